//! Pictures: marks on a sheet, written as SVG or as pixels.
//!
//! ```text
//! Sheet (lines, dots, polygons, text, in px) → SVG, or PNG
//! ```
//!
//! A figure draws marks on a [`sheet::Sheet`] and does not know their format. SVG and PNG show the
//! same on every machine, as PNG has its own letters. Colours are those of Okabe and Ito, which
//! differ to every eye. Each curve also has its own dashes, which differ in grey.

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
