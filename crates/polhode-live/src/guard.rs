//! Access control: a request needs the token, and must come from this machine's own page.

use hyper::header::{HOST, HeaderMap, ORIGIN};
use hyper::{Method, StatusCode, Uri, Version};

use crate::answer::Refusal;

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
    pub(crate) fn admit<'u>(
        &self,
        method: &Method,
        uri: &'u Uri,
        version: Version,
        headers: &HeaderMap,
    ) -> Result<&'u str, Refusal> {
        let refused = |what: &str| {
            Refusal::new(StatusCode::FORBIDDEN, format!("{what} of the request is not that of this page"))
        };
        if version > Version::HTTP_11 || uri.scheme().is_some() || uri.authority().is_some() {
            return Err(Refusal::new(
                StatusCode::BAD_REQUEST,
                "the request is not an HTTP/1.1 request for a page",
            ));
        }
        // A foreign name that DNS resolves to this address is refused (DNS rebinding).
        let mut hosts = headers.get_all(HOST).iter();
        let host = hosts.next().and_then(|host| host.to_str().ok()).ok_or_else(|| refused("the host"))?;
        if hosts.next().is_some() || !self.is_own(host) {
            return Err(refused("the host"));
        }
        for origin in headers.get_all(ORIGIN) {
            let own = origin.to_str().ok().and_then(|origin| origin.strip_prefix("http://"));
            if !own.is_some_and(|origin| self.is_own(origin) && origin == host) {
                return Err(refused("the origin"));
            }
        }
        // Browsers set this header, and pages cannot change it.
        for site in headers.get_all("sec-fetch-site") {
            if !matches!(site.to_str(), Ok("same-origin" | "none")) {
                return Err(refused("the site"));
            }
        }
        if !matches!(*method, Method::GET | Method::POST) {
            return Err(Refusal::new(StatusCode::METHOD_NOT_ALLOWED, "only GET and POST are allowed"));
        }
        let path = uri.path().strip_prefix('/').unwrap_or_default();
        match path.split_once('/') {
            Some((token, rest)) if is_same(token.as_bytes(), self.token.as_bytes()) => Ok(rest),
            _ => Err(Refusal::not_found()),
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

    fn admitted(guard: &Guard, path: &str, headers: &[(&'static str, &str)]) -> Result<String, StatusCode> {
        let mut map = HeaderMap::new();
        for (name, value) in headers {
            map.append(*name, value.parse().unwrap());
        }
        let uri: Uri = path.parse().unwrap();
        let rest = guard.admit(&Method::GET, &uri, Version::HTTP_11, &map);
        rest.map(str::to_owned).map_err(|refusal| refusal.status)
    }

    #[test]
    fn only_this_page_with_its_token_is_admitted() {
        let guard = Guard::new(4000).unwrap();
        let own = format!("/{}/motion", guard.token);
        let host = ("host", "127.0.0.1:4000");
        assert_eq!(admitted(&guard, &own, &[host]), Ok("motion".to_owned()));
        let with_origin = [
            ("host", "localhost:4000"),
            ("origin", "http://localhost:4000"),
            ("sec-fetch-site", "same-origin"),
        ];
        assert_eq!(admitted(&guard, &own, &with_origin), Ok("motion".to_owned()));
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
            assert_eq!(admitted(&guard, &own, &others), Err(StatusCode::FORBIDDEN), "{others:?}");
        }
        let mut wrong = guard.token.clone();
        wrong.replace_range(31.., if wrong.ends_with('0') { "1" } else { "0" });
        for path in
            [format!("/{wrong}/"), format!("/{}", guard.token), "/".to_owned(), format!("//{}/", guard.token)]
        {
            assert_eq!(admitted(&guard, &path, &[host]), Err(StatusCode::NOT_FOUND), "{path}");
        }
        assert_ne!(Guard::new(4000).unwrap().token, guard.token);
    }
}
