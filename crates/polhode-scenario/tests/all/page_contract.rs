//! The keys of a page's data equal those of `viewer/src/data.ts`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use polhode::body::shape::{
    Capsule, Cone, ConeShell, CylinderShell, Disk, Plate, Torus, TriangularPlate, TriangularPrism,
};
use polhode::motion::Orbit;
use polhode::prelude::*;
use serde_json::Value;

use crate::page::{data, html_of, potato};

/// Returns the fields of each interface of `viewer/src/data.ts`, and of each `kind` of its unions.
fn contract() -> BTreeMap<String, BTreeSet<String>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../viewer/src/data.ts");
    let source = std::fs::read_to_string(path).unwrap();
    // Without comments, only names, braces and types remain.
    let mut code = String::new();
    let mut rest = source.as_str();
    while let Some((before, after)) = rest.split_once("/*") {
        code.push_str(before);
        rest = after.split_once("*/").unwrap().1;
    }
    code.push_str(rest);
    let mut found = BTreeMap::new();
    let mut open: Vec<(String, BTreeSet<String>)> = Vec::new();
    let mut word = String::new();
    let mut last = String::new();
    for c in code.chars() {
        match c {
            c if c.is_alphanumeric() || c == '"' => word.push(c),
            _ => {
                if !word.is_empty() {
                    let previous = std::mem::replace(&mut last, std::mem::take(&mut word));
                    if let (Some((name, _)), true) = (open.last_mut(), previous == "kind") {
                        *name = last.trim_matches('"').to_owned();
                    }
                }
                match c {
                    '{' => open.push((last.clone(), BTreeSet::new())),
                    '}' => {
                        let (name, fields) = open.pop().unwrap();
                        found.insert(name, fields);
                    }
                    ':' => {
                        if let Some((_, fields)) = open.last_mut() {
                            fields.insert(last.clone());
                        }
                    }
                    _ => {}
                }
            }
        }
    }
    found
}

#[test]
fn keys_are_those_of_the_contract() {
    let contract = contract();
    let agree = |name: &str, value: &Value, inherited: &[&str]| {
        let mut wanted = contract.get(name).unwrap_or_else(|| panic!("{name} is not in data.ts")).clone();
        wanted.extend(inherited.iter().map(|field| (*field).to_owned()));
        let found: BTreeSet<String> = value.as_object().unwrap().keys().cloned().collect();
        assert_eq!(found, wanted, "{name}");
    };
    let mut kinds = BTreeSet::new();
    let mut orbits = 0;
    let mesh = ClosedMesh::of(&potato(4)).unwrap();
    let one = |kind: &'static str, shape: &dyn Shape| {
        crate::common::solid(kind, kind, shape, 1.5, [0.1, 0.2, 0.3], 0.5)
    };
    let mut all = crate::common::all();
    let every = crate::common::scenario(
        "Every shape",
        vec![
            one("box", &BoxShape::new([1.0, 2.0, 3.0]).unwrap()),
            one("sphere", &Sphere::new(1.0).unwrap()),
            one("cylinder", &CylinderShell::new(1.0, 2.0, false).unwrap()),
            one("capsule", &Capsule::new(1.0, 2.0).unwrap()),
            one("cone", &Cone::new(1.0, 0.0, 2.0).unwrap()),
            one("cylinder", &Cylinder::hollow(1.0, 0.7, 2.0).unwrap()),
            one("sphere", &Sphere::hollow(1.0, 0.7).unwrap()),
            one("cone_shell", &ConeShell::new(1.0, 0.3, 2.0, false).unwrap()),
            one("cone_shell", &ConeShell::new(1.0, 0.0, 2.0, true).unwrap()),
            one("triangular_plate", &TriangularPlate::new([[0.1, 0.2], [1.1, 0.0], [0.3, 0.9]]).unwrap()),
            one(
                "triangular_prism",
                &TriangularPrism::new([[0.1, 0.2], [1.1, 0.0], [0.3, 0.9]], 0.8).unwrap(),
            ),
            one("torus", &Torus::new(1.0, 0.2).unwrap()),
            one("rod", &Rod::new(1.0).unwrap()),
            one("disk", &Disk::new(1.0).unwrap()),
            one("plate", &Plate::new([1.0, 2.0]).unwrap()),
            one("mesh", &mesh),
            crate::common::particles(&[(1.0, [0.0; 3]), (2.0, [1.0, 0.0, 0.0])]),
        ],
    );
    let every = crate::common::spinning(every, AngularVelocity::new(0.1, 0.2, 0.3));
    all.push(every.sampled(crate::common::run(1.0, 3)));
    all.extend([crate::common::gyrostat(), crate::page_scene::top(7.0), crate::page_contact::egg()]);
    all.push(crate::page_gimbals::gyroscope());
    let orbit = Orbit::circular(3e14, 7e6, Direction::new(0.6, 0.8, 0.0), Direction::new(0.0, 0.1, 1.0));
    all.push(crate::common::thruster().in_orbit(orbit.unwrap()).unwrap());
    for scenario in all {
        let Some(Ok(trajectory)) = scenario.simulate() else { continue };
        let data = data(&html_of(&scenario, &trajectory, ""));
        agree("PageData", &data, &["findings"]);
        agree("BodyData", &data["body"], &[]);
        agree("principal", &data["body"]["principal"], &[]);
        agree("EquivalentEllipsoid", &data["body"]["ellipsoid"], &[]);
        agree("EquivalentBox", &data["body"]["box"], &[]);
        agree("MotionData", &data["motion"], &[]);
        if !data["free"].is_null() {
            agree("FreeData", &data["free"], &[]);
            agree("cones", &data["free"]["cones"], &[]);
        }
        agree("SceneData", &data["scene"], &[]);
        agree("captions", &data["scene"]["captions"], &[]);
        if !data["scene"]["orbit"].is_null() {
            agree("OrbitData", &data["scene"]["orbit"], &[]);
            orbits += 1;
        }
        for line in data["motion"]["drift"].as_array().unwrap() {
            agree("drift", line, &[]);
        }
        if !data["motion"]["work"].is_null() {
            agree("work", &data["motion"]["work"], &[]);
        }
        for line in data["motion"]["pointings"].as_array().unwrap() {
            agree("pointings", line, &[]);
        }
        for line in data["motion"]["directions"].as_array().unwrap() {
            agree("directions", line, &[]);
        }
        let contact = &data["motion"]["contact"];
        if !contact.is_null() {
            agree("ContactData", contact, &[]);
            agree("GroundData", &contact["ground"], &[]);
            contact["phases"].as_array().unwrap().iter().for_each(|phase| agree("phases", phase, &[]));
        }
        if !data["top"].is_null() {
            agree("TopData", &data["top"], &[]);
        }
        for (key, list) in [("wheels", &data["motion"]["wheels"]), ("events", &data["motion"]["events"])] {
            list.as_array().unwrap().iter().for_each(|one| agree(key, one, &[]));
        }
        for group in data["facts"].as_array().unwrap() {
            agree("FactGroup", group, &[]);
            group["rows"].as_array().unwrap().iter().for_each(|row| agree("rows", row, &[]));
        }
        data["findings"].as_array().unwrap().iter().for_each(|finding| agree("findings", finding, &[]));
        for shape in data["body"]["shapes"].as_array().unwrap() {
            let kind = shape["kind"].as_str().unwrap();
            agree(kind, shape, &["name", "position", "quaternion"]);
            kinds.insert(kind.to_owned());
        }
        for block in data["explanation"].as_array().unwrap() {
            let kind = block["kind"].as_str().unwrap();
            agree(kind, block, &[]);
            kinds.insert(kind.to_owned());
        }
    }
    assert_eq!(orbits, 1);
    let shown: Vec<&str> = kinds.iter().map(String::as_str).collect();
    let every = [
        "balls",
        "box",
        "capsule",
        "cone",
        "cylinder",
        "ellipsoid",
        "formula",
        "heading",
        "lines",
        "mesh",
        "picture",
        "table",
        "text",
        "torus",
    ];
    assert_eq!(shown, every);
}
