//! Comparisons of two models: equal robots, and each planted slip in exactly one place.

mod cases;
mod dynamics;
mod robots;
mod slips;
mod written;
mod zeros;

use polhode_document::Report as _;
use polhode_robot::compare::{Comparison, REPORT_SCHEMA, Request, run};
use polhode_source::files::Memory;

use crate::common::schema::require_fits;
use robots::{Frame, LANGUAGES, Robot, robot};

fn request(a: &str, b: &str, tolerance: &str) -> Request {
    let tolerance = Some(tolerance.parse().unwrap());
    Request { a: a.into(), b: b.into(), tolerance, ..Request::default() }
}

/// Compares two texts.
fn compared([of_a, a]: [&str; 2], [of_b, b]: [&str; 2], tolerance: &str) -> Comparison {
    let (a_name, b_name) = (format!("a.{of_a}"), format!("b.{of_b}"));
    let files = Memory::from([(a_name.as_str(), a), (b_name.as_str(), b)]);
    let comparison =
        run(&request(&a_name, &b_name, tolerance), &files).unwrap_or_else(|f| panic!("{f}\n{a}\n{b}"));
    require_fits(REPORT_SCHEMA, &comparison.to_json());
    comparison
}

/// Compares two robots in two languages, far more strictly than the default.
fn between(a: (&Robot, &str), b: (&Robot, &str)) -> Comparison {
    compared([a.1, &a.0.written(a.1)], [b.1, &b.0.written(b.1)], "1e-12")
}

/// Returns code and subject of each difference.
fn codes(comparison: &Comparison) -> Vec<(&str, &str)> {
    let last = |name: &'_ str| name.rsplit('/').next().map_or(0, str::len);
    comparison
        .differences()
        .map(|found| (found.code, &found.subject[found.subject.len() - last(&found.subject)..]))
        .collect()
}

fn messages(comparison: &Comparison) -> Vec<&str> {
    comparison.differences().map(|found| found.message.as_str()).collect()
}

fn notes(comparison: &Comparison) -> Vec<(&str, &str)> {
    comparison.notes().map(|found| (found.code, found.message.as_str())).collect()
}

#[test]
fn one_robot_in_four_languages_is_equal() {
    for of_a in LANGUAGES {
        for of_b in LANGUAGES {
            let comparison = between((&robot(), of_a), (&robot(), of_b));
            assert_eq!(codes(&comparison), [], "{of_a} {of_b}\n{}", comparison.to_text(None));
            assert!(notes(&comparison).is_empty(), "{of_a} {of_b}: {:?}", notes(&comparison));
            let line = format!("a.{of_a} and b.{of_b} agree within 1e-12: 6 links, 4 joints, 6.88 kg\n");
            assert_eq!(comparison.to_text(None), line);
        }
    }
}

#[test]
fn merged_links_other_frames_and_other_zeros_are_no_difference() {
    let plain = robot();
    for of_a in LANGUAGES {
        for of_b in LANGUAGES {
            let merged = between((&plain, of_a), (&plain.merged(), of_b));
            assert_eq!(codes(&merged), [], "{of_a} {of_b}\n{}", merged.to_text(None));
            let [(code, message)] = notes(&merged)[..] else { panic!("{:?}", notes(&merged)) };
            assert_eq!(code, "compare.frame");
            assert!(message.starts_with("the sums of the rigid group agree: "), "{message}");

            let frames = between((&plain, of_a), (&plain.reframed(of_b), of_b));
            assert_eq!(codes(&frames), [], "{of_a} {of_b}\n{}", frames.to_text(None));
            assert!(notes(&frames).is_empty(), "{:?}", notes(&frames));

            // The elbow has a link with mass below it that is fixed, the shoulder an axis.
            let zeros = plain.rezeroed("upper", 0.7).rezeroed("fore", -1.3).rezeroed("rail", 0.04);
            for moved in [zeros.clone(), zeros.reframed(of_b), zeros.merged()] {
                let comparison = between((&plain, of_a), (&moved, of_b));
                assert_eq!(codes(&comparison), [], "{of_a} {of_b}\n{}", comparison.to_text(None));
                let offsets = |joint: &str| {
                    let of_joint = comparison
                        .notes()
                        .find(|found| found.code == "compare.zero" && found.subject.ends_with(joint));
                    of_joint.map(|found| found.numbers[0].1)
                };
                // 0 of the first model is −q of the second, whose zero was moved by q.
                for (joint, q) in [("shoulder", 0.7), ("elbow", -1.3), ("slide", 0.04)] {
                    assert!((offsets(joint).unwrap() + q).abs() < 1e-12, "{joint} {:?}", offsets(joint));
                }
                assert_eq!(offsets("knuckle"), None);
            }
        }
    }
}

/// Requires one difference of a code at a subject, in all languages, with and without other frames.
fn require_one(slip: impl Fn(&mut Robot), expected: &[(&str, &str)], words: &str) {
    for of_a in LANGUAGES {
        for of_b in LANGUAGES {
            let mut slipped = robot();
            slip(&mut slipped);
            for other in [slipped.clone(), slipped.reframed(of_b)] {
                let comparison = between((&robot(), of_a), (&other, of_b));
                let text = comparison.to_text(None);
                assert_eq!(codes(&comparison), expected, "{of_a} {of_b}\n{text}");
                assert!(comparison.has_failed());
                assert!(comparison.notes().all(|note| note.code != "compare.zero"), "{text}");
                let messages: Vec<&str> =
                    comparison.differences().map(|found| found.message.as_str()).collect();
                assert!(messages.iter().any(|message| message.contains(words)), "{of_a} {of_b}\n{text}");
            }
        }
    }
}

#[test]
fn each_planted_slip_is_found_in_exactly_one_place() {
    require_one(|r| r.solid("fore").mass *= 1.01, &[("compare.mass", "fore")], "0.909 kg, in a");
    require_one(|r| r.solid("rail").center[1] += 1e-3, &[("compare.center", "rail")], "1 mm apart");
    require_one(
        |r| {
            let t = &mut r.solid("finger").tensor;
            (t[0][1], t[1][0]) = (-t[0][1], -t[1][0]);
        },
        &[("compare.tensor", "finger")],
        " kg·m², in a.",
    );
    require_one(|r| r.solid("hand").tensor[2][2] *= 1.02, &[("compare.tensor", "hand")], " kg·m², in a.");
    // The axis moves with the links below it; across it, by 1 mm.
    require_one(
        |r| {
            let part = r.part("fore");
            let across = [0.64, -0.6, 0.0].map(|c: f64| 1e-3 * c / 0.64_f64.hypot(0.6));
            let shift = Frame { p: across, ..Frame::IDENTITY };
            part.pose = part.pose.then(&shift);
        },
        &[("compare.joint", "elbow")],
        "1 mm apart",
    );
    require_one(
        |r| r.part("upper").joint.as_mut().unwrap().axis = [-0.36, 0.48, -0.8],
        &[("compare.joint", "shoulder")],
        "reversed",
    );
}
