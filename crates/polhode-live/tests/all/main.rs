//! The integration tests of `polhode-live`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may")]

mod client;
mod crowded;
mod ground_lessons;
mod hostile;
mod inspect;
mod known;
mod lesson_files;
mod lessons;
mod robot_shapes;
mod robots;
mod stopped;
