//! Trees of several texts that name one another.

use std::collections::HashMap;

use roxmltree::Document;

use crate::read::xml::Element;

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
