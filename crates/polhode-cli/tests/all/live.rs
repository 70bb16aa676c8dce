//! `polhode live`: refused arguments, pages as files, and termination on request. The pages are
//! tested in a browser (`viewer/test/`).

use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::process::Stdio;

use crate::common::{Scratch, example, stdout};

#[test]
fn lessons_are_listed_and_what_has_nothing_to_do_beside_is_refused() {
    let scratch = Scratch::new("live-lessons");
    let list = stdout(&scratch.run(&["live", "--lesson"]));
    assert!(list.lines().count() >= 20 && list.contains("racket"), "{list}");
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    for (arguments, said) in [
        (&["--lesson", "--no-open"][..], "--no-open has no effect"),
        (&["--port", "8000", "--lesson"], "--port has no effect"),
        (&["--lesson", "nothing-of-the-kind"], "nothing-of-the-kind"),
        (&["--lesson", "cube", &example("t-handle.toml")], "cannot be used with"),
        (&["missing.toml"], "\"missing.toml\" cannot be read"),
        (&["--no-open", "--port", &port], "cannot listen on 127.0.0.1"),
        (&["--port", "70000"], "70000"),
        (&["--lesson", "--output", "a.html"], "--output has no effect"),
        (&["--output", "a.html", "--no-open"], "cannot be used with"),
        (&["--output", "a.html", "--port", "8000"], "cannot be used with"),
        (&["--output", "a.toml"], "a.toml is not the name of a page"),
        (&["--output", "a.html", "missing.toml"], "\"missing.toml\" cannot be read"),
        (&["--force"], "--output"),
    ] {
        let refused = scratch.run(&[&["live"], arguments].concat());
        let error = String::from_utf8(refused.stderr).unwrap();
        assert_eq!(refused.status.code(), Some(2), "{arguments:?}: {error}");
        assert!(error.contains(said) && refused.stdout.is_empty(), "{arguments:?}: {error}");
    }
    assert_eq!(scratch.entries(), [""; 0]);
}

#[test]
fn a_page_is_written_and_replaced_only_on_request() {
    let scratch = Scratch::new("live-output");
    let arguments = ["live", &example("t-handle.toml"), "--output", "page.html"];
    assert_eq!(stdout(&scratch.run(&arguments)), "wrote page.html\n");
    let page = fs::read(scratch.0.join("page.html")).unwrap();
    let has = |text: &str| {
        let text: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        page.windows(text.len()).any(|part| part == text)
    };
    assert!(has("id=\"polhode-files\"") && !has("<!--polhode-files-->"));
    fs::write(scratch.0.join("page.html"), "other").unwrap();
    let refused = scratch.run(&arguments);
    let error = String::from_utf8(refused.stderr).unwrap();
    assert!(refused.status.code() == Some(2) && error.contains("page.html already exists"), "{error}");
    assert_eq!(fs::read_to_string(scratch.0.join("page.html")).unwrap(), "other");
    stdout(&scratch.run(&[&arguments[..], &["--force"]].concat()));
    assert!(fs::read(scratch.0.join("page.html")).unwrap() == page);
}

#[test]
#[cfg(unix)]
fn it_serves_until_it_is_told_to_end() {
    let scratch = Scratch::new("live-serves");
    let mut command = scratch.command(&["live", &example("t-handle.toml"), "--no-open"]);
    let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
    let mut address = String::new();
    BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut address).unwrap();
    let (host, path) = address.trim().strip_prefix("http://").unwrap().split_once('/').unwrap();
    let mut stream = TcpStream::connect(host).unwrap();
    write!(stream, "GET /{path}files HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").unwrap();
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).unwrap();
    let answer = String::from_utf8_lossy(&answer);
    assert!(answer.starts_with("HTTP/1.1 200") && answer.contains("t-handle.toml"), "{answer}");
    // Where a shell has started the tests in the background, SIGINT is ignored.
    let told = std::process::Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap();
    let ended = child.wait().unwrap();
    assert_eq!((told.success(), std::os::unix::process::ExitStatusExt::signal(&ended)), (true, Some(15)));
}
