//! Table of units, each with its exact definition.
//!
//! SI, prefixes, and the units accepted with it: BIPM, *The International System of Units* (SI
//! Brochure, 9th ed. 2019), tables 2, 4, 7 and 8. Pound, foot, ounce, slug, standard gravity: NIST
//! SP 811 (2008), appendix B.8, with the pound of 0.453 592 37 kg and the foot of 0.3048 m, both
//! exact, and lbf = lb × 9.806 65 m/s² exactly, so slug = lbf s²/ft; gauss, 1e-4 T.
//!
//! Names are case-sensitive.

use super::Dimension;

/// Unit found by its name.
#[derive(Clone, Copy)]
pub(crate) struct Unit {
    /// Value in SI: a decimal, π, or a ratio of two of these.
    pub factor: &'static str,
    pub dimension: Dimension,
}

impl Unit {
    /// Returns the unit of that name; both micro signs (U+00B5, U+03BC) are accepted.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let name = name.replace('\u{3bc}', "\u{b5}");
        UNITS
            .iter()
            .find(|(names, ..)| names.split(' ').any(|n| n == name))
            .map(|&(_, factor, dimension)| Self { factor, dimension })
    }
}

/// Returns the first name of each unit of a dimension.
pub(crate) fn names_of(dimension: Dimension) -> impl Iterator<Item = &'static str> {
    let of = UNITS.iter().filter(move |(.., found)| *found == dimension);
    of.filter_map(|(names, ..)| names.split(' ').next())
}

/// Returns the unit named by a word in lower case.
pub(crate) fn word(lower: &str) -> Option<&'static str> {
    WORDS.iter().find(|(words, _)| words.split(' ').any(|word| word == lower)).map(|&(_, unit)| unit)
}

/// Returns the closest unit to a misspelt name, if one is close.
pub(crate) fn suggestion(name: &str) -> Option<String> {
    let base = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let power = &name[base.len()..];
    if power.len() == 1 && Unit::named(base).is_some() {
        return Some(format!("{base}^{power}"));
    }
    let names = || UNITS.iter().flat_map(|(names, ..)| names.split(' '));
    let lower = name.to_lowercase();
    word(&lower)
        .or_else(|| names().find(|n| n.to_lowercase() == lower))
        .or_else(|| names().find(|n| n.len() > 1 && name.len() > 1 && one_edit_apart(n, name)))
        .map(str::to_owned)
}

/// Returns true if `a` and `b` differ by one inserted, omitted, replaced or swapped letter.
fn one_edit_apart(a: &str, b: &str) -> bool {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let head = a.iter().zip(&b).take_while(|(x, y)| x == y).count();
    let (a, b) = (&a[head..], &b[head..]);
    let tail = a.iter().rev().zip(b.iter().rev()).take_while(|(x, y)| x == y).count();
    match (&a[..a.len() - tail], &b[..b.len() - tail]) {
        ([p, q], [r, s]) => p == s && q == r,
        (a, b) => a.len() <= 1 && b.len() <= 1,
    }
}

/// Names of each unit, its value in SI, and its dimension.
const UNITS: &[(&str, &str, Dimension)] = &[
    ("kg", "1", Dimension::MASS),
    ("g", "0.001", Dimension::MASS),
    ("mg", "0.000001", Dimension::MASS),
    ("t", "1000", Dimension::MASS),
    ("lb lbm", "0.45359237", Dimension::MASS),
    ("oz", "0.028349523125", Dimension::MASS), // lb/16
    ("slug", "4.4482216152605/0.3048", Dimension::MASS),
    ("m", "1", Dimension::LENGTH),
    ("km", "1000", Dimension::LENGTH),
    ("dm", "0.1", Dimension::LENGTH),
    ("cm", "0.01", Dimension::LENGTH),
    ("mm", "0.001", Dimension::LENGTH),
    ("µm um", "0.000001", Dimension::LENGTH),
    ("in inch", "0.0254", Dimension::LENGTH),
    ("ft", "0.3048", Dimension::LENGTH),
    ("yd", "0.9144", Dimension::LENGTH),
    ("mi", "1609.344", Dimension::LENGTH),
    ("au", "149597870700", Dimension::LENGTH),
    ("cc", "0.000001", Dimension::VOLUME), // cm^3
    ("s", "1", Dimension::TIME),
    ("ms", "0.001", Dimension::TIME),
    ("µs us", "0.000001", Dimension::TIME),
    ("ns", "0.000000001", Dimension::TIME),
    ("min", "60", Dimension::TIME),
    ("h hr", "3600", Dimension::TIME),
    ("d day", "86400", Dimension::TIME),
    ("rad", "1", Dimension::ANGLE),
    ("mrad", "0.001", Dimension::ANGLE),
    ("µrad urad", "0.000001", Dimension::ANGLE),
    ("deg °", "pi/180", Dimension::ANGLE),
    ("mdeg", "pi/180000", Dimension::ANGLE),
    ("arcmin", "pi/10800", Dimension::ANGLE),
    ("arcsec", "pi/648000", Dimension::ANGLE),
    ("rev turn", "pi/0.5", Dimension::ANGLE),
    ("rpm", "pi/30", Dimension::ANGULAR_VELOCITY),
    ("g0 gee", "9.80665", Dimension::ACCELERATION),
    ("N", "1", Dimension::FORCE),
    ("kN", "1000", Dimension::FORCE),
    ("mN", "0.001", Dimension::FORCE),
    ("µN uN", "0.000001", Dimension::FORCE),
    ("nN", "0.000000001", Dimension::FORCE),
    ("lbf", "4.4482216152605", Dimension::FORCE),     // lb g0
    ("ozf", "0.27801385095378125", Dimension::FORCE), // lbf/16
    ("kgf", "9.80665", Dimension::FORCE),
    ("J Nm", "1", Dimension::TORQUE),
    ("kJ kNm", "1000", Dimension::TORQUE),
    ("mJ mNm Nmm", "0.001", Dimension::TORQUE),
    ("µJ uJ µNm uNm", "0.000001", Dimension::TORQUE),
    ("Nms", "1", Dimension::ANGULAR_MOMENTUM),
    ("mNms", "0.001", Dimension::ANGULAR_MOMENTUM),
    ("A", "1", Dimension::CURRENT),
    ("mA", "0.001", Dimension::CURRENT),
    ("T", "1", Dimension::MAGNETIC_FIELD),
    ("mT", "0.001", Dimension::MAGNETIC_FIELD),
    ("µT uT", "0.000001", Dimension::MAGNETIC_FIELD),
    ("nT", "0.000000001", Dimension::MAGNETIC_FIELD),
    ("G", "0.0001", Dimension::MAGNETIC_FIELD), // gauss
];

/// Words in lower case that are not unit symbols, and the units they mean.
const WORDS: &[(&str, &str)] = &[
    ("gram grams gr gm", "g"),
    ("kilo kilos kilogram kilograms kgs", "kg"),
    ("pound pounds lbs", "lb"),
    ("ounce ounces", "oz"),
    ("tonne tonnes ton tons", "t"),
    ("meter meters metre metres", "m"),
    ("millimeter millimeters millimetre millimetres", "mm"),
    ("centimeter centimeters centimetre centimetres", "cm"),
    ("kilometer kilometers kilometre kilometres", "km"),
    ("milligram milligrams", "mg"),
    ("micron microns micrometer micrometers micrometre micrometres", "µm"),
    ("decimeter decimeters decimetre decimetres", "dm"),
    ("inches", "in"),
    ("foot feet", "ft"),
    ("yard yards", "yd"),
    ("mile miles", "mi"),
    ("sec secs second seconds", "s"),
    ("minute minutes", "min"),
    ("hour hours hrs", "h"),
    ("days", "d"),
    ("radian radians rads", "rad"),
    ("degree degrees degs", "deg"),
    ("revolution revolutions", "rev"),
    ("newton newtons", "N"),
    ("joule joules", "J"),
    ("amp amps ampere amperes", "A"),
    ("tesla", "T"),
    ("gauss gs", "G"),
];

#[cfg(test)]
mod tests {
    use super::*;

    fn names() -> impl Iterator<Item = &'static str> {
        UNITS.iter().flat_map(|(names, ..)| names.split(' '))
    }

    #[test]
    fn a_name_is_one_unit_and_no_word() {
        let mut sorted: Vec<_> = names().collect();
        sorted.sort_unstable();
        let count = sorted.len();
        sorted.dedup();
        assert_eq!(sorted.len(), count);
        for word in WORDS.iter().flat_map(|(words, _)| words.split(' ')) {
            assert!(Unit::named(word).is_none(), "{word}");
        }
        for (_, unit) in WORDS {
            assert!(Unit::named(unit).is_some(), "{unit}");
        }
    }

    #[test]
    fn a_factor_is_made_of_decimals_that_fit() {
        for part in UNITS.iter().flat_map(|(_, factor, _)| factor.split('/')).filter(|&part| part != "pi") {
            assert!(part.replacen('.', "", 1).parse::<u64>().is_ok_and(|integer| integer > 0), "{part}");
        }
    }

    #[test]
    fn one_edit_is_an_insertion_a_removal_a_replacement_or_a_swap() {
        for (a, b) in [("lbm", "lbms"), ("slug", "slg"), ("deg", "dag"), ("rpm", "prm"), ("in", "in")] {
            assert!(one_edit_apart(a, b) && one_edit_apart(b, a), "{a} {b}");
        }
        for (a, b) in
            [("lbm", "lbmss"), ("slug", "sg"), ("deg", "dog!"), ("arcmin", "arcsec"), ("abc", "cba")]
        {
            assert!(!one_edit_apart(a, b) && !one_edit_apart(b, a), "{a} {b}");
        }
    }
}
