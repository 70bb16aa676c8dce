//! Errors at their places in a text of the page.

use std::path::Path;

use polhode_source::{Failure, FormatError, Place, shown};

use crate::protocol::TextError;
use crate::utf16;

impl TextError {
    /// Converts an error of the text at `path`, or of a file to which it refers.
    pub(crate) fn of_format(error: &FormatError, path: &Path, text: &str) -> Self {
        if error.path() == path {
            return Self::at_place(error, text);
        }
        of_place(error.origin().map(|(_, place)| place), error.to_string(), error, text)
    }

    /// Converts an error of the text itself.
    pub(crate) fn at_place(error: &FormatError, text: &str) -> Self {
        of_place(error.place(), error.message(), error, text)
    }

    /// Converts a failure of a document at `path`. Without a text, only line and column are given.
    pub(crate) fn of_failure(failure: &Failure, path: &Path, text: Option<&str>) -> Self {
        if let (Failure::Input(error), Some(text)) = (failure, text) {
            return Self { message: error.message(), ..Self::of_format(error, path, text) };
        }
        let is_own = |file: &Option<String>| file.as_ref().is_none_or(|file| *file == shown(path));
        let is_elsewhere = matches!(failure, Failure::Usage { file, .. } if !is_own(file));
        let place = failure.place_in(path).filter(|_| !is_elsewhere);
        let [line, column] = place.map_or([None; 2], |place| place.map(Some));
        let error =
            Self { message: failure.message(), hint: failure.hint(), line, column, ..Self::default() };
        match (text, place) {
            (Some(text), Some([line, _])) => {
                let start: usize =
                    text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
                let end = start + text[start..].lines().next().unwrap_or_default().len();
                Self { from: Some(utf16::of_byte(text, start)), to: Some(utf16::of_byte(text, end)), ..error }
            }
            _ => error,
        }
    }
}

fn of_place(place: Option<&Place>, message: String, error: &FormatError, text: &str) -> TextError {
    TextError {
        message,
        hint: error.hint(),
        from: place.map(|place| utf16::of_byte(text, place.span.start)),
        to: place.map(|place| utf16::of_byte(text, place.span.end)),
        line: place.map(|place| place.line),
        column: place.map(|place| place.column),
    }
}
