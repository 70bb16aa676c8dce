//! `--moments`: a free body that starts at the first row of the log, without a scenario file.

use serde_json::{Value, json};

use crate::log::{
    HEAD, MOMENTS, OMEGA, Row, answer, euler, exact, in_space, judged, number, plain, refused, text,
};

const BODY: &str = "1.3, 2.9, 2.1";

/// Returns the scenario file of the body with the start of a row; its mass has no effect.
fn scenario(rows: &[Row]) -> String {
    let (_, q, w) = rows[0];
    format!(
        "[[body.part]]\nshape = \"tensor\"\nmass = 4.2\nmoments = {MOMENTS:?}\n\
         [start]\nattitude = {{ quaternion = {q:?} }}\nspin = {{ body = {w:?} }}\n"
    )
}

fn untitled(mut report: Value) -> Value {
    report.as_object_mut().unwrap().remove("title").unwrap();
    report
}

fn only_run(report: &Value) -> &Value {
    let [run] = &report["runs"].as_array().unwrap()[..] else { panic!("one run") };
    run
}

#[test]
fn the_exact_motion_is_right() {
    let log = text(HEAD, &exact(401), plain);
    let report = judged(&json!({ "files": ["run.csv"], "moments": BODY }), &[("run.csv", log)]).unwrap();
    assert_eq!(report["title"], "Free body, moments 1.3, 2.9, 2.1 kg·m²");
    let error = &only_run(&report)["error"];
    assert!(number(&error["attitude_largest_rad"]) < 2e-15, "{error}");
    assert!(number(&error["rates"]["omega_relative"]) < 2e-15, "{error}");
    assert!(number(&error["rates"]["momentum_direction_rad"]) < 2e-15, "{error}");
}

/// The report is that on a scenario file with the same body and start: for a right and a wrong
/// program, and for a log that begins at another time than 0.
#[test]
fn a_scenario_file_with_the_body_gives_the_same_report() {
    for (rows, cause) in [
        (exact(401), None),
        (euler(401), Some("first-order integration (semi-implicit Euler), h = 0.020000 s")),
    ] {
        for origin in [0.0, 3.5] {
            let later: Vec<Row> = rows.iter().map(|&(t, q, w)| (t + origin, q, w)).collect();
            let files = [("run.csv", text(HEAD, &later, plain)), ("body.toml", scenario(&rows))];
            let mut by_file = json!({ "files": ["body.toml", "run.csv"] });
            if origin != 0.0 {
                by_file["time-origin"] = origin.into();
            }
            let by_file = judged(&by_file, &files).unwrap();
            let by_moments = judged(&json!({ "files": ["run.csv"], "moments": BODY }), &files).unwrap();
            assert_eq!(untitled(by_moments.clone()), untitled(by_file));
            let run = only_run(&by_moments);
            let named =
                run["causes"]["tried"].as_array().unwrap().iter().find(|tried| tried["named"] == true);
            match cause {
                None => assert!(named.is_none(), "{named:?}"),
                Some(cause) => {
                    assert_eq!(named.unwrap()["cause"], cause);
                    assert!(number(&run["error"]["attitude_largest_rad"]) > 0.01);
                }
            }
        }
    }
}

/// Order, sense and frame of ω are not stated: the first row has the interpretation with which the
/// next rows follow from it.
#[test]
fn the_conventions_of_the_first_row_are_found() {
    let rows = exact(401);
    let head = "t,q0,q1,q2,q3,wx,wy,wz";
    for (order, sense, frame) in [
        ("wxyz", "body_to_space", "space"),
        ("xyzw", "body_to_space", "body"),
        ("wxyz", "space_to_body", "body"),
        ("xyzw", "space_to_body", "space"),
    ] {
        let cells = |row: &Row| {
            let ([w, x, y, z], rate) = (row.1, if frame == "space" { in_space(row) } else { row.2 });
            let [x, y, z] = [x, y, z].map(|c| if sense == "space_to_body" { -c } else { c });
            let q = if order == "wxyz" { [w, x, y, z] } else { [x, y, z, w] };
            [&q[..], &rate[..]].concat()
        };
        let files = [("run.csv", text(head, &rows, cells))];
        let report = judged(&json!({ "files": ["run.csv"], "moments": BODY }), &files).unwrap();
        let (run, context) = (only_run(&report), [order, sense, frame]);
        let found = &run["reading"]["found"];
        assert_eq!(found["quaternion"], order, "{context:?}");
        assert_eq!(found["sense"], sense, "{context:?}");
        assert_eq!(run["reading"]["omega_axes"], frame, "{context:?}");
        assert!(number(&run["error"]["attitude_largest_rad"]) < 1e-14, "{context:?}: {}", run["error"]);
    }
}

/// A clock in ms whose header states no unit is found, as with a scenario.
#[test]
fn the_unit_of_the_times_is_found() {
    let rows: Vec<Row> = exact(401).into_iter().map(|(t, q, w)| (1e3 * t + 40.0, q, w)).collect();
    let files = [("run.csv", text(HEAD, &rows, plain))];
    let report = judged(&json!({ "files": ["run.csv"], "moments": BODY }), &files).unwrap();
    let run = only_run(&report);
    assert_eq!(number(&run["reading"]["found"]["time_factor"]), 1e-3);
    assert!(number(&run["error"]["attitude_largest_rad"]) < 1e-13, "{run}");
}

/// The given ω supplies that of a log without ω, and replaces that of another log, whose ω is then
/// compared with it.
#[test]
fn omega_at_the_start_can_be_given() {
    let rows = exact(401);
    let omega = "(40.107045659157644, -22.918311805232932, 63.0253574643905663) deg/s";
    let without = [("run.csv", text("t,qw,qx,qy,qz", &rows, |row| row.1.to_vec()))];
    let request = json!({ "files": ["run.csv"], "moments": BODY, "start-omega": omega });
    let report = judged(&request, &without).unwrap();
    assert!(number(&only_run(&report)["error"]["attitude_largest_rad"]) < 1e-14);

    let faster = [("run.csv", text(HEAD, &rows, |(_, q, w)| [&q[..], &w.map(|c| 1.01 * c)].concat()))];
    let error = &only_run(&judged(&request, &faster).unwrap())["error"].clone();
    assert!(number(&error["attitude_largest_rad"]) < 1e-14);
    assert!((number(&error["rates"]["omega_relative"]) - 0.01).abs() < 1e-12, "{error}");
    let own = judged(&json!({ "files": ["run.csv"], "moments": BODY }), &faster).unwrap();
    assert!(number(&only_run(&own)["error"]["attitude_largest_rad"]) > 0.01);
}

/// The first of several runs gives the start.
#[test]
fn several_runs_are_of_one_motion() {
    let shifted: Vec<Row> = exact(201).into_iter().skip(1).collect();
    let files = [("a.csv", text(HEAD, &exact(401), plain)), ("b.csv", text(HEAD, &shifted, plain))];
    let report = judged(&json!({ "files": ["a.csv", "b.csv"], "moments": BODY }), &files).unwrap();
    for run in report["runs"].as_array().unwrap() {
        assert!(number(&run["error"]["attitude_largest_rad"]) < 1e-14, "{run}");
    }
}

/// Wrong signs of ω are a mistake in the log, not another convention of its attitudes: the report
/// is that on a scenario file. In a log of an inaccurate program, −ω along body axes differs too
/// little from conjugate attitudes with ω along space axes.
#[test]
fn wrong_signs_of_omega_are_found() {
    let omega = format!("{}, {}, {}", OMEGA[0], OMEGA[1], OMEGA[2]);
    for head in [HEAD, "t,qw,qx,qy,qz,wx,wy,wz"] {
        for signs in [[-1.0, -1.0, -1.0], [1.0, 1.0, -1.0]] {
            for (rows, is_exact) in [(exact(401), true), (euler(401), false)] {
                let wrong = |(_, q, w): &Row| [&q[..], &[0, 1, 2].map(|i| signs[i] * w[i])].concat();
                let files = [("run.csv", text(head, &rows, wrong)), ("body.toml", scenario(&rows))];
                let by_file = judged(&json!({ "files": ["body.toml", "run.csv"] }), &files).unwrap();
                let by_log = json!({ "files": ["run.csv"], "moments": BODY });
                let by_option = json!({ "files": ["run.csv"], "moments": BODY, "start-omega": omega });
                let context = format!("{head} {signs:?} {is_exact}");
                let same = |request: &Value| {
                    let report = judged(request, &files).unwrap();
                    assert_eq!(untitled(report), untitled(by_file.clone()), "{context} {request}");
                    let (has_failed, answer) = answer(request, &files);
                    assert!(has_failed && answer.contains("Mistake in the log: ω has the"), "{answer}");
                };
                same(&by_option);
                if is_exact || judged(&by_log, &files).is_ok() {
                    same(&by_log);
                } else {
                    let message = refused(&by_log, &files);
                    let hint = "or ω at the first row: --start-omega X,Y,Z";
                    assert!(message.contains("2 interpretations") && message.contains(hint), "{message}");
                }
            }
        }
    }
}

/// Spins about a principal axis: −ω is equivalent to conjugate attitudes.
#[test]
fn indistinguishable_senses_are_refused() {
    let row = |k: u32| {
        let half = 0.012 * f64::from(k);
        (0.02 * f64::from(k), [half.cos(), 0.0, half.sin(), 0.0], [0.0, -1.2, 0.0])
    };
    let rows: Vec<Row> = (0..200).map(row).collect();
    let files = [("run.csv", text(HEAD, &rows, plain))];
    let mut request = json!({ "files": ["run.csv"], "moments": BODY });
    let message = refused(&request, &files);
    assert!(message.contains("interpretations") && message.contains("--sense"), "{message}");
    request["sense"] = "space-to-body".into();
    assert!(number(&only_run(&judged(&request, &files).unwrap())["error"]["attitude_largest_rad"]) < 1e-14);
    let stated = json!({ "sense": "body-to-space", "omega": "body", "start-omega": "0, 1.2, 0" });
    request.as_object_mut().unwrap().extend(stated.as_object().unwrap().clone());
    let error = &only_run(&judged(&request, &files).unwrap())["error"].clone();
    assert!(number(&error["attitude_largest_rad"]) < 1e-14, "{error}");
    assert!((number(&error["rates"]["omega_relative"]) - 2.0).abs() < 1e-14, "{error}");
}

#[test]
fn a_first_row_without_rotation_is_explained() {
    let rows = exact(101);
    let first = |row: &Row| if row.0 == 0.0 { [&row.1[..], &[0.0; 3]].concat() } else { plain(row) };
    let still = |row: &Row| if row.0 < 0.1 { [&rows[5].1[..], &[0.0; 3]].concat() } else { plain(row) };
    let constant = |(_, _, w): &Row| [&[0.6, -0.3, 0.5, 0.2][..], w].concat();
    let files = [
        ("first.csv", text(HEAD, &rows, first)),
        ("still.csv", text(HEAD, &rows, still)),
        ("constant.csv", text(HEAD, &rows, constant)),
    ];
    for (run, says, hint) in [
        (
            "first.csv",
            "ω of the first row is 0, but the attitude rotates at 1.364 rad/s between rows 1 and 2",
            "--start-omega X,Y,Z; or delete the row",
        ),
        ("still.csv", "rad/s between rows 6 and 7", "delete the rows before the motion"),
        ("constant.csv", "the attitude is the same in rows 1 and 2", "--start-omega X,Y,Z"),
    ] {
        let message = refused(&json!({ "files": [run], "moments": BODY }), &files);
        assert!(message.contains(says) && message.contains(hint) && !message.contains('—'), "{message}");
    }
}

/// Rest is the same motion in every convention, so the named one is used.
#[test]
fn a_body_at_rest_is_judged() {
    for (head, order) in
        [(HEAD, "wxyz"), ("t,q0,q1,q2,q3,wx,wy,wz", "wxyz"), ("t,qx,qy,qz,qw,wx,wy,wz", "xyzw")]
    {
        let at_rest = |_: &Row| vec![0.6, -0.3, 0.5, 0.2, 0.0, 0.0, 0.0];
        let files = [("run.csv", text(head, &exact(101), at_rest))];
        let request = json!({ "files": ["run.csv"], "moments": BODY });
        let report = judged(&request, &files).unwrap();
        assert_eq!(only_run(&report)["reading"]["found"]["quaternion"], order);
        assert_eq!(only_run(&report)["reading"]["found"]["sense"], "body_to_space");
        assert!(number(&only_run(&report)["error"]["attitude_largest_rad"]) < 1e-15);
        assert!(!answer(&request, &files).0);
    }
}

#[test]
fn contradictory_and_incomplete_requests_are_refused() {
    let rows = exact(101);
    let files = [
        ("run.csv", text(HEAD, &rows, plain)),
        ("no-omega.csv", text("t,qw,qx,qy,qz", &rows, |row| row.1.to_vec())),
        ("no-attitude.csv", text("t,wx,wy,wz", &rows, |row| row.2.to_vec())),
        ("degrees.csv", text(HEAD, &rows, |(_, q, w)| [&q[..], &w.map(f64::to_degrees)].concat())),
        ("named.csv", format!("# scenario = \"body.toml\"\n{}", text(HEAD, &rows, plain))),
        ("body.toml", scenario(&rows)),
    ];
    for (request, says) in [
        (json!({ "files": ["no-omega.csv"], "moments": BODY }), "by --start-omega"),
        (json!({ "files": ["no-attitude.csv"], "moments": BODY }), "attitude"),
        (json!({ "files": ["degrees.csv"], "moments": BODY }), "0.01745 times |ω|"),
        (
            json!({ "files": ["named.csv"], "moments": BODY }),
            "names the scenario \"body.toml\", but --moments",
        ),
        (json!({ "files": ["body.toml", "run.csv"], "moments": BODY }), "body.toml and --moments both state"),
        (json!({ "files": ["run.csv"], "moments": "1, 2, 10" }), "is less than i3 = 10"),
        (json!({ "files": ["run.csv"], "moments": BODY, "axes": "y,z,x" }), "--axes has no effect"),
        (json!({ "files": ["run.csv"], "moments": BODY, "time-origin": 1 }), "--time-origin has no effect"),
        (json!({ "suite": "runs", "moments": BODY }), "--moments has no effect on the suite"),
        (json!({ "files": ["body.toml", "run.csv"], "start-omega": "0, 0, 1" }), "without --moments"),
        (json!({ "files": ["run.csv"] }), "--moments A,B,C"),
    ] {
        let message = refused(&request, &files);
        assert!(message.contains(says), "{request}: {message}");
    }
}
