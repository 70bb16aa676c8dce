//! Recognition of robot models in a build that cannot read them.

use std::path::PathBuf;

use polhode_source::files::Disk;
use polhode_source::read_file;
use pyo3::prelude::*;

use crate::error::Raise;

/// Returns true if the file starts like a robot model, with `<` or `#usda`. The missing function
/// `robot_file` then reports the reason.
#[pyfunction]
pub(crate) fn is_robot(py: Python<'_>, path: PathBuf) -> PyResult<bool> {
    let is_robot = |bytes: &[u8]| {
        let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
        Ok(start.first() == Some(&b'<') || start.starts_with(b"#usda"))
    };
    py.detach(|| read_file(&Disk, &path, is_robot)).map_err(Raise::raise)
}
