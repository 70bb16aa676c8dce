//! Ten thousand requests that no page sends change nothing in a session.

use std::panic::{AssertUnwindSafe, catch_unwind};

use polhode_source::files::Disk;
use serde_json::{Value, json};

use crate::chance::Chance;
use crate::page::Page;
use crate::session::{Answer, motion};

/// Scenario that is computed in negligible time.
const SMALL: &str = "[[body.part]]\nshape = \"box\"\nsize = [1, 2, 3]\nmass = 4\n[start]\nspin = { body = [0.1, 0.2, 0.3] }\n[run]\nduration = 1\nsamples = 2\n";

/// A request and its expected answer.
struct Attempt {
    request: Vec<u8>,
    expected: Expected,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Expected {
    Refusal,
    /// An answer with the errors of the text.
    Errors,
    /// Any answer except one that indicates a defect.
    Anything,
}

fn json_of_another_shape(chance: &mut Chance) -> Attempt {
    let depth = 1 << chance.below(16);
    let body = match chance.below(14) {
        0 => "[".repeat(depth).into_bytes(),
        1 => "{\"document\":".repeat(depth).into_bytes(),
        2 => format!("{}{}", "[".repeat(depth), "]".repeat(depth)).into_bytes(),
        3 => chance.bytes(400),
        4 => b"{\"document\":0,\"text\":\"\xff\xfe\",\"edits\":[]}".to_vec(),
        5 => b"{\"document\":1e400,\"text\":\"\",\"edits\":[]}".to_vec(),
        6 => b"{\"document\":-0.5}".to_vec(),
        7 => b"{\"document\":0,\"document\":0,\"text\":\"\",\"at\":0}".to_vec(),
        8 => b"{\"document\":0,\"text\":\"\\ud800\",\"at\":0}".to_vec(),
        9 => b"{\"document\":0,\"text\":\"\",\"at\":99999999999999999999999}".to_vec(),
        10 => b"{\"__proto__\":{\"document\":0}}".to_vec(),
        11 => b"null".to_vec(),
        12 => b"{\"set\":4294967296,\"name\":\"a\"}".to_vec(),
        _ => format!("{{\"document\":0,\"text\":\"\",\"edits\":{}}}", "9".repeat(depth)).into_bytes(),
    };
    let request =
        [format!("{{\"{}\":", chance.of(&["motion", "complete", "open"])).as_bytes(), &body, b"}"].concat();
    Attempt { request, expected: Expected::Refusal }
}

/// Texts that are not scenarios; the answer reports their errors.
fn texts(chance: &mut Chance) -> Attempt {
    let many = 1 << chance.below(13);
    let file = chance.of(&[
        "/etc/passwd",
        "../x.stl",
        "../../../../etc/passwd",
        "file:///etc/passwd",
        "C:\\\\x.stl",
        "//host/x.stl",
        "/dev/zero",
        "/proc/self/environ",
        "x.stl",
        ".",
    ]);
    let of_part = |part: &str| format!("[[body.part]]\n{part}\n[start]\nspin = {{ body = [1, 2, 3] }}\n");
    let text = match chance.below(12) {
        0 => format!("a = {}", "[".repeat(many)),
        1 => format!("a = {}1{}", "[".repeat(many), "]".repeat(many)),
        2 => format!("a{} = 1", ".a".repeat(many)),
        3 => format!("[a{}]", ".a".repeat(many)),
        4 => format!("a = {}1{}", "{ a = ".repeat(many), " }".repeat(many)),
        5 => "[[body.part]]\n".repeat(many.min(500)),
        6 => format!("a = {}", "9".repeat(many)),
        7 => String::from_utf8_lossy(&chance.bytes(600)).into_owned(),
        8 => of_part("shape = \"box\"\nsize = [1e400, 1, 1]\nmass = 1"),
        9 => of_part(&format!("shape = \"mesh\"\nfile = \"{file}\"\nunit = \"m\"\ndensity = 1")),
        10 => of_part(&format!("shape = \"molecule\"\nfile = \"{file}\"")),
        _ => SMALL.replace("size", "__proto__"),
    };
    let request = motion(&text, &json!([])).to_string().into_bytes();
    Attempt { request, expected: Expected::Errors }
}

fn edits(chance: &mut Chance) -> Attempt {
    let key = chance.of(&[
        "__proto__",
        "constructor.prototype",
        "body.part[99999999999999999999]",
        "body.part[-1]",
        "body.part[0].size[18446744073709551615]",
        "body.part[0].",
        ".",
        "",
        "[",
        "]",
        "[0]",
        "body[0]",
        "start.spin.body[0][0]",
        "body.part[0].mass.mass",
        "\u{0}",
        "run.duration\n",
        "body.part[0x0].mass",
        "body.part[٣].mass",
    ]);
    let value = chance.of(&[
        "1e999",
        "nan",
        "-inf",
        "\"\"",
        "{ a = { a = 1 } }",
        "1\n[x]\ny = 1",
        "\"9e999 m\"",
        "'''",
        "[[[[",
        "0x",
        "\u{0}",
        "\"/etc/passwd\"",
    ]);
    let edit = match chance.below(6) {
        0 => json!({ "set": key, "value": null }),
        1 => json!({ "omega": [1e308, -1e308, 1e308] }),
        2 => json!({ "attitude": [0, 0, 0, 0], "omega": [0, 0, 0] }),
        3 => json!({ "moments": [-1, 0, 1e308] }),
        4 => json!({ "set": "body.part[0].mass", "value": value }),
        _ => json!({ "set": key, "value": value }),
    };
    let edits = if chance.below(8) == 0 { json!(vec![edit; 65]) } else { json!([edit]) };
    let request = motion(SMALL, &edits).to_string().into_bytes();
    Attempt { request, expected: Expected::Anything }
}

/// Checks that the engine still answers ordinary requests.
fn answers(page: &Page) {
    assert_eq!(page.documents()[0]["name"], "t-handle.toml");
    let edits = json!([{ "set": "body.part[0].mass", "value": "5" }]);
    let moved = page.ask(&motion(SMALL, &edits));
    assert_eq!(moved["text"], SMALL.replace("mass = 4", "mass = 5"));
    assert_eq!(moved["motion"]["page"]["body"]["mass"], 5.0);
    assert_eq!(moved["errors"], json!([]));
}

fn is_right(expected: Expected, answer: &Value) -> bool {
    let is_refused =
        matches!(answer["refusal"]["kind"].as_str(), Some("bad_request" | "not_found" | "unprocessable"));
    let is_error = answer["motion"].is_null() && answer["errors"][0]["message"].is_string();
    // The answer contains no data of this machine.
    let is_silent = !answer.to_string().contains("root:");
    is_silent
        && match expected {
            Expected::Refusal => is_refused,
            Expected::Errors => is_error,
            Expected::Anything => is_refused || answer["refusal"].is_null(),
        }
}

#[test]
fn ten_thousand_requests_that_no_page_sends_change_nothing() {
    let page = Page::open(&[]);
    let mut chance = Chance(7);
    answers(&page);
    for k in 0..10_000 {
        let Attempt { request, expected } = [json_of_another_shape, texts, edits][k % 3](&mut chance);
        let shown = || String::from_utf8_lossy(&request[..request.len().min(2_000)]).into_owned();
        let answer = catch_unwind(AssertUnwindSafe(|| page.engine.answer(&request, &Disk, &|| true)));
        let answer = Answer::parse(&answer.unwrap_or_else(|_| panic!("{k}: {}", shown()))).json;
        assert!(is_right(expected, &answer), "{k}: {answer}, not {expected:?}, to {}", shown());
        if k % 500 == 0 {
            answers(&page);
        }
    }
    answers(&page);
}

#[test]
fn a_text_names_no_file_that_it_was_not_opened_with() {
    let page = Page::open(&[]);
    for file in ["/etc/passwd", "../x.stl", "/proc/self/environ", "../../../../../../etc/passwd"] {
        for part in [
            format!("shape = \"mesh\"\nfile = \"{file}\"\nunit = \"m\"\ndensity = 1"),
            format!("shape = \"particles\"\nfile = \"{file}\""),
            format!("shape = \"molecule\"\nfile = \"{file}\""),
        ] {
            let text = format!("[[body.part]]\n{part}\n[start]\nspin = {{ body = [1, 2, 3] }}\n");
            let told = page.motion(0, &text);
            assert!(told["motion"].is_null());
            let message = told["errors"][0]["message"].as_str().unwrap();
            assert!(!message.contains("root:"), "{message}");
        }
    }
}
