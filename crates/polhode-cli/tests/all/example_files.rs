//! Example files of one body in many formats; all give the same result.

use serde_json::Value;

use crate::common::{Scratch, example, json, number, numbers};

/// Returns the JSON of `polhode inertia` for a file in examples/.
fn inertia(scratch: &Scratch, file: &str, flags: &[&str]) -> Value {
    json(&scratch.run(&[&["inertia", &example(file), "--json"], flags].concat()))
}

/// Returns the nine elements of the inertia tensor.
fn tensor(body: &Value) -> Vec<f64> {
    body["inertia"]["tensor"].as_array().unwrap().iter().flat_map(numbers).collect()
}

#[test]
fn the_bracket_is_the_same_in_every_mesh_format() {
    let scratch = Scratch::new("brackets");
    let [density, unit] = [["--density", "2700 kg/m^3"], ["--unit", "mm"]];
    let stl = inertia(&scratch, "bracket.stl", &[density, unit].concat());
    let (mass, center, elements) = (number(&stl["mass"]), numbers(&stl["center_of_mass"]), tensor(&stl));
    assert!(elements.iter().all(|e| e.abs() > 1e-8), "no symmetry hides an exchanged axis: {elements:?}");
    let half_trace = 0.5 * (elements[0] + elements[4] + elements[8]);
    let own = &density.to_vec();
    let given = &[density, unit].concat();
    for (file, flags) in [
        ("bracket.obj", given),
        ("bracket.off", given),
        ("bracket.ply", given),
        ("bracket.glb", own), // metres, by the format
        ("bracket.3mf", own), // millimetres, by the file
        ("bracket.dae", own),
    ] {
        let body = inertia(&scratch, &format!("meshes/{file}"), flags);
        // The coordinates are the same doubles; only the conversion from millimetres to metres
        // happens earlier or later.
        assert!((number(&body["mass"]) / mass - 1.0).abs() < 4e-15, "{file}: {}", body["mass"]);
        for (got, want) in numbers(&body["center_of_mass"]).iter().zip(&center) {
            assert!((got - want).abs() < 4e-17, "{file}: {got} is not {want}");
        }
        for (got, want) in tensor(&body).iter().zip(&elements) {
            assert!((got - want).abs() < 4e-15 * half_trace, "{file}: {got} is not {want}");
        }
        assert_eq!(body["findings"], stl["findings"], "{file}");
    }
}

#[test]
fn water_is_the_same_in_every_molecule_format() {
    let scratch = Scratch::new("waters");
    let xyz = inertia(&scratch, "water.xyz", &[]);
    let constants = |body: &Value| numbers(&body["molecule"]["rotational_constants_ghz"]);
    // A distance of 0.6 Å to the axis, printed in steps of 1e-4 or 1e-3 Å: half a step, doubled
    // because it is squared.
    for (file, digits) in [("water.mol", 2e-4), ("water.pdb", 2e-3)] {
        let body = inertia(&scratch, file, &[]);
        assert_eq!(number(&body["mass"]), number(&xyz["mass"]), "{file}");
        for (got, want) in constants(&body).iter().zip(constants(&xyz)) {
            let error = (got / want - 1.0).abs();
            assert!(error < digits && error > 0.0, "{file}: {got} is not {want}");
        }
    }
}
