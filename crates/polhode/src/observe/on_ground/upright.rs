//! Wheels: symmetric bodies whose axis is level.

use super::stable_spins::StableSpins;
use crate::motion::contact::Footing;

/// A disk, a hoop, a torus, or another symmetric body that is its own mirror image, with its axis level: it rolls straight, or spins about the vertical.
///
/// C is the moment about the axis and A that across it, ρ the height of the centre of mass, κ the radius of curvature of the profile where it touches: zero of a sharp
/// rim, the tube's of a torus. With the lean φ and the heading ψ, and e ≈ (−ψ, 1, φ), L = A e × ė + C s e, r = (0, (ρ − κ) φ, −ρ), the equations
/// L̇ = r × F, F = m (v̇ − g), v = r × ω of a wheel that rolls straight at ω about its axis are to first order
///
/// (A + m ρ²) φ̈ = (C + m ρ²) ω ψ̇ + m g (ρ − κ) φ,  A ψ̇ = −C ω φ + const
///
/// so that it is stable where ω² > A m g (ρ − κ)/(C (C + m ρ²)), and where it spins at Ω about the vertical diameter, with the rate s about the axis,
///
/// (A + m ρ²) φ̈ = (m g (ρ − κ) − A Ω² − m ρ κ Ω²) φ + (C + m ρ²) Ω s,  (C + m ρ²) ṡ = −m ρ (ρ − κ) Ω φ̇
///
/// where Ω² > m g (ρ − κ)/(A + m ρ²). Without friction the terms with m ρ² are absent: ω² > A m g (ρ − κ)/C², Ω² > m g (ρ − κ)/A.
///
/// Source: for sharp rims E. J. Routh, Dynamics of a System of Rigid Bodies, Advanced Part (1905), art. 241–244; O. M. O'Reilly, Nonlinear Dyn. 10
/// (1996) 287, sec. 5 and 6. With κ derived here as above.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct UprightWheel {
    /// m, kg
    pub mass: f64,
    /// g, m/s²
    pub gravity: f64,
    /// A, kg·m²
    pub across: f64,
    /// C, kg·m²
    pub along: f64,
    /// ρ, m
    pub height: f64,
    /// κ, m
    pub profile: f64,
    /// What acts along the ground.
    pub footing: Footing,
}

impl UprightWheel {
    /// m g (ρ − κ)
    fn falling(&self) -> f64 {
        self.mass * self.gravity * (self.height - self.profile)
    }

    /// Rates of rolling straight; not known here with viscous friction.
    pub fn rolling(&self) -> Option<StableSpins> {
        let (a, c, falling) = (self.across, self.along, self.falling());
        match self.footing {
            Footing::Rolling => {
                let held = c * (c + self.mass * self.height * self.height);
                Some(StableSpins::where_exceeds(held, a * falling, "ω² > A m g (ρ − κ)/(C (C + m ρ²))"))
            }
            Footing::Frictionless => {
                Some(StableSpins::where_exceeds(c * c, a * falling, "ω² > A m g (ρ − κ)/C²"))
            }
            Footing::Viscous => None,
        }
    }

    /// Rates of spinning about the vertical; not known here with viscous friction.
    pub fn spinning(&self) -> Option<StableSpins> {
        let (a, falling) = (self.across, self.falling());
        match self.footing {
            Footing::Rolling => {
                let about_contact = a + self.mass * self.height * self.height;
                Some(StableSpins::where_exceeds(about_contact, falling, "ω² > m g (ρ − κ)/(A + m ρ²)"))
            }
            Footing::Frictionless => Some(StableSpins::where_exceeds(a, falling, "ω² > m g (ρ − κ)/A")),
            Footing::Viscous => None,
        }
    }
}
