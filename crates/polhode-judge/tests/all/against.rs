//! `--against`: a run compared with another log of the same motion.

use polhode::math::{Attitude, Body, Direction, Rotation, Space};
use serde_json::{Value, json};

use crate::log::{HEAD, Row, STEP, answer, conjugate, exact, in_space, judged, number, plain, refused, text};

const TURN: [f64; 3] = [0.02, -0.05, 0.03];

/// Returns the rows with all attitudes rotated in space by [`TURN`].
fn turned(rows: &[Row]) -> Vec<Row> {
    let turn = Rotation::<Space, Space>::exp(Direction::from_array(TURN)).unwrap();
    let one = |&(t, q, w): &Row| (t, (turn * Attitude::from_quaternion(q).unwrap()).quaternion(), w);
    rows.iter().map(one).collect()
}

fn compared(request: &Value, files: &[(&str, String)]) -> Value {
    let report = judged(request, files).unwrap();
    let [run] = &report["runs"].as_array().unwrap()[..] else { panic!("one run") };
    run.clone()
}

#[test]
fn equal_logs_have_no_difference() {
    // The other log has more rows, and states neither order nor frame.
    let (rows, other) = (exact(401), exact(601));
    let run: Vec<Row> = rows.into_iter().step_by(4).collect();
    let head = "t,q0,q1,q2,q3,wx,wy,wz";
    let files = [
        ("run.csv", text(HEAD, &run, plain)),
        ("other.csv", text(head, &other, |(_, [w, x, y, z], v)| [&[-x, -y, -z, *w][..], v].concat())),
    ];
    let request = json!({ "files": ["run.csv"], "against": "other.csv" });
    let found = compared(&request, &files);
    let (error, rates) = (&found["error"], &found["error"]["rates"]);
    assert!(number(&error["attitude_largest_rad"]) < 1e-15, "{error}");
    assert!(number(&rates["omega_relative"]) == 0.0 && rates["kinetic_energy_relative"].is_null(), "{rates}");
    let with_moments = json!({ "files": ["run.csv"], "against": "other.csv", "moments": "1.3, 2.9, 2.1" });
    let rates = compared(&with_moments, &files)["error"]["rates"].clone();
    assert!(number(&rates["kinetic_energy_relative"]) == 0.0, "{rates}");
    assert!(number(&rates["momentum_direction_rad"]) < 1e-15, "{rates}");
}

/// A rotation in space is found with its components, and turns the direction of L.
#[test]
fn a_rotation_offset_is_found() {
    let rows = exact(401);
    let files = [("run.csv", text(HEAD, &turned(&rows), plain)), ("other.csv", text(HEAD, &rows, plain))];
    let request = json!({ "files": ["run.csv"], "against": "other.csv", "moments": "1.3, 2.9, 2.1" });
    let found = compared(&request, &files);
    let angle = TURN.iter().map(|c| c * c).sum::<f64>().sqrt();
    let error = &found["error"];
    assert!((number(&error["attitude_last_rad"]) - angle).abs() < 1e-14, "{error}");
    assert!((number(&error["attitude_largest_rad"]) - angle).abs() < 1e-14, "{error}");
    let direction = number(&error["rates"]["momentum_direction_rad"]);
    assert!(direction > 0.5 * angle && direction < angle, "{direction}");
    assert!(number(&error["rates"]["momentum_relative"]) < 1e-15, "{error}");
    let part = &found["split"]["parts"][0];
    assert_eq!(part["part"], "start");
    for (value, expected) in part["value"].as_array().unwrap().iter().zip(TURN) {
        // The fit is linear in the angle.
        assert!((number(value) - expected).abs() < 2e-3, "{part}");
    }
}

/// A rotation about one axis has the same ω along body and space axes, so the frame is not needed.
#[test]
fn a_rotation_about_one_axis_needs_no_frame() {
    let row = |k: u32| {
        let time = STEP * f64::from(k);
        (
            time,
            [(0.4 * time).cos(), 0.0, (0.4 * time).sin() * 0.6, (0.4 * time).sin() * 0.8],
            [0.0, 0.48, 0.64],
        )
    };
    let rows: Vec<Row> = (0..201).map(row).collect();
    let files = [("run.csv", text("t,q0,q1,q2,q3,wx,wy,wz", &rows, plain))];
    let found = compared(&json!({ "files": ["run.csv"], "against": "run.csv" }), &files);
    assert_eq!(found["reading"]["found"]["quaternion"], "wxyz");
    assert_eq!(number(&found["error"]["attitude_largest_rad"]), 0.0);
}

/// Without ω, the stated conventions are used; T and L are not compared.
#[test]
fn logs_without_omega_are_compared_by_their_attitudes() {
    let rows = exact(101);
    let only = |(_, q, _): &Row| q.to_vec();
    let columns = "# columns = \"quaternion wxyz body-to-space = qw qx qy qz\"\nt,qw,qx,qy,qz";
    let files =
        [("run.csv", text("t,qw,qx,qy,qz", &turned(&rows), only)), ("other.csv", text(columns, &rows, only))];
    let request = json!({ "files": ["run.csv"], "against": "other.csv", "sense": "body-to-space" });
    let error = compared(&request, &files)["error"].clone();
    let angle = TURN.iter().map(|c| c * c).sum::<f64>().sqrt();
    assert!((number(&error["attitude_largest_rad"]) - angle).abs() < 1e-14, "{error}");
    assert!(error["rates"].is_null());
    let message = refused(&json!({ "files": ["run.csv"], "against": "other.csv" }), &files);
    assert!(message.contains("has no ω") && message.contains("--sense"), "{message}");
}

#[test]
fn logs_that_cannot_be_compared_are_refused() {
    let rows = exact(101);
    let late: Vec<Row> = rows.iter().map(|&(t, q, w)| (t + 0.4 * STEP, q, w)).collect();
    let in_body = Rotation::<Body, Body>::exp(Direction::new(0.4, 0.1, -0.2)).unwrap();
    let other_body = |&(_, q, w): &Row| {
        let q = (Attitude::from_quaternion(q).unwrap() * in_body).quaternion();
        [&q[..], &w.map(|c| 3.0 * c)].concat()
    };
    let files = [
        ("run.csv", text(HEAD, &rows, plain)),
        ("late.csv", text(HEAD, &late, plain)),
        ("short.csv", text(HEAD, &rows[..60], plain)),
        ("unlike.csv", text(HEAD, &rows, other_body)),
        ("a.csv", format!("# scenario = \"a.toml\"\n{}", text(HEAD, &rows, plain))),
        ("b.csv", format!("# scenario = \"b.toml\"\n{}", text(HEAD, &rows, plain))),
        ("body.toml", String::new()),
    ];
    for (request, says) in [
        (json!({ "files": ["run.csv"], "against": "late.csv" }), "a row at 0 s, but late.csv has none"),
        (json!({ "files": ["run.csv"], "against": "short.csv" }), "a row at 1.2 s, but short.csv has none"),
        (json!({ "files": ["run.csv"], "against": "unlike.csv" }), "do not rotate as its ω states"),
        (json!({ "files": ["a.csv"], "against": "b.csv" }), "\"a.toml\", but b.csv names \"b.toml\""),
        (
            json!({ "files": ["body.toml", "run.csv"], "against": "late.csv" }),
            "body.toml and --against both state",
        ),
        (json!({ "suite": "runs", "against": "late.csv" }), "--against has no effect on the suite"),
        (
            json!({ "files": ["run.csv"], "against": "late.csv", "moments": "1, 2, 2.5", "start-omega": "0, 0, 1" }),
            "--start-omega has no effect with --against",
        ),
        (json!({ "files": ["run.csv"], "against": "run.csv", "moments": "1, 2, 10" }), "less than i3 = 10"),
        (json!({ "against": "run.csv" }), "no log to judge"),
    ] {
        let message = refused(&request, &files);
        assert!(message.contains(says), "{request}: {message}");
    }
    // A declared clock makes the times equal.
    let request = json!({ "files": ["late.csv"], "against": "run.csv", "time-origin": 0.4 * STEP });
    assert!(number(&compared(&request, &files)["error"]["attitude_largest_rad"]) < 1e-15);
}

/// A changed convention is not "no difference": it is stated, and the exit status is 1.
#[test]
fn changed_conventions_are_reported() {
    let rows = exact(201);
    let space = |row: &Row| [&row.1[..], &in_space(row)].concat();
    let silent = "t,qw,qx,qy,qz,wx,wy,wz";
    let files = [
        ("run.csv", text(HEAD, &rows, plain)),
        ("space.csv", text(HEAD, &rows, space)),
        ("silent.csv", text(silent, &rows, plain)),
        ("silent-space.csv", text(silent, &rows, space)),
        ("conjugate.csv", text(silent, &rows, conjugate)),
    ];
    let contrary = "Interpreted contrary to its column names: space.csv: ";
    let different = "The same columns have different meanings: ";
    for (run, other, says) in [
        ("space.csv", "run.csv", contrary),
        ("run.csv", "space.csv", contrary),
        ("space.csv", "space.csv", contrary),
        ("conjugate.csv", "silent.csv", different),
        ("silent.csv", "conjugate.csv", different),
        ("silent-space.csv", "silent.csv", different),
    ] {
        let request = json!({ "files": [run], "against": other });
        let (has_failed, answer) = answer(&request, &files);
        assert!(has_failed && answer.contains(says), "{run} {other}: {answer}");
        assert!(answer.contains("interpreted as follows\n"), "{run} {other}: {answer}");
        let report = judged(&request, &files).unwrap();
        let (run_found, other_found) = (&report["runs"][0], &report["against"]["reading"]);
        assert_eq!(run_found["reading"]["against_names"], run == "space.csv");
        assert_eq!(other_found["against_names"], other == "space.csv");
        assert_eq!(run_found["other_meaning"], run != other, "{run} {other}");
    }
    // Declared conventions, and those that the names leave open, are not contradictions.
    for request in [
        json!({ "files": ["space.csv"], "against": "run.csv", "omega": "space" }),
        json!({ "files": ["conjugate.csv"], "against": "silent.csv", "sense": "space-to-body" }),
        json!({ "files": ["conjugate.csv"], "against": "run.csv" }),
        json!({ "files": ["silent-space.csv"], "against": "run.csv" }),
    ] {
        let (has_failed, answer) = answer(&request, &files);
        assert!(!has_failed && answer.starts_with("No difference above"), "{request}: {answer}");
        assert!(!answer.contains('\n'), "{request}: {answer}");
    }
}

/// The conventions follow from the rows that rotate, wherever they are.
#[test]
fn a_log_that_starts_at_rest_is_compared() {
    let moving = exact(201);
    let (_, attitude, _) = moving[0];
    let rest = (0..600).map(|k| (STEP * f64::from(k), attitude, [0.0; 3]));
    let rows: Vec<Row> = rest.chain(moving.iter().map(|&(t, q, w)| (t + 600.0 * STEP, q, w))).collect();
    let files = [
        ("run.csv", text("t,q0,q1,q2,q3,wx,wy,wz", &rows, plain)),
        ("rest.csv", text(HEAD, &rows[..600], plain)),
        ("sparse.csv", text(HEAD, &exact(601).into_iter().step_by(60).collect::<Vec<_>>(), plain)),
        ("degrees.csv", text(HEAD, &moving, |(_, q, w)| [&q[..], &w.map(f64::to_degrees)].concat())),
        ("attitudes.csv", text("t,qw,qx,qy,qz", &moving, |row| row.1.to_vec())),
    ];
    let found = compared(&json!({ "files": ["run.csv"], "against": "run.csv" }), &files);
    assert_eq!(found["reading"]["found"]["quaternion"], "wxyz");
    for (run, says) in [
        ("rest.csv", "the attitude does not rotate, so"),
        ("sparse.csv", "rotates by more than 1 rad from row to row"),
        ("degrees.csv", "their rate is 0.01745 times |ω|"),
        ("degrees.csv", "(check the units of ω"),
    ] {
        let message = refused(&json!({ "files": [run], "against": "run.csv" }), &files);
        // The other log is read first.
        let by_other = refused(&json!({ "files": ["run.csv"], "against": run }), &files);
        assert!(message.contains(says) && by_other.contains(says), "{message}\n{by_other}");
    }
    for request in [
        json!({ "files": ["attitudes.csv"], "against": "run.csv" }),
        json!({ "files": ["run.csv"], "against": "attitudes.csv" }),
    ] {
        let message = refused(&request, &files);
        assert!(message.contains("has no ω") && !message.contains("omega"), "{message}");
    }
}

/// A log at rest has no largest ω, so that of the run is the unit.
#[test]
fn a_rotating_run_differs_from_a_log_at_rest() {
    let rows: Vec<Row> = exact(101).into_iter().map(|(t, _, w)| (t, [0.6, -0.3, 0.5, 0.2], w)).collect();
    let columns = "# columns = \"quaternion wxyz body-to-space = qw qx qy qz, omega body = wx wy wz\"\nt,qw,qx,qy,qz,wx,wy,wz";
    let still = |(_, q, _): &Row| [&q[..], &[0.0; 3]].concat();
    let files = [("run.csv", text(columns, &rows, plain)), ("rest.csv", text(columns, &rows, still))];
    let request = json!({ "files": ["run.csv"], "against": "rest.csv", "moments": "1.3, 2.9, 2.1" });
    let rates = &compared(&request, &files)["error"]["rates"];
    for name in ["omega_relative", "kinetic_energy_relative", "momentum_relative"] {
        assert_eq!(number(&rates[name]), 1.0, "{name}");
    }
}
