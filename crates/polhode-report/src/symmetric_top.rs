//! The constants of a free symmetric top, for programs.

use polhode::observe::{Cones, SymmetricTop};
use polhode_document::json::vector;
use serde_json::{Map, Value};

/// Axis, moments, rates and cones.
pub(crate) fn to_json(top: &SymmetricTop, cones: &Cones) -> Map<String, Value> {
    let [axial, transverse] = top.moments();
    let numbers = [
        ("axial_moment", axial),
        ("transverse_moment", transverse),
        ("spin_rad_s", top.spin()),
        ("body_rate_rad_s", cones.body_rate),
        ("space_rate_rad_s", cones.space_rate),
        ("body_cone_half_angle_rad", cones.body_half_angle),
        ("space_cone_half_angle_rad", cones.space_half_angle),
        ("nutation_rad", cones.nutation),
    ];
    let numbers = numbers.into_iter().map(|(key, value)| (key.to_owned(), value.into()));
    [("axis".to_owned(), vector(top.axis()))].into_iter().chain(numbers).collect()
}
