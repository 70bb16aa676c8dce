//! Free symmetric top: two equal moments, two uniform rotations.

use crate::body::principal::{PrincipalFrame, Symmetry};
use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::model::state::State;
use crate::motion::solve::free::{FreeMotion, Regime};

/// Free motion of a body with a symmetry axis e.
///
/// Seen from the body, ω circles e at the rate Ω = (I_e − I_t) ω_e / I_t. In space, ω and e circle
/// L at the rate φ̇ = |L| / I_t. Both rates are constant, so the attitude is a product of two
/// rotations with linear phases:
///
/// attitude(t) = turn(L̂, φ̇ t) · attitude(0) · turn(e, −Ω t)
///
/// I_e is the moment about e (i3 in the notes), and I_t the moment perpendicular to it (i1 = i2 in
/// the notes).
///
/// # Accuracy
/// The error is the rounding of the phases Ω t and φ̇ t: about 2e-16 rad per radian of rotation.
///
/// # Source
/// The lecture notes, "Force-free motion of a symmetric top". The product form follows from
/// ω = L/I_t − Ω e.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricTop {
    start: State,
    kind: SymmetricTopKind,
    axis: Direction<Body>,
    axial: f64,
    transverse: f64,
    spin: f64,
    momentum: Direction<Space>,
    body_rate: f64,
    space_rate: f64,
}

/// Shape of a symmetric body, by the ratio of its moments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymmetricTopKind {
    /// Elongated: I_e < I_t, and e is principal axis 1. A rod is the limit.
    Prolate,
    /// Flattened: I_e > I_t, and e is principal axis 3.
    Oblate,
}

impl SymmetricTop {
    /// Returns the motion from a start state; `None` unless exactly two moments are equal.
    pub fn of(principal: &PrincipalFrame<Body>, start: State) -> Option<Self> {
        let [i1, i2, i3] = principal.moments();
        let (kind, axis, axial, transverse) = match principal.symmetry() {
            Symmetry::Oblate => (SymmetricTopKind::Oblate, principal.axis(2), i3, 0.5 * (i1 + i2)),
            Symmetry::Prolate | Symmetry::Rod => {
                (SymmetricTopKind::Prolate, principal.axis(0), i1, 0.5 * (i2 + i3))
            }
            _ => return None,
        };
        let spin = axis.dot(start.omega);
        // L = I_t ω + (I_e − I_t) ω_e e, without reading the tensor again.
        let along: AngularVelocity<Body> = axis.as_quantity() * ((axial - transverse) / transverse * spin);
        let l_over_it = start.omega + along;
        Some(Self {
            start,
            kind,
            axis,
            axial,
            transverse,
            spin,
            momentum: (start.attitude * l_over_it).direction().unwrap_or(Direction::ZERO),
            body_rate: (axial - transverse) / transverse * spin,
            space_rate: l_over_it.norm(),
        })
    }

    /// Returns the symmetric top of a free motion; `None` unless its regime is `Symmetric` (not at
    /// rest, not a permanent rotation).
    pub fn of_motion(motion: &FreeMotion) -> Option<Self> {
        (motion.regime() == Regime::Symmetric).then(|| Self::of(motion.principal(), motion.start())).flatten()
    }

    /// Returns the start state.
    pub const fn start(&self) -> State {
        self.start
    }

    /// Returns the kind of top: prolate or oblate.
    pub const fn kind(&self) -> SymmetricTopKind {
        self.kind
    }

    /// Returns the symmetry axis e, body axes.
    pub const fn axis(&self) -> Direction<Body> {
        self.axis
    }

    /// Returns the moments about the symmetry axis and perpendicular to it, kg·m².
    pub const fn moments(&self) -> [f64; 2] {
        [self.axial, self.transverse]
    }

    /// Returns ω · e, rad/s, which is constant.
    pub const fn spin(&self) -> f64 {
        self.spin
    }

    /// Returns Ω = (I_e − I_t) ω_e / I_t, the rate at which ω circles e in the body, rad/s,
    /// right-handed about e.
    pub const fn body_rate(&self) -> f64 {
        self.body_rate
    }

    /// Returns φ̇ = |L| / I_t, the rate at which e and ω circle L in space, rad/s.
    pub const fn space_rate(&self) -> f64 {
        self.space_rate
    }

    /// Returns the direction of L, fixed in space.
    pub const fn momentum_direction(&self) -> Direction<Space> {
        self.momentum
    }
}
