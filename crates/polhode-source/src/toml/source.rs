//! The text of a scenario file: places in it, and errors at them.

use std::any::Any;
use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::asked::Asked;
use super::tree::{Kind, Node, Replacement};
use crate::expression::ExpressionError;
use crate::files::Files;
use crate::{FormatError, FormatErrorKind, Place};

/// The text of a file, and its path, for messages and for the files that it names.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Path of the file; paths in the text are relative to its folder.
    pub path: &'a Path,
    /// Text of the file, UTF-8.
    pub text: &'a str,
    /// Place that the files which it names are taken from.
    pub files: &'a dyn Files,
    /// The other file whose text the end of this one is.
    pub rest: Option<Rest<'a>>,
    /// Whether the scenario will be looked at: members of sweeps are not.
    pub is_shown: bool,
    /// Where the reader writes down what it asks for, if somebody wants to know.
    pub asked: Option<&'a Asked>,
    /// Contents of a file that the text may name, if the caller has read it. The file's reader knows the type.
    pub kept: Option<&'a (dyn Any + Send + Sync)>,
    /// The keys of the file itself that are tables: messages say how these are written.
    pub headings: &'a [&'static str],
    /// Cancellation check, called repeatedly during long computations.
    pub watch: Watch<'a>,
}

/// File whose text is the end of a joined text.
#[derive(Clone, Copy, Debug)]
pub struct Rest<'a> {
    /// First byte of it in the joined text.
    pub from: usize,
    /// Its path; paths in it are relative to its folder.
    pub path: &'a Path,
    /// Place that the files which it names are taken from.
    pub files: &'a dyn Files,
}

/// Asked again and again by what takes time: false ends it.
#[derive(Clone, Copy)]
pub struct Watch<'a>(pub &'a (dyn Fn() -> bool + Sync));

impl fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Watch")
    }
}

impl<'a> Source<'a> {
    /// Of a scenario that will be looked at.
    pub const fn new(files: &'a dyn Files, path: &'a Path, text: &'a str) -> Self {
        Self {
            path,
            text,
            files,
            rest: None,
            is_shown: true,
            asked: None,
            kept: None,
            headings: &[],
            watch: Watch(&|| true),
        }
    }

    /// Returns the line and column of a range of bytes of the text.
    pub fn place(&self, span: Range<usize>) -> Place {
        Place::in_text(self.text, span)
    }

    /// The path of a file that the scenario names.
    pub fn beside(&self, name: &str) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(name)
    }

    /// The text of a value, with the numbers that are replaced.
    pub fn current(&self, node: &Node) -> String {
        let mut replaced = Vec::new();
        node.each_leaf(&mut |leaf| {
            if let Kind::Replaced(Replacement::Number(value)) = leaf.kind {
                replaced.push((&leaf.span, value));
            }
        });
        replaced.sort_by_key(|(place, _)| place.start);
        let (mut text, mut at) = (String::new(), node.span.start);
        for (place, value) in replaced {
            text += self.text.get(at..place.start).unwrap_or_default();
            text += &format!("{value:?}");
            at = place.end;
        }
        text + self.text.get(at..node.span.end).unwrap_or_default()
    }

    /// Creates an error at a range of bytes of the text.
    pub fn error(&self, span: Range<usize>, kind: FormatErrorKind) -> FormatError {
        FormatError::new(self.path, Some(self.place(span)), kind)
    }

    /// An error in a formula that stands at a place, at its own place there; of a string with escapes, at the string.
    pub fn formula(&self, span: Range<usize>, text: &str, error: ExpressionError) -> FormatError {
        let raw = self.text.get(span.clone()).unwrap_or_default();
        let mut place = span.clone();
        if let Some(offset) = raw.find(text).filter(|_| !text.is_empty()) {
            let start =
                text.char_indices().nth(error.column.saturating_sub(1)).map_or(text.len(), |(at, _)| at);
            let word = |c: char| c.is_alphanumeric() || c == '_';
            let end = text[start..].find(|c| !word(c)).map_or(text.len(), |length| start + length);
            let one = text[start..].chars().next().map_or(0, char::len_utf8);
            let end = end.max(start + one);
            place = span.start + offset + start..span.start + offset + end;
        }
        self.error(place, FormatErrorKind::Formula(error))
    }

    /// What the TOML parser refuses.
    pub fn syntax(&self, error: &toml::de::Error) -> FormatError {
        let message = error.message().to_owned();
        let hint = match message.as_str() {
            "duplicate key" => Some(
                "a key stands once in its table; one more part, torque or event begins with its own [[body.part]], [[torque]] or [[event]]",
            ),
            m if m.starts_with("string values must be quoted") => {
                Some("a quantity with a unit is a string in quotes, such as \"25 mm\"")
            }
            _ => None,
        };
        let fail = self.error(error.span().unwrap_or_default(), FormatErrorKind::Toml { message });
        match hint {
            Some(hint) => fail.with_hint(hint),
            None => fail,
        }
    }
}
