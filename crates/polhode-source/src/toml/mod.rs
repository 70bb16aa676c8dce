//! TOML with places: tables and values know their position in the file, and every error states it.

mod asked;
mod body_part;
pub mod list_units;
mod meant;
pub mod reader;
mod rotation;
pub mod source;
pub mod symbols;
mod text;
pub mod tree;

pub use asked::{Asked, Question, What};
pub use body_part::BodyPart;
pub use rotation::rotation;
pub use text::{LARGEST_FILE, document, root_names, text_of};
