//! XML with the place of everything that is written in it.
//!
//! Readers of models are namespace-unaware and forgiving, so a text is made [`plain()`] before it is parsed. No document types, no entities of one's own;
//! memory is bounded by the bytes that are there.

mod document;
mod element;
mod plain;
mod written;

use crate::content::ContentError;

pub use document::Document;
pub use element::{Children, Element, Forest, Links};
pub use plain::{plain, second_root};
pub use written::{Name, Number, Written, is_true};

/// Reads a text as a tree and makes something of its root element.
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
/// [`ContentError`] for what is no XML, has a document type, or what `read` refuses.
pub fn with_root<T>(
    text: &str,
    read: impl FnOnce(Element<'_>) -> Result<T, ContentError>,
) -> Result<T, ContentError> {
    let copy = plain(text)?;
    let document = Document::parse(text, &copy)?;
    let forest = Forest::of_one(&document);
    read(forest.root())
}
