//! Permanent rotation: ω along a principal axis.

use crate::body::principal::{PrincipalFrame, Symmetry};
use crate::math::frame::Body;
use crate::math::rotation::Rotation;
use crate::math::vector::AngularVelocity;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;

/// A rotation whose axis stays fixed in the body and in space: attitude(t) = attitude(0) · turn(ω̂, |ω| t).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PermanentRotation {
    start: State,
}

/// The principal axis of a permanent rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PermanentAxis {
    /// Of the least of three different moments: stable.
    Least,
    /// Of the intermediate one: any departure grows.
    Intermediate,
    /// Of the greatest one: stable.
    Greatest,
    /// The symmetry axis of a body with two equal moments.
    Symmetry,
    /// Across the symmetry axis.
    AcrossSymmetry,
    /// Any axis of a body with three equal moments.
    Any,
}

/// ω counts as along a stable axis within this part of |ω|, the rounding of a turned tensor: what is left only wobbles
/// by as much.
const ALONG: f64 = 8.0 * f64::EPSILON;

impl PermanentAxis {
    /// The axis that ω turns about for good; `None` if it does not, or is zero.
    ///
    /// Along the intermediate of three different axes ω has to be exactly: any departure grows, so a nearly permanent
    /// rotation is not one.
    pub fn of(principal: &PrincipalFrame<Body>, omega: AngularVelocity<Body>) -> Option<Self> {
        let w = principal.axes().map(|axis| axis.dot(omega).abs());
        let speed = omega.norm();
        if speed == 0.0 {
            return None;
        }
        let axisymmetric = |along: f64, across: f64| {
            if across <= ALONG * speed {
                Some(Self::Symmetry)
            } else {
                (along <= ALONG * speed).then_some(Self::AcrossSymmetry)
            }
        };
        match principal.symmetry() {
            Symmetry::Spherical | Symmetry::Point => Some(Self::Any),
            Symmetry::Oblate => axisymmetric(w[2], libm::hypot(w[0], w[1])),
            Symmetry::Prolate | Symmetry::Rod => axisymmetric(w[0], libm::hypot(w[1], w[2])),
            Symmetry::Asymmetric => {
                let [w1, w2, w3] = w;
                let within = |a: f64, b: f64| libm::hypot(a, b) <= ALONG * speed;
                if within(w2, w3) {
                    Some(Self::Least)
                } else if within(w1, w2) {
                    Some(Self::Greatest)
                } else {
                    (w1 == 0.0 && w3 == 0.0).then_some(Self::Intermediate)
                }
            }
        }
    }

    /// The rotation in words.
    pub const fn description(self) -> &'static str {
        match self {
            Self::Least => "permanent rotation about the axis of least moment",
            Self::Intermediate => "permanent rotation about the axis of intermediate moment (unstable)",
            Self::Greatest => "permanent rotation about the axis of greatest moment",
            Self::Symmetry => "permanent rotation about the symmetry axis",
            Self::AcrossSymmetry => "permanent rotation about an axis across the symmetry axis",
            Self::Any => "permanent rotation (the three moments are equal)",
        }
    }
}

impl PermanentRotation {
    /// `None` unless ω lies along a principal axis, or is zero.
    pub(super) fn of(rotor: &Rotor, start: State) -> Option<Self> {
        let permanent = PermanentAxis::of(rotor.principal(), start.omega).is_some();
        (permanent || start.omega == AngularVelocity::ZERO).then_some(Self { start })
    }

    /// The state at a time, s.
    pub fn at(&self, time: f64) -> State {
        let State { attitude, omega, time: t0 } = self.start;
        let turn =
            omega.direction().map_or(Rotation::identity(), |n| Rotation::turn(n, omega.norm() * (time - t0)));
        State { time, attitude: attitude * turn, omega }
    }
}
