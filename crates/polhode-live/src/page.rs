//! The page: one HTML file, with the engine, and with the files or their address.

use std::io::Write as _;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use flate2::Compression;
use flate2::write::ZlibEncoder;

use crate::error::LiveError;
use crate::gather::gather;
use crate::options::LiveOptions;
use crate::pack::Pack;

/// Build of `viewer/`.
const PAGE: &str = include_str!("../assets/polhode.html");

/// Place of the files in the page.
const FILES: &str = "<!--polhode-files-->";

/// Returns the page as one file that contains the files of `options`; the port has no effect.
///
/// The pack of the files is in the page as zlib (RFC 1950) in base64. It is the length of a JSON
/// index as a little-endian u64; the index, padded with spaces to a multiple of eight bytes; and the
/// contents of the files. The index has the paths to open, the lesson, and the path and length of
/// each file. Paths are relative to the deepest common folder of the files.
///
/// # Errors
/// [`LiveError`] if a file cannot be opened, or is named by an absolute path.
pub fn page(options: &LiveOptions) -> Result<Vec<u8>, LiveError> {
    let pack = Pack::of(&gather(options).1?.relative()?)?;
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    // A vector takes all bytes.
    let written = encoder.write_all(&pack.bytes).and_then(|()| encoder.finish());
    let pack = BASE64_STANDARD.encode(written.unwrap_or_default());
    let script = format!("<script type=\"application/octet-stream\" id=\"polhode-files\">{pack}</script>");
    Ok(PAGE.replacen(FILES, &script, 1).into_bytes())
}

/// Returns the page that requests its files from this server.
pub(crate) fn served() -> Vec<u8> {
    let page = PAGE.replacen("connect-src 'none'", "connect-src 'self'", 1);
    page.replacen(FILES, "<meta name=\"polhode-files\" content=\"files\">", 1).into_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_has_one_place_for_files_and_one_for_the_address() {
        assert_eq!([FILES, "connect-src 'none'"].map(|text| PAGE.matches(text).count()), [1, 1]);
    }
}
