//! Integration tests of `polhode-web`, combined in one program, because each program links the
//! whole library. All files are in memory.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may")]

mod inspect;
mod lesson;
mod motion;
mod refused;
mod session;
mod text;
