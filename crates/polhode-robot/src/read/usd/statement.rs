//! Statements of USD text: metadata, properties and values.

use std::collections::HashMap;

use polhode_source::{ContentError, ContentErrorKind};

use super::array::{self, ARRAYS};
use super::token::{Token, TokenKind};
use super::value::Value;
use crate::model::{Number, Span};

/// Maximum nesting depth of brackets in a value.
const MOST_BRACKETS: usize = 100;

/// List operation of a statement. Removals and orderings refer to lower layers, which are not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edit {
    /// The list is replaced.
    Explicit,
    /// `prepend`, `append` and `add`: the items are added.
    Added,
    /// `delete` and `reorder`: operations on items of other layers.
    OfOthers,
}

impl Edit {
    fn of(word: &str) -> Self {
        match word {
            "prepend" | "append" | "add" => Self::Added,
            "delete" | "reorder" => Self::OfOthers,
            _ => Self::Explicit,
        }
    }
}

/// Property or metadata key.
pub(super) struct Property {
    name: String,
    edit: Edit,
    value: Value,
}

impl Property {
    /// Inserts the property; returns its name and position if it was stated before.
    pub(super) fn put_into(self, all: &mut HashMap<String, Value>) -> Option<(String, Span)> {
        let Self { name, edit, value } = self;
        match (edit, all.get_mut(&name)) {
            (Edit::OfOthers, _) => None,
            (Edit::Added, Some(there)) => {
                there.numbers.extend(value.numbers);
                there.words.extend(value.words);
                None
            }
            _ => {
                let span = value.span.clone();
                all.insert(name.clone(), value).map(|_| (name, span))
            }
        }
    }
}

/// Reader of statements.
pub(super) struct Reader<'t, 's> {
    pub(super) tokens: &'t [Token<'s>],
    pub(super) at: usize,
    /// Length of the text.
    pub(super) end: usize,
    /// Names that were stated twice, and their positions.
    pub(super) twice: Vec<(String, Span)>,
}

impl<'t, 's> Reader<'t, 's> {
    pub(super) fn peek(&self) -> Option<&'t Token<'s>> {
        self.tokens.get(self.at)
    }

    pub(super) fn next(&mut self) -> Option<&'t Token<'s>> {
        let token = self.peek();
        self.at += 1;
        token
    }

    /// Returns the end of the last token that was read.
    pub(super) fn last_end(&self) -> usize {
        let last = self.at.checked_sub(1).and_then(|last| self.tokens.get(last));
        last.map_or(0, |token| token.span.end)
    }

    pub(super) fn takes(&mut self, mark: char) -> bool {
        let takes = self.peek().is_some_and(|token| token.is(mark));
        self.at += usize::from(takes);
        takes
    }

    pub(super) fn expect(&mut self, mark: char) -> Result<(), ContentError> {
        if self.takes(mark) { Ok(()) } else { Err(self.expected(&format!("a {mark}"))) }
    }

    pub(super) fn expected(&self, what: &str) -> ContentError {
        let span = self.peek().map_or(self.end..self.end, |token| token.span.clone());
        let found = self.peek().map_or_else(String::new, |token| token.kind.in_words());
        ContentErrorKind::expected(what, found).at(span)
    }

    /// Reads keys and values up to `)`.
    pub(super) fn metadata(&mut self) -> Result<HashMap<String, Value>, ContentError> {
        let mut metadata = HashMap::new();
        loop {
            match self.peek().map(|token| &token.kind) {
                Some(TokenKind::Mark(')')) => {
                    self.at += 1;
                    return Ok(metadata);
                }
                Some(TokenKind::Text(_) | TokenKind::Mark(';' | ',')) => self.at += 1,
                Some(TokenKind::Word(_)) => {
                    if let Some(property) = self.property()? {
                        self.twice.extend(property.put_into(&mut metadata));
                    }
                }
                _ => return Err(self.expected("a key of metadata, or the closing )")),
            }
        }
    }

    /// Reads words, the last of which is the name, and the value; `None` without a value.
    pub(super) fn property(&mut self) -> Result<Option<Property>, ContentError> {
        let (mut name, mut edit) = ("", Edit::Explicit);
        let mut is_first = true;
        while let Some(token) = self.peek().filter(|token| is_first || !token.begins_line) {
            match &token.kind {
                TokenKind::Word(word) => {
                    if is_first {
                        edit = Edit::of(word);
                    }
                    name = word;
                }
                TokenKind::Mark('[' | ']') => {}
                _ => break,
            }
            self.at += 1;
            is_first = false;
        }
        if !self.takes('=') {
            self.own_metadata()?;
            return Ok(None);
        }
        let mut value = self.value()?;
        if ARRAYS.contains(&name) && value.array.is_none() {
            // An array with comments, which was split into tokens.
            let numbers = value.numbers.drain(..).map(|number| number.value.unwrap_or(f64::NAN));
            value.array = Some(numbers.collect());
        }
        self.own_metadata()?;
        Ok(Some(Property { name: name.to_owned(), edit, value }))
    }

    /// Skips the metadata of a property.
    fn own_metadata(&mut self) -> Result<(), ContentError> {
        if self.takes('(') {
            self.metadata()?;
        }
        Ok(())
    }

    /// Reads a value: one word, or everything between brackets.
    fn value(&mut self) -> Result<Value, ContentError> {
        let mut value = Value::default();
        let mut closing: Vec<char> = Vec::new();
        let first = self.at;
        loop {
            let Some(token) = self.next() else { return Err(self.expected("the end of the value")) };
            match &token.kind {
                TokenKind::Mark('(') => closing.push(')'),
                TokenKind::Mark('[') => closing.push(']'),
                TokenKind::Mark('{') => closing.push('}'),
                TokenKind::Mark(mark @ (')' | ']' | '}')) => {
                    if closing.pop() != Some(*mark) {
                        self.at -= 1;
                        return Err(self.expected("the closing bracket"));
                    }
                }
                TokenKind::Mark(_) if closing.is_empty() => {
                    self.at -= 1;
                    return Err(self.expected("a value"));
                }
                TokenKind::Mark(_) => {}
                TokenKind::Number(text) => value.numbers.push(Number {
                    text: (*text).to_owned(),
                    span: token.span.clone(),
                    value: text.parse().ok(),
                }),
                TokenKind::Array(text) => value.array = Some(array::numbers(text)),
                // The keyword for no value.
                TokenKind::Word("None") => {}
                TokenKind::Word(word) => value.words.push((*word).to_owned()),
                TokenKind::Text(text) | TokenKind::Path(text) => value.words.push((*text).to_owned()),
                TokenKind::Asset(text) => value.words.push(format!("@{text}@")),
            }
            if closing.len() > MOST_BRACKETS {
                let what = format!("brackets nested deeper than {MOST_BRACKETS}");
                return Err(ContentErrorKind::unsupported(what).at(token.span.clone()));
            }
            if closing.is_empty() {
                // Path after an asset: @file@</prim>.
                let goes_on = self.peek().is_some_and(|next| {
                    !next.begins_line
                        && matches!(next.kind, TokenKind::Path(_))
                        && matches!(token.kind, TokenKind::Asset(_))
                });
                if !goes_on {
                    let start = self.tokens.get(first).map_or(0, |token| token.span.start);
                    value.span = start..token.span.end;
                    return Ok(value);
                }
            }
        }
    }
}
