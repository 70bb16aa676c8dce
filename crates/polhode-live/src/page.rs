//! The page: one HTML file, with the engine, and with the files or their address.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;

use crate::error::LiveError;
use crate::gather::gather;
use crate::options::LiveOptions;
use crate::pack::Pack;

/// Build of `viewer/`: UTF-16, little-endian, with a byte order mark.
const PAGE: &[u8] = include_bytes!("../assets/polhode.html");

/// Place of the files in the page.
const FILES: &str = "<!--polhode-files-->";

/// Returns the page as one file that contains the files of `options`; the port has no effect.
///
/// The pack of the files is in the page as zlib (RFC 1950): character U+4000 + d for each 15 bits d,
/// the most significant first; `data-length` is the number of bytes. The pack is the length of a
/// JSON index as a little-endian u64; the index, padded with spaces to a multiple of eight bytes;
/// and the contents of the files. The index has the paths to open, the lesson, and the path and
/// length of each file. Paths are relative to the deepest common folder of the files.
///
/// # Errors
/// [`LiveError`] if a file cannot be opened, or is named by an absolute path.
pub fn page(options: &LiveOptions) -> Result<Vec<u8>, LiveError> {
    let pack = Pack::of(&gather(options).1?.relative()?)?;
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    // A vector takes all bytes.
    let written = encoder.write_all(&pack.bytes).and_then(|()| encoder.finish());
    let zlib = written.unwrap_or_default();
    let (length, pack) = (zlib.len(), base_32768(&zlib));
    let script = format!(
        "<script type=\"application/octet-stream\" id=\"polhode-files\" data-length=\"{length}\">{pack}</script>"
    );
    Ok(bytes(&text().replacen(FILES, &script, 1)))
}

/// Returns the page that requests its files from this server.
pub(crate) fn served() -> Vec<u8> {
    let page = text().replacen("connect-src 'none'", "connect-src 'self'", 1);
    bytes(&page.replacen(FILES, "<meta name=\"polhode-files\" content=\"files\">", 1))
}

/// Returns the text of the page, with its byte order mark.
fn text() -> String {
    let codes = PAGE.as_chunks().0.iter().map(|&code| u16::from_le_bytes(code));
    char::decode_utf16(codes).map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}

/// Returns a text as UTF-16, little-endian.
fn bytes(text: &str) -> Vec<u8> {
    text.encode_utf16().flat_map(u16::to_le_bytes).collect()
}

/// Returns a character for each 15 bits. Its bits after the last byte are 0.
fn base_32768(bytes: &[u8]) -> String {
    let digit = |place: usize| {
        let three = [0, 1, 2].map(|k| bytes.get(15 * place / 8 + k).copied().map_or(0, u32::from));
        let bits = three[0] << 16 | three[1] << 8 | three[2];
        char::from_u32(0x4000 + (bits >> (9 - 15 * place % 8) & 0x7fff))
    };
    (0..(8 * bytes.len()).div_ceil(15)).filter_map(digit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_has_one_place_for_files_and_one_for_the_address() {
        assert_eq!([FILES, "connect-src 'none'"].map(|place| text().matches(place).count()), [1, 1]);
    }

    #[test]
    fn the_text_of_the_page_has_its_bytes() {
        assert!(text().starts_with("\u{feff}<!doctype html>") && bytes(&text()) == PAGE);
    }

    #[test]
    fn fifteen_bits_are_a_character() {
        assert_eq!(base_32768(&[]), "");
        assert_eq!(base_32768(&[0x80, 0x03, 0xff]), "\u{8001}\u{bfc0}");
        assert_eq!(base_32768(&[0xff; 15]), "\u{bfff}".repeat(8));
    }
}
