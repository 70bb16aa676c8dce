//! Outcomes of requests.

use polhode_source::Failure;
use serde_json::Value;

use crate::failed::Failed;

/// Outcome of a request.
#[derive(Debug, PartialEq)]
pub(crate) enum Outcome {
    /// Result as JSON, and the numbers of its arrays.
    Done {
        /// Report in JSON.
        value: Value,
        /// Numbers of all arrays, one array after the other.
        numbers: Vec<f64>,
    },
    /// Failures, at least one.
    Failed(Vec<Failed>),
    /// The request needs a build with the feature `full`.
    NeedsFull,
}

impl Outcome {
    /// Creates the outcome of a report without arrays.
    pub(crate) const fn of(value: Value) -> Self {
        Self::Done { value, numbers: Vec::new() }
    }
}

impl From<Failure> for Outcome {
    fn from(failure: Failure) -> Self {
        Self::Failed(vec![Failed::of(&failure)])
    }
}

impl<T: Into<Self>> From<Result<T, Failure>> for Outcome {
    fn from(result: Result<T, Failure>) -> Self {
        result.map_or_else(Self::from, Into::into)
    }
}
