//! USD layer as text (`.usda`): nested prims with metadata and properties.
//!
//! Source: openusd.org, "Text File Format". Values are stored flat, in order: numbers, and words or
//! strings.

use std::collections::HashMap;

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::token::{Token, TokenKind, tokens};
use crate::model::{Name, Number, Span};

/// Maximum nesting depth of prims.
const MOST_DEPTH: usize = 500;

/// Layer: its metadata and its prims, each after its parent.
#[derive(Debug, Default)]
pub(super) struct Layer {
    pub(super) metadata: HashMap<String, Value>,
    pub(super) prims: Vec<Prim>,
    /// Positions of variant sets, which are not read.
    pub(super) variants: Vec<Span>,
    /// Repeated statements: path of the prim (empty for the layer), name, and position.
    pub(super) twice: Vec<(String, String, Span)>,
    /// Total bytes of all paths.
    path_bytes: usize,
}

/// Prim of a layer.
#[derive(Debug)]
pub(super) struct Prim {
    /// Type: `"Xform"`; empty if omitted.
    pub(super) kind: String,
    pub(super) name: Name,
    pub(super) parent: Option<usize>,
    /// Path in the stage: `/robot/arm`.
    pub(super) path: String,
    /// Position of its specifier, type and name.
    pub(super) span: Span,
    /// Byte after the `(` of its metadata, if it has any, and byte after its `{`.
    pub(super) openings: (Option<usize>, usize),
    pub(super) metadata: HashMap<String, Value>,
    pub(super) properties: HashMap<String, Value>,
    /// True for a `class`, which only provides opinions to others, for its descendants, and for
    /// inactive prims.
    pub(super) is_abstract: bool,
}

/// Value of a property or metadata key.
#[derive(Clone, Debug, Default)]
pub(super) struct Value {
    pub(super) span: Span,
    pub(super) numbers: Vec<Number>,
    /// Strings, words, paths and assets, without delimiters.
    pub(super) words: Vec<String>,
}

impl Value {
    /// Returns numbers and words as text, separated by spaces.
    pub(super) fn text(&self) -> String {
        let numbers = self.numbers.iter().map(|number| number.text.as_str());
        numbers.chain(self.words.iter().map(String::as_str)).collect::<Vec<_>>().join(" ")
    }

    /// Returns true unless the value is empty or all zero, which means "not given" in USD.
    pub(super) fn is_given(&self) -> bool {
        !self.words.is_empty() || self.numbers.iter().any(|number| number.value != Some(0.0))
    }

    /// Returns true for `false`, which usdcat writes as 0 in attributes.
    pub(super) fn is_false(&self) -> bool {
        self.words.iter().any(|word| word == "false")
            || self.numbers.iter().any(|number| number.value == Some(0.0))
    }
}

impl Prim {
    /// Returns true if it has this attribute with the value false.
    pub(super) fn is_off(&self, name: &str) -> bool {
        self.properties.get(name).is_some_and(Value::is_false)
    }
}

/// Returns an error if the paths together are much longer than the text.
pub(super) fn require_short(bytes: usize, text: usize, span: Span) -> Result<(), ContentError> {
    const FOR_EACH_BYTE: usize = 16;
    const ANYHOW: usize = 1 << 24;
    if bytes <= FOR_EACH_BYTE * text + ANYHOW {
        return Ok(());
    }
    let what = "paths that are many times longer in total than the file";
    Err(ContentErrorKind::unsupported(what).at(span))
}

impl Layer {
    pub(super) fn of(text: &str) -> Result<Self, ContentError> {
        let tokens = tokens(text)?;
        let mut layer = Self::default();
        let mut reader = Reader { tokens: &tokens, at: 0, end: text.len(), twice: Vec::new() };
        if reader.takes('(') {
            layer.metadata = reader.metadata()?;
            layer.note_twice(&mut reader, None);
        }
        let mut open: Vec<usize> = Vec::new();
        while let Some(token) = reader.peek() {
            match &token.kind {
                TokenKind::Mark('}') if !open.is_empty() => {
                    reader.at += 1;
                    open.pop();
                }
                TokenKind::Mark(';') => reader.at += 1,
                TokenKind::Word(word) if matches!(*word, "def" | "over" | "class") => {
                    layer.prim(&mut reader, &mut open)?;
                }
                TokenKind::Word("variantSet") if !open.is_empty() => {
                    layer.variants.push(token.span.clone());
                    reader.at += 2; // and its name
                    reader.expect('=')?;
                    reader.value()?;
                }
                TokenKind::Word(_) => {
                    let property = reader.property()?;
                    if let (Some(property), Some(&prim)) = (property, open.last())
                        && let Some(prim) = layer.prims.get_mut(prim)
                    {
                        reader.twice.extend(property.put_into(&mut prim.properties));
                    }
                    layer.note_twice(&mut reader, open.last().copied());
                }
                _ => return Err(reader.expected("a prim or a property")),
            }
        }
        if open.is_empty() { Ok(layer) } else { Err(reader.expected("the } that ends the prim")) }
    }

    /// Takes over the reader's repeated statements, in a prim or in the layer itself.
    fn note_twice(&mut self, reader: &mut Reader<'_, '_>, prim: Option<usize>) {
        let path = |layer: &Self| prim.and_then(|prim| layer.prims.get(prim)).map(|prim| prim.path.clone());
        for (name, span) in reader.twice.drain(..) {
            self.twice.push((path(self).unwrap_or_default(), name, span));
        }
    }

    /// Reads the start of a prim, up to its `{`.
    fn prim(&mut self, reader: &mut Reader<'_, '_>, open: &mut Vec<usize>) -> Result<(), ContentError> {
        let Some(first) = reader.next() else { return Ok(()) };
        let mut is_abstract = matches!(first.kind, TokenKind::Word("class"));
        let mut kind = String::new();
        let name = loop {
            match reader.next().map(|token| (&token.kind, token.span.clone())) {
                Some((TokenKind::Word(word), _)) => kind = (*word).to_owned(),
                Some((TokenKind::Text(text), span)) => break Name { text: (*text).to_owned(), span },
                _ => return Err(reader.expected("the name of the prim")),
            }
        };
        if open.len() >= MOST_DEPTH {
            let what = format!("prims nested deeper than {MOST_DEPTH}");
            let place = ContentPlace::Text(first.span.clone());
            return Err(ContentError::new(ContentErrorKind::unsupported(what), place));
        }
        let (mut parenthesis, mut metadata) = (None, HashMap::new());
        if reader.takes('(') {
            parenthesis = Some(reader.last_end());
            metadata = reader.metadata()?;
        }
        reader.expect('{')?;
        let openings = (parenthesis, reader.last_end());
        let parent = open.last().copied();
        let around = parent.and_then(|parent| self.prims.get(parent));
        self.path_bytes += around.map_or(0, |around| around.path.len()) + name.text.len() + 1;
        require_short(self.path_bytes, reader.end, first.span.clone())?;
        let path = format!("{}/{}", around.map_or("", |around| &around.path), name.text);
        is_abstract |= around.is_some_and(|around| around.is_abstract);
        is_abstract |= metadata.get("active").is_some_and(Value::is_false);
        open.push(self.prims.len());
        let span = first.span.start..name.span.end + 1;
        self.prims.push(Prim {
            kind,
            name,
            parent,
            path,
            span,
            openings,
            metadata,
            properties: HashMap::new(),
            is_abstract,
        });
        self.note_twice(reader, open.last().copied());
        Ok(())
    }
}

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
struct Property {
    name: String,
    edit: Edit,
    value: Value,
}

impl Property {
    /// Inserts the property; returns its name and position if it was stated before.
    fn put_into(self, all: &mut HashMap<String, Value>) -> Option<(String, Span)> {
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

struct Reader<'t, 's> {
    tokens: &'t [Token<'s>],
    at: usize,
    /// Length of the text.
    end: usize,
    /// Names that were stated twice, and their positions.
    twice: Vec<(String, Span)>,
}

impl<'t, 's> Reader<'t, 's> {
    fn peek(&self) -> Option<&'t Token<'s>> {
        self.tokens.get(self.at)
    }

    fn next(&mut self) -> Option<&'t Token<'s>> {
        let token = self.peek();
        self.at += 1;
        token
    }

    /// Returns the end of the last token that was read.
    fn last_end(&self) -> usize {
        let last = self.at.checked_sub(1).and_then(|last| self.tokens.get(last));
        last.map_or(0, |token| token.span.end)
    }

    fn takes(&mut self, mark: char) -> bool {
        let takes = self.peek().is_some_and(|token| token.is(mark));
        self.at += usize::from(takes);
        takes
    }

    fn expect(&mut self, mark: char) -> Result<(), ContentError> {
        if self.takes(mark) { Ok(()) } else { Err(self.expected(&format!("a {mark}"))) }
    }

    fn expected(&self, what: &str) -> ContentError {
        let span = self.peek().map_or(self.end..self.end, |token| token.span.clone());
        let found = self.peek().map_or_else(String::new, |token| token.kind.in_words());
        ContentErrorKind::expected(what, found).at(span)
    }

    /// Reads keys and values up to `)`.
    fn metadata(&mut self) -> Result<HashMap<String, Value>, ContentError> {
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
    fn property(&mut self) -> Result<Option<Property>, ContentError> {
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
        let value = self.value()?;
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
                // The keyword for no value.
                TokenKind::Word("None") => {}
                TokenKind::Word(word) => value.words.push((*word).to_owned()),
                TokenKind::Text(text) | TokenKind::Path(text) => value.words.push((*text).to_owned()),
                TokenKind::Asset(text) => value.words.push(format!("@{text}@")),
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
