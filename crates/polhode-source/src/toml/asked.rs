//! What the reader asks a text for: the keys of each table, the names that a value may have, the dimension of a quantity. Completions come from
//! it, so that they are what the reader takes.

use std::cell::RefCell;
use std::ops::Range;

use crate::unit::Dimension;

/// What was asked, in the order of asking.
#[derive(Debug, Default)]
pub struct Asked(RefCell<Vec<Question>>);

#[derive(Clone, Debug)]
pub struct Question {
    /// The value, in bytes of the text; of a table with a header, the header.
    pub span: Range<usize>,
    pub what: What,
}

#[derive(Clone, Debug)]
pub enum What {
    /// The keys of a table, and what it is called.
    Keys(String, Vec<&'static str>),
    Choice(Vec<&'static str>),
    Quantity(Dimension),
}

impl Asked {
    pub fn keys(&self, span: &Range<usize>, table: &str, known: &[&'static str]) {
        self.put(span, What::Keys(table.to_owned(), known.to_vec()));
    }

    pub fn choice(&self, span: &Range<usize>, names: &[&'static str]) {
        self.put(span, What::Choice(names.to_vec()));
    }

    pub fn quantity(&self, span: &Range<usize>, dimension: Dimension) {
        self.put(span, What::Quantity(dimension));
    }

    pub fn all(self) -> Vec<Question> {
        self.0.into_inner()
    }

    fn put(&self, span: &Range<usize>, what: What) {
        self.0.borrow_mut().push(Question { span: span.clone(), what });
    }
}
