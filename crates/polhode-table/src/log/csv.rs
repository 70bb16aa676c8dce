//! Text with a line for each row. The names are in the first line, and `# key = value` lines are
//! above it.

use std::ops::Range;

use polhode_source::csv::{Separator, line_at, trimmed};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::blocks::Lines;
use super::choice::{Header, Plan};
use super::head::Head;
use super::rows::{MOST, Problem, RowError, Rows};

/// Contents of the first lines, and the start of the rows.
#[derive(Debug)]
pub(crate) struct Opening {
    pub head: Head,
    pub header: Header,
    pub separator: Separator,
    pub rows: usize,
}

/// Fields of a log. Blanks around a field are ignored. A field that begins with a quote ends with
/// one.
trait Fields: Copy {
    fn is_blank(self, byte: u8) -> bool;

    /// Returns the position after the blanks at a position.
    fn skip_blanks(self, bytes: &[u8], at: usize) -> usize;

    /// Returns the end of the field that begins at a position. The end of a quoted field is after
    /// its closing quote; `None` if that is missing.
    fn field_end(self, bytes: &[u8], start: usize) -> Option<usize>;

    /// Returns the fields of a line, without their quotes.
    fn fields(self, bytes: &[u8], line: &Range<usize>) -> Result<Vec<(String, Range<usize>)>, ContentError>;
}

impl Fields for Separator {
    fn is_blank(self, byte: u8) -> bool {
        byte == b' ' || byte == b'\r' || byte == b'\t' && self != Self::Byte(b'\t')
    }

    #[inline(always)]
    fn skip_blanks(self, bytes: &[u8], mut at: usize) -> usize {
        while bytes.get(at).is_some_and(|b| *b <= b' ' && self.is_blank(*b)) {
            at += 1;
        }
        at
    }

    fn field_end(self, bytes: &[u8], start: usize) -> Option<usize> {
        if bytes.get(start) == Some(&b'"') {
            let mut at = start + 1;
            loop {
                match bytes.get(at)? {
                    b'\n' => return None,
                    b'"' if bytes.get(at + 1) == Some(&b'"') => at += 2,
                    b'"' => return Some(at + 1),
                    _ => at += 1,
                }
            }
        }
        let ends = |byte: &u8| match self {
            Self::Byte(separator) => *byte == separator || *byte == b'\n',
            // Same as in `skip_blanks`. A form feed does not end a field, or the reader would never
            // pass it.
            Self::Blanks => self.is_blank(*byte) || *byte == b'\n',
        };
        let rest = bytes.get(start..).unwrap_or_default();
        Some(start + rest.iter().position(ends).unwrap_or(rest.len()))
    }

    fn fields(self, bytes: &[u8], line: &Range<usize>) -> Result<Vec<(String, Range<usize>)>, ContentError> {
        let text = &bytes[..line.end];
        let (mut at, mut fields) = (self.skip_blanks(text, line.start), Vec::new());
        loop {
            let end = self.field_end(text, at).ok_or_else(|| {
                let what = "a closing quote".to_owned();
                let found = String::from_utf8_lossy(&text[at..]).into_owned();
                let kind = ContentErrorKind::Expected { what, found };
                ContentError::new(kind, ContentPlace::Text(at..line.end))
            })?;
            let written = String::from_utf8_lossy(&text[at..end]);
            let written = written.trim();
            let plain = written.strip_prefix('"').and_then(|name| name.strip_suffix('"'));
            let name = plain.map_or_else(|| written.to_owned(), |name| name.replace("\"\"", "\""));
            fields.push((name, at..at + written.len()));
            let next = self.skip_blanks(text, end);
            at = match self {
                _ if next >= text.len() => return Ok(fields),
                Self::Byte(_) => self.skip_blanks(text, next + 1),
                Self::Blanks => next,
            };
        }
    }
}

/// Reads the lines up to the first row. A file may lack names if the user states the columns. The
/// names are then numbers.
pub(crate) fn opening(bytes: &[u8], is_told: bool) -> Result<Opening, ContentError> {
    let (mut at, mut head, mut comment) = (0, Head::default(), None);
    if bytes.starts_with(b"\xef\xbb\xbf") {
        at = 3;
    }
    if bytes.contains(&b'\r') && !bytes.contains(&b'\n') {
        let kind = ContentErrorKind::Unsupported { what: "lines that end in \\r alone".to_owned() };
        return Err(ContentError::new(kind, ContentPlace::Whole).hint("end them in \\n or \\r\\n"));
    }
    while let Some((line, next)) = line_at(bytes, at) {
        if bytes[line.clone()].starts_with(b"#") {
            let text = String::from_utf8_lossy(&bytes[line.clone()]);
            match Head::pair(&text) {
                Some((key, value)) => head.add(key, value, &ContentPlace::Text(line.clone()))?,
                None => {
                    let hashes = bytes[line.clone()].iter().take_while(|b| **b == b'#').count();
                    comment = Some(line.start + hashes..line.end);
                }
            }
        } else if !line.is_empty() {
            let separator = Separator::of(&bytes[line.clone()], None);
            let fields = separator.fields(bytes, &line)?;
            if !fields.iter().all(|(field, _)| field.parse::<f64>().is_ok()) {
                let header = header(fields);
                return Ok(Opening { head, header, separator, rows: next.min(bytes.len()) });
            }
            // NumPy writes the names as a comment.
            let names =
                comment.map(|comment| Separator::of(&bytes[comment.clone()], None).fields(bytes, &comment));
            let names = names.and_then(Result::ok).filter(|names| names.len() == fields.len());
            if names.is_none() && !is_told && head.columns.is_none() {
                let kind = ContentErrorKind::Missing { what: "names of its columns".to_owned() };
                return Err(ContentError::new(kind, ContentPlace::Text(line)).hint(
                    "write them in the first line, or state the columns by their numbers: --columns \"time = 1, quaternion \
                     wxyz = 2..5\"",
                ));
            }
            let numbered =
                || (1..).zip(&fields).map(|(k, (_, span))| (format!("{k}"), span.clone())).collect();
            let header = header(names.unwrap_or_else(numbered));
            return Ok(Opening { head, header, separator, rows: at });
        }
        at = next;
    }
    let kind = ContentErrorKind::Missing { what: "rows".to_owned() };
    Err(ContentError::new(kind, ContentPlace::Whole).hint(
        "a log has a line of names and one for each time: time_s,attitude_w,attitude_x,attitude_y,attitude_z",
    ))
}

fn header(fields: Vec<(String, Range<usize>)>) -> Header {
    let (names, spans) = fields.into_iter().unzip();
    Header { names, spans, is_in_order: true, ..Header::default() }
}

/// Rows of a text.
#[derive(Debug)]
pub(crate) struct Table<'a> {
    plan: &'a Plan,
    separator: Separator,
    /// Slot of each column; `None` if it is not read.
    slots: Vec<Option<u8>>,
}

impl<'a> Table<'a> {
    pub(crate) fn new(plan: &'a Plan, opening: &Opening) -> Self {
        let mut slots = vec![None; opening.header.names.len()];
        for (slot, column) in (0..).zip(&plan.slots) {
            slots[column.column] = Some(slot);
        }
        Self { plan, separator: opening.separator, slots }
    }

    /// Adds the row at a position. Returns the position after its line.
    #[inline]
    fn row(
        &self,
        text: &[u8],
        offset: usize,
        start: usize,
        rows: &mut Rows,
        numbers: &mut [f64; MOST],
    ) -> Result<usize, Error> {
        let separator = self.separator;
        let (mut at, mut width, mut time) = (start, 0, start..start);
        loop {
            let field = at;
            if let Some(Some(slot)) = self.slots.get(width) {
                let slot = usize::from(*slot);
                let (number, end) = self.number(text, field, slot)?;
                numbers[slot] = number;
                if slot == 0 {
                    time = field..end;
                }
                at = separator.skip_blanks(text, end);
            } else {
                let end = separator.field_end(text, field).ok_or_else(|| open_quote(text, field))?;
                at = separator.skip_blanks(text, end);
            }
            width += 1;
            match (text.get(at), separator) {
                (None | Some(b'\n'), _) => break,
                (Some(byte), Separator::Byte(own)) if *byte == own => {
                    at = separator.skip_blanks(text, at + 1);
                }
                (_, Separator::Blanks) if at > field => {}
                _ => {
                    let wrong = self.slots.get(width - 1).copied().flatten();
                    let wrong = wrong.and_then(|slot| self.rare_number(text, field, slot.into()).err());
                    return Err(wrong.unwrap_or_else(|| open_quote(text, field)));
                }
            }
        }
        if width != self.slots.len() {
            let at = start..line_end(text, start);
            let line = shown(text, at.clone());
            return Err(Error {
                at,
                problem: Problem::Width { expected: self.slots.len(), found: width, line },
            });
        }
        let place = offset + time.start..offset + time.end;
        let pushed = rows.push(self.plan, &numbers[..self.plan.slots.len()], place);
        pushed.map_err(|problem| {
            let is_late = matches!(problem, Problem::NotLater { .. });
            Error { at: if is_late { time } else { start..line_end(text, start) }, problem }
        })?;
        Ok(at + 1)
    }

    /// Reads the number of a slot at a position. Returns the number and the position after it.
    #[inline(always)]
    fn number(&self, text: &[u8], at: usize, slot: usize) -> Result<(f64, usize), Error> {
        let rest = text.get(at..).unwrap_or_default();
        let length = rest.iter().position(|b| self.ends_number(*b)).unwrap_or(rest.len());
        match str::from_utf8(&rest[..length]).ok().and_then(|number| number.parse::<f64>().ok()) {
            Some(number) if number.is_finite() => Ok((number, at + length)),
            _ => self.rare_number(text, at, slot),
        }
    }

    /// Returns true for a byte that ends a number.
    #[inline(always)]
    fn ends_number(&self, byte: u8) -> bool {
        byte == b'\n' || self.separator == Separator::Byte(byte) || self.separator.is_blank(byte)
    }

    /// Reads a number in quotes, or returns the error.
    #[cold]
    fn rare_number(&self, text: &[u8], at: usize, slot: usize) -> Result<(f64, usize), Error> {
        let end = self.separator.field_end(text, at).ok_or_else(|| open_quote(text, at))?;
        let span = trimmed(text, at..end);
        let found = shown(text, span.clone());
        let plain = found.trim_matches('"').trim();
        match plain.parse::<f64>() {
            Ok(number) if number.is_finite() && found.starts_with('"') => Ok((number, end)),
            Ok(number) if !number.is_finite() => {
                Err(Error { at: span, problem: Problem::NotFinite { slot, found: plain.to_owned() } })
            }
            _ => Err(Error { at: span, problem: Problem::NotNumber { slot, found: plain.to_owned() } }),
        }
    }
}

/// Error of a line, with its position in the text.
struct Error {
    at: Range<usize>,
    problem: Problem,
}

impl Lines for Table<'_> {
    fn rows(&self, text: &[u8], offset: usize) -> Result<Rows, RowError> {
        let (mut rows, mut at, mut numbers) = (Rows::default(), 0, [0.0; MOST]);
        while at < text.len() {
            let start = self.separator.skip_blanks(text, at);
            match text.get(start) {
                None => break,
                Some(b'\n') => at = start + 1,
                Some(b'#') => {
                    let line = start..line_end(text, start);
                    at = line.end + 1;
                    if let Some((key, _)) = Head::pair(&String::from_utf8_lossy(&text[line.clone()])) {
                        let place = ContentPlace::Text(offset + line.start..offset + line.end);
                        let problem = Problem::LateKey { key: key.to_owned() };
                        return Err(RowError { row: rows.times.len(), place, problem });
                    }
                }
                Some(_) => {
                    let row = rows.times.len();
                    at = self.row(text, offset, start, &mut rows, &mut numbers).map_err(|error| {
                        let place = ContentPlace::Text(offset + error.at.start..offset + error.at.end);
                        RowError { row, place, problem: error.problem }
                    })?;
                }
            }
        }
        Ok(rows)
    }
}

/// Returns the error of a field that begins with a quote and does not end with one.
#[cold]
fn open_quote(text: &[u8], at: usize) -> Error {
    let line = at..line_end(text, at);
    Error { problem: Problem::OpenQuote { line: shown(text, line.clone()) }, at: line }
}

/// Returns the end of a line, without the line break.
fn line_end(text: &[u8], at: usize) -> usize {
    let rest = text.get(at..).unwrap_or_default();
    at + rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len())
}

/// Returns a part of a text, shortened for a message.
fn shown(text: &[u8], span: Range<usize>) -> String {
    const MOST: usize = 256;
    let part = text.get(span).unwrap_or_default();
    String::from_utf8_lossy(&part[..part.len().min(MOST)]).trim().to_owned()
}
