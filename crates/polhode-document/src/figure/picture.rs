//! Picture that can be written as SVG or PNG.

#[cfg(feature = "png")]
use super::png;
use super::sheet::{MAKER, Sheet};
use super::svg;

/// Scale of pictures on a page.
const ON_PAGE: f64 = 1.15;

/// Drawn picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Marks of the picture.
    pub sheet: Sheet,
}

impl Picture {
    /// Returns the picture as SVG. Text remains text in the reader's sans-serif font.
    pub fn to_svg(&self) -> String {
        svg::write(&self.sheet)
    }

    /// Returns the picture as SVG for a page, where its letters are as large as those of tables.
    pub(crate) fn to_page_svg(&self) -> String {
        svg::scaled(&self.sheet, ON_PAGE)
    }

    /// Returns the picture with the command that made it; the command is written into the file.
    #[must_use]
    pub fn made_by(mut self, command: &str) -> Self {
        self.sheet.maker = Some(command.to_owned());
        self
    }

    /// Returns true if the beginning of a file states that this command made the picture.
    pub fn is_made_by(head: &[u8], command: &str) -> bool {
        let holds = |text: &[u8]| head.windows(text.len()).any(|window| window == text);
        holds(format!("<desc>{}</desc>", svg::escaped(command)).as_bytes())
            || holds(&[MAKER.as_bytes(), &[0; 5], command.as_bytes(), b"\n"].concat())
    }

    /// Returns the picture as PNG, 288 pixels per inch, on white.
    ///
    /// # Errors
    /// [`png::PngError`] if the picture is too large for the memory.
    #[cfg(feature = "png")]
    pub fn to_png(&self) -> Result<Vec<u8>, png::PngError> {
        png::write(&self.sheet)
    }
}
