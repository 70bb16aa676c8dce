//! Unit names of reports: `grams * square millimeters`, `lbmass in^2`, `KILOGRAM / MM^3`.

use polhode_source::unit;
use polhode_source::unit::Dimension;

/// Unit names of CAD programs and the names in [`polhode_source::unit`], in lower case.
const NAMES: &[(&str, &str)] = &[
    ("milligram milligrams", "mg"),
    ("gram grams g", "g"),
    ("kilogram kilograms kg", "kg"),
    ("tonne tonnes t", "t"),
    ("pound pounds lb lbs lbm lbmass", "lb"),
    ("ounce ounces oz", "oz"),
    ("slug slugs", "slug"),
    ("micron microns micrometer micrometers micrometre micrometres", "um"),
    ("millimeter millimeters millimetre millimetres mm", "mm"),
    ("centimeter centimeters centimetre centimetres cm", "cm"),
    ("meter meters metre metres m", "m"),
    ("inch inches in", "in"),
    ("foot feet ft", "ft"),
];

/// Returns the unit in the grammar of [`unit::parse`], if it has this dimension.
pub(crate) fn read(phrase: &str, dimension: Dimension) -> Option<String> {
    let unit = rewritten(phrase)?;
    unit::factor(&unit, dimension).is_ok().then_some(unit)
}

/// Rewrites a phrase word by word: names are replaced, `square` and `cubic` become a power of the
/// next word, `per` becomes a slash.
fn rewritten(phrase: &str) -> Option<String> {
    let (mut unit, mut power) = (String::new(), "");
    let mut rest = phrase.trim();
    while let Some(first) = rest.chars().next() {
        let word = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
        if word == 0 {
            // A point between factors, as in kg.m^2, or a cross is a product.
            unit.push(if matches!(first, '.' | '×') { '*' } else { first });
            rest = &rest[first.len_utf8()..];
            continue;
        }
        match rest[..word].to_lowercase().as_str() {
            "square" => power = "^2",
            "cubic" => power = "^3",
            "squared" => {
                unit.truncate(unit.trim_end().len());
                unit.push_str("^2");
            }
            "per" => unit.push('/'),
            "x" => unit.push('*'),
            lower => {
                let name = NAMES.iter().find(|(names, _)| names.split(' ').any(|n| n == lower));
                unit.push_str(name.map_or(&rest[..word], |(_, name)| name));
                unit.push_str(power);
                power = "";
            }
        }
        rest = &rest[word..];
    }
    (!unit.is_empty()).then_some(unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_units() {
        let value = |phrase: &str, dimension| {
            let unit = read(phrase, dimension)?;
            unit::factor(&unit, dimension).ok()
        };
        let pound_inch = 0.453_592_37 * 0.0254 * 0.0254;
        for (phrase, want) in [
            (" grams *  square millimeters ", 1e-9),
            ("g mm^2", 1e-9),
            ("KILOGRAM * MM^2", 1e-6),
            ("KILOGRAM * M^2", 1.0),
            ("KG M^2", 1.0),
            ("G * CM^2", 1e-7),
            ("TONNE MM^2", 1e-3),
            ("T * M^2", 1e3),
            ("POUND * FT^2", 0.453_592_37 * 0.3048 * 0.3048),
            ("Kg.m^2", 1.0),
            ("kg m\u{b2}", 1.0),
            ("kilogram meter squared", 1.0),
            ("tonne mm^2", 1e-3),
            ("kilograms x square meters", 1.0),
            ("kg \u{d7} m\u{b2}", 1.0),
            ("pounds * square inches", pound_inch),
            ("lbmass in^2", pound_inch),
        ] {
            let found = value(phrase, Dimension::INERTIA).unwrap();
            assert!((found / want - 1.0).abs() < 1e-15, "{phrase}: {found}");
        }
        assert_eq!(value("grams per cubic millimeter", Dimension::DENSITY), Some(1e6));
        assert_eq!(value("g / mm^3", Dimension::DENSITY), Some(1e6));
        assert_eq!(value("MM^3", Dimension::VOLUME), Some(1e-9));
        assert_eq!(value("M^3", Dimension::VOLUME), Some(1.0));
        assert_eq!(value("M", Dimension::LENGTH), Some(1.0));
        assert_eq!(value("KILOGRAM / M^3", Dimension::DENSITY), Some(1.0));
        for phrase in ["Using positive tensor notation.", "user-overridden", "", "grams"] {
            assert_eq!(read(phrase, Dimension::INERTIA), None, "{phrase}");
        }
    }
}
