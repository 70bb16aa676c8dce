//! Stages of several layers, in text, binary and packages, compared with OpenUSD's
//! `ComputeMassProperties`. `tests/usd/stages.py` writes them. `POLHODE_USD_STAGES` names another
//! folder with such stages.

use std::path::{Path, PathBuf};

use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::model::RobotModel;
use polhode_robot::read::{ReadOptions, read_model};
use serde_json::Value;

/// Tolerance, relative to the mass, to the largest moment, and to the size of the robot: OpenUSD
/// computes in single precision, and rounds moments about a common centre.
const SINGLE: f64 = 3e-5;

pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/usd/kinds")
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let all: Vec<f64> = value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    all.try_into().unwrap()
}

/// Returns the number of bodies that were compared.
fn compared(model: &RobotModel, bodies: &serde_json::Map<String, Value>, file: &str) -> usize {
    let mut names: Vec<_> = model.links.iter().map(|link| link.name.text.as_str()).collect();
    let mut expected: Vec<_> = bodies.keys().map(String::as_str).collect();
    names.sort_unstable();
    expected.sort_unstable();
    assert_eq!(names, expected, "{file}");
    let mut count = 0;
    for link in &model.links {
        let truth = &bodies[&link.name.text];
        if truth.is_null() {
            continue;
        }
        let place = format!("{file} {}", link.name.text);
        let body = match link_mass(model.format, link) {
            Ok(LinkMass::Body(body)) => body.properties,
            other => panic!("{place}: {other:?}"),
        };
        let mass = truth["mass"].as_f64().unwrap();
        assert!((body.mass() / mass - 1.0).abs() < SINGLE, "{place}: mass {} and {mass}", body.mass());
        let center = numbers::<3>(&truth["center"]);
        let off = body
            .center_of_mass()
            .to_array()
            .iter()
            .zip(center)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        assert!(off < SINGLE, "{place}: centre {:?} and {center:?}", body.center_of_mass());
        let own = body.inertia().matrix();
        let own = [own[0][0], own[1][1], own[2][2], own[0][1], own[0][2], own[1][2]];
        let tensor = numbers::<6>(&truth["tensor"]);
        let scale = tensor[..3].iter().fold(0.0_f64, |most, moment| most.max(*moment));
        let off = own.iter().zip(tensor).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < SINGLE * scale, "{place}: tensor {own:?} and {tensor:?}");
        count += 1;
    }
    count
}

#[test]
fn composed_stages_have_the_masses_of_openusd() {
    let folder = std::env::var_os("POLHODE_USD_STAGES").map_or_else(folder, PathBuf::from);
    let truth = std::fs::read_to_string(folder.join("truth.json")).unwrap();
    let stages: Vec<Value> = serde_json::from_str(&truth).unwrap();
    let (mut count, mut wrong) = (0, Vec::new());
    for stage in &stages {
        let file = stage["file"].as_str().unwrap();
        let model = read_model(&folder.join(file), &ReadOptions::default()).unwrap();
        let bodies = stage["bodies"].as_object().unwrap();
        match std::panic::catch_unwind(|| compared(&model, bodies, file)) {
            Ok(some) => count += some,
            Err(error) => wrong.push(error.downcast_ref::<String>().cloned().unwrap_or_default()),
        }
    }
    assert!(wrong.is_empty(), "{} of {} stages: {}", wrong.len(), stages.len(), wrong.join("\n"));
    assert!(count >= 2 * stages.len(), "{count} bodies of {} stages", stages.len());
}
