//! The integration tests of `polhode-source`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod expression;
mod unit;
