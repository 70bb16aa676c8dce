//! NPY, NumPy's format for one array, versions 1.0 to 3.0.
//!
//! The file consists of a magic word, a version, a length, a Python dictionary with the keys
//! `descr`, `fortran_order` and `shape`, and the array. It does not state the positions of the
//! voxels.

use std::ops::Range;

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::{Layout, Placement, Scalar, declared_bytes, require_length};

pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";

/// Reads the header from the first bytes of a file with this length.
pub(crate) fn read(bytes: &[u8], file_length: u64) -> Result<Layout, ContentError> {
    let version = bytes.get(6..8).ok_or_else(|| cut("the version", bytes.len()))?;
    let (start, length) = match version[0] {
        1 => (10, bytes.get(8..10).map(|b| usize::from(b[0]) | usize::from(b[1]) << 8)),
        2 | 3 => {
            let word = bytes.get(8..12).and_then(<[u8]>::first_chunk);
            (12, word.map(|&b| u32::from_le_bytes(b) as usize))
        }
        _ => {
            let what = format!("version {}.{} of NPY", version[0], version[1]);
            let place = ContentPlace::Byte { offset: 6, what: "the version".to_owned() };
            return Err(ContentError::new(ContentErrorKind::unsupported(what), place));
        }
    };
    let length = length.ok_or_else(|| cut("the length of the header", bytes.len()))?;
    let end = length.checked_add(start).filter(|&end| end <= bytes.len()).ok_or_else(|| {
        let (declared, present) = (length as u64, file_length.saturating_sub(start as u64));
        let kind = if present < declared {
            ContentErrorKind::count("bytes of header", declared, present)
        } else {
            ContentErrorKind::unsupported(format!("a header of {declared} bytes"))
        };
        ContentError::new(kind, ContentPlace::Byte { offset: 8, what: "the length of the header".to_owned() })
    })?;
    let header = Header::read(bytes, start..end)?;
    let Header { counts, scalar, big_endian, fortran } = header;
    let (declared, start) = (declared_bytes(counts, scalar)?, end as u64);
    require_length(declared, Some(file_length - start), start)?;
    let order = if fortran { [0, 1, 2] } else { [2, 1, 0] };
    let placement = Placement::default();
    Ok(Layout { counts, order, scalar, big_endian, placement, start, compressed: None, declared })
}

fn cut(what: &str, length: usize) -> ContentError {
    let kind = ContentErrorKind::expected(what, "");
    let place = ContentPlace::Byte { offset: length as u64, what: String::new() };
    ContentError::new(kind, place).hint("the file is truncated")
}

struct Header {
    counts: [usize; 3],
    scalar: Scalar,
    big_endian: bool,
    fortran: bool,
}

impl Header {
    fn read(bytes: &[u8], span: Range<usize>) -> Result<Self, ContentError> {
        let mut parser = Dictionary { bytes: &bytes[..span.end], at: span.start };
        let (mut descr, mut fortran, mut shape) = (None, None, None);
        parser.punctuation(b'{')?;
        loop {
            if parser.take(b'}') {
                break;
            }
            let place = parser.place();
            let key = parser.string()?;
            parser.punctuation(b':')?;
            let new = match key {
                "descr" => descr.replace(parser.scalar()?).is_none(),
                "fortran_order" => fortran.replace(parser.truth()?).is_none(),
                "shape" => shape.replace(parser.shape()?).is_none(),
                _ => false,
            };
            if !new {
                let what = "each of 'descr', 'fortran_order' and 'shape' once";
                return Err(ContentError::new(ContentErrorKind::expected(what, key), place));
            }
            if !parser.take(b',') {
                parser.punctuation(b'}')?;
                break;
            }
        }
        parser.skip_space();
        if parser.at < span.end {
            return Err(parser.expected("the end of the header"));
        }
        let missing = |what: &str| ContentErrorKind::missing(format!("'{what}'")).at(span.clone());
        let (scalar, big_endian) = descr.ok_or_else(|| missing("descr"))?;
        let fortran = fortran.ok_or_else(|| missing("fortran_order"))?;
        let counts = shape.ok_or_else(|| missing("shape"))?;
        Ok(Self { counts, scalar, big_endian, fortran })
    }
}

/// Parser for the subset of Python that the header may contain.
struct Dictionary<'a> {
    /// File contents up to the end of the header.
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Dictionary<'a> {
    fn skip_space(&mut self) {
        while self.bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
    }

    fn take(&mut self, byte: u8) -> bool {
        self.skip_space();
        let there = self.bytes.get(self.at) == Some(&byte);
        self.at += usize::from(there);
        there
    }

    fn punctuation(&mut self, byte: u8) -> Result<(), ContentError> {
        if self.take(byte) { Ok(()) } else { Err(self.expected(&char::from(byte).to_string())) }
    }

    /// Returns a word of letters and digits.
    fn word(&mut self) -> &'a [u8] {
        self.skip_space();
        let rest = &self.bytes[self.at..];
        &rest[..rest.iter().position(|b| !b.is_ascii_alphanumeric()).unwrap_or(rest.len())]
    }

    fn string(&mut self) -> Result<&'a str, ContentError> {
        self.skip_space();
        let rest = &self.bytes[self.at..];
        let quote = rest.first().copied().filter(|b| b"'\"".contains(b));
        let text = quote.and_then(|quote| {
            let inner = rest.get(1..)?;
            std::str::from_utf8(&inner[..inner.iter().position(|&b| b == quote)?]).ok()
        });
        let text = text.ok_or_else(|| self.expected("a string"))?;
        self.at += text.len() + 2;
        Ok(text)
    }

    fn truth(&mut self) -> Result<bool, ContentError> {
        let word = self.word();
        let truth = match word {
            b"True" => true,
            b"False" => false,
            _ => return Err(self.expected("True or False")),
        };
        self.at += word.len();
        Ok(truth)
    }

    /// Returns the number type, and true if it is big-endian.
    fn scalar(&mut self) -> Result<(Scalar, bool), ContentError> {
        self.skip_space();
        let start = self.at;
        if self.bytes.get(start) == Some(&b'[') {
            return Err(ContentError::new(ContentErrorKind::unsupported("arrays of records"), self.place()));
        }
        let descr = self.string()?;
        let unsupported = || {
            let kind = ContentErrorKind::unsupported(format!("numbers of the type '{descr}'"));
            kind.at(start..start + descr.len() + 2).hint("convert it: numpy.save(name, array.astype('<f8'))")
        };
        let (order, kind) = descr.split_at_checked(1).ok_or_else(unsupported)?;
        let scalar = match kind {
            "b1" => Scalar::Bool,
            "u1" => Scalar::U8,
            "i1" => Scalar::I8,
            "u2" => Scalar::U16,
            "i2" => Scalar::I16,
            "u4" => Scalar::U32,
            "i4" => Scalar::I32,
            "u8" => Scalar::U64,
            "i8" => Scalar::I64,
            "f4" => Scalar::F32,
            "f8" => Scalar::F64,
            _ => return Err(unsupported()),
        };
        match order {
            "<" => Ok((scalar, false)),
            ">" => Ok((scalar, true)),
            "|" if scalar.size() == 1 => Ok((scalar, false)),
            _ => Err(unsupported()),
        }
    }

    fn shape(&mut self) -> Result<[usize; 3], ContentError> {
        self.skip_space();
        let start = self.at;
        self.punctuation(b'(')?;
        let mut counts = Vec::new();
        while !self.take(b')') {
            let digits = self.word();
            let count = std::str::from_utf8(digits).ok().and_then(|text| text.parse::<usize>().ok());
            counts.push(count.ok_or_else(|| self.expected("a whole number"))?);
            self.at += digits.len();
            if !self.take(b',') {
                self.punctuation(b')')?;
                break;
            }
        }
        let dimensions = counts.len();
        counts.try_into().map_err(|_| {
            let kind = ContentErrorKind::value("the number of dimensions", dimensions.to_string(), "3");
            kind.at(start..self.at)
        })
    }

    fn place(&mut self) -> ContentPlace {
        self.skip_space();
        ContentPlace::Text(self.at..(self.at + self.word().len().max(1)).min(self.bytes.len()))
    }

    fn expected(&mut self, what: &str) -> ContentError {
        let place = self.place();
        let rest = &self.bytes[self.at..];
        let found = String::from_utf8_lossy(&rest[..self.word().len().max(1).min(rest.len())]).into_owned();
        ContentError::new(ContentErrorKind::expected(what, found), place)
    }
}
