//! Suspensions on wires, as they are given.

use super::super::number::{Linear, Point};
use crate::error::IdentifyError;

/// A wire: straight, without mass, of a length that does not change.
#[derive(Clone, Debug, PartialEq)]
pub struct Wire {
    /// Where it is held above, along the axes of space, from any origin that all wires share.
    pub top: Point,
    /// Where it holds the body, in the rig.
    pub bottom: Point,
    /// Its length, m.
    pub length: Linear,
}

/// One, two or three wires.
///
/// The motion is the one that repeats itself and is mostly a twist about the vertical: the body turns, rises, tilts and sways as it has to with wires of
/// unequal lengths, the centre of mass anywhere and any products of inertia. It is solved from the equations
///
/// m p̈ = −W ẑ − Σ λ r,  I Ω̇ + Ω × I Ω = −Σ d × Rᵀ λ r − Rᵀ κ ∇θ,  r = p + R d − a,  |r| = length
///
/// with the centre of mass p, wires from a to d (from the centre), and tensions λ × length. A swing that was let go in another way sways besides, with other
/// periods; counted over many swings that averages out, and in a log it shows in the residuals.
///
/// On two wires the body also rolls about the line of their lower ends, as a pendulum. If the centre of mass is exactly on that line, nothing turns it back:
/// then it is taken as held in the attitude as it was described.
///
/// Two parallel wires of length L at distances r to both sides of the centre have for small angles T = 2π √(I L/(W r²)). Sources: T. R. Kane, G.-S. Tseng, Int. J.
/// Mech. Sci. 9 (1967) 83; M. R. Jardin, E. R. Mueller, J. Aircraft 46 (2009) 763.
#[derive(Clone, Debug, PartialEq)]
pub struct Wires {
    /// All wires.
    pub wires: Vec<Wire>,
    /// What the wires' own twist adds, N·m/rad: no torque in the attitude in which the axes of the rig are those of space.
    pub stiffness: Linear,
}

impl Wires {
    /// Wires, which do not resist twist.
    pub fn new(wires: Vec<Wire>) -> Self {
        Self { wires, stiffness: Linear::default() }
    }

    /// Two wires of one length, held at ± `above` along x, holding at ± `below`, m.
    pub fn bifilar(above: impl Into<Linear>, below: impl Into<Linear>, length: impl Into<Linear>) -> Self {
        Self::around(2, &above.into(), &below.into(), &length.into())
    }

    /// Three wires of one length at 0°, 120° and 240° from x, at distances `above` and `below` from the middle, m.
    pub fn trifilar(above: impl Into<Linear>, below: impl Into<Linear>, length: impl Into<Linear>) -> Self {
        Self::around(3, &above.into(), &below.into(), &length.into())
    }

    /// One wire that resists twist, and holds the body at a point of the rig; its length in m.
    pub fn torsion(at: impl Into<Point>, length: impl Into<Linear>, stiffness: impl Into<Linear>) -> Self {
        let wire = Wire { top: Point::default(), bottom: at.into(), length: length.into() };
        Self { wires: vec![wire], stiffness: stiffness.into() }
    }

    fn around(count: u32, above: &Linear, below: &Linear, length: &Linear) -> Self {
        let wire = |k: u32| {
            let angle = core::f64::consts::TAU * f64::from(k) / f64::from(count);
            // of two wires the second is exactly opposite
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

/// That all are made of numbers of the plan.
pub(in super::super) fn all_of<'a>(
    all: impl IntoIterator<Item = &'a Linear>,
    count: usize,
) -> Result<(), IdentifyError> {
    let wrong = all.into_iter().filter(|linear| !linear.is_of(count)).count();
    IdentifyError::require(
        "how many quantities of a rig are not finite, or made of another plan's numbers",
        wrong as f64,
        wrong == 0,
        "none",
    )
}
