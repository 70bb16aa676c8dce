//! 3MF: the 3D Manufacturing Format, XML in a ZIP archive.

use super::MeshContents;
use crate::content::{ContentError, ContentErrorKind, ContentPlace};

pub fn read(_bytes: &[u8]) -> Result<MeshContents, ContentError> {
    Err(ContentError::new(ContentErrorKind::Unsupported { what: "this".to_owned() }, ContentPlace::Whole))
}
