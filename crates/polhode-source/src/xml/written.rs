//! What is written in a text, and where.

use std::ops::Range;

/// The value of an attribute or the text of an element, without the blanks around it.
#[derive(Clone, Debug)]
pub struct Written<'a> {
    /// What it says.
    pub value: &'a str,
    /// Where it stands, without quotes.
    pub span: Range<usize>,
    /// The bytes of the text are the value itself: no entity stands for a character of it.
    literal: bool,
}

impl<'a> Written<'a> {
    /// Value with its place in a text.
    pub fn new(text: &'a str, span: Range<usize>, value: &'a str) -> Self {
        let raw = text.get(span.clone()).unwrap_or("");
        // The value is longer than the text with sections (CDATA) after it, and shorter by a byte for each end of a line in two.
        let is_whole = || raw.len() == value.len() || raw.len() == value.len() + raw.matches("\r\n").count();
        if raw.contains(['&', '<']) || !is_whole() {
            return Self { value: value.trim(), span, literal: false };
        }
        Self::raw(text, span)
    }

    /// Bytes as they are written.
    pub fn raw(text: &'a str, span: Range<usize>) -> Self {
        let raw = text.get(span.clone()).unwrap_or("");
        let start = span.start + (raw.len() - raw.trim_start().len());
        let value = raw.trim();
        Self { value, span: start..start + value.len(), literal: true }
    }

    /// The same, in a text whose places count from `start`.
    pub fn moved(mut self, start: usize) -> Self {
        self.span = start + self.span.start..start + self.span.end;
        self
    }

    /// As a name.
    pub fn name(&self) -> Name {
        Name { text: self.value.to_owned(), span: self.span.clone() }
    }

    /// As one number.
    pub fn number(&self) -> Number {
        Number { text: self.value.to_owned(), span: self.span.clone(), value: parsed(self.value) }
    }

    /// As numbers with blanks between them. With an entity in it, each stands where all of them stand.
    pub fn numbers(&self) -> impl Iterator<Item = Number> {
        let from = self.value.as_ptr().addr();
        self.value.split_ascii_whitespace().map(move |word| {
            let start = self.span.start + (word.as_ptr().addr() - from);
            let span = if self.literal { start..start + word.len() } else { self.span.clone() };
            Number { text: word.to_owned(), span, value: parsed(word) }
        })
    }

    /// As plain values: NaN for NaN.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        self.value.split_ascii_whitespace().map(|word| parsed(word).unwrap_or(f64::NAN))
    }

    /// As `N` plain values; `None` if there are fewer or more.
    pub fn array<const N: usize>(&self) -> Option<[f64; N]> {
        let mut values = self.values();
        let mut array = [0.0; N];
        for slot in &mut array {
            *slot = values.next()?;
        }
        values.next().is_none().then_some(array)
    }
}

/// The number that a word is. What overflows is infinite, `nan` is NaN.
fn parsed(word: &str) -> Option<f64> {
    word.parse().ok()
}

/// A name, and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The name.
    pub text: String,
    /// Where it stands, without quotes.
    pub span: Range<usize>,
}

/// A number as it is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// The text: `"1676359E-6"`.
    pub text: String,
    /// Where it stands, without quotes or the spaces around it.
    pub span: Range<usize>,
    /// What it is: `None` if the text is not a number. It may be infinite or NaN: `"1e400"`, `"nan"`.
    pub value: Option<f64>,
}

/// `true` as languages of models write it.
pub fn is_true(word: &str) -> bool {
    matches!(word.trim(), "true" | "1" | "True" | "TRUE")
}
