//! Lines of a particle table, as numbers.

use std::ops::Range;

use polhode_source::csv::{Lines, Separator, line_at};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::fields::{fields, number, text_of};
use super::header::{Column, Header, NAMES, Products, Role};
use super::{ParticleOptions, missing, value};

/// Format of the lines of a file.
pub(crate) struct Table {
    separator: Separator,
    pub header: Header,
}

/// Values of a line.
pub(crate) struct Row {
    /// Numbers in SI; 0 for missing columns.
    pub numbers: [f64; 10],
    /// Position of the name.
    pub name: Option<Range<usize>>,
}

impl Table {
    /// Parses the header; also returns the position of the first line of numbers.
    pub(crate) fn of(
        bytes: &[u8],
        start: usize,
        options: &ParticleOptions,
    ) -> Result<(Self, usize), ContentError> {
        let (mut at, mut comment, mut products) = (start, None, None);
        while let Some((line, next)) = line_at(bytes, at) {
            if bytes[line.clone()].starts_with(b"#") {
                match Products::declared(bytes, &line) {
                    Some(declared) => products = Some(declared?),
                    None => comment = Some(line.start + 1),
                }
            } else if !line.is_empty() {
                let separator = Separator::of(&bytes[line.clone()], Some(b'#'));
                let first = fields(bytes, at, separator)?;
                if first.iter().any(|field| number(&bytes[field.clone()], separator).is_none()) {
                    let header = Header::named(bytes, &first, products, options)?;
                    return Ok((Self { separator, header }, next));
                }
                // NumPy writes the header as a comment.
                if let Some(comment) = comment {
                    let names = fields(bytes, comment, separator).unwrap_or_default();
                    let roles: Vec<_> = names.iter().map(|f| Column::of(bytes, f).role).collect();
                    if names.len() == first.len() && (1..4).all(|k| roles.contains(&Role::Number(k))) {
                        let header = Header::named(bytes, &names, products, options)?;
                        return Ok((Self { separator, header }, at));
                    }
                }
                let header = Header::nameless(&line, first.len(), options)?;
                return Ok((Self { separator, header }, at));
            }
            at = next;
        }
        Err(missing("lines", "write a header such as mass_kg,x_m,y_m,z_m and one line per particle"))
    }

    /// Calls `visit` with every line from byte `at` on, and its values.
    pub(crate) fn each_row(
        &self,
        bytes: &[u8],
        at: usize,
        mut visit: impl FnMut(Range<usize>, &Row) -> Result<(), ContentError>,
    ) -> Result<(), ContentError> {
        let roles = &self.header.roles;
        let (mut lines, mut mark) = (Lines::new(bytes, at, self.separator), None);
        loop {
            let (mut row, mut count) = (Row { numbers: [0.0; 10], name: None }, 0);
            let line = lines.each_field(|field| {
                match roles.get(count) {
                    Some(Role::Number(k)) => {
                        let read = self.number(bytes, &field, NAMES[*k], &mut mark)?;
                        row.numbers[*k] = self.header.scales[*k].apply(read);
                    }
                    Some(Role::Count) => self.one(bytes, &field, &mut mark)?,
                    Some(Role::Name) => row.name = Some(field),
                    Some(Role::Label) | None => {}
                }
                count += 1;
                Ok(())
            })?;
            match line {
                None => return Ok(()),
                Some(_) if count == 0 => {}
                Some(line) if count == roles.len() => visit(line, &row)?,
                Some(line) => {
                    let rule = format!("{} fields long, like the first line; it has {count}", roles.len());
                    return Err(value("the line", text_of(bytes, &line), rule, ContentPlace::Text(line)));
                }
            }
        }
    }

    /// Returns an error unless the quantity of a line is 1.
    fn one(&self, bytes: &[u8], field: &Range<usize>, mark: &mut Option<u8>) -> Result<(), ContentError> {
        let count = self.number(bytes, field, "the quantity", mark)?;
        if count == 1.0 {
            return Ok(());
        }
        let rule = "1: a line is one piece, at one position".to_owned();
        let error = value("the quantity", text_of(bytes, field), rule, ContentPlace::Text(field.clone()));
        Err(error.hint("write one line per piece, with its own position"))
    }

    /// Parses a finite number with the same decimal mark as before.
    fn number(
        &self,
        bytes: &[u8],
        field: &Range<usize>,
        what: &str,
        mark: &mut Option<u8>,
    ) -> Result<f64, ContentError> {
        let (number, found) =
            number(&bytes[field.clone()], self.separator).ok_or_else(|| not_a_number(bytes, field))?;
        if found.is_some() && mark.is_some() && *mark != found {
            let hint = "the file mixes decimal points and decimal commas; use one of them throughout";
            return Err(not_a_number(bytes, field).hint(hint));
        }
        *mark = mark.or(found);
        if !number.is_finite() {
            return Err(ContentErrorKind::not_finite(what, text_of(bytes, field)).at(field.clone()));
        }
        Ok(number)
    }
}

fn not_a_number(bytes: &[u8], field: &Range<usize>) -> ContentError {
    let found = if field.is_empty() { "nothing".to_owned() } else { text_of(bytes, field) };
    ContentErrorKind::expected("a number", found).at(field.clone())
}
