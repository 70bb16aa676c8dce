//! Bodies of changing mass, tested through the command.

use crate::common::{Scratch, example, json, number, refused, stdout};

#[test]
fn the_stage_burns_and_what_does_not_know_it_says_so() {
    let scratch = Scratch::new("mass-history");
    let stage = example("spinning-stage.toml");
    let text = stdout(&scratch.run(&["simulate", &stage, "--output", "run"]));
    assert!(text.contains("425 → 150 kg, through an exit, with jet damping"), "{text}");
    assert!(text.contains("The mass of the body changes") && !text.contains("free motion"), "{text}");
    let summary: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(scratch.0.join("run/summary.json")).unwrap()).unwrap();
    let history = &summary["mass_history"];
    assert_eq!(
        (history["outflow"].as_str(), history["changes_at_s"].as_array().map(Vec::len)),
        (Some("exits"), Some(3))
    );
    assert!((number(&history["final"]["mass_kg"]) - 150.0).abs() < 1e-12);
    assert!(number(&summary["drift"]["momentum"]) < 1e-13 && summary["motion"]["regime"].is_null());
    // Jet damping: the spin is proportional to J^(µ r²/2 b − 1), where b is the rate of decrease of
    // J.
    let [x, y, z] = [0, 1, 2].map(|k| number(&summary["final"]["omega_body"][k]));
    assert!(x.hypot(y) < 0.002, "{x} {y}");
    let (mu, b, grain, rest) = (
        250.0 / 45.0,
        250.0 / 45.0 * 0.29_f64.powi(2) / 2.0,
        250.0 * 0.29_f64.powi(2) / 2.0,
        payload_and_case(),
    );
    let spin = std::f64::consts::TAU * ((rest + grain) / rest).powf(1.0 - mu * 0.2_f64.powi(2) / (2.0 * b));
    assert!((z / spin - 1.0).abs() < 1e-12, "{z} {spin}");

    for command in ["explain", "stability"] {
        let error = refused(&scratch.run(&[command, &stage]), 2);
        assert!(
            error.contains("worked solution") || error.contains("steady motions are not defined"),
            "{error}"
        );
    }
    let error = refused(&scratch.run(&["spin", &stage]), 2);
    assert!(error.contains("the mass properties change"), "{error}");
    let mass = json(&scratch.run(&["inertia", &stage, "--json"]));
    assert!((number(&mass["mass"]) - 425.0).abs() < 1e-10, "that at the start: {mass}");
    assert_eq!(mass["findings"][0]["code"], "mass_history.start");
    let taken = "the mass properties change with time: these are those at t = 0 s";
    assert_eq!(mass["findings"][0]["message"], taken);
    scratch.write("parts.csv", &format!("name,scenario\nstage,\"{stage}\"\n"));
    let folder = std::path::Path::new(&stage).parent().unwrap().to_str().unwrap();
    let data = json(&scratch.run(&["budget", "parts.csv", "--root", folder, "--json"]));
    assert!(data.to_string().contains(taken), "{data}");
    // The scenario cannot be judged against; the run itself is valid.
    scratch.write("run.csv", "time_s,qw,qx,qy,qz\n0,1,0,0,0\n1,0.6,0.8,0,0\n");
    let error = refused(&scratch.run(&["judge", &stage, "run.csv"]), 2);
    assert!(error.contains("the mass properties of the scenario's body change"), "{error}");
    assert!(
        error.contains("--> ") && error.contains("spinning-stage.toml") && !error.contains("run.csv"),
        "{error}"
    );
}

/// The mass line of runs that cover all of a history, a part of it, or none.
#[test]
fn the_line_of_the_mass_says_what_happens_in_the_run() {
    let scratch = Scratch::new("mass-line");
    let text = std::fs::read_to_string(example("spinning-stage.toml")).unwrap();
    let line = |changed: &[(&str, &str)]| {
        let text = changed.iter().fold(text.clone(), |text, (old, new)| {
            assert!(text.contains(old), "{old}");
            text.replace(old, new)
        });
        scratch.write("stage.toml", &text);
        let said = stdout(&scratch.run(&["simulate", "stage.toml", "--output", "run", "--force"]));
        let from = said.find("\n  mass ").unwrap();
        let line = &said[from..from + said[from..].find("\nEvidence").unwrap()];
        line.split_whitespace().skip(1).collect::<Vec<_>>().join(" ")
    };
    let [run, burn] = ["duration = \"60 s\"", "until = \"45 s\""];
    let jet = "d(I ω)/dt + ω × I ω = N − Σ µ ρ × (ω × ρ)";
    assert_eq!(line(&[]), format!("425 → 150 kg, through an exit, with jet damping, and dropped; {jet}"));
    let early = line(&[(run, "duration = \"45 s\"")]);
    assert_eq!(early, format!("425 → 175 kg, through an exit, with jet damping; {jet}"));
    let late = (burn, "from = \"65 s\"\nuntil = \"70 s\"");
    let drop = ("time = \"50 s\"", "time = \"71 s\"");
    assert_eq!(line(&[late]), "425 → 400 kg, dropped; d(I ω)/dt + ω × I ω = N");
    assert_eq!(line(&[late, drop]), "425 kg; nothing of its history is in this time");
}

/// Returns the moment of inertia about the spin axis of the parts that do not burn: a solid
/// cylinder, and a thin tube with or without end caps, as the scenario says.
fn payload_and_case() -> f64 {
    let scratch = Scratch::new("mass-history-rest");
    let text = std::fs::read_to_string(example("spinning-stage.toml")).unwrap();
    let from = text.find("[[body.part]]\nname = \"propellant\"").unwrap();
    scratch.write("rest.toml", &text[..from]);
    number(&json(&scratch.run(&["inertia", "rest.toml", "--json"]))["inertia"]["tensor"][2][2])
}
