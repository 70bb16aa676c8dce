//! Record of the reader's requests: the keys of each table, and the type, names or dimension of
//! each value. Completions and the schema use this record, so they state exactly what the reader
//! accepts.

use std::cell::RefCell;
use std::ops::Range;

use crate::unit::Dimension;

/// Recorded requests, in the order in which the reader made them.
#[derive(Debug, Default)]
pub struct Asked(RefCell<Vec<Question>>);

#[derive(Clone, Debug)]
/// One request of the reader: a place in the text, and what the reader accepts there.
pub struct Question {
    /// Bytes of the value; for a table with a header, bytes of the header.
    pub span: Range<usize>,
    /// Keys, names or dimension that the reader accepts there.
    pub what: What,
}

#[derive(Clone, Debug)]
/// Kind of value that the reader accepts at a place.
pub enum What {
    /// Name of a table, and its keys.
    Keys(String, Vec<&'static str>),
    /// One of these names, as a string.
    Choice(Vec<&'static str>),
    /// A quantity of this dimension.
    Quantity(Dimension),
    /// A number without a unit.
    Number,
    /// A whole number.
    Count,
    /// A string of any content.
    Text,
    /// `true` or `false`.
    Truth,
    /// An array, with its number of elements if the reader requires a certain number.
    Array(Option<usize>),
    /// A check for an array, which the reader treats differently from other values.
    PerhapsArray,
    /// A table with or without a header.
    Table,
    /// A table with keys of the user's choice.
    AnyKeys,
    /// A key that the table must have.
    Required(&'static str),
}

impl Asked {
    /// Returns the recorded requests in the order in which the reader made them.
    pub fn all(self) -> Vec<Question> {
        self.0.into_inner()
    }

    pub(crate) fn put(&self, span: &Range<usize>, what: What) {
        self.0.borrow_mut().push(Question { span: span.clone(), what });
    }
}
