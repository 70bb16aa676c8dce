//! TOML with places: tables and values that know where in the file they stand, so that every error can say it.

mod asked;
mod body_part;
pub mod list_units;
mod meant;
pub mod reader;
mod rotation;
pub mod source;
mod text;
pub mod tree;

pub use asked::{Asked, Question, What};
pub use body_part::BodyPart;
pub use rotation::rotation;
pub use text::{LARGEST_FILE, document, text_of};
