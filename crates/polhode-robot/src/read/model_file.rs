//! Detection of model files, by the file extension and, if necessary, by the root element.

use std::ffi::OsStr;
use std::io::{self, BufRead as _, BufReader, Read as _};
use std::path::Path;

use polhode_source::files::Files;

use super::{format_of, root_of};
use crate::model::ModelFormat;

/// Returns true if a file is a robot model.
///
/// All `.urdf`, `.usda` and `.osim` files are, and with the feature `usd` all `.usd`, `.usdc` and
/// `.usdz` files. Files with the extension `.sdf`, `.world`, `.xml` or
/// `.mjcf` are models unless they are clearly something else: XML with another root element, or not
/// XML. A file that cannot be opened, or that ends before its root element, counts as a model, so
/// that its reader reports the error.
///
/// SDF is the name of two formats. SDFormat is XML and begins with `<`; a structure-data file of
/// molecules does not.
pub fn is_model(files: &dyn Files, path: &Path) -> bool {
    let ending = path.extension().map(OsStr::to_ascii_lowercase);
    let needs_root = match ending.as_ref().and_then(|ending| ending.to_str()) {
        Some("urdf" | "usda" | "osim") => false,
        Some("usd" | "usdc" | "usdz") => return cfg!(feature = "usd") && !is_other(files, path),
        Some("sdf" | "world" | "xml" | "mjcf") => true,
        _ => return false,
    };
    !is_other(files, path) && (!needs_root || has_model_root(files, path).unwrap_or(true))
}

/// Returns true for a folder or pipe. Reading a pipe would not end.
fn is_other(files: &dyn Files, path: &Path) -> bool {
    files.look(path).is_ok_and(|look| !look.is_file())
}

/// Returns true if the root element is that of a model, or cannot be found. Only a file that begins
/// with `<` is read to its end. A UTF-16 file counts as a model, so that its reader reports the
/// encoding.
fn has_model_root(files: &dyn Files, path: &Path) -> io::Result<bool> {
    // Byte order marks of both encodings, and the zero byte of ASCII characters in UTF-16.
    const UNSEEN: [u8; 6] = [0xef, 0xbb, 0xbf, 0xfe, 0xff, 0];
    let seen = |byte: &u8| !UNSEEN.contains(byte) && !byte.is_ascii_whitespace();
    let mut file = BufReader::new(files.open(path)?);
    if file.fill_buf()?.iter().find(|byte| seen(byte)) != Some(&b'<') {
        return Ok(false);
    }
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    bytes.retain(|byte| *byte != 0);
    let start = bytes.iter().position(seen).unwrap_or(bytes.len());
    let text = String::from_utf8_lossy(bytes.get(start..).unwrap_or_default());
    Ok(match format_of(&text) {
        // Other documents have the same root elements: SRDF, and the tool settings of OpenSim.
        Some(ModelFormat::Urdf) => has_element(&text, "link"),
        Some(ModelFormat::Osim) => has_element(&text, "Model"),
        Some(_) => true,
        None => root_of(&text).is_none(),
    })
}

fn has_element(text: &str, name: &str) -> bool {
    let ends = |rest: &str| rest.starts_with(|c: char| c.is_whitespace() || c == '>' || c == '/');
    text.split('<').any(|after| after.strip_prefix(name).is_some_and(ends))
}
