//! Buffers: bytes beside the document, in the GLB, in the document as base64, or in a file of its folder.

use std::fs::File;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::rc::Rc;

use super::json::Json;
use crate::confinement::{Confinement, NotOpened};
use crate::content::{ContentError, ContentErrorKind};
use crate::file;

/// The buffers of a document, each read when it is first needed.
#[derive(Debug)]
pub(super) struct Buffers<'a> {
    root: Json<'a>,
    chunk: Option<&'a [u8]>,
    folder: &'a Path,
    loaded: Vec<Option<Bytes<'a>>>,
    files: Vec<(PathBuf, Rc<Vec<u8>>)>,
}

#[derive(Clone, Debug)]
enum Bytes<'a> {
    Here(&'a [u8]),
    Loaded(Rc<Vec<u8>>),
}

/// A part of a buffer.
#[derive(Clone, Debug)]
pub(super) struct View<'a> {
    buffer: Bytes<'a>,
    start: usize,
    length: usize,
    /// From one element to the next, if the view says so.
    pub(super) stride: Option<u64>,
}

impl View<'_> {
    pub(super) fn bytes(&self) -> &[u8] {
        let all = match &self.buffer {
            Bytes::Here(bytes) => bytes,
            Bytes::Loaded(bytes) => bytes.as_slice(),
        };
        all.get(self.start..).and_then(|rest| rest.get(..self.length)).unwrap_or_default()
    }
}

impl<'a> Buffers<'a> {
    pub(super) fn new(root: Json<'a>, chunk: Option<&'a [u8]>, folder: &'a Path) -> Self {
        let loaded = vec![None; root.count("buffers")];
        Self { root, chunk, folder, loaded, files: Vec::new() }
    }

    /// The view that this value, an index, means.
    pub(super) fn view(&mut self, index: &Json<'a>) -> Result<View<'a>, ContentError> {
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
            let kind = ContentErrorKind::Count {
                what: "bytes of the view".to_owned(),
                declared: length,
                present: declared.saturating_sub(start),
            };
            return Err(view.error(kind).hint(format!("buffers[{k}] ends before the view does")));
        }
        let stride = view.get("byteStride").map(|stride| stride.whole()).transpose()?;
        Ok(View { buffer: bytes, start: start as usize, length: length as usize, stride })
    }

    /// All the bytes that the buffer declares.
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
        let kind = ContentErrorKind::Count { what: "bytes".to_owned(), declared, present: present as u64 };
        Err(buffer.error(kind).hint("the buffer is cut short"))
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
            (None, _) => Err(buffer.error(ContentErrorKind::Missing { what: "uri".to_owned() })),
        }
    }

    /// The bytes of a file inside the document's folder.
    fn file(&mut self, uri: &Json<'a>) -> Result<Rc<Vec<u8>>, ContentError> {
        let outside = || {
            uri.refused("uri", "a file in the folder of the document, or below it").hint(
            "polhode opens no other files and no addresses: put the buffer beside the .gltf, or export a .glb",
        )
        };
        let failed = |e: &std::io::Error| uri.refused("uri", &format!("a file that can be read ({e})"));
        let path = inside(uri.text()?).ok_or_else(outside)?;
        let folder = if self.folder.as_os_str().is_empty() { Path::new(".") } else { self.folder };
        let confinement = Confinement::within([folder.to_owned()]);
        let path = confinement.file(folder, &path).map_err(|why| match why {
            NotOpened::Outside => outside(),
            NotOpened::Missing => failed(&io::ErrorKind::NotFound.into()),
            NotOpened::NotRegular => uri.refused("uri", "an ordinary file"),
        })?;
        if let Some((_, bytes)) = self.files.iter().find(|(known, _)| *known == path) {
            return Ok(bytes.clone());
        }
        let file = File::open(&path).map_err(|e| failed(&e))?;
        let bytes =
            file.metadata().and_then(|before| file::all(&file, u64::MAX, &before)).map_err(|e| failed(&e))?;
        let bytes = Rc::new(bytes);
        self.files.push((path, bytes.clone()));
        Ok(bytes)
    }
}

pub(super) const UNPACK: &str = "export it without compression, or unpack it first";

pub(super) fn compressed(name: &str) -> ContentErrorKind {
    ContentErrorKind::Unsupported { what: format!("compressed meshes ({name})") }
}

/// The relative path of a URI, if it is one and does not climb.
fn inside(uri: &str) -> Option<PathBuf> {
    let text = percent_decoded(uri)?;
    let has_scheme = |text: &str| text.split('/').next().is_some_and(|first| first.contains(':'));
    if text.is_empty() || has_scheme(uri) || has_scheme(&text) || text.contains(['\\', '\0']) {
        return None;
    }
    let path = PathBuf::from(text);
    path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir)).then_some(path)
}

/// %41 is A; `None` if two hexadecimal digits do not follow, or the result is not UTF-8.
fn percent_decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        let mut digit = || (rest.next()? as char).to_digit(16);
        bytes.push(if byte == b'%' { (digit()? * 16 + digit()?) as u8 } else { byte });
    }
    String::from_utf8(bytes).ok()
}

/// The bytes behind `data:`, base64 as in RFC 4648 §4; the padding may be missing.
fn decoded(data: &str, uri: &Json<'_>) -> Result<Vec<u8>, ContentError> {
    let text = match data.split_once(',') {
        Some((kind, text)) if kind.ends_with(";base64") => text,
        _ => return Err(uri.refused("uri", "data:…;base64,… if it is data")),
    };
    let digits = text.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::with_capacity(digits.len() / 4 * 3 + 2);
    for (k, four) in digits.chunks(4).enumerate() {
        let mut word = 0_u32;
        for (i, &digit) in four.iter().enumerate() {
            let value = match digit {
                b'A'..=b'Z' => digit - b'A',
                b'a'..=b'z' => digit - b'a' + 26,
                b'0'..=b'9' => digit - b'0' + 52,
                b'+' => 62,
                b'/' => 63,
                _ => {
                    let what = format!("a base64 digit at {} of the data", 4 * k + i);
                    let found = char::from(digit).to_string();
                    return Err(uri.error(ContentErrorKind::Expected { what, found }));
                }
            };
            word |= u32::from(value) << (18 - 6 * i);
        }
        let [_, a, b, c] = word.to_be_bytes();
        match four.len() {
            4 => bytes.extend([a, b, c]),
            3 => bytes.extend([a, b]),
            2 => bytes.push(a),
            _ => return Err(uri.refused("uri", "base64 of whole bytes: one digit is left over")),
        }
    }
    Ok(bytes)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may")]
mod tests {
    use serde_json::Value;

    use super::{Json, decoded, inside};

    /// The test vectors of RFC 4648, §10.
    #[test]
    fn base64_of_the_standard() {
        let null = Value::Null;
        let cases = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
        ];
        for (plain, code) in cases {
            let data = format!("application/octet-stream;base64,{code}");
            assert_eq!(decoded(&data, &Json::root(&null)).unwrap(), plain.as_bytes());
        }
        assert_eq!(decoded(";base64,+/9", &Json::root(&null)).unwrap(), [0xfb, 0xff]);
        for bad in [";base64,Zg=g", ";base64,Z", ";base64,Zm 9v", ",Zg==", "Zg=="] {
            assert!(decoded(bad, &Json::root(&null)).is_err(), "{bad}");
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
