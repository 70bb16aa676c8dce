//! A picture, to be written as SVG or PNG.

#[cfg(feature = "png")]
use super::png;
use super::sheet::Sheet;
use super::svg;

/// The keyword of the text in a PNG that says how it was made.
pub(super) const MAKER: &str = "Source";

/// A picture that is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Marks of the picture.
    pub sheet: Sheet,
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
    /// [`png::PngError`] if the picture is too large for the memory.
    #[cfg(feature = "png")]
    pub fn to_png(&self) -> Result<Vec<u8>, png::PngError> {
        png::write(&self.sheet)
    }
}
