//! Requests of the reader: the keys of each table, and the type, names or dimension of each value.
//! Completions and the schema come from them, so that they state what the reader accepts.

use std::cell::RefCell;
use std::ops::Range;

use crate::unit::Dimension;

/// What was asked, in the order of asking.
#[derive(Debug, Default)]
pub struct Asked(RefCell<Vec<Question>>);

#[derive(Clone, Debug)]
/// One request of the reader: a place in the text, and what the reader accepts there.
pub struct Question {
    /// The value, in bytes of the text; of a table with a header, the header.
    pub span: Range<usize>,
    /// Keys, names or dimension that the reader accepts there.
    pub what: What,
}

#[derive(Clone, Debug)]
/// Kind of value that the reader accepts at a place.
pub enum What {
    /// The keys of a table, and what it is called.
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
    /// An array, of this many elements where the reader requires a certain number.
    Array(Option<usize>),
    /// An array is read in another way than other values, or refused with advice.
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
