//! Errors of a text, and completions, at places that count UTF-16 units.

use serde_json::json;

use crate::session::Session;

const TEXT: &str = "\
title = \"🜨 a slab\"
[[body.part]]
shape = \"box\"
size = [\"3 m\", \"2 m\", \"1 m\"]
mass = \"4 kg\"

[start]
spin = { body = [\"0.2 rad/s\", \"1 rad/s\", \"-0.3 rad/s\"] }

[run]
duration = \"2 s\"
samples = 21
";

fn session() -> Session {
    let mut session = Session::default();
    session.open("slab.toml", TEXT.as_bytes());
    session
}

/// Returns the number of UTF-16 units before a part of a text.
fn units_before(text: &str, part: &str) -> usize {
    text.split(part).next().unwrap().encode_utf16().count()
}

#[test]
fn an_error_has_its_place_and_a_hint() {
    let text = TEXT.replace("mass =", "mas =");
    let answer = session().motion(&text, &json!([])).json;
    assert_eq!(answer["motion"], json!(null));
    let error = &answer["errors"][0];
    assert!(
        error["message"].as_str().unwrap().starts_with("unknown key \"mas\" in [[body.part]]"),
        "{error}"
    );
    assert!(error["hint"].as_str().unwrap().starts_with("did you mean mass?"), "{error}");
    let from = units_before(&text, "mas =");
    assert_eq!([&error["from"], &error["to"]], [&json!(from), &json!(from + 3)]);
    assert_eq!([&error["line"], &error["column"]], [&json!(5), &json!(1)]);
}

#[test]
fn a_key_is_completed_at_the_cursor() {
    let text = TEXT.replace("mass = \"4 kg\"", "dens");
    let at = units_before(&text, "dens") + 4;
    let message = json!({ "complete": { "document": 0, "text": text, "at": at } });
    let answer = session().ask(&message).json;
    assert_eq!([&answer["from"], &answer["to"]], [&json!(at - 4), &json!(at)]);
    let options = answer["options"].as_array().unwrap();
    assert!(
        options.iter().any(|option| option["label"].as_str().unwrap().starts_with("density")),
        "{answer}"
    );
}

#[test]
fn a_file_that_changed_is_read_again() {
    let mut session = session();
    let text = |session: &Session| session.ask(&json!({ "document": { "id": 0 } })).json["text"].clone();
    let stamp = |session: &Session| session.ask(&json!("documents")).json["documents"][0]["stamp"].clone();
    let before = stamp(&session);
    assert_eq!(text(&session), TEXT);
    let heavier = TEXT.replace("4 kg", "5 kg");
    session.files.insert("slab.toml", heavier.as_bytes());
    assert_ne!(stamp(&session), before);
    assert_eq!(text(&session), heavier);
}
