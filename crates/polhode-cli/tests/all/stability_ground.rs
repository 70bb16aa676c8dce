//! `polhode stability` for bodies on the ground, from the user's side.

use crate::common::{Scratch, json, number, refused, stdout};

fn scenario(body: &str, contact: &str, start: &str) -> String {
    format!("[[body.part]]\n{body}\n[contact]\n{contact}\n[start]\n{start}\n[run]\nduration = \"1 s\"\n")
}

const COIN: [&str; 2] = [
    "shape = \"tensor\"\nmass = \"8 g\"\nmoments = [\"0.27 g m^2\", \"0.27 g m^2\", \"0.54 g m^2\"]",
    "surface = { shape = \"rim\", radius = \"12 mm\" }\nlaw = \"rolling\"",
];

#[test]
fn a_coin_that_rolls_has_its_threshold() {
    let scratch = Scratch::new("stability-coin");
    let start = |angle: f64, spin: &str| {
        format!("attitude = {{ axis = [1, 0, 0], angle = \"{angle} deg\" }}\nspin = {spin}")
    };
    let [body, contact] = COIN;
    scratch.write("rolls.toml", &scenario(body, contact, &start(88.0, "{ body = [0, 0, \"-9 rad/s\"] }")));
    let answer = json(&scratch.run(&["stability", "rolls.toml", "--json"]));
    let ground = &answer["on_ground"];
    assert_eq!(ground["path"], "rolling_upright");
    assert_eq!(ground["neutral"], ground["neutral_ways"].as_array().unwrap().len());
    let (a, c, weight, r) = (0.27e-3, 0.54e-3, 0.008 * 9.80665, 0.012);
    let threshold = f64::sqrt(a * weight * r / (c * (c + 0.008 * r * r)));
    assert!((number(&ground["threshold"]) / -threshold - 1.0).abs() < 1e-12, "{ground}");
    assert!((number(&ground["margin"]) / (9.0 / threshold - 1.0) - 1.0).abs() < 1e-12, "{ground}");
    assert_eq!(ground["stable"], 9.0 > threshold);
    let text = stdout(&scratch.run(&["stability", "rolls.toml"]));
    let answer = "Rolling straight at 9 rad/s with a level axis is stable (oscillation period 0.3513 s); its spin is\n\
                  865 % above the threshold, 0.9327 rad/s.";
    assert!(text.contains(answer), "{text}");
    assert!(text.contains("stable spins        above 0.9327 rad/s in either sense"), "{text}");
    scratch.write("spins.toml", &scenario(body, contact, &start(89.0, "{ space = [0, 0, \"9 rad/s\"] }")));
    let ground = &json(&scratch.run(&["stability", "spins.toml", "--json"]))["on_ground"];
    assert_eq!(ground["path"], "spinning_upright");
    // Far from both steady motions, the error says where they are.
    scratch.write("far.toml", &scenario(body, contact, &start(45.0, "{ body = [0, 0, \"9 rad/s\"] }")));
    let why = refused(&scratch.run(&["stability", "far.toml"]), 2);
    assert!(
        why.contains("the start is not near a steady motion on") && why.contains("hint: start nearer"),
        "{why}"
    );
    let slowed = format!("{contact}\nrolling_friction = \"0.1 mm\"");
    scratch.write("slows.toml", &scenario(body, &slowed, &start(88.0, "{ body = [0, 0, \"9 rad/s\"] }")));
    let why = refused(&scratch.run(&["stability", "slows.toml"]), 2);
    assert!(why.contains("every motion slows down"), "{why}");
}

#[test]
fn a_tippe_top_has_its_group_and_its_end() {
    let scratch = Scratch::new("stability-tippe-top");
    let body = "shape = \"tensor\"\nmass = \"15 g\"\nmoments = [\"1.9e-6 kg m^2\", \"1.9e-6 kg m^2\", \"2.0e-6 kg m^2\"]";
    let contact = "surface = { shape = \"sphere\", radius = \"18 mm\", position = [0, 0, \"4 mm\"] }\nlaw = \"friction\"\nfriction = 0.3";
    let start = "attitude = { axis = [1, 0, 0], angle = \"6 deg\" }\nspin = { space = [0, 0, \"150 rad/s\"] }\nvelocity = [0, 0, 0]";
    scratch.write("top.toml", &scenario(body, contact, start));
    let ground = &json(&scratch.run(&["stability", "top.toml", "--json"]))["on_ground"];
    let top = &ground["tippe_top"];
    assert_eq!((&ground["path"], &top["group"]), (&"on_vertex".into(), &2.into()));
    let minima: Vec<_> =
        top["end_states"].as_array().unwrap().iter().filter(|end| end["minimum"] == true).collect();
    assert_eq!(minima.len(), 1);
    assert_eq!(minima[0]["place"], "inverted");
    assert!(number(&top["jellett"]) > number(&top["inverted_from"]));
    let text = stdout(&scratch.run(&["stability", "top.toml"]));
    assert!(text.contains("\nSliding friction leads to the inverted position.\n"), "{text}");
}

#[test]
fn a_rattleback_has_its_sense() {
    let scratch = Scratch::new("stability-celt");
    let body = "shape = \"tensor\"\nmass = \"0.8 kg\"\ninertia = [[1.36e-3, -1.02e-3, 0], [-1.02e-3, 7.94e-3, 0], [0, 0, 8.9e-3]]";
    let contact = "surface = { shape = \"ellipsoid\", semi_axes = [\"230 mm\", \"50 mm\", \"40 mm\"] }\nlaw = \"rolling\"";
    for spin in [30, -30] {
        let start = format!("spin = {{ space = [0, 0, \"{spin} rad/s\"] }}");
        scratch.write("celt.toml", &scenario(body, contact, &start));
        let ground = &json(&scratch.run(&["stability", "celt.toml", "--json"]))["on_ground"];
        let rattle = &ground["rattleback"];
        let sense = number(&rattle["stable_sense"]);
        assert!(number(&rattle["threshold"]) < 30.0, "{rattle}");
        assert_eq!(ground["stable"], sense * f64::from(spin) > 0.0, "{ground}");
        let text = stdout(&scratch.run(&["stability", "celt.toml"]));
        assert!(
            text.contains("A rattleback: counter-clockwise spin, seen from above, is stable above"),
            "{text}"
        );
    }
}
