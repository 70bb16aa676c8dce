//! Lesson files of teachers: how they are served, and which errors are reported.

use std::fs;
use std::path::{Path, PathBuf};

use polhode_source::files::Disk;
use polhode_web::{Engine, LessonError, lessons};
use serde_json::{Value, json};

/// Writes a lesson, as a teacher would, into a folder of its own.
fn written(name: &str, lesson: &str, beside: &[(&str, &str)]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("lessons").join(name);
    fs::create_dir_all(&folder).unwrap();
    for (name, text) in beside {
        fs::write(folder.join(name), text).unwrap();
    }
    let path = folder.join("own lesson.toml");
    fs::write(&path, lesson).unwrap();
    path
}

fn bound(path: &Path) -> Result<Engine, LessonError> {
    Engine::beginning_with_lesson(path.to_str().unwrap(), &Disk, &|| true)
}

const BALL: &str = "[[body.part]]\nshape = \"sphere\"\nradius = \"20 mm\"\nmass = \"1 kg\"\n";

const GOOD: &str = "title = \"A ball\"
summary = \"It turns.\"
scenario = \"ball.toml\"

[[step]]
text = \"Look.\"
knobs = [\"body.part[0].radius\"]
set = [{ key = \"body.part[0].mass\", value = \"2 kg\" }]
working = \"3. \"
question = { text = \"Does it turn?\", answers = [\"No\", \"Yes\"], right = 2, why = \"It does.\" }
";

#[test]
fn a_teachers_own_lesson_is_listed_first_and_served() {
    let engine = bound(&written("good", GOOD, &[("ball.toml", BALL)])).unwrap();
    assert_eq!(engine.first_lesson(), Some("own lesson.toml"));
    let ask = |message: Value| -> Value {
        serde_json::from_slice(&engine.answer(message.to_string().as_bytes(), &Disk, &|| true)).unwrap()
    };
    let list = ask(json!("lessons"));
    assert_eq!(list["lessons"][0]["id"], "own lesson.toml");
    assert_eq!(list["lessons"].as_array().unwrap().len(), 1 + lessons().count());
    let lesson = ask(json!({ "lesson": { "id": "own lesson.toml" } }));
    let step = &lesson["steps"][0];
    assert_eq!(step["question"]["right"], 1);
    assert_eq!(step["scenario"], BALL.replace("1 kg", "2 kg"));
    let documents = ask(json!("documents"));
    assert_eq!(documents["first"], lesson["document"]);
    // Another lesson is a new document; opened again, it is not.
    let twice = [(); 2].map(|()| ask(json!({ "lesson": { "id": "cube" } })));
    assert_eq!(twice[0], twice[1]);
    assert_eq!(ask(json!("documents"))["documents"].as_array().unwrap().len(), 2);
}

#[test]
fn the_lesson_in_the_book_is_one() {
    let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/lessons.md");
    let page = fs::read_to_string(book).unwrap();
    let (_, after) = page.split_once("```toml fragment\n").unwrap();
    let (lesson, _) = after.split_once("```").unwrap();
    bound(&written("book", lesson, &[])).unwrap();
    // The table contains every lesson.
    for info in lessons() {
        assert!(page.contains(&format!("| `{}` |", info.id)), "{}", info.id);
    }
}

#[test]
fn what_a_lesson_cannot_be_is_refused_at_its_place() {
    let beside = [("ball.toml", BALL)];
    for (k, (from, to, place, says)) in [
        ("summary = \"It turns.\"\n", "", None, "missing field `summary`"),
        ("summary", "sumary", Some([2, 1]), "unknown field `sumary`"),
        ("\"It turns.\"", "\" \"", Some([2, 11]), "this text is empty"),
        ("\"It turns.\"", "3", Some([2, 11]), "expected a string"),
        ("ball.toml", "cube.toml", Some([3, 12]), "cannot be read"),
        ("scenario = \"ball.toml\"", "", None, "either `scenario`"),
        (
            "scenario = \"ball.toml\"",
            "scenario = \"ball.toml\"\nscenario_text = ''",
            Some([4, 17]),
            "either `scenario`",
        ),
        ("body.part[0].radius", "body.part[1].radius", Some([7, 10]), "no number \"body.part[1].radius\""),
        ("body.part[0].radius", "body.part[0].shape", Some([7, 10]), "no number \"body.part[0].shape\""),
        ("body.part[0].mass", "body.part[3].mass", Some([8, 8]), "the scenario has no body.part[3].mass"),
        ("\"2 kg\"", "\"-2 kg\"", Some([8, 8]), "with the values of this step"),
        ("\"3. \"", "\"9. \"", Some([9, 11]), "no heading of the worked solution begins with \"9. \""),
        ("\"3. \"", "\"\"", Some([9, 11]), "no heading"),
        ("right = 2", "right = 3", Some([10, 71]), "from 1 to 2, not 3"),
        ("right = 2", "right = 0", Some([10, 71]), "from 1 to 2, not 0"),
        ("[\"No\", \"Yes\"]", "[\"No\"]", Some([10, 48]), "2 to 5 answers, not 1"),
        ("\"Yes\"]", "\"Yes\", \"a\", \"b\", \"c\", \"d\"]", Some([10, 48]), "2 to 5 answers, not 6"),
        ("[[step]]", "[[stop]]", Some([5, 3]), "unknown field `stop`"),
        ("\"A ball\"", "\"A ball", Some([1, 16]), ""),
    ]
    .into_iter()
    .enumerate()
    {
        let lesson = GOOD.replace(from, to);
        assert_ne!(lesson, GOOD, "{from}");
        let error = bound(&written(&format!("bad-{k}"), &lesson, &beside)).unwrap_err();
        assert!(error.message.contains(says), "{error}");
        if place.is_some() {
            assert_eq!(error.place, place, "{error}");
        }
    }
    let no_step = GOOD.split("[[step]]").next().unwrap();
    let error = bound(&written("no-step", no_step, &beside)).unwrap_err();
    assert!(error.message.contains("at least one [[step]]"), "{error}");
    // An error in a scenario is reported at its place, in its own file or in the lesson.
    let wrong = BALL.replace("sphere", "spere");
    let error = bound(&written("scenario", GOOD, &[("ball.toml", &wrong)])).unwrap_err();
    assert!(error.path.ends_with("ball.toml") && error.place == Some([2, 9]), "{error}");
    let inside = GOOD.replace("scenario = \"ball.toml\"", &format!("scenario_text = '''\n{wrong}'''"));
    let error = bound(&written("inside", &inside, &[])).unwrap_err();
    assert!(error.path.ends_with("own lesson.toml") && error.place == Some([5, 9]), "{error}");
    assert!(error.hint.is_some());
}

#[test]
fn an_unknown_lesson_is_refused_with_the_names() {
    let error = bound(Path::new("raket")).unwrap_err();
    assert!(error.message.contains("unknown lesson") && error.hint.unwrap().contains("racket"));
    let error = bound(Path::new("nowhere/lesson.toml")).unwrap_err();
    assert!(error.message.contains("cannot be read"), "{error}");
}
