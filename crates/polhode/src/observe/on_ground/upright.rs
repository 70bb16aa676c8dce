//! Wheels: symmetric bodies with a level axis.

use super::stable_spins::StableSpins;
use crate::motion::contact::Footing;

/// Disk, hoop, torus, or another mirror-symmetric body of revolution with its axis level, which
/// rolls straight or spins about the vertical.
///
/// C is the moment about the axis, A the moment perpendicular to it, and ρ the height of the centre
/// of mass. κ is the radius of curvature of the profile at the contact: zero for a sharp rim, the
/// tube radius for a torus. Let φ be the lean and ψ the heading, with e ≈ (−ψ, 1, φ), L = A
/// e × ė + C s e, r = (0, (ρ − κ) φ, −ρ). For a wheel that rolls straight at the rate ω about its
/// axis, the equations L̇ = r × F, F = m (v̇ − g), v = r × ω are to first order
///
/// (A + m ρ²) φ̈ = (C + m ρ²) ω ψ̇ + m g (ρ − κ) φ,  A ψ̇ = −C ω φ + const
///
/// Therefore it is stable if ω² > A m g (ρ − κ)/(C (C + m ρ²)). If it spins at Ω about the vertical
/// diameter, with the rate s about the axis,
///
/// (A + m ρ²) φ̈ = (m g (ρ − κ) − A Ω² − m ρ κ Ω²) φ + (C + m ρ²) Ω s,
/// (C + m ρ²) ṡ = −m ρ (ρ − κ) Ω φ̇,
///
/// and it is stable if Ω² > m g (ρ − κ)/(A + m ρ²). Without friction the terms with m ρ² are
/// absent: ω² > A m g (ρ − κ)/C², Ω² > m g (ρ − κ)/A.
///
/// Source: for sharp rims E. J. Routh, Dynamics of a System of Rigid Bodies, Advanced Part (1905),
/// art. 241–244; O. M. O'Reilly, Nonlinear Dyn. 10 (1996) 287, sec. 5 and 6. With κ derived here as
/// above.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct UprightWheel {
    /// Mass m, kg.
    pub mass: f64,
    /// Gravitational acceleration g, m/s².
    pub gravity: f64,
    /// Moment of inertia A perpendicular to the axis, kg·m².
    pub across: f64,
    /// Moment of inertia C about the axis, kg·m².
    pub along: f64,
    /// Height ρ of the centre of mass, m.
    pub height: f64,
    /// Radius of curvature κ of the profile at the contact, m.
    pub profile: f64,
    /// Kind of force along the ground.
    pub footing: Footing,
}

impl UprightWheel {
    /// Returns m g (ρ − κ), N·m.
    fn falling(&self) -> f64 {
        self.mass * self.gravity * (self.height - self.profile)
    }

    /// Returns the stable rates of straight rolling; `None` with viscous friction, for which no
    /// closed form is known.
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

    /// Returns the stable rates of spin about the vertical; `None` with viscous friction, for which
    /// no closed form is known.
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
