//! Values in an XML text, with their places.

use std::ops::Range;

/// Trimmed value of an attribute, or trimmed text of an element.
#[derive(Clone, Debug)]
pub struct Written<'a> {
    /// The value, with entities resolved.
    pub value: &'a str,
    /// Bytes of the value in the text, without quotes.
    pub span: Range<usize>,
    /// True if the bytes of the text equal the value, that is, it contains no entities.
    literal: bool,
}

impl<'a> Written<'a> {
    /// Creates a value with its place in a text.
    pub fn new(text: &'a str, span: Range<usize>, value: &'a str) -> Self {
        let raw = text.get(span.clone()).unwrap_or("");
        // CDATA sections make the raw text longer; each two-byte line end makes the value a byte
        // shorter.
        let is_whole = || raw.len() == value.len() || raw.len() == value.len() + raw.matches("\r\n").count();
        if raw.contains(['&', '<']) || !is_whole() {
            return Self { value: value.trim(), span, literal: false };
        }
        Self::raw(text, span)
    }

    /// Creates a value from the raw bytes of a text.
    pub fn raw(text: &'a str, span: Range<usize>) -> Self {
        let raw = text.get(span.clone()).unwrap_or("");
        let start = span.start + (raw.len() - raw.trim_start().len());
        let value = raw.trim();
        Self { value, span: start..start + value.len(), literal: true }
    }

    /// Returns the value with its place moved by `start`, the offset of its text.
    pub fn moved(mut self, start: usize) -> Self {
        self.span = start + self.span.start..start + self.span.end;
        self
    }

    /// Returns the value as a name.
    pub fn name(&self) -> Name {
        Name { text: self.value.to_owned(), span: self.span.clone() }
    }

    /// Returns the value as one number.
    pub fn number(&self) -> Number {
        Number { text: self.value.to_owned(), span: self.span.clone(), value: parsed(self.value) }
    }

    /// Returns the numbers separated by blanks. If the value contains entities, each number has the
    /// place of the whole value.
    pub fn numbers(&self) -> impl Iterator<Item = Number> {
        let from = self.value.as_ptr().addr();
        self.value.split_ascii_whitespace().map(move |word| {
            let start = self.span.start + (word.as_ptr().addr() - from);
            let span = if self.literal { start..start + word.len() } else { self.span.clone() };
            Number { text: word.to_owned(), span, value: parsed(word) }
        })
    }

    /// Returns the numbers separated by blanks as plain values; a word that is not a number is NaN.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        self.value.split_ascii_whitespace().map(|word| parsed(word).unwrap_or(f64::NAN))
    }

    /// Returns exactly `N` plain values; `None` if there are fewer or more.
    pub fn array<const N: usize>(&self) -> Option<[f64; N]> {
        let mut values = self.values();
        let mut array = [0.0; N];
        for slot in &mut array {
            *slot = values.next()?;
        }
        values.next().is_none().then_some(array)
    }
}

/// Parses a word as a number; overflow gives infinity, `nan` gives NaN.
fn parsed(word: &str) -> Option<f64> {
    word.parse().ok()
}

/// Name with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// Text of the name.
    pub text: String,
    /// Bytes of the name in the text, without quotes.
    pub span: Range<usize>,
}

/// Number as written, with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// Text of the number: `"1676359E-6"`.
    pub text: String,
    /// Bytes of the number in the text, without quotes or blanks.
    pub span: Range<usize>,
    /// Value; `None` if the text is not a number. It may be infinite or NaN: `"1e400"`, `"nan"`.
    pub value: Option<f64>,
}

/// Returns true for the spellings of `true` in model languages.
pub fn is_true(word: &str) -> bool {
    matches!(word.trim(), "true" | "1" | "True" | "TRUE")
}
