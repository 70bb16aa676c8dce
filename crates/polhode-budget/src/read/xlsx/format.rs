//! Number formats of a workbook: percent, dates, and decimals.

use std::collections::HashMap;
use std::sync::Arc;

use polhode_source::ContentError;
use polhode_source::package::xml::{Token, Xml};

use super::strings::is;

/// Number format of a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Number with this many decimals, if stated.
    Number {
        decimals: Option<u8>,
    },
    /// Number with text before and after it. The text counts as written in the cell: a unit.
    Quoted {
        decimals: Option<u8>,
        text: Arc<[String; 2]>,
    },
    Percent,
    /// Number in thousands or millions, with a comma after its digits.
    Thousands,
    Date,
}

/// Characters that mark the number in a format code.
const DIGITS: [char; 4] = ['0', '#', '?', 'g'];

impl Format {
    pub(crate) const GENERAL: Self = Self::Number { decimals: None };

    /// Parses a format code such as `0.00`, `#,##0.0" kg"` or `yyyy-mm-dd`.
    fn of_code(code: &str) -> Self {
        let mut plain = String::new();
        let mut text = [String::new(), String::new()];
        let mut characters = code.chars();
        while let Some(c) = characters.next() {
            match c {
                // The rest is not for positive numbers.
                ';' => break,
                '"' => text[usize::from(plain.contains(DIGITS))]
                    .extend(characters.by_ref().take_while(|c| *c != '"')),
                '\\' => text[usize::from(plain.contains(DIGITS))].extend(characters.next()),
                '_' | '*' => _ = characters.next(),
                '[' => {
                    let inside: String = characters.by_ref().take_while(|c| *c != ']').collect();
                    let is_time = !inside.is_empty() && inside.chars().all(|c| "hmsHMS".contains(c));
                    plain.extend(is_time.then_some('h'));
                }
                c => plain.push(c.to_ascii_lowercase()),
            }
        }
        let text = text.map(|text| text.trim().to_owned());
        let with = |decimals| match text.iter().all(String::is_empty) {
            true => Self::Number { decimals },
            false => Self::Quoted { decimals, text: Arc::new(text.clone()) },
        };
        if plain.contains("general") {
            return with(None);
        }
        if plain.contains('%') {
            return Self::Percent;
        }
        if plain.contains(['y', 'm', 'd', 'h', 's']) {
            return Self::Date;
        }
        if plain.contains(['e', '/', '@']) || !plain.contains(['0', '#', '?']) {
            return with(None);
        }
        let whole = plain.split('.').next().unwrap_or_default();
        if plain.trim_end().ends_with(',') || whole.trim_end().ends_with(',') {
            return Self::Thousands;
        }
        let behind = plain.split_once('.').map_or("", |(_, behind)| behind);
        let decimals = behind.chars().take_while(|c| "0#?".contains(*c)).count();
        with(u8::try_from(decimals).ok())
    }

    /// Returns a built-in format, which has no code.
    fn built_in(number: u32) -> Self {
        match number {
            1 | 3 | 37 | 38 => Self::Number { decimals: Some(0) },
            2 | 4 | 39 | 40 => Self::Number { decimals: Some(2) },
            9 | 10 => Self::Percent,
            14..=22 | 27..=36 | 45..=47 | 50..=58 => Self::Date,
            _ => Self::GENERAL,
        }
    }
}

/// Reads the formats, in the order of the indices that cells refer to.
pub(crate) fn read(mut xml: Xml<'_, '_>) -> Result<Vec<Format>, ContentError> {
    let (mut codes, mut formats) = (HashMap::new(), Vec::new());
    let mut buffer = Vec::new();
    let mut is_of_cells = false;
    loop {
        match xml.next(&mut buffer)? {
            Token::Start(element) if is(&element, "numFmt") => {
                let [number, code] = xml.values(&element, ["numFmtId", "formatCode"])?;
                let number = number.and_then(|number| number.parse::<u32>().ok());
                codes.extend(number.map(|number| (number, Format::of_code(&code.unwrap_or_default()))));
            }
            Token::Start(element) if is(&element, "cellXfs") => is_of_cells = true,
            Token::Start(element) if is(&element, "cellStyles") || is(&element, "dxfs") => {
                is_of_cells = false;
            }
            Token::Start(element) if is_of_cells && is(&element, "xf") => {
                let [number] = xml.values(&element, ["numFmtId"])?;
                let number = number.and_then(|number| number.parse::<u32>().ok());
                let of = |number| codes.get(&number).cloned().unwrap_or_else(|| Format::built_in(number));
                formats.push(number.map_or(Format::GENERAL, of));
            }
            Token::Eof => return Ok(formats),
            Token::Start(_) | Token::Text(_) | Token::End | Token::Other => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_say_how_numbers_are_shown() {
        let decimals = |decimals| Format::Number { decimals: Some(decimals) };
        let quoted = |decimals, front: &str, behind: &str| Format::Quoted {
            decimals,
            text: Arc::new([front.to_owned(), behind.to_owned()]),
        };
        for (code, expected) in [
            ("General", Format::GENERAL),
            ("0.000", decimals(3)),
            ("#,##0.0\" kg\"", quoted(Some(1), "", "kg")),
            ("0\\ \\g", quoted(Some(0), "", "g")),
            ("\"about \"0.0", quoted(Some(1), "about", "")),
            ("General\" mm\"", quoted(None, "", "mm")),
            ("#,##0_);[Red](#,##0.00)", decimals(0)),
            ("0.0%", Format::Percent),
            ("#,##0,\" t\"", Format::Thousands),
            ("0.0,,", Format::Thousands),
            ("0,.0", Format::Thousands),
            ("0\\%", quoted(Some(0), "", "%")),
            ("yyyy-mm-dd", Format::Date),
            ("[h]:mm", Format::Date),
            ("[$-409]d\\-mmm\\-yy", Format::Date),
            ("[Red]0.0", decimals(1)),
            ("0.00E+00", Format::GENERAL),
            ("# ?/?", Format::GENERAL),
            ("@", Format::GENERAL),
        ] {
            assert_eq!(Format::of_code(code), expected, "{code}");
        }
    }
}
