//! The elements of a document by their ids.

use std::collections::HashMap;

use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_source::xml::Element;
use polhode_source::{ContentError, ContentErrorKind};

use super::value::{missing, positive, start, unsupported};

/// What others name.
const NAMED: [&str; 6] = ["visual_scene", "node", "geometry", "vertices", "source", "float_array"];

/// The elements that others name, by their names and ids: the first that has both, and another if there is one.
pub(crate) struct Library<'a>(HashMap<(&'a str, &'a str), (Element<'a>, Option<Element<'a>>)>);

impl<'a> Library<'a> {
    /// Those of a document in one unit: an `<asset>` inside may say another, which no program that writes it is known to do.
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

    /// The element of this name that an attribute of another names: `url="#id"`.
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

/// Metres in the unit that an `<asset>` states.
///
/// A number that contradicts the name is an error: programs read the number, but either may be meant.
pub(crate) fn meter(asset: Element<'_>) -> Result<Option<f64>, ContentError> {
    /// Numbers are rounded to three digits or more.
    const EQUAL: f64 = 0.002;
    let Some(element) = asset.child("unit") else { return Ok(None) };
    match (element.attribute("meter"), element.word("name")) {
        (Some(written), name) => {
            let meter = positive(&written)?;
            match name.and_then(|name| unit::spelt(name, Dimension::LENGTH)) {
                Some(metres) if (meter / metres - 1.0).abs() > EQUAL => {
                    let name = name.unwrap_or_default();
                    let what = format!("meter of the unit {name:?}");
                    let rule = format!("{metres}, as the name says");
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
