//! XML as a stream of elements with line numbers.

use std::borrow::Cow;
use std::fmt;
use std::io::BufRead;

use quick_xml::events::attributes::Attribute;
use quick_xml::events::{BytesStart, Event};
use quick_xml::name::{QName, ResolveResult};
use quick_xml::reader::NsReader;
use quick_xml::{Error, XmlVersion};

use super::archive::Stream;
use crate::content::{ContentError, ContentErrorKind, ContentPlace};

/// Streaming reader of one entry.
pub struct Xml<'s, 'a> {
    reader: NsReader<Stream<'s, 'a>>,
    entry: String,
    depth: usize,
}

impl fmt::Debug for Xml<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Xml").field("entry", &self.entry).finish_non_exhaustive()
    }
}

/// Next part of an entry. An empty element gives a start and an end.
#[derive(Debug)]
pub enum Token<'b> {
    /// Start of an element.
    Start(BytesStart<'b>),
    /// Text between tags with entities resolved.
    Text(Cow<'b, str>),
    /// End of an element.
    End,
    /// Comment or processing instruction.
    Other,
    /// End of the document.
    Eof,
}

impl<'s, 'a> Xml<'s, 'a> {
    /// Creates a reader of an entry.
    pub fn new(stream: Stream<'s, 'a>, entry: &str) -> Self {
        let mut reader = NsReader::from_reader(stream);
        reader.config_mut().expand_empty_elements = true;
        Self { reader, entry: entry.to_owned(), depth: 0 }
    }

    /// Returns the current line, from 1.
    pub fn line(&self) -> usize {
        self.reader.get_ref().line
    }

    /// Returns the next token; the buffer holds its text.
    pub fn next<'b>(&mut self, buffer: &'b mut Vec<u8>) -> Result<Token<'b>, ContentError> {
        buffer.clear();
        match self.reader.read_event_into(buffer) {
            Err(e) => Err(self.broken(&e)),
            Ok(Event::Start(element)) => {
                self.depth += 1;
                Ok(Token::Start(element))
            }
            Ok(Event::End(_)) => {
                self.depth = self.depth.saturating_sub(1);
                Ok(Token::End)
            }
            Ok(Event::Eof) if self.depth > 0 => {
                let (what, found) = ("the end of an element".to_owned(), String::new());
                Err(self.error(ContentErrorKind::Expected { what, found }).hint("the file is cut short"))
            }
            Ok(Event::Eof) => Ok(Token::Eof),
            Ok(Event::DocType(_)) => {
                let what = "XML with a document type declaration, which packages must not have".to_owned();
                Err(self.error(ContentErrorKind::Unsupported { what }))
            }
            Ok(Event::Text(text)) => Ok(Token::Text(text.into_inner())),
            Ok(Event::CData(text)) => Ok(Token::Text(text.into_inner())),
            Ok(Event::GeneralRef(name)) => {
                if let Ok(Some(character)) = name.resolve_char_ref() {
                    return Ok(Token::Text(Cow::Owned(character.into())));
                }
                let character = quick_xml::escape::resolve_predefined_entity(&name);
                Ok(Token::Text(Cow::Borrowed(character.unwrap_or("\u{fffd}"))))
            }
            Ok(Event::Empty(_) | Event::Comment(_) | Event::Decl(_) | Event::PI(_)) => Ok(Token::Other),
        }
    }

    /// Returns the next bytes that are unpacked already; call it directly after the start or end of
    /// an element.
    pub fn ahead(&self) -> &[u8] {
        self.reader.get_ref().unpacked()
    }

    /// Skips `count` bytes; they must be whole elements and the text between them.
    pub fn pass(&mut self, count: usize) {
        self.reader.get_mut().consume(count);
    }

    /// Skips the rest of the current element.
    pub fn skip(&mut self) -> Result<(), ContentError> {
        let (outside, mut buffer) = (self.depth.saturating_sub(1), Vec::new());
        while self.depth > outside {
            self.next(&mut buffer)?;
        }
        Ok(())
    }

    /// Returns the namespace of an element; empty if it has none.
    pub fn namespace(&self, element: &BytesStart<'_>) -> &str {
        name(&self.reader.resolver().resolve_element(element.name()).0)
    }

    /// Returns the namespace of an attribute; empty if it has none.
    pub fn namespace_of(&self, attribute: &Attribute<'_>) -> &str {
        name(&self.reader.resolver().resolve_attribute(attribute.key).0)
    }

    /// Returns the namespace of a prefix.
    pub fn prefixed(&self, prefix: &str) -> &str {
        name(&self.reader.resolver().resolve_attribute(QName(&format!("{prefix}:x"))).0)
    }

    /// Iterates over the attributes of an element.
    pub fn attributes<'e>(
        &self,
        element: &'e BytesStart<'_>,
    ) -> impl Iterator<Item = Result<Attribute<'e>, ContentError>> {
        // The duplicate check of the parser takes quadratic time; the readers refuse duplicates
        // themselves.
        let mut attributes = element.attributes();
        attributes.with_checks(false);
        attributes.map(|attribute| attribute.map_err(|e| self.broken(&Error::InvalidAttr(e))))
    }

    /// Returns the value of an attribute with entities resolved.
    pub fn value<'e>(&self, attribute: &Attribute<'e>) -> Result<Cow<'e, str>, ContentError> {
        attribute.normalized_value(XmlVersion::Implicit1_0).map_err(|e| self.broken(&e))
    }

    /// Returns the values of the attributes with these names; `None` for a missing one.
    pub fn values<'e, const N: usize>(
        &self,
        element: &'e BytesStart<'_>,
        names: [&str; N],
    ) -> Result<[Option<Cow<'e, str>>; N], ContentError> {
        let mut values = [const { None }; N];
        for attribute in self.attributes(element) {
            let attribute = attribute?;
            let value = self.value(&attribute)?;
            let slots = names.iter().zip(&mut values);
            slots
                .filter(|(name, _)| **name == attribute.key.0)
                .for_each(|(_, slot)| *slot = Some(value.clone()));
        }
        Ok(values)
    }

    /// Creates an error at the current line.
    pub fn error(&self, kind: ContentErrorKind) -> ContentError {
        ContentError::new(kind, ContentPlace::Within(self.place()))
    }

    /// Returns the entry and the current line, as text.
    pub fn place(&self) -> String {
        format!("{}, line {}", self.entry, self.line())
    }

    /// Creates an error for a value that breaks a rule.
    pub fn refused(&self, what: &str, value: &str, rule: &str) -> ContentError {
        let (what, value, rule) = (what.to_owned(), value.to_owned(), rule.to_owned());
        self.error(ContentErrorKind::Value { what, value, rule })
    }

    /// Creates an error for a missing part.
    pub fn missing(&self, what: &str) -> ContentError {
        self.error(ContentErrorKind::Missing { what: what.to_owned() })
    }

    fn broken(&self, error: &Error) -> ContentError {
        let (what, rule) = match error {
            Error::Io(_) => ("the entry", "an entry that decompresses completely"),
            Error::Encoding(_) => ("the text", "UTF-8"),
            _ => ("the XML", "well-formed"),
        };
        self.refused(what, &error.to_string(), rule)
    }
}

fn name<'r>(resolved: &ResolveResult<'r>) -> &'r str {
    match resolved {
        ResolveResult::Bound(namespace) => namespace.into_inner(),
        ResolveResult::Unbound | ResolveResult::Unknown(_) => "",
    }
}
