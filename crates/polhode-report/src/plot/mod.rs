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
pub(crate) mod axis_path;
mod bars;
mod chart;
mod constant;
mod curve;
mod drawing;
mod drift;
mod envelope;
mod error;
mod euler;
mod event_marks;
mod figure;
mod font;
mod graph;
mod legend;
mod line;
mod motion;
mod oscillation;
mod panel;
mod plane;
mod plotted;
#[cfg(feature = "png")]
mod png;
mod prefix;
mod range;
mod scale;
pub(crate) mod series;
mod sheet;
mod solids;
mod sphere;
mod svg;
mod sweep;
#[cfg(test)]
mod tests;
mod ticks;
mod time;
mod triangle;
mod view;
mod wheels;

pub use error::PlotError;
pub use figure::Figure;
pub use motion::MotionFigures;
pub use sweep::SweepFigures;

/// The keyword of the text in a PNG that says how it was made.
const MAKER: &str = "Source";

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

    /// With the command that makes it, which is written into the file.
    #[must_use]
    pub fn made_by(mut self, command: &str) -> Self {
        self.sheet.maker = Some(command.to_owned());
        self
    }

    /// Whether the beginning of a file of a picture says that this command made it.
    pub fn is_made_by(head: &[u8], command: &str) -> bool {
        let holds = |text: &[u8]| head.windows(text.len()).any(|window| window == text);
        holds(format!("<desc>{}</desc>", svg::escaped(command)).as_bytes())
            || holds(&[MAKER.as_bytes(), &[0; 5], command.as_bytes(), b"\n"].concat())
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
