//! Which files are robot models: by their ending, and where that is not enough by their root element.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::{BufRead as _, BufReader};
use std::path::Path;

use polhode_robot::read::format_of;

/// True of .urdf, .usda and .osim files, and of .sdf, .world and .xml files whose root element is a model's.
///
/// SDF is the name of two formats: SDFormat is XML and begins with `<`, a structure-data file of molecules does not.
pub(crate) fn is_model(path: &Path) -> bool {
    let ending = path.extension().map(OsStr::to_ascii_lowercase);
    match ending.as_ref().and_then(|ending| ending.to_str()) {
        Some("urdf" | "usda" | "osim") => path.is_file(),
        Some("sdf" | "world" | "xml" | "mjcf") => path.is_file() && has_model_root(path),
        _ => false,
    }
}

/// True if the file's root element is a model's. Only a file that begins with `<` is read to its end. One in UTF-16 is a model too: its
/// reader says what is wrong with it.
fn has_model_root(path: &Path) -> bool {
    // The marks of both encodings, and half of each ASCII character in UTF-16.
    const UNSEEN: [u8; 6] = [0xef, 0xbb, 0xbf, 0xfe, 0xff, 0];
    let seen = |byte: &u8| !UNSEEN.contains(byte) && !byte.is_ascii_whitespace();
    let begins = File::open(path)
        .map(BufReader::new)
        .and_then(|mut file| Ok(file.fill_buf()?.iter().find(|byte| seen(byte)) == Some(&b'<')));
    let root = |mut bytes: Vec<u8>| {
        bytes.retain(|byte| *byte != 0);
        let start = bytes.iter().position(seen).unwrap_or(bytes.len());
        format_of(&String::from_utf8_lossy(&bytes[start..])).is_some()
    };
    begins.unwrap_or(false) && fs::read(path).is_ok_and(root)
}
