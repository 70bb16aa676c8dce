//! Permanent rotation: ω along a principal axis.

use crate::body::principal::Symmetry;
use crate::math::rotation::Rotation;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;

/// A rotation whose axis stays fixed in the body and in space: attitude(t) = attitude(0) · turn(ω̂, |ω| t).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PermanentRotation {
    start: State,
}

impl PermanentRotation {
    /// `None` unless ω lies exactly along a principal axis, or the body is spherical, or at rest.
    ///
    /// Exactly: about an unstable axis any departure grows, so a nearly permanent rotation is not one.
    pub(super) fn of(rotor: &Rotor, start: State) -> Option<Self> {
        let principal = rotor.principal();
        let w = principal.axes().map(|axis| axis.dot(start.omega));
        let along_axis = w.iter().filter(|w| **w != 0.0).count() <= 1;
        (along_axis || principal.symmetry() == Symmetry::Spherical).then_some(Self { start })
    }

    /// The state at a time, s.
    pub fn at(&self, time: f64) -> State {
        let State { attitude, omega, time: t0 } = self.start;
        let turn =
            omega.direction().map_or(Rotation::identity(), |n| Rotation::turn(n, omega.norm() * (time - t0)));
        State { time, attitude: attitude * turn, omega }
    }
}
