//! Elements and what is written in them, each with its place in the text.

use std::collections::HashMap;

use polhode_formats::{ContentError, ContentErrorKind, ContentPlace};
use roxmltree::{Document, Error, Node, ParsingOptions};

use crate::model::{Name, Number, Slot, Span};
use crate::read::plain::plain;

/// Reads a text as a tree and makes something of its root element.
///
/// No document types, no entities of one's own, no namespaces; memory is bounded by the bytes that are there.
pub(crate) fn with_root<T>(
    text: &str,
    read: impl FnOnce(Element<'_>) -> Result<T, ContentError>,
) -> Result<T, ContentError> {
    with_root_at(text, 0, read)
}

/// As [`with_root`], for a text whose places count from `start`; those of an error count from 0.
pub(crate) fn with_root_at<T>(
    text: &str,
    start: usize,
    read: impl FnOnce(Element<'_>) -> Result<T, ContentError>,
) -> Result<T, ContentError> {
    let copy = plain(text)?;
    let document = parsed_document(text, &copy)?;
    let forest = Forest::of_one(&document, start);
    read(forest.root())
}

/// The tree of a text; `copy` is the text made plain.
pub(super) fn parsed_document<'a>(text: &str, copy: &'a str) -> Result<Document<'a>, ContentError> {
    // a node each for at most every < and the text after it, and one for the document
    let most = 2 * copy.bytes().filter(|&byte| byte == b'<').count() + 2;
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: u32::try_from(most).unwrap_or(u32::MAX),
        entity_resolver: None,
    };
    Document::parse_with_options(copy, options).map_err(|error| unreadable(text, &error))
}

/// What the parser says, and where.
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
            // the place is the error's own and need not be in the message
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

/// The byte of a line and a character, both from 1.
fn at(text: &str, line: u32, column: u32) -> Span {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1) as usize).map(str::len).sum();
    let rest = text.get(before..).unwrap_or("");
    let start = rest.char_indices().nth(column.saturating_sub(1) as usize).map_or(rest.len(), |(k, _)| k);
    let length = rest.get(start..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8);
    before + start..before + start + length
}

/// The trees of a text and of those that it names. Places count through all of them, as [`crate::model::Source`] says.
#[derive(Debug)]
pub(crate) struct Forest<'a> {
    trees: Vec<Tree<'a>>,
    links: Links,
    /// What an `<include>` names stands in its place.
    splices: bool,
}

/// Which file an element names: by the file that it stands in and its first byte there.
pub(super) type Links = HashMap<(usize, usize), usize>;

#[derive(Debug)]
struct Tree<'a> {
    document: &'a Document<'a>,
    /// The place of its first byte.
    start: usize,
}

impl<'a> Forest<'a> {
    /// One tree alone.
    pub(super) fn of_one(document: &'a Document<'a>, start: usize) -> Self {
        Self { trees: vec![Tree { document, start }], links: Links::new(), splices: false }
    }

    /// Several, each with the place of its first byte.
    pub(super) fn of(
        trees: impl Iterator<Item = (&'a Document<'a>, usize)>,
        links: Links,
        splices: bool,
    ) -> Self {
        Self { trees: trees.map(|(document, start)| Tree { document, start }).collect(), links, splices }
    }

    /// The root of the first tree.
    pub(super) fn root(&'a self) -> Element<'a> {
        Element::new(self.trees[0].document.root_element(), self, 0)
    }

    /// The root of the file that stands in the place of an element.
    pub(super) fn spliced(&'a self, element: Element<'a>) -> Option<Element<'a>> {
        element.linked().filter(|_| self.splices && element.name() == "include")
    }

    /// The place of a tree's first byte.
    pub(super) fn start(&self, tree: usize) -> usize {
        self.trees.get(tree).map_or(0, |tree| tree.start)
    }

    /// The root of the file that the element at this byte of a tree names.
    pub(super) fn linked(&'a self, tree: usize, byte: usize) -> Option<Element<'a>> {
        let target = *self.links.get(&(tree, byte))?;
        Some(Element::new(self.trees.get(target)?.document.root_element(), self, target))
    }
}

/// An element of a tree. What it includes stands among its children in its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Element<'a> {
    node: Node<'a, 'a>,
    forest: &'a Forest<'a>,
    tree: usize,
}

impl<'a> Element<'a> {
    pub(super) const fn new(node: Node<'a, 'a>, forest: &'a Forest<'a>, tree: usize) -> Self {
        Self { node, forest, tree }
    }

    /// Its name; a prefix is part of it, with an underscore: `xacro_macro`.
    pub(crate) fn name(self) -> &'a str {
        self.node.tag_name().name()
    }

    /// From the `<` of its start to the `>` of its end.
    pub(crate) fn span(self) -> Span {
        self.shifted(self.node.range())
    }

    /// Bytes of its own text as places.
    fn shifted(self, range: Span) -> Span {
        let start = self.forest.start(self.tree);
        start + range.start..start + range.end
    }

    /// The file that it stands in: 0 is the first.
    pub(crate) const fn tree(self) -> usize {
        self.tree
    }

    /// The root of the file that it names, if that was read.
    pub(crate) fn linked(self) -> Option<Self> {
        self.forest.linked(self.tree, self.node.range().start)
    }

    /// The whole text, without comments.
    pub(crate) fn document(self) -> &'a str {
        self.node.document().input_text()
    }

    /// The elements in it.
    pub(crate) fn children(self) -> Children<'a> {
        Children { forest: self.forest, levels: vec![(self.node.children(), self.tree)] }
    }

    /// The elements in it that have this name.
    pub(crate) fn named(self, name: &'a str) -> impl Iterator<Item = Element<'a>> {
        self.children().filter(move |child| child.name() == name)
    }

    /// The first element in it that has this name.
    pub(crate) fn child(self, name: &str) -> Option<Element<'a>> {
        self.children().find(|child| child.name() == name)
    }

    /// The text in the first element in it that has this name.
    pub(crate) fn child_text(self, name: &str) -> Option<Written<'a>> {
        self.child(name).and_then(Element::text)
    }

    /// What an attribute says.
    pub(crate) fn attribute(self, name: &str) -> Option<Written<'a>> {
        self.node.attribute_node(name).map(|attribute| {
            let range = attribute.range();
            let text = self.node.document().input_text();
            // the value stands between the last character and the quote before it that is like it; the parser's own range is
            // wrong after 255 blanks
            let all = text.get(range.clone()).unwrap_or("");
            let quote = all.chars().next_back().unwrap_or('"');
            let inner = all.strip_suffix(quote).unwrap_or(all);
            let start = range.start + inner.rfind(quote).map_or(0, |at| at + quote.len_utf8());
            let end = range.start + inner.len();
            Written::new(text, start..end, attribute.value()).moved(self.forest.start(self.tree))
        })
    }

    /// The names of all attributes.
    pub(crate) fn attribute_names(self) -> impl Iterator<Item = &'a str> {
        self.node.attributes().map(|attribute| attribute.name())
    }

    /// The words of an attribute, if it is there.
    pub(crate) fn word(self, name: &str) -> Option<&'a str> {
        self.attribute(name).map(|written| written.value)
    }

    /// Whether an attribute says `true` or `1`.
    pub(crate) fn says_true(self, name: &str) -> bool {
        self.word(name).is_some_and(is_true)
    }

    /// Whether it declares a prefix of names: `xmlns:xacro`.
    pub(crate) fn has_prefix(self, prefix: &str) -> bool {
        self.node.attributes().any(|attribute| attribute.name().strip_prefix("xmlns_") == Some(prefix))
    }

    /// The text in it: the first that is not blank.
    pub(crate) fn text(self) -> Option<Written<'a>> {
        let text = self.node.document().input_text();
        let words =
            |node: &Node<'a, 'a>| node.is_text() && node.text().is_some_and(|text| !text.trim().is_empty());
        let node = self.node.children().find(words)?;
        let written = Written::new(text, node.range(), node.text().unwrap_or(""));
        Some(written.moved(self.forest.start(self.tree)))
    }
}

/// The elements in an element, and in place of each `<include>` those of the file that it names.
pub(crate) struct Children<'a> {
    forest: &'a Forest<'a>,
    levels: Vec<(roxmltree::Children<'a, 'a>, usize)>,
}

impl<'a> Iterator for Children<'a> {
    type Item = Element<'a>;

    fn next(&mut self) -> Option<Element<'a>> {
        loop {
            let (nodes, tree) = self.levels.last_mut()?;
            let tree = *tree;
            let Some(node) = nodes.next() else {
                self.levels.pop();
                continue;
            };
            if !node.is_element() {
                continue;
            }
            let element = Element::new(node, self.forest, tree);
            match self.forest.spliced(element) {
                Some(root) => self.levels.push((root.node.children(), root.tree)),
                None => return Some(element),
            }
        }
    }
}

/// `true` as these languages write it.
pub(crate) fn is_true(word: &str) -> bool {
    matches!(word.trim(), "true" | "1" | "True" | "TRUE")
}

/// The value of an attribute or the text of an element, without the blanks around it.
#[derive(Clone, Debug)]
pub(crate) struct Written<'a> {
    /// What it says.
    pub(crate) value: &'a str,
    /// Where it stands, without quotes.
    pub(crate) span: Span,
    /// The bytes of the text are the value itself: no entity stands for a character of it.
    literal: bool,
}

impl<'a> Written<'a> {
    fn new(text: &'a str, span: Span, value: &'a str) -> Self {
        let raw = text.get(span.clone()).unwrap_or("");
        if raw.contains(['&', '<']) {
            return Self { value: value.trim(), span, literal: false };
        }
        let start = span.start + (raw.len() - raw.trim_start().len());
        let value = raw.trim();
        Self { value, span: start..start + value.len(), literal: true }
    }

    /// The same, in a text whose places count from `start`.
    fn moved(mut self, start: usize) -> Self {
        self.span = start + self.span.start..start + self.span.end;
        self
    }

    /// As a name.
    pub(crate) fn name(&self) -> Name {
        Name { text: self.value.to_owned(), span: self.span.clone() }
    }

    /// As one number.
    pub(crate) fn number(&self) -> Number {
        Number { text: self.value.to_owned(), span: self.span.clone(), value: parsed(self.value) }
    }

    /// As numbers with blanks between them. With an entity in it, each stands where all of them stand.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = Number> {
        let from = self.value.as_ptr().addr();
        self.value.split_ascii_whitespace().map(move |word| {
            let start = self.span.start + (word.as_ptr().addr() - from);
            let span = if self.literal { start..start + word.len() } else { self.span.clone() };
            Number { text: word.to_owned(), span, value: parsed(word) }
        })
    }

    /// As plain values: NaN for NaN.
    pub(crate) fn values(&self) -> impl Iterator<Item = f64> {
        self.value.split_ascii_whitespace().map(|word| parsed(word).unwrap_or(f64::NAN))
    }

    /// As `N` plain values; `None` if there are fewer or more.
    pub(crate) fn array<const N: usize>(&self) -> Option<[f64; N]> {
        let mut values = self.values();
        let mut array = [0.0; N];
        for slot in &mut array {
            *slot = values.next()?;
        }
        values.next().is_none().then_some(array)
    }
}

/// The number that a word is. What overflows is infinite, `nan` is NaN.
fn parsed(word: &str) -> Option<f64> {
    word.parse().ok()
}

/// What an element's attribute says as a number, or that it lacks it.
pub(crate) fn slot(element: Element<'_>, name: &str) -> Slot {
    match element.attribute(name) {
        Some(written) => Slot::Given(written.number()),
        None => Slot::Missing { span: element.span(), name: name.to_owned() },
    }
}

/// What an element in the element says as a number, or that it lacks it.
pub(crate) fn child_slot(element: Element<'_>, name: &str) -> Slot {
    match element.child(name) {
        Some(child) => match child.text() {
            Some(written) => Slot::Given(written.number()),
            None => Slot::Given(Number { text: String::new(), span: child.span(), value: None }),
        },
        None => Slot::Missing { span: element.span(), name: name.to_owned() },
    }
}
