//! Ten numbers of a body.

use polhode::body::MassProperties;
use polhode::math::Frame;
use polhode_document::number::tidy;

use crate::{NUMBERS, SequenceRow};

/// Returns the rates of change of the ten numbers.
pub(crate) fn rates(row: &SequenceRow) -> [f64; 10] {
    let [x, y, z] = row.rates.center_of_mass.to_array();
    let [xx, yy, zz, xy, xz, yz] = row.rates.inertia;
    [row.rates.mass, x, y, z, xx, yy, zz, xy, xz, yz]
}

/// Returns the numbers, with 0 for coordinates of the centre that are only rounding.
pub(crate) fn tidied(mut values: [f64; 10]) -> [f64; 10] {
    let center = tidy([values[1], values[2], values[3]]);
    values[1..4].copy_from_slice(&center);
    values
}

/// Returns the name of a number, the unit in which it is shown, and the factor from SI to that
/// unit.
///
/// Lengths are shown in the given unit.
pub(crate) fn shown(k: usize, length: (&'static str, f64)) -> (&'static str, &'static str, f64) {
    let (name, unit) = NUMBERS[k];
    let (unit, scale) = if unit == "m" { length } else { (unit, 1.0) };
    (name, unit, scale)
}

/// Returns the ten numbers of a body.
pub(crate) fn ten<F: Frame>(body: &MassProperties<F>) -> [f64; 10] {
    let [[xx, xy, xz], [_, yy, yz], [.., zz]] = body.inertia().matrix();
    let [x, y, z] = body.center_of_mass().to_array();
    [body.mass(), x, y, z, xx, yy, zz, xy, xz, yz]
}
