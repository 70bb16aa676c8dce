//! Head of a request: its method, its target and its headers (RFC 9112).

use std::io::Read as _;
use std::net::TcpStream;
use std::time::Instant;

use crate::answer::Refusal;
use crate::limits;

/// Head of a request.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Head {
    pub(crate) method: String,
    pub(crate) target: String,
    /// Names in lower case, and values.
    headers: Vec<(String, String)>,
}

const END: &[u8] = b"\r\n\r\n";

impl Head {
    /// Reads a head. Returns `None` if the client hangs up, or does not send it in time.
    pub(crate) fn read(stream: &mut TcpStream) -> Option<Result<Self, Refusal>> {
        let end = Instant::now() + limits::HEAD_TIME;
        let (mut bytes, mut chunk) = (Vec::new(), [0; 4096]);
        loop {
            let left = end.checked_duration_since(Instant::now()).filter(|left| !left.is_zero())?;
            stream.set_read_timeout(Some(left)).ok()?;
            let count = stream.read(&mut chunk).ok().filter(|count| *count > 0)?;
            let searched = bytes.len().saturating_sub(END.len() - 1);
            bytes.extend_from_slice(chunk.get(..count)?);
            let found = bytes.get(searched..)?.windows(END.len()).position(|four| four == END);
            match found.map_or(bytes.len(), |at| searched + at) {
                length if length > limits::HEAD => {
                    return Some(Err(Refusal {
                        status: 431,
                        message: "the headers of the request are too large",
                    }));
                }
                length if found.is_some() => return Some(Self::parse(bytes.get(..length)?)),
                _ => {}
            }
        }
    }

    /// Parses a head without the empty line at its end. A request with a body is refused.
    fn parse(bytes: &[u8]) -> Result<Self, Refusal> {
        let bad = Refusal { status: 400, message: "the request is not an HTTP/1.1 request for a page" };
        let text = std::str::from_utf8(bytes).map_err(|_| bad)?;
        let mut lines = text.split("\r\n");
        if lines.clone().any(|line| line.contains(|c: char| c.is_control() && c != '\t')) {
            return Err(bad);
        }
        let words: Vec<&str> = lines.next().unwrap_or_default().split(' ').collect();
        let [method, target, "HTTP/1.1" | "HTTP/1.0"] = words.as_slice() else { return Err(bad) };
        if !is_token(method) || !target.starts_with('/') {
            return Err(bad);
        }
        let headers = lines.map(|line| {
            let (name, value) = line.split_once(':').filter(|(name, _)| is_token(name)).ok_or(bad)?;
            Ok((name.to_ascii_lowercase(), value.trim_matches([' ', '\t']).to_owned()))
        });
        let headers: Vec<_> = headers.collect::<Result<_, Refusal>>()?;
        if headers.len() > limits::HEADERS {
            return Err(Refusal { status: 431, message: "the request has too many headers" });
        }
        let head = Self { method: (*method).to_owned(), target: (*target).to_owned(), headers };
        if head.all("transfer-encoding").next().is_some()
            || head.all("content-length").any(|length| length != "0")
        {
            return Err(Refusal { status: 413, message: "a request for a page has no body" });
        }
        Ok(head)
    }

    /// Returns the values of all headers with a name in lower case.
    pub(crate) fn all<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a str> {
        self.headers.iter().filter(move |(own, _)| own == name).map(|(_, value)| value.as_str())
    }
}

/// Returns true for a token (RFC 9110, section 5.6.2).
fn is_token(text: &str) -> bool {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"!#$%&'*+-.^_`|~".contains(&byte);
    !text.is_empty() && text.bytes().all(is_plain)
}

#[cfg(test)]
pub(crate) mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    pub(crate) fn head(text: &str) -> Head {
        Head::parse(text.as_bytes()).unwrap()
    }

    #[test]
    fn a_head_is_one_line_and_its_headers() {
        let head = head("HEAD /a/files HTTP/1.0\r\nHost:127.0.0.1:80 \r\nIf-None-Match:\t\"7\"");
        assert_eq!((head.method.as_str(), head.target.as_str()), ("HEAD", "/a/files"));
        assert_eq!(head.all("host").collect::<Vec<_>>(), ["127.0.0.1:80"]);
        assert_eq!(head.all("if-none-match").collect::<Vec<_>>(), ["\"7\""]);
        for (wrong, status) in [
            ("GET / HTTP/1.1\r\nTransfer-Encoding: chunked", 413),
            ("GET / HTTP/1.1\r\nContent-Length: 1", 413),
            ("GET / HTTP/2", 400),
            ("GET  / HTTP/1.1", 400),
            ("GET http://127.0.0.1/ HTTP/1.1", 400),
            ("GET / HTTP/1.1\r\nHost : a", 400),
            ("GET / HTTP/1.1\r\nA: b\r\n c", 400),
            ("GET / HTTP/1.1\nA: b", 400),
            ("GET / HTTP/1.1\r\nA: b\rc", 400),
            ("GET / HTTP/1.1\r\nA", 400),
            ("G\0T / HTTP/1.1", 400),
            ("", 400),
            (&format!("GET / HTTP/1.1{}", "\r\na: b".repeat(101)), 431),
        ] {
            assert_eq!(Head::parse(wrong.as_bytes()).unwrap_err().status, status, "{wrong}");
        }
    }
}
