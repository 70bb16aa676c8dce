//! Inertials as XML elements, in place of an old one or as the first child of their link.

use std::collections::HashMap;

use polhode_source::ContentError;

use super::digits::{Digits, InertialDigits};
use crate::model::{Link, ModelFormat, RobotModel, Span};
use crate::read::xml::{Element, with_root};

/// Elements of links in a text, by their first byte.
pub(super) struct LinkElements(HashMap<usize, LinkElement>);

/// Element of a link.
struct LinkElement {
    /// End of the start tag.
    start_tag: usize,
    /// Own inertial, if there is one.
    inertial: Option<Span>,
    /// First byte of the first child.
    first_child: Option<usize>,
}

impl LinkElements {
    /// Finds the elements of links and bodies in a text.
    ///
    /// # Errors
    /// [`ContentError`] if the text is not well-formed XML.
    pub(super) fn of(text: &str) -> Result<Self, ContentError> {
        with_root(text, |root| {
            let mut found = HashMap::new();
            let mut waiting = vec![root];
            while let Some(element) = waiting.pop() {
                waiting.extend(element.children());
                if matches!(element.name(), "link" | "body") {
                    found.extend(Self::one(element).map(|one| (element.span().start, one)));
                }
            }
            Ok(Self(found))
        })
    }

    fn one(element: Element<'_>) -> Option<LinkElement> {
        let span = element.span();
        let start_tag = span.start + end_of_tag(element.document().get(span)?)?;
        Some(LinkElement {
            start_tag,
            inertial: element.child("inertial").map(Element::span),
            first_child: element.children().next().map(|child| child.span().start),
        })
    }

    /// Returns the edits that write the inertial of a link.
    ///
    /// # Errors
    /// The reason in words why it cannot be written.
    pub(super) fn edits(
        &self,
        model: &RobotModel,
        link: &Link,
        digits: &InertialDigits,
    ) -> Result<Vec<(Span, String)>, String> {
        let Some(element) = self.0.get(&link.span.start) else {
            return Err("its element was not found".to_owned());
        };
        let lines = lines(model.format, digits);
        let text = &model.text;
        let end = line_end(text);
        let (span, indent) = match &element.inertial {
            Some(old) => {
                let has_lines =
                    lines.len() == 1 || text.get(old.clone()).is_some_and(|old| old.contains(end));
                (old.clone(), own_indent(text, old.start).filter(|_| has_lines))
            }
            None if link.inertial.is_some() => {
                return Err("its inertial is in a <frame>, which places it".to_owned());
            }
            None => {
                let begins_line = text.get(element.start_tag..).is_some_and(|rest| {
                    rest.find(end)
                        .is_some_and(|length| rest.get(..length).is_some_and(|rest| rest.trim().is_empty()))
                });
                let of_child = element.first_child.and_then(|child| own_indent(text, child));
                (element.start_tag..element.start_tag, of_child.filter(|_| begins_line))
            }
        };
        let Some(indent) = indent else {
            return Ok(vec![(span, lines.into_iter().map(|(_, line)| line).collect())]);
        };
        let around = own_indent(text, link.span.start).unwrap_or("");
        let step = indent.strip_prefix(around).filter(|step| !step.is_empty()).unwrap_or("  ");
        let indented = |(depth, line): (usize, String)| format!("{indent}{}{line}", step.repeat(depth));
        let all = lines.into_iter().map(indented).collect::<Vec<_>>().join(end);
        if element.inertial.is_none() {
            return Ok(vec![(span, format!("{end}{all}"))]);
        }
        Ok(by_lines(text, span, all.trim_start(), end))
    }
}

/// Returns the edits from a span to a new text, one for each line that changes if both have as many
/// lines.
fn by_lines(text: &str, span: Span, new: &str, end: &str) -> Vec<(Span, String)> {
    let old = text.get(span.clone()).unwrap_or_default();
    if old.split(end).count() != new.split(end).count() {
        return vec![(span, new.to_owned())];
    }
    let mut at = span.start;
    let mut edits = Vec::new();
    for (old, new) in old.split(end).zip(new.split(end)) {
        if old != new {
            edits.push((at..at + old.len(), new.to_owned()));
        }
        at += old.len() + end.len();
    }
    edits
}

/// Returns the lines of an inertial with their depths.
fn lines(
    format: ModelFormat,
    InertialDigits { mass, center, tensor, .. }: &InertialDigits,
) -> Vec<(usize, String)> {
    let words =
        |digits: &[&Digits]| digits.iter().map(|digits| digits.text.as_str()).collect::<Vec<_>>().join(" ");
    let [x, y, z] = center;
    let center = words(&[x, y, z]);
    let [xx, yy, zz, xy, xz, yz] = tensor;
    let named = [("ixx", xx), ("ixy", xy), ("ixz", xz), ("iyy", yy), ("iyz", yz), ("izz", zz)];
    let mass = &mass.text;
    match format {
        ModelFormat::Mjcf => {
            let full = words(&[xx, yy, zz, xy, xz, yz]);
            vec![(0, format!("<inertial pos=\"{center}\" mass=\"{mass}\" fullinertia=\"{full}\"/>"))]
        }
        ModelFormat::Sdf => {
            let elements = named.map(|(name, digits)| (2, format!("<{name}>{}</{name}>", digits.text)));
            let before = [
                (0, "<inertial>".to_owned()),
                (1, format!("<pose>{center} 0 0 0</pose>")),
                (1, format!("<mass>{mass}</mass>")),
                (1, "<inertia>".to_owned()),
            ];
            let after = [(1, "</inertia>".to_owned()), (0, "</inertial>".to_owned())];
            before.into_iter().chain(elements).chain(after).collect()
        }
        ModelFormat::Urdf | ModelFormat::Usd | ModelFormat::Osim => {
            let elements = named.map(|(name, digits)| format!("{name}=\"{}\"", digits.text)).join(" ");
            vec![
                (0, "<inertial>".to_owned()),
                (1, format!("<origin xyz=\"{center}\" rpy=\"0 0 0\"/>")),
                (1, format!("<mass value=\"{mass}\"/>")),
                (1, format!("<inertia {elements}/>")),
                (0, "</inertial>".to_owned()),
            ]
        }
    }
}

/// Returns the line end of a text.
pub(super) fn line_end(text: &str) -> &'static str {
    match text.find('\n') {
        Some(at) if text.get(..at).is_some_and(|before| before.ends_with('\r')) => "\r\n",
        None if text.contains('\r') => "\r",
        _ => "\n",
    }
}

/// Returns the blanks before a position, if nothing else is before it in its line.
pub(super) fn own_indent(text: &str, position: usize) -> Option<&str> {
    let before = text.get(..position)?;
    let line = before.rsplit(['\n', '\r']).next()?.trim_start_matches('\u{feff}');
    line.chars().all(|c| c == ' ' || c == '\t').then_some(line)
}

/// Returns the length of the start tag of an element.
fn end_of_tag(element: &str) -> Option<usize> {
    let mut quote = None;
    for (at, c) in element.char_indices() {
        match (quote, c) {
            (None, '>') => return Some(at + 1),
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if open == c => quote = None,
            _ => {}
        }
    }
    None
}
