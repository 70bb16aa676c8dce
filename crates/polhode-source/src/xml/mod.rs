//! XML with the place of every element and attribute.
//!
//! Readers of models are namespace-unaware and tolerant, so a text goes through [`plain()`] before
//! it is parsed. Document types and custom entities are refused. Memory is bounded by the size of
//! the text.

mod document;
mod element;
mod plain;
mod written;

use crate::content::ContentError;

pub use document::Document;
pub use element::{Children, Element, Forest, Links};
pub use plain::{plain, second_root};
pub use written::{Name, Number, Written, is_true};

/// Parses a text and calls `read` with its root element.
///
/// ```
/// use polhode_source::xml::with_root;
/// let sides = with_root("<box>\n  <size>0.3 1.7 2.2</size></box>", |root| {
///     Ok(root.child_text("size").and_then(|size| size.array()))
/// })?;
/// assert_eq!(sides, Some([0.3, 1.7, 2.2]));
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] for text that is not well-formed XML or has a document type, and errors of
/// `read`.
pub fn with_root<T>(
    text: &str,
    read: impl FnOnce(Element<'_>) -> Result<T, ContentError>,
) -> Result<T, ContentError> {
    let copy = plain(text)?;
    let document = Document::parse(text, &copy)?;
    let forest = Forest::of_one(&document);
    read(forest.root())
}
