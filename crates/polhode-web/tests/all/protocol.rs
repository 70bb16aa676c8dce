//! Requests and answers conform to the schema of which the page's TypeScript types are made.

use polhode_source::files::Memory;
use polhode_web::{
    Edit, Engine, ExerciseRequest, Message, MotionRequest, PROTOCOL_SCHEMA, ReportRequest, TableKind,
};
use serde_json::{Value, json};

use crate::schema::fits;

const SCENARIO: &str = "[[body.part]]\nshape = 'box'\nsize = ['0.11 m', '0.23 m', '0.31 m']\nmass = '2.3 kg'\n\
    [start]\nspin = { body = [0.1, 3.1, -0.2] }\n[[torque]]\nmodel = 'drag'\nlaw = 'linear'\n\
    coefficient = [0.001, 0.002, 0.0015]\n[run]\nduration = 5\nsamples = 7\n";

/// Tetrahedron with one face missing.
const OPEN_MESH: &str = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";

/// Box with a lost exponent of izz, and a link without inertial data.
const ROBOT: &str = r#"<robot name="r"><link name="box"><inertial><mass value="2"/>
  <inertia ixx="0.0216667" ixy="0" ixz="0" iyy="0.0166667" iyz="0" izz="8.33333"/></inertial>
  <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link><link name="tool"/>
  <joint name="j" type="fixed"><parent link="box"/><child link="tool"/></joint></robot>"#;

/// Parts list with one row.
const PARTS: &str = "name,mass [kg],x [mm],y [mm],z [mm]\nframe,2.3,1,-2,3\nlid,0.7,10,20,-30\n";

fn require(definition: &str, value: &Value) {
    let schema: Value = serde_json::from_str(PROTOCOL_SCHEMA).unwrap();
    let found = fits(&schema, &schema["$defs"][definition], value, "");
    assert!(found.is_ok(), "{definition}: {found:?}\n{value:#}");
}

/// Sends a request, and checks both the request and the answer.
fn ask(engine: &Engine, files: &Memory, message: &Message, answer: &str) -> Value {
    let request = serde_json::to_value(message).unwrap();
    require("Request", &request);
    let bytes = engine.answer(request.to_string().as_bytes(), files, &|| true);
    let json = match bytes.strip_prefix(b"{") {
        Some(_) => &bytes[..],
        None => &bytes[8..8 + u64::from_le_bytes(bytes[..8].try_into().unwrap()) as usize],
    };
    let found = serde_json::from_slice(json).unwrap();
    require(answer, &found);
    found
}

#[test]
fn requests_and_answers_conform() {
    let lesson = include_str!("../../lessons/racket.toml");
    let files = Memory::from([
        ("own/box.toml", SCENARIO),
        ("open.obj", OPEN_MESH),
        ("arm.urdf", ROBOT),
        ("racket.toml", lesson),
        ("parts.csv", PARTS),
    ]);
    let engine = Engine::default();
    let open = |path: &str, set: Option<&str>| Message::Open { path: path.into(), set: set.map(Into::into) };
    ask(&engine, &files, &Message::OpenExample, "DocumentInfo");
    let boxed = ask(&engine, &files, &open("own/box.toml", Some("own")), "DocumentInfo");
    let mesh = ask(&engine, &files, &open("open.obj", None), "DocumentInfo");
    let robot = ask(&engine, &files, &open("arm.urdf", None), "DocumentInfo");
    assert_eq!([&boxed["kind"], &mesh["kind"], &robot["kind"]], ["scenario", "mesh", "robot"]);
    let [boxed, mesh, robot] = [boxed, mesh, robot].map(|info| info["id"].as_u64().unwrap() as u32);
    ask(&engine, &files, &Message::Documents, "Documents");
    for id in [boxed, mesh, robot] {
        ask(&engine, &files, &Message::Document { id }, "DocumentContent");
    }
    let found = ask(&engine, &files, &Message::Document { id: robot }, "RobotContent");
    assert!(found["robot"]["repair"]["changes"][0]["line"].is_u64());
    assert!(
        found["robot"]["links"][0]["inertial"]["mass"] == 2.0
            && found["robot"]["links"][1]["inertial"].is_null()
    );
    let found = ask(&engine, &files, &Message::Mesh { id: mesh }, "MeshContent");
    assert!(found["mesh"]["findings"].as_array().is_some_and(|findings| !findings.is_empty()));

    let motion = |text: &str, edits: Vec<Edit>| {
        let (text, body) = (text.to_owned(), None);
        Message::Motion(MotionRequest { document: boxed, text, edits, error: true, working: true, body })
    };
    let edits = vec![
        Edit::Set { set: "body.part[0].mass".to_owned(), value: Some("'1.7 kg'".to_owned()) },
        Edit::Omega { omega: [0.2, 2.9, -0.3] },
        Edit::Start { attitude: [0.5, -0.5, 0.1, 0.7], omega: [0.1, 2.9, -0.3] },
        Edit::Moments { moments: [0.8, 1.7, 2.1] },
    ];
    let found = ask(&engine, &files, &motion(SCENARIO, edits), "MotionAnswer");
    assert_eq!((&found["errors"], found["motion"].is_object()), (&json!([]), true));
    assert!(found["knobs"].as_array().is_some_and(|knobs| knobs.len() > 2));
    assert_eq!(found["switches"][0]["on"], true);
    let found = ask(&engine, &files, &motion("[[body.part]]\nshape = 3\n", vec![]), "MotionAnswer");
    assert_eq!((&found["errors"][0]["line"], &found["motion"]), (&json!(2), &Value::Null));
    let complete =
        polhode_web::CompleteRequest { document: boxed, text: "[[body.part]]\nsha".to_owned(), at: 17 };
    let found = ask(&engine, &files, &Message::Complete(complete), "CompleteAnswer");
    assert!(found["options"].as_array().is_some_and(|options| options.len() > 2));

    let table = ask(&engine, &files, &open("parts.csv", None), "DocumentInfo");
    assert_eq!(table["kind"], "table");
    let document = table["id"].as_u64().unwrap() as u32;
    let found = ask(&engine, &files, &Message::Document { id: document }, "DocumentContent");
    assert!(found["table"]["kinds"].as_array().is_some_and(|kinds| kinds.len() > 1));
    let report = |options: Value| {
        let options = options.as_object().unwrap().clone();
        Message::Report(ReportRequest {
            document,
            kind: TableKind::Budget,
            text: None,
            scenario: None,
            options,
        })
    };
    let found =
        ask(&engine, &files, &report(json!({ "about": "(1, 2, 3) mm", "draws": 100 })), "ReportAnswer");
    assert!(found["report"]["html"].as_str().is_some_and(|html| html.contains("frame")));
    let found = ask(&engine, &files, &report(json!({ "about": "here" })), "ReportAnswer");
    assert!(found["error"]["message"].is_string() && found["report"].is_null());
    let turning = ask(&engine, &files, &Message::Particles { id: document }, "DocumentInfo");
    assert_eq!(turning["kind"], "scenario");

    let lessons = ask(&engine, &files, &Message::Lessons, "Lessons");
    for lesson in lessons["lessons"].as_array().unwrap() {
        let id = lesson["id"].as_str().unwrap().to_owned();
        ask(&engine, &files, &Message::Lesson { id }, "Lesson");
    }
    let topics = ask(&engine, &files, &Message::Exercises, "Exercises");
    let (topic, symbols) = (topics["topics"][0]["topic"].as_str().unwrap().to_owned(), false);
    for answers in ["", "[", "1"].map(|text| Some(text.to_owned())) {
        let request = ExerciseRequest { topic: topic.clone(), seed: 3, symbols, answers, solution: true };
        ask(&engine, &files, &Message::Exercise(request), "ExerciseAnswer");
    }
    ask(&engine, &files, &Message::LessonFile { path: "racket.toml".into() }, "LessonFile");
    ask(&engine, &files, &Message::Document { id: 9999 }, "Refused");
}
