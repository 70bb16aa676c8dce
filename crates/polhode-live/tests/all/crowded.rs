//! A server with many connections still answers within a second.

use std::io::{ErrorKind, Read as _, Write as _};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use crate::client::{Folder, Page};
use crate::models::SCENARIO;

const SECOND: Duration = Duration::from_secs(1);

#[track_caller]
fn answers_soon(page: &Page) {
    let begun = Instant::now();
    assert_eq!(page.get("").status, 200);
    assert!(begun.elapsed() < SECOND, "{:?}", begun.elapsed());
}

#[test]
fn two_hundred_half_open_connections_keep_nobody_out() {
    let page = Page::open(&[]);
    let half_open: Vec<TcpStream> = (0..200)
        .map(|k| {
            let mut stream = page.connect();
            // Some clients have sent nothing, some a part of a head.
            let part = ["", "GET / HTT", "GET /0/files HTTP/1.1\r\nHost: a\r\n"][k % 3];
            // The oldest of them may be closed already.
            let _ = stream.write_all(part.as_bytes());
            stream
        })
        .collect();
    answers_soon(&page);
    // The oldest connections were closed for new ones; the server still waits for the newest.
    let is_closed = |stream: &TcpStream| {
        let mut stream = stream;
        stream.set_read_timeout(Some(Duration::from_millis(50))).unwrap();
        match stream.read(&mut [0; 16]) {
            Ok(count) => count == 0,
            Err(error) => error.kind() == ErrorKind::ConnectionReset,
        }
    };
    assert!(half_open[..100].iter().all(is_closed));
    assert!(!is_closed(&half_open[199]));
}

#[test]
fn an_answer_in_progress_is_not_closed_for_others() {
    // The pack is larger than the buffers of a connection.
    let folder = Folder::new("crowded");
    let comment = format!("# {}\n", "x".repeat(40 << 20));
    let page = Page::open(&[folder.file("long.toml", format!("{comment}{SCENARIO}"))]);
    let mut slow = page.connect();
    slow.write_all(format!("{}\r\n", page.head("GET", "files")).as_bytes()).unwrap();
    let mut first = [0; 12];
    slow.read_exact(&mut first).unwrap();
    assert_eq!(&first, b"HTTP/1.1 200");
    let others: Vec<TcpStream> = (0..100).map(|_| page.connect()).collect();
    answers_soon(&page);
    let mut rest = Vec::new();
    slow.read_to_end(&mut rest).unwrap();
    assert!(rest.len() > comment.len() && rest.ends_with(SCENARIO.as_bytes()));
    drop(others);
}

#[test]
fn a_head_that_takes_too_long_is_not_waited_for() {
    let page = Page::open(&[]);
    let mut slow = page.connect();
    let begun = Instant::now();
    for byte in page.head("GET", "files").bytes().cycle() {
        std::thread::sleep(Duration::from_millis(200));
        if slow.write_all(&[byte]).is_err() {
            break;
        }
    }
    let took = begun.elapsed();
    assert!(took > 9 * SECOND && took < 15 * SECOND, "{took:?}");
}
