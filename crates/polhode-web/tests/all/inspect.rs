//! Inspection of meshes and robots in memory.

use std::fmt::Write as _;

use polhode_source::files::Memory;
use polhode_web::{DroppedSet, Engine, MotionRequest};
use serde_json::json;

use crate::session::Session;

/// Corners of a generic tetrahedron, m.
const CORNERS: [[f64; 3]; 4] = [[0.1, 0.2, -0.1], [1.3, 0.1, 0.2], [0.4, 1.7, 0.3], [0.2, 0.5, 1.9]];

/// Faces, counter-clockwise from outside.
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

/// Returns an OBJ file with some of the faces.
fn obj(faces: &[[usize; 3]]) -> String {
    let mut text = String::new();
    for [x, y, z] in CORNERS {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    for face in faces {
        let [a, b, c] = face.map(|k| k + 1);
        writeln!(text, "f {a} {b} {c}").unwrap();
    }
    text
}

/// Returns the volume of the tetrahedron, m³.
fn volume() -> f64 {
    let [a, b, c] = [1, 2, 3].map(|k| [0, 1, 2].map(|i| CORNERS[k][i] - CORNERS[0][i]));
    let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    (a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]).abs() / 6.0
}

#[test]
fn an_open_mesh_is_shown_with_its_boundary() {
    let mut session = Session::default();
    let info = session.open("open.obj", obj(&FACES[..3]).as_bytes());
    assert_eq!((&info["kind"], &info["mesh"]), (&json!("mesh"), &json!(true)));
    for message in [json!({ "document": { "id": 0 } }), json!({ "mesh": { "id": 0 } })] {
        let answer = session.ask(&message);
        let mesh = &answer.json["mesh"];
        assert_eq!((&answer.json["kind"], &mesh["of"]), (&json!("mesh"), &json!(3)));
        let vertices = answer.f32s(&mesh["vertices"]);
        let triangles = answer.u32s(&mesh["triangles"]);
        let shown = triangles.iter().map(|k| *k as usize).flat_map(|k| vertices[3 * k..][..3].to_vec());
        let in_file = FACES[..3].as_flattened().iter().flat_map(|k| CORNERS[*k].map(|x| x as f32));
        assert_eq!((vertices.len(), shown.collect::<Vec<_>>()), (12, in_file.collect()));
        let open = &mesh["findings"][0];
        assert_eq!((&open["code"], &open["severity"]), (&json!("mesh.open"), &json!("error")));
        // The boundary is that of the missing face 0, 3, 2.
        let edges = answer.f32s(&open["edges"]);
        let on_face = |p: &[f32]| [0, 2, 3].iter().any(|k| CORNERS[*k].map(|x| x as f32) == *p);
        assert_eq!(edges.len(), 3 * 2 * 3);
        assert!(edges.chunks(3).all(on_face), "{edges:?}");
    }
}

#[test]
fn a_closed_mesh_moves_as_a_solid_of_water() {
    let mut session = Session::default();
    let info = session.open("solid.obj", obj(&FACES).as_bytes());
    assert_eq!((&info["kind"], &info["mesh"]), (&json!("scenario"), &json!(true)));
    let text = session.ask(&json!({ "document": { "id": 0 } })).json["text"].as_str().unwrap().to_owned();
    let answer = session.motion(&text, &json!([]));
    assert_eq!(answer.json["errors"], json!([]));
    let density =
        answer.json["knobs"].as_array().unwrap().iter().find(|knob| knob["key"] == "body.part[0].density");
    assert_eq!(density.unwrap()["value"], 1000.0);
    let page = &answer.json["motion"]["page"];
    let omega = answer.f64s(&page["motion"]["omega"]);
    assert_eq!(omega[..3], [0.05, 0.1, 3.0]);
    let mass = page["body"]["mass"].as_f64().unwrap();
    assert!((mass / (1000.0 * volume()) - 1.0).abs() < 1e-12, "{mass}");
    assert_eq!(session.ask(&json!({ "mesh": { "id": 0 } })).json["mesh"]["of"], 4);
}

const ROBOT: &str = "<robot name=\"arm\">
<link name=\"base\">
<inertial><origin xyz=\"0.01 -0.02 0.05\"/><mass value=\"3.6\"/><inertia ixx=\"0.02\" ixy=\"0.001\" ixz=\"-0.002\" iyy=\"0.025\" iyz=\"0.003\" izz=\"0.03\"/></inertial>
<visual><geometry><mesh filename=\"meshes/solid.obj\"/></geometry></visual>
</link>
<link name=\"tip\">
<inertial><mass value=\"0.9\"/><inertia ixx=\"0.001\" ixy=\"0\" ixz=\"0\" iyy=\"0.002\" iyz=\"0\" izz=\"0.004\"/></inertial>
</link>
<joint name=\"j\" type=\"fixed\"><parent link=\"base\"/><child link=\"tip\"/><origin xyz=\"0.3 -0.1 0.7\"/></joint>
</robot>
";

#[test]
fn a_robot_is_shown_with_its_meshes_and_its_impossible_inertia() {
    let mut session = Session::default();
    session.files.insert("arm/meshes/solid.obj", obj(&FACES).as_bytes());
    assert_eq!(session.open("arm/arm.urdf", ROBOT.as_bytes())["kind"], "robot");
    let robot = session.ask(&json!({ "document": { "id": 0 } })).json["robot"].clone();
    let [base, tip] = [0, 1].map(|k| &robot["links"][k]);
    assert_eq!((&base["shapes"][0]["kind"], &base["shapes"][0]["of"]), (&json!("mesh"), &json!(4)));
    assert_eq!(tip["position"], json!([0.3, -0.1, 0.7]));
    // The base has less inertia than its mesh; 0.001 + 0.002 < 0.004 is impossible.
    assert_eq!((&base["verdict"], &tip["verdict"]), (&json!("suspect"), &json!("impossible")));
    let finding =
        robot["findings"].as_array().unwrap().iter().find(|finding| finding["severity"] == "impossible");
    assert_eq!((&finding.unwrap()["link"], &finding.unwrap()["line"]), (&json!(1), &json!(7)));
}

#[test]
fn a_file_of_a_set_refers_only_to_files_of_its_set() {
    let scenario = "[[body.part]]\nshape = \"mesh\"\nfile = \"../b/solid.obj\"\nunit = \"m\"\nmass = 1.5\n\
                    [start]\nspin = { body = [0.1, 0.7, -0.2] }\n";
    let files = Memory::from([("a/one.toml", scenario), ("b/solid.obj", &obj(&FACES))]);
    let set = DroppedSet { folder: "a".into(), files: vec!["a/one.toml".into()] };
    let errors = |set: Option<&DroppedSet>| {
        let engine = Engine::default();
        let document = engine.open("a/one.toml".as_ref(), set, &files, &|| true).unwrap().id;
        let (text, edits, body) = (scenario.to_owned(), Vec::new(), None);
        let request = MotionRequest { document, text, edits, error: false, working: false, body };
        let answer = engine.motion(&request, &files, &|| true).unwrap();
        assert_eq!(answer.motion.is_some(), answer.errors.is_empty());
        answer.errors
    };
    assert_eq!(errors(None), []);
    let error = errors(Some(&set)).remove(0);
    assert!(
        error.message.contains("must be a file that was opened or dropped together with the scenario"),
        "{error:?}"
    );
    assert_eq!(error.line, Some(3));
}
