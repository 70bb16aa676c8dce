//! Which files are robot models: by their ending, and where that is not enough by their root element.

use std::ffi::OsStr;
use std::io::{self, BufRead as _, BufReader, Read as _};
use std::path::Path;

use polhode_source::files::Files;

use super::{format_of, root_of};
use crate::model::ModelFormat;

/// True of .urdf, .usda and .osim files, and of .sdf, .world, .xml and .mjcf files, but for those that are clearly something else: XML with
/// another root element, or no XML. One that cannot be opened, or breaks off before its root element, is true: its reader says what is wrong.
///
/// SDF is the name of two formats: SDFormat is XML and begins with `<`, a structure-data file of molecules does not.
pub fn is_model(files: &dyn Files, path: &Path) -> bool {
    let ending = path.extension().map(OsStr::to_ascii_lowercase);
    let needs_root = match ending.as_ref().and_then(|ending| ending.to_str()) {
        Some("urdf" | "usda" | "osim") => false,
        Some("sdf" | "world" | "xml" | "mjcf") => true,
        _ => return false,
    };
    // a pipe would never end
    let is_other = files.look(path).is_ok_and(|look| !look.is_file());
    !is_other && (!needs_root || has_model_root(files, path).unwrap_or(true))
}

/// True if the file's root element is a model's, or cannot be found. Only a file that begins with `<` is read to its end. One in UTF-16 is a
/// model too: its reader says what is wrong with it.
fn has_model_root(files: &dyn Files, path: &Path) -> io::Result<bool> {
    // The marks of both encodings, and half of each ASCII character in UTF-16.
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
        // the roots of other documents are the same: SRDF, and OpenSim's settings of tools
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
