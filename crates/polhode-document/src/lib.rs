//! Documents and figures of reports, written as plain text, Markdown, HTML, LaTeX, JSON and SVG.
//!
//! | module | holds |
//! |---|---|
//! | [`Document`] | sections of paragraphs, formulas, numbers, tables and pictures, with a writer for each format |
//! | [`Report`] | the result of a request: its JSON and its document |
//! | [`fact`] | results as a list, from which text, JSON and page rows are generated |
//! | [`drawing`], [`graph`] | pictures of a document, as data |
//! | [`figure`] | a sheet of marks with axes and letters, written as SVG or PNG: a [`Picture`] |
//! | [`mathml`] | formulas and matrices for a browser |
//! | [`number`], [`mod@unit`], [`si_prefix`] | numbers as text |
//! | [`layout`], [`sparkline`] | plain text for a terminal of 100 columns |
//! | [`json`], [`finding`] | common parts of JSON |
//!
//! The crate does not access files or the clock, and does not depend on a subject.
#![forbid(unsafe_code)]

mod csv;
mod document;
pub mod drawing;
mod extra;
pub mod fact;
pub mod figure;
pub mod finding;
pub mod graph;
pub mod json;
pub mod layout;
pub mod mathml;
pub mod number;
mod report;
pub mod si_prefix;
mod source;
pub mod sparkline;
pub mod unit;

pub use csv::csv_name;
pub use document::{Block, Document, Level, Section, Verdict};
pub use extra::Extra;
pub use figure::picture::Picture;
pub use report::Report;
pub use source::SourceInfo;

/// Version stated in reports.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
