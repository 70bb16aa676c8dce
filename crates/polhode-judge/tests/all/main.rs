//! Integration tests of `polhode-judge`. They are one program, because each program links the
//! whole library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod against;
mod free_body;
mod log;
