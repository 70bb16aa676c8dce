//! `polhode stability` as its users meet it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod common;

use common::{Scratch, example, json, number, refused, stdout};

const ROD: &str = r#"
title = "A rod that hangs, and a wheel in it"
[[body.part]]
shape = "cylinder"
radius = "20 mm"
length = "1.2 m"
mass = "0.8 kg"
position = [0, 0, "-0.6 m"]
[[torque]]
model = "gravity"
pivot = [0, 0, 0]
"#;

#[test]
fn the_t_handle_has_its_unstable_axis() {
    let scratch = Scratch::new("stability");
    let text = stdout(&scratch.run(&["stability", &example("t-handle.toml")]));
    assert_eq!(text.matches("unstable: a departure grows at").count(), 2, "{text}");
    assert_eq!(text.matches("stable: a departure goes round it in").count(), 4, "{text}");
    assert!(!text.contains("small swings"), "{text}");
    let answer = json(&scratch.run(&["stability", &example("t-handle.toml"), "--json"]));
    let names: Vec<_> = answer["permanent_rotations"]
        .as_array()
        .unwrap()
        .iter()
        .map(|r| r["stability"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["stable", "stable", "unstable", "unstable", "stable", "stable"]);
    assert!(answer["small_oscillations"].is_null());
    assert!(scratch.entries().is_empty());
}

#[test]
fn a_hanging_rod_swings_as_a_pendulum_does() {
    let scratch = Scratch::new("stability-rod");
    scratch.write("rod.toml", ROD);
    let answer = json(&scratch.run(&["stability", "rod.toml", "--json"]));
    let small = &answer["small_oscillations"];
    assert_eq!((small["equilibrium"].as_str(), small["neutral"].as_u64()), (Some("start"), Some(2)));
    let moment = 0.8 * (3.0 * 4e-4 + 1.44) / 12.0 + 0.8 * 0.36;
    let frequency = f64::sqrt(0.8 * 9.80665 * 0.6 / moment);
    for mode in small["modes"].as_array().unwrap() {
        assert!((number(&mode["frequency"]) / frequency - 1.0).abs() < 1e-9, "{mode}");
    }
    // Away from the equilibrium the nearest one is found, and said to be so.
    scratch.write(
        "away.toml",
        &format!("{ROD}[start]\nattitude = {{ axis = [1, 2, 0], angle = \"25 deg\" }}\n"),
    );
    let text = stdout(&scratch.run(&["stability", "away.toml"]));
    assert!(text.contains("about the nearest equilibrium, 25° from the start: nothing grows"), "{text}");
    // A wheel along the rod makes two frequencies of the one.
    scratch.write("wheel.toml", &format!("{ROD}[[wheel]]\naxis = [0, 0, 1]\nmomentum = 0.9\n"));
    let answer = json(&scratch.run(&["stability", "wheel.toml", "--json"]));
    let modes = answer["small_oscillations"]["modes"].as_array().unwrap();
    let product = number(&modes[0]["frequency"]) * number(&modes[1]["frequency"]);
    assert!(
        (product / (frequency * frequency) - 1.0).abs() < 1e-9 && answer["wheel_momentum_body"][2] == 0.9
    );
}

#[test]
fn what_cannot_depart_is_refused() {
    let scratch = Scratch::new("stability-prescribed");
    let text = refused(&scratch.run(&["stability", &example("notes/11-10-dumbbell.toml")]), 2);
    assert!(text.contains("is prescribed") && text.contains("hint:"), "{text}");
    // and what only wheels turn is no free motion
    scratch.write(
        "wheel.toml",
        &format!("{ROD}[[wheel]]\naxis = [0, 0, 1]\nmomentum = 0.9\n")
            .replace("[[torque]]\nmodel = \"gravity\"\npivot = [0, 0, 0]\n", ""),
    );
    let text = refused(&scratch.run(&["spin", "wheel.toml"]), 2);
    assert!(text.contains("wheels spin in the body"), "{text}");
}
