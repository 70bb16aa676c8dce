//! Which files are robot models: by their ending, and where that is not enough by their root element.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::{BufRead as _, BufReader};
use std::path::Path;

use polhode_robot::read::format_of;

/// True of .urdf files, and of .sdf, .world and .xml files whose root element is a model's.
///
/// SDF is the name of two formats: SDFormat is XML and begins with `<`, a structure-data file of molecules does not.
pub(crate) fn is_model(path: &Path) -> bool {
    let ending = path.extension().map(OsStr::to_ascii_lowercase);
    match ending.as_ref().and_then(|ending| ending.to_str()) {
        Some("urdf") => path.is_file(),
        Some("sdf" | "world" | "xml" | "mjcf") => path.is_file() && has_model_root(path),
        _ => false,
    }
}

/// True if the file's root element is a model's. Only a file that begins with `<` is read to its end.
fn has_model_root(path: &Path) -> bool {
    const MARK: &[u8] = "\u{feff}".as_bytes();
    let begins = File::open(path).map(BufReader::new).and_then(|mut file| {
        let start = file.fill_buf()?;
        Ok(start.strip_prefix(MARK).unwrap_or(start).trim_ascii_start().first() == Some(&b'<'))
    });
    begins.unwrap_or(false)
        && fs::read(path).is_ok_and(|bytes| format_of(&String::from_utf8_lossy(&bytes)).is_some())
}
