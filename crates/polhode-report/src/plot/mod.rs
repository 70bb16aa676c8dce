//! Plots: the standard figures of a motion, for papers and slides.
//!
//! ```text
//! MotionFigures → Sheet (lines, dots, text, in px) → SVG, or PNG
//! ```
//!
//! A figure draws marks on a [`sheet::Sheet`]; it does not know what becomes of them. One writer turns them into SVG, the
//! other into pixels with letters of its own, so both show the same on every machine. Colours are those of Okabe and Ito,
//! which differ to every eye, and each curve has dashes of its own, which differ in grey.

mod axes;
mod axis_path;
mod drift;
mod error;
mod euler;
mod figure;
mod font;
mod line;
mod motion;
mod panel;
mod plane;
mod plotted;
#[cfg(feature = "png")]
mod png;
mod series;
mod sheet;
mod sphere;
mod svg;
mod sweep;
#[cfg(test)]
mod tests;
mod ticks;
mod view;
mod wheels;

pub use error::PlotError;
pub use figure::Figure;
pub use motion::MotionFigures;
pub use sweep::SweepFigures;

/// A picture that is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    sheet: sheet::Sheet,
}

impl Picture {
    /// As SVG; text stays text, in the reader's sans-serif.
    pub fn to_svg(&self) -> String {
        svg::write(&self.sheet)
    }

    /// As PNG, 288 pixels to an inch, on white.
    ///
    /// # Errors
    /// [`PlotError::Pixels`] if the picture is too large for the memory.
    #[cfg(feature = "png")]
    pub fn to_png(&self) -> Result<Vec<u8>, PlotError> {
        png::write(&self.sheet)
    }
}
