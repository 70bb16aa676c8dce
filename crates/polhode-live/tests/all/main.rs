//! The integration tests of `polhode-live`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may")]

#[path = "../../../polhode-source/tests/common/chance.rs"]
mod chance;
mod client;
mod crowded;
mod hostile;
mod limits;
mod models;
mod output;
mod served;
mod watched;
