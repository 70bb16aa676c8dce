//! Font of pictures: widths of text, and outlines for pixel formats.
//!
//! A subset of Inter (SIL Open Font License 1.1, `font/LICENSE.txt`) is embedded: Latin, Greek,
//! Cyrillic, and mathematical signs. A PNG therefore does not depend on installed fonts. An SVG
//! names a font family and uses the reader's fonts; its layout leaves room for wider letters.

use ttf_parser::Face;

const INTER: &[u8] = include_bytes!("font/inter-subset.ttf");

/// Font family named in an SVG.
pub const FAMILY: &str = "Inter, 'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif";

/// Width factor that allows for fonts wider than Inter.
const ROOM: f64 = 1.06;

/// Font of all letters, parsed; `None` if the parser refuses it.
pub fn face() -> Option<Face<'static>> {
    Face::parse(INTER, 0).ok()
}

/// Returns the width of a line of text, px, with a margin for other fonts.
pub fn width(text: &str, size: f64) -> f64 {
    // Without a font, the mean width of a letter is taken as half its size.
    let units = face().map_or(0.5 * text.chars().count() as f64, |face| advance(&face, text));
    units * size * ROOM
}

/// Returns the width of a line of text in units of its size.
pub fn advance(face: &Face<'_>, text: &str) -> f64 {
    let of = |c: char| {
        glyph(face, c)
            .and_then(|glyph| face.glyph_hor_advance(glyph))
            .map_or(0.5, |units| f64::from(units) / f64::from(face.units_per_em()))
    };
    text.chars().map(of).sum()
}

/// Returns the glyph of a letter; a letter that the font lacks is shown as an empty box.
pub fn glyph(face: &Face<'_>, c: char) -> Option<ttf_parser::GlyphId> {
    face.glyph_index(c).or(Some(ttf_parser::GlyphId(0)))
}

/// Returns the text, shortened with an ellipsis if it is wider than `room` px.
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
