//! How near a start is to the intermediate axis.

use polhode::body::PrincipalFrame;
use polhode::math::Body;
use polhode::motion::State;
use polhode_document::number::number;

/// The angle between ω and the line of axis 2, in degrees.
pub(crate) fn degrees_off(principal: &PrincipalFrame<Body>, start: &State) -> String {
    let angle = start.omega.angle_to(principal.axis(1));
    number(angle.min(std::f64::consts::PI - angle).to_degrees(), 3)
}
