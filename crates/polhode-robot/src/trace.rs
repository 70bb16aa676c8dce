//! Traces findings about an expanded model to the files with its macros.
//!
//! A link or joint of the expanded text comes from an element whose name is the same, or has
//! expressions `${…}` and `$(…)` in the places of some characters. A finding moves there if exactly
//! one element can have made it. Otherwise it stays in the expanded text, and its message names the
//! file, and the macro if all candidates are in one.

use std::collections::BTreeSet;

use polhode_source::xml::{Document, Element, Forest, plain};

use crate::finding::Finding;
use crate::model::{RobotModel, Source, Span};

/// Moves the findings about an expanded model to its macros. Other models are not changed.
pub(crate) fn trace(model: &RobotModel, findings: &mut [Finding]) {
    let Some(expansion) = &model.expansion else { return };
    let Some(copies) = model.texts().next().and_then(|text| plain(text).ok()) else { return };
    let Ok(document) = Document::parse(&model.text, &copies) else { return };
    let expanded = Forest::of_one(&document);
    let texts: Vec<(&Source, String)> =
        model.included.iter().filter_map(|source| Some((source, plain(&source.text).ok()?))).collect();
    let documents = texts.iter().filter_map(|(source, copy)| {
        Document::parse(&source.text, copy).ok().map(|document| (*source, document))
    });
    let documents: Vec<(&Source, Document<'_>)> = documents.collect();
    let forests: Vec<(&Source, Forest<'_>)> =
        documents.iter().map(|(source, document)| (*source, Forest::of_one(document))).collect();
    let made: Vec<Made<'_>> =
        forests.iter().flat_map(|(source, forest)| elements(source, forest.root())).collect();
    let file = model.path.file_name().unwrap_or(model.path.as_os_str()).to_string_lossy();
    for finding in findings.iter_mut().filter(|finding| finding.span.start <= model.text.len()) {
        let root = expanded.root();
        let Some(named) = root.children().find(|child| holds(child.span(), &finding.span)) else {
            // A finding about the whole model is at its root element.
            if let Some((source, forest)) = forests
                .first()
                .filter(|(source, _)| source.path == model.path && finding.span.start <= root.span().start)
            {
                finding.span = moved(source, forest.root().span());
            }
            continue;
        };
        let candidates: Vec<&Made<'_>> = made.iter().filter(|made| made.can_be(named)).collect();
        let is_certain = |made: &&&Made<'_>| made.is_certain() && made.source.path == model.path;
        let certain: Vec<&&Made<'_>> = candidates.iter().filter(is_certain).collect();
        // Elements of one name cannot be told apart.
        let is_named_once = root.named(named.name()).filter(|other| same_name(*other, named)).count() == 1;
        let origin = match (certain.as_slice(), candidates.as_slice()) {
            _ if !is_named_once => None,
            ([one], _) => Some(**one),
            ([], [one]) if expansion.is_whole => Some(*one),
            _ => None,
        };
        match origin {
            Some(origin) => finding.span = moved(origin.source, place(named, origin.element, &finding.span)),
            None => {
                let macros: BTreeSet<Option<&str>> = candidates.iter().map(|made| made.of_macro).collect();
                let of_macro = match macros.iter().next() {
                    Some(Some(name)) if macros.len() == 1 && expansion.is_whole => format!(", macro {name}"),
                    _ => String::new(),
                };
                finding.message = format!("{}; expanded from {file}{of_macro}", finding.message);
            }
        }
    }
}

/// Link or joint in a file with macros.
#[derive(Clone, Copy, Debug)]
struct Made<'a> {
    source: &'a Source,
    element: Element<'a>,
    /// Name, perhaps with expressions.
    name: &'a str,
    /// Innermost macro that contains it.
    of_macro: Option<&'a str>,
    /// True if a condition contains it.
    is_conditional: bool,
}

impl Made<'_> {
    /// Returns true if the element can have made one of the expanded text.
    fn can_be(&self, expanded: Element<'_>) -> bool {
        self.element.name() == expanded.name()
            && expanded.word("name").is_some_and(|name| matches(self.name, name))
    }

    /// Returns true if the expanded text has the element under its own name, if it has the top
    /// level of the element's file.
    fn is_certain(&self) -> bool {
        self.of_macro.is_none() && !self.is_conditional && !self.name.contains('$')
    }
}

fn same_name(one: Element<'_>, other: Element<'_>) -> bool {
    one.word("name") == other.word("name")
}

/// Returns the links and joints of a file with macros.
fn elements<'a>(source: &'a Source, root: Element<'a>) -> Vec<Made<'a>> {
    let mut found = Vec::new();
    let mut waiting = vec![(root, None, false)];
    while let Some((element, of_macro, is_conditional)) = waiting.pop() {
        if matches!(element.name(), "link" | "joint")
            && let Some(name) = element.word("name")
        {
            found.push(Made { source, element, name, of_macro, is_conditional });
        }
        let of_macro = match element.name() {
            "xacro_macro" | "macro" => element.word("name").or(of_macro),
            _ => of_macro,
        };
        let tests = matches!(element.name(), "xacro_if" | "xacro_unless" | "if" | "unless");
        waiting.extend(element.children().map(|child| (child, of_macro, is_conditional || tests)));
    }
    found
}

/// Returns true if a name is that of a pattern, in which expressions stand for any characters.
fn matches(pattern: &str, name: &str) -> bool {
    let parts = literals(pattern);
    let Some((first, rest)) = parts.split_first() else { return false };
    let Some(mut name) = name.strip_prefix(first.as_str()) else { return false };
    let Some((last, middle)) = rest.split_last() else { return name.is_empty() };
    for part in middle {
        match name.split_once(part.as_str()) {
            Some((_, after)) => name = after,
            None => return false,
        }
    }
    name.ends_with(last.as_str())
}

/// Returns the literal parts of a text, before, between and after its expressions.
fn literals(pattern: &str) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut characters = pattern.chars().peekable();
    while let Some(c) = characters.next() {
        let close = match characters.peek() {
            Some('{') if c == '$' => '}',
            Some('(') if c == '$' => ')',
            _ => {
                parts.last_mut().into_iter().for_each(|part| part.push(c));
                continue;
            }
        };
        // As in xacro, an expression ends at the first closing bracket.
        let _ = characters.by_ref().find(|c| *c == close);
        parts.push(String::new());
    }
    parts
}

/// Returns the place in an element with macros that corresponds to a place in its expansion: the
/// value of an attribute, or the innermost element on the way to it that is there once.
fn place(expanded: Element<'_>, made: Element<'_>, span: &Span) -> Span {
    let (mut expanded, mut made) = (expanded, made);
    while let Some(inner) = expanded.children().find(|child| holds(child.span(), span)) {
        let [theirs, ours] = [expanded, made].map(|element| element.named(inner.name()).count());
        // Elements of macros and conditions may make further ones.
        let is_plain = made.children().all(|child| !child.name().starts_with("xacro_"));
        let number = expanded.named(inner.name()).take_while(|child| child.span() != inner.span()).count();
        match made.named(inner.name()).nth(number) {
            Some(child) if theirs == ours && (ours == 1 || is_plain) => (expanded, made) = (inner, child),
            _ => return made.span(),
        }
    }
    let of_value = |name: &str| expanded.attribute(name).is_some_and(|value| holds(value.span.clone(), span));
    let value = expanded.attribute_names().find(|name| of_value(name)).and_then(|name| made.attribute(name));
    value.map_or(made.span(), |value| value.span)
}

fn holds(outer: Span, inner: &Span) -> bool {
    outer.start <= inner.start && inner.end <= outer.end
}

/// Converts a place in a file with macros to the numbering of the model.
fn moved(source: &Source, span: Span) -> Span {
    source.start + span.start..source.start + span.end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions_stand_for_any_characters() {
        for (pattern, name) in [
            ("arm", "arm"),
            ("${side}_arm", "left_arm"),
            ("${side}_arm", "_arm"),
            ("leg_$(arg number)_${end}", "leg_3_foot"),
            ("${d['(']}x$(arg {})", "1x2"),
            ("${a}b${c}b", "bb"),
        ] {
            assert!(matches(pattern, name), "{pattern} {name}");
        }
        for (pattern, name) in [
            ("arm", "arms"),
            ("arm", "left_arm"),
            ("${side}_arm", "left_arms"),
            ("leg_$(arg number)_${end}", "leg_3"),
            ("${a}b${c}b", "b"),
        ] {
            assert!(!matches(pattern, name), "{pattern} {name}");
        }
    }
}
