//! `polhode identify --body`: scenarios of bodies from swing tests and throws.

use serde_json::Value;

use crate::common::{Scratch, example, json, number, numbers, refused, stdout};

/// Returns the principal moments of `polhode inertia` for a file.
fn moments(scratch: &Scratch, file: &str) -> Vec<f64> {
    numbers(&json(&scratch.run(&["inertia", file, "--json"]))["principal"]["moments"])
}

fn near(got: &[f64], want: &[f64]) {
    assert_eq!(got.len(), want.len());
    for (got, want) in got.iter().zip(want) {
        assert!((got / want - 1.0).abs() < 1e-13, "{got} is not {want}");
    }
}

#[test]
fn a_body_that_was_swung_is_a_scenario() {
    let scratch = Scratch::new("identify-body-swing");
    let plan = example("identify/bifilar.toml");
    let report = json(&scratch.run(&["identify", &plan, "--json"]));
    scratch.write("body.toml", &stdout(&scratch.run(&["identify", &plan, "--body"])));
    near(&moments(&scratch, "body.toml"), &numbers(&report["principal"]["moments"]));
    let read = polhode_scenario::read::read(&scratch.0.join("body.toml")).unwrap();
    let of = |name: &str| {
        let all = report["estimate"]["numbers"].as_array().unwrap();
        number(&all.iter().find(|n| n["name"] == name).unwrap()["value"])
    };
    let c = read.body().center_of_mass().to_array();
    near(&[read.body().mass(), c[0], c[1], c[2]], &["mass", "center x", "center y", "center z"].map(of));
    for flag in [["--mass", "3 kg"], ["--greatest-moment", "0.05 kg m^2"]] {
        let error = refused(&scratch.run(&["identify", &plan, "--body", flag[0], flag[1]]), 2);
        assert!(error.contains(&format!("{} has no effect", flag[0])), "{error}");
    }
}

#[test]
fn a_body_that_was_thrown_is_one_of_the_size_that_is_said() {
    let scratch = Scratch::new("identify-body-tumble");
    let plan = example("identify/racket-like.toml");
    let with = |flags: &[&str]| scratch.run(&[&["identify", &plan, "--body"], flags].concat());
    let error = refused(&with(&["--mass", "350 g"]), 2);
    assert!(
        error.contains("only the ratios of the moments") && error.contains("--greatest-moment"),
        "{error}"
    );
    let error = refused(&with(&["--greatest-moment", "0.0166 kg m^2"]), 2);
    assert!(error.contains("does not determine the mass") && error.contains("--mass"), "{error}");
    refused(&with(&["--greatest-moment", "-1 kg m^2", "--mass", "350 g"]), 2);
    let text = stdout(&with(&["--greatest-moment", "0.0166 kg m^2", "--mass", "350 g"]));
    assert!(
        text.contains(
            "# The motion determined the ratios of the moments. The greatest moment, 0.0166 kg m^2"
        ),
        "{text}"
    );
    scratch.write("body.toml", &text);
    let report = json(&scratch.run(&["identify", &plan, "--json"]));
    let ratios = numbers(&report["principal"]["ratios"]);
    near(&moments(&scratch, "body.toml"), &[0.0166 * ratios[0], 0.0166 * ratios[1], 0.0166]);
    // The first flight, from its start.
    let run = scratch.run(&["simulate", "body.toml", "-o", "run"]);
    assert!(run.status.success(), "{run:?}");
    let scenario = polhode_scenario::read::read(&scratch.0.join("body.toml")).unwrap();
    assert!((scenario.body().mass() - 0.35).abs() < 1e-15);
    let flight = &report["flights"][0];
    assert!(text.contains(&format!("# Initial state of {}\n", flight["name"].as_str().unwrap())), "{text}");
    let omega = numbers(&flight["omega"]);
    assert!(
        text.contains(&format!("spin = {{ body = [{:?}, {:?}, {:?}] }}", omega[0], omega[1], omega[2])),
        "{text}"
    );
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
length = "1.2 m"
counted = { swings = 50, time = "103.2 s", sd = "0.1 s", amplitude = ["0.31 rad", "0.26 rad"], amplitude_sd = "5 mrad" }
"#;

#[test]
fn what_is_not_known_is_no_body() {
    let scratch = Scratch::new("identify-body-unknown");
    scratch.write("plan.toml", ONE_AXIS);
    let error = refused(&scratch.run(&["identify", "plan.toml", "--body"]), 2);
    assert!(error.contains("the set of swing tests does not determine it completely"), "{error}");
    let report = json(&scratch.run(&["identify", "plan.toml", "--json"]));
    assert_eq!(report["next"]["now"]["unknown"], 5);
    assert_eq!(report["next"]["candidates"][0]["then"]["unknown"], 4);
    assert_eq!(report["next"]["together"].as_array().unwrap().len(), 5);
    assert_eq!(report["principal"], Value::Null);
    let text = stdout(&scratch.run(&["identify", "plan.toml"]));
    assert!(
        text.contains("5 directions of the body's parameters are unobservable.")
            && text.contains("Together, these experiments make all directions observable: ")
    );
    // The page has no triangle of moments.
    assert!(!stdout(&scratch.run(&["identify", "plan.toml", "--html"])).contains("The triangle of moments"));
}
