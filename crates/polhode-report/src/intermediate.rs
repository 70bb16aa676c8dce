//! How near a start is to the intermediate axis.

use polhode::{Rotor, State};

use crate::number::number;

/// The angle between ω and the line of axis 2, in degrees.
pub(crate) fn degrees_off(rotor: &Rotor, start: &State) -> String {
    let angle = start.omega.angle_to(rotor.principal().axis(1));
    number(angle.min(std::f64::consts::PI - angle).to_degrees(), 3)
}
