//! Errors of links without usable mass properties, alone or joined.

use std::error::Error;
use std::fmt;

use polhode::body::BodyError;
use polhode_document::layout::printable;
use polhode_source::Failure;

use crate::line_index::{FilePlace, Places};
use crate::model::{RobotModel, Span};

/// Error of a link or of joined links: missing or unphysical numbers, unknown links or joints,
/// joints that do not form a tree, or unknown joint values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkError {
    message: String,
    hint: String,
    span: Option<Span>,
}

impl LinkError {
    /// Creates an error without a position in the model's text.
    pub(crate) fn new(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { message: message.into(), hint: hint.into(), span: None }
    }

    /// Adds the position in the model's text.
    pub(crate) fn at(self, span: &Span) -> Self {
        Self { span: Some(span.clone()), ..self }
    }

    /// Creates the error of a link's own numbers.
    pub(crate) fn of_number(message: impl Into<String>, span: &Span) -> Self {
        Self::new(message, "`polhode check` reports the error and the fix").at(span)
    }

    /// Creates the error of unphysical numbers.
    pub(crate) fn impossible(error: &BodyError, span: &Span) -> Self {
        Self::of_number(error.to_string(), span)
    }

    /// Creates the error of a model or subtree without mass.
    pub(crate) fn massless(subtree: Option<&str>) -> Self {
        let message = match subtree {
            None => "no link has mass".to_owned(),
            Some(link) => format!("neither the link {link:?} nor its descendants have mass"),
        };
        Self::new(message, "add an <inertial> to a link")
    }

    /// Adds the name of the link.
    pub(crate) fn of_link(self, link: &str) -> Self {
        Self { message: format!("the link {link:?} cannot be used: {}", self.message), ..self }
    }

    /// Converts to a failure, with its place in the model if it has one.
    pub(crate) fn in_model(&self, model: &RobotModel) -> Failure {
        let (message, hint) = (self.to_string(), self.hint());
        match self.span() {
            Some(span) => {
                let FilePlace { file, line, column, .. } = Places::of(model).place(&span);
                if model.expansion.is_some() {
                    let message = format!("{message} (line {line} of the expanded text)");
                    return Failure::usage(message, hint).in_file(&model.path);
                }
                Failure::located(message, file, [line, column], hint)
            }
            None => Failure::usage(message, hint).in_file(&model.path),
        }
    }

    /// Returns the position in the model's text, if there is one.
    pub fn span(&self) -> Option<Span> {
        self.span.clone()
    }

    /// Returns the hint.
    pub fn hint(&self) -> &str {
        &self.hint
    }
}

impl fmt::Display for LinkError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl Error for LinkError {}

/// Returns a hint: the nearest name, and the list of names.
pub(crate) fn suggested(meant: Option<&str>, introduction: &str, names: &[&str]) -> String {
    const MOST: usize = 40;
    let meant = meant.map_or_else(String::new, |meant| format!("did you mean {}? ", printable(meant)));
    let listed: Vec<_> = names.iter().take(MOST).map(|name| printable(name)).collect();
    let more = if names.len() > MOST { ", …" } else { "" };
    format!("{meant}{introduction} {}{more}", listed.join(", "))
}
