//! A hostile client sends ten thousand requests that no page sends; the server still answers as
//! before.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::chance::Chance;
use crate::client::{Answer, Page, repository};

/// A request that is refused, or has no answer.
struct Attempt {
    bytes: Vec<u8>,
    /// True if the client hangs up after the bytes.
    cut: bool,
}

impl Attempt {
    const fn refused(bytes: Vec<u8>) -> Self {
        Self { bytes, cut: false }
    }

    const fn cut(bytes: Vec<u8>) -> Self {
        Self { bytes, cut: true }
    }
}

/// Generator of requests of one kind.
type Kind = fn(&Page, &mut Chance) -> Attempt;

const KINDS: [Kind; 8] = [request_lines, headers, strangers, tokens, paths, lengths, chunks, heads_cut];

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
    let path = chance.of(&["files", ""]);
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
    Attempt::refused(format!("GET /{token}/files HTTP/1.1\r\n{host}\r\n").into_bytes())
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
    path += chance.of(&["etc/passwd", "files", "Cargo.toml", "", "polhode.html", "index.html"]);
    let names = ["files/", "files?", "?", "Files", "files%20", "%66iles", "polhode.html"];
    let path = if chance.below(4) == 0 { chance.of(&names).to_owned() } else { path };
    Attempt::refused(format!("{}\r\n", page.head("GET", &path)).into_bytes())
}

fn lengths(page: &Page, chance: &mut Chance) -> Attempt {
    let head = page.head(chance.of(&["POST", "GET"]), chance.of(&["files", ""]));
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
    let head = page.head(chance.of(&["POST", "GET"]), chance.of(&["files", ""]));
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

fn heads_cut(page: &Page, chance: &mut Chance) -> Attempt {
    let head = page.head("GET", chance.of(&["files", ""]));
    Attempt::cut(head.as_bytes()[..chance.below(head.len())].to_vec())
}

/// Checks that the page still answers its ordinary requests.
fn answers(page: &Page) {
    assert!(page.get("").text().contains("polhode-files"));
    assert_eq!(page.pack().open, [page.pack().files[0].0.as_str()]);
}

/// Returns the number of open files and connections of this process.
fn open_files() -> Option<usize> {
    Some(std::fs::read_dir("/proc/self/fd").ok()?.count())
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
    let page = Page::open(&[repository("examples/t-handle.toml")]);
    let mut chance = Chance(7);
    answers(&page);
    let before = open_files();
    for batch in 0..20 {
        for k in 0..500 {
            let attempt = KINDS[k % KINDS.len()](&page, &mut chance);
            let answer = page.say(&attempt.bytes, attempt.cut);
            let is_refused =
                |answer: &Answer| (400..500).contains(&answer.status) && !answer.text().contains("root:");
            assert!(
                answer.as_ref().map_or(attempt.cut, is_refused),
                "batch {batch}, {k}: {:?} to {}",
                answer.as_ref().map(|answer| (answer.status, answer.text())),
                String::from_utf8_lossy(&attempt.bytes[..attempt.bytes.len().min(2_000)])
            );
        }
        answers(&page);
    }
    assert_eq!(PANICS.load(Ordering::Relaxed), 0);
    if let (Some(before), Some(after)) = (before, open_files()) {
        // Other tests run simultaneously; one of them opens 200 connections.
        assert!(after < before + 500, "{before} open files before, {after} after");
    }
}
