//! Stream of the numbers in a voxel file, compressed or not.
//!
//! The numbers are read in blocks, from memory or from a file, and again from the start when
//! needed. The memory therefore does not depend on their count, however strongly they are
//! compressed.

use std::borrow::Cow;
use std::io::{self, BufReader, ErrorKind, Read, SeekFrom};
use std::path::PathBuf;

use flate2::read::MultiGzDecoder;
use polhode_source::file;
use polhode_source::files::{Files, Look};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::{Layout, Voxels};

/// Source of the bytes of a file.
#[derive(Debug)]
pub(crate) enum Source<'a> {
    Memory(Cow<'a, [u8]>),
    /// File, with its metadata when it was opened.
    File {
        files: &'a dyn Files,
        path: PathBuf,
        before: Look,
    },
}

/// Block size, bytes; a multiple of the size of every number type.
const BLOCK: u64 = 1 << 16;

/// Values of the voxels, in the order of their numbers.
pub struct VoxelValues<'v> {
    voxels: &'v Voxels<'v>,
    stream: Option<Stream<'v>>,
    count: usize,
}

/// State of the byte stream of the numbers.
struct Stream<'v> {
    input: Box<dyn Read + 'v>,
    block: Vec<u8>,
    /// Offset of the next byte in the block.
    at: usize,
    /// Number of bytes after the block.
    left: u64,
    /// Number of the next voxel.
    next: usize,
}

impl std::fmt::Debug for VoxelValues<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("VoxelValues").field("voxels", &self.voxels).finish_non_exhaustive()
    }
}

impl<'v> VoxelValues<'v> {
    pub(crate) fn of(voxels: &'v Voxels<'v>) -> Self {
        // The product was checked to fit a usize.
        let count = voxels.layout.counts.iter().product();
        Self { voxels, stream: None, count }
    }

    /// Returns the value of a voxel by its number in the grid; NaN beyond the last. Sequential
    /// access is fast. For an earlier voxel, the file is read again from its beginning.
    ///
    /// # Errors
    /// [`ContentError`] if the file has a different number of values than it declares, or cannot be
    /// decompressed. The error is returned with the last value.
    #[inline]
    pub fn at(&mut self, voxel: usize) -> Result<f64, ContentError> {
        if voxel >= self.count {
            return Ok(f64::NAN);
        }
        let layout = &self.voxels.layout;
        let size = layout.scalar.size();
        let mut stream = match self.stream.take() {
            Some(stream) if stream.next <= voxel => stream,
            _ => Stream::start(layout, &self.voxels.source)?,
        };
        loop {
            if stream.at == stream.block.len() {
                stream.read_block(layout, &self.voxels.source)?;
            }
            let (bytes, number) = (stream.at..stream.at + size, stream.next);
            (stream.at, stream.next) = (bytes.end, number + 1);
            if number == voxel {
                let value = layout.scalar.decode(&stream.block[bytes], layout.big_endian);
                self.stream = Some(stream);
                return Ok(value);
            }
        }
    }
}

impl<'v> Stream<'v> {
    fn start(layout: &Layout, source: &'v Source<'_>) -> Result<Self, ContentError> {
        let input: Box<dyn Read + 'v> = match source {
            Source::Memory(bytes) => {
                let start = usize::try_from(layout.start).unwrap_or(usize::MAX);
                Box::new(bytes.get(start..).unwrap_or_default())
            }
            Source::File { files, path, .. } => {
                let mut file = files.open(path).map_err(|e| layout.broken(&e, 0))?;
                file.seek(SeekFrom::Start(layout.start)).map_err(|e| layout.broken(&e, 0))?;
                Box::new(BufReader::with_capacity(BLOCK as usize, file))
            }
        };
        let input = match layout.compressed {
            None => input,
            Some(skip) => {
                let mut decoder = MultiGzDecoder::new(input);
                io::copy(&mut decoder.by_ref().take(skip), &mut io::sink())
                    .map_err(|e| layout.broken(&e, 0))?;
                Box::new(decoder)
            }
        };
        Ok(Self { input, block: Vec::new(), at: 0, left: layout.declared, next: 0 })
    }

    fn read_block(&mut self, layout: &Layout, source: &Source<'_>) -> Result<(), ContentError> {
        let length = self.left.min(BLOCK);
        self.block.clear();
        let before = layout.declared - self.left;
        let read = self.input.by_ref().take(length).read_to_end(&mut self.block);
        let present = before + self.block.len() as u64;
        read.map_err(|error| layout.broken(&error, present))?;
        if (self.block.len() as u64) < length {
            return Err(layout.wrong_count(present, "the file is truncated"));
        }
        (self.at, self.left) = (0, self.left - length);
        if self.left == 0 {
            // Read to the end, so that the checksum is verified.
            let more = self.input.read(&mut [0]).map_err(|error| layout.broken(&error, present))?;
            if more > 0 {
                let hint = "the compressed data contain more bytes than the sizes state";
                return Err(layout.wrong_count(present + 1, hint));
            }
            if let Source::File { files, path, before } = source {
                let now = files.look(path);
                now.and_then(|now| file::unchanged(now, before))
                    .map_err(|error| layout.broken(&error, present))?;
            }
        }
        Ok(())
    }
}

impl Layout {
    fn place(&self) -> ContentPlace {
        let what = if self.compressed.is_some() { "the compressed voxels" } else { "the first voxel" };
        ContentPlace::Byte { offset: self.start, what: what.to_owned() }
    }

    fn wrong_count(&self, present: u64, hint: &str) -> ContentError {
        let (what, declared) = ("bytes of voxels", self.declared);
        ContentError::new(ContentErrorKind::count(what, declared, present), self.place()).hint(hint)
    }

    fn broken(&self, error: &io::Error, present: u64) -> ContentError {
        match (error.kind(), self.compressed) {
            (ErrorKind::UnexpectedEof, Some(_)) => {
                self.wrong_count(present, "the compressed data are truncated")
            }
            (_, Some(_)) => {
                let (what, found) = ("data compressed by gzip", error.to_string());
                ContentError::new(ContentErrorKind::expected(what, found), self.place())
                    .hint("the file is damaged: save it again, or with the encoding raw")
            }
            (_, None) => {
                let (what, found) = ("voxels that can be read", error.to_string());
                ContentError::new(ContentErrorKind::expected(what, found), self.place())
            }
        }
    }
}
