//! The page as the viewer reads it: the data in its script, and the escape of text from outside.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use polhode::body::shape::{Cone, Tetrahedron};
use polhode::motion::{
    ClosedForm, EventAction, MU_EARTH, Measure, Mechanism, Orbit, Pointing, Reference, Sense, Solution,
};
use polhode::prelude::*;
use polhode_document::Document;
use polhode_scenario::report::{PageInput, PageSubject, explain_motion, page, page_rows};
use polhode_scenario::symbolic::Exact;
use serde_json::Value;

const OPEN: &str = "<script id=\"polhode-data\" type=\"application/json\">";

pub(crate) fn html_of(scenario: &Scenario, trajectory: &Trajectory, text: &str) -> String {
    // A motion on the ground or in gimbals has no worked solution.
    let is_held = scenario.mechanism() != Mechanism::Rotor;
    let explanation = (!is_held).then(|| explain_motion(scenario, trajectory, &Exact::None).unwrap());
    page(&input(scenario, trajectory, text, explanation.as_ref()))
}

fn input<'a>(
    scenario: &'a Scenario,
    trajectory: &'a Trajectory,
    text: &'a str,
    explanation: Option<&'a Document>,
) -> PageInput<'a> {
    PageInput {
        title: scenario.title().unwrap(),
        source: "polhode simulate",
        scenario_text: Some(text),
        subject: PageSubject::Scenario(scenario),
        trajectory,
        explanation,
        whole: true,
    }
}

/// Returns the data block of the page as a browser reads it, up to the first end of a script.
pub(crate) fn data(html: &str) -> Value {
    let (before, rest) = html.split_once(OPEN).unwrap();
    assert!(!rest.contains(OPEN) && !before.contains(OPEN));
    serde_json::from_str(rest.split_once("</script").unwrap().0).unwrap()
}

pub(crate) fn page_of(scenario: &Scenario) -> (Value, Trajectory) {
    let trajectory = scenario.simulate().unwrap().unwrap();
    (data(&html_of(scenario, &trajectory, "title = \"x\"")), trajectory)
}

pub(crate) fn bytes(text: &Value) -> Vec<u8> {
    BASE64_STANDARD.decode(text.as_str().unwrap()).unwrap()
}

fn doubles(text: &Value) -> Vec<f64> {
    bytes(text).chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect()
}

pub(crate) fn floats(text: &Value) -> Vec<f32> {
    bytes(text).chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect()
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

/// Checks that the page with its rows outside the JSON has the same bytes as the base64 inside, one
/// row after the other.
fn rows_beside_are_those_inside(scenario: &Scenario, trajectory: &Trajectory, inside: &Value) {
    fn compare(inside: &Value, beside: &Value, rows: &[u8], seen: &mut Vec<(usize, usize)>) {
        if let Some(place) = beside.get("f64") {
            let [at, count] = [0, 1].map(|k| 8 * usize::try_from(place[k].as_u64().unwrap()).unwrap());
            assert_eq!(bytes(inside), rows[at..at + count]);
            seen.push((at, at + count));
            return;
        }
        match (inside, beside) {
            (Value::Array(a), Value::Array(b)) => {
                assert_eq!(a.len(), b.len());
                a.iter().zip(b).for_each(|(a, b)| compare(a, b, rows, seen));
            }
            (Value::Object(a), Value::Object(b)) => {
                assert!(a.keys().eq(b.keys()));
                a.values().zip(b.values()).for_each(|(a, b)| compare(a, b, rows, seen));
            }
            (a, b) => assert_eq!(a, b),
        }
    }
    let explanation = explain_motion(scenario, trajectory, &Exact::None).unwrap();
    let (beside, rows) = page_rows(&input(scenario, trajectory, "title = \"x\"", Some(&explanation)));
    let mut seen = Vec::new();
    compare(inside, &beside, &rows, &mut seen);
    seen.sort_unstable();
    assert!(seen.len() >= 7 && seen.windows(2).all(|pair| pair[0].1 == pair[1].0));
    assert_eq!((seen[0].0, seen[seen.len() - 1].1), (0, rows.len()));
}

#[test]
fn the_rows_are_the_trajectory_bit_for_bit() {
    for scenario in [crate::common::t_handle(), crate::common::thruster(), crate::common::pendulum()] {
        let (data, trajectory) = page_of(&scenario);
        let motion = &data["motion"];
        let samples = trajectory.samples();
        assert_eq!(number(&motion["count"]), samples.len() as f64);
        let rows: [(&str, Vec<f64>); 6] = [
            ("times", samples.iter().map(|s| s.state.time).collect()),
            ("attitude", samples.iter().flat_map(|s| s.state.attitude.quaternion()).collect()),
            ("omega", samples.iter().flat_map(|s| s.state.omega.to_array()).collect()),
            ("momentum", samples.iter().flat_map(|s| s.momentum.to_array()).collect()),
            ("torque", samples.iter().flat_map(|s| s.torque.to_array()).collect()),
            ("kinetic", samples.iter().map(|s| s.kinetic_energy).collect()),
        ];
        for (key, wanted) in rows {
            if key == "torque" && scenario.torques().is_empty() {
                assert_eq!(motion[key], Value::Null);
                continue;
            }
            let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>();
            assert_eq!(bits(doubles(&motion[key])), bits(wanted), "{key}");
        }
        rows_beside_are_those_inside(&scenario, &trajectory, &data);
        // The largest value of each line is the drift in the reports.
        let drift = Drift::of(&trajectory).unwrap();
        let lines = motion["drift"].as_array().unwrap();
        let worst = |name: &str| {
            let line = lines.iter().find(|line| line["name"] == name).unwrap();
            doubles(&line["values"]).into_iter().fold(0.0, f64::max)
        };
        // In a closed form under torque the impulse is the gain of L, so its balance tests nothing.
        match (scenario.torques().is_empty(), trajectory.solution()) {
            (true, _) => assert_eq!(worst("L in space"), drift.momentum),
            (false, Solution::ClosedForm(_)) => assert_eq!(worst("T + U"), drift.total_energy.unwrap()),
            (false, _) => assert_eq!(worst("L − impulse"), drift.momentum),
        }
        assert!(motion["wheels"].as_array().unwrap().is_empty() && motion["complete"] == true);
    }
}

#[test]
fn wheels_events_and_switches_are_on_the_page() {
    let (data, trajectory) = page_of(&crate::common::gyrostat());
    let wheels = data["motion"]["wheels"].as_array().unwrap();
    let [held, turned] = &wheels[..] else { panic!("{wheels:?}") };
    assert_eq!((&held["name"], &held["speed"]), (&"wheel 1".into(), &Value::Null));
    let [inertia, torque, from] = crate::common::MOTOR;
    let h = doubles(&turned["momentum"]);
    assert!((h[60] - h[0] - torque * (6.0 - from)).abs() < 1e-12);
    assert_eq!(doubles(&turned["speed"])[0], 12.0);
    let scale = |k: usize| (0.36_f64 + 0.09 + 0.64).sqrt().recip() * [0.6, -0.3, 0.8][k];
    (0..3).for_each(|k| assert!((number(&turned["axis"][k]) - scale(k)).abs() < 1e-15));
    assert_eq!(held["motor"], Value::Null);
    let motor = doubles(&turned["motor"]);
    assert_eq!((motor[0], motor[14], motor[16], motor[60]), (0.0, 0.0, torque, torque));
    // Without external torque L itself is constant.
    let lines = data["motion"]["drift"].as_array().unwrap();
    let names: Vec<&str> = lines.iter().filter_map(|line| line["name"].as_str()).collect();
    assert_eq!(names, ["T − work", "L in space"]);
    let (first, last) = (trajectory.start().state, trajectory.samples().last().unwrap().state);
    assert!(first.time == 0.0 && last.time == 6.0 && inertia > 0.0);
    let rows = |data: &Value, group: &str| -> Vec<[String; 3]> {
        let groups = data["facts"].as_array().unwrap();
        let group = groups.iter().find(|g| g["title"] == group).unwrap();
        let row = |row: &Value| ["label", "value", "note"].map(|key| row[key].as_str().unwrap().to_owned());
        group["rows"].as_array().unwrap().iter().map(row).collect()
    };
    let driven = rows(&data, "Torques and wheels");
    let speed = driven.iter().find(|[label, ..]| label.starts_with("Ω of ")).unwrap();
    assert!(speed[1].starts_with("12 → ") && speed[2] == "in the body", "{speed:?}");

    let mut scenario = crate::common::thruster();
    let brake = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, -0.9)));
    let brake = polhode::motion::ActingTorque { model: brake, name: Some("brake".to_owned()), is_on: false };
    scenario = scenario.clone().with_torques([scenario.torques()[0].clone().into(), brake]).unwrap();
    let along = Measure::OmegaBody(Direction::new(0.0, 0.0, 1.0));
    let action = EventAction::Switch { torque: 1, on: true };
    scenario =
        scenario.watching(vec![Event::new("too fast", along, 0.45, Sense::Rising, action).unwrap()]).unwrap();
    let (data, trajectory) = page_of(&scenario);
    let events = data["motion"]["events"].as_array().unwrap();
    assert_eq!(events.len(), trajectory.events().len());
    assert_eq!(data["motion"]["eventCount"], events.len());
    assert!(
        events[0]["name"] == "too fast" && number(&events[0]["time"]) == trajectory.events()[0].state.time
    );
    let driven = rows(&data, "Torques and wheels");
    let brake =
        driven.iter().find(|[_, value, _]| value.starts_with("brake: constant in body axes")).unwrap();
    assert_eq!(brake[2], "model constant, off until the event \"too fast\"");
}

/// A satellite has its nadir and velocity at each sample, and the targets of its pointings.
#[test]
fn directions_of_an_orbit_are_on_the_page() {
    let radial = Direction::new(0.48, -0.6, 0.64);
    let orbit = Orbit::circular(MU_EARTH, 7.1e6, radial, Direction::new(0.8, 0.0, -0.6)).unwrap();
    let camera =
        Pointing::new("camera", Direction::new(0.6, 0.0, 0.8), Reference::Nadir(orbit.clone())).unwrap();
    let camera = camera.with_limit(0.25).unwrap();
    let (data, trajectory) =
        page_of(&crate::common::thruster().in_orbit(orbit.clone()).unwrap().pointing(vec![camera]));
    let motion = &data["motion"];
    let [nadir, velocity] = &motion["directions"].as_array().unwrap()[..] else { panic!("{motion}") };
    assert_eq!((&nadir["name"], &velocity["name"]), (&"nadir".into(), &"velocity".into()));
    assert_eq!(
        (&motion["pointings"][0]["target"], &motion["pointings"][0]["limit"]),
        (&0.into(), &0.25.into())
    );
    let rows = [&nadir["values"], &velocity["values"]].map(floats);
    for (k, sample) in trajectory.samples().iter().enumerate() {
        let time = sample.state.time;
        let position = orbit.position(time).to_array().map(|x| -x / 7.1e6);
        let speed = orbit.velocity(time).norm();
        let along = orbit.velocity(time).to_array().map(|v| v / speed);
        for c in 0..3 {
            assert!((f64::from(rows[0][3 * k + c]) - position[c]).abs() < 1e-7);
            assert!((f64::from(rows[1][3 * k + c]) - along[c]).abs() < 1e-7);
        }
    }
}

/// The fixed target of a pointing named sun is the Sun, whichever of the pointings comes first.
#[test]
fn the_sun_is_on_the_page_where_a_pointing_is_named_after_it() {
    let to = |name: &str, target: [f64; 3]| {
        Pointing::new(name, Direction::new(0.6, 0.0, 0.8), Reference::Space(Direction::from_array(target)))
            .unwrap()
    };
    let names = |pointings: Vec<Pointing>| {
        let (data, _) = page_of(&crate::common::thruster().pointing(pointings));
        let directions = data["motion"]["directions"].as_array().unwrap().clone();
        let targets = data["motion"]["pointings"].as_array().unwrap().clone();
        let name = |line: &Value| directions[line["target"].as_u64().unwrap() as usize]["name"].clone();
        targets.iter().map(name).collect::<Vec<_>>()
    };
    let sun = [0.8, 0.55, 0.24];
    let two = || vec![to("panel", sun), to("Sun", sun)];
    assert_eq!(names(two()), ["sun", "sun"]);
    assert_eq!(names(two().into_iter().rev().collect()), ["sun", "sun"]);
    let others = vec![to("sunshade", sun), to("panel", [-0.8, 0.55, 0.24])];
    assert_eq!(names(others), ["target of sunshade", "target of panel"]);
}

/// Pointings, work and a top's axis are on the page, but only for motions that have them.
#[test]
fn pointings_work_and_the_axis_of_a_top_are_on_the_page() {
    let axis = Direction::new(0.6, 0.0, 0.8);
    let to = Reference::Space(Direction::new(0.0, 1.0, 0.0));
    let pointing = Pointing::new("<b>camera</b>", axis, to).unwrap();
    let (data, trajectory) = page_of(&crate::common::thruster().pointing(vec![pointing]));
    let [line] = &data["motion"]["pointings"].as_array().unwrap()[..] else { panic!("{data}") };
    let work = &data["motion"]["work"];
    assert_eq!((&line["name"], &work["name"]), (&"<b>camera</b>".into(), &"work".into()));
    for (k, (sample, angle)) in trajectory.samples().iter().zip(doubles(&line["values"])).enumerate() {
        // cos = R e · Y
        let seen = sample.state.attitude * axis;
        assert!((seen.y - angle.cos()).abs() < 1e-14);
        assert_eq!(doubles(&work["values"])[k].to_bits(), sample.work.to_bits());
    }
    assert_eq!(data["top"], Value::Null);
    assert_eq!((&line["target"], &line["limit"]), (&0.into(), &Value::Null));
    let direction = &data["motion"]["directions"][0];
    assert_eq!(direction["name"], "target of <b>camera</b>");
    assert_eq!(direction["fixed"], serde_json::json!([0.0, 1.0, 0.0]));

    // Gravity and the arm are along x. Up is −x, and φ starts at y, the horizontal axis.
    let (data, trajectory) = page_of(&crate::common::pendulum());
    assert_eq!(data["motion"]["work"], Value::Null, "there is a potential instead");
    assert!(data["motion"]["potential"].is_string() && data["top"]["bounds"].is_null());
    let vector = |value: &Value| value.as_array().unwrap().iter().map(number).collect::<Vec<_>>();
    let top = &data["top"];
    assert_eq!((vector(&top["axis"]), vector(&top["up"])), (vec![1.0, 0.0, 0.0], vec![-1.0, 0.0, 0.0]));
    assert_eq!(vector(&top["across"][0]), [0.0, 1.0, 0.0]);
    assert_eq!(vector(&top["across"][1]), [0.0, 0.0, -1.0], "up × the first");
    assert!(trajectory.samples().iter().all(|s| s.potential_energy.is_some()));
    let (data, _) = page_of(&crate::common::t_handle());
    assert!(data["top"].is_null() && data["motion"]["work"].is_null());
    assert_eq!(data["motion"]["pointings"], serde_json::json!([]));
}

#[test]
fn hostile_text_is_inert() {
    let evil =
        "</script><script>alert(1)</script><!--polhode-data--><!-- \" ' & \u{2028} <title>x</title>\\\u{0}";
    let scenario = crate::common::hostile(evil);
    let trajectory = scenario.simulate().unwrap().unwrap();
    let html = html_of(&scenario, &trajectory, evil);
    let tame = html_of(&crate::common::t_handle(), &trajectory, "");
    for mark in ["<script", "</script", "<!--", "-->", "<title>", "</title>"] {
        assert_eq!(html.matches(mark).count(), tame.matches(mark).count(), "{mark}");
    }
    let data = data(&html);
    for text in [&data["title"], &data["scenario"], &data["body"]["shapes"][0]["name"]] {
        assert_eq!(*text, evil);
    }
    assert!(data["findings"][0]["message"].as_str().unwrap().contains(evil));
    assert!(html.contains("<title>&lt;/script&gt;&lt;script&gt;alert(1)"));
    for block in data["explanation"].as_array().unwrap().iter().filter(|b| b["kind"] == "formula") {
        let markup = block["mathml"].as_str().unwrap();
        assert!(markup.starts_with("<math ") && !markup.contains("<script"), "{markup}");
    }
}

#[test]
fn every_formula_is_set() {
    for scenario in crate::common::all() {
        let Some(Ok(trajectory)) = scenario.simulate() else { continue };
        let data = data(&html_of(&scenario, &trajectory, ""));
        for block in data["explanation"].as_array().unwrap().iter().filter(|b| b["kind"] == "formula") {
            let (markup, text) = (block["mathml"].as_str().unwrap(), block["text"].as_str().unwrap());
            let parsed = roxmltree::Document::parse(markup).unwrap_or_else(|e| panic!("{markup}: {e}"));
            // A formula that cannot be parsed would be plain text.
            assert!(markup.contains("<mo"), "{text}: {markup}");
            for node in parsed.descendants() {
                let wanted = match node.tag_name().name() {
                    "msub" | "msup" | "munder" | "mover" | "mfrac" => 2,
                    "msubsup" | "munderover" => 3,
                    _ => continue,
                };
                assert_eq!(node.children().count(), wanted, "{text}: {markup}");
            }
            for c in parsed.descendants().filter_map(|node| node.text()) {
                let missing: Vec<char> =
                    c.chars().chain(c.chars().filter_map(italic)).filter(|c| !is_in_font(*c)).collect();
                assert!(missing.is_empty(), "the font of formulas has no {missing:?}: {text}");
            }
        }
    }
}

/// Returns true if the bundled font has the character, by its style sheet.
fn is_in_font(c: char) -> bool {
    let css = include_str!("../../../polhode-document/assets/math.css");
    let ranges = css.split_once("unicode-range:").unwrap().1.split_once(';').unwrap().0;
    let number = |hex: &str| u32::from_str_radix(hex, 16).unwrap();
    ranges.split(',').map(|range| range.trim().strip_prefix("U+").unwrap()).any(|range| {
        let (first, last) = range.split_once('-').unwrap_or((range, range));
        (number(first)..=number(last)).contains(&u32::from(c))
    })
}

/// Returns the italic character that a browser shows for a single letter.
fn italic(c: char) -> Option<char> {
    let (first, place) = match c {
        'h' => return Some('ℎ'),
        'A'..='Z' => ('A', 0x1D434),
        'a'..='z' => ('a', 0x1D44E),
        'Α'..='Ω' => ('Α', 0x1D6E2),
        'α'..='ω' => ('α', 0x1D6FC),
        _ => return None,
    };
    char::from_u32(place + u32::from(c) - u32::from(first))
}

#[test]
fn every_scenario_has_a_page_without_a_hole() {
    for scenario in crate::common::all().into_iter().chain([crate::common::gyrostat()]) {
        let Some(Ok(trajectory)) = scenario.simulate() else { continue };
        let data = data(&html_of(&scenario, &trajectory, ""));
        let title = scenario.title().unwrap();
        let numbers = |value: &Value| doubles(value).into_iter().all(f64::is_finite);
        for key in ["times", "attitude", "omega", "momentum", "kinetic"] {
            assert!(numbers(&data["motion"][key]), "{title}: {key}");
        }
        for line in data["motion"]["drift"].as_array().unwrap() {
            assert!(numbers(&line["values"]), "{title}");
        }
        if let Some(free) = data["free"].as_object() {
            for key in ["polhode", "herpolhode", "trace"] {
                assert!(numbers(&free[key]) && !doubles(&free[key]).is_empty(), "{title}: {key}");
            }
        }
        for x in data["body"]["ellipsoid"]["half"].as_array().unwrap() {
            assert!(number(x) >= 0.0, "{title}");
        }
    }
}

#[test]
fn the_geometry_is_that_of_the_motion() {
    let (data, trajectory) = page_of(&crate::common::t_handle());
    let Solution::ClosedForm(ClosedForm::Free(motion)) = trajectory.solution() else { panic!("not exact") };
    let free = &data["free"];
    let l = motion.momentum().norm();
    assert_eq!(number(&free["momentum"]), l);
    assert_eq!(number(&free["period"]), motion.period().unwrap());
    let triples = |value: &Value| -> Vec<[f64; 3]> {
        doubles(value).chunks_exact(3).map(|p| p.try_into().unwrap()).collect()
    };
    let norm = |p: &[f64; 3]| p.iter().map(|x| x * x).sum::<f64>().sqrt();
    let moments = motion.principal().moments();
    // On the sphere, 2T/L² = Σ n_k² / i_k is constant for this motion; on a separatrix it equals
    // that of axis 2.
    let inverse = |p: &[f64; 3]| p.iter().zip(moments).map(|(n, i)| n * n / i).sum::<f64>();
    let energy = 2.0 * motion.kinetic_energy() / (l * l);
    for point in triples(&free["trace"]) {
        assert!((norm(&point) - 1.0).abs() < 1e-14 && (inverse(&point) / energy - 1.0).abs() < 1e-12);
    }
    let separatrices = free["separatrix"].as_array().unwrap();
    assert_eq!(separatrices.len(), 2);
    for line in separatrices {
        let points = triples(line);
        assert_eq!(points.first(), points.last());
        assert!(points.iter().all(|p| (inverse(p) * moments[1] - 1.0).abs() < 1e-12));
        let jump = |pair: &[[f64; 3]]| norm(&std::array::from_fn(|k| pair[1][k] - pair[0][k]));
        assert!(points.windows(2).map(jump).fold(0.0, f64::max) < 0.15);
    }
    assert_eq!(free["family"].as_array().unwrap().len(), 20);
    // The herpolhode is ω in space: in the plane normal to L at the height 2T/|L|.
    let normal = motion.momentum().to_array().map(|x| x / l);
    let height = 2.0 * motion.kinetic_energy() / l;
    for point in triples(&free["herpolhode"]) {
        let along: f64 = point.iter().zip(normal).map(|(a, b)| a * b).sum();
        assert!((along / height - 1.0).abs() < 1e-12);
    }
    let polhode = triples(&free["polhode"]);
    assert_eq!(polhode.first(), polhode.last());
}

#[test]
fn parts_are_where_they_are() {
    let scenario = crate::common::t_handle();
    let (data, _) = page_of(&scenario);
    let shapes = data["body"]["shapes"].as_array().unwrap();
    assert_eq!(shapes.len(), 2);
    assert_eq!((&shapes[0]["kind"], &shapes[0]["height"]), (&"cylinder".into(), &0.04.into()));
    let center = scenario.body().center_of_mass().to_array();
    let part = scenario.parts()[1].properties.center_of_mass().to_array();
    for k in 0..3 {
        assert!((number(&shapes[1]["position"][k]) - (part[k] - center[k])).abs() < 1e-17);
    }
    // Rotated by 0.2 rad about z.
    let q = &shapes[1]["quaternion"];
    assert!((number(&q[0]) - 0.1_f64.cos()).abs() < 1e-15 && (number(&q[3]) - 0.1_f64.sin()).abs() < 1e-15);

    // The origin of a cone is the centre of its base, and that of a tetrahedron is its own origin.
    // Both are rotated and moved.
    let cone = Cone::new(0.3, 0.1, 0.8).unwrap();
    let corners = [[0.1, 0.2, 0.3], [1.1, 0.0, 0.4], [0.3, 0.9, 0.2], [0.2, 0.1, 1.3]];
    let four = Tetrahedron::new(corners).unwrap();
    let parts = vec![
        crate::common::solid("cone", "cone", &cone, 1.3, [0.5, -0.2, 0.7], 0.4),
        crate::common::solid("four", "tetrahedron", &four, 0.9, [-1.0, 0.3, 0.1], 0.4),
        crate::common::particles(&[(1.0, [0.0; 3]), (8.0, [0.0, 0.0, 2.0]), (1.0, [0.0, 1.0, 2.0])]),
    ];
    let mut scenario = crate::common::scenario("Parts", parts);
    scenario = scenario.held_at(Position::new(0.25, 0.5, -1.0)).unwrap();
    scenario = crate::common::spinning(scenario, AngularVelocity::new(0.1, 0.2, 0.3));
    scenario = scenario.sampled(crate::common::run(1.0, 3));
    let (data, _) = page_of(&scenario);
    assert_eq!(data["body"]["about"], "pivot");
    let shapes = data["body"]["shapes"].as_array().unwrap();
    let position = |shape: &Value| -> [f64; 3] { std::array::from_fn(|k| number(&shape["position"][k])) };
    assert_eq!(position(&shapes[0]), [0.25, -0.7, 2.1]);
    // Triangles face outward: relative to the centre of the solid each has a positive volume.
    let points = floats(&shapes[1]["vertices"]);
    let indices: Vec<u32> = bytes(&shapes[1]["triangles"])
        .chunks_exact(4)
        .map(|b| u32::from_le_bytes(b.try_into().unwrap()))
        .collect();
    let corner = |k: u32| -> [f32; 3] { points[3 * k as usize..][..3].try_into().unwrap() };
    let middle: [f32; 3] = std::array::from_fn(|k| (0..4).map(|v| corner(v)[k]).sum::<f32>() / 4.0);
    for triangle in indices.chunks_exact(3) {
        let [a, b, c] = [0, 1, 2].map(|k| {
            let p = corner(triangle[k]);
            [p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]]
        });
        let volume = a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        assert!(volume > 0.0, "{volume}");
    }
    // The first vertex, transformed by the place and rotation of the shape, is the corner of the
    // tetrahedron relative to the pivot.
    let (sin, cos) = 0.4_f64.sin_cos();
    let local = corner(0).map(f64::from);
    let [px, py, pz] = position(&shapes[1]);
    let found = [px + cos * local[0] - sin * local[1], py + sin * local[0] + cos * local[1], pz + local[2]];
    let [x, y, z] = corners[0];
    let wanted = [-1.0 + cos * x - sin * y - 0.25, 0.3 + sin * x + cos * y - 0.5, 0.1 + z + 1.0];
    for (found, wanted) in found.into_iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-6, "{found} {wanted}");
    }
    // Balls: volumes proportional to masses, sticks of minimal total length.
    let balls = &shapes[2];
    assert_eq!(floats(&balls["centers"])[..3], [-0.25, -0.5, 1.0]);
    let radii = floats(&balls["radii"]);
    assert!((radii[1] / radii[0] - 2.0).abs() < 1e-6);
    assert_eq!(balls["sticks"].to_string(), "[[0,1],[1,2]]");
}

/// Returns a wavy ball of n × 2n quadrilaterals, which may have more than 100,000 triangles.
pub(crate) fn potato(n: u32) -> TriangleMesh {
    let (pi, m) = (std::f64::consts::PI, 2 * n);
    let point = |i: u32, j: u32| {
        let (theta, phi) = (pi * f64::from(i) / f64::from(n), 2.0 * pi * f64::from(j) / f64::from(m));
        let r = 1.0 + 0.1 * (3.0 * phi).sin() * theta.sin().powi(3);
        [r * theta.sin() * phi.cos() + 5.0, 0.7 * r * theta.sin() * phi.sin(), 1.4 * r * theta.cos()]
    };
    // One vertex at each pole, so that the surface is closed.
    let mut vertices = vec![point(0, 0)];
    vertices.extend((1..n).flat_map(|i| (0..m).map(move |j| point(i, j))));
    vertices.push(point(n, 0));
    let at = |i: u32, j: u32| match i {
        0 => 0,
        i if i == n => (n - 1) * m + 1,
        i => 1 + (i - 1) * m + j % m,
    };
    let quads = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
    let triangles = quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    TriangleMesh::new(vertices, triangles).unwrap()
}

#[test]
fn a_page_of_many_triangles_and_samples_has_two_megabytes() {
    let mesh = ClosedMesh::of(&potato(230)).unwrap();
    let triangles = mesh.surface().triangles().len();
    assert!(triangles > 200_000);
    let mut scenario = crate::common::scenario(
        "A potato",
        vec![crate::common::solid("potato", "mesh", &mesh, 3.0, [0.4, 0.0, -7.0], 0.3)],
    );
    scenario = crate::common::spinning(scenario, AngularVelocity::new(0.3, 0.1, 2.0));
    for samples in [2_001, 30_000] {
        scenario = scenario.sampled(crate::common::run(60.0, samples));
        let trajectory = scenario.simulate().unwrap().unwrap();
        let html = html_of(&scenario, &trajectory, "");
        assert!(html.len() <= 2_000_000, "{} bytes", html.len());
        let data = data(&html);
        assert_eq!(number(&data["motion"]["count"]), 2001.0);
        let times = doubles(&data["motion"]["times"]);
        assert_eq!((times[0], times[2000]), (0.0, 60.0));
        let shape = &data["body"]["shapes"][0];
        assert_eq!(number(&shape["of"]), triangles as f64);
        let shown = bytes(&shape["triangles"]).len() / 12;
        assert!(shown > 15_000 && shown < triangles, "{shown}");
        let page = data["facts"].as_array().unwrap().last().unwrap().to_string();
        assert!(page.contains("potato") && page.contains("simplified"), "{page}");
        assert_eq!(page.contains("of 30,000, evenly chosen"), samples == 30_000, "{page}");
    }
}

#[test]
fn moments_alone_have_a_page() {
    let start =
        State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.02) };
    let motion = FreeMotion::of_moments([3.0, 1.0, 2.5], start).unwrap();
    let trajectory = Trajectory::of_motion(motion, &[0.0, 1.0, 2.0]).unwrap();
    let html = page(&PageInput {
        title: "Moments",
        source: "polhode spin",
        scenario_text: None,
        subject: PageSubject::Moments(motion.principal()),
        trajectory: &trajectory,
        explanation: None,
        whole: true,
    });
    let data = data(&html);
    assert_eq!(data["body"]["mass"], Value::Null);
    assert_eq!(data["body"]["inertia"].to_string(), "[[3.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,2.5]]");
    assert_eq!(data["scenario"], Value::Null);
    assert_eq!(data["explanation"].to_string(), "[]");
    assert!(data["free"].is_object());
}
