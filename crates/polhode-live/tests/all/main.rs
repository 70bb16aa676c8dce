//! Tests of the server through its addresses.

mod lesson_files;
mod lessons;
