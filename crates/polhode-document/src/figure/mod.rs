//! Pictures: marks on a sheet, written as SVG or PNG.
//!
//! ```text
//! Sheet (lines, dots, polygons, text, in px) → SVG, or PNG
//! ```
//!
//! A figure draws marks on a [`sheet::Sheet`], independent of the output format. SVG and PNG look
//! the same; a PNG does not depend on installed fonts. Colours are those of Okabe and Ito,
//! distinguishable with any colour vision. Each curve also has its own dash pattern, for grey
//! prints.

pub mod axes;
mod bars;
mod drawing;
pub mod font;
mod graph;
pub mod legend;
pub mod line;
pub(crate) mod picture;
#[cfg(feature = "png")]
mod png;
pub mod prefix;
pub mod range;
pub mod scale;
pub mod sheet;
mod solids;
pub mod svg;
pub mod ticks;
mod triangle;

#[cfg(feature = "png")]
pub use png::PngError;
