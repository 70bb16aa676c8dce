//! `polhode torque`: from a prescribed motion to the required torque.

use std::f64::consts::PI;
use std::fs;

use crate::common::{Scratch, example, json, number, numbers, refused, stdout};

#[test]
fn the_dumbbell_has_the_torque_and_the_forces_of_the_notes() {
    let scratch = Scratch::new("torque-dumbbell");
    let file = example("notes/11-10-dumbbell.toml");
    let report = json(&scratch.run(&["torque", &file, "--json", "--at", "0.5 s,1500 ms"]));
    let [m1, m2, b, omega, alpha] = [2.0, 3.0, 0.5, PI, PI / 6.0];
    let expected = -(m1 + m2) * b * b * omega * omega * alpha.sin() * alpha.cos();
    let torque = numbers(&report["start"]["torque_body_n_m"]);
    assert!((torque[0] - expected).abs() < 1e-14 && torque[1].abs() < 1e-14 && torque[2].abs() < 1e-14);
    // Every mass moves on a circle: F = m ω² b sin α toward the axis.
    let forces = report["start"]["particle_forces"].as_array().unwrap();
    for (force, m) in forces.iter().zip([m1, m2]) {
        let f = numbers(&force["force_body_n"]);
        let size = f.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((size - m * omega * omega * b * alpha.sin()).abs() < 1e-13, "{f:?}");
    }
    assert_eq!((forces.len(), report["at"].as_array().unwrap().len()), (2, 2));
    assert!(number(&report["work_j"]).abs() < 1e-13);
    let [omega, body, space] = ["omega_body", "momentum_body_kg_m2_s", "momentum_space_kg_m2_s"]
        .map(|key| numbers(&report["start"][key]));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    assert!((0.5 * dot(&omega, &body) - number(&report["start"]["kinetic_energy_j"])).abs() < 1e-14);
    assert!((dot(&body, &body) - dot(&space, &space)).abs() < 1e-14);
    // Half a turn later the torque in space axes is reversed.
    let later = json(&scratch.run(&["torque", &file, "--json", "--at", "1"]));
    let [now, then] = [&later["start"], &later["at"][0]].map(|s| numbers(&s["torque_space_n_m"]));
    let axis = [0.0, 0.5, 0.75_f64.sqrt()];
    let along: f64 = now.iter().zip(axis).map(|(a, b)| a * b).sum();
    for k in 0..3 {
        assert!((now[k] + then[k] - 2.0 * along * axis[k]).abs() < 1e-13);
    }
    let text = stdout(&scratch.run(&["torque", &file]));
    let answer = "The motion needs a torque of 5.342 N·m at the start.\nThe power is 0 W throughout.\n";
    assert!(text.contains(answer), "{text}");
    assert!(text.contains("  N                   (-5.34208, 0, 0) N·m, in body axes"), "{text}");
    assert!(text.contains("force on particle 1 (0, 4.27366, -2.4674) N"), "{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 101), "{text}");
}

#[test]
fn a_slew_begins_and_ends_without_torque() {
    let scratch = Scratch::new("torque-slew");
    let file = example("slew.toml");
    let text =
        stdout(&scratch.run(&["torque", &file, "-o", "slew.csv", "--point", "0.5 kg, 1 m, -20 cm, 0.3 m"]));
    assert!(text.ends_with("wrote slew.csv\n"), "{text}");
    let table = fs::read_to_string(scratch.0.join("slew.csv")).unwrap();
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    let column = |name: &str| names.iter().position(|n| *n == name).unwrap_or_else(|| panic!("{name}"));
    assert_eq!((rows.len(), names.len()), (601, 18));
    let torque =
        |row: &Vec<f64>| row[column("torque_body_x_n_m")].abs() + row[column("torque_body_y_n_m")].abs();
    assert!(torque(&rows[0]) < 1e-12 && torque(&rows[600]) < 1e-11 && torque(&rows[150]) > 0.1);
    assert!(rows[600][column("work_j")].abs() < 1e-12 && rows[300][column("work_j")] > 0.01);
    // The work is the integral of the power, by Simpson's rule.
    let power = column("power_w");
    let odd: f64 = (1..300).step_by(2).map(|k| rows[k][power]).sum();
    let even: f64 = (2..300).step_by(2).map(|k| rows[k][power]).sum();
    let integral = 0.1 / 3.0 * (rows[0][power] + 4.0 * odd + 2.0 * even + rows[300][power]);
    assert!((integral - rows[300][column("work_j")]).abs() < 1e-6, "{integral}");
    assert!(rows[150][column("force_1_body_x_n")] != 0.0);
    // A table is replaced only on request; Parquet is supported too.
    let again = refused(&scratch.run(&["torque", &file, "-o", "slew.csv"]), 2);
    assert!(again.contains("slew.csv already exists"), "{again}");
    assert!(stdout(&scratch.run(&["torque", &file, "-o", "slew.csv", "--force"])).contains("wrote slew.csv"));
    assert!(
        stdout(&scratch.run(&["torque", &file, "--table", "parquet"])).contains("wrote slew-torque.parquet")
    );
    assert!(fs::read(scratch.0.join("slew-torque.parquet")).unwrap().starts_with(b"PAR1"));
    assert_eq!(scratch.entries(), ["slew-torque.parquet", "slew.csv"]);
}

#[test]
fn a_rotor_is_balanced() {
    let scratch = Scratch::new("torque-shaft");
    let file = example("shaft.toml");
    let report = json(&scratch.run(&["torque", &file, "--json"]));
    let shaft = &report["shaft"];
    assert_eq!(shaft["unbalance"], "dynamic");
    assert_eq!(shaft["balanced"]["unbalance"], "none");
    let size = |v: &serde_json::Value| numbers(v).iter().map(|x| x * x).sum::<f64>().sqrt();
    for k in 0..2 {
        let before = size(&shaft["bearings"][k]["turning_body_n"]);
        assert!(before > 10.0 && size(&shaft["balanced"]["bearings_body_n"][k]) < 1e-13 * before);
    }
    // Both bearings carry the weight.
    let held: f64 = (0..2).map(|k| numbers(&shaft["bearings"][k]["weight_space_n"])[1]).sum();
    let mass = 7850.0 * PI * (0.015 * 0.015 * 0.4 + 2.0 * 0.09 * 0.09 * 0.02);
    assert!((held - 9.81 * mass).abs() < 1e-10, "{held}");
    let text = stdout(&scratch.run(&["torque", &file]));
    assert!(text.contains("Dynamic unbalance: the bearings carry at most"), "{text}");
    assert!(text.contains("residual unbalance: none"), "{text}");
    assert!(stdout(&scratch.run(&["torque", &file, "--table", "csv"])).contains("shaft-torque.csv"));
    let table = fs::read_to_string(scratch.0.join("shaft-torque.csv")).unwrap();
    assert!(table.lines().next().unwrap().ends_with("bearing_2_body_z_n"));
}

#[test]
fn a_table_of_attitudes_tells_how_good_it_is() {
    let scratch = Scratch::new("torque-table");
    let report = json(&scratch.run(&["torque", &example("prescribed-table.toml"), "--json"]));
    assert_eq!(report["findings"][0]["code"], "prescribed.table");
    assert!(numbers(&report["largest"]["torque_body_n_m"]).iter().any(|n| n.abs() > 0.005));
}

#[test]
fn what_is_missing_is_said() {
    let scratch = Scratch::new("torque-missing");
    let computed = refused(&scratch.run(&["torque", &example("t-handle.toml")]), 2);
    assert!(computed.contains("has a [run] but no [prescribed] motion"), "{computed}");
    assert!(computed.contains("hint: `polhode simulate` computes it"), "{computed}");
    let nothing = refused(&scratch.run(&["torque", &example("notes/11-03-cube.toml")]), 2);
    assert!(nothing.contains("has no [prescribed] motion"), "{nothing}");
    let body = "[[body.part]]\nshape = 'box'\nsize = [1, 2, 3]\nmass = 1\n[prescribed]\n";
    scratch.write("timeless.toml", &format!("{body}angles = ['1[1/s]*t', 'sin(1[1/s]*t)', 0]\n"));
    assert!(stdout(&scratch.run(&["torque", "timeless.toml", "--at", "2"])).contains("at the start"));
    let timeless = refused(&scratch.run(&["torque", "timeless.toml", "--table", "csv"]), 2);
    assert!(timeless.contains("has no [run] section"), "{timeless}");
    scratch.write(
        "short.toml",
        &format!("{body}omega = {{ body = ['1[rad/s^2]*t', 0, 1] }}\n[run]\nduration = 1\n"),
    );
    let late = refused(&scratch.run(&["torque", "short.toml", "--at", "2"]), 2);
    assert!(late.contains("the time = 2 must be within the time for which the motion is given"), "{late}");
    scratch.write("root.toml", &format!("{body}angles = ['sqrt(1 - t/1[s])', 0, 0]\n[run]\nduration = 2\n"));
    let root = refused(&scratch.run(&["torque", "root.toml"]), 3);
    assert!(root.contains("the motion is not finite after t ="), "{root}");
    for point in ["1,2,3", "0,1,2,3", "1 m,0,0,0"] {
        let file = example("slew.toml");
        let output = scratch.run(&["torque", &file, "--point", point]);
        assert_eq!(output.status.code(), Some(2), "{point}");
    }
    assert_eq!(scratch.entries(), ["root.toml", "short.toml", "timeless.toml"]);
}
