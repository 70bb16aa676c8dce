//! Shared strings of a workbook.

use polhode_source::ContentError;
use polhode_source::package::xml::{Token, Xml};
use quick_xml::events::BytesStart;

/// Concatenated shared strings of a workbook.
#[derive(Debug, Default)]
pub(crate) struct Strings {
    text: String,
    ends: Vec<usize>,
}

impl Strings {
    /// Returns a string by its index.
    pub(crate) fn get(&self, number: usize) -> Option<&str> {
        let start = match number.checked_sub(1) {
            Some(before) => *self.ends.get(before)?,
            None => 0,
        };
        self.text.get(start..*self.ends.get(number)?)
    }

    pub(crate) const fn len(&self) -> usize {
        self.ends.len()
    }
}

/// Reads all strings in their order.
pub(crate) fn read(mut xml: Xml<'_, '_>) -> Result<Strings, ContentError> {
    let mut all = Strings::default();
    let mut buffer = Vec::new();
    loop {
        match xml.next(&mut buffer)? {
            Token::Start(element) if is(&element, "si") => {
                all.text.push_str(&inside(&mut xml)?);
                all.ends.push(all.text.len());
            }
            Token::Eof => return Ok(all),
            Token::Start(_) | Token::Text(_) | Token::End | Token::Other => {}
        }
    }
}

/// Returns the text in an element that was just entered, from all its runs, without phonetic text.
pub(crate) fn inside(xml: &mut Xml<'_, '_>) -> Result<String, ContentError> {
    let mut text = String::new();
    let mut buffer = Vec::new();
    let (mut depth, mut is_text) = (1, false);
    while depth > 0 {
        match xml.next(&mut buffer)? {
            Token::Start(element) if is(&element, "rPh") => {
                drop(element);
                xml.skip()?;
            }
            Token::Start(element) => {
                depth += 1;
                is_text = is(&element, "t");
            }
            Token::End => {
                depth -= 1;
                is_text = false;
            }
            Token::Text(part) if is_text => text.push_str(&part),
            Token::Text(_) | Token::Other => {}
            Token::Eof => break,
        }
    }
    Ok(text)
}

pub(crate) fn is(element: &BytesStart<'_>, name: &str) -> bool {
    element.local_name().into_inner() == name
}
