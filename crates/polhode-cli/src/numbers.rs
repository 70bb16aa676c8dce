//! Numbers in flags: quantities with their units, and lists of them.

use polhode::{Frame, Rotation};
use polhode_formats::unit::{self, Dimension};

/// A number, with its unit or in SI.
pub(crate) fn quantity(text: &str, dimension: Dimension) -> Result<f64, String> {
    unit::parse(text, dimension).map_err(|error| match error.hint() {
        Some(hint) => format!("{error} (hint: {hint})"),
        None => error.to_string(),
    })
}

/// Numbers with commas between, each with its unit; `(1, 2, 3) deg/s` gives all of them one.
///
/// A list in which some have a unit and others, not zero, have none is refused: the unit of the last is often meant for all.
pub(crate) fn list(text: &str, dimension: Dimension) -> Result<Vec<f64>, String> {
    let (inside, unit) = match text.trim().strip_prefix('(').and_then(|rest| rest.split_once(')')) {
        Some((inside, unit)) => (inside, unit),
        None => (text, ""),
    };
    let parts: Vec<_> = inside.split(',').map(|part| format!("{part} {unit}").trim().to_owned()).collect();
    let numbers = parts.iter().map(|part| quantity(part, dimension)).collect::<Result<Vec<_>, _>>()?;
    let has_unit =
        |part: &&String| part.contains(|c: char| c == '°' || c.is_alphabetic() && !"eE".contains(c));
    let bare = parts.iter().zip(&numbers).find(|(part, number)| !has_unit(part) && **number != 0.0);
    match (parts.iter().find(has_unit), bare) {
        (Some(with), Some((without, _))) => Err(format!(
            "{with:?} has a unit and {without:?} has none (hint: give each its own, or one to all: \"(1, 2) unit\")"
        )),
        _ => Ok(numbers),
    }
}

/// As [`list`], of `N` numbers.
pub(crate) fn numbers<const N: usize>(
    text: &str,
    form: &str,
    dimension: Dimension,
) -> Result<[f64; N], String> {
    let found = if text.trim().is_empty() { 0 } else { text.split(',').count() };
    if found != N {
        return Err(format!("{N} numbers belong here ({form}), not {found}"));
    }
    list(text, dimension)?.try_into().map_err(|_| format!("{N} numbers belong here ({form})"))
}

/// A quaternion, scalar first, of any length but zero.
pub(crate) fn rotation<A: Frame, B: Frame>(text: &str) -> Result<Rotation<A, B>, String> {
    let q = numbers(text, "w,x,y,z", Dimension::NONE)?;
    Rotation::from_quaternion(q).map_err(|e| e.to_string())
}

/// The number, if it is positive.
pub(crate) fn positive(value: f64) -> Result<f64, String> {
    if value > 0.0 { Ok(value) } else { Err("it must be positive".to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_has_a_unit_for_each_or_one_for_all() {
        let list = |text: &str| numbers::<3>(text, "x,y,z", Dimension::ANGULAR_VELOCITY);
        assert_eq!(list("1, -2e-3,3"), Ok([1.0, -2e-3, 3.0]));
        assert_eq!(list("0,0,-2 1/s"), Ok([0.0, 0.0, -2.0]));
        assert_eq!(list(" (1, 0.5, 0) rev/s"), list("1 rev/s, 0.5 rev/s, 0"));
        for (wrong, says) in [
            ("1,2,3 deg/s", "\"1\" has none"),
            ("1 deg/s,2,0", "\"2\" has none"),
            ("1,2", "not 2"),
            ("", "not 0"),
            ("1,,3", "not a number"),
            ("(1,2,3) m", "a length"),
            ("(1,2,3 rad/s", "not a number"),
            ("nan,0,1", "not a number"),
        ] {
            let error = list(wrong).unwrap_err();
            assert!(error.contains(says), "{wrong}: {error}");
        }
    }
}
