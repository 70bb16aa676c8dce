//! Orbit of a satellite, for its picture.

use polhode::math::{Direction, Space};
use polhode::motion::{MU_EARTH, Orbit};
use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

/// Equatorial radius of the Earth, m (WGS 84).
const EARTH: f64 = 6_378_137.0;

/// Returns the conic r = p/(1 + e · r̂) with its normal, and the radius of the central body if it is
/// the Earth.
///
/// r̂ is opposite to the nadir of the page's directions.
pub(crate) fn json(orbit: &Orbit) -> Value {
    let [position, velocity, rate]: [Direction<Space>; 3] = [
        orbit.position(0.0).to_array(),
        orbit.velocity(0.0).to_array(),
        orbit.angular_velocity(0.0).to_array(),
    ]
    .map(Direction::from_array);
    let normal = rate / rate.norm();
    // In units of √(µ/p), v = n × (e + r̂); therefore e = v × n − r̂.
    let parameter = orbit.periapsis() * (1.0 + orbit.eccentricity());
    let speed = velocity * (parameter / orbit.mu()).sqrt();
    let eccentricity = if orbit.eccentricity() > 0.0 {
        speed.cross(normal) - position / position.norm()
    } else {
        Direction::ZERO
    };
    let is_earth = (orbit.mu() / MU_EARTH - 1.0).abs() < 1e-2;
    json!({
        "parameter": finite(parameter),
        "eccentricity": numbers(&eccentricity.to_array().map(finite)),
        "normal": numbers(&normal.to_array().map(finite)),
        "central": (is_earth && orbit.periapsis() > EARTH).then_some(EARTH),
    })
}
