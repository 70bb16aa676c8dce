//! Value of a property or of a metadata key.

use std::sync::Arc;

use crate::model::{Number, Span};

/// Value of a property or metadata key.
#[derive(Clone, Debug, Default)]
pub(super) struct Value {
    pub(super) span: Span,
    pub(super) numbers: Vec<Number>,
    /// Strings, words, paths and assets, without delimiters.
    pub(super) words: Vec<String>,
    /// Numbers of an attribute that is stored as an array.
    pub(super) array: Option<Arc<[f64]>>,
}

impl Value {
    /// Returns numbers and words as text, separated by spaces.
    pub(super) fn text(&self) -> String {
        let numbers = self.numbers.iter().map(|number| number.text.as_str());
        numbers.chain(self.words.iter().map(String::as_str)).collect::<Vec<_>>().join(" ")
    }

    /// Returns true unless the value is empty or all zero, which means "not given" in USD.
    pub(super) fn is_given(&self) -> bool {
        !self.words.is_empty() || self.numbers.iter().any(|number| number.value != Some(0.0))
    }

    /// Returns true for `false`, which usdcat writes as 0 in attributes.
    pub(super) fn is_false(&self) -> bool {
        self.words.iter().any(|word| word == "false")
            || self.numbers.iter().any(|number| number.value == Some(0.0))
    }
}
