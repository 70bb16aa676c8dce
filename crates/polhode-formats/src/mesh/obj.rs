//! Wavefront OBJ: vertices, faces of any number of corners, groups.

use super::MeshContents;
use crate::content::{ContentError, ContentErrorKind, ContentPlace};

pub fn read(_bytes: &[u8]) -> Result<MeshContents, ContentError> {
    Err(ContentError::new(ContentErrorKind::Unsupported { what: "this".to_owned() }, ContentPlace::Whole))
}
