//! Data of the body that a page already has are not sent again.

use serde_json::{Value, json};

use crate::page::{Folder, Page, f64s};

const AT_REST: &str = "\
[[body.part]]
shape = \"box\"
size = [\"3 m\", \"2 m\", \"1 m\"]
mass = \"4 kg\"

[start]
spin = { body = [\"0 rad/s\", \"0 rad/s\", \"0 rad/s\"] }

[run]
duration = \"2 s\"
samples = 21
";

/// Returns the motion with this initial ω, for a page that has the data with the key `known`.
fn motion(page: &Page, omega: [f64; 3], known: Option<&str>) -> Value {
    let edits = json!([{ "omega": omega }]);
    let request = json!({
        "document": 0, "text": AT_REST, "edits": edits, "error": false, "working": false, "body": known,
    });
    let answer = page.ask(&json!({ "motion": request }));
    assert_eq!(answer["errors"], json!([]));
    answer["motion"].clone()
}

fn count(value: &Value) -> usize {
    value.as_array().map_or(0, Vec::len)
}

#[test]
fn other_motions_of_a_body_are_sent_with_its_first_free_one() {
    let folder = Folder::new("known");
    let page = Page::open(&[folder.file("rest.toml", AT_REST.as_bytes())]);
    let rest = motion(&page, [0.0; 3], None);
    assert_eq!((count(&rest["page"]["body"]["shapes"]), &rest["page"]["free"]), (1, &Value::Null));
    // The page has the shapes, but no curves yet.
    let key = rest["body"].as_str().unwrap();
    assert_eq!(count(&motion(&page, [0.0; 3], Some(key))["page"]["body"]["shapes"]), 0);
    let first = motion(&page, [0.4, 1.0, -0.3], Some(key));
    let of_first = &first["page"]["free"];
    assert_eq!((count(&of_first["family"]), count(&of_first["separatrix"])), (20, 2));
    // Now it has the shapes and the curves of all motions of this body. Curves of a single motion
    // are sent each time.
    let key = first["body"].as_str().unwrap();
    let next = motion(&page, [1.0, 0.2, 0.7], Some(key));
    let of_next = &next["page"]["free"];
    assert_eq!((count(&of_next["family"]), count(&of_next["separatrix"])), (0, 0));
    assert_eq!((count(&next["page"]["body"]["shapes"]), &next["body"]), (0, &first["body"]));
    assert!(of_next["polhode"] != of_first["polhode"]);
    let anew = motion(&page, [1.0, 0.2, 0.7], None);
    for (line, k) in [("family", 0), ("family", 13), ("separatrix", 1)] {
        let [a, b] = [of_first, &anew["page"]["free"]].map(|free| f64s(&free[line][k]));
        let apart = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(a.len() == b.len() && a.len() > 30 && apart < 1e-12, "{line} {k}: {apart}");
    }
    // At rest the page still has them.
    assert_eq!(motion(&page, [0.0; 3], Some(key))["body"], first["body"]);
}
