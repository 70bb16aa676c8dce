//! NRRD: header lines `field: value`, an empty line, and the numbers.
//!
//! Supported are three dimensions, attached data, and the encodings `raw` and `gzip`. The first
//! axis varies fastest. The voxels are placed by `space directions` and `space origin`, otherwise
//! by `spacings`. Both are in the unit of `space units` or `units`.

use std::ops::Range;

use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::{Layout, Placement, Scalar, declared_bytes, require_length};

pub(crate) const MAGIC: &[u8] = b"NRRD";

/// Fields that do not affect the mass, such as display ranges and names.
const PASSED_OVER: [&str; 18] = [
    "content",
    "number",
    "block size",
    "blocksize",
    "min",
    "max",
    "old min",
    "oldmin",
    "old max",
    "oldmax",
    "labels",
    "thicknesses",
    "centers",
    "centerings",
    "space",
    "space dimension",
    "measurement frame",
    "modality",
];

/// Reads the header from the first bytes of a file with this length.
pub(crate) fn read(bytes: &[u8], length: u64) -> Result<Layout, ContentError> {
    let header = Header::read(bytes)?;
    header.require_density()?;
    let scalar = header.scalar()?;
    let counts = header.counts()?;
    let big_endian = header.big_endian(scalar)?;
    let encoding = header.encoding()?;
    let declared = declared_bytes(counts, scalar)?;
    let after_lines = header.after_lines(bytes)?;
    let (start, compressed) = match encoding {
        Encoding::Raw => (header.after_bytes(after_lines, length, declared)?, None),
        Encoding::Gzip => (after_lines, Some(header.compressed_skip()?)),
    };
    let present = length.saturating_sub(start);
    require_length(declared, compressed.is_none().then_some(present), start)?;
    let placement = header.placement()?;
    Ok(Layout { counts, order: [0, 1, 2], scalar, big_endian, placement, start, compressed, declared })
}

/// Encoding of the numbers.
#[derive(Clone, Copy)]
enum Encoding {
    /// Uncompressed.
    Raw,
    /// Compressed with gzip.
    Gzip,
}

/// Line of the header.
struct Field<'a> {
    /// Name in lower case.
    name: String,
    value: &'a str,
    /// Position of the value in the file.
    span: Range<usize>,
}

struct Header<'a> {
    fields: Vec<Field<'a>>,
    /// Offset after the empty line.
    end: usize,
}

impl<'a> Header<'a> {
    fn read(bytes: &'a [u8]) -> Result<Self, ContentError> {
        let mut fields: Vec<Field<'a>> = Vec::new();
        let mut at = 0;
        loop {
            let rest = &bytes[at..];
            let Some(length) = rest.iter().position(|&b| b == b'\n') else {
                return Err(ContentErrorKind::expected("an empty line at the end of the header", "")
                    .at(bytes.len()..bytes.len())
                    .hint(
                        "the file is truncated, or its data are in another file; only attached data are read",
                    ));
            };
            let line = rest[..length].strip_suffix(b"\r").unwrap_or(&rest[..length]);
            let start = at;
            at += length + 1;
            if line.is_empty() {
                return Ok(Self { fields, end: at });
            }
            let place = ContentPlace::Text(start..start + line.len());
            let line = std::str::from_utf8(line).map_err(|_| {
                let what = "a line of text";
                let found = String::from_utf8_lossy(line).into_owned();
                ContentError::new(ContentErrorKind::expected(what, found), place.clone())
            })?;
            if start == 0 {
                require_version(line, place)?;
            } else if !line.starts_with('#') {
                fields.extend(field(line, start)?);
            }
        }
    }

    /// Returns the only line with one of these names, which are alternative spellings.
    fn find(&self, names: &[&str]) -> Result<Option<&Field<'a>>, ContentError> {
        let mut found = self.fields.iter().filter(|field| names.contains(&field.name.as_str()));
        let first = found.next();
        match found.next() {
            None => Ok(first),
            Some(again) => {
                let rule = "given once";
                let (what, value) = (format!("the field {}", again.name), again.value.to_owned());
                Err(again.error(ContentErrorKind::value(what, value, rule)))
            }
        }
    }

    fn need(&self, name: &str) -> Result<&Field<'a>, ContentError> {
        self.find(&[name])?.ok_or_else(|| missing(&format!("field {name}")))
    }

    /// Refuses numbers that are not densities in kg/m³: values along an axis, or in a different
    /// unit of density. Other kinds of values, such as those of a scanner, are not recognized here.
    fn require_density(&self) -> Result<(), ContentError> {
        if let Some(field) = self.find(&["kinds"])?
            && let Some(kind) =
                field.value.split_whitespace().find(|kind| !["domain", "space", "???", "none"].contains(kind))
        {
            let error = field.unsupported(&format!("an axis of the kind {kind}"));
            return Err(error.hint("a density is one number for each voxel of space"));
        }
        let Some(field) = self.find(&["sample units", "sampleunits"])? else { return Ok(()) };
        let unit = field.value.trim_matches('"').trim();
        match unit::factor(unit, Dimension::DENSITY) {
            Ok(factor) if factor != 1.0 && !unit.is_empty() => {
                let error = field.unsupported(&format!(
                    "values in {unit}: values must be densities in kg/m³, or need --per-value"
                ));
                Err(error
                    .hint(format!("delete the field, and give the density for a value of 1: {factor} kg/m³")))
            }
            _ => Ok(()),
        }
    }

    fn scalar(&self) -> Result<Scalar, ContentError> {
        let field = self.need("type")?;
        let words: Vec<_> = field.value.split_whitespace().collect();
        Ok(match words.join(" ").as_str() {
            "signed char" | "int8" | "int8_t" => Scalar::I8,
            "uchar" | "unsigned char" | "uint8" | "uint8_t" => Scalar::U8,
            "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => Scalar::I16,
            "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => Scalar::U16,
            "int" | "signed int" | "int32" | "int32_t" => Scalar::I32,
            "uint" | "unsigned int" | "uint32" | "uint32_t" => Scalar::U32,
            "longlong"
            | "long long"
            | "long long int"
            | "signed long long"
            | "signed long long int"
            | "int64"
            | "int64_t" => Scalar::I64,
            "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => {
                Scalar::U64
            }
            "float" => Scalar::F32,
            "double" => Scalar::F64,
            other => return Err(field.unsupported(&format!("numbers of the type {other}"))),
        })
    }

    fn counts(&self) -> Result<[usize; 3], ContentError> {
        let dimension = self.need("dimension")?;
        if dimension.value != "3" {
            let (what, value) = ("the dimension", dimension.value.to_owned());
            let error = dimension.error(ContentErrorKind::value(what, value, "3"));
            return Err(error.hint("a density is one number for each voxel of space"));
        }
        self.need("sizes")?.three("three whole numbers", |word| word.parse().ok())
    }

    fn big_endian(&self, scalar: Scalar) -> Result<bool, ContentError> {
        match self.find(&["endian"])? {
            _ if scalar.size() == 1 => Ok(false),
            None => Err(missing("field endian").hint("add the line: endian: little, or endian: big")),
            Some(field) if field.value.eq_ignore_ascii_case("little") => Ok(false),
            Some(field) if field.value.eq_ignore_ascii_case("big") => Ok(true),
            Some(field) => Err(field.expected("little or big")),
        }
    }

    /// Returns the encoding of the numbers, which must be attached.
    fn encoding(&self) -> Result<Encoding, ContentError> {
        if let Some(field) = self.find(&["data file", "datafile"])? {
            let error = field.unsupported("data in another file than the header");
            return Err(error.hint("save the grid as a single .nrrd file"));
        }
        let field = self.need("encoding")?;
        match field.value.to_ascii_lowercase().as_str() {
            "raw" => Ok(Encoding::Raw),
            "gzip" | "gz" => Ok(Encoding::Gzip),
            _ => Err(field
                .unsupported(&format!("the encoding {}", field.value))
                .hint("save the grid with the encoding raw or gzip")),
        }
    }

    /// Returns the offset after the header and the lines to be skipped.
    fn after_lines(&self, bytes: &[u8]) -> Result<u64, ContentError> {
        let mut at = self.end;
        if let Some(field) = self.find(&["line skip", "lineskip"])? {
            let lines: usize = field.value.parse().map_err(|_| field.expected("a whole number"))?;
            for _ in 0..lines {
                let end = bytes.get(at..).and_then(|rest| rest.iter().position(|&b| b == b'\n'));
                at +=
                    1 + end.ok_or_else(|| field.expected("at most the number of lines at the beginning"))?;
            }
        }
        Ok(at as u64)
    }

    /// Returns the number of bytes to skip before the numbers. `None` stands for −1, which skips
    /// everything before the numbers.
    fn byte_skip(&self) -> Result<Option<(&Field<'a>, Option<u64>)>, ContentError> {
        let Some(field) = self.find(&["byte skip", "byteskip"])? else { return Ok(None) };
        let skip = match field.value {
            "-1" => None,
            value => Some(value.parse().map_err(|_| field.expected("a whole number, or -1"))?),
        };
        Ok(Some((field, skip)))
    }

    /// Returns the offset of the uncompressed numbers, after the bytes to be skipped.
    fn after_bytes(&self, from: u64, length: u64, declared: u64) -> Result<u64, ContentError> {
        let Some((field, skip)) = self.byte_skip()? else { return Ok(from) };
        let start = match skip {
            Some(skip) => from.checked_add(skip),
            None => length.checked_sub(declared).filter(|&start| start >= from),
        };
        start
            .filter(|&start| start <= length)
            .ok_or_else(|| field.expected("at most the number of bytes in the file"))
    }

    /// Returns the number of bytes to skip after decompression.
    fn compressed_skip(&self) -> Result<u64, ContentError> {
        match self.byte_skip()? {
            None => Ok(0),
            Some((_, Some(skip))) => Ok(skip),
            Some((field, None)) => Err(field
                .unsupported("a byte skip of -1 in compressed data")
                .hint("write the number of bytes to skip after decompression")),
        }
    }

    fn placement(&self) -> Result<Placement, ContentError> {
        let directions = self.find(&["space directions"])?;
        let spacings = self.find(&["spacings"])?;
        if let (Some(_), Some(field)) = (directions, spacings) {
            return Err(field.unsupported("spacings together with space directions, which state the same"));
        }
        let (steps, units) = match (directions, spacings) {
            (Some(field), _) => {
                if field.value.contains("none") {
                    return Err(field.unsupported("an axis that is not a spatial axis"));
                }
                let vectors: Vec<_> = field.value.split_inclusive(')').map(vector).collect();
                let steps = <[_; 3]>::try_from(vectors).ok().and_then(all);
                (Some(steps.ok_or_else(|| field.expected("three vectors (x,y,z)"))?), "space units")
            }
            (None, Some(field)) => {
                let [a, b, c] = field.three("three numbers", finite)?;
                (Some([[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]]), "units")
            }
            (None, None) => (None, "space units"),
        };
        let origin = match self.find(&["space origin"])? {
            None => None,
            Some(field) => Some(vector(field.value).ok_or_else(|| field.expected("a vector (x,y,z)"))?),
        };
        let unit = self.find(&[units])?.map(Field::unit).transpose()?;
        Ok(Placement { steps, origin, unit })
    }
}

fn require_version(line: &str, place: ContentPlace) -> Result<(), ContentError> {
    match line.strip_prefix("NRRD") {
        Some("0001" | "0002" | "0003" | "0004" | "0005") => Ok(()),
        _ => Err(ContentError::new(ContentErrorKind::expected("NRRD0001 to NRRD0005", line), place)),
    }
}

/// Parses `name: value`. Returns `None` for `key:=value`, which has no defined meaning.
fn field(line: &str, start: usize) -> Result<Option<Field<'_>>, ContentError> {
    const READ: [&str; 18] = [
        "type",
        "dimension",
        "sizes",
        "endian",
        "encoding",
        "data file",
        "datafile",
        "line skip",
        "lineskip",
        "byte skip",
        "byteskip",
        "spacings",
        "space directions",
        "space origin",
        "space units",
        "sample units",
        "sampleunits",
        "kinds",
    ];
    let expected =
        |what: &str, found: &str| ContentErrorKind::expected(what, found).at(start..start + line.len());
    let Some((name, value)) = line.split_once(':') else {
        return Err(expected("field: value, or an empty line", line));
    };
    if value.starts_with('=') {
        return Ok(None);
    }
    let offset = start + line.len() - value.trim_start().len();
    let value = value.trim();
    let name = name.to_ascii_lowercase();
    if PASSED_OVER.contains(&name.as_str()) {
        return Ok(None);
    }
    if !READ.contains(&name.as_str()) && name != "units" {
        let what = format!("the field {name}");
        return Err(ContentErrorKind::unsupported(what).at(start..start + line.len()));
    }
    Ok(Some(Field { name, value, span: offset..offset + value.len() }))
}

impl Field<'_> {
    fn error(&self, kind: ContentErrorKind) -> ContentError {
        kind.at(self.span.clone())
    }

    fn expected(&self, what: &str) -> ContentError {
        self.error(ContentErrorKind::expected(what, self.value.to_owned()))
    }

    fn unsupported(&self, what: &str) -> ContentError {
        self.error(ContentErrorKind::unsupported(what))
    }

    fn three<T>(&self, what: &str, read: impl Fn(&str) -> Option<T>) -> Result<[T; 3], ContentError> {
        let words: Vec<_> = self.value.split_whitespace().map(read).collect();
        <[_; 3]>::try_from(words).ok().and_then(all).ok_or_else(|| self.expected(what))
    }

    /// Parses three quoted units of length, which must be equal.
    fn unit(&self) -> Result<(String, f64), ContentError> {
        let names: Vec<_> = self.value.split('"').skip(1).step_by(2).collect();
        let [name, second, third] = names[..] else {
            return Err(self.expected("three units in quotes"));
        };
        if name != second || name != third {
            return Err(self.unsupported("axes with different units"));
        }
        match unit::factor(name, Dimension::LENGTH) {
            Ok(metres) if !name.trim().is_empty() => Ok((name.to_owned(), metres)),
            _ => Err(self.expected("a unit of length, such as \"mm\"")),
        }
    }
}

fn missing(what: &str) -> ContentError {
    ContentErrorKind::missing(what).of_whole()
}

/// Parses a vector `(x,y,z)` of finite numbers.
fn vector(text: &str) -> Option<[f64; 3]> {
    let inner = text.trim().strip_prefix('(')?.strip_suffix(')')?;
    let parts: Vec<_> = inner.split(',').map(|part| finite(part.trim())).collect();
    all(parts.try_into().ok()?)
}

fn finite(word: &str) -> Option<f64> {
    word.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Returns all three values, or `None` if one is missing.
fn all<T>(parts: [Option<T>; 3]) -> Option<[T; 3]> {
    let [a, b, c] = parts;
    Some([a?, b?, c?])
}
