//! A body as ten numbers.

use polhode::body::MassProperties;
use polhode::math::Body;

use crate::SequenceRow;

/// How fast they change.
pub(crate) fn rates(row: &SequenceRow) -> [f64; 10] {
    let [x, y, z] = row.rates.center_of_mass.to_array();
    let [xx, yy, zz, xy, xz, yz] = row.rates.inertia;
    [row.rates.mass, x, y, z, xx, yy, zz, xy, xz, yz]
}

/// The ten numbers.
pub(crate) fn ten(body: &MassProperties<Body>) -> [f64; 10] {
    let [[xx, xy, xz], [_, yy, yz], [.., zz]] = body.inertia().matrix();
    let [x, y, z] = body.center_of_mass().to_array();
    [body.mass(), x, y, z, xx, yy, zz, xy, xz, yz]
}
