//! Invalid requests and files are refused with their place, the rule and a fix.

use polhode_source::files::Memory;
use serde_json::{Value, json};

use crate::ask;

/// Returns the only failure of a request.
fn failure(request: &Value, files: &Memory) -> Value {
    let (answer, numbers) = ask(request, files);
    let failures = answer["failures"].as_array().unwrap_or_else(|| panic!("{answer}"));
    assert_eq!((failures.len(), numbers.len()), (1, 0));
    failures[0].clone()
}

#[test]
fn unknown_keys_are_refused() {
    let files = Memory::default();
    for (request, key) in [
        (json!({ "check": { "files": [], "mass": 1 } }), "`mass`"),
        (json!({ "inertia": { "box": "1 m, 2 m, 3 m", "mass": 2, "masss": 3 } }), "`masss`"),
        (json!({ "inertia": { "files": [], "table": true } }), "`table`"),
        (
            json!({ "free_motion": { "moments": [1, 2, 2.5], "omega": [0, 1, 2], "times": [], "t": 1 } }),
            "`t`",
        ),
        (json!({ "simulate": { "file": "a.toml", "duration": 3 } }), "`duration`"),
        (json!({ "explain": { "request": { "file": "a.toml" }, "format": "pdf" } }), "`pdf`"),
        (json!({ "spin": {} }), "`spin`"),
    ] {
        let failure = failure(&request, &files);
        assert_eq!(failure["kind"], "request");
        assert!(failure["reason"].as_str().unwrap().contains(key), "{failure}");
    }
    let twice = polhode_npm::answer(br#"{"check": {"files": [], "fix": true, "fix": false}}"#, &files);
    assert!(String::from_utf8(twice.json).unwrap().contains("fix"));
}

#[test]
fn a_failure_has_its_place() {
    let files =
        Memory::from([("a.toml", "[[body.part]]\nshape = 'box'\nsize = [0.1, -0.2, 0.3]\nmass = 2\n")]);
    let found = failure(&json!({ "simulate": { "file": "a.toml" } }), &files);
    assert_eq!(
        (&found["kind"], &found["file"], &found["line"]),
        (&json!("input"), &json!("a.toml"), &json!(3))
    );
    assert!(found["text"].as_str().unwrap().contains("--> a.toml:3:"), "{found}");
    let found = failure(&json!({ "check": { "files": ["b.urdf"] } }), &files);
    assert_eq!((&found["kind"], &found["file"]), (&json!("input"), &json!("b.urdf")));
    let found = failure(&json!({ "simulate": { "file": "a.toml", "at": ["1 s"] } }), &files);
    assert_eq!(found["line"], 3);
}

#[test]
fn bodies_and_times_that_do_not_exist_are_refused() {
    let of = |moments: [f64; 3], omega: [f64; 3], attitude: [f64; 4], times: &[f64]| {
        let request = json!({ "moments": moments, "omega": omega, "attitude": attitude, "times": times });
        failure(&json!({ "free_motion": request }), &Memory::default())["reason"].as_str().unwrap().to_owned()
    };
    let upright = [1.0, 0.0, 0.0, 0.0];
    assert!(of([0.4, 1.0, 2.0], [0.1, 2.0, 0.3], upright, &[1.0]).contains("moments"));
    assert!(of([1.0, 2.0, 2.5], [0.1, 2.0, 0.3], [0.0; 4], &[1.0]).contains("attitude"));
    assert!(of([1.0, 2.0, 2.5], [0.1, 2.0, 0.3], upright, &[1.0, 1e300]).contains("1e300"));
    assert!(of([1e200, 2e200, 2.5e200], [1e100, 2.0, 0.3], upright, &[]).contains("too large"));
}

#[test]
fn files_are_not_written() {
    let request = json!({ "inertia": { "files": ["a.stl"], "write-mesh": "b.stl" } });
    let reason = failure(&request, &Memory::default())["reason"].clone();
    assert!(reason.as_str().unwrap().starts_with("write-mesh names an output file"));
}

#[test]
fn selections_of_links_do_not_contradict() {
    for (request, word) in [
        (json!({ "link": "a", "lump": "all" }), "link and lump"),
        (json!({ "link": "a", "joint": ["elbow=0.3"] }), "joint is only for"),
        (json!({ "joint": ["elbow=0.3"] }), "joint is only for"),
    ] {
        let mut request = request;
        request["files"] = json!(["r.urdf"]);
        let found = failure(&json!({ "inertia": request }), &Memory::default());
        assert!(found["reason"].as_str().unwrap().contains(word), "{found}");
    }
}
