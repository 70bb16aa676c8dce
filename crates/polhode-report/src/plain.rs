//! What plain text for people is made of: for reports that are made elsewhere, and look the same.

pub use crate::export::csv::quoted as csv_name;
pub use crate::layout::{WIDTH, columns, plain_spaces, printable, printable_lines, wrap};
pub use crate::number::{exact, ungrouped as number};
