//! A body as ten numbers.

use polhode::body::MassProperties;
use polhode::math::Body;

/// The ten numbers.
pub(super) fn ten(body: &MassProperties<Body>) -> [f64; 10] {
    let [[xx, xy, xz], [_, yy, yz], [.., zz]] = body.inertia().matrix();
    let [x, y, z] = body.center_of_mass().to_array();
    [body.mass(), x, y, z, xx, yy, zz, xy, xz, yz]
}
