//! Content of a cell.

use std::ops::Range;

use polhode_source::ContentError;
use polhode_source::package::xml::{Token, Xml};

use super::format::Format;
use super::strings::{inside, is};
use crate::read::cell::{Broken, Content};

#[derive(Debug)]
pub(crate) enum RawText {
    /// Range in the texts of the sheet.
    Own(Range<usize>),
    /// Index of a shared string.
    Shared(usize),
}

/// Type of value that a cell declares.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Number,
    Shared,
    Text,
    Truth,
    Error,
    Date,
}

impl Kind {
    pub(crate) fn named(name: &str) -> Self {
        match name {
            "s" => Self::Shared,
            "str" | "inlineStr" => Self::Text,
            "b" => Self::Truth,
            "e" => Self::Error,
            "d" => Self::Date,
            _ => Self::Number,
        }
    }
}

/// Cell whose text was appended to the texts of the sheet.
pub(crate) struct Written<'f> {
    pub kind: Kind,
    pub format: Format,
    pub formula: Option<&'f str>,
    /// True if the text is an element of the cell, not a value.
    pub is_text: bool,
    /// Start of its text in the texts of the sheet.
    pub start: usize,
}

/// Reads the content of a cell that was just entered. Its text is appended to `texts`.
pub(crate) fn value(
    xml: &mut Xml<'_, '_>,
    buffer: &mut Vec<u8>,
    kind: Kind,
    format: Format,
    strings: usize,
    texts: &mut String,
) -> Result<Option<(RawText, Content)>, ContentError> {
    let start = texts.len();
    let (mut formula, mut is_text) = (None, false);
    let (mut depth, mut element_of) = (1, b' ');
    while depth > 0 {
        match xml.next(buffer)? {
            Token::Start(element) if is(&element, "is") => {
                drop(element);
                texts.push_str(&inside(xml)?);
                is_text = true;
            }
            Token::Start(element) => {
                depth += 1;
                element_of = if is(&element, "v") { b'v' } else { b' ' };
                if is(&element, "f") {
                    (formula, element_of) = (Some(String::new()), b'f');
                }
            }
            Token::End => {
                depth -= 1;
                element_of = b' ';
            }
            Token::Text(text) if element_of == b'v' => texts.push_str(&text),
            Token::Text(text) if element_of == b'f' => formula.iter_mut().for_each(|f| f.push_str(&text)),
            Token::Text(_) | Token::Other => {}
            Token::Eof => break,
        }
    }
    let written = Written { kind, format, formula: formula.as_deref(), is_text, start };
    written
        .content(strings, texts)
        .map_err(|number| xml.refused("the string", &number, "one of the workbook's"))
}

impl Written<'_> {
    /// Returns the content of the cell. `strings` is the number of shared strings. An index beyond
    /// them is the error.
    pub(crate) fn content(
        self,
        strings: usize,
        texts: &mut String,
    ) -> Result<Option<(RawText, Content)>, String> {
        let Self { kind, format, formula, is_text, start } = self;
        let result = texts.get(start..).unwrap_or_default().trim();
        let content = match (kind, format) {
            _ if is_text => Content::Text,
            _ if result.is_empty() => {
                let Some(formula) = formula.filter(|_| kind != Kind::Text) else { return Ok(None) };
                texts.push('=');
                texts.push_str(formula);
                Content::Broken(Broken::NoResult)
            }
            (Kind::Shared, _) => {
                let number = result.parse::<usize>().ok().filter(|number| *number < strings);
                let number = number.ok_or_else(|| result.to_owned())?;
                texts.truncate(start);
                return Ok(Some((RawText::Shared(number), Content::Text)));
            }
            (Kind::Text, _) => Content::Text,
            (Kind::Truth, _) => {
                let truth = if truth(result) { "true" } else { "false" };
                texts.truncate(start);
                texts.push_str(truth);
                Content::Text
            }
            (Kind::Error, _) => Content::Broken(Broken::Error),
            (_, Format::Thousands) => Content::Broken(Broken::Thousands),
            (Kind::Date, _) | (_, Format::Date) => Content::Broken(Broken::Date),
            (_, Format::Percent) => {
                let percent = format!("{} %", hundredfold(result));
                texts.truncate(start);
                texts.push_str(&percent);
                Content::Number { decimals: None }
            }
            (_, Format::Number { decimals }) => Content::Number { decimals },
            (_, Format::Quoted { decimals, text }) => {
                let [front, behind] = text.as_ref();
                let shown = format!("{front} {result} {behind}").trim().to_owned();
                texts.truncate(start);
                texts.push_str(&shown);
                Content::Number { decimals }
            }
        };
        Ok(Some((RawText::Own(start..texts.len()), content)))
    }
}

pub(crate) fn truth(text: &str) -> bool {
    matches!(text.trim(), "1" | "true")
}

/// Multiplies a number by 100, in its digits.
fn hundredfold(number: &str) -> String {
    let (digits, power) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let Ok(power) = power.parse::<i32>() else { return number.to_owned() };
    let (whole, behind) = digits.split_once('.').unwrap_or((digits, ""));
    if power != 0 || !behind.bytes().all(|b| b.is_ascii_digit()) {
        return format!("{digits}e{}", power.saturating_add(2));
    }
    let (first, rest) = behind.split_at(behind.len().min(2));
    let moved = format!("{whole}{first:0<2}");
    let trimmed = moved.trim_start_matches('0');
    let moved = if trimmed.is_empty() { "0" } else { trimmed };
    if rest.is_empty() { moved.to_owned() } else { format!("{moved}.{rest}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percents_have_the_digits_of_their_numbers() {
        for (number, expected) in [
            ("0.15", "15"),
            ("0.075", "7.5"),
            ("1", "100"),
            ("0", "0"),
            ("0.005", "0.5"),
            ("0.1234", "12.34"),
            ("1.5E-3", "1.5e-1"),
            ("12.5", "1250"),
        ] {
            assert_eq!(hundredfold(number), expected, "{number}");
        }
    }
}
