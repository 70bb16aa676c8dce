//! A file as memory: one of the two `unsafe` lines of the project. The other is a hint to the cache (`ahead.rs`).
//!
//! A mapped file is bytes that somebody else may change while they are borrowed, which Rust cannot check: another
//! process that writes to the file changes them, and one that shortens it lets a later access end the process. Nothing
//! here relies on what the bytes are: they are only read, each at most a few times, every value of every byte is a valid one, and
//! no index or length comes from them after the file's length was asked. So a changing file gives wrong sums, and a
//! shortened one a signal, as with any tool that maps files. Who cannot accept that reads the file instead
//! ([`crate::moments_of_file`]).

use std::fs::File;
use std::io;
use std::ops::Deref;

/// The bytes of a file, mapped for reading.
#[derive(Debug)]
pub struct Mapped(memmap2::Mmap);

impl Mapped {
    /// Maps a whole file.
    ///
    /// # Errors
    /// What the system says: an empty file, a pipe or a directory cannot be mapped.
    pub fn new(file: &File) -> io::Result<Self> {
        #[allow(unsafe_code, reason = "see the top of this file")]
        // SAFETY: see the top of this file.
        unsafe { memmap2::Mmap::map(file) }.map(Self)
    }
}

impl Deref for Mapped {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        &self.0
    }
}
