//! The integration tests of `polhode-table`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod log;
mod output;
