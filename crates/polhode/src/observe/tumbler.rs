//! Inverse problem of tumbling: states of rotation from the two periods that light curves and radar
//! measure.

use core::fmt;

use crate::body::error::BodyError;
use crate::body::inertia::InertiaTensor;
use crate::body::principal::PrincipalFrame;
use crate::math::double::Double;
use crate::math::frame::Body;
use crate::math::means::quarter_and_share;
use crate::math::number::PI;
use crate::math::rotation::Attitude;
use crate::math::symmetric3::power_of_two_near;
use crate::math::vector::AngularVelocity;
use crate::motion::model::state::State;
use crate::motion::solve::free::{FreeMotion, Regime};

use super::tumbling::{AxisConvention, TumblingPeriods};

/// State of rotation that has the two given periods of a tumbling body.
///
/// Light curves and radar images give P_φ and P_ψ; a shape gives the principal moments up to a
/// factor. Each mode then has at most one energy E/E0, because the ratio P_ψ/P_φ grows strictly
/// from its smallest value at the permanent rotation to infinity at the separatrix
/// ([`TumblingPeriods::ratio`] gives the smallest value).
///
/// *Proof.* Let |L| = 1 and e = 2T. From the permanent rotation outward, e changes with the sign σ
/// (+1 in short-axis mode, −1 in long-axis mode). In one period P, the axis that L circles advances
/// by e P − σS + 2πσ ([`crate::observe::GeometricPhase`]), where S is the solid angle enclosed by
/// the path of L. Further P = 2σ dS/de, because |L| S is the area in phase space. Therefore
/// 2π d(P_ψ/P_φ)/de = P + e P′ − P/2 = √e d(√e P)/de, and √e P is the period at constant *energy*.
/// This period is 4K(m)/λ. Toward the separatrix K increases, and λ, which at constant T is
/// proportional to √(L² − 2T i1) or √(2T i3 − L²), decreases. ∎
///
/// So there are zero, one or two solutions, at most one in each mode. The periods do not
/// distinguish a state from its mirror images (ω with the sign of any component along the principal
/// axes reversed), and do not determine the direction of L.
///
/// # Accuracy
/// The relative error of the energy ratio is about 10⁻¹⁵ for exact moments and periods, also near
/// the permanent rotations and the separatrix. An exception is the long-axis mode of a needle in
/// the short-axis convention, where only P_ψ/P_φ − 1 ≈ i1/i3 contains information: the error is
/// larger by i3/i1. Near the separatrix, the periods are so sensitive that the rounding of ω
/// changes them; the field `periods` shows this.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::Regime;
/// use polhode::observe::{AxisConvention, TumblerError, TumblingPeriods, TumblingSolution};
/// // Toutatis in days: the periods of Zhao et al. 2015, the moments of Takahashi, Busch & Scheeres 2013
/// let periods = TumblingPeriods { precession: 7.40, rotation: 5.38 };
/// let spins = TumblingSolution::all([3.0836, 3.235, 1.0], periods, AxisConvention::LongAxis)?;
/// assert_eq!(spins.len(), 1);
/// assert_eq!(spins[0].regime, Regime::LongAxis);
/// assert!((spins[0].omega.z.abs().to_degrees() - 98.73).abs() < 0.005); // deg/day, about the long axis
/// # Ok::<(), TumblerError>(())
/// ```
///
/// # Source
/// The problem: Samarasinha & A'Hearn, Icarus 93 (1991) 194; Kaasalainen, Astron. Astrophys. 376
/// (2001) 302. The proof and the search variable are original to this library.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TumblingSolution {
    /// Mode of rotation; `Symmetric` for a body with two equal moments.
    pub regime: Regime,
    /// Energy ratio E/E0 = 2 T i3/L², relative to the least energy for this L: 1 … i3/i1.
    pub energy_ratio: f64,
    /// Angular momentum |L|, kg·m²/s for moments in kg·m² and periods in s.
    pub momentum: f64,
    /// Angular velocity ω, rad/s, body axes, at an instant at which its component along the
    /// intermediate axis is zero. The angle between L and the axis that it circles is then
    /// smallest.
    pub omega: AngularVelocity<Body>,
    /// Periods of the motion that starts with `omega`, in the requested convention; they equal the
    /// requested periods except for the rounding of ω. `None` if the rounded ω does not tumble.
    pub periods: Option<TumblingPeriods>,
}

/// Error of the inverse problem.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum TumblerError {
    /// The moments are not those of a physical body.
    Body(BodyError),
    /// A period is not positive and finite.
    Period {
        /// Name of the period.
        what: &'static str,
        /// Value of the period, s.
        value: f64,
    },
    /// Neither mode has this ratio of periods.
    NoSolution {
        /// Given ratio P_ψ/P_φ.
        ratio: f64,
        /// Range of the ratio in long-axis mode, in the same convention; `None` if the body has no
        /// such mode. The upper end is infinite in theory; the value is at the end of the search,
        /// close to the separatrix.
        long_axis: Option<[f64; 2]>,
        /// Range of the ratio in short-axis mode, in the same convention; `None` if the body has no
        /// such mode.
        short_axis: Option<[f64; 2]>,
    },
}

impl TumblingSolution {
    /// Finds the states of rotation of a body with these principal moments along its x, y and z
    /// axes, in any order, and these periods; in order of ascending energy.
    ///
    /// If the moments are known only up to a factor, everything except `momentum` is correct. For a
    /// symmetric body, L can circle only the symmetry axis. A rod and a body with three equal
    /// moments have no solution.
    ///
    /// # Errors
    /// [`TumblerError`]: moments that are not physical, periods that are not positive and finite,
    /// or a ratio of periods outside the ranges of both modes.
    pub fn all(
        moments: [f64; 3],
        periods: TumblingPeriods,
        convention: AxisConvention,
    ) -> Result<Vec<Self>, TumblerError> {
        for (what, value) in [("P_phi", periods.precession), ("P_psi", periods.rotation)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(TumblerError::Period { what, value });
            }
        }
        let tensor = InertiaTensor::<Body>::diagonal(moments).map_err(TumblerError::Body)?;
        let principal = PrincipalFrame::of(&tensor);
        let unit = power_of_two_near(principal.moments()[2]);
        let [least, middle, greatest] = principal.moments().map(|i| i / unit);
        let short = Family::of([least, middle, greatest], convention);
        let long = Family::of([greatest, middle, least], convention);

        let ratio = periods.ratio();
        let mut solutions = Vec::new();
        for family in [&short, &long].into_iter().flatten() {
            if let Some(wobble) = family.with_ratio(ratio) {
                let [across, along] = if family.circles_least() { [2, 0] } else { [0, 2] };
                let momentum = 2.0 * PI / (periods.precession * wobble.axis_rate);
                let [other, _, circled] = family.moments;
                let omega = principal.axis(across) * (momentum * wobble.sine / other)
                    + principal.axis(along) * (momentum * wobble.cosine / circled);
                let omega = omega.as_quantity();
                let start = State { time: 0.0, attitude: Attitude::identity(), omega };
                let motion = FreeMotion::of_moments(moments, start).ok();
                solutions.push(Self {
                    regime: family.regime(),
                    energy_ratio: family.energy_ratio(&wobble),
                    momentum: momentum * unit,
                    omega,
                    periods: motion.and_then(|motion| TumblingPeriods::of(&motion, convention)),
                });
            }
        }
        if solutions.is_empty() {
            let [long_axis, short_axis] = [long, short].map(|f| f.map(|f| f.range()));
            return Err(TumblerError::NoSolution { ratio, long_axis, short_axis });
        }
        Ok(solutions)
    }
}

/// Motions of a body in which L circles one of the extreme axes.
#[derive(Clone, Copy, Debug)]
struct Family {
    /// Moments; the third belongs to the axis that L circles, the second to the intermediate axis.
    moments: [f64; 3],
    /// Advance of the convention's axis relative to the axis that L circles, turns per period of ω.
    turns: f64,
}

/// One motion of the family, for |L| = 1.
#[derive(Clone, Copy, Debug)]
struct Wobble {
    /// Cosine of the smallest angle between L and the axis that it circles.
    cosine: f64,
    sine: f64,
    /// Rate 2π/P_φ, rad/s.
    axis_rate: f64,
    /// Ratio P_ψ/P_φ.
    ratio: f64,
}

/// Bounds of the search for y = ln z: from a wobble too small to represent, to 1 − m = 10⁻²⁷⁰.
const NEAREST: f64 = -620.0;
const FARTHEST: f64 = 620.0;

impl Family {
    /// Returns the family; `None` if L cannot circle the third axis: it is not the extreme one, or
    /// its moment is zero.
    fn of(moments: [f64; 3], convention: AxisConvention) -> Option<Self> {
        let [_, i2, i3] = moments;
        let family = Self { moments, turns: 0.0 };
        let turns = f64::from(convention.turns_ahead(family.circles_least()));
        (i2 != i3 && i3 > 0.0).then_some(Self { turns, ..family })
    }

    fn circles_least(&self) -> bool {
        self.moments[2] < self.moments[0]
    }

    fn regime(&self) -> Regime {
        let [i1, i2, _] = self.moments;
        match self.circles_least() {
            _ if i1 == i2 => Regime::Symmetric,
            true => Regime::LongAxis,
            false => Regime::ShortAxis,
        }
    }

    /// Returns 2 T i/L² with the largest moment i.
    fn energy_ratio(&self, wobble: &Wobble) -> f64 {
        let [i1, _, i3] = self.moments;
        let greatest = i1.max(i3);
        1.0 + (greatest - i1) / i1 * wobble.sine.powi(2) + (greatest - i3) / i3 * wobble.cosine.powi(2)
    }

    /// Returns the range of P_ψ/P_φ.
    fn range(&self) -> [f64; 2] {
        [NEAREST, FARTHEST].map(|y| self.at(y).ratio)
    }

    /// Returns the motion with a ratio P_ψ/P_φ, by bisection; the ratio increases with y.
    fn with_ratio(&self, ratio: f64) -> Option<Wobble> {
        let [least, most] = self.range();
        if !(least < ratio && ratio <= most) {
            return None;
        }
        let (mut below, mut above) = (NEAREST, FARTHEST);
        for _halving in 0..MOST_HALVINGS {
            let middle = 0.5 * (below + above);
            if self.at(middle).ratio < ratio {
                below = middle;
            } else {
                above = middle;
            }
        }
        Some(self.at(above))
    }

    /// Returns the motion whose largest nutation θ′ satisfies tan² θ′ = z/ρ, with z = eʸ and
    /// ρ = (1/i2 − 1/i3)/(1/i1 − 1/i3).
    ///
    /// Let ν = 1/ρ − 1. The smallest nutation θ and the parameter satisfy tan² θ = z/(1 + νz),
    /// m = νz/(1 + νz) and 1 − m = 1/(1 + νz). Nothing cancels between the permanent rotation (z
    /// → 0) and the separatrix (z → ∞), nor in the limit of a symmetric body (ν → 0).
    ///
    /// The quantities of `motion/solve/free/elements.rs` are
    /// λ = cos θ √((1/i1 − 1/i3)(1/i2 − 1/i3)) and Ω = 1/i2 + ½ (1/i1 − 1/i2) R.
    fn at(&self, y: f64) -> Wobble {
        let [i1, i2, i3] = self.moments;
        let (d21, d31, d32) = (i2 - i1, i3 - i1, i3 - i2);
        let z = libm::exp(y);
        let m1 = 1.0 / (1.0 + d21 * i3 / (d32 * i1) * z);
        let tangent_squared = z * m1;
        let secant = (1.0 + tangent_squared).sqrt();
        let (quarter, share) =
            quarter_and_share(Double::from(m1).sqrt(), Double::from(d31 * i2 / (d32 * i1)));
        let (quarter, share) = (quarter.value(), share.value());
        let lambda = (d31 / i1 * (d32 / i2)).sqrt() / (i3 * secant);
        let rate = 0.5 * PI * lambda / quarter;
        let axis_rate = 1.0 / i2 + 0.5 * d21 / (i1 * i2) * share + self.turns * rate;
        Wobble {
            cosine: 1.0 / secant,
            sine: tangent_squared.sqrt() / secant,
            axis_rate,
            ratio: axis_rate / rate,
        }
    }
}

/// Number of bisections; they reduce the interval of 1240 to 10⁻¹⁶.
const MOST_HALVINGS: usize = 64;

impl fmt::Display for TumblerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Body(error) => error.fmt(f),
            Self::Period { what, value } => write!(f, "{what} = {value} s must be positive and finite"),
            Self::NoSolution { ratio, long_axis, short_axis } => {
                write!(f, "no spin of this body has P_psi/P_phi = {ratio}: ")?;
                for (k, (mode, range)) in [("long", long_axis), ("short", short_axis)].into_iter().enumerate()
                {
                    let separator = if k == 0 { "" } else { "; " };
                    match range {
                        // An upper end that is practically infinite is not printed.
                        Some([least, most]) if *most > 1e6 => {
                            write!(f, "{separator}{mode}-axis mode has more than {least:.6}")?;
                        }
                        Some([least, most]) => {
                            write!(
                                f,
                                "{separator}{mode}-axis mode has more than {least:.6}, at most {most:.1}"
                            )?;
                        }
                        None => write!(f, "{separator}it has no {mode}-axis mode")?,
                    }
                }
                Ok(())
            }
        }
    }
}

impl core::error::Error for TumblerError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Body(error) => Some(error),
            Self::Period { .. } | Self::NoSolution { .. } => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CONVENTIONS: [AxisConvention; 2] = [AxisConvention::LongAxis, AxisConvention::ShortAxis];

    /// Returns both modes of bodies of every shape: bricks, plates, needles, and nearly symmetric
    /// ones.
    fn families() -> Vec<Family> {
        let second = [1e-9, 1e-3, 0.1, 0.3, 0.5, 0.9, 0.999, 1.0 - 1e-9];
        let mut families = Vec::new();
        for b in second {
            for c in second.into_iter().chain([0.0]).filter(|c| *c < b) {
                // Second moments 1 > b > c give moments b + c < 1 + c < 1 + b.
                let [i1, i2, i3] = [b + c, 1.0 + c, 1.0 + b];
                for convention in CONVENTIONS {
                    families.extend(Family::of([i1, i2, i3], convention));
                    families.extend(Family::of([i3, i2, i1], convention));
                }
            }
        }
        assert!(families.len() > 100);
        families
    }

    #[test]
    fn the_ratio_grows_from_the_permanent_rotation_to_the_separatrix() {
        for family in families() {
            let mut last = family.at(NEAREST).ratio;
            for k in 0..=2480 {
                let ratio = family.at(NEAREST + 0.5 * f64::from(k)).ratio;
                assert!(ratio >= last * (1.0 - 8.0 * f64::EPSILON), "{family:?} {k}: {last} then {ratio}");
                last = ratio;
            }
        }
    }

    #[test]
    fn the_ratio_of_the_smallest_wobble_is_elementary() {
        for family in families() {
            let [i1, i2, i3] = family.moments;
            let one = (i1 * i2 / ((i3 - i1) * (i3 - i2))).sqrt();
            let sign = if family.circles_least() { -1.0 } else { 1.0 };
            let expected = one + (sign + family.turns);
            let [least, most] = family.range();
            assert!((least - expected).abs() < 1e-14 * one, "{family:?}: {least} {expected}");
            assert!(most > least + 10.0);
        }
    }

    #[test]
    fn the_search_finds_every_wobble_that_the_ratio_tells() {
        for family in families() {
            for y in [-30.0, -3.0, -0.1, 0.0, 1.0, 10.0, 50.0, 300.0, 600.0] {
                let (truth, nearby) = (family.at(y), family.at(y - 0.01));
                let Some(found) = family.with_ratio(truth.ratio) else {
                    assert_eq!(truth.ratio, family.range()[0], "{family:?} {y}");
                    continue;
                };
                assert!((found.ratio / truth.ratio - 1.0).abs() < 4.0 * f64::EPSILON, "{family:?} {y}");
                let [energy, other, again] =
                    [truth, nearby, found].map(|wobble| family.energy_ratio(&wobble));
                // Effect of the rounding of the ratio on the energy: large for a needle in the
                // short-axis convention.
                let slope = (energy - other).abs() / (truth.ratio - nearby.ratio).max(f64::MIN_POSITIVE);
                let allowed = 1e-14 * energy + slope * 8.0 * f64::EPSILON * truth.ratio;
                assert!((again - energy).abs() < allowed, "{family:?} {y}: {:e} {allowed:e}", again - energy);
            }
        }
    }
}
