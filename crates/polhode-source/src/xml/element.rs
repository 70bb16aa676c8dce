//! Elements of an XML text and of the texts that it includes.

use std::collections::HashMap;
use std::ops::Range;

use roxmltree::Node;

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

use super::document::Document;
use super::written::{Written, is_true};

/// Trees of a text and of the texts that it names. Byte offsets are numbered through all texts; one
/// byte separates consecutive texts.
#[derive(Debug)]
pub struct Forest<'a> {
    first: Tree<'a>,
    others: Vec<Tree<'a>>,
    links: Links,
    /// True if the content of a file replaces the `<include>` that names it.
    splices: bool,
}

/// File named by an element; the key is the number of the containing file and the element's first
/// byte there.
pub type Links = HashMap<(usize, usize), usize>;

#[derive(Debug)]
struct Tree<'a> {
    document: &'a Document<'a>,
    /// Offset of its first byte in the combined numbering.
    start: usize,
}

impl<'a> Forest<'a> {
    /// Creates a forest of one tree.
    pub fn of_one(document: &'a Document<'a>) -> Self {
        Self { first: Tree { document, start: 0 }, others: Vec::new(), links: Links::new(), splices: false }
    }

    /// Creates a forest of several trees, each with the offset of its first byte.
    ///
    /// # Errors
    /// [`ContentError`] if `trees` is empty.
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

    /// Returns the root of the first tree.
    pub fn root(&'a self) -> Element<'a> {
        Element::new(self.first.document.0.root_element(), self, 0)
    }

    fn tree(&self, number: usize) -> Option<&Tree<'a>> {
        number.checked_sub(1).map_or(Some(&self.first), |other| self.others.get(other))
    }

    /// Returns the root of the file that replaces an `<include>` element.
    fn spliced(&'a self, element: Element<'a>) -> Option<Element<'a>> {
        element.linked().filter(|_| self.splices && element.name() == "include")
    }

    /// Returns the offset of a tree's first byte.
    fn start(&self, tree: usize) -> usize {
        self.tree(tree).map_or(0, |tree| tree.start)
    }

    /// Returns the root of the file that is named by the element at this byte of a tree.
    fn linked(&'a self, tree: usize, byte: usize) -> Option<Element<'a>> {
        let target = *self.links.get(&(tree, byte))?;
        Some(Element::new(self.tree(target)?.document.0.root_element(), self, target))
    }
}

/// Element of a tree. The content of an included file counts among its children.
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

    /// Returns the name; a prefix is part of it, with an underscore: `xacro_macro`.
    pub fn name(self) -> &'a str {
        self.node.tag_name().name()
    }

    /// Returns the bytes from the `<` of the start tag to the `>` of the end tag.
    pub fn span(self) -> Range<usize> {
        self.shifted(self.node.range())
    }

    /// Converts a range of the element's own text to the combined numbering.
    fn shifted(self, range: Range<usize>) -> Range<usize> {
        let start = self.forest.start(self.tree);
        start + range.start..start + range.end
    }

    /// Returns the number of the containing file; 0 is the first.
    pub const fn tree(self) -> usize {
        self.tree
    }

    /// Returns the root of the file that the element names, if that file was read.
    pub fn linked(self) -> Option<Self> {
        self.forest.linked(self.tree, self.node.range().start)
    }

    /// Returns the whole text of the file without comments.
    pub fn document(self) -> &'a str {
        self.node.document().input_text()
    }

    /// Returns the child elements.
    pub fn children(self) -> Children<'a> {
        Children { forest: self.forest, levels: vec![(self.node.children(), self.tree)] }
    }

    /// Returns the child elements with this name.
    pub fn named(self, name: &'a str) -> impl Iterator<Item = Element<'a>> {
        self.children().filter(move |child| child.name() == name)
    }

    /// Returns the first child element with this name.
    pub fn child(self, name: &str) -> Option<Element<'a>> {
        self.children().find(|child| child.name() == name)
    }

    /// Returns the text of the first child element with this name.
    pub fn child_text(self, name: &str) -> Option<Written<'a>> {
        self.child(name).and_then(Element::text)
    }

    /// Returns the value of an attribute.
    pub fn attribute(self, name: &str) -> Option<Written<'a>> {
        self.node.attribute_node(name).map(|attribute| {
            let range = attribute.range();
            let text = self.node.document().input_text();
            // The value extends from the matching quote to the last character. The range of the
            // parser itself is wrong after 255 blanks.
            let all = text.get(range.clone()).unwrap_or("");
            let quote = all.chars().next_back().unwrap_or('"');
            let inner = all.strip_suffix(quote).unwrap_or(all);
            let start = range.start + inner.rfind(quote).map_or(0, |at| at + quote.len_utf8());
            let end = range.start + inner.len();
            Written::new(text, start..end, attribute.value()).moved(self.forest.start(self.tree))
        })
    }

    /// Returns the names of all attributes.
    pub fn attribute_names(self) -> impl Iterator<Item = &'a str> {
        self.node.attributes().map(|attribute| attribute.name())
    }

    /// Returns the text of an attribute, if it is present.
    pub fn word(self, name: &str) -> Option<&'a str> {
        self.attribute(name).map(|written| written.value)
    }

    /// Returns true if an attribute is `true` or `1`.
    pub fn says_true(self, name: &str) -> bool {
        self.word(name).is_some_and(is_true)
    }

    /// Returns true if the element declares a prefix, such as `xmlns:xacro`.
    pub fn has_prefix(self, prefix: &str) -> bool {
        self.node.attributes().any(|attribute| attribute.name().strip_prefix("xmlns_") == Some(prefix))
    }

    /// Returns the text content. Child elements between text are part of it as written, such as
    /// `<a/>`, which is then neither a valid number nor a valid name.
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

/// Iterator over the child elements; the elements of an included file replace each `<include>`.
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
