//! Descriptions of wire suspensions.

use super::super::number::{Linear, Point};
use crate::error::IdentifyError;

/// Straight, massless and inextensible wire.
#[derive(Clone, Debug, PartialEq)]
pub struct Wire {
    /// Upper end along the axes of space, m, from an origin that all wires share.
    pub top: Point,
    /// Lower end in the rig, m.
    pub bottom: Point,
    /// Length, m.
    pub length: Linear,
}

/// Suspension on one, two or three wires.
///
/// The computed motion is periodic and mostly a twist about the vertical. The body also rises,
/// tilts and sways as the wires require; lengths, centre of mass and products of inertia are
/// arbitrary. The equations are
///
/// m p̈ = −W ẑ − Σ λ r,  I Ω̇ + Ω × I Ω = −Σ d × Rᵀ λ r − Rᵀ κ ∇θ,  r = p + R d − a,  |r| = length
///
/// with the centre of mass p, wires from a to d (from the centre), and tensions λ × length. A swing
/// released differently also sways, with other periods. This averages out over many counted swings,
/// and it is visible in the residuals of a log.
///
/// A body on two wires also rolls about the line of their lower ends, like a pendulum. If the
/// centre of mass is exactly on that line, the roll is neutral. It is then locked in the described
/// attitude.
///
/// Two parallel wires of length L at distances r on both sides of the centre have the small-angle
/// period T = 2π √(I L/(W r²)). Sources: T. R. Kane, G.-S. Tseng, Int. J. Mech. Sci. 9 (1967) 83;
/// M. R. Jardin, E. R. Mueller, J. Aircraft 46 (2009) 763.
#[derive(Clone, Debug, PartialEq)]
pub struct Wires {
    /// One, two or three wires.
    pub wires: Vec<Wire>,
    /// Torsional stiffness of the wires, N·m/rad: no torque in the attitude with the rig's axes
    /// equal to those of space.
    pub stiffness: Linear,
}

impl Wires {
    /// Creates a suspension on wires without torsional stiffness.
    pub fn new(wires: Vec<Wire>) -> Self {
        Self { wires, stiffness: Linear::default() }
    }

    /// Creates two wires of equal length, fixed at ± `above` along x and holding the body at ±
    /// `below`, m.
    pub fn bifilar(above: impl Into<Linear>, below: impl Into<Linear>, length: impl Into<Linear>) -> Self {
        Self::around(2, &above.into(), &below.into(), &length.into())
    }

    /// Creates three wires of equal length at 0°, 120° and 240° from x, at distances `above` and
    /// `below` from the middle, m.
    pub fn trifilar(above: impl Into<Linear>, below: impl Into<Linear>, length: impl Into<Linear>) -> Self {
        Self::around(3, &above.into(), &below.into(), &length.into())
    }

    /// Creates one wire with torsional stiffness, N·m/rad, that holds the body at a point of the
    /// rig; length in m.
    pub fn torsion(at: impl Into<Point>, length: impl Into<Linear>, stiffness: impl Into<Linear>) -> Self {
        let wire = Wire { top: Point::default(), bottom: at.into(), length: length.into() };
        Self { wires: vec![wire], stiffness: stiffness.into() }
    }

    fn around(count: u32, above: &Linear, below: &Linear, length: &Linear) -> Self {
        let wire = |k: u32| {
            let angle = core::f64::consts::TAU * f64::from(k) / f64::from(count);
            // The second of two wires is exactly opposite.
            let (y, x) = if count == 2 { (0.0, 1.0 - 2.0 * f64::from(k)) } else { libm::sincos(angle) };
            let at = |radius: &Linear| {
                Point::from([radius.clone().scaled(x), radius.clone().scaled(y), Linear::default()])
            };
            Wire { top: at(above), bottom: at(below), length: length.clone() }
        };
        Self::new((0..count).map(wire).collect())
    }

    pub(super) fn check(&self, count: usize) -> Result<(), IdentifyError> {
        let wires = self.wires.len();
        IdentifyError::require("the number of wires", wires as f64, (1..=3).contains(&wires), "1, 2 or 3")?;
        for wire in &self.wires {
            all_of(wire.top.0.iter().chain(&wire.bottom.0).chain([&wire.length]), count)?;
        }
        all_of([&self.stiffness], count)
    }
}

/// Returns an error unless all are finite combinations of the plan's numbers.
pub(in super::super) fn all_of<'a>(
    all: impl IntoIterator<Item = &'a Linear>,
    count: usize,
) -> Result<(), IdentifyError> {
    let wrong = all.into_iter().filter(|linear| !linear.is_of(count)).count();
    IdentifyError::require(
        "the number of rig quantities that are not finite or refer to another plan",
        wrong as f64,
        wrong == 0,
        "zero",
    )
}
