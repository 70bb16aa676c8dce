//! Comments `<!-- polhode: allow RULE: REASON -->` in a model.
//!
//! A comment applies to the link or joint whose element contains it or follows it directly. Before
//! the root element it applies to the whole file. Elsewhere it applies to findings about the model
//! as a whole.

use std::collections::BTreeSet;

use super::not_enough;
use crate::finding::{Finding, Severity};
use crate::model::{ModelFormat, RobotModel, Span};
use crate::rule::{rule, rules};

/// Prefix of such comments.
const MARK: &str = "polhode:";

/// Comment with this prefix.
#[derive(Clone, Debug)]
pub(super) struct Comment {
    span: Span,
    scope: Scope,
    /// Rules that the comment names.
    codes: Vec<&'static str>,
    /// Reason, in the user's words.
    pub(super) reason: String,
    /// Reason why the comment is malformed, if it is.
    fault: Option<String>,
}

/// Scope of a comment.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Scope {
    File,
    Model,
    /// Names of links and joints.
    Elements(Vec<String>),
}

impl Comment {
    /// Returns true if the comment allows findings of a rule about a link or joint, or about the
    /// model if `subject` is empty. Findings in an included file are allowed only for a link or
    /// joint by name.
    pub(super) fn allows(&self, code: &str, subject: &str, is_included: bool) -> bool {
        self.fault.is_none()
            && self.codes.contains(&code)
            && match &self.scope {
                Scope::File => !is_included,
                Scope::Model => !is_included && subject.is_empty(),
                Scope::Elements(names) => names.iter().any(|name| name == subject),
            }
    }

    /// Returns the finding about the comment itself: it is malformed, or one of its rules allowed
    /// nothing. For an unused rule, `lacking` returns the links that need an allowance too.
    pub(super) fn fault(&self, lacking: impl Fn(&str) -> Option<BTreeSet<String>>) -> Option<Finding> {
        let (code, severity, message) = match &self.fault {
            Some(fault) => ("allow.malformed", Severity::Suspect, fault.clone()),
            None => {
                let (mut unused, mut others) = (Vec::new(), BTreeSet::new());
                for code in &self.codes {
                    if let Some(lacking) = lacking(code) {
                        unused.push(*code);
                        others.extend(lacking);
                    }
                }
                if unused.is_empty() {
                    return None;
                }
                let place = match &self.scope {
                    Scope::File => "in the file".to_owned(),
                    Scope::Model => "of the whole model; the comment is not at a link or joint".to_owned(),
                    Scope::Elements(names) => format!("of {}", names.join(", ")),
                };
                let why = not_enough(&others).map_or(String::new(), |why| format!(" alone: {why}"));
                ("allow.unused", Severity::Note, format!("no finding {} {place}{why}", unused.join(", ")))
            }
        };
        let title = rule(code).map_or("", |rule| rule.title);
        let subject = match &self.scope {
            Scope::Elements(names) => names.first().map_or("", String::as_str),
            Scope::File | Scope::Model => "",
        };
        Some(Finding::new(code, severity, subject, self.span.clone(), message, title))
    }
}

/// Returns the comments of a model's text.
pub(super) fn comments(model: &RobotModel) -> Vec<Comment> {
    if !model.text.contains(MARK) {
        return Vec::new();
    }
    let text = model.text.as_str();
    let (comments, root) = scan(text);
    // In USD, "<" begins a path.
    let first = model.links.iter().map(|link| link.span.start).min();
    let root = if model.format == ModelFormat::Usd { first.unwrap_or(text.len()) } else { root };
    let of = |span: &Span| {
        let said = text.get(span.start + 4..span.end - 3)?.trim().strip_prefix(MARK)?.trim();
        let scope = if span.end <= root { Scope::File } else { scope(model, span, &comments) };
        let (codes, reason, fault) = match understood(said) {
            Ok((codes, reason)) => (codes, reason, None),
            Err(fault) => (Vec::new(), String::new(), Some(fault)),
        };
        Some(Comment { span: span.clone(), scope, codes, reason, fault })
    };
    comments.iter().filter_map(of).collect()
}

/// Returns the comments of a well-formed text, and the position of its root element.
fn scan(text: &str) -> (Vec<Span>, usize) {
    let (mut comments, mut root, mut at) = (Vec::new(), None, 0);
    while let Some(start) = text.get(at..).and_then(|rest| rest.find('<')).map(|found| at + found) {
        let rest = text.get(start..).unwrap_or_default();
        let close = if rest.starts_with("<!--") {
            "-->"
        } else if rest.starts_with("<?") {
            "?>"
        } else if rest.starts_with("<![CDATA[") {
            "]]>"
        } else {
            root = root.or(Some(start));
            at = start + 1;
            continue;
        };
        let opening = if close == "-->" { 4 } else { 2 };
        let found = rest.get(opening..).and_then(|rest| rest.find(close));
        at = found.map_or(text.len(), |found| start + opening + found + close.len());
        if close == "-->" && found.is_some() {
            comments.push(start..at);
        }
    }
    (comments, root.unwrap_or(text.len()))
}

/// Returns the links and joints that a comment applies to.
fn scope(model: &RobotModel, comment: &Span, comments: &[Span]) -> Scope {
    let elements = || {
        let links = model.links.iter().map(|link| (&link.span, &link.name.text));
        links.chain(model.joints.iter().map(|joint| (&joint.span, &joint.name.text)))
    };
    let mut next = comment.end;
    while let Some(rest) = model.text.get(next..) {
        next += rest.len() - rest.trim_start().len();
        match comments.iter().find(|other| other.start == next) {
            Some(other) => next = other.end,
            None => break,
        }
    }
    let follows = elements().any(|(span, _)| span.start == next);
    let around = elements().filter(|(span, _)| span.start < comment.start && comment.end < span.end);
    let innermost = || around.min_by_key(|(span, _)| span.end - span.start).map(|(span, _)| span.start);
    let Some(start) = Some(next).filter(|_| follows).or_else(innermost) else { return Scope::Model };
    let mut names: Vec<String> =
        elements().filter(|(span, _)| span.start == start).map(|(_, name)| name.clone()).collect();
    names.dedup();
    Scope::Elements(names)
}

/// Returns the rules and the reason, or the error if the text is not an allowance.
fn understood(said: &str) -> Result<(Vec<&'static str>, String), String> {
    const FORM: &str = "write polhode: allow RULE: REASON";
    let Some(rest) = said.strip_prefix("allow").filter(|rest| rest.starts_with(char::is_whitespace)) else {
        return Err(format!("{said:?} cannot be read: {FORM}"));
    };
    let (codes, reason) = rest.split_once(':').unwrap_or((rest, ""));
    let mut known = Vec::new();
    for code in codes.split([',', ' ', '\t', '\n', '\r']).filter(|code| !code.is_empty()) {
        let Some(rule) = rule(code) else {
            let meant = polhode_source::nearest(code, rules().map(|rule| rule.code));
            let meant = meant.map_or(String::new(), |meant| format!(": did you mean {meant}?"));
            return Err(format!("unknown rule {code}{meant}"));
        };
        known.push(rule.code);
    }
    let reason = reason.split_whitespace().collect::<Vec<_>>().join(" ");
    if known.is_empty() {
        Err(format!("the rule is missing: {FORM}"))
    } else if reason.is_empty() {
        Err(format!("the reason is missing: {FORM}"))
    } else {
        Ok((known, reason))
    }
}
