//! Integration tests of `polhode-budget`. They are one program, because each program links the
//! whole library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod ballast;
mod ballast_bounds;
mod ballast_places;
mod ballast_sizes;
mod draws;
mod errors;
mod limits;
mod liquids;
mod lists;
mod masses;
mod principal;
mod published;
mod read;
mod report;
mod rows;
mod sequences;
mod shares;
mod sums;
mod tanks;
