//! Elements of a document by their ids.

use std::collections::HashMap;

use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_source::xml::Element;
use polhode_source::{ContentError, ContentErrorKind};

use super::value::{missing, positive, start, unsupported};

/// Elements that are referred to by id.
const NAMED: [&str; 6] = ["visual_scene", "node", "geometry", "vertices", "source", "float_array"];

/// Elements by element name and id: the first with that id, and a second one if there is a
/// duplicate.
pub(crate) struct Library<'a>(HashMap<(&'a str, &'a str), (Element<'a>, Option<Element<'a>>)>);

impl<'a> Library<'a> {
    /// Collects the elements of a document with a single unit. An inner `<asset>` may state another
    /// unit, but no known program writes one.
    pub(crate) fn of(root: Element<'a>, unit: f64) -> Result<Self, ContentError> {
        let mut named = HashMap::new();
        let mut waiting = vec![root];
        while let Some(element) = waiting.pop() {
            if NAMED.contains(&element.name())
                && let Some(id) = element.word("id")
            {
                let entry = named.entry((element.name(), id));
                entry.and_modify(|(_, other)| *other = Some(element)).or_insert((element, None));
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

    /// Returns the element of this name that an attribute refers to: `url="#id"`.
    pub(crate) fn named(
        &self,
        by: Element<'a>,
        attribute: &str,
        name: &'static str,
    ) -> Result<Element<'a>, ContentError> {
        let url = by.word(attribute).unwrap_or("");
        let (file, id) = url.split_once('#').unwrap_or(("", url));
        if !file.is_empty() {
            return Err(unsupported(by, &format!(" that is in another file, {file:?}")));
        }
        match self.0.get(&(name, id)) {
            Some((element, None)) => Ok(*element),
            Some((first, Some(other))) => {
                let later = if first.span().start < other.span().start { other } else { first };
                let (what, rule) = (format!("the id of <{name}>"), "that of one element");
                let kind = ContentErrorKind::value(what, format!("{id:?}"), rule);
                Err(ContentError::new(kind, start(*later)))
            }
            None => Err(missing(&format!("{name} {id:?}"), by)),
        }
    }
}

/// Returns the unit of length in an `<asset>`, m.
///
/// A number that contradicts the name of the unit is an error. Programs read the number, but either
/// may be intended.
pub(crate) fn meter(asset: Element<'_>) -> Result<Option<f64>, ContentError> {
    /// Tolerance for numbers rounded to three digits.
    const EQUAL: f64 = 0.002;
    let Some(element) = asset.child("unit") else { return Ok(None) };
    match (element.attribute("meter"), element.word("name")) {
        (Some(written), name) => {
            let meter = positive(&written)?;
            match name.and_then(|name| unit::spelt(name, Dimension::LENGTH)) {
                Some(metres) if (meter / metres - 1.0).abs() > EQUAL => {
                    let name = name.unwrap_or_default();
                    let what = format!("meter of the unit {name:?}");
                    let rule = format!("{metres}, as its name implies");
                    let kind = ContentErrorKind::value(what, written.value.to_owned(), rule);
                    let hint =
                        format!("write meter=\"{metres}\", or name the unit whose length is {meter} m");
                    Err(kind.at(written.span).hint(hint))
                }
                _ => Ok(Some(meter)),
            }
        }
        (None, None | Some("meter" | "metre" | "m")) => Ok(None),
        (None, Some(name)) => Err(missing(&format!("meter of the unit {name:?}"), element)),
    }
}
