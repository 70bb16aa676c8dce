//! The letters of pictures: how wide they are, and their outlines where there are only pixels.
//!
//! A part of Inter (SIL Open Font License 1.1, `font/LICENSE.txt`) is in the program: Latin, Greek, Cyrillic, and
//! the signs of formulas. A PNG therefore does not depend on the fonts of a machine. An SVG names a family and is
//! shown in the reader's; its layout leaves room for wider letters.

use ttf_parser::Face;

const INTER: &[u8] = include_bytes!("font/inter-subset.ttf");

/// The family that an SVG asks for.
pub const FAMILY: &str = "Inter, 'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif";

/// Letters of other fonts, Inter's being 1.
const ROOM: f64 = 1.06;

/// Font of all letters, parsed; `None` if the parser refuses it.
pub fn face() -> Option<Face<'static>> {
    Face::parse(INTER, 0).ok()
}

/// The width of a line of text that is safe in other fonts too, px.
pub fn width(text: &str, size: f64) -> f64 {
    // Half its size is the mean width of a letter, if ever there is no font.
    let units = face().map_or(0.5 * text.chars().count() as f64, |face| advance(&face, text));
    units * size * ROOM
}

/// The width of a line of text in units of its size.
pub fn advance(face: &Face<'_>, text: &str) -> f64 {
    let of = |c: char| {
        glyph(face, c)
            .and_then(|glyph| face.glyph_hor_advance(glyph))
            .map_or(0.5, |units| f64::from(units) / f64::from(face.units_per_em()))
    };
    text.chars().map(of).sum()
}

/// The glyph of a letter; one that the font lacks is shown as an empty box.
pub fn glyph(face: &Face<'_>, c: char) -> Option<ttf_parser::GlyphId> {
    face.glyph_index(c).or(Some(ttf_parser::GlyphId(0)))
}

/// The text, shortened with an ellipsis to what fits.
pub fn fitted(text: &str, size: f64, room: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let mut letters: Vec<char> = text.chars().take(1000).collect();
    while !letters.is_empty() {
        letters.pop();
        let shorter = letters.iter().collect::<String>().trim_end().to_owned() + "…";
        if width(&shorter, size) <= room {
            return shorter;
        }
    }
    String::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sign_of_the_figures_is_in_the_font() {
        let face = face().unwrap();
        for c in "ωφθψΩLTUE₁₂₃ₓ⁻⁰¹²³⁴⁵⁶⁷⁸⁹·−×…°½∫≤→—|%()[],./'".chars()
        {
            assert!(face.glyph_index(c).is_some(), "{c}");
        }
        assert!(width("ω₁", 10.0) > width("ω", 10.0));
    }

    #[test]
    fn long_text_is_shortened() {
        assert_eq!(fitted("short", 10.0, 100.0), "short");
        let cut = fitted("a title that goes on and on", 10.0, 60.0);
        assert!(cut.ends_with('…') && width(&cut, 10.0) <= 60.0 && cut.len() > 8, "{cut}");
    }
}
