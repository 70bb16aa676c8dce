//! `polhode identify` for swing tests.

use crate::common::{Scratch, example, json, number, refused, stdout};

/// True values from fixtures/identify_bifilar.py.
const TRUTH: [(&str, f64); 12] = [
    ("mass", 3.2),
    ("center x", 0.0041),
    ("center y", -0.0026),
    ("center z", 0.0033),
    ("Ixx", 0.0312),
    ("Iyy", 0.0458),
    ("Izz", 0.0561),
    ("Ixy", -0.0035),
    ("Ixz", 0.0021),
    ("Iyz", 0.0027),
    ("radius", 0.2004),
    ("length", 1.4987),
];

#[test]
fn the_example_holds_the_truth() {
    let scratch = Scratch::new("identify-bifilar");
    let found = json(&scratch.run(&["identify", &example("identify/bifilar.toml"), "--json", "--strict"]));
    assert_eq!(found["kind"], "swing");
    let all = found["estimate"]["numbers"].as_array().unwrap();
    for (name, truth) in TRUTH {
        let one = all.iter().find(|one| one["name"] == name).unwrap();
        let (value, sd) = (number(&one["value"]), number(&one["sd"]));
        assert!(sd > 0.0 && (value - truth).abs() < 4.0 * sd, "{name}: {value} ± {sd}, {truth}");
    }
    // The tensor is determined to about a percent.
    let moments = found["principal"]["moments"].as_array().unwrap();
    for (moment, sd) in moments.iter().zip(found["principal"]["moment_sd"].as_array().unwrap()) {
        assert!(number(sd) < 0.01 * number(moment), "{moment} {sd}");
    }
    let z = &found["tests"][2];
    assert_eq!(z["name"], "about z");
    let izz = all.iter().find(|one| one["name"] == "Izz").unwrap();
    assert!((number(&z["moment"]["value"]) - number(&izz["value"])).abs() < 1e-12);
    assert_eq!(found["residuals"]["is_too_large"], false);
    // One degree of freedom remains to check seven tests.
    let codes: Vec<_> =
        found["findings"].as_array().unwrap().iter().map(|finding| &finding["code"]).collect();
    assert_eq!(codes, ["identify.unchecked"]);
}

const ONE_AXIS: &str = r#"[swing]
mass = "2 kg"
center = [0, 0, 0]
[[swing.test]]
name = "about z"
rig = "bifilar"
up = [0, 0, 1]
across = [1, 0, 0]
radius = "15 cm"
length = { value = "1.2 m", sd = "1 mm" }
counted = { swings = 50, time = "103.2 s", sd = "0.2 s", amplitude = ["18 deg", "15 deg"], amplitude_sd = "0.3 deg" }
"#;

#[test]
fn one_axis_says_nothing_of_the_others() {
    let scratch = Scratch::new("identify-one-axis");
    scratch.write("plan.toml", ONE_AXIS);
    let text = stdout(&scratch.run(&["identify", "plan.toml"]));
    assert!(
        text.contains("only the moment about one axis was measured")
            && text.contains("need the complete tensor"),
        "{text}"
    );
    assert!(text.contains("about z: length"), "{text}");
    let found = json(&scratch.run(&["identify", "plan.toml", "--json"]));
    assert!(found["principal"].is_null());
    assert_eq!(found["estimate"]["unknown"].as_array().unwrap().len(), 5);
    assert!(number(&found["tests"][0]["moment"]["sd"]) > 0.0);
    let page = stdout(&scratch.run(&["identify", "plan.toml", "--html"]));
    assert!(page.starts_with("<!") && page.contains("about z"), "{page}");
}

#[test]
fn what_cannot_be_is_refused() {
    let scratch = Scratch::new("identify-no-swing");
    // Lighter than air.
    scratch.write("plan.toml", &ONE_AXIS.replace("up = ", "air = { displaced = \"3 kg\" }\nup = "));
    let text = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(text.contains("plan.toml") && text.contains("buoyancy is -9.8"), "{text}");
    scratch.write("plan.toml", &ONE_AXIS.replace("radius = \"15 cm\"", "radius = \"r\""));
    let text = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(text.contains("plan.toml:9:10") && text.contains("[swing.numbers] has none"), "{text}");
}

#[test]
fn an_amplitude_that_grows_is_refused() {
    let scratch = Scratch::new("identify-growing");
    let plan = std::fs::read_to_string(example("identify/bifilar.toml")).unwrap();
    let reversed = "amplitude = [\"14.7 deg\", \"11.4 deg\"]";
    assert!(plan.contains(reversed));
    scratch.write("plan.toml", &plan.replace(reversed, "amplitude = [\"11.4 deg\", \"14.7 deg\"]"));
    let text = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(text.contains("viscous damping of “about y”") && text.contains("does not grow"), "{text}");
    assert!(text.contains("largest first"), "{text}");
}

#[test]
fn swings_are_counted_in_whole_numbers() {
    let scratch = Scratch::new("identify-count");
    let plan = std::fs::read_to_string(example("identify/bifilar.toml")).unwrap();
    scratch.write("plan.toml", &plan.replacen("swings = 40", "swings = 2.5", 1));
    let text = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(text.contains("plan.toml:28:") && text.contains("a whole number of swings"), "{text}");
    let amplitudes =
        "amplitude = [{ after = 0.3, value = \"14.8 deg\" }, { after = 40, value = \"12.1 deg\" }]";
    scratch.write("plan.toml", &plan.replacen("amplitude = [\"14.8 deg\", \"12.1 deg\"]", amplitudes, 1));
    let text = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(text.contains("plan.toml:28:") && text.contains("whole or half swings"), "{text}");
}

#[test]
fn logs_of_a_rod_on_an_edge_hold_the_truth() {
    let scratch = Scratch::new("identify-rod-logs");
    let plan = example("identify/rod-logs.toml");
    let found = json(&scratch.run(&["identify", &plan, "--json", "--strict"]));
    // True values from fixtures/identify_swing_log.py.
    let all = found["estimate"]["numbers"].as_array().unwrap();
    for (name, truth, small) in [("Izz", 4.31e-3, 1e-5), ("center y", 0.0817, 1e-4)] {
        let one = all.iter().find(|one| one["name"] == name).unwrap();
        let (value, sd) = (number(&one["value"]), number(&one["sd"]));
        assert!((value - truth).abs() < 4.0 * sd && sd < small, "{name}: {value} ± {sd}, {truth}");
    }
    let text = stdout(&scratch.run(&["identify", &plan]));
    assert!(text.contains("rod-rate.csv: temperature_C.") && text.contains("rate: rate_rad_s"), "{text}");
}

const BIFILAR: [&str; 14] = [
    "identify",
    "--bifilar",
    "--mass",
    "2 kg ± 1 g",
    "--distance",
    "30 cm",
    "--length",
    "1.2 m +- 1 mm",
    "--swings",
    "50",
    "--time",
    "103.2 s ± 0.2 s",
    "--amplitude",
    "18 deg, 15 deg ± 0.3 deg",
];

#[test]
fn swings_about_one_axis_need_no_plan() {
    let scratch = Scratch::new("identify-flags");
    let found = json(&scratch.run(&[&BIFILAR[..], &["--json"]].concat()));
    let z = &found["tests"][0]["moment"];
    // m g r² T²/(4π² L), for small amplitudes.
    let period = 103.2 / 50.0;
    let small = 2.0 * 9.80665 * 0.15 * 0.15 * (period / std::f64::consts::TAU).powi(2) / 1.2;
    assert!((number(&z["value"]) / small - 1.0).abs() < 0.02 && number(&z["sd"]) > 0.0, "{z} {small}");
    // The printed plan gives the same result.
    scratch.write("plan.toml", &stdout(&scratch.run(&[&BIFILAR[..], &["--print-plan"]].concat())));
    let same = json(&scratch.run(&["identify", "plan.toml", "--json"]));
    assert_eq!(same, found);
    // Three wires at this mutual distance are closer to the middle than two.
    let three: Vec<&str> =
        BIFILAR.iter().map(|a| if *a == "--bifilar" { "--trifilar" } else { *a }).collect();
    let three = json(&scratch.run(&[&three[..], &["--json"]].concat()));
    let ratio = number(&three["tests"][0]["moment"]["value"]) / number(&z["value"]);
    assert!((ratio - 4.0 / 3.0).abs() < 0.01, "{ratio}");

    let pendulum =
        ["identify", "--pendulum", "--mass", "742 g", "--distance", "81.7 mm +- 0.2 mm", "--swings", "50"];
    let rest = ["--time", "52.2 s +- 0.1 s", "--amplitude", "8 deg +- 1 deg", "--json"];
    let found = json(&scratch.run(&[&pendulum[..], &rest[..]].concat()));
    let hung = 0.742 * 0.0817 * (9.80665 * (52.2_f64 / 50.0 / std::f64::consts::TAU).powi(2) - 0.0817);
    let moment = number(&found["tests"][0]["moment"]["value"]);
    assert!((moment / hung - 1.0).abs() < 0.01, "{moment} {hung}");
}

#[test]
fn flags_that_say_too_little_or_too_much_are_refused() {
    let scratch = Scratch::new("identify-no-flags");
    let without = |flag: &str| -> Vec<&str> {
        let at = BIFILAR.iter().position(|a| *a == flag).unwrap();
        BIFILAR.iter().enumerate().filter(|(k, _)| !(at..at + 2).contains(k)).map(|(_, a)| *a).collect()
    };
    for flag in ["--mass", "--distance", "--length", "--swings", "--time", "--amplitude"] {
        let text = refused(&scratch.run(&without(flag)), 2);
        assert!(
            text.contains(&format!("--bifilar needs {flag}")) && text.contains("hint: for example"),
            "{text}"
        );
    }
    let instead = |from: &str, to: &'static str| -> Vec<&str> {
        BIFILAR.iter().map(|a| if *a == from { to } else { *a }).collect()
    };
    for (from, to, says) in [
        ("103.2 s ± 0.2 s", "103.2 s", "--time needs a standard deviation"),
        ("103.2 s ± 0.2 s", "103.2 s ± 0.2", "each with its unit"),
        ("103.2 s ± 0.2 s", "103.2 s ± 0.2 m", "a length where a time belongs"),
        ("50", "fifty", "must be a positive number"),
        ("18 deg, 15 deg ± 0.3 deg", "18 deg, 17 deg, 15 deg ± 0.3 deg", "takes one angle, or two"),
        ("2 kg ± 1 g", "2 kgg", "unknown unit"),
        ("--bifilar", "--pendulum", "but --pendulum has none"),
    ] {
        let text = refused(&scratch.run(&instead(from, to)), 2);
        assert!(text.contains(says), "{to}: {text}");
    }
    let text = refused(&scratch.run(&["identify"]), 2);
    assert!(text.contains("no measurement is specified") && text.contains("--pendulum"), "{text}");
}

#[test]
fn gravity_that_is_not_of_this_planet_is_named() {
    let scratch = Scratch::new("gravity");
    let named = |gravity: &str, time: &str| {
        let swings = ["identify", "--pendulum", "--mass", "742 g", "--distance", "8.2 cm", "--swings", "50"];
        let measured = ["--time", time, "--amplitude", "8 deg +- 1 deg", "--gravity", gravity, "--json"];
        stdout(&scratch.run(&[&swings[..], &measured].concat())).contains("identify.gravity")
    };
    assert!(!named("9.81 m/s^2", "41.2 s +- 0.1 s"));
    assert!(named("1.62 m/s^2", "101.4 s +- 0.1 s"));
}

#[test]
fn an_amplitude_that_grows_is_reported_and_absurd_numbers_are_refused_where_they_are() {
    let scratch = Scratch::new("identify-grows");
    let with = |from: &str, to: &str| {
        assert!(ONE_AXIS.contains(from));
        scratch.write("plan.toml", &ONE_AXIS.replace(from, to));
        scratch.run(&["identify", "plan.toml", "--json"])
    };
    // ln(17/15.3) = 0.105 ± 0.026.
    let found = json(&with("[\"18 deg\", \"15 deg\"]", "[\"15.3 deg\", \"17 deg\"]"));
    let findings = found["findings"].as_array().unwrap();
    let grows = findings.iter().find(|finding| finding["code"] == "identify.growing").unwrap();
    let message = grows["message"].as_str().unwrap();
    assert!(
        message.contains("viscous damping of “about z” is -")
            && message.contains("standard deviations below zero")
    );
    let swings = refused(&with("swings = 50", "swings = 1e300"), 2);
    assert!(swings.contains("plan.toml:11:") && swings.contains("up to a billion"), "{swings}");
    let length = refused(&with("\"1.2 m\"", "\"1e300 m\""), 2);
    assert!(length.contains("plan.toml:10:") && length.contains("at most 1e12"), "{length}");
}
