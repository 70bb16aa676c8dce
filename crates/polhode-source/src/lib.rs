//! Input text with places: what every reader of polhode needs, whatever the subject of its files.
//!
//! | module | holds |
//! |---|---|
//! | [`FormatError`] | path, line, column, what is there, the rule, what to write instead |
//! | [`ContentError`] | the same of bytes whose file is not known yet |
//! | [`Failure`] | what a slice answers to a request that has no result |
//! | [`given`] | quantities and lists as a user gives them |
//! | [`read_file`], [`read_text_file`], [`mod@file`] | files, with limits |
//! | [`files`] | where files come from: this machine, memory, some folders of another |
//! | [`mod@unit`] | quantities in text |
//! | [`expression`] | formulas in text |
//! | [`toml`] | TOML: tables, values and rotations with their places |
//! | [`mod@csv`] | lines and fields of tables; numbers with commas between them |
//! | [`times`] | lists of times, one per line |
//! | [`xml`] | elements, attributes and numbers with their places |
//! | [`package`] | XML in ZIP archives, with limits on what they unfold to |
//! | [`text`] | excerpts in which nothing is unseen |
#![forbid(unsafe_code)]

mod content;
pub mod csv;
mod error;
pub mod expression;
mod failure;
pub mod file;
pub mod files;
pub mod given;
mod json;
pub mod package;
mod reading;
mod suggestion;
pub mod text;
pub mod times;
pub mod toml;
pub mod unit;
pub mod xml;

pub use content::{ContentError, ContentErrorKind, ContentPlace, told_unit};
pub use error::{FormatError, FormatErrorKind, Place, Spot};
pub use failure::{Failure, shown};
pub use json::json_value;
pub use reading::{read_file, read_text_file};
pub use suggestion::nearest;
