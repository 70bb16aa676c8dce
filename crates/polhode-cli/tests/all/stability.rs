//! `polhode stability` from the user's side.

use crate::common::{Scratch, example, json, number, refused, stdout};

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
    let answer = "Spins about axes 1 and 3 are stable; about axis 2 unstable (e-folding time 0.2445 s).\n\
                  With dissipation inside, every other spin ends in the flat spin about axis 3, at 4.545 rad/s.";
    assert_eq!(text.lines().skip(1).take(2).collect::<Vec<_>>().join("\n"), answer);
    let table = "
Steady spins
  axis  ω in body axes         stability                   oscillation period  growth rate
  3     (0, 4.5447, 0) rad/s   stable                      1.44749 s
  2     (0, 0, 6.00002) rad/s  unstable                                        4.08952 /s
  1     (17.4918, 0, 0) rad/s  stable without dissipation  0.515109 s
";
    assert!(text.ends_with(table), "{text}");
    let details = stdout(&scratch.run(&["stability", &example("t-handle.toml"), "-v"]));
    assert!(details.contains("1.77034 mJ") && !text.contains("mJ"), "{details}");
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
    // Away from an equilibrium, the nearest one is found and reported as such.
    scratch.write(
        "away.toml",
        &format!("{ROD}[start]\nattitude = {{ axis = [1, 2, 0], angle = \"25 deg\" }}\n"),
    );
    let text = stdout(&scratch.run(&["stability", "away.toml"]));
    assert!(
        text.contains(
            "The equilibrium nearest to the start, 25° off, is stable (oscillation period 1.795 s)."
        ),
        "{text}"
    );
    // A wheel along the rod splits the frequency into two.
    scratch.write("wheel.toml", &format!("{ROD}[[wheel]]\naxis = [0, 0, 1]\nmomentum = 0.9\n"));
    let answer = json(&scratch.run(&["stability", "wheel.toml", "--json"]));
    let modes = answer["small_oscillations"]["modes"].as_array().unwrap();
    let product = number(&modes[0]["frequency"]) * number(&modes[1]["frequency"]);
    assert!(
        (product / (frequency * frequency) - 1.0).abs() < 1e-9 && answer["wheel_momentum_body"][2] == 0.9
    );
}

/// The intended steady motion of the examples is found, although no start is exactly on it.
#[test]
fn the_steady_motion_that_is_meant_is_found() {
    let scratch = Scratch::new("stability-meant");
    let of = |name: &str| json(&scratch.run(&["stability", &example(name), "--json"]));
    // The satellite rotates with its orbit only to the digits in its file.
    let satellite = &of("gravity-gradient.toml")["small_oscillations"];
    assert_eq!(
        (satellite["equilibrium"].as_str(), satellite["stable"].as_bool()),
        (Some("on_orbit"), Some(true))
    );
    let all = satellite["on_orbit"].as_array().unwrap();
    assert_eq!((all.len(), all.iter().filter(|one| one["stable"] == true).count()), (24, 4));
    let n = number(&satellite["omega_body"][1]);
    assert!((n / 1.10682e-3 - 1.0).abs() < 1e-5, "{n}");
    // √3 k in the orbital plane and 2 across it, for small oscillations, with k close to 1.
    let has = |ratio: f64| {
        let modes = satellite["modes"].as_array().unwrap();
        modes.iter().any(|mode| (number(&mode["frequency"]) / n - ratio).abs() < 0.05)
    };
    assert!(has(3f64.sqrt()) && has(2.0), "{satellite}");
    // Both tops spin with a small nutation.
    let sleeping = &of("sleeping-top.toml")["small_oscillations"];
    assert_eq!(
        (sleeping["top"]["path"].as_str(), sleeping["stable"].as_bool()),
        (Some("sleeping"), Some(true))
    );
    assert!(
        (number(&sleeping["omega_from_start"]) / 2.0 / (std::f64::consts::TAU / 60.0) - 1.0).abs() < 1e-9
    );
    let heavy = &of("heavy-top.toml")["small_oscillations"];
    assert_eq!((heavy["top"]["path"].as_str(), heavy["stable"].as_bool()), (Some("steady_slow"), Some(true)));
    let lean = number(&heavy["top"]["nutation_rad"]).to_degrees();
    assert!(lean > 30.0 && lean < 32.9, "{lean}");
    let text = stdout(&scratch.run(&["stability", &example("heavy-top.toml")]));
    let words = "Steady precession, the slower of two, at 31.42° is stable (oscillation period 97.59 ms).";
    assert!(text.contains(words) && text.contains("above the sleeping-top threshold, 101.9 rad/s"), "{text}");
    assert!(text.contains("  inclination         31.4196°"), "{text}");
    let text = stdout(&scratch.run(&["stability", &example("gravity-gradient.toml")]));
    assert!(
        text.contains("\n4 of 24 attitudes at rest relative to the orbit are stable; fastest growth:"),
        "{text}"
    );
    assert!(
        text.contains("  1, 2, 3                                              4          26.8962°  stable\n"),
        "{text}"
    );
}

#[test]
fn wheels_are_judged_before_and_after_their_motors() {
    let scratch = Scratch::new("stability-motors");
    let answer = json(&scratch.run(&["stability", &example("gyrostat.toml"), "--json"]));
    assert_eq!((number(&answer["judged_at_s"]), number(&answer["wheel_momentum_body"][2])), (0.0, 0.0));
    let [after] = answer["later"].as_array().unwrap().as_slice() else { panic!("{answer}") };
    assert_eq!(number(&after["judged_at_s"]), 25.0);
    assert!((number(&after["wheel_momentum_body"][2]) - 0.3).abs() < 1e-15);
    let text = stdout(&scratch.run(&["stability", &example("gyrostat.toml")]));
    assert!(
        text.contains("\nAt t = 0: 4 of 6 steady spins are stable; fastest growth: e-folding time 3.212 s.")
            && text.contains("\nFrom t = 25 s on: 4 of 6 steady spins are stable;"),
        "{text}"
    );
}

/// Moments 0.2 and 5 kg·m²: τ = 1/(α L² (1/0.2 − 1/5)).
#[test]
fn friction_inside_decides() {
    let scratch = Scratch::new("stability-friction");
    let answer = json(&scratch.run(&["stability", &example("flat-spin.toml"), "--json"]));
    let last = answer["permanent_rotations"].as_array().unwrap().last().unwrap().clone();
    assert_eq!((last["stability"].as_str(), last["with_sink"].as_str()), (Some("stable"), Some("leaves")));
    let l = number(&answer["momentum"]);
    assert!((number(&last["with_sink_rate"]) / (0.002 * l * l * 4.8) - 1.0).abs() < 1e-12, "{last}");
    let text = stdout(&scratch.run(&["stability", &example("flat-spin.toml")]));
    let words = "Spins about axes 2 and 3 are stable; about axis 1 unstable (e-folding time 26.04 s).\nWith its friction inside, \
         every other spin ends in a flat spin, such as about axis 2, at 0.4 rad/s";
    assert!(text.contains(words), "{text}");
    assert!(
        text.contains("stable            0.654473 s          unstable, e-folding time 26.0397 s"),
        "{text}"
    );
}

#[test]
fn modes_of_one_frequency_are_a_plane() {
    let scratch = Scratch::new("stability-plane");
    let text = stdout(&scratch.run(&["stability", &example("magnet.toml")]));
    assert!(text.contains("any in the plane of (1, 0, 0) and (0, 1, 0)"), "{text}");
}

/// A formula that is NaN at the start is reported with its line.
#[test]
fn a_torque_that_is_no_number_is_shown_in_its_line() {
    let scratch = Scratch::new("stability-nan");
    let text = format!(
        "{ROD}[[torque]]\nmodel = \"formula\"\naxes = \"body\"\ntorque = [\"0\", \"1[N m s]/t\", \"0\"]\n[run]\nduration = \"1 s\"\n"
    );
    scratch.write("nan.toml", &text);
    let text = refused(&scratch.run(&["simulate", "nan.toml"]), 2);
    assert!(
        text.contains("torque 2 is not finite at the start") && text.contains("nan.toml:15:16"),
        "{text}"
    );
    assert!(scratch.entries() == ["nan.toml"], "{:?}", scratch.entries());
}

#[test]
fn what_cannot_depart_is_refused() {
    let scratch = Scratch::new("stability-prescribed");
    let text = refused(&scratch.run(&["stability", &example("notes/11-10-dumbbell.toml")]), 2);
    assert!(text.contains("is prescribed") && text.contains("hint:"), "{text}");
    // Without external torques, wheels alone are not a free motion.
    scratch.write(
        "wheel.toml",
        &format!("{ROD}[[wheel]]\naxis = [0, 0, 1]\nmomentum = 0.9\n")
            .replace("[[torque]]\nmodel = \"gravity\"\npivot = [0, 0, 0]\n", ""),
    );
    let text = refused(&scratch.run(&["spin", "wheel.toml"]), 2);
    assert!(text.contains("wheels spin in the body"), "{text}");
}

#[test]
fn the_torque_that_prevents_an_equilibrium_is_named() {
    let scratch = Scratch::new("stability-prevented");
    let torque = |keys: &str| {
        format!("[[torque]]\nmodel = 'constant'\naxes = 'space'\ntorque = [0, 0, 0.1]\n{keys}\n")
    };
    let body = "[[body.part]]\nshape = 'box'\nsize = [0.1, 0.2, 1.1]\nmass = 2\n";
    let gravity = "[[torque]]\nmodel = 'gravity'\npivot = [0, 0, 0.5]\n";
    let text = [body, gravity, &torque("name = 'motor'"), &torque("name = 'later'\nfrom = '4 s'")].concat();
    scratch.write("driven.toml", &text);
    let shown = stdout(&scratch.run(&["stability", "driven.toml"]));
    assert!(shown.contains("No equilibrium near the start: the torque \"motor\" prevents it."), "{shown}");
    assert!(shown.contains("unbalanced          0.1 N·m"), "{shown}");
    assert!(shown.contains("excluded            the torque \"later\", not acting at t = 0 s"), "{shown}");
    let answer = json(&scratch.run(&["stability", "driven.toml", "--json"]));
    assert_eq!(answer["small_oscillations"], serde_json::Value::Null);
    assert_eq!(answer["prevented_by"], serde_json::json!(["motor"]));
    assert_eq!(answer["torques_that_do_not_act"], serde_json::json!(["later"]));
    // √(M g l/I) of the remaining torques, about the axis of 0.7083 kg·m².
    let mode = &answer["small_oscillations_of_the_rest"]["modes"][0];
    let expected = (2.0 * 9.80665 * 0.5 / (2.0 * ((1.1 * 1.1 + 0.04) / 12.0 + 0.25_f64))).sqrt();
    assert!((mode["frequency"].as_f64().unwrap() / expected - 1.0).abs() < 1e-9, "{mode}");
    // Torques without names are identified by number.
    scratch.write("two.toml", &[body, gravity, &torque(""), &torque("from = '4 s'")].concat());
    let two = json(&scratch.run(&["stability", "two.toml", "--json"]));
    assert_eq!(two["prevented_by"], serde_json::json!(["constant, torque 2 of the scenario"]));
    assert_eq!(two["torques_that_do_not_act"], serde_json::json!(["constant, torque 3 of the scenario"]));
    // If it is the only torque, nothing remains.
    scratch.write("alone.toml", &[body, &torque("name = 'motor'")].concat());
    let alone = json(&scratch.run(&["stability", "alone.toml", "--json"]));
    assert_eq!(alone["prevented_by"], serde_json::json!(["motor"]));
    assert_eq!(alone["small_oscillations_of_the_rest"], serde_json::Value::Null);
}
