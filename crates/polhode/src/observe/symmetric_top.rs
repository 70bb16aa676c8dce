//! The free symmetric top: two equal moments, two uniform turns.

use crate::body::principal::{PrincipalFrame, Symmetry};
use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::model::state::State;
use crate::motion::solve::free::{FreeMotion, Regime};

/// The free motion of a body with a symmetry axis e.
///
/// In the body ω circles e at the rate Ω = (I_e − I_t) ω_e / I_t; in space ω and e circle L at the rate
/// φ̇ = |L| / I_t. Both are uniform, so the attitude is two turns of linear phase:
///
/// attitude(t) = turn(L̂, φ̇ t) · attitude(0) · turn(e, −Ω t)
///
/// I_e is the moment about e (the notes' i3) and I_t the one across it (their i1 = i2).
///
/// # Accuracy
/// Rounding of the phases Ω t and φ̇ t: about 2e-16 rad per radian turned.
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

/// Which way a symmetric body departs from a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymmetricTopKind {
    /// I_e < I_t: elongated; e is principal axis 1. A rod is the limit.
    Prolate,
    /// I_e > I_t: flattened; e is principal axis 3.
    Oblate,
}

impl SymmetricTop {
    /// The motion that starts from a state; `None` unless exactly two moments are equal.
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
        // L = I_t ω + (I_e − I_t) ω_e e, without reading the tensor again
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

    /// The top of a free motion; `None` unless it moves as one, neither at rest nor in permanent rotation.
    pub fn of_motion(motion: &FreeMotion) -> Option<Self> {
        (motion.regime() == Regime::Symmetric).then(|| Self::of(motion.principal(), motion.start())).flatten()
    }

    /// Where it starts.
    pub const fn start(&self) -> State {
        self.start
    }

    /// Prolate or oblate.
    pub const fn kind(&self) -> SymmetricTopKind {
        self.kind
    }

    /// The symmetry axis e.
    pub const fn axis(&self) -> Direction<Body> {
        self.axis
    }

    /// The moments about the symmetry axis and across it, kg·m².
    pub const fn moments(&self) -> [f64; 2] {
        [self.axial, self.transverse]
    }

    /// ω · e, rad/s: constant.
    pub const fn spin(&self) -> f64 {
        self.spin
    }

    /// Ω = (I_e − I_t) ω_e / I_t: the rate at which ω circles e in the body, rad/s, right-handed about e.
    pub const fn body_rate(&self) -> f64 {
        self.body_rate
    }

    /// φ̇ = |L| / I_t: the rate at which e and ω circle L in space, rad/s.
    pub const fn space_rate(&self) -> f64 {
        self.space_rate
    }

    /// The direction of L, fixed in space.
    pub const fn momentum_direction(&self) -> Direction<Space> {
        self.momentum
    }
}
