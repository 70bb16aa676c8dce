//! USD layer as text (`.usda`): nested prims with metadata and properties, and their positions.
//!
//! A variant is a prim here, with the path of its spec: `/robot{hand=left}`.
//!
//! Source: openusd.org, "Text File Format". Values are stored flat, in order: numbers, and words or
//! strings.

use std::collections::HashMap;

use polhode_source::{ContentError, ContentErrorKind};

use super::statement::Reader;
use super::token::{TokenKind, tokens};
use super::value::Value;
use crate::model::{Name, Span};

/// Maximum nesting depth of prims and variants.
const MOST_DEPTH: usize = 500;

/// Layer: its metadata and its prims, each after its parent.
#[derive(Debug, Default)]
pub(super) struct Layer {
    pub(super) metadata: HashMap<String, Value>,
    pub(super) prims: Vec<Prim>,
    /// Positions of variant sets.
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
    /// True for a `class`, which only provides opinions to others, for a variant, for the
    /// descendants of both, and for inactive prims.
    pub(super) is_abstract: bool,
    /// True for an `over` of a prim that a layer may define which is not read.
    pub(super) is_over: bool,
}

/// Element whose `}` has not been read.
enum Open {
    /// Prim or variant, with its index.
    Prim(usize),
    /// Variant set with its name.
    Set(String),
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
    /// Returns true if other layers or prims contribute to the stage of this layer.
    pub(super) fn has_arcs(&self) -> bool {
        const ARCS: [&str; 8] = [
            "references",
            "payload",
            "inherits",
            "specializes",
            "subLayers",
            "relocates",
            "clips",
            "instanceable",
        ];
        let own = |metadata: &HashMap<String, Value>| ARCS.iter().any(|key| metadata.contains_key(*key));
        !self.variants.is_empty() || own(&self.metadata) || self.prims.iter().any(|prim| own(&prim.metadata))
    }

    pub(super) fn of(text: &str) -> Result<Self, ContentError> {
        let tokens = tokens(text)?;
        let mut layer = Self::default();
        let mut reader = Reader { tokens: &tokens, at: 0, end: text.len(), twice: Vec::new() };
        if reader.takes('(') {
            layer.metadata = reader.metadata()?;
            layer.note_twice(&mut reader, None);
        }
        let mut open: Vec<Open> = Vec::new();
        while let Some(token) = reader.peek() {
            match (&token.kind, open.last()) {
                (TokenKind::Mark('}'), Some(_)) => {
                    reader.at += 1;
                    open.pop();
                }
                (TokenKind::Text(variant), Some(Open::Set(set))) => {
                    let name = Name { text: format!("{{{set}={variant}}}"), span: token.span.clone() };
                    reader.at += 1;
                    layer.put(&mut reader, &mut open, token.span.clone(), name, String::new(), true)?;
                }
                (_, Some(Open::Set(_))) => return Err(reader.expected("the name of a variant")),
                (TokenKind::Mark(';'), _) => reader.at += 1,
                (TokenKind::Word(word), _) if matches!(*word, "def" | "over" | "class") => {
                    layer.prim(&mut reader, &mut open)?;
                }
                (TokenKind::Word("variantSet"), Some(Open::Prim(_))) => {
                    layer.variants.push(token.span.clone());
                    reader.at += 1;
                    let Some(TokenKind::Text(set)) = reader.next().map(|token| &token.kind) else {
                        return Err(reader.expected("the name of the variant set"));
                    };
                    reader.expect('=')?;
                    reader.expect('{')?;
                    open.push(Open::Set((*set).to_owned()));
                }
                (TokenKind::Word(_), prim) => {
                    let prim = if let Some(Open::Prim(prim)) = prim { Some(*prim) } else { None };
                    let property = reader.property()?;
                    if let (Some(property), Some(prim)) = (property, prim)
                        && let Some(prim) = layer.prims.get_mut(prim)
                    {
                        reader.twice.extend(property.put_into(&mut prim.properties));
                    }
                    layer.note_twice(&mut reader, prim);
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
    fn prim(&mut self, reader: &mut Reader<'_, '_>, open: &mut Vec<Open>) -> Result<(), ContentError> {
        let Some(first) = reader.next() else { return Ok(()) };
        let is_class = matches!(first.kind, TokenKind::Word("class"));
        let mut kind = String::new();
        let name = loop {
            match reader.next().map(|token| (&token.kind, token.span.clone())) {
                Some((TokenKind::Word(word), _)) => kind = (*word).to_owned(),
                Some((TokenKind::Text(text), span)) => break Name { text: (*text).to_owned(), span },
                _ => return Err(reader.expected("the name of the prim")),
            }
        };
        self.put(reader, open, first.span.clone(), name, kind, is_class)
    }

    /// Adds a prim or variant whose name has been read; reads on up to its `{`.
    fn put(
        &mut self,
        reader: &mut Reader<'_, '_>,
        open: &mut Vec<Open>,
        first: Span,
        name: Name,
        kind: String,
        mut is_abstract: bool,
    ) -> Result<(), ContentError> {
        if open.len() >= MOST_DEPTH {
            let what = format!("prims nested deeper than {MOST_DEPTH}");
            return Err(ContentErrorKind::unsupported(what).at(first));
        }
        let (mut parenthesis, mut metadata) = (None, HashMap::new());
        if reader.takes('(') {
            parenthesis = Some(reader.last_end());
            metadata = reader.metadata()?;
        }
        reader.expect('{')?;
        let openings = (parenthesis, reader.last_end());
        let parent =
            open.iter().rev().find_map(|open| if let Open::Prim(k) = open { Some(*k) } else { None });
        let around = parent.and_then(|parent| self.prims.get(parent));
        let path = child_path(around.map_or("", |around| &around.path), &name.text);
        self.path_bytes += path.len();
        require_short(self.path_bytes, reader.end, first.clone())?;
        is_abstract |= around.is_some_and(|around| around.is_abstract);
        is_abstract |= metadata.get("active").is_some_and(Value::is_false);
        open.push(Open::Prim(self.prims.len()));
        self.prims.push(Prim {
            kind,
            span: first.start..name.span.end + 1,
            name,
            parent,
            path,
            openings,
            metadata,
            properties: HashMap::new(),
            is_abstract,
            is_over: false,
        });
        let last = self.prims.len().checked_sub(1);
        self.note_twice(reader, last);
        Ok(())
    }
}

/// Returns the path of a prim or variant by its parent's path: `/a/b`, `/a{set=name}`,
/// `/a{set=name}b`.
fn child_path(parent: &str, name: &str) -> String {
    let slash = if name.starts_with('{') || parent.ends_with('}') { "" } else { "/" };
    format!("{parent}{slash}{name}")
}
