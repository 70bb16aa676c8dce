//! One body and one motion: scenario files, and what is known of them.
//!
//! - [`mod@read`]: scenario files, as TOML
//! - [`request`]: what is asked of them, and the functions that answer
//! - [`report`]: results for people and for programs: text, JSON, worked solutions, pages and figures
//!
//! Text is plain Unicode for a terminal of 100 columns. JSON is SI, its keys are stable, and its
//! numbers read back bit for bit; what is not finite or does not exist is `null`.
#![forbid(unsafe_code)]

pub mod read;
pub mod report;
pub mod request;
pub mod symbolic;
