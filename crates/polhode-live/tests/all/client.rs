//! A page served in a thread, and an HTTP client that can send arbitrary bytes.

use std::collections::HashMap;
use std::io::{Read as _, Write as _};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::path::{Path, PathBuf};
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

/// A page that is served until the tests end.
pub(crate) struct Page {
    pub(crate) port: u16,
    pub(crate) token: String,
}

#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) headers: HashMap<String, String>,
    pub(crate) body: Vec<u8>,
}

/// Files of a page.
#[derive(Debug, PartialEq)]
pub(crate) struct Pack {
    pub(crate) open: Vec<String>,
    pub(crate) lesson: Value,
    /// Path and contents of each file.
    pub(crate) files: Vec<(String, Vec<u8>)>,
}

impl Page {
    pub(crate) fn open(files: &[PathBuf]) -> Self {
        Self::of(&LiveOptions { files: files.to_vec(), ..LiveOptions::default() })
    }

    pub(crate) fn of(options: &LiveOptions) -> Self {
        let live = Live::bind(options).unwrap();
        let address = live.address();
        let (port, token) =
            address.strip_prefix("http://127.0.0.1:").unwrap().trim_end_matches('/').split_once('/').unwrap();
        let page = Self { port: port.parse().unwrap(), token: token.to_owned() };
        std::thread::spawn(move || live.run());
        page
    }

    pub(crate) fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(SocketAddr::from(([127, 0, 0, 1], self.port))).unwrap();
        stream.set_nodelay(true).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        stream
    }

    /// Sends bytes and reads the answer to its end. `cut` closes the writing side after the bytes,
    /// like a client that hangs up.
    pub(crate) fn say(&self, bytes: &[u8], cut: bool) -> Option<Answer> {
        let mut stream = self.connect();
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
        format!("{method} /{}/{path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n", self.token, self.port)
    }

    /// Sends a request with more header lines.
    pub(crate) fn request(&self, method: &str, path: &str, more: &str) -> Answer {
        self.say(format!("{}{more}\r\n", self.head(method, path)).as_bytes(), false).unwrap()
    }

    pub(crate) fn get(&self, path: &str) -> Answer {
        self.request("GET", path, "")
    }

    pub(crate) fn pack(&self) -> Pack {
        let answer = self.get("files");
        assert_eq!(
            (answer.status, answer.headers["content-type"].as_str()),
            (200, "application/octet-stream")
        );
        Pack::parse(&answer.body)
    }
}

impl Pack {
    /// Reads a pack. Each byte belongs to the index or to exactly one file.
    pub(crate) fn parse(bytes: &[u8]) -> Self {
        let (length, rest) = bytes.split_first_chunk().unwrap();
        let (index, mut rest) = rest.split_at(u64::from_le_bytes(*length).try_into().unwrap());
        assert_eq!(index.len() % 8, 0);
        let index: Value = serde_json::from_slice(index).unwrap();
        let file = |file: &Value| {
            let (bytes, after) = rest.split_at(file["length"].as_u64().unwrap().try_into().unwrap());
            rest = after;
            (file["path"].as_str().unwrap().to_owned(), bytes.to_vec())
        };
        let files = index["files"].as_array().unwrap().iter().map(file).collect();
        assert!(rest.is_empty());
        let open = index["open"].as_array().unwrap().iter().map(|path| path.as_str().unwrap().to_owned());
        Self { open: open.collect(), lesson: index["lesson"].clone(), files }
    }

    pub(crate) fn paths(&self) -> Vec<&str> {
        self.files.iter().map(|(path, _)| path.as_str()).collect()
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
        let status = lines.next().unwrap().strip_prefix("HTTP/1.1 ").unwrap()[..3].parse().unwrap();
        let headers = lines.map(|line| line.split_once(": ").unwrap());
        let headers: HashMap<_, _> =
            headers.map(|(name, value)| (name.to_owned(), value.to_owned())).collect();
        let answer = Self { status, headers, body: bytes[end + 4..].to_vec() };
        answer.is_kept_to_itself();
        Some(answer)
    }

    /// Checks the security headers.
    fn is_kept_to_itself(&self) {
        for (name, value) in SECURITY {
            assert_eq!(self.headers.get(name).map(String::as_str), Some(value), "{name}: {self:?}");
        }
        assert!(self.headers["content-security-policy"].contains("frame-ancestors 'none'"));
        assert!(self.headers.contains_key("permissions-policy"));
        assert!(!self.headers.contains_key("access-control-allow-origin"));
    }

    pub(crate) fn text(&self) -> String {
        if self.headers["content-type"].ends_with("utf-16le") {
            return utf16(&self.body);
        }
        String::from_utf8_lossy(&self.body).into_owned()
    }
}

/// Returns the text of UTF-16, little-endian.
pub(crate) fn utf16(bytes: &[u8]) -> String {
    let codes: Vec<u16> = bytes.chunks_exact(2).map(|two| u16::from_le_bytes([two[0], two[1]])).collect();
    String::from_utf16(&codes).unwrap()
}

/// Returns the path of a file of the repository.
pub(crate) fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// Temporary folder of this process, removed when dropped.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let name = format!("polhode-live-test-{}-{name}", std::process::id());
        let path = std::fs::canonicalize(std::env::temp_dir()).unwrap().join(name);
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// Writes a file, and the folders in which it is.
    pub(crate) fn file(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, bytes).unwrap();
        path
    }

    /// Returns the path of a file as text.
    pub(crate) fn path(&self, name: &str) -> String {
        self.0.join(name).to_str().unwrap().to_owned()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
