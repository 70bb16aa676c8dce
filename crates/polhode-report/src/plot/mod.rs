//! Plots: the standard figures of a motion, for papers and slides.
//!
//! ```text
//! MotionFigures → Sheet (lines, dots, text, in px) → SVG, or PNG
//! ```
//!
//! A figure draws marks on a [`polhode_document::figure::sheet::Sheet`]; it does not know what becomes of them. One writer turns them into SVG, the
//! other into pixels with letters of its own, so both show the same on every machine. Colours are those of Okabe and Ito,
//! which differ to every eye, and each curve has dashes of its own, which differ in grey.

pub(crate) mod axis_path;
mod chart;
mod constant;
mod curve;
mod drift;
mod envelope;
mod error;
mod euler;
mod event_marks;
mod figure;
mod motion;
mod oscillation;
mod panel;
mod plane;
mod plotted;
pub(crate) mod series;
mod sphere;
mod sweep;
#[cfg(test)]
mod tests;
mod time;
mod view;
mod wheels;

pub use error::PlotError;
pub use figure::Figure;
pub use motion::MotionFigures;

pub use sweep::SweepFigures;
