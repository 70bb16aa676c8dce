//! Input text with places, shared by all readers of polhode.
//!
//! | module | holds |
//! |---|---|
//! | [`FormatError`] | path, line, column, text found, broken rule, advice |
//! | [`ContentError`] | the same for bytes whose file is not known yet |
//! | [`Failure`] | the error of a request without a result |
//! | [`given`] | quantities and lists in arguments |
//! | [`read_file`], [`read_text_file`], [`mod@file`] | files, with limits |
//! | [`files`] | sources of files: this machine, memory, certain folders of another source |
//! | [`mod@unit`] | quantities in text |
//! | [`expression`] | formulas in text |
//! | [`toml`] | TOML: tables, values and rotations with their places |
//! | [`mod@csv`] | lines and fields of tables; numbers separated by commas |
//! | [`times`] | lists of times, one per line |
//! | [`xml`] | elements, attributes and numbers with their places |
//! | [`package`] | XML in ZIP archives, with limits on the unpacked size |
//! | [`text`] | excerpts with all control characters made visible |
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
