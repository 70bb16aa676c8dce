//! Requests that are refused: each has an answer with its kind.

use std::sync::atomic::{AtomicU32, Ordering};

use serde_json::json;

use crate::session::{Session, motion};

const TEXT: &str = "[[body.part]]\nshape = \"box\"\nsize = [\"3 m\", \"2 m\", \"1 m\"]\nmass = 4\n\
                    [start]\nspin = { body = [0.2, 1, -0.3] }\n[run]\nduration = \"2 s\"\nsamples = 5\n\
                    [[torque]]\nmodel = \"energy_sink\"\ncoefficient = \"0.3 /(N m s)\"\n";

fn session() -> Session {
    let mut session = Session::default();
    session.open("slab.toml", TEXT.as_bytes());
    session
}

#[test]
fn wrong_json_is_a_bad_request() {
    let session = session();
    let whole = motion(TEXT, &json!([])).to_string();
    for request in [
        "",
        "{",
        "null",
        "[]",
        "\"motion\"",
        "\"close\"",
        "{\"document\":{}}",
        "{\"document\":{\"id\":-1}}",
        "{\"document\":{\"id\":0,\"id\":0}}",
        "{\"document\":{\"id\":0,\"name\":\"a\"}}",
        "{\"document\":{\"id\":0},\"mesh\":{\"id\":0}}",
        "{\"open\":{\"path\":7}}",
        &whole.replace("\"edits\":[]", "\"edits\":[{\"turn\":1}]"),
        &whole.replace("\"working\"", "\"works\""),
        &whole[..whole.len() - 1],
        "\u{feff}\"documents\"",
    ] {
        let answer = session.engine.answer(request.as_bytes(), &session.files, &|| true);
        let text = String::from_utf8(answer).unwrap();
        let begins = "{\"refusal\":{\"kind\":\"bad_request\",\"message\":\"the request is invalid: ";
        assert!(text.starts_with(begins), "{request}: {text}");
    }
    let not_utf8 = session.engine.answer(b"\"docu\xffments\"", &session.files, &|| true);
    assert!(not_utf8.starts_with(b"{\"refusal\":{\"kind\":\"bad_request\""));
    let many = json!(vec![json!({ "omega": [0.1, 0.2, 0.3] }); 65]);
    assert_eq!(session.motion(TEXT, &many).refusal(), ["bad_request", "a request has at most 64 edits"]);
}

#[test]
fn what_does_not_exist_or_has_another_kind_is_refused() {
    let mut session = session();
    let unknown = ["not_found", "unknown document 7"];
    let mut of_seven = motion(TEXT, &json!([]));
    of_seven["motion"]["document"] = json!(7);
    for message in [
        json!({ "document": { "id": 7 } }),
        json!({ "mesh": { "id": 7 } }),
        json!({ "complete": { "document": 7, "text": TEXT, "at": 3 } }),
        of_seven,
    ] {
        assert_eq!(session.ask(&message).refusal(), unknown, "{message}");
    }
    let not_a_mesh = session.ask(&json!({ "mesh": { "id": 0 } }));
    assert_eq!(not_a_mesh.refusal(), ["not_found", "\"slab.toml\" is not a mesh"]);
    let lesson = session.ask(&json!({ "lesson": { "id": "../cube" } }));
    assert_eq!(lesson.refusal(), ["not_found", "unknown lesson"]);
    let missing = session.ask(&json!({ "open": { "path": "/etc/hostname" } }));
    assert_eq!(missing.refusal()[0], "unprocessable");
    session.files.insert("notes.txt", *b"plain");
    let notes = session.ask(&json!({ "open": { "path": "notes.txt" } }));
    assert_eq!(
        notes.refusal(),
        ["unprocessable", "\"notes.txt\" cannot be read: its file extension is unknown"]
    );
    session.files.insert("robot.urdf", *b"<robot name=\"r\"><link name=\"a\"/></robot>");
    assert_eq!(session.ask(&json!({ "open": { "path": "robot.urdf" } })).json["id"], 1);
    let mut of_robot = motion(TEXT, &json!([]));
    of_robot["motion"]["document"] = json!(1);
    assert_eq!(session.ask(&of_robot).refusal(), ["bad_request", "\"robot.urdf\" is not a scenario"]);
}

#[test]
fn a_session_that_is_full_opens_no_more() {
    let mut session = session();
    for id in 1..100 {
        assert_eq!(session.open("slab.toml", TEXT.as_bytes())["id"], id);
    }
    let full = session.ask(&json!({ "open": { "path": "slab.toml" } }));
    assert_eq!(full.refusal(), ["full", "a session shows at most 100 documents"]);
}

#[test]
fn a_cancelled_request_is_refused_and_leaves_nothing() {
    let session = session();
    for message in [
        json!("documents"),
        json!("open_example"),
        json!({ "open": { "path": "slab.toml" } }),
        json!({ "lesson": { "id": "cube" } }),
        motion(TEXT, &json!([])),
    ] {
        let answer = session.ask_watched(&message, &|| false);
        assert_eq!(answer.refusal(), ["ended", "the request was cancelled"], "{message}");
    }
    // Cancelled at any later check, it is refused as well.
    let whole = session.motion(TEXT, &json!([])).json;
    let cancelled_after = |most: u32| {
        let calls = AtomicU32::new(0);
        let goes_on = || calls.fetch_add(1, Ordering::Relaxed) < most;
        session.ask_watched(&motion(TEXT, &json!([])), &goes_on)
    };
    let mut answers = (1..).map(cancelled_after).take_while(|answer| answer.json != whole);
    assert!(answers.next().is_some());
    answers.for_each(|answer| assert_eq!(answer.refusal()[0], "ended"));
    assert_eq!(session.ask(&json!("documents")).json["documents"].as_array().unwrap().len(), 1);
}
