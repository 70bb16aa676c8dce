//! Header of a PLY file: its elements with their counts and properties.

use std::collections::HashSet;
use std::ops::Range;

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::super::scan::Scan;

/// Header of a PLY file.
#[derive(Clone, Debug)]
pub(crate) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Offset after the header.
    pub end: usize,
}

/// Encoding of the elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// Element type: a group of items with the same properties.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub name: String,
    /// Declared number of items; not to be trusted.
    pub count: u64,
    pub properties: Vec<Property>,
    /// Position of the declaration.
    pub span: Range<usize>,
}

/// Property of every item of an element.
#[derive(Clone, Debug)]
pub(crate) struct Property {
    pub name: String,
    /// Type of a list's length, if the property is a list.
    pub length: Option<Scalar>,
    /// Type of the number, or of the items of a list.
    pub scalar: Scalar,
    pub span: Range<usize>,
}

/// Number type of a property.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    /// Returns the type by either of its two names.
    fn named(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// Returns the size in a binary file, bytes.
    pub(crate) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(crate) const fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

impl Element {
    /// Returns the plural of the element's name, for messages.
    pub(crate) fn plural(&self) -> String {
        match self.name.as_str() {
            "vertex" => "vertices".to_owned(),
            "face" => "faces".to_owned(),
            name => format!("elements {name:?}"),
        }
    }

    pub(crate) fn property(&self, name: &str) -> Option<(usize, &Property)> {
        self.properties.iter().enumerate().find(|(_, property)| property.name == name)
    }
}

/// Maximum length of a header line, bytes.
const LONGEST_LINE: usize = 1 << 16;

/// Reads the header. All lines of a file must have the same line end.
pub(crate) fn read(bytes: &[u8]) -> Result<Header, ContentError> {
    let start = &bytes[..bytes.len().min(LONGEST_LINE + 1)];
    let first = start.iter().position(|b| b"\r\n".contains(b)).unwrap_or(start.len());
    if bytes[..first].trim_ascii() != b"ply" {
        return Err(Scan::new(bytes).expected("\"ply\""));
    }
    let line_end: &[u8] = match &bytes[first..] {
        [b'\r', b'\n', ..] => b"\r\n",
        [b'\r', ..] => b"\r",
        _ => b"\n",
    };
    let start = Scan::new(&bytes[..first]);
    let (mut encoding, mut elements, mut at) = (None, Vec::<Element>::new(), first);
    let (mut names, mut property_names) = (HashSet::new(), HashSet::new());
    loop {
        at = (at + line_end.len()).min(bytes.len());
        let rest = &bytes[at..];
        let length = find(&rest[..rest.len().min(LONGEST_LINE + line_end.len())], line_end);
        if length > LONGEST_LINE {
            let what = format!("a line of the header of more than {LONGEST_LINE} bytes");
            let place = ContentPlace::Text(at..at + 1);
            return Err(ContentError::new(ContentErrorKind::unsupported(what), place)
                .hint("break a long comment into several lines"));
        }
        let mut line = Line { scan: start.within(&bytes[..at + length], at) };
        at += length;
        match line.next() {
            b"comment" | b"obj_info" => {}
            b"" if at < bytes.len() => {}
            b"" => return Err(line.scan.expected("end_header")),
            b"format" => encoding = Some(line.format()?),
            b"element" => {
                let element = line.element()?;
                if !names.insert(element.name.clone()) {
                    return Err(twice("the element", &element.name, &element.span));
                }
                property_names = HashSet::new();
                elements.push(element);
            }
            b"property" => {
                let property = line.property()?;
                let Some(element) = elements.last_mut() else {
                    return Err(line.back("an element before its properties"));
                };
                if !property_names.insert(property.name.clone()) {
                    return Err(twice("the property", &property.name, &property.span));
                }
                element.properties.push(property);
            }
            b"end_header" => {
                let what = || "format: ascii, binary_little_endian or binary_big_endian".to_owned();
                let missing = || ContentErrorKind::missing(what()).of_whole();
                let encoding = encoding.ok_or_else(missing)?;
                return Ok(Header { encoding, elements, end: (at + line_end.len()).min(bytes.len()) });
            }
            _ => return Err(line.back("format, comment, obj_info, element, property or end_header")),
        }
    }
}

/// Words of one line.
struct Line<'a> {
    scan: Scan<'a>,
}

impl<'a> Line<'a> {
    fn next(&mut self) -> &'a [u8] {
        self.scan.skip_space();
        self.scan.word()
    }

    /// Returns the error for an unexpected last word.
    fn back(&self, what: &str) -> ContentError {
        let before = &self.scan.bytes[..self.scan.at];
        let length = before.iter().rev().take_while(|b| **b > b' ').count();
        self.scan.moved(self.scan.at - length).expected(what)
    }

    fn format(&mut self) -> Result<Encoding, ContentError> {
        let encoding = match self.next() {
            b"ascii" => Encoding::Ascii,
            b"binary_little_endian" => Encoding::LittleEndian,
            b"binary_big_endian" => Encoding::BigEndian,
            _ => return Err(self.back("ascii, binary_little_endian or binary_big_endian")),
        };
        match self.next() {
            b"1.0" => Ok(encoding),
            _ => Err(self.back("the version 1.0")),
        }
    }

    fn element(&mut self) -> Result<Element, ContentError> {
        let name = self.name("the name of an element")?;
        let word = self.next();
        let count = str::from_utf8(word).ok().and_then(|word| word.parse().ok());
        let count = count.ok_or_else(|| self.back("the count of the element"))?;
        Ok(Element { name, count, properties: Vec::new(), span: self.scan.at - word.len()..self.scan.at })
    }

    fn property(&mut self) -> Result<Property, ContentError> {
        let mut scan = self.scan;
        scan.skip_space();
        let is_list = scan.word() == b"list";
        if is_list {
            self.scan = scan;
        }
        let length = if is_list { Some(self.scalar()?) } else { None };
        if length.is_some_and(|length| !length.is_integer()) {
            return Err(self.back("an integer type for the length of a list"));
        }
        let scalar = self.scalar()?;
        let name = self.name("the name of a property")?;
        Ok(Property { length, scalar, span: self.scan.at - name.len()..self.scan.at, name })
    }

    fn scalar(&mut self) -> Result<Scalar, ContentError> {
        let scalar = Scalar::named(self.next());
        scalar.ok_or_else(|| self.back("char, uchar, short, ushort, int, uint, float, double or list"))
    }

    fn name(&mut self, what: &str) -> Result<String, ContentError> {
        match str::from_utf8(self.next()) {
            Ok(name) if !name.is_empty() => Ok(name.to_owned()),
            _ => Err(self.back(what)),
        }
    }
}

fn twice(what: &str, name: &str, span: &Range<usize>) -> ContentError {
    let (what, value, rule) = (what, name.to_owned(), "declared once");
    ContentErrorKind::value(what, value, rule).at(span.clone())
}

/// Returns the position of the next line end, or the length.
fn find(bytes: &[u8], line_end: &[u8]) -> usize {
    bytes.windows(line_end.len()).position(|window| window == line_end).unwrap_or(bytes.len())
}
