//! Motions have the bits of a direct simulation, and edits change only their value.

use std::sync::atomic::{AtomicU32, Ordering};

use polhode::body::PrincipalFrame;
use polhode_scenario::read::ScenarioFile;
use polhode_source::files::Memory;
use polhode_web::Watch;
use serde_json::{Value, json};

use crate::session::{Session, motion};

/// Scenario at a generic point: two parts, products of inertia, an offset centre, and a torque.
const TEXT: &str = "\
# A bracket with a pin.
[[body.part]]
name = \"bracket\"
shape = \"box\"
size = [\"0.3 m\", \"0.21 m\", \"0.12 m\"]
position = [0.02, -0.05, 0.03]
rotate = { axis = [1, -2, 3], angle = \"40 deg\" }
mass = \"2.7 kg\" # of aluminium

[[body.part]]
name = \"pin\"
shape = \"cylinder\"
radius = \"15 mm\"
length = \"0.25 m\"
position = [-0.11, 0.04, 0.08]
mass = \"0.6 kg\"

[[torque]]
model = \"energy_sink\"
coefficient = \"0.9 /(N m s)\"

[start]
spin = { body = [\"0.4 rad/s\", \"-2.1 rad/s\", \"1.3 rad/s\"] }

[run]
duration = \"9 s\"
samples = 37
";

fn session() -> Session {
    let mut session = Session::default();
    let info = session.open("bracket.toml", TEXT.as_bytes());
    let stamp = &info["stamp"];
    assert_eq!(
        info,
        json!({ "id": 0, "name": "bracket.toml", "kind": "scenario", "mesh": false, "stamp": stamp })
    );
    session
}

#[test]
fn a_motion_has_the_bits_of_a_direct_simulation() {
    let session = session();
    let text = session.ask(&json!({ "document": { "id": 0 } })).json["text"].clone();
    let edit = json!([{ "set": "body.part[1].mass", "value": "\"0.8 kg\"" }]);
    for edits in [json!([]), edit] {
        let answer = session.motion(text.as_str().unwrap(), &edits);
        assert_eq!((&answer.json["errors"], &answer.json["took"]), (&json!([]), &json!(0.0)));
        let changed = answer.json["text"].as_str().unwrap();
        let file = ScenarioFile::parse(&Memory::default(), changed.to_owned(), "direct.toml".as_ref());
        let trajectory = file.unwrap().scenario.simulate().unwrap().unwrap();
        let samples = trajectory.samples();
        assert_eq!(samples.len(), 37);
        let shown = &answer.json["motion"]["page"]["motion"];
        let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        for (key, direct) in [
            ("times", samples.iter().map(|s| s.state.time).collect::<Vec<_>>()),
            ("attitude", samples.iter().flat_map(|s| s.state.attitude.quaternion()).collect()),
            ("omega", samples.iter().flat_map(|s| s.state.omega.to_array()).collect()),
            ("momentum", samples.iter().flat_map(|s| s.momentum.to_array()).collect()),
        ] {
            assert_eq!(bits(answer.f64s(&shown[key])), bits(direct), "{key}");
        }
    }
}

#[test]
fn an_edit_changes_its_value_and_nothing_else() {
    let session = session();
    let edits = json!([{ "set": "body.part[0].mass", "value": "\"3.1 kg\"" }]);
    let answer = session.motion(TEXT, &edits).json;
    assert_eq!(answer["text"], TEXT.replace("2.7 kg", "3.1 kg"));
    let knob = |key: &str| {
        let knobs = answer["knobs"].as_array().unwrap();
        knobs.iter().find(|knob| knob["key"] == key).unwrap().clone()
    };
    let mass = knob("body.part[0].mass");
    assert_eq!(
        (&mass["value"], &mass["unit"], &mass["label"]),
        (&json!(3.1), &json!("kg"), &json!("bracket: mass"))
    );
    assert_eq!(answer["switches"], json!([{ "key": "torque[0].on", "label": "energy sink", "on": true }]));
    let moments = [0.012, 0.019, 0.023];
    let answer = session.motion(TEXT, &json!([{ "moments": moments }])).json;
    let text = answer["text"].as_str().unwrap().to_owned();
    let file = ScenarioFile::parse(&Memory::default(), text, "moments.toml".as_ref()).unwrap();
    let body = file.scenario.body();
    assert_eq!(body.mass(), 2.7 + 0.6);
    for (found, wanted) in PrincipalFrame::of(body.inertia()).moments().into_iter().zip(moments) {
        assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
    }
    let refused = session.motion(TEXT, &json!([{ "set": "body.part[2].mass", "value": "1" }])).json;
    assert_eq!(refused["errors"][0]["message"], "the scenario has no body.part[2].mass");
    assert_eq!(refused["text"], TEXT);
}

/// Watch of a caller with a clock, which here counts calls.
#[derive(Default)]
struct Clock {
    calls: AtomicU32,
    most: u32,
}

impl Watch for Clock {
    fn goes_on(&self) -> bool {
        self.calls.fetch_add(1, Ordering::Relaxed) < self.most
    }

    fn is_wanted(&self) -> bool {
        true
    }
}

#[test]
fn a_motion_that_takes_too_long_is_reported_with_its_knobs() {
    let session = session();
    let clock = Clock { most: 5, ..Clock::default() };
    let answer = session.ask_watched(&motion(TEXT, &json!([])), &clock).json;
    let message = answer["errors"][0]["message"].as_str().unwrap();
    assert!(
        message.starts_with("the motion takes more than 20 s to compute: it was stopped at t = "),
        "{message}"
    );
    assert_eq!(answer["motion"], Value::Null);
    assert_eq!(
        answer["knobs"].as_array().unwrap().len(),
        session.motion(TEXT, &json!([])).json["knobs"].as_array().unwrap().len()
    );
}
