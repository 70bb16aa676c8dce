//! A hostile client sends ten thousand requests that no page sends; the server still answers as
//! before.

use std::sync::atomic::{AtomicUsize, Ordering};

use serde_json::{Value, json};

use crate::client::{Answer, Page};

/// Scenario that is computed in negligible time.
const SMALL: &str = "[[body.part]]\nshape = \"box\"\nsize = [1, 2, 3]\nmass = 4\n[start]\nspin = { body = [0.1, 0.2, 0.3] }\n[run]\nduration = 1\nsamples = 2\n";

/// Deterministic pseudo-random numbers.
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    fn of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
        all[self.below(all.len())]
    }

    fn bytes(&mut self, most: usize) -> Vec<u8> {
        (0..self.below(most)).map(|_| self.below(256) as u8).collect()
    }
}

/// A request and its expected answer.
struct Attempt {
    bytes: Vec<u8>,
    /// True if the client hangs up after the bytes.
    cut: bool,
    expected: Expected,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Expected {
    /// A status 4xx, or no answer.
    Refusal,
    /// An answer of the page with the errors of the text.
    Errors,
    /// Any answer except one that indicates a defect.
    Anything,
}

impl Attempt {
    const fn refused(bytes: Vec<u8>) -> Self {
        Self { bytes, cut: false, expected: Expected::Refusal }
    }

    const fn cut(bytes: Vec<u8>) -> Self {
        Self { bytes, cut: true, expected: Expected::Refusal }
    }
}

/// Generator of requests of one kind.
type Kind = fn(&Page, &mut Chance) -> Attempt;

const KINDS: [Kind; 12] = [
    request_lines,
    headers,
    strangers,
    tokens,
    paths,
    lengths,
    chunks,
    bodies_cut,
    json_of_another_shape,
    texts,
    edits,
    names,
];

fn post(page: &Page, path: &str, body: &[u8]) -> Vec<u8> {
    let head = format!("{}Content-Length: {}\r\n\r\n", page.head("POST", path), body.len());
    [head.as_bytes(), body].concat()
}

fn request_lines(page: &Page, chance: &mut Chance) -> Attempt {
    let (token, port) = (&page.token, page.port);
    let method = chance
        .of(&["GET", "get", "PUT", "DELETE", "CONNECT", "TRACE", "OPTIONS", "G\u{e9}T", "", " ", "PATCH"]);
    let version = chance.of(&[
        "HTTP/1.1",
        "HTTP/1.0",
        "HTTP/2.0",
        "HTTP/9.9",
        "http/1.1",
        "HTTP",
        "",
        "SIP/2.0",
        "HTTP/1.1 x",
    ]);
    let target = chance.of(&[
        "*",
        "http://evil.example/",
        "//evil.example/",
        "\\",
        "/\u{1F600}",
        "/ ",
        "evil.example:443",
        "?",
        "#",
    ]);
    let line = match chance.below(3) {
        0 => format!("{method} {target} {version}"),
        1 => format!("{method} /{token}/no-such-thing {version}"),
        _ => String::from_utf8_lossy(&chance.bytes(200)).replace("\r\n\r\n", ""),
    };
    Attempt::cut(format!("{line}\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n").into_bytes())
}

fn headers(page: &Page, chance: &mut Chance) -> Attempt {
    let head = page.head("GET", "no-such-thing");
    let more = match chance.below(6) {
        0 => format!("X: {}\r\n", "x".repeat(1 << 14 << chance.below(3))),
        1 => (0..20 * (1 + chance.below(20))).map(|k| format!("x-{k}: {k}\r\n")).collect(),
        2 => "No colon at all\r\n".to_owned(),
        3 => ": no name\r\n".to_owned(),
        4 => "X: a\r\n folded\r\n".to_owned(),
        _ => format!("X\u{0}: \u{1}{}\r\n", chance.below(9)),
    };
    Attempt::cut(format!("{head}{more}\r\n").into_bytes())
}

/// Requests for existing resources from foreign origins.
fn strangers(page: &Page, chance: &mut Chance) -> Attempt {
    let Page { port, token, .. } = page;
    let own = format!("Host: 127.0.0.1:{port}\r\n");
    let lines = match chance.below(12) {
        0 => String::new(),
        1 => own.repeat(2),
        2 => format!("Host: evil.example:{port}\r\n"),
        3 => format!("Host: 127.0.0.1:{port}.evil.example\r\n"),
        4 => format!("Host: 127.0.0.1:{}\r\n", port ^ 1),
        5 => format!("Host: user@127.0.0.1:{port}\r\n"),
        6 => format!("{own}Origin: http://evil.example\r\n"),
        7 => format!("{own}Origin: null\r\n"),
        8 => format!("{own}Origin: http://localhost:{port}\r\n"),
        9 => format!("{own}Sec-Fetch-Site: cross-site\r\n"),
        10 => format!("Host: [::1]:{port}\r\n"),
        _ => format!("{own}Origin: http://127.0.0.1:{port}\r\nOrigin: http://evil.example\r\n"),
    };
    let path = chance.of(&["documents", "document/0", "", "live.js"]);
    Attempt::refused(format!("GET /{token}/{path} HTTP/1.1\r\n{lines}Connection: close\r\n\r\n").into_bytes())
}

fn tokens(page: &Page, chance: &mut Chance) -> Attempt {
    let mut token = page.token.clone();
    match chance.below(5) {
        0 => token.truncate(chance.below(32)),
        1 => token.push('0'),
        2 => token = token.to_uppercase() + "g",
        3 => token = format!("%{:02x}{}", token.as_bytes()[0], &token[1..]),
        _ => {
            let k = chance.below(32);
            let other = if token.as_bytes()[k] == b'a' { "b" } else { "a" };
            token.replace_range(k..=k, other);
        }
    }
    let host = format!("Host: 127.0.0.1:{}\r\nConnection: close\r\n", page.port);
    Attempt::refused(format!("GET /{token}/documents HTTP/1.1\r\n{host}\r\n").into_bytes())
}

fn paths(page: &Page, chance: &mut Chance) -> Attempt {
    let steps = [
        "..",
        "%2e%2e",
        "%2E.",
        ".%2e",
        "%252e%252e",
        "..%2f",
        "..%5c",
        "%c0%ae%c0%ae",
        "....//",
        "%00",
        "%",
        "%zz",
        "assets",
        "src",
    ];
    let mut path = String::new();
    for _ in 0..=chance.below(8) {
        path += chance.of(&steps);
        path.push('/');
    }
    path += chance.of(&["etc/passwd", "live.js", "Cargo.toml", "document/0", "", "live.html", "index.html"]);
    let numbers = [
        "document/-1",
        "document/99",
        "document/99999999999999999999",
        "document/0x0",
        "document/0/",
        "document/%30",
        "document/",
        "document/NaN",
    ];
    let path = if chance.below(4) == 0 { chance.of(&numbers).to_owned() } else { path };
    Attempt::refused(format!("{}\r\n", page.head("GET", &path)).into_bytes())
}

fn lengths(page: &Page, chance: &mut Chance) -> Attempt {
    let head =
        page.head("POST", chance.of(&["motion", "complete", "open", "drop?set=1&name=a.stl", "documents"]));
    let lengths = match chance.below(7) {
        0 => "Content-Length: -1\r\n".to_owned(),
        1 => "Content-Length: 99999999999999999999999999\r\n".to_owned(),
        2 => "Content-Length: 18446744073709551615\r\n".to_owned(),
        3 => "Content-Length: 2\r\nContent-Length: 3\r\n".to_owned(),
        4 => "Content-Length: two\r\n".to_owned(),
        5 => "Content-Length: 4000000000\r\n".to_owned(),
        _ => "Content-Length: 20\r\nTransfer-Encoding: gzip, identity\r\n".to_owned(),
    };
    Attempt::cut(format!("{head}{lengths}\r\n{{}}").into_bytes())
}

fn chunks(page: &Page, chance: &mut Chance) -> Attempt {
    let head = page.head("POST", chance.of(&["motion", "complete", "open", "documents"]));
    let body = match chance.below(6) {
        0 => "zz\r\n{}\r\n0\r\n\r\n".to_owned(),
        1 => "ffffffffffffffffff\r\n{}".to_owned(),
        2 => "2\r\n{}0\r\n\r\n".to_owned(),
        3 => format!("2;{}\r\n{{}}\r\n0\r\n\r\n", "e".repeat(1 << chance.below(15))),
        4 => "1\r\n{\r\n".repeat(1 + chance.below(300)) + "0\r\n\r\n",
        _ => "2\r\n{}\r\n0\r\n".to_owned() + &"X: y\r\n".repeat(chance.below(300)),
    };
    Attempt::cut(format!("{head}Transfer-Encoding: chunked\r\n\r\n{body}").into_bytes())
}

fn bodies_cut(page: &Page, chance: &mut Chance) -> Attempt {
    let whole = post(
        page,
        chance.of(&["motion", "complete", "open", "drop?set=9&name=a.stl"]),
        motion(SMALL, &json!([])).as_bytes(),
    );
    let end = chance.below(whole.len());
    Attempt::cut(whole[..end].to_vec())
}

fn motion(text: &str, edits: &Value) -> String {
    json!({ "document": 0, "text": text, "edits": edits, "error": false, "working": false, "body": null })
        .to_string()
}

fn json_of_another_shape(page: &Page, chance: &mut Chance) -> Attempt {
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
    Attempt::refused(post(page, chance.of(&["motion", "complete", "open"]), &body))
}

/// Texts that are not scenarios; the answer reports their errors.
fn texts(page: &Page, chance: &mut Chance) -> Attempt {
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
    let answer = Expected::Errors;
    Attempt {
        bytes: post(page, "motion", motion(&text, &json!([])).as_bytes()),
        cut: false,
        expected: answer,
    }
}

fn edits(page: &Page, chance: &mut Chance) -> Attempt {
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
    let bytes = post(page, "motion", motion(SMALL, &edits).as_bytes());
    Attempt { bytes, cut: false, expected: Expected::Anything }
}

/// File names that lead outside the set.
fn names(page: &Page, chance: &mut Chance) -> Attempt {
    let name = chance.of(&[
        "../x.stl",
        "/etc/passwd",
        "a/../../x.stl",
        "..",
        ".",
        "",
        "a\\..\\x.stl",
        "C:x.stl",
        "a\u{0}.stl",
        "a\n.stl",
        "CON",
        "nul.stl",
        ".ssh",
        "a/b/c/d/e/f/g/h/i.stl",
        "a//b.stl",
        "~/x.stl",
        "a:b.stl",
        "x.stl.",
        " x.stl",
    ]);
    if chance.below(2) == 0 {
        let body = json!({ "set": chance.below(10), "name": name }).to_string();
        return Attempt::refused(post(page, "open", body.as_bytes()));
    }
    let encoded: String = name.bytes().map(|byte| format!("%{byte:02X}")).collect();
    let query = match chance.below(5) {
        0 => format!("set=-1&name={encoded}"),
        1 => format!("set=1&set=2&name={encoded}"),
        2 => "set=1&name=%".to_owned(),
        3 => "set=1&name=%ff%fe.stl".to_owned(),
        _ => format!("set=1&name={encoded}"),
    };
    Attempt::refused(post(page, &format!("drop?{query}"), b"solid"))
}

/// Checks that the page still answers its ordinary requests.
fn answers(page: &Page) {
    let documents = page.get("documents").json();
    assert_eq!(documents["documents"][0]["name"], "t-handle.toml");
    assert_eq!(page.get("document/0").json()["kind"], "scenario");
    let moved =
        page.post("motion", motion(SMALL, &json!([{ "set": "body.part[0].mass", "value": "5" }])).as_bytes());
    let moved = moved.json();
    assert_eq!(moved["text"], SMALL.replace("mass = 4", "mass = 5"));
    assert_eq!(moved["motion"]["page"]["body"]["mass"], 5.0);
    assert_eq!(moved["errors"], json!([]));
}

fn is_right(attempt: &Attempt, answer: Option<&Answer>) -> bool {
    let Some(answer) = answer else { return attempt.cut || attempt.expected == Expected::Refusal };
    let is_refused = (400..500).contains(&answer.status);
    // The answer contains no data of this machine.
    let is_silent = !answer.text().contains("root:") && !answer.text().contains("panicked");
    is_silent
        && match attempt.expected {
            Expected::Refusal => is_refused,
            Expected::Errors => {
                let told = (answer.status == 200).then(|| answer.json());
                told.is_some_and(|told| told["motion"].is_null() && told["errors"][0]["message"].is_string())
            }
            Expected::Anything => is_refused || answer.status == 200,
        }
}

/// Returns the resident memory of this process, KiB.
fn resident() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse().ok()
}

static PANICS: AtomicUsize = AtomicUsize::new(0);

#[test]
fn ten_thousand_requests_of_one_who_means_no_good_change_nothing() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        // Panics inside tests are not counted.
        if panic.location().is_some_and(|place| !place.file().contains("tests")) {
            PANICS.fetch_add(1, Ordering::Relaxed);
        }
        usual(panic);
    }));
    let page = Page::open(&[]);
    let mut chance = Chance(7);
    answers(&page);
    let before = resident();
    for batch in 0..20 {
        for k in 0..500 {
            let attempt = KINDS[k % KINDS.len()](&page, &mut chance);
            let answer = page.say(&attempt.bytes, attempt.cut);
            assert!(
                is_right(&attempt, answer.as_ref()),
                "batch {batch}, {k}: {:?}, not {:?}, to {}",
                answer.as_ref().map(|answer| (answer.status, answer.text())),
                attempt.expected,
                String::from_utf8_lossy(&attempt.bytes[..attempt.bytes.len().min(2_000)])
            );
        }
        answers(&page);
    }
    assert_eq!(PANICS.load(Ordering::Relaxed), 0);
    if let (Some(before), Some(after)) = (before, resident()) {
        // Other tests run simultaneously.
        assert!(after < before + (700 << 10), "{before} KiB before, {after} KiB after");
    }
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
            let told = page.post("motion", motion(&text, &json!([])).as_bytes()).json();
            assert!(told["motion"].is_null());
            let message = told["errors"][0]["message"].as_str().unwrap();
            assert!(!message.contains("root:"), "{message}");
        }
    }
}

#[test]
fn many_who_never_end_leave_room_for_one_who_does() {
    use std::io::Write as _;
    use std::net::{SocketAddr, TcpStream};
    let page = Page::open(&[]);
    let address = SocketAddr::from(([127, 0, 0, 1], page.port));
    let begun = |bytes: &[u8]| {
        let mut stream = TcpStream::connect(address).unwrap();
        stream.write_all(bytes).unwrap();
        stream
    };
    let half_heads: Vec<_> = (0..20).map(|_| begun(b"GET / HTT")).collect();
    let half = format!("{}Content-Length: 100\r\n\r\n{{", page.head("POST", "motion"));
    let half_bodies: Vec<_> = (0..20).map(|_| begun(half.as_bytes())).collect();
    answers(&page);
    drop((half_heads, half_bodies));
    answers(&page);
}
