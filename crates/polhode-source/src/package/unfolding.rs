//! How far a file may unfold in memory.
//!
//! A few bytes can stand for very many: an entry of a ZIP archive inflates up to 1032 times, and a mesh that is
//! placed a thousand times, in a group that is placed a thousand times, stands there a million times. So what a
//! file unfolds to is counted before it is made, and may be a multiple of the bytes that are there. Small files
//! may unfold further: up to a floor that any machine holds.

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

/// Bytes that may still be made.
#[derive(Debug)]
pub struct Budget {
    left: u64,
    limit: u64,
}

impl Budget {
    /// For meshes: 100 times the bytes of the file, or 256 MiB. A solid costs 48 bytes a vertex here and 24 in
    /// a file, so fifty copies of all of a file are within, or five million vertices whatever the file.
    pub fn placing(present: u64) -> Self {
        Self::new(present.saturating_mul(100), 256 << 20)
    }

    /// For text that is inflated: 60 times the bytes of the archive, or 64 MiB. A model of real coordinates
    /// deflates 4 to 10 times, and one of short integers in order 30 times.
    pub fn inflating(present: u64) -> Self {
        Self::new(present.saturating_mul(60), 64 << 20)
    }

    fn new(multiple: u64, floor: u64) -> Self {
        let limit = multiple.max(floor);
        Self { left: limit, limit }
    }

    /// What is left.
    pub fn left(&self) -> u64 {
        self.left
    }

    /// Takes the bytes of so many items.
    pub fn spend(
        &mut self,
        items: usize,
        bytes_each: usize,
        place: impl Fn() -> String,
    ) -> Result<(), ContentError> {
        let bytes = (items as u64).saturating_mul(bytes_each as u64);
        match self.left.checked_sub(bytes) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => Err(self.exhausted(place())),
        }
    }

    /// The error of a file that wants more than there is.
    pub fn exhausted(&self, place: String) -> ContentError {
        let kind = ContentErrorKind::Unsupported {
            what: format!("a file of this size that unfolds to more than {} MiB", self.limit >> 20),
        };
        ContentError::new(kind, ContentPlace::Within(place))
            .hint("a few bytes stand for very many here: the file is damaged or made to do harm")
    }
}
