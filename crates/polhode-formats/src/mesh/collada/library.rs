//! The elements of a document by their ids.

use std::collections::HashMap;

use crate::content::ContentError;
use crate::xml::Element;

use super::value::{missing, positive, unsupported};

/// All elements that have an `id`.
pub(super) struct Library<'a>(HashMap<&'a str, Element<'a>>);

impl<'a> Library<'a> {
    /// Those of a document in one unit: an `<asset>` inside may say another, which no program that writes it is known to do.
    pub(super) fn of(root: Element<'a>, unit: f64) -> Result<Self, ContentError> {
        let mut named = HashMap::new();
        let mut waiting = vec![root];
        while let Some(element) = waiting.pop() {
            if let Some(id) = element.word("id") {
                named.entry(id).or_insert(element);
            }
            if element.name() == "asset"
                && let Some(own) = meter(element)?
                && own != unit
            {
                return Err(unsupported(element, " in another unit than that of the file"));
            }
            waiting.extend(element.children());
        }
        Ok(Self(named))
    }

    /// The element that an attribute of another names: `url="#id"`.
    pub(super) fn named(
        &self,
        by: Element<'a>,
        attribute: &str,
        what: &str,
    ) -> Result<Element<'a>, ContentError> {
        let url = by.word(attribute).unwrap_or("");
        let element = self.0.get(url.trim_start_matches('#')).copied();
        element.ok_or_else(|| missing(&format!("{what} {:?}", url.trim_start_matches('#')), by))
    }
}

/// Metres in the unit that an `<asset>` says.
pub(super) fn meter(asset: Element<'_>) -> Result<Option<f64>, ContentError> {
    let unit = asset.child("unit").and_then(|unit| unit.attribute("meter"));
    unit.map(|meter| positive(&meter)).transpose()
}
