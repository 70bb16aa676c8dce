//! Static files of the page: the build of `viewer/`.

/// Returns the MIME type and the bytes of a file of the page.
pub(crate) fn asset(name: &str) -> Option<(&'static str, &'static [u8])> {
    match name {
        "" => Some(("text/html; charset=utf-8", include_bytes!("../assets/live.html"))),
        "live.js" => Some(("text/javascript; charset=utf-8", include_bytes!("../assets/live.js"))),
        "live.css" => Some(("text/css; charset=utf-8", include_bytes!("../assets/live.css"))),
        _ => None,
    }
}
