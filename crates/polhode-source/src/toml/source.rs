//! Text of a scenario file, with places and errors in it.

use std::any::Any;
use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::asked::Asked;
use super::symbols::Symbols;
use super::tree::{Kind, Node, Replacement};
use crate::expression::ExpressionError;
use crate::files::Files;
use crate::{FormatError, FormatErrorKind, Place};

/// Text and path of a file, for messages and for the files that it names.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Path of the file; paths in the text are relative to its folder.
    pub path: &'a Path,
    /// Text of the file, UTF-8.
    pub text: &'a str,
    /// Source of the files named in the text.
    pub files: &'a dyn Files,
    /// Second file, if the end of this text was joined from another file.
    pub rest: Option<Rest<'a>>,
    /// True if the scenario is displayed; members of sweeps are not.
    pub is_shown: bool,
    /// Record of the reader's requests, if the caller wants one.
    pub asked: Option<&'a Asked>,
    /// Contents of a file that the text may name, if the caller has read it. The reader of the file
    /// knows the type.
    pub kept: Option<&'a (dyn Any + Send + Sync)>,
    /// Symbols that formulas in place of quantities may contain.
    pub symbols: Option<&'a Symbols>,
    /// Top-level keys that are tables; messages say how to write them.
    pub headings: &'a [&'static str],
    /// Cancellation check, called repeatedly during long computations.
    pub watch: Watch<'a>,
}

/// Second file at the end of a joined text.
#[derive(Clone, Copy, Debug)]
pub struct Rest<'a> {
    /// Offset of its first byte in the joined text.
    pub from: usize,
    /// Path of the second file; paths in it are relative to its folder.
    pub path: &'a Path,
    /// Source of the files named in it.
    pub files: &'a dyn Files,
}

/// Cancellation check, called repeatedly by long computations: false cancels.
#[derive(Clone, Copy)]
pub struct Watch<'a>(pub &'a (dyn Fn() -> bool + Sync));

impl fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Watch")
    }
}

impl<'a> Source<'a> {
    /// Creates the source of a scenario that is displayed.
    pub const fn new(files: &'a dyn Files, path: &'a Path, text: &'a str) -> Self {
        Self {
            path,
            text,
            files,
            rest: None,
            is_shown: true,
            asked: None,
            kept: None,
            symbols: None,
            headings: &[],
            watch: Watch(&|| true),
        }
    }

    /// Returns the line and column of a range of bytes of the text.
    pub fn place(&self, span: Range<usize>) -> Place {
        Place::in_text(self.text, span)
    }

    /// Returns the path of a file that the scenario names, relative to the scenario.
    pub fn sibling(&self, name: &str) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(name)
    }

    /// Returns the text of a value with all replacements inserted.
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

    /// Creates an error in a formula that stands at `span`, at the place within the formula; for a
    /// string with escapes, at the string.
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

    /// Returns the error for a text that the TOML parser refuses.
    pub fn syntax(&self, error: &toml::de::Error) -> FormatError {
        let message = error.message().to_owned();
        let hint = match message.as_str() {
            "duplicate key" => Some(
                "use each key once per table; another part, torque or event starts with its own [[body.part]], [[torque]] or [[event]]",
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
