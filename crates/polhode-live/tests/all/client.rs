//! A page served in a thread, and an HTTP client that can send arbitrary bytes.

use std::collections::HashMap;
use std::io::{Read as _, Write as _};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

use polhode_live::{Live, LiveOptions};
use serde_json::Value;

/// Security headers that every answer of the page has.
const SECURITY: [(&str, &str); 6] = [
    ("x-content-type-options", "nosniff"),
    ("x-frame-options", "DENY"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-resource-policy", "same-origin"),
    ("cross-origin-opener-policy", "same-origin"),
    ("cache-control", "no-store"),
];

/// A page that is served until this value is dropped.
pub(crate) struct Page {
    pub(crate) port: u16,
    pub(crate) token: String,
    goes_on: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) headers: HashMap<String, String>,
    pub(crate) body: Vec<u8>,
}

impl Page {
    pub(crate) fn open(files: &[PathBuf]) -> Self {
        let live = Live::bind(&LiveOptions { port: 0, files: files.to_vec(), lesson: None }).unwrap();
        let address = live.address();
        let (authority, token) =
            address.strip_prefix("http://127.0.0.1:").unwrap().trim_end_matches('/').split_once('/').unwrap();
        let (port, token) = (authority.parse().unwrap(), token.to_owned());
        let goes_on = Arc::new(AtomicBool::new(true));
        let flag = goes_on.clone();
        let thread = Some(std::thread::spawn(move || live.run_while(&flag).unwrap()));
        Self { port, token, goes_on, thread }
    }

    /// Sends bytes and reads the answer to its end. `cut` closes the writing side after the bytes,
    /// like a client that hangs up.
    pub(crate) fn say(&self, bytes: &[u8], cut: bool) -> Option<Answer> {
        let mut stream = TcpStream::connect(SocketAddr::from(([127, 0, 0, 1], self.port))).unwrap();
        stream.set_nodelay(true).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        // The server may close the connection before it has read everything.
        let _ = stream.write_all(bytes);
        if cut {
            let _ = stream.shutdown(Shutdown::Write);
        }
        let mut heard = Vec::new();
        if let Err(error) = stream.read_to_end(&mut heard) {
            assert!(error.kind() == std::io::ErrorKind::ConnectionReset, "no answer in time: {error}");
        }
        Answer::parse(&heard)
    }

    pub(crate) fn head(&self, method: &str, path: &str) -> String {
        format!(
            "{method} /{}/{path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n",
            self.token, self.port
        )
    }

    pub(crate) fn get(&self, path: &str) -> Answer {
        self.say(format!("{}\r\n", self.head("GET", path)).as_bytes(), false).unwrap()
    }

    pub(crate) fn post(&self, path: &str, body: &[u8]) -> Answer {
        let head = format!("{}Content-Length: {}\r\n\r\n", self.head("POST", path), body.len());
        self.say(&[head.as_bytes(), body].concat(), false).unwrap()
    }

    /// Drops a file into a set of dropped files.
    pub(crate) fn drop_file(&self, set: u32, name: &str, bytes: &[u8]) -> Answer {
        let encoded: String = name.bytes().map(|byte| format!("%{byte:02x}")).collect();
        self.post(&format!("drop?set={set}&name={encoded}"), bytes)
    }

    /// Opens a file of a set of dropped files.
    pub(crate) fn open_dropped(&self, set: u32, name: &str) -> Answer {
        self.post("open", serde_json::json!({ "set": set, "name": name }).to_string().as_bytes())
    }

    /// Drops and opens a file; returns its document.
    pub(crate) fn dropped(&self, set: u32, name: &str, bytes: &[u8]) -> Value {
        assert_eq!(self.drop_file(set, name, bytes).status, 200);
        let opened = self.open_dropped(set, name);
        assert_eq!(opened.status, 200, "{}", opened.text());
        self.document(&opened.json()["id"])
    }

    pub(crate) fn document(&self, id: &Value) -> Value {
        let answer = self.get(&format!("document/{id}"));
        assert_eq!(answer.status, 200, "{}", answer.text());
        answer.json()
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        self.goes_on.store(false, Ordering::Relaxed);
        let ended = self.thread.take().map(JoinHandle::join);
        assert!(std::thread::panicking() || matches!(ended, Some(Ok(()))));
    }
}

impl Answer {
    /// Parses an answer; `None` for a connection closed without an answer.
    fn parse(bytes: &[u8]) -> Option<Self> {
        if bytes.is_empty() {
            return None;
        }
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").unwrap();
        let head = std::str::from_utf8(&bytes[..end]).unwrap();
        let mut lines = head.split("\r\n");
        let status = lines.next().unwrap().strip_prefix("HTTP/1.").unwrap()[2..5].parse().unwrap();
        let headers = lines.map(|line| line.split_once(": ").unwrap());
        let headers: HashMap<_, _> =
            headers.map(|(name, value)| (name.to_owned(), value.to_owned())).collect();
        let answer = Self { status, headers, body: bytes[end + 4..].to_vec() };
        answer.is_kept_to_itself();
        Some(answer)
    }

    /// Checks the security headers. An empty answer must have a status for invalid HTTP.
    fn is_kept_to_itself(&self) {
        if self.headers.get("content-length").map(String::as_str) == Some("0") && self.body.is_empty() {
            assert!(matches!(self.status, 400 | 414 | 431), "{self:?}");
            return;
        }
        for (name, value) in SECURITY {
            assert_eq!(self.headers.get(name).map(String::as_str), Some(value), "{name}: {self:?}");
        }
        assert!(self.headers["content-security-policy"].starts_with("default-src 'none'"));
        assert!(self.headers.contains_key("permissions-policy"));
        assert!(!self.headers.contains_key("access-control-allow-origin"));
    }

    pub(crate) fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }

    pub(crate) fn json(&self) -> Value {
        match self.headers["content-type"].as_str() {
            "application/octet-stream" => self.json_with_rows(),
            _ => serde_json::from_slice(&self.body).unwrap(),
        }
    }

    /// Reads JSON followed by rows of numbers, and inserts the rows at their places. Each number
    /// must belong to exactly one row.
    fn json_with_rows(&self) -> Value {
        let (length, rest) = self.body.split_first_chunk().unwrap();
        let (head, rows) = rest.split_at(u64::from_le_bytes(*length).try_into().unwrap());
        assert_eq!(head.len() % 8, 0, "the rows are aligned");
        let mut left: Vec<_> = rows.iter().copied().map(Some).collect();
        let mut value = serde_json::from_slice(head).unwrap();
        put_rows(&mut value, &mut left);
        assert!(left.iter().all(Option::is_none), "a row is of nothing");
        value
    }
}

fn put_rows(value: &mut Value, left: &mut [Option<u8>]) {
    fn row<const N: usize>(
        place: &Value,
        left: &mut [Option<u8>],
        number: impl Fn([u8; N]) -> Value,
    ) -> Value {
        let [at, count] = [0, 1].map(|k| usize::try_from(place[k].as_u64().unwrap()).unwrap());
        let words = left[N * at..N * (at + count)].as_chunks_mut().0.iter_mut();
        words
            .map(|word: &mut [_; N]| number(std::mem::replace(word, [None; N]).map(Option::unwrap)))
            .collect()
    }
    *value = match value {
        Value::Array(items) => return items.iter_mut().for_each(|item| put_rows(item, left)),
        Value::Object(entries) => match entries.iter().next() {
            Some((kind, place)) if kind == "f64" => row(place, left, |x| f64::from_le_bytes(x).into()),
            Some((kind, place)) if kind == "f32" => row(place, left, |x| f32::from_le_bytes(x).into()),
            Some((kind, place)) if kind == "u32" => row(place, left, |x| u32::from_le_bytes(x).into()),
            _ => return entries.values_mut().for_each(|entry| put_rows(entry, left)),
        },
        _ => return,
    };
}

/// Returns the path of a file of the repository.
pub(crate) fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// Temporary folder of this process, removed when dropped.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("polhode-live-test-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn file(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Returns the f32 numbers of an array, or of a base64 text.
pub(crate) fn f32s(value: &Value) -> Vec<f32> {
    match value {
        Value::Array(_) => f64s(value).into_iter().map(|x| x as f32).collect(),
        _ => words(value).into_iter().map(f32::from_le_bytes).collect(),
    }
}

/// Returns the u32 numbers of an array, or of a base64 text.
pub(crate) fn u32s(value: &Value) -> Vec<u32> {
    match value.as_array() {
        Some(numbers) => numbers.iter().map(|x| x.as_u64().unwrap().try_into().unwrap()).collect(),
        None => words(value).into_iter().map(u32::from_le_bytes).collect(),
    }
}

/// Returns the f64 numbers of an array.
pub(crate) fn f64s(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn words<const N: usize>(value: &Value) -> Vec<[u8; N]> {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut value_of = [0_u32; 256];
    (0..).zip(DIGITS).for_each(|(k, &digit)| value_of[usize::from(digit)] = k);
    let mut bytes = Vec::new();
    for four in value.as_str().unwrap().as_bytes().chunks(4) {
        let bits = four.iter().fold(0, |bits, &digit| bits << 6 | value_of[usize::from(digit)]);
        let padding = four.iter().filter(|digit| **digit == b'=').count();
        bytes.extend_from_slice(&bits.to_be_bytes()[1..4 - padding]);
    }
    assert_eq!(bytes.len() % N, 0);
    bytes.chunks(N).map(|word| word.try_into().unwrap()).collect()
}
