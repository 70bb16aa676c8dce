//! Access control: a request needs the token, and must come from this machine's own page.

use crate::answer::{NOT_FOUND, Refusal};
use crate::head::Head;

/// Conditions that every request must meet.
#[derive(Debug)]
pub(crate) struct Guard {
    token: String,
    port: u16,
}

impl Guard {
    /// Makes a guard with a new random token; `None` if the system provides no random numbers.
    pub(crate) fn new(port: u16) -> Option<Self> {
        let mut bytes = [0; 16];
        getrandom::fill(&mut bytes).ok()?;
        Some(Self { token: bytes.iter().map(|byte| format!("{byte:02x}")).collect(), port })
    }

    /// Returns the address of the page, such as `http://127.0.0.1:41234/0123…/`.
    pub(crate) fn address(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.port, self.token)
    }

    /// Returns the path after the token, if the request is admitted.
    pub(crate) fn admit<'h>(&self, head: &'h Head) -> Result<&'h str, Refusal> {
        let refused = |message| Refusal { status: 403, message };
        // A foreign name that DNS resolves to this address is refused (DNS rebinding).
        let mut hosts = head.all("host");
        let host = hosts.next().filter(|host| self.is_own(host) && hosts.next().is_none());
        let host = host.ok_or(refused("the host of the request is not that of this page"))?;
        let is_own_origin = |origin: &str| origin.strip_prefix("http://") == Some(host);
        if !head.all("origin").all(is_own_origin) {
            return Err(refused("the origin of the request is not that of this page"));
        }
        // Browsers set this header, and pages cannot change it.
        if !head.all("sec-fetch-site").all(|site| matches!(site, "same-origin" | "none")) {
            return Err(refused("the site of the request is not that of this page"));
        }
        if !matches!(head.method.as_str(), "GET" | "HEAD") {
            return Err(Refusal { status: 405, message: "only GET and HEAD are allowed" });
        }
        match head.target.strip_prefix('/').and_then(|path| path.split_once('/')) {
            Some((token, rest)) if is_same(token.as_bytes(), self.token.as_bytes()) => Ok(rest),
            _ => Err(NOT_FOUND),
        }
    }

    fn is_own(&self, host: &str) -> bool {
        let name = host.strip_suffix(&format!(":{}", self.port));
        matches!(name, Some("127.0.0.1" | "localhost"))
    }
}

/// Compares two texts in a time that does not depend on the position of a difference.
fn is_same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).fold(0, |differing, (a, b)| differing | (a ^ b)) == 0
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::head::tests::head;

    fn admitted(guard: &Guard, path: &str, headers: &[(&'static str, &str)]) -> Result<String, u16> {
        let lines = headers.iter().map(|(name, value)| format!("\r\n{name}: {value}"));
        let head = head(&format!("GET {path} HTTP/1.1{}", lines.collect::<String>()));
        guard.admit(&head).map(str::to_owned).map_err(|refusal| refusal.status)
    }

    #[test]
    fn only_this_page_with_its_token_is_admitted() {
        let guard = Guard::new(4000).unwrap();
        let own = format!("/{}/files", guard.token);
        let host = ("host", "127.0.0.1:4000");
        assert_eq!(admitted(&guard, &own, &[host]), Ok("files".to_owned()));
        let with_origin = [
            ("host", "localhost:4000"),
            ("origin", "http://localhost:4000"),
            ("sec-fetch-site", "same-origin"),
        ];
        assert_eq!(admitted(&guard, &own, &with_origin), Ok("files".to_owned()));
        for others in [
            vec![],
            vec![("host", "evil.example:4000")],
            vec![("host", "127.0.0.1")],
            vec![("host", "127.0.0.1:4001")],
            vec![("host", "127.0.0.1:4000.evil.example")],
            vec![host, host],
            vec![host, ("origin", "http://evil.example")],
            vec![host, ("origin", "null")],
            vec![host, ("origin", "https://127.0.0.1:4000")],
            vec![host, ("origin", "http://localhost:4000")],
            vec![host, ("origin", "http://127.0.0.1:4000"), ("origin", "http://evil.example")],
            vec![host, ("sec-fetch-site", "cross-site")],
            vec![host, ("sec-fetch-site", "same-site")],
        ] {
            assert_eq!(admitted(&guard, &own, &others), Err(403), "{others:?}");
        }
        let mut wrong = guard.token.clone();
        wrong.replace_range(31.., if wrong.ends_with('0') { "1" } else { "0" });
        for path in
            [format!("/{wrong}/"), format!("/{}", guard.token), "/".to_owned(), format!("//{}/", guard.token)]
        {
            assert_eq!(admitted(&guard, &path, &[host]), Err(404), "{path}");
        }
        assert_ne!(Guard::new(4000).unwrap().token, guard.token);
    }
}
