//! Plots: the standard figures of a motion, for papers and slides.
//!
//! Each figure draws marks on a [`polhode_document::figure::sheet::Sheet`], which is written as SVG
//! or PNG.

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
#[cfg(test)]
mod tests;
mod time;
mod view;
mod wheels;

pub use error::PlotError;
pub use figure::Figure;
pub use motion::MotionFigures;
