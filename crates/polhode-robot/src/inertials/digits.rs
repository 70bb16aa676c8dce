//! Numbers of an inertial as text, each with the digits that its error leaves.

use polhode::body::MassProperties;
use polhode::math::Part;
use polhode_document::number::number;

use crate::moments::{Elements, elements, norm};

/// Digits that identify any double.
const MOST: usize = 17;

/// Number as text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Digits {
    pub(super) text: String,
    pub(super) value: f64,
}

/// Mass, centre and tensor of an inertial as text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct InertialDigits {
    /// Mass in kg.
    pub(super) mass: Digits,
    /// Centre of mass in the link's frame, m.
    pub(super) center: [Digits; 3],
    /// Elements xx, yy, zz, xy, xz, yz about the centre of mass, link axes, kg·m².
    pub(super) tensor: [Digits; 6],
    /// Bounds on the changes by rounding: of the mass, kg; of a coordinate, m; of an element, kg·m².
    pub(super) errors: [f64; 3],
}

impl Digits {
    /// Returns the shortest decimal that differs from a number by at most an error.
    pub(super) fn within(x: f64, error: f64) -> Self {
        if x.abs() <= error {
            return Self { text: "0".to_owned(), value: 0.0 };
        }
        let shorter = (1..MOST).find_map(|digits| {
            let text = number(x, digits);
            let value: f64 = text.parse().ok()?;
            ((value - x).abs() <= error).then_some(Self { text, value })
        });
        shorter.unwrap_or_else(|| Self { text: number(x, MOST), value: x })
    }
}

impl InertialDigits {
    /// Returns the numbers of a body whose moments have this relative error; `extent` is the
    /// distance of its farthest point from the link's origin, m. `mass` is the text of a kept mass.
    pub(super) fn of(body: &MassProperties<Part>, error: f64, extent: f64, mass: Option<Digits>) -> Self {
        let tensor: Elements = elements(&body.inertia().matrix());
        let errors = [error * body.mass(), error * extent, error * norm(&tensor)];
        Self {
            mass: mass.unwrap_or_else(|| Digits::within(body.mass(), errors[0])),
            center: body.center_of_mass().to_array().map(|c| Digits::within(c, errors[1])),
            tensor: tensor.map(|element| Digits::within(element, errors[2])),
            errors,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Digits;

    #[test]
    fn the_shortest_decimal_within_the_error() {
        let text = |x: f64, error: f64| Digits::within(x, error).text;
        assert_eq!(text(0.123_456_789, 1e-4), "0.1235");
        assert_eq!(text(-0.123_456_789, 5e-10), "-0.123456789");
        assert_eq!(text(0.1 + 0.2, 1e-15), "0.3");
        assert_eq!(text(0.1 + 0.2, 0.0), "0.30000000000000004");
        assert_eq!(text(-3e-17, 1e-16), "0");
        assert_eq!(text(0.0, 0.0), "0");
        assert_eq!(text(4.123e-7, 1e-10), "4.123e-7");
    }
}
