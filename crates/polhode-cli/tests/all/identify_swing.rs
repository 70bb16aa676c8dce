//! `polhode identify` of swing tests.

use serde_json::Value;

use crate::common::{Scratch, example, json, number, refused, stdout};

/// As fixtures/identify_bifilar.py has it.
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
    // what is known of the tensor is worth saying: a percent
    let moments = found["principal"]["moments"].as_array().unwrap();
    for (moment, sd) in moments.iter().zip(found["principal"]["moment_sd"].as_array().unwrap()) {
        assert!(number(sd) < 0.01 * number(moment), "{moment} {sd}");
    }
    let z = &found["tests"][2];
    assert_eq!(z["name"], "about z");
    let izz = all.iter().find(|one| one["name"] == "Izz").unwrap();
    assert!((number(&z["moment"]["value"]) - number(&izz["value"])).abs() < 1e-12);
    assert_eq!(found["residuals"]["is_too_large"], false);
    assert_eq!(found["findings"], Value::Array(Vec::new()));
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
    assert!(text.contains("only one axis was swung") && text.contains("need the whole tensor"), "{text}");
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
    // lighter than air
    scratch.write("plan.toml", &ONE_AXIS.replace("up = ", "air = { displaced = \"3 kg\" }\nup = "));
    let text = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(text.contains("plan.toml") && text.contains("buoyancy is -9.8"), "{text}");
    scratch.write("plan.toml", &ONE_AXIS.replace("radius = \"15 cm\"", "radius = \"r\""));
    let text = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(text.contains("plan.toml:9:10") && text.contains("[swing.numbers] has none"), "{text}");
}
