//! Tippe tops: symmetric balls with an off-centre centre of mass, and their motion under sliding
//! friction.

use super::{ROUNDING_OF_SIZE, level, moments};
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::math::root::root;
use crate::math::vector::Direction;
use crate::motion::contact::{Contact, SurfaceShape};

/// Symmetric ball whose centre of mass is on its axis, at the distance α R from its centre.
///
/// Any friction at the point of contact conserves Jellett's constant J = −L · r, and dissipates
/// energy while the point slips. Without slip, with ζ = n − α e = −r/R, the ball rotates at
/// ω = J ζ/(R D) with its centre of mass at rest. Of all motions with this J at this tilt, this has
/// the least energy,
///
/// W(u) = J²/(2 R² D(u)) + m g R (1 − α u),  D = A (1 − u²) + C (u − α)²,  u = cos θ = e · n
///
/// where the axis e points from the centre of the ball away from the centre of mass, so that the
/// centre of mass is lowest for u = 1. Friction leads to the minima of W. With R² D² W′ = P(u) = J²
/// ((A − C) u + C α) − m g R³ α D², the bottom position is a minimum if P(1) < 0, the inverted
/// position if P(−1) > 0, and a tilt if P rises through zero there. With the spin ω = J/(R C
/// (1 ∓ α)):
///
/// bottom: (A − C (1 − α)) ω² < m g R α (1 − α)²,  inverted: (C (1 + α) − A) ω² > m g R α (1 + α)².
///
/// Source: S. Ebenfeld, F. Scheck, Ann. Phys. 243 (1995) 195; S. Rauch-Wojciechowski, M. Sköldstam,
/// T. Glad, Regul. Chaotic Dyn. 10 (2005) 333; the numbering of the groups follows T. Ueda, K.
/// Sasaki, S. Watanabe, SIAM J. Appl. Dyn. Syst. 4 (2005) 1159.
///
/// ```
/// use polhode::observe::{Place, TippeTop};
/// let top = TippeTop { mass: 0.006, gravity: 9.81, radius: 0.015, eccentricity: 0.2, across: 5.0e-7, along: 5.3e-7 };
/// assert_eq!(top.group(), 2);
/// let fast = top.jellett_of_bottom(100.0).max(top.inverted_from().unwrap() * 1.01);
/// assert!(top.minima(fast).iter().any(|end| end.place == Place::Inverted));
/// assert_eq!(top.minima(0.0)[0].place, Place::Bottom);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TippeTop {
    /// Mass m, kg.
    pub mass: f64,
    /// Gravitational acceleration g, m/s².
    pub gravity: f64,
    /// Radius R, m.
    pub radius: f64,
    /// Eccentricity α, between 0 and 1.
    pub eccentricity: f64,
    /// Moment of inertia A perpendicular to the axis, about the centre of mass, kg·m².
    pub across: f64,
    /// Moment of inertia C about the axis, kg·m².
    pub along: f64,
}

/// Position of a tippe top's axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Vertical, with the centre of mass lowest.
    Bottom,
    /// Tilted, between the two vertical positions.
    Tilted,
    /// Vertical, with the centre of mass highest.
    Inverted,
}

impl Place {
    /// Returns its name in JSON.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bottom => "bottom",
            Self::Tilted => "tilted",
            Self::Inverted => "inverted",
        }
    }
}

/// Motion about the vertical without slip.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct EndState {
    /// Position of the axis.
    pub place: Place,
    /// cos θ, with the angle θ between the axis and the upward vertical; 1 if the centre of mass is
    /// lowest.
    pub cosine: f64,
    /// Energy, J; the potential energy is zero if the centre of mass is at ground level.
    pub energy: f64,
    /// True if the energy is a minimum for its J: friction leads there and keeps it.
    pub is_minimum: bool,
}

impl TippeTop {
    /// Returns the tippe top that a symmetric ball with an off-centre centre of mass is on level
    /// ground, and its axis e.
    pub fn of(body: &MassProperties<Body>, contact: &Contact) -> Option<(Self, Direction<Body>)> {
        let SurfaceShape::Sphere { radius } = *contact.surface.shape() else { return None };
        let (gravity, axis) = (level(contact)?, contact.symmetry_axis(body)?);
        let eccentricity = (contact.surface.center() - body.center_of_mass()).norm() / radius;
        let [across, along] = moments(body, axis);
        let top = Self { mass: body.mass(), gravity, radius, eccentricity, across, along };
        (eccentricity > ROUNDING_OF_SIZE && eccentricity < 1.0).then_some((top, axis))
    }

    /// Returns the group. 1: A < C (1 − α), the bottom position is stable at any spin. 3: A > C
    /// (1 + α), the inverted position is never stable. 2: in between, the top inverts if it spins
    /// fast enough.
    pub fn group(&self) -> u8 {
        if self.across < self.along * (1.0 - self.eccentricity) {
            1
        } else if self.across < self.along * (1.0 + self.eccentricity) {
            2
        } else {
            3
        }
    }

    /// Returns the J above which the bottom position is not a minimum, kg·m³/s; `None` if it always
    /// is.
    pub fn bottom_up_to(&self) -> Option<f64> {
        let less = 1.0 - self.eccentricity;
        let left = self.across - self.along * less;
        (left > 0.0).then(|| self.radius * self.along * less * less * (self.lever() / left).sqrt())
    }

    /// Returns the J above which the inverted position is a minimum, kg·m³/s; `None` if it never
    /// is.
    pub fn inverted_from(&self) -> Option<f64> {
        let more = 1.0 + self.eccentricity;
        let left = self.along * more - self.across;
        (left > 0.0).then(|| self.radius * self.along * more * more * (self.lever() / left).sqrt())
    }

    /// Returns J for a spin, rad/s, about the vertical axis with the centre of mass lowest,
    /// kg·m³/s.
    pub fn jellett_of_bottom(&self, spin: f64) -> f64 {
        self.radius * self.along * (1.0 - self.eccentricity) * spin
    }

    /// Returns J for a spin, rad/s, about the vertical axis with the centre of mass highest,
    /// kg·m³/s.
    pub fn jellett_of_inverted(&self, spin: f64) -> f64 {
        self.radius * self.along * (1.0 + self.eccentricity) * spin
    }

    /// Returns W(u), the least energy for this J at the cosine u, J.
    pub fn least_energy(&self, jellett: f64, cosine: f64) -> f64 {
        let lambda = jellett / self.radius;
        0.5 * lambda * lambda / self.moment(cosine)
            + self.mass * self.gravity * self.radius * (1.0 - self.eccentricity * cosine)
    }

    /// Returns the motions without slip with this J that are extrema of the energy, from the bottom
    /// to the inverted position.
    pub fn all(&self, jellett: f64) -> Vec<EndState> {
        let slope = |u: f64| self.slope(jellett, u);
        let state = |place, cosine, is_minimum| EndState {
            place,
            cosine,
            energy: self.least_energy(jellett, cosine),
            is_minimum,
        };
        let mut all = vec![state(Place::Bottom, 1.0, slope(1.0) < 0.0)];
        let roots = self.tilts(jellett);
        // The signs of the slope on both sides of each root.
        for (k, &u) in roots.iter().enumerate().rev() {
            let before = if k == 0 { -1.0 } else { roots[k - 1] };
            let after = roots.get(k + 1).copied().unwrap_or(1.0);
            let rises = slope(0.5 * (before + u)) < 0.0 && slope(0.5 * (u + after)) > 0.0;
            all.push(state(Place::Tilted, u, rises));
        }
        all.push(state(Place::Inverted, -1.0, slope(-1.0) > 0.0));
        all
    }

    /// Returns the motions of least energy, to which sliding friction leads.
    pub fn minima(&self, jellett: f64) -> Vec<EndState> {
        self.all(jellett).into_iter().filter(|state| state.is_minimum).collect()
    }

    /// Returns the spin about the vertical for this J without slip, at the cosine u, rad/s.
    pub fn spin(&self, jellett: f64, cosine: f64) -> f64 {
        jellett * (1.0 - self.eccentricity * cosine) / (self.radius * self.moment(cosine))
    }

    /// Returns Routh's constant of rolling, ω_e √(A C + m r · I r), kg·m²·rad/s, for the rate about
    /// the axis and the cosine of its tilt.
    pub fn routh(&self, spin: f64, cosine: f64) -> f64 {
        let square = self.mass * self.radius * self.radius * self.moment(cosine);
        spin * (self.across * self.along + square).sqrt()
    }

    /// Returns ω = J ζ/(R D) at a tilt, rad/s: its component along e, and the one perpendicular to
    /// e in the plane of e and n.
    pub(super) fn omega(&self, jellett: f64, u: f64) -> [f64; 2] {
        let rate = jellett / (self.radius * self.moment(u));
        [rate * (u - self.eccentricity), rate * ((1.0 - u) * (1.0 + u)).max(0.0).sqrt()]
    }

    /// Returns m g R α.
    fn lever(&self) -> f64 {
        self.mass * self.gravity * self.radius * self.eccentricity
    }

    /// Returns D, kg·m².
    fn moment(&self, u: f64) -> f64 {
        let from = u - self.eccentricity;
        self.across * (1.0 - u) * (1.0 + u) + self.along * from * from
    }

    /// Returns P/R².
    fn slope(&self, jellett: f64, u: f64) -> f64 {
        let (lambda, moment) = (jellett / self.radius, self.moment(u));
        let turned = (self.across - self.along) * u + self.along * self.eccentricity;
        lambda * lambda * turned - self.lever() * moment * moment
    }

    /// Returns the zeros of P between −1 and 1, in ascending order, bracketed by the zeros of its
    /// derivatives.
    fn tilts(&self, jellett: f64) -> Vec<f64> {
        let lambda = jellett / self.radius;
        let (a, c, alpha) = (self.across, self.along, self.eccentricity);
        // D = d₀ + d₁ u + d₂ u².
        let (d0, d1, d2) = (a + c * alpha * alpha, -2.0 * c * alpha, c - a);
        let k = self.lever();
        let polynomial = [
            lambda * lambda * c * alpha - k * d0 * d0,
            lambda * lambda * (a - c) - k * 2.0 * d0 * d1,
            -k * (d1 * d1 + 2.0 * d0 * d2),
            -k * 2.0 * d1 * d2,
            -k * d2 * d2,
        ];
        roots_within(&polynomial)
    }
}

/// Returns the zeros of a polynomial between −1 and 1 at which it changes its sign.
fn roots_within(polynomial: &[f64]) -> Vec<f64> {
    if polynomial.len() < 2 {
        return Vec::new();
    }
    let value = |x: f64| polynomial.iter().rev().fold(0.0, |sum, a| sum * x + a);
    let derivative: Vec<f64> =
        polynomial.iter().enumerate().skip(1).map(|(power, a)| power as f64 * a).collect();
    let mut bounds = vec![-1.0];
    bounds.extend(roots_within(&derivative));
    bounds.push(1.0);
    let between = |pair: &[f64]| {
        let values = [value(pair[0]), value(pair[1])];
        (values[0] * values[1] < 0.0).then(|| root(value, [pair[0], pair[1]], values))
    };
    bounds.windows(2).filter_map(between).collect()
}
