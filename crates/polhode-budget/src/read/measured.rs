//! Numbers with their errors: `1.2 ± 0.1 kg`, `1.2 kg ± 5 %`.

use polhode_source::unit;
use polhode_source::unit::{Dimension, UnitError};

use super::number::{Amount, Measured, Unit, Wrong, is_parted};

pub(crate) const MARKS: [&str; 3] = ["±", "+/-", "+-"];

/// Reads a number of a column, with its error if the cell has one.
pub(crate) fn measured(
    text: &str,
    unit: &Unit,
    dimension: Dimension,
    heading: &str,
) -> Result<Measured, Wrong> {
    // Most numbers have no error, and a search for three marks costs more than everything else.
    let is_marked = text.bytes().any(|b| b == b'+' || !b.is_ascii());
    let marked = || MARKS.iter().find_map(|mark| text.split_once(mark));
    let Some((left, right)) = is_marked.then(marked).flatten() else {
        return Ok(unit.read(text, dimension)?);
    };
    // (1.2 ± 0.1) kg
    let (left, right) = match (left.trim().strip_prefix('('), right.split_once(')')) {
        (Some(left), Some((right, unit))) => (left, format!("{right} {unit}")),
        _ => (left, right.to_owned()),
    };
    let (left, right) = (left.trim(), right.trim());
    if let Some(fraction) = percent(right) {
        let read = unit.read(left, dimension)?;
        return Ok(Measured { error: Some(Amount::Relative(fraction?)), ..read });
    }
    let last = unit::unit_of(right);
    let value = match (unit::unit_of(left).is_empty(), last.is_empty()) {
        (true, false) => unit.read(&format!("{left} {last}"), dimension)?,
        (false, true) => {
            let rule = "a number and an error in one unit";
            let hint = format!("write {left} ± {right} {}", unit::unit_of(left));
            return Err(Wrong::rule(heading, text, rule, &hint));
        }
        _ => unit.read(left, dimension)?,
    };
    let error = unit.read(right, dimension)?;
    Ok(Measured { value: value.value, error: Some(Amount::Absolute(error.value)), has_unit: error.has_unit })
}

/// Reads a fraction in percent; `None` if the text is not in percent.
pub(crate) fn percent(text: &str) -> Option<Result<f64, Wrong>> {
    text.trim().strip_suffix('%').map(|number| hundredths(number.trim_end()))
}

/// Reads a number of hundredths.
pub(crate) fn hundredths(number: &str) -> Result<f64, Wrong> {
    if is_parted(number) {
        return Err(UnitError::NotANumber { text: number.to_owned() }.into());
    }
    unit::parse(&hundredth(number), Dimension::NONE).map_err(Wrong::from)
}

/// Divides a number by 100 in its text form.
fn hundredth(number: &str) -> String {
    match unit::number_of(number) {
        // The number is in one piece: 1.5e-2 has an exponent, and 1.5 has none.
        Some(whole) if unit::unit_of(number).is_empty() => match whole.split_once('e') {
            Some((digits, power)) => match power.parse::<i32>().ok().and_then(|power| power.checked_sub(2)) {
                Some(power) => format!("{digits}e{power}"),
                None => whole,
            },
            None => format!("{whole}e-2"),
        },
        _ => number.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_read_in_every_form() {
        let grams = Unit::new("g", Dimension::MASS).unwrap();
        let absolute = |value, error| (value, Some(Amount::Absolute(error)));
        for (text, expected) in [
            ("12.5", (0.0125, None)),
            ("12.5 ± 0.5", absolute(0.0125, 0.0005)),
            ("12.5±0.5", absolute(0.0125, 0.0005)),
            ("1.25 ± 0.05 kg", absolute(1.25, 0.05)),
            ("(1.25 +- 0.05) kg", absolute(1.25, 0.05)),
            ("1.25 kg +/- 50 g", absolute(1.25, 0.05)),
            ("1.25 kg ± 4 %", (1.25, Some(Amount::Relative(0.04)))),
            ("12.5 ± 7%", (0.0125, Some(Amount::Relative(0.07)))),
        ] {
            let read = measured(text, &grams, Dimension::MASS, "mass").unwrap();
            assert_eq!((read.value, read.error), expected, "{text}");
        }
        for text in ["1.25 kg ± 0.05", "1 ± 2 mm", "± 3", "3 ±", "1 ± 2 ± 3", "1 ± x %", "1,5", "%"] {
            assert!(measured(text, &grams, Dimension::MASS, "mass").is_err(), "{text}");
        }
    }
}
