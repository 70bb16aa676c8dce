//! What the reader asks a text for: the keys of each table, the names that a value may have, the dimension of a quantity. Completions come from
//! it, so that they are what the reader takes.

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
}

impl Asked {
    pub(crate) fn keys(&self, span: &Range<usize>, table: &str, known: &[&'static str]) {
        self.put(span, What::Keys(table.to_owned(), known.to_vec()));
    }

    pub(crate) fn choice(&self, span: &Range<usize>, names: &[&'static str]) {
        self.put(span, What::Choice(names.to_vec()));
    }

    pub(crate) fn quantity(&self, span: &Range<usize>, dimension: Dimension) {
        self.put(span, What::Quantity(dimension));
    }

    /// Returns the recorded requests in the order in which the reader made them.
    pub fn all(self) -> Vec<Question> {
        self.0.into_inner()
    }

    fn put(&self, span: &Range<usize>, what: What) {
        self.0.borrow_mut().push(Question { span: span.clone(), what });
    }
}
