//! Integration tests of `polhode-identify`, as one program, because each program links the whole
//! library.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "a test may"
)]

mod draws;
mod next;
mod noise;
#[path = "../../../polhode-source/tests/common/obey.rs"]
mod obey;
mod payload;
mod read;
mod read_swing;
mod residuals;
mod tumble;
mod tumble_flaws;
