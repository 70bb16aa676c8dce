//! GLB container: a header of twelve bytes, a JSON chunk, and a binary chunk for the first buffer.

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

/// Document of a glTF file, with its embedded buffer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Container<'a> {
    pub json: &'a [u8],
    pub chunk: Option<&'a [u8]>,
    pub is_binary: bool,
}

/// Opens a GLB or a JSON file.
pub(crate) fn open(bytes: &[u8]) -> Result<Container<'_>, ContentError> {
    if bytes.starts_with(b"glTF") {
        return binary(bytes);
    }
    let json = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    match json.trim_ascii_start().starts_with(b"{") {
        true => Ok(Container { json: bytes, chunk: None, is_binary: false }),
        false => {
            let what = "the { of a .gltf or the \"glTF\" of a .glb";
            let found = String::from_utf8_lossy(&bytes[..bytes.len().min(16)]).into_owned();
            Err(ContentError::new(ContentErrorKind::expected(what, found), at(0, "")))
        }
    }
}

fn binary(bytes: &[u8]) -> Result<Container<'_>, ContentError> {
    let word = |offset: usize| bytes.get(offset..)?.first_chunk().map(|&b| u32::from_le_bytes(b));
    let (Some(version), Some(length)) = (word(4), word(8)) else {
        return Err(short("bytes of the header", 12, bytes.len(), 0));
    };
    if version != 2 {
        let kind = ContentErrorKind::unsupported(format!("version {version} of the GLB container"));
        return Err(ContentError::new(kind, at(4, "the header")).hint("export it as glTF 2.0"));
    }
    if length as usize != bytes.len() {
        return Err(short("bytes in the file", length.into(), bytes.len(), 8));
    }
    let json = match chunk(bytes, 12)? {
        Some((JSON, json)) => json,
        _ => {
            let what = "JSON chunk after the header";
            return Err(ContentError::new(ContentErrorKind::missing(what), at(12, "")));
        }
    };
    let mut offset = 20 + json.len();
    let mut first = None;
    // Chunks of other types are extensions. The buffer is the first binary chunk after the JSON.
    while let Some((kind, contents)) = chunk(bytes, offset)? {
        if kind == BIN && first.is_none() {
            first = Some(contents);
        }
        offset += 8 + contents.len();
    }
    Ok(Container { json, chunk: first, is_binary: true })
}

const JSON: [u8; 4] = *b"JSON";
const BIN: [u8; 4] = *b"BIN\0";

/// Type and contents of a chunk.
type Chunk<'a> = ([u8; 4], &'a [u8]);

/// Returns the chunk at an offset; `None` at the end of the file.
fn chunk(bytes: &[u8], offset: usize) -> Result<Option<Chunk<'_>>, ContentError> {
    let rest = bytes.get(offset..).unwrap_or_default();
    // A remainder shorter than a header is padding.
    let Some((header, rest)) = rest.split_first_chunk::<8>() else { return Ok(None) };
    let [a, b, c, d, kind @ ..] = *header;
    let length = u32::from_le_bytes([a, b, c, d]);
    match rest.get(..length as usize) {
        Some(contents) => Ok(Some((kind, contents))),
        None => Err(short("bytes of the chunk", length.into(), rest.len(), offset)),
    }
}

fn short(what: &str, declared: u64, present: usize, offset: usize) -> ContentError {
    let present = present as u64;
    let kind = ContentErrorKind::count(what, declared, present);
    let hint =
        if declared > present { "the file is truncated" } else { "the file has bytes after the last chunk" };
    ContentError::new(kind, at(offset, "")).hint(hint)
}

fn at(offset: usize, what: &str) -> ContentPlace {
    ContentPlace::Byte { offset: offset as u64, what: what.to_owned() }
}
