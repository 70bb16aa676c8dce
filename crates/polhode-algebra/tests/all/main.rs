//! Integration tests of `polhode-algebra`. They are one program, because each program links the
//! whole library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod angles;
mod canonical;
mod common;
mod formulas;
mod lagrange;
mod parsing;
mod rationals;
mod roots;
mod round_trip;
mod vectors;
