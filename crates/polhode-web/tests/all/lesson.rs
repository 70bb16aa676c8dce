//! Lessons in memory: those of the program, and a teacher's own.

use std::sync::atomic::{AtomicU32, Ordering};

use polhode_source::files::Memory;
use polhode_web::{Engine, Watch, lessons};
use serde_json::json;

use crate::session::Session;

const LESSON: &str = "\
title = \"A plate\"
summary = \"Does it wobble?\"
scenario = \"plate.toml\"

[[step]]
text = \"Look.\"

[[step]]
text = \"A thicker one.\"
knobs = [\"body.part[0].size[2]\"]
set = [{ key = \"body.part[0].size[2]\", value = \"9 mm\" }]
";

const PLATE: &str = "\
[[body.part]]
shape = \"box\"
size = [\"0.31 m\", \"0.2 m\", \"4 mm\"]
mass = \"0.7 kg\"

[start]
spin = { body = [\"0.3 rad/s\", \"-0.2 rad/s\", \"5 rad/s\"] }

[run]
duration = \"3 s\"
samples = 16
";

#[test]
fn a_lesson_of_the_program_becomes_one_document() {
    let session = Session::default();
    let listed = session.ask(&json!("lessons")).json;
    let ids: Vec<_> = lessons().map(|lesson| lesson.id).collect();
    assert_eq!(listed["lessons"].as_array().unwrap().len(), ids.len());
    assert!(ids.len() >= 20 && listed["lessons"][3]["id"] == ids[3].as_str());
    let twice = [(); 2].map(|()| session.ask(&json!({ "lesson": { "id": "racket" } })).json);
    assert_eq!(twice[0], twice[1]);
    assert_eq!((&twice[0]["id"], &twice[0]["document"]), (&json!("racket"), &json!(0)));
    let scenario = twice[0]["steps"][0]["scenario"].as_str().unwrap();
    assert_eq!(session.motion(scenario, &json!([])).json["errors"], json!([]));
    assert_eq!(session.ask(&json!("documents")).json["documents"].as_array().unwrap().len(), 1);
}

/// Watch that counts the motions of a lesson.
#[derive(Default)]
struct Motions(AtomicU32);

impl Watch for Motions {
    fn goes_on(&self) -> bool {
        true
    }

    fn restart(&self) {
        self.0.fetch_add(1, Ordering::Relaxed);
    }
}

#[test]
fn a_teachers_own_lesson_is_read_from_memory() {
    let files = Memory::from([("course/plate-lesson.toml", LESSON), ("course/plate.toml", PLATE)]);
    let motions = Motions::default();
    let engine = Engine::beginning_with_lesson("course/plate-lesson.toml", &files, &motions).unwrap();
    // The scenario, and the step that changes it.
    assert_eq!(motions.0.into_inner(), 2);
    assert_eq!(engine.first_lesson(), Some("plate-lesson.toml"));
    let session = Session { engine, files };
    assert_eq!(session.ask(&json!("lessons")).json["lessons"][0]["title"], "A plate");
    let lesson = session.ask(&json!({ "lesson": { "id": "plate-lesson.toml" } })).json;
    assert_eq!(lesson["steps"][0]["scenario"], PLATE);
    assert_eq!(lesson["steps"][1]["scenario"], PLATE.replace("4 mm", "9 mm"));
}

#[test]
fn a_page_begins_with_one_lesson_of_its_own() {
    let files = Memory::from([("a/mine.toml", LESSON), ("a/plate.toml", PLATE), ("b/mine.toml", LESSON)]);
    let session = Session { engine: Engine::default(), files };
    let begin = |path: &str| session.ask(&json!({ "lesson_file": { "path": path } })).json;
    for _ in 0..2 {
        assert_eq!(begin("a/mine.toml")["id"], "mine.toml");
    }
    assert_eq!(session.ask(&json!("lessons")).json["lessons"][0]["title"], "A plate");
    for other in ["b/mine.toml", "cube"] {
        let message = begin(other)["refusal"]["message"].to_string();
        assert!(message.contains("the session has begun with the lesson"), "{message}");
    }
}

#[test]
fn a_wrong_lesson_is_refused_at_its_place() {
    let wrong = LESSON.replace("size[2]\"]", "size[3]\"]");
    let files = Memory::from([("lesson.toml", wrong.as_str()), ("plate.toml", PLATE)]);
    let error = Engine::beginning_with_lesson("lesson.toml", &files, &|| true).unwrap_err();
    assert_eq!(
        (error.place, error.message.as_str()),
        (Some([10, 10]), "the scenario has no number \"body.part[0].size[3]\"")
    );
    let unknown = Engine::beginning_with_lesson("racquet", &files, &|| true).unwrap_err();
    assert!(unknown.message == "unknown lesson" && unknown.hint.unwrap().contains("racket"));
}
