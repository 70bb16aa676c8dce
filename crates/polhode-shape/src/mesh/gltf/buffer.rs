//! Buffers: in the GLB, in the document as base64, or in a separate file in its folder.

use std::io;
use std::path::{Component, Path, PathBuf};
use std::rc::Rc;

use base64::engine::general_purpose::{GeneralPurpose, NO_PAD};
use base64::{Engine as _, alphabet};
use polhode_source::file;
use polhode_source::files::{Confined, Files, NotOpened};
use polhode_source::{ContentError, ContentErrorKind};

use super::json::Json;

/// Buffers of a document, each read when it is first needed.
#[derive(Debug)]
pub(crate) struct Buffers<'a> {
    root: Json<'a>,
    chunk: Option<&'a [u8]>,
    from: &'a dyn Files,
    folder: &'a Path,
    loaded: Vec<Option<Bytes<'a>>>,
    files: Vec<(PathBuf, Rc<Vec<u8>>)>,
}

#[derive(Clone, Debug)]
enum Bytes<'a> {
    Here(&'a [u8]),
    Loaded(Rc<Vec<u8>>),
}

/// Buffer view: a range of bytes in a buffer.
#[derive(Clone, Debug)]
pub(crate) struct View<'a> {
    buffer: Bytes<'a>,
    start: usize,
    length: usize,
    /// Distance between elements, bytes, if the view states it.
    pub stride: Option<u64>,
}

impl View<'_> {
    pub(crate) fn bytes(&self) -> &[u8] {
        let all = match &self.buffer {
            Bytes::Here(bytes) => bytes,
            Bytes::Loaded(bytes) => bytes.as_slice(),
        };
        all.get(self.start..).and_then(|rest| rest.get(..self.length)).unwrap_or_default()
    }
}

impl<'a> Buffers<'a> {
    pub(crate) fn new(
        root: Json<'a>,
        chunk: Option<&'a [u8]>,
        from: &'a dyn Files,
        folder: &'a Path,
    ) -> Self {
        let loaded = vec![None; root.count("buffers")];
        Self { root, chunk, from, folder, loaded, files: Vec::new() }
    }

    /// Returns the view with this index.
    pub(crate) fn view(&mut self, index: &Json<'a>) -> Result<View<'a>, ContentError> {
        let (_, view) = index.referred(&self.root, "bufferViews", "buffer view")?;
        if let Some(packed) = view.get("extensions").and_then(|e| e.get("EXT_meshopt_compression")) {
            return Err(packed.error(compressed("EXT_meshopt_compression")).hint(UNPACK));
        }
        let (k, buffer) = view.need("buffer")?.referred(&self.root, "buffers", "buffer")?;
        let declared = buffer.need("byteLength")?.whole()?;
        let bytes = self.buffer(k, &buffer, declared)?;
        let start = view.whole_or("byteOffset", 0)?;
        let length = view.need("byteLength")?.whole()?;
        if start.checked_add(length).is_none_or(|end| end > declared) {
            let kind = ContentErrorKind::count("bytes of the view", length, declared.saturating_sub(start));
            return Err(view.error(kind).hint(format!("buffers[{k}] ends before the view does")));
        }
        let stride = view.get("byteStride").map(|stride| stride.whole()).transpose()?;
        Ok(View { buffer: bytes, start: start as usize, length: length as usize, stride })
    }

    /// Returns the buffer; it must have the declared length.
    fn buffer(&mut self, k: usize, buffer: &Json<'a>, declared: u64) -> Result<Bytes<'a>, ContentError> {
        let bytes = match self.loaded.get(k) {
            Some(Some(bytes)) => bytes.clone(),
            _ => self.load(k, buffer)?,
        };
        let present = match &bytes {
            Bytes::Here(bytes) => bytes.len(),
            Bytes::Loaded(bytes) => bytes.len(),
        };
        if present as u64 >= declared {
            if let Some(slot) = self.loaded.get_mut(k) {
                *slot = Some(bytes.clone());
            }
            return Ok(bytes);
        }
        let kind = ContentErrorKind::count("bytes", declared, present as u64);
        Err(buffer.error(kind).hint("the buffer is truncated"))
    }

    fn load(&mut self, k: usize, buffer: &Json<'a>) -> Result<Bytes<'a>, ContentError> {
        match (buffer.get("uri"), self.chunk) {
            (Some(uri), _) => match uri.text()?.strip_prefix("data:") {
                Some(data) => Ok(Bytes::Loaded(Rc::new(decoded(data, &uri)?))),
                None => Ok(Bytes::Loaded(self.file(&uri)?)),
            },
            (None, Some(chunk)) if k == 0 => Ok(Bytes::Here(chunk)),
            (None, _)
                if buffer.get("extensions").is_some_and(|e| e.get("EXT_meshopt_compression").is_some()) =>
            {
                Err(buffer.error(compressed("EXT_meshopt_compression")).hint(UNPACK))
            }
            (None, _) => Err(buffer.error(ContentErrorKind::missing("uri"))),
        }
    }

    /// Returns the bytes of a file inside the document's folder.
    fn file(&mut self, uri: &Json<'a>) -> Result<Rc<Vec<u8>>, ContentError> {
        let outside = || {
            uri.refused("uri", "a file in the folder of the document, or below it").hint(
            "polhode opens no other files and no addresses: put the buffer next to the .gltf, or export a .glb",
        )
        };
        let failed = |e: &std::io::Error| uri.refused("uri", &format!("a file that can be read ({e})"));
        let path = inside(uri.text()?).ok_or_else(outside)?;
        let files = Confined::within(self.from, [self.folder.to_owned()]);
        let path = files.named(self.folder, &path).map_err(|why| match why {
            NotOpened::Outside => outside(),
            NotOpened::Missing | NotOpened::NotGiven => failed(&io::ErrorKind::NotFound.into()),
            NotOpened::NotRegular => uri.refused("uri", "an ordinary file"),
        })?;
        if let Some((_, bytes)) = self.files.iter().find(|(known, _)| *known == path) {
            return Ok(bytes.clone());
        }
        let read = || {
            let mut file = files.open(&path)?;
            let before = file.look()?;
            file::all(&mut *file, u64::MAX, &before)
        };
        let bytes = read().map_err(|e| failed(&e))?;
        let bytes = Rc::new(bytes);
        self.files.push((path, bytes.clone()));
        Ok(bytes)
    }
}

pub(crate) const UNPACK: &str = "export it without compression, or unpack it first";

pub(crate) fn compressed(name: &str) -> ContentErrorKind {
    ContentErrorKind::unsupported(format!("compressed meshes ({name})"))
}

/// Returns the relative path of a URI; `None` for an absolute URI or a path that leaves the folder.
fn inside(uri: &str) -> Option<PathBuf> {
    let text = percent_decoded(uri)?;
    let has_scheme = |text: &str| text.split('/').next().is_some_and(|first| first.contains(':'));
    if text.is_empty() || has_scheme(uri) || has_scheme(&text) || text.contains(['\\', '\0']) {
        return None;
    }
    let path = PathBuf::from(text);
    path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)).then_some(path)
}

/// Decodes percent escapes: %41 is A. Returns `None` if two hexadecimal digits do not follow, or
/// the result is not UTF-8.
fn percent_decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        let mut digit = || (rest.next()? as char).to_digit(16);
        bytes.push(if byte == b'%' { (digit()? * 16 + digit()?) as u8 } else { byte });
    }
    String::from_utf8(bytes).ok()
}

/// Base64 (RFC 4648 §4) without padding. The unused bits of the last digit may have any value.
static BASE64: GeneralPurpose =
    GeneralPurpose::new(&alphabet::STANDARD, NO_PAD.with_decode_allow_trailing_bits(true));

/// Decodes the data after `data:`; the padding may be missing.
fn decoded(data: &str, uri: &Json<'_>) -> Result<Vec<u8>, ContentError> {
    let text = match data.split_once(',') {
        Some((kind, text)) if kind.ends_with(";base64") => text,
        _ => return Err(uri.refused("uri", "data:…;base64,… for embedded data")),
    };
    let digits = text.trim_end_matches('=').as_bytes();
    BASE64.decode(digits).map_err(|_| {
        let is_digit = |b: &u8| b.is_ascii_alphanumeric() || b"+/".contains(b);
        match digits.iter().enumerate().find(|(_, b)| !is_digit(b)) {
            Some((at, &byte)) => {
                let what = format!("a base64 digit at {at} of the data");
                uri.error(ContentErrorKind::expected(what, char::from(byte).to_string()))
            }
            None => uri.refused("uri", "base64 of whole bytes: there is one digit too many"),
        }
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may")]
mod tests {
    use serde_json::Value;

    use super::{Json, decoded, inside};

    #[test]
    fn base64_may_lack_padding_and_have_any_unused_bits() {
        let null = Value::Null;
        let read = |data: &str| decoded(data, &Json::root(&null)).map_err(|error| error.kind.to_string());
        for data in ["", "=", "===="] {
            assert_eq!(read(&format!(";base64,{data}")), Ok(Vec::new()));
        }
        for data in ["Zm9vYg==", "Zm9vYg=", "Zm9vYg", "Zm9vYh==", "Zm9vYg======="] {
            assert_eq!(read(&format!("application/octet-stream;base64,{data}")).unwrap(), b"foob", "{data}");
        }
        assert_eq!(read(";base64,+/9"), Ok(vec![0xfb, 0xff]));
        for (bad, message) in [
            (";base64,Zg=g", "a base64 digit at 2 of the data"),
            (";base64,Zm 9v?", "a base64 digit at 2 of the data"),
            (";base64,Zm9v-_", "a base64 digit at 4 of the data"),
            (";base64,Z", "one digit too many"),
            (",Zg==", "for embedded data"),
            ("Zg==", "for embedded data"),
        ] {
            assert!(read(bad).unwrap_err().contains(message), "{bad}");
        }
    }

    #[test]
    fn a_path_stays_inside_its_folder() {
        for good in ["a.bin", "./a.bin", "b/a.bin", "a%20b.bin", "..a/b", "a..bin", "b/a:1.bin"] {
            assert!(inside(good).is_some(), "{good}");
        }
        for bad in [
            "",
            "/a.bin",
            "//host/a",
            "../a.bin",
            "b/../../a",
            "b/..",
            "%2e%2e/a",
            "b/%2E%2e/a",
            "%2Fa",
            "a\\b",
            "a%5Cb",
            "http://host/a",
            "file:///a",
            "C:/a",
            "C%3A/a",
            "a%00b",
            "a%2",
            "a%zz",
            "%ff",
        ] {
            assert!(inside(bad).is_none(), "{bad}");
        }
        assert_eq!(inside("a%20b.bin").unwrap().to_str(), Some("a b.bin"));
    }
}
