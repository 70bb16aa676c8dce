//! Failures as data of `PolhodeError`.

use std::path::Path;

use polhode_source::{Failure, shown};
use serde::Serialize;

/// Failure as `PolhodeError` of the package has it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Failed {
    /// Kind: `input` for a file, `motion` for a motion that cannot be computed, `request` for an
    /// invalid request.
    kind: &'static str,
    /// Text as the command prints it: reason, place with the line of the file, and advice.
    text: String,
    /// Reason and the broken rule, without place and advice.
    reason: String,
    /// Path of the file.
    file: Option<String>,
    /// Line of the place, from 1.
    line: Option<usize>,
    /// Character of the place in its line, from 1.
    column: Option<usize>,
    /// Advice for a fix.
    hint: Option<String>,
}

impl Failed {
    pub(crate) fn of(failure: &Failure) -> Self {
        let (kind, file, place) = match failure {
            Failure::Input(error) => {
                let place = error.place().map(|place| [place.line, place.column]);
                ("input", Some(shown(error.path())), place)
            }
            Failure::Motion { path, .. } => ("motion", Some(path.clone()), None),
            Failure::Usage { file, place, .. } => ("request", file.clone(), *place),
        };
        let text = failure.to_string();
        let text = text.strip_prefix("error: ").unwrap_or(&text).trim_end().to_owned();
        let [line, column] = place.map_or([None; 2], |place| place.map(Some));
        Self { kind, text, reason: failure.message(), file, line, column, hint: failure.hint() }
    }

    /// Creates the failure of a file of a request.
    pub(crate) fn in_file(failure: &Failure, file: &Path) -> Self {
        Self::of(&failure.clone().in_file(file))
    }
}
