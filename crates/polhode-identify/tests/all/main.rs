//! Integration tests.

mod noise;
mod payload;
