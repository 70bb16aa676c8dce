//! Rotors in gimbals, tested through the command.

use std::fs;

use crate::common::{Scratch, example, json, number, refused, stdout};

#[test]
fn the_gyrocompass_is_simulated() {
    let scratch = Scratch::new("gimbals");
    let compass = example("gyrocompass.toml");
    let arguments = ["simulate", &compass, "--output", "run", "--table", "csv", "--table", "parquet", "-v"];
    let text = stdout(&scratch.run(&arguments));
    for line in [
        "the equations of a rotor in gimbals have Taylor series",
        "ω of the base       (0, 44.8947, 57.4627) µrad/s",
        "inner axis          (1, 0, 0), with all angles zero, locked at 0 rad (0°)",
        "T + U − works of the axes and the base; relative, worst sample",
        "outer angle         30° → ",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    // Work and impulse follow from theorems and are not independent checks, so they are not
    // printed.
    assert!(!text.contains("T - work") && !text.contains("free motion"), "{text}");
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(scratch.0.join("run/summary.json")).unwrap()).unwrap();
    let gimbals = &summary["gimbals"];
    let holds: Vec<_> = (0..3).map(|k| gimbals["axes"][k]["hold"].as_str().unwrap()).collect();
    assert_eq!(holds, ["free", "locked", "driven"]);
    assert!(number(&gimbals["energy_drift"]) < 1e-13);
    assert!(summary["drift"].is_null() && summary["motion"]["regime"].is_null());
    assert!(summary["contact"].is_null() && summary["complete"] == true);
    let table = fs::read_to_string(scratch.0.join("run/trajectory.csv")).unwrap();
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let last: Vec<f64> = lines.next_back().unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    let of = |name: &str| last[names.iter().position(|other| *other == name).unwrap()];
    // The table and the summary describe the same motion.
    let end = &gimbals["final"];
    for (k, axis) in ["outer", "inner", "rotor"].iter().enumerate() {
        assert_eq!(of(&format!("{axis}_angle_rad")), number(&end["angles_rad"][k]));
        assert_eq!(of(&format!("{axis}_rate_rad_s")), number(&end["rates_rad_s"][k]));
        assert_eq!(of(&format!("{axis}_holding_n_m")), number(&end["holding_n_m"][k]));
    }
    for (name, key) in [
        ("total_kinetic_energy_j", "kinetic_energy_j"),
        ("damping_work_j", "damping_work_j"),
        ("motor_work_j", "motor_work_j"),
        ("base_work_j", "base_work_j"),
    ] {
        assert_eq!(of(name), number(&end[key]), "{name}");
    }
    assert!(of("inner_holding_n_m") != 0.0 && of("damping_work_j") < 0.0);
    let page = fs::read_to_string(scratch.0.join("run/report.html")).unwrap();
    assert!(page.contains("It hangs in two gimbals on a base that turns"), "the caption");
}

#[test]
fn what_does_not_know_gimbals_says_so() {
    let scratch = Scratch::new("gimbals-refused");
    let compass = example("gyrocompass.toml");
    scratch.write("run.csv", "time_s,qw,qx,qy,qz\n0,1,0,0,0\n1,0.6,0.8,0,0\n");
    for (arguments, why) in [
        (&["explain", &compass][..], "the body hangs in gimbals: worked solutions cover bodies that"),
        (&["stability", &compass], "is in gimbals"),
        (&["spin", &compass], "is not a free motion: the body hangs in gimbals"),
        (&["judge", &compass, "run.csv"], "the scenario's body is in gimbals"),
        (&["torque", &compass], "its motion is computed, not given"),
        (&["sweep", &compass], "[sweep]"),
    ] {
        let error = refused(&scratch.run(arguments), 2);
        assert!(error.contains(why), "{arguments:?}: {error}");
    }
    let mass = json(&scratch.run(&["inertia", &compass, "--json"]));
    assert!((number(&mass["mass"]) - 2.0).abs() < 1e-15);
}

/// The motion before gimbal lock is written, and marked incomplete.
#[test]
fn gimbals_that_lock_leave_a_motion_incomplete() {
    let scratch = Scratch::new("gimbals-lock");
    let body = "[[body.part]]\nshape = 'cylinder'\nradius = '25 mm'\nlength = '12 mm'\nmass = '200 g'\n";
    let gimbals = "[gimbals]\nouter_axis = [0, 0, 1]\ninner_axis = [1, 0, 0]\ninner = { angle = '30 deg', rate = '40 deg/s' }\n";
    scratch.write("lock.toml", &format!("{body}{gimbals}[run]\nduration = '4 s'\nsamples = 41\n"));
    let output = scratch.run(&["simulate", "lock.toml", "--no-page"]);
    let error = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(3), "{error}");
    assert!(error.contains("the gimbals lock"), "{error}");
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(scratch.0.join("lock/summary.json")).unwrap()).unwrap();
    assert_eq!(
        (summary["complete"].as_bool(), summary["end"]["reason"].as_str()),
        (Some(false), Some("failure"))
    );
    assert!((number(&summary["end"]["time_s"]) - 1.5).abs() < 1e-3);
    assert!(number(&summary["error"]["attitude_rad"]) < 1e-9, "{}", summary["error"]);
}
