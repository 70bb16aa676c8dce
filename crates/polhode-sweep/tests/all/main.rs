//! Integration tests of `polhode-sweep`, as one program, because each program links the whole
//! library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod book;
mod dataset;
mod examples;
#[path = "../../../polhode-source/tests/common/obey.rs"]
mod obey;
mod outcomes;
mod plan;
mod questions;
mod summary;
