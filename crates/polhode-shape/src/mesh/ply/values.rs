//! Sequence of values in a PLY file, in its three encodings.

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::super::scan::Scan;
use super::header::{Encoding, Scalar};

/// Source of values. It is `Copy`, so that a position can be saved.
pub(crate) trait Values: Copy {
    /// Reads a number.
    fn number(&mut self, scalar: Scalar) -> Result<f64, Stop>;
    /// Reads a number of an integer type.
    fn integer(&mut self, scalar: Scalar) -> Result<i64, Stop>;
    /// Skips this many values.
    fn skip(&mut self, scalar: Scalar, count: u64) -> Result<(), Stop>;
    /// Returns the text and place of the last value; `what` describes it.
    fn last(&self, what: String) -> (String, ContentPlace);
    /// Returns the number of unread bytes.
    fn rest(&self) -> usize;
}

/// Reason for a missing value.
#[derive(Debug)]
pub(crate) enum Stop {
    /// End of the file.
    Ended,
    /// Content that is not a number of the expected type.
    Wrong(ContentError),
}

/// Binary numbers in big- or little-endian byte order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Binary<'a, const BIG: bool> {
    bytes: &'a [u8],
    at: usize,
    last: (usize, Scalar),
}

impl<'a, const BIG: bool> Binary<'a, BIG> {
    pub(crate) const fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at, last: (at, Scalar::U8) }
    }

    #[inline]
    fn take<const N: usize>(&mut self) -> Result<[u8; N], Stop> {
        let mut bytes = *self.bytes.get(self.at..).and_then(<[u8]>::first_chunk::<N>).ok_or(Stop::Ended)?;
        self.at += N;
        if BIG {
            bytes.reverse();
        }
        Ok(bytes)
    }

    #[inline]
    fn read_number(&mut self, scalar: Scalar) -> Result<f64, Stop> {
        Ok(match scalar {
            Scalar::F32 => f64::from(f32::from_le_bytes(self.take()?)),
            Scalar::F64 => f64::from_le_bytes(self.take()?),
            _ => self.read_integer(scalar)? as f64,
        })
    }

    #[inline]
    fn read_integer(&mut self, scalar: Scalar) -> Result<i64, Stop> {
        Ok(match scalar {
            Scalar::I8 => i64::from(i8::from_le_bytes(self.take()?)),
            Scalar::U8 => i64::from(u8::from_le_bytes(self.take()?)),
            Scalar::I16 => i64::from(i16::from_le_bytes(self.take()?)),
            Scalar::U16 => i64::from(u16::from_le_bytes(self.take()?)),
            Scalar::I32 => i64::from(i32::from_le_bytes(self.take()?)),
            Scalar::U32 => i64::from(u32::from_le_bytes(self.take()?)),
            // The header excludes such a type here.
            Scalar::F32 => f32::from_le_bytes(self.take()?) as i64,
            Scalar::F64 => f64::from_le_bytes(self.take()?) as i64,
        })
    }
}

impl<const BIG: bool> Values for Binary<'_, BIG> {
    #[inline]
    fn number(&mut self, scalar: Scalar) -> Result<f64, Stop> {
        self.last = (self.at, scalar);
        self.read_number(scalar)
    }

    #[inline]
    fn integer(&mut self, scalar: Scalar) -> Result<i64, Stop> {
        self.last = (self.at, scalar);
        self.read_integer(scalar)
    }

    #[inline]
    fn skip(&mut self, scalar: Scalar, count: u64) -> Result<(), Stop> {
        self.last = (self.at, scalar);
        let length = usize::try_from(count).ok().and_then(|count| count.checked_mul(scalar.size()));
        match length {
            Some(length) if length <= self.rest() => self.at += length,
            _ => return Err(Stop::Ended),
        }
        Ok(())
    }

    fn last(&self, what: String) -> (String, ContentPlace) {
        let (offset, scalar) = self.last;
        let value = Self { at: offset, ..*self }.read_number(scalar);
        let value = value.map_or_else(|_| String::new(), |value| value.to_string());
        (value, ContentPlace::Byte { offset: offset as u64, what })
    }

    fn rest(&self) -> usize {
        self.bytes.len().saturating_sub(self.at)
    }
}

/// Numbers in text, separated by white space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ascii<'a> {
    scan: Scan<'a>,
    last: usize,
}

impl<'a> Ascii<'a> {
    pub(crate) fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { scan: Scan::new(bytes).moved(at), last: at }
    }

    #[inline]
    fn start(&mut self) -> Result<(), Stop> {
        self.scan.skip_space();
        self.last = self.scan.at;
        if self.scan.is_done() { Err(Stop::Ended) } else { Ok(()) }
    }
}

impl Values for Ascii<'_> {
    #[inline]
    fn number(&mut self, _: Scalar) -> Result<f64, Stop> {
        self.start()?;
        self.scan.float("coordinate").map_err(Stop::Wrong)
    }

    #[inline]
    fn integer(&mut self, _: Scalar) -> Result<i64, Stop> {
        self.start()?;
        self.scan.integer("an integer").map_err(Stop::Wrong)
    }

    #[inline]
    fn skip(&mut self, _: Scalar, count: u64) -> Result<(), Stop> {
        for _ in 0..count {
            self.start()?;
            self.scan.word();
            // No progress: a value cannot start with a control character.
            if self.scan.at == self.last {
                return Err(Stop::Wrong(self.scan.expected("a number")));
            }
        }
        Ok(())
    }

    fn last(&self, _: String) -> (String, ContentPlace) {
        let scan = self.scan.moved(self.last);
        let length = { scan }.word().len();
        (scan.found(), ContentPlace::Text(self.last..self.last + length))
    }

    fn rest(&self) -> usize {
        self.scan.bytes[self.scan.at..].trim_ascii().len()
    }
}

impl Encoding {
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Ascii => "ascii",
            Self::LittleEndian => "binary, little-endian",
            Self::BigEndian => "binary, big-endian",
        }
    }
}

impl Stop {
    /// Converts to an error, with `ended` for the end of the file.
    pub(crate) fn or(self, ended: impl FnOnce() -> ContentError) -> ContentError {
        match self {
            Self::Ended => ended(),
            Self::Wrong(error) => error,
        }
    }
}

/// Returns the error for a count that exceeds the file.
pub(crate) fn short(what: String, declared: u64, present: u64, place: ContentPlace) -> ContentError {
    ContentError::new(ContentErrorKind::count(what, declared, present), place).hint("the file is truncated")
}
