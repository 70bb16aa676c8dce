//! An overloaded server still answers light requests within seconds.

use std::io::{Read as _, Write as _};
use std::net::{SocketAddr, TcpStream};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::client::{Answer, Page};

/// Scenario whose motion is computed in negligible time.
const LIGHT: &str = "[[body.part]]\nshape = \"box\"\nsize = [1, 2, 3]\nmass = 4\n[start]\nspin = { body = [0.1, 0.2, 0.3] }\n[run]\nduration = 1\nsamples = 2\n";

/// Scenario whose motion takes longer than any answer may take: 2·10⁷ rad under a torque. It needs
/// fewer steps than the limit for immediate refusal.
const HEAVY: &str = "[[body.part]]\nshape = \"box\"\nsize = [1, 2, 3]\nmass = 4\n[start]\nspin = { body = [11, 12, 13] }\n[[torque]]\nmodel = \"drag\"\nlaw = \"linear\"\ncoefficient = [1e-9, 2e-9, 1e-9]\n[run]\nduration = 1e6\nsamples = 2\n";

fn motion(text: &str) -> String {
    json!({ "document": 0, "text": text, "edits": [], "error": false, "working": false, "body": null })
        .to_string()
}

fn connect(page: &Page) -> TcpStream {
    TcpStream::connect(SocketAddr::from(([127, 0, 0, 1], page.port))).unwrap()
}

fn within(most: Duration, what: &str, ask: impl FnOnce() -> Answer) -> Value {
    let begun = Instant::now();
    let answer = ask();
    let took = begun.elapsed();
    assert_eq!(answer.status, 200, "{what}: {}", answer.text());
    assert!(took < most, "{what}: {took:?}");
    answer.json()
}

const SECOND: Duration = Duration::from_secs(1);

#[test]
fn two_hundred_half_open_connections_keep_nobody_out() {
    let page = Page::open(&[]);
    let half_open: Vec<TcpStream> = (0..200)
        .map(|k| {
            let mut stream = connect(&page);
            // Some clients have sent nothing, some a part of a head.
            stream
                .write_all(["", "GET / HTT", "GET /0/documents HTTP/1.1\r\nHost: a\r\n"][k % 3].as_bytes())
                .unwrap();
            stream
        })
        .collect();
    within(SECOND, "documents", || page.get("documents"));
    // The oldest connections were closed for new ones; the server still waits for the newest.
    let is_closed = |stream: &TcpStream| {
        let mut stream = stream;
        stream.set_read_timeout(Some(Duration::from_millis(50))).unwrap();
        match stream.read(&mut [0; 16]) {
            Ok(count) => count == 0,
            Err(error) => error.kind() == std::io::ErrorKind::ConnectionReset,
        }
    };
    assert!(half_open[..100].iter().all(is_closed));
    assert!(!is_closed(&half_open[199]));
}

#[test]
fn a_request_in_progress_is_not_closed_for_others() {
    let page = Page::open(&[]);
    let mut busy = connect(&page);
    let body = motion(LIGHT);
    let head = format!("{}Content-Length: {}\r\n\r\n", page.head("POST", "motion"), body.len());
    let (first, rest) = body.split_at(10);
    busy.write_all(format!("{head}{first}").as_bytes()).unwrap();
    // The head is read before the other connections arrive.
    std::thread::sleep(Duration::from_millis(100));
    let others: Vec<TcpStream> = (0..100).map(|_| connect(&page)).collect();
    within(SECOND, "documents", || page.get("documents"));
    busy.write_all(rest.as_bytes()).unwrap();
    busy.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
    let mut answer = Vec::new();
    busy.read_to_end(&mut answer).unwrap();
    assert!(answer.starts_with(b"HTTP/1.1 200"));
    drop(others);
}

#[test]
fn heavy_motions_do_not_stall_light_requests() {
    let page = Page::open(&[]);
    let body = motion(HEAVY);
    let request = format!("{}Content-Length: {}\r\n\r\n{body}", page.head("POST", "motion"), body.len());
    let heavy: Vec<TcpStream> = (0..8)
        .map(|_| {
            let mut stream = connect(&page);
            stream.write_all(request.as_bytes()).unwrap();
            stream
        })
        .collect();
    within(SECOND, "documents", || page.get("documents"));
    let complete = json!({ "document": 0, "text": LIGHT, "at": 3 }).to_string();
    within(SECOND, "complete", || page.post("complete", complete.as_bytes()));
    let moved = within(2 * SECOND, "a light motion", || page.post("motion", motion(LIGHT).as_bytes()));
    assert_eq!(moved["errors"], json!([]));
    assert_eq!(moved["motion"]["page"]["body"]["mass"], 4.0);
    // All of these are still being computed or queued.
    for mut stream in heavy {
        stream.set_nonblocking(true).unwrap();
        let kind = stream.read(&mut [0; 16]).map_err(|error| error.kind());
        assert_eq!(kind, Err(std::io::ErrorKind::WouldBlock));
    }
}

#[test]
fn bodies_that_take_long_do_not_stall_light_requests() {
    let page = Page::open(&[]);
    // The integrals of this density take minutes and precede any motion.
    let density = "density = \"1000 + 500*sin(100000*x*y)*abs(x-y+0.1*z)\"";
    let body = motion(&LIGHT.replace("mass = 4", density));
    let request = format!("{}Content-Length: {}\r\n\r\n{body}", page.head("POST", "motion"), body.len());
    let slow = [(); 4].map(|()| {
        let mut stream = connect(&page);
        stream.write_all(request.as_bytes()).unwrap();
        stream
    });
    std::thread::sleep(Duration::from_millis(100));
    within(4 * SECOND, "a light motion", || page.post("motion", motion(LIGHT).as_bytes()));
    for mut stream in slow {
        stream.set_nonblocking(true).unwrap();
        let kind = stream.read(&mut [0; 16]).map_err(|error| error.kind());
        assert_eq!(kind, Err(std::io::ErrorKind::WouldBlock));
    }
}

#[test]
fn more_heavy_motions_than_may_wait_are_refused() {
    let page = Page::open(&[]);
    let body = motion(HEAVY);
    let request = format!("{}Content-Length: {}\r\n\r\n{body}", page.head("POST", "motion"), body.len());
    let mut heavy: Vec<TcpStream> = (0..24)
        .map(|_| {
            let mut stream = connect(&page);
            stream.write_all(request.as_bytes()).unwrap();
            stream
        })
        .collect();
    // Two of these are computed, and 16 wait.
    let mut refused = 0;
    for stream in &mut heavy {
        stream.set_read_timeout(Some(Duration::from_millis(500))).unwrap();
        let mut answer = [0; 12];
        refused += usize::from(stream.read_exact(&mut answer).is_ok() && &answer == b"HTTP/1.1 503");
    }
    assert_eq!(refused, 6);
    within(SECOND, "documents", || page.get("documents"));
}
