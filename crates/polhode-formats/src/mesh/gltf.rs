//! glTF 2.0: JSON with buffers beside it, or all of it in one binary GLB.

use super::MeshContents;
use crate::content::{ContentError, ContentErrorKind, ContentPlace};

pub fn read(_bytes: &[u8], _folder: &std::path::Path) -> Result<MeshContents, ContentError> {
    Err(ContentError::new(ContentErrorKind::Unsupported { what: "this".to_owned() }, ContentPlace::Whole))
}
