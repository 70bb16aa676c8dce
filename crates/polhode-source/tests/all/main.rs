//! Integration tests of `polhode-source`, built as one program so that the library is linked only
//! once.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod expression;
mod unit;
