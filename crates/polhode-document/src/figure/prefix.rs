//! Units with a prefix or a power of ten.

use super::ticks::{exponent, power_of_ten, reduced};
use crate::number::{NO_BREAK, number, typeset};
use crate::si_prefix::prefixes;

/// Returns the prefix for a power of ten, if one is in use with the unit.
fn prefix(exponent: i32, unit: &str) -> Option<&'static str> {
    prefixes(unit).find(|(power, _)| *power == exponent).map(|(_, prefix)| prefix)
}

/// Returns the unit 10^exponent × `unit`: `mJ`, `10⁻⁶ kg·m²/s`.
pub fn unit(exponent: i32, unit: &str) -> String {
    match prefix(exponent, unit) {
        _ if exponent == 0 => unit.to_owned(),
        Some(prefix) => format!("{prefix}{unit}"),
        None => format!("{}{NO_BREAK}{unit}", power_of_ten(exponent)).trim_end().to_owned(),
    }
}

/// Formats a value with at most `digits` digits and its unit, without line breaks: `3.5214 mJ`,
/// `7.7908×10⁻⁴ kg·m²/s`.
pub fn value(x: f64, digits: usize, name: &str) -> String {
    let power = exponent(x);
    let (shown, unit) = match prefix(power, name) {
        Some(prefix) => (reduced(x, power), format!("{prefix}{name}")),
        None => (x, name.to_owned()),
    };
    format!("{}{NO_BREAK}{unit}", typeset(&number(shown, digits)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::plain_spaces;

    #[test]
    fn units_have_the_prefix_that_is_in_use_or_a_factor() {
        let units = [(0, "J"), (-3, "J"), (-6, "N·m"), (-12, "s"), (12, "rad/s"), (-6, "kg·m²/s"), (3, "")];
        let shown = units.map(|(exponent, name)| plain_spaces(&unit(exponent, name)));
        assert_eq!(shown, ["J", "mJ", "µN·m", "ps", "10¹² rad/s", "10⁻⁶ kg·m²/s", "10³"]);
    }

    #[test]
    fn values_keep_their_digits_in_the_unit() {
        let shown = |x, name| plain_spaces(&value(x, 6, name));
        assert_eq!(shown(3.521_437_8e-3, "J"), "3.52144 mJ");
        assert_eq!(shown(-8.55e-5, "J"), "−85.5 µJ");
        assert_eq!(shown(7.790_812e-4, "kg·m²/s"), "7.79081×10⁻⁴ kg·m²/s");
        assert_eq!(shown(240.855_4, "rad/s"), "240.855 rad/s");
    }
}
