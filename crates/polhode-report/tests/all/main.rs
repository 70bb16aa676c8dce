//! The integration tests of `polhode-report`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod budget;
mod common;
mod explain;
mod explain_rows;
mod export;
mod golden;
mod json;
mod page;
mod page_contact;
mod page_contract;
mod page_gimbals;
mod page_scene;
mod sweep;
mod worked;
mod worked_ground;
