//! Bodies on the ground, tested through the command.

use std::fs;

use crate::common::{Scratch, example, json, number, refused, stdout};

#[test]
fn the_tippe_top_is_simulated() {
    let scratch = Scratch::new("contact");
    let top = example("tippe-top.toml");
    let text =
        stdout(&scratch.run(&["simulate", &top, "--output", "run", "--table", "csv", "--table", "parquet"]));
    for line in [
        "It rolls or slides, with friction, on a level plane: sliding at the start; ",
        "  surface             sphere, radius 18 mm, centred at (0, 0, 4) mm in the body",
        "  ground              a level plane",
        "  contact law         friction µ = 0.3",
        "the point of contact has come to rest, and friction holds it",
        "  energy balance ",
        "T + U − works of the contact; relative, worst sample",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    // Work and impulse follow from theorems and are not independent checks, so they are not
    // printed.
    assert!(!text.contains("T − work") && !text.contains("free motion"), "{text}");
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(scratch.0.join("run/summary.json")).unwrap()).unwrap();
    let contact = &summary["contact"];
    assert_eq!(contact["surface"]["shape"], "sphere");
    assert_eq!(contact["law"]["name"], "friction");
    assert_eq!(
        (contact["start"]["phase"].as_str(), contact["final"]["phase"].as_str()),
        (Some("sliding"), Some("rolling"))
    );
    assert_eq!(contact["changes"][0]["change"], "grips");
    assert!(number(&contact["energy_drift"]) < 1e-12);
    assert!(summary["drift"].is_null() && summary["motion"]["regime"].is_null());
    assert!(number(&summary["energy"]["work_j"]) < -0.01, "{}", summary["energy"]);
    let table = fs::read_to_string(scratch.0.join("run/trajectory.csv")).unwrap();
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let first: Vec<f64> = lines.next().unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    let last: Vec<f64> = lines.next_back().unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    let of = |row: &[f64], name: &str| row[names.iter().position(|other| *other == name).unwrap()];
    assert_eq!([of(&first, "contact_phase"), of(&last, "contact_phase")], [1.0, 0.0]);
    // The table and the summary describe the same motion.
    for (name, key) in [
        ("normal_force_n", "normal_force_n"),
        ("total_kinetic_energy_j", "kinetic_energy_j"),
        ("potential_energy_j", "potential_energy_j"),
        ("friction_work_j", "friction_work_j"),
        ("ground_work_j", "ground_work_j"),
    ] {
        assert_eq!(of(&last, name), number(&contact["final"][key]), "{name}");
    }
    for (k, axis) in ["x", "y", "z"].iter().enumerate() {
        assert_eq!(of(&last, &format!("position_space_{axis}_m")), number(&contact["final"]["center_m"][k]));
        assert_eq!(of(&last, &format!("contact_space_{axis}_m")), number(&contact["final"]["contact_m"][k]));
        assert_eq!(
            of(&last, &format!("contact_body_{axis}_m")),
            number(&contact["final"]["contact_body_m"][k])
        );
        assert_eq!(
            of(&last, &format!("friction_space_{axis}_n")),
            number(&contact["final"]["friction_n"][k])
        );
    }
    assert!(of(&first, "slip_speed_m_s") > 0.05 && of(&last, "slip_speed_m_s") < 1e-12);
    let page = fs::read_to_string(scratch.0.join("run/report.html")).unwrap();
    assert!(page.contains("It rolls or slides, with friction, on a level plane"), "the caption");
}

#[test]
fn what_does_not_know_the_ground_says_so() {
    let scratch = Scratch::new("contact-refused");
    let disk = example("hoop.toml");
    scratch.write("run.csv", "time_s,qw,qx,qy,qz\n0,1,0,0,0\n1,0.6,0.8,0,0\n");
    for (arguments, why) in [
        (&["stability", &disk][..], "the ground is not level"),
        (&["spin", &disk], "is not a free motion: the body is on the ground"),
        (&["judge", &disk, "run.csv"], "the scenario's body is on the ground"),
        (&["torque", &disk], "its motion is computed, not given"),
        (&["sweep", &disk], "[sweep]"),
    ] {
        let error = refused(&scratch.run(arguments), 2);
        assert!(error.contains(why), "{arguments:?}: {error}");
    }
    let mass = json(&scratch.run(&["inertia", &disk, "--json"]));
    assert!((number(&mass["mass"]) - 0.4).abs() < 1e-15);
}

/// A motion that ends because of its contact is complete, not failed.
#[test]
fn a_disk_that_falls_flat_ends_its_run() {
    let scratch = Scratch::new("contact-flat");
    let text = fs::read_to_string(example("coin.toml")).unwrap();
    scratch.write("coin.toml", &text.replace("\"7 s\"\nsamples = 2801", "\"9 s\"\nsamples = 10"));
    let text = stdout(&scratch.run(&["simulate", "coin.toml", "--no-page"]));
    assert!(text.contains("ended at t = 7.50") && text.contains("the disk lies flat"), "{text}");
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(scratch.0.join("coin/summary.json")).unwrap()).unwrap();
    assert_eq!(
        (summary["complete"].as_bool(), summary["end"]["reason"].as_str()),
        (Some(true), Some("contact"))
    );
}
