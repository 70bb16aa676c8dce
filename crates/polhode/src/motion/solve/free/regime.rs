//! Kinds of free motion.

use crate::body::principal::{PrincipalFrame, Symmetry};
use crate::math::frame::Body;
use crate::math::vector::AngularVelocity;

use super::labelled::{Labelled, Mode};

/// Kind of a free motion. D = L²/2T is compared with the intermediate moment i2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Regime {
    /// ω = 0.
    AtRest,
    /// ω lies along a principal axis and stays there.
    Permanent(PermanentAxis),
    /// Two equal moments: ω circles the symmetry axis.
    Symmetric,
    /// D < i2: long-axis mode, L circles axis 1.
    LongAxis,
    /// D > i2: short-axis mode, L circles axis 3.
    ShortAxis,
    /// D = i2: ω approaches the intermediate axis asymptotically.
    Separatrix,
}

/// The principal axis of a permanent rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PermanentAxis {
    /// Axis of the least of three different moments; stable.
    Least,
    /// Axis of the intermediate moment; unstable, every deviation grows.
    Intermediate,
    /// Axis of the greatest moment; stable.
    Greatest,
    /// The symmetry axis of a body with two equal moments.
    Symmetry,
    /// An axis perpendicular to the symmetry axis.
    AcrossSymmetry,
    /// Any axis of a body with three equal moments.
    Any,
}

/// Tolerance for ω along a stable axis, relative to |ω|: the rounding error of a rotated tensor. A
/// deviation within it stays equally small.
const ALONG: f64 = 8.0 * f64::EPSILON;

impl PermanentAxis {
    /// Returns the axis of the permanent rotation; `None` if the rotation is not permanent or ω is
    /// zero.
    ///
    /// ω must lie exactly along the intermediate axis of three different moments. Every deviation
    /// from it grows, so a nearly permanent rotation is not one.
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

    /// Returns a description of the rotation for people.
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

impl Regime {
    /// Determines the regime for moments and ω that are exact inputs.
    pub(super) fn of_exact(labelled: &Labelled) -> Self {
        let ([i1, i2, i3], [w1, w2, w3]) = (labelled.moments, labelled.omega.map(|w| !w.is_zero()));
        match (w1, w2, w3) {
            (false, false, false) => Self::AtRest,
            _ if i1 == i2 && i2 == i3 => Self::Permanent(PermanentAxis::Any),
            // Equal moments have the labels 1 and 2, unless ω lies along an axis; then that axis
            // has the label 3.
            (false, false, true) => Self::Permanent(match () {
                () if i1 == i2 => PermanentAxis::Symmetry,
                () if i2 == i3 || i1 == i3 => PermanentAxis::AcrossSymmetry,
                () if i3 < i1 && i3 < i2 => PermanentAxis::Least,
                () if i3 > i1 && i3 > i2 => PermanentAxis::Greatest,
                () => PermanentAxis::Intermediate,
            }),
            (_, _, false) if i1 == i2 => Self::Permanent(PermanentAxis::AcrossSymmetry),
            _ if i1 == i2 => Self::Symmetric,
            _ => Self::of_mode(labelled),
        }
    }

    /// Determines the regime for a tensor whose axes were computed with rounding. A motion that
    /// differs from a permanent rotation by at most this rounding counts as permanent. A nearly
    /// symmetric body counts as symmetric.
    pub(super) fn of_rounded(
        labelled: &Labelled,
        principal: &PrincipalFrame<Body>,
        omega: AngularVelocity<Body>,
    ) -> Self {
        if omega == AngularVelocity::ZERO {
            return Self::AtRest;
        }
        match PermanentAxis::of(principal, omega) {
            Some(axis) => Self::Permanent(axis),
            None if principal.symmetry() == Symmetry::Asymmetric => Self::of_mode(labelled),
            None => Self::Symmetric,
        }
    }

    fn of_mode(labelled: &Labelled) -> Self {
        match labelled.mode {
            _ if labelled.excess.is_zero() => Self::Separatrix,
            Mode::Short => Self::ShortAxis,
            Mode::Long => Self::LongAxis,
        }
    }

    /// Returns the name used in summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::AtRest => "at_rest",
            Self::Permanent(_) => "permanent",
            Self::Symmetric => "symmetric",
            Self::LongAxis => "long_axis",
            Self::ShortAxis => "short_axis",
            Self::Separatrix => "separatrix",
        }
    }

    /// Returns a description for people.
    pub const fn description(self) -> &'static str {
        match self {
            Self::AtRest => "at rest",
            Self::Permanent(axis) => axis.description(),
            Self::Symmetric => "a symmetric top: ω circles the symmetry axis, both circle L",
            Self::LongAxis => "long-axis mode: L circles axis 1",
            Self::ShortAxis => "short-axis mode: L circles axis 3",
            Self::Separatrix => "the separatrix: ω creeps to the intermediate axis",
        }
    }
}
