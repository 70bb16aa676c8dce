//! Elements of the trees of a text and of those that it names.

use std::collections::HashMap;
use std::ops::Range;

use roxmltree::Node;

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

use super::document::Document;
use super::written::{Written, is_true};

/// The trees of a text and of those that it names. Places count through all of them: each begins where the one before has its end, and a byte more.
#[derive(Debug)]
pub struct Forest<'a> {
    first: Tree<'a>,
    others: Vec<Tree<'a>>,
    links: Links,
    /// What an `<include>` names stands in its place.
    splices: bool,
}

/// Which file an element names: by the file that it stands in and its first byte there.
pub type Links = HashMap<(usize, usize), usize>;

#[derive(Debug)]
struct Tree<'a> {
    document: &'a Document<'a>,
    /// The place of its first byte.
    start: usize,
}

impl<'a> Forest<'a> {
    /// One tree alone.
    pub fn of_one(document: &'a Document<'a>) -> Self {
        Self { first: Tree { document, start: 0 }, others: Vec::new(), links: Links::new(), splices: false }
    }

    /// Several, each with the place of its first byte.
    ///
    /// # Errors
    /// [`ContentError`] for none.
    pub fn of(
        trees: impl Iterator<Item = (&'a Document<'a>, usize)>,
        links: Links,
        splices: bool,
    ) -> Result<Self, ContentError> {
        let mut trees = trees.map(|(document, start)| Tree { document, start });
        let missing = || {
            let kind = ContentErrorKind::Missing { what: "root element".to_owned() };
            ContentError::new(kind, ContentPlace::Whole)
        };
        let first = trees.next().ok_or_else(missing)?;
        Ok(Self { first, others: trees.collect(), links, splices })
    }

    /// The root of the first tree.
    pub fn root(&'a self) -> Element<'a> {
        Element::new(self.first.document.0.root_element(), self, 0)
    }

    fn tree(&self, number: usize) -> Option<&Tree<'a>> {
        number.checked_sub(1).map_or(Some(&self.first), |other| self.others.get(other))
    }

    /// The root of the file that stands in the place of an element.
    fn spliced(&'a self, element: Element<'a>) -> Option<Element<'a>> {
        element.linked().filter(|_| self.splices && element.name() == "include")
    }

    /// The place of a tree's first byte.
    fn start(&self, tree: usize) -> usize {
        self.tree(tree).map_or(0, |tree| tree.start)
    }

    /// The root of the file that the element at this byte of a tree names.
    fn linked(&'a self, tree: usize, byte: usize) -> Option<Element<'a>> {
        let target = *self.links.get(&(tree, byte))?;
        Some(Element::new(self.tree(target)?.document.0.root_element(), self, target))
    }
}

/// An element of a tree. What it includes stands among its children in its place.
#[derive(Clone, Copy, Debug)]
pub struct Element<'a> {
    node: Node<'a, 'a>,
    forest: &'a Forest<'a>,
    tree: usize,
}

impl<'a> Element<'a> {
    const fn new(node: Node<'a, 'a>, forest: &'a Forest<'a>, tree: usize) -> Self {
        Self { node, forest, tree }
    }

    /// Its name; a prefix is part of it, with an underscore: `xacro_macro`.
    pub fn name(self) -> &'a str {
        self.node.tag_name().name()
    }

    /// From the `<` of its start to the `>` of its end.
    pub fn span(self) -> Range<usize> {
        self.shifted(self.node.range())
    }

    /// Bytes of its own text as places.
    fn shifted(self, range: Range<usize>) -> Range<usize> {
        let start = self.forest.start(self.tree);
        start + range.start..start + range.end
    }

    /// The file that it stands in: 0 is the first.
    pub const fn tree(self) -> usize {
        self.tree
    }

    /// The root of the file that it names, if that was read.
    pub fn linked(self) -> Option<Self> {
        self.forest.linked(self.tree, self.node.range().start)
    }

    /// The whole text, without comments.
    pub fn document(self) -> &'a str {
        self.node.document().input_text()
    }

    /// The elements in it.
    pub fn children(self) -> Children<'a> {
        Children { forest: self.forest, levels: vec![(self.node.children(), self.tree)] }
    }

    /// The elements in it that have this name.
    pub fn named(self, name: &'a str) -> impl Iterator<Item = Element<'a>> {
        self.children().filter(move |child| child.name() == name)
    }

    /// The first element in it that has this name.
    pub fn child(self, name: &str) -> Option<Element<'a>> {
        self.children().find(|child| child.name() == name)
    }

    /// The text in the first element in it that has this name.
    pub fn child_text(self, name: &str) -> Option<Written<'a>> {
        self.child(name).and_then(Element::text)
    }

    /// What an attribute says.
    pub fn attribute(self, name: &str) -> Option<Written<'a>> {
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
    pub fn attribute_names(self) -> impl Iterator<Item = &'a str> {
        self.node.attributes().map(|attribute| attribute.name())
    }

    /// The words of an attribute, if it is there.
    pub fn word(self, name: &str) -> Option<&'a str> {
        self.attribute(name).map(|written| written.value)
    }

    /// Whether an attribute says `true` or `1`.
    pub fn says_true(self, name: &str) -> bool {
        self.word(name).is_some_and(is_true)
    }

    /// Whether it declares a prefix of names: `xmlns:xacro`.
    pub fn has_prefix(self, prefix: &str) -> bool {
        self.node.attributes().any(|attribute| attribute.name().strip_prefix("xmlns_") == Some(prefix))
    }

    /// The text in it. What stands beside text as an element is part of it as it is written, `<a/>`, which is no number and no
    /// name.
    pub fn text(self) -> Option<Written<'a>> {
        let says = |node: &Node<'a, 'a>| node.text().is_none_or(|text| !text.trim().is_empty());
        let mut nodes = self.node.children().filter(says);
        let first = nodes.next()?;
        let others = nodes.next().map(|second| nodes.next_back().unwrap_or(second));
        let text = self.node.document().input_text();
        let written = match others {
            None if first.is_text() => Written::new(text, first.range(), first.text().unwrap_or("")),
            Some(last) if self.node.children().any(|node| node.is_text() && says(&node)) => {
                Written::raw(text, first.range().start..last.range().end)
            }
            _ => return None,
        };
        Some(written.moved(self.forest.start(self.tree)))
    }
}

/// The elements in an element, and in place of each `<include>` those of the file that it names.
#[derive(Debug)]
pub struct Children<'a> {
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
