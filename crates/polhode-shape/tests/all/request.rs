//! Requests of `inertia`: every kind of file from memory, and the schemas.

use std::path::{Path, PathBuf};

use polhode_document::Report as _;
use polhode_shape::mesh::MeshFormat;
use polhode_shape::{Bodies, Kind, Request, run};
use polhode_source::Failure;
use polhode_source::files::{Disk, Memory};
use serde_json::{Value, json};

use crate::schema::require_fits;

/// Files of this repository with a list of the extensions of meshes, and what is before and after
/// each.
const LISTS: [(&str, [&str; 2]); 5] = [
    ("crates/polhode-py/python/polhode/_inertia.py", ["\"", "\""]),
    ("viewer/src/live/dropped.ts", ["\"", "\""]),
    ("crates/polhode-web/src/documents.rs", [".", ""]),
    ("book/inertia.md", ["`.", "`"]),
    ("book/live.md", [".", ""]),
];

const REQUEST: &str = polhode_shape::REQUEST_SCHEMA;
const REPORT: &str = polhode_shape::REPORT_SCHEMA;

/// Two tetrahedra with edges (2, 3, 1) m along the axes, the second one displaced by 10 m along x.
const TWO: &str = "\
v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1
g near\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4
v 10 0 0\nv 12 0 0\nv 10 3 0\nv 10 0 1
g far\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8
";

/// CAD report with a mass, with products of the negative convention.
const CAD: &str = "Mass properties of part\nMass = 2.00 kilograms\nCenter of mass: ( meters )\nX = 0.10\nY = 0.20\nZ = 0.30\n";

fn files() -> Memory {
    Memory::from([
        ("two.obj", TWO),
        (
            "points.csv",
            "mass [g], x [mm], y [mm], z [mm]\n1, 0, 0, 0\n2, 10, 0, 0\n3, 0, 20, 0\n4, 0, 0, 30\n",
        ),
        ("water.xyz", "3\nwater\nO 0 0 0\nH 0.757 0.586 0\nH -0.757 0.586 0\n"),
        ("broken.txt", CAD),
        ("a.toml", "title = 1"),
    ])
}

fn answer(request: Value) -> Result<Bodies, Failure> {
    let request: Request = serde_json::from_value(request).unwrap();
    require_fits(REQUEST, &serde_json::to_value(&request).unwrap());
    let bodies = run(&request, &files())?;
    require_fits(REPORT, &bodies.to_json());
    Ok(bodies)
}

#[test]
fn bodies_of_every_kind_fit_the_schema() {
    let mesh = answer(json!({
        "files": ["two.obj"], "part": ["near=250 g"], "mass": "2 kg", "about": "0,0,1", "along": "1,0,0,1",
        "write-mesh": "used.ply", "weld": "1e-9", "fill": "1 mm",
    }));
    let mesh = mesh.unwrap();
    assert_eq!(mesh.to_json()["mass"], 2.25);
    let written = mesh.mesh.unwrap();
    assert_eq!((written.path.as_path(), &written.bytes[..3]), (Path::new("used.ply"), b"ply".as_slice()));
    for request in [
        json!({ "files": ["two.obj"], "field": "1 + x^2", "tolerance": 1e-6 }),
        json!({ "files": ["two.obj"], "close-within": "5%", "weld": "1e-9" }),
        json!({ "files": ["two.obj"], "walls": "5 cm", "top-layers": 0.08, "infill": "15%", "mass": "2 kg" }),
        json!({ "files": ["two.obj"], "shell": 0.001, "density": 2700 }),
        json!({ "files": ["two.obj"], "union": true, "material": "steel" }),
        json!({ "files": ["two.obj", "points.csv", "water.xyz", "missing.stl"] }),
        json!({ "files": ["water.xyz"], "isotopes": "average" }),
        json!({ "files": ["broken.txt", "a.toml"] }),
    ] {
        answer(request.clone()).unwrap_or_else(|failure| panic!("{request}: {failure}"));
    }
}

#[test]
fn what_another_crate_reads_is_refused() {
    let bodies = answer(json!({ "files": ["a.toml"] })).unwrap();
    let failure = bodies.files[0].reports.as_ref().unwrap_err();
    assert_eq!(failure.message(), "a.toml is a scenario, which cannot be read here");
    let several = answer(json!({ "files": ["two.obj", "two.obj"], "write-mesh": "a.stl" }));
    assert!(several.unwrap_err().message().starts_with("--write-mesh writes one mesh"));
}

#[test]
fn the_examples_fit_the_schema() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let meshes = ["bracket.stl", "meshes/bracket.3mf", "meshes/bracket.dae", "meshes/bracket.glb"];
    let others = ["meshes/bracket.obj", "meshes/bracket.off", "meshes/bracket.ply"];
    let molecules = ["water.mol", "water.pdb", "water.xyz"];
    let files: Vec<PathBuf> = [&meshes[..], &others, &molecules]
        .concat()
        .iter()
        .map(|name| root.join("examples").join(name))
        .collect();
    let bodies = run(&Request { files, ..Request::default() }, &Disk).unwrap();
    for file in &bodies.files {
        assert!(file.reports.is_ok(), "{file:?}");
    }
    require_fits(REPORT, &bodies.to_json());
    let golden = root.join("crates/polhode-scenario/tests/all/golden/inertia.json");
    require_fits(REPORT, &serde_json::from_str(&std::fs::read_to_string(golden).unwrap()).unwrap());
}

#[test]
fn requests_fit_the_schema() {
    let full = json!({
        "files": ["a.stl"], "box": "20 cm, 10 cm, 6 cm", "sphere": "1 m", "ellipsoid": "(3, 2, 1) mm", "cylinder": "1 m, 2 m",
        "capsule": "1 m, 2 m", "cone": "1 m, 2 m", "torus": "2 m, 1 m", "rod": "1 m", "disk": "1 m", "density": null, "mass": "85 g", "material": null, "part": ["rod=steel", "grip=85 g"],
        "hull": true, "shell": "1 mm", "field": "2700 - 300*hypot(x, y)", "tolerance": "1e-6", "weld": "0.01 mm",
        "fill": "2 mm", "close-within": "5%", "walls": "1.2 mm", "top-layers": "0.8 mm", "bottom-layers": "0.6 mm", "infill": "15%", "union": true, "write-mesh": "b.stl", "unit": "mm", "mass-unit": "g",
        "isotopes": "average", "products": "negative", "decimal": "comma", "spacing": "1 mm,1 mm,2 mm",
        "origin": "0,0,0", "per-value": "1 g/cm^3", "format": "stl", "about": "0,0,12 mm", "along": "1,0,0,0",
    });
    let default = serde_json::to_value(Request::default()).unwrap();
    for value in [default, full] {
        require_fits(REQUEST, &value);
        let request: Request = serde_json::from_value(value.clone()).unwrap();
        assert_eq!(serde_json::to_value(&request).unwrap(), value);
    }
    let unknown = serde_json::from_value::<Request>(json!({ "files": [], "colour": "red" }));
    assert!(unknown.unwrap_err().to_string().contains("colour"));
    let Err(error) = serde_json::from_value::<Kind>(json!("step")) else { panic!() };
    assert!(error.to_string().contains("nrrd"), "{error}");
}

#[test]
fn every_list_of_mesh_formats_has_all_of_them() {
    let schema: Value = serde_json::from_str(REQUEST).unwrap();
    let kinds = schema["properties"]["format"]["enum"].as_array().unwrap();
    for format in MeshFormat::ALL {
        assert!(kinds.contains(&json!(format.name())), "{} is not in the schema", format.name());
        for (path, [before, after]) in LISTS {
            let text =
                std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path))
                    .unwrap();
            for extension in format.extensions() {
                let written = format!("{before}{extension}{after}");
                assert!(text.contains(&written), "{path} does not have {written}");
            }
        }
    }
}
