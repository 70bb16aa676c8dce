//! Body cone and space cone of a free symmetric top.

use crate::math::frame::{Body, Space};
use crate::math::symmetric3::power_of_two_near;
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::model::state::State;

use super::symmetric_top::SymmetricTop;

/// Cones that ω sweeps: about the symmetry axis e in the body, and about L in space.
///
/// The body cone rolls on the space cone without slipping; they touch along ω.
///
/// Source: the lecture notes, "Force-free motion of a symmetric top".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cones {
    /// Half-angle of the body cone, between ω and ±e, 0 … π/2 rad: tan = ω_t / |ω_e|.
    pub body_half_angle: f64,
    /// Half-angle of the space cone, between ω and L, rad.
    pub space_half_angle: f64,
    /// Nutation angle between L and ±e, 0 … π/2 rad, constant.
    pub nutation: f64,
    /// Ω: rate at which ω circles e in the body, rad/s; negative if against the right-hand rule
    /// about e.
    pub body_rate: f64,
    /// φ̇ = |L|/I_t: rate at which ω and e circle L in space, rad/s.
    pub space_rate: f64,
}

impl Cones {
    /// Returns the cones of a motion; they do not depend on the time.
    pub fn of(top: &SymmetricTop) -> Self {
        let [axial, transverse] = top.moments();
        let start = top.start();
        let across = (start.omega - along_axis(top, start.omega)).norm();
        // Values are scaled by powers of two near the largest: this is exact, and no product
        // overflows.
        let (rate, moment) = (power_of_two_near(start.omega.max_abs()), power_of_two_near(transverse));
        let (across, spin) = (across / rate, top.spin().abs() / rate);
        let (axial, transverse) = (axial / moment, transverse / moment);
        // The components of L are I_t ω_t perpendicular to e and I_e ω_e along it.
        let body_half_angle = libm::atan2(across, spin);
        let nutation = libm::atan2(transverse * across, axial * spin);
        Self {
            body_half_angle,
            // ω and L lie in one plane with e, on the same side of it.
            space_half_angle: libm::atan2(
                (transverse - axial).abs() * across * spin,
                transverse * across * across + axial * spin * spin,
            ),
            nutation,
            body_rate: top.body_rate(),
            space_rate: top.space_rate(),
        }
    }

    /// Returns the deviation of L, ω and e from coplanarity at a state: |ê · (ω̂ × L̂)|, zero
    /// except for rounding.
    ///
    /// It is also zero if two of them are parallel.
    pub fn coplanarity(top: &SymmetricTop, state: &State) -> f64 {
        let e = state.attitude * top.axis();
        let omega: Option<Direction<Space>> = state.omega_space().direction();
        omega.map_or(0.0, |omega| e.dot(omega.cross(top.momentum_direction())).abs())
    }
}

fn along_axis(top: &SymmetricTop, omega: AngularVelocity<Body>) -> AngularVelocity<Body> {
    top.axis().as_quantity() * top.axis().dot(omega)
}
