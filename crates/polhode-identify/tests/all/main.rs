//! Bodies that are found again from what a known body would have shown.

mod noise;
mod tumble;
