//! Parsing of XML text into a tree.

use std::ops::Range;

use roxmltree::{Error, ParsingOptions};

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

/// Tree of an XML text.
#[derive(Debug)]
pub struct Document<'a>(pub roxmltree::Document<'a>);

impl<'a> Document<'a> {
    /// Parses a text into a tree; `copy` is the text after `plain`.
    ///
    /// # Errors
    /// [`ContentError`], with its place, for text that is not well-formed XML.
    pub fn parse(text: &str, copy: &'a str) -> Result<Self, ContentError> {
        // At most two nodes for every `<` (a tag and the text after it), and two for the document.
        let most = 2 * copy.bytes().filter(|&byte| byte == b'<').count() + 2;
        let options = ParsingOptions {
            allow_dtd: false,
            nodes_limit: u32::try_from(most).unwrap_or(u32::MAX),
            entity_resolver: None,
        };
        let tree = roxmltree::Document::parse_with_options(copy, options);
        tree.map(Self).map_err(|error| unreadable(text, &error))
    }
}

/// Converts an error of the parser, with its place.
fn unreadable(text: &str, error: &Error) -> ContentError {
    let position = error.pos();
    let span = match error {
        Error::NoRootNode => 0..0,
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => text.len()..text.len(),
        _ => at(text, position.row, position.col),
    };
    let (what, found) = match error {
        Error::UnexpectedCloseTag(expected, actual, _) => (format!("</{expected}>"), format!("</{actual}>")),
        Error::UnclosedRootNode => ("the end of the root element".to_owned(), String::new()),
        _ => {
            // The error has its own place; it is removed from the message.
            let said = error.to_string().replace(&format!(" at {position}"), "");
            (format!("well-formed XML ({said})"), text.get(span.clone()).unwrap_or("").to_owned())
        }
    };
    let hint = match error {
        Error::UnknownEntityReference(..) | Error::MalformedEntityReference(..) => {
            Some("write & as &amp;; the only entities are &amp; &lt; &gt; &quot; &apos; and &#…;")
        }
        Error::UnexpectedCloseTag(..) => Some("elements close in the opposite order of opening"),
        _ => None,
    };
    let error = ContentError::new(ContentErrorKind::Expected { what, found }, ContentPlace::Text(span));
    match hint {
        Some(hint) => error.hint(hint),
        None => error,
    }
}

/// Returns the bytes of the character at a line and column, both from 1.
fn at(text: &str, line: u32, column: u32) -> Range<usize> {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1) as usize).map(str::len).sum();
    let rest = text.get(before..).unwrap_or("");
    let start = rest.char_indices().nth(column.saturating_sub(1) as usize).map_or(rest.len(), |(k, _)| k);
    let length = rest.get(start..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8);
    before + start..before + start + length
}
