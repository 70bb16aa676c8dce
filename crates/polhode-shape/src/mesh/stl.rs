//! STL: triangles only, in one of two encodings.
//!
//! A binary file has an 80-byte header, a count, and 50 bytes per triangle. An ASCII file is a
//! sequence of `solid … endsolid`. Some binary files also start with `solid`, so the length is
//! tested first: a file with exactly the length of its count is binary. A count is never trusted
//! before the bytes are present.
//!
//! The reader returns the vertices in the file's own unit, in double precision; ASCII coordinates
//! are parsed directly to `f64`. The winding of a triangle defines its outside. The stored normals
//! are redundant and often wrong, and are ignored.

use std::panic::resume_unwind;
use std::path::Path;
use std::sync::Mutex;
use std::thread;

use polhode::body::mesh::{Triangle, TriangleMesh};
use polhode_source::text::is_utf16;
use polhode_source::{FormatError, FormatErrorKind, Place};

use super::stl_error::{HEADER, PREAMBLE, RECORD};
use super::{MeshContents, MeshPart};

pub use super::stl_error::{StlError, StlPlace};

/// Length of the normal at the beginning of a record, bytes.
const NORMAL: usize = 12;

/// The contents of an STL file.
#[derive(Clone, Debug, PartialEq)]
pub struct Stl {
    /// Encoding of the file.
    pub kind: StlKind,
    /// Name of the first solid, or text of the binary header; often empty.
    pub name: String,
    /// Number of solids in the file; their triangles are joined in one list.
    pub solids: usize,
    /// Triangles with vertices counter-clockwise as seen from outside, in the file's unit of
    /// length.
    pub triangles: Vec<[[f64; 3]; 3]>,
}

/// Encoding of an STL file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StlKind {
    /// Binary: little-endian records in single precision.
    Binary,
    /// Text, usually called ASCII STL.
    Ascii,
}

/// Reads the bytes of an STL file, binary or ASCII.
///
/// ```
/// use polhode_shape::mesh::stl::{StlKind, read};
///
/// let text = b"solid flake
///   facet normal 0 0 1
///     outer loop
///       vertex 0.1 0 2.5e-3
///       vertex 1.2 0.3 0
///       vertex 0.4 1.7 -1
///     endloop
///   endfacet
/// endsolid flake";
/// let stl = read(text).unwrap();
/// assert_eq!((stl.kind, stl.name.as_str()), (StlKind::Ascii, "flake"));
/// assert_eq!(stl.triangles, [[[0.1, 0.0, 2.5e-3], [1.2, 0.3, 0.0], [0.4, 1.7, -1.0]]]);
///
/// let error = read(b"solid\nfacet normal 0 0 1\nouter loop\nvertex 0,5 2 1").unwrap_err();
/// assert_eq!(error.to_string(), "line 4, column 8: expected a number, found \"0,5\"");
/// assert_eq!(error.hint(), Some("use a decimal point"));
/// ```
///
/// # Errors
///
/// Bytes that are not an STL file, a truncated file or one that does not follow the grammar, a
/// coordinate that is not finite, and a file without a triangle.
pub fn read(bytes: &[u8]) -> Result<Stl, StlError> {
    let declared = bytes.get(HEADER..).and_then(<[u8]>::first_chunk).map(|&count| u32::from_le_bytes(count));
    let stl = match declared {
        Some(n) if bytes.len() as u64 == PREAMBLE as u64 + RECORD as u64 * u64::from(n) => binary(bytes)?,
        _ if is_text(bytes) => Ascii::new(bytes).file()?,
        Some(declared) => return Err(StlError::WrongCount { declared, length: bytes.len() }),
        None => return Err(StlError::Unrecognized { length: bytes.len() }),
    };
    match stl.triangles.is_empty() {
        true => Err(StlError::NoTriangles),
        false => Ok(stl),
    }
}

/// Returns the contents of an STL file; `path` is for messages.
pub fn contents(bytes: &[u8], path: &Path) -> Result<MeshContents, FormatError> {
    let Stl { kind, name, triangles, .. } = read(bytes).map_err(|error| refused(path, bytes, &error))?;
    let mesh = TriangleMesh::of_soup(triangles)
        .map_err(|error| FormatError::new(path, None, FormatErrorKind::Body(error)))?;
    let encoding = match kind {
        StlKind::Binary => "binary",
        StlKind::Ascii => "ascii",
    };
    let parts = vec![MeshPart { name: String::new(), mesh }];
    Ok(MeshContents { encoding, name, unit: None, parts, findings: Vec::new() })
}

/// Returns the error for a file with these bytes.
fn refused(path: &Path, bytes: &[u8], error: &StlError) -> FormatError {
    match is_utf16(bytes) {
        true => FormatError::new(path, None, FormatErrorKind::Utf16),
        false => {
            // Line and column are part of the error; the index of a record is added to the message.
            let message = match error.place() {
                Some(StlPlace::Text { .. }) => error.message(),
                _ => error.to_string(),
            };
            let kind = FormatErrorKind::Subject { message, hint: error.hint().map(str::to_owned) };
            FormatError::new(path, place(bytes, error), kind)
        }
    }
}

/// Returns the place of an error in an ASCII file. The column counts characters, not bytes.
fn place(bytes: &[u8], error: &StlError) -> Option<Place> {
    let StlPlace::Text { line, column } = error.place()? else { return None };
    let mut start = 0;
    for _ in 1..line {
        let end = start + bytes[start..].iter().position(|b| b"\r\n".contains(b))?;
        start = end + if bytes[end..].starts_with(b"\r\n") { 2 } else { 1 };
    }
    let offset = start + column - 1;
    let rest = bytes.get(offset..)?;
    let token = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
    Some(Place::in_bytes(bytes, offset..offset + token))
}

/// Returns true if the bytes start with `solid` and look like text. In a binary file, the count at
/// byte 80 contains a zero byte for up to 16 million triangles.
fn is_text(bytes: &[u8]) -> bool {
    Ascii::new(bytes).token().eq_ignore_ascii_case(b"solid") && !bytes.iter().take(512).any(|&b| b == 0)
}

/// Reads a binary file whose length agrees with its count.
fn binary(bytes: &[u8]) -> Result<Stl, StlError> {
    let (header, records) = (&bytes[..HEADER], bytes[PREAMBLE..].as_chunks::<RECORD>().0);
    let triangles = decoded(records)?;
    let name = lossy(header.split(|&b| b == 0).next().unwrap_or_default());
    Ok(Stl { kind: StlKind::Binary, name, solids: 1, triangles })
}

/// Number of records in a work item.
const PIECE: usize = 1 << 14;

/// Decodes the triangles of binary records on all threads. Most of the time is spent on access to
/// newly allocated memory.
fn decoded(records: &[[u8; RECORD]]) -> Result<Vec<Triangle>, StlError> {
    let mut triangles = vec![[[0.0; 3]; 3]; records.len()];
    let pieces = Mutex::new(records.chunks(PIECE).zip(triangles.chunks_mut(PIECE)).enumerate());
    let next = || pieces.lock().ok()?.next();
    // First triangle with a coordinate that is not finite, among the work items of a thread.
    let work = || {
        let mut wrong: Option<usize> = None;
        while let Some((k, (records, triangles))) = next() {
            let mut all = records.iter().zip(triangles);
            if let Some(at) = all.position(|(record, triangle)| !decode(record, triangle)) {
                wrong = Some(wrong.map_or(k * PIECE + at, |first| first.min(k * PIECE + at)));
            }
        }
        wrong
    };
    let others = thread::available_parallelism().map_or(1, usize::from).min(records.len().div_ceil(PIECE));
    let wrong = thread::scope(|scope| {
        // If a thread cannot be started, the others do its work.
        let spawn = |_| thread::Builder::new().spawn_scoped(scope, work).ok();
        let others: Vec<_> = (1..others).filter_map(spawn).collect();
        let own = work();
        let joined =
            others.into_iter().map(|other| other.join().unwrap_or_else(|panic| resume_unwind(panic)));
        joined.flatten().chain(own).min()
    });
    wrong.map_or(Ok(triangles), |index| Err(not_finite(index, &records[index])))
}

/// Decodes a record; returns false if a coordinate is not finite.
fn decode(record: &[u8; RECORD], triangle: &mut Triangle) -> bool {
    let words = record[NORMAL..].as_chunks::<4>().0;
    let coordinates = triangle.as_flattened_mut().iter_mut();
    coordinates.zip(words).fold(true, |finite, (coordinate, &word)| {
        *coordinate = f64::from(f32::from_le_bytes(word));
        finite & coordinate.is_finite()
    })
}

fn not_finite(index: usize, record: &[u8; RECORD]) -> StlError {
    let words = record[NORMAL..].as_chunks::<4>().0;
    let mut values = words.iter().map(|&word| f32::from_le_bytes(word)).enumerate();
    let (k, value) = values.find(|(_, value)| !value.is_finite()).unwrap_or_default();
    let offset = PREAMBLE + RECORD * index + NORMAL + 4 * k;
    StlError::NotFinite { at: StlPlace::Record { index, offset }, found: value.to_string() }
}

/// Parser of an ASCII file; `at` is the offset of the next byte.
#[derive(Clone, Copy)]
struct Ascii<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Ascii<'a> {
    /// Starts at the first byte, or after a byte order mark.
    fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: if bytes.starts_with("\u{feff}".as_bytes()) { 3 } else { 0 } }
    }

    fn file(mut self) -> Result<Stl, StlError> {
        let mut stl = Stl { kind: StlKind::Ascii, name: String::new(), solids: 0, triangles: Vec::new() };
        loop {
            self.keyword("solid")?;
            let name = self.line();
            if stl.solids == 0 {
                stl.name = lossy(name);
            }
            stl.solids += 1;
            while !self.next_is("endsolid") {
                stl.triangles.push(self.facet()?);
            }
            self.keyword("endsolid")?;
            self.line();
            if self.peek().is_empty() {
                return Ok(stl);
            }
        }
    }

    fn facet(&mut self) -> Result<[[f64; 3]; 3], StlError> {
        self.expect("facet", "facet or endsolid")?;
        self.keyword("normal")?;
        for _ in 0..3 {
            self.token();
        }
        self.keyword("outer")?;
        self.keyword("loop")?;
        let triangle = [self.vertex()?, self.vertex()?, self.vertex()?];
        self.keyword("endloop")?;
        self.keyword("endfacet")?;
        Ok(triangle)
    }

    fn vertex(&mut self) -> Result<[f64; 3], StlError> {
        self.keyword("vertex")?;
        Ok([self.coordinate()?, self.coordinate()?, self.coordinate()?])
    }

    fn coordinate(&mut self) -> Result<f64, StlError> {
        let before = *self;
        match str::from_utf8(self.token()).ok().and_then(|token| token.parse::<f64>().ok()) {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => Err(StlError::NotFinite { at: before.place(), found: before.found() }),
            None => Err(before.unexpected("a number")),
        }
    }

    fn keyword(&mut self, word: &'static str) -> Result<(), StlError> {
        self.expect(word, word)
    }

    fn expect(&mut self, word: &str, expected: &'static str) -> Result<(), StlError> {
        match self.skip(word) {
            Some(after) => {
                *self = after;
                Ok(())
            }
            None => Err(self.unexpected(expected)),
        }
    }

    fn next_is(&self, word: &str) -> bool {
        self.skip(word).is_some()
    }

    /// Returns the parser after the word, which may be split after its `end`.
    fn skip(mut self, word: &str) -> Option<Self> {
        let word = word.as_bytes();
        let token = self.token();
        let token_is = token.eq_ignore_ascii_case(word);
        let halves = token.eq_ignore_ascii_case(b"end")
            && word.strip_prefix(b"end").is_some_and(|half| self.token().eq_ignore_ascii_case(half));
        (token_is || halves).then_some(self)
    }

    /// Returns the next run of bytes without white space; empty at the end of the file.
    fn token(&mut self) -> &'a [u8] {
        let rest = self.bytes[self.at..].trim_ascii_start();
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        let (token, rest) = rest.split_at(length);
        self.at = self.bytes.len() - rest.len();
        token
    }

    fn peek(mut self) -> &'a [u8] {
        self.token()
    }

    /// Returns the rest of the line.
    fn line(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|b| b"\r\n".contains(b)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    fn unexpected(&self, expected: &'static str) -> StlError {
        StlError::Syntax { at: self.place(), expected, found: self.found() }
    }

    /// Returns the next token, shortened for messages.
    fn found(&self) -> String {
        lossy(self.peek()).chars().take(40).collect()
    }

    /// Returns the start of the next token; at the end of the file, the end of the last token.
    fn place(&self) -> StlPlace {
        let blank = self.bytes[self.at..].len() - self.bytes[self.at..].trim_ascii_start().len();
        let start = if self.peek().is_empty() { self.at } else { self.at + blank };
        let before = &self.bytes[..start];
        let ends_line =
            |i: &usize| before[*i] == b'\n' || before[*i] == b'\r' && self.bytes.get(i + 1) != Some(&b'\n');
        let line_start = (0..start).rev().find(ends_line).map_or(0, |i| i + 1);
        StlPlace::Text { line: 1 + (0..start).filter(ends_line).count(), column: 1 + start - line_start }
    }
}

fn lossy(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).trim().to_owned()
}
