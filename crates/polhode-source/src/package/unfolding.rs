//! Limits on the memory that a file may need when unpacked.
//!
//! A few bytes can expand to very many. An entry of a ZIP archive inflates up to 1032 times. A mesh
//! placed a thousand times, in a group placed a thousand times, is there a million times. The size
//! is therefore counted before memory is allocated, and is limited to a multiple of the size of the
//! file. Small files may expand further, up to a fixed minimum limit.

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

/// Number of bytes that may still be allocated.
#[derive(Debug)]
pub struct Budget {
    left: u64,
    limit: u64,
}

impl Budget {
    /// Creates a budget for meshes: 100 times the bytes of the file, at least 256 MiB. A solid
    /// needs 48 bytes a vertex in memory and 24 in a file. The limit allows fifty copies of the
    /// whole file, and at least five million vertices.
    pub fn placing(present: u64) -> Self {
        Self::new(present.saturating_mul(100), 256 << 20)
    }

    /// Creates a budget for inflated text: 60 times the bytes of the archive, at least 64 MiB. A
    /// model with real coordinates deflates 4 to 10 times, one with short integers in order 30
    /// times.
    pub fn inflating(present: u64) -> Self {
        Self::new(present.saturating_mul(60), 64 << 20)
    }

    fn new(multiple: u64, floor: u64) -> Self {
        let limit = multiple.max(floor);
        Self { left: limit, limit }
    }

    /// Returns the number of bytes that may still be allocated.
    pub fn left(&self) -> u64 {
        self.left
    }

    /// Subtracts `items` × `bytes_each` bytes from the budget; an error if it is exhausted.
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

    /// Returns the error for a file that exceeds the budget.
    pub fn exhausted(&self, place: String) -> ContentError {
        let kind = ContentErrorKind::Unsupported {
            what: format!("a file of this size that expands to more than {} MiB", self.limit >> 20),
        };
        ContentError::new(kind, ContentPlace::Within(place))
            .hint("a few bytes stand for very many here: the file is damaged or malicious")
    }
}
