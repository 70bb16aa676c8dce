//! Motion of a pendulum: oscillation, rotation, or the separatrix between the two.
//!
//! Let s = sin ½θ and r = θ̇/2ω₀, and let k² = s² + r² at the start. Then
//!
//! - k < 1: sin ½θ = k sn(x|k²), r = k cn, x = x₀ + ω₀t;
//! - k > 1: ½θ = ± am(x|1/k²), r = ± k dn, x = x₀ + ω₀kt;
//! - k = 1: ½θ = ± gd(x), r = ± sech x.
//!
//! 1 − k² = cos²½θ − r² is computed from the start in two words. Motions close to the upright
//! position therefore keep their precision.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elliptic::{EllipticParameter, unit};
use crate::math::number::{PI, Splat, sin_cos};

use super::phase::{Angle, Elapsed};
use super::reach::Drift;
use super::theta::Lattice;
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Angle and rate of a pendulum at any time, θ̈ = −ω₀² sin θ.
///
/// ```
/// use polhode::motion::PendulumMotion;
/// // ω₀ = 2 rad/s, let go at 90°: after a quarter of its period it hangs, at its fastest.
/// let motion = PendulumMotion::of(2.0, std::f64::consts::FRAC_PI_2, 0.0)?;
/// let quarter = motion.period().unwrap() / 4.0;
/// let (angle, rate) = motion.at(quarter);
/// assert!(angle.abs() < 1e-15 && (rate + 2.0 * 2.0_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
///
/// # Accuracy
/// 4·10⁻¹⁶ against references of 32 digits, unchanged after thousands of periods. The error is
/// relative to the amplitude and to the largest rate; after a full turn, relative to the angle
/// itself. Exactly on the separatrix (k = 1) the hyperbolic functions have one word. Measured by
/// `tests/all/pendulum_motion.rs`.
///
/// Source: Whittaker, Analytical Dynamics, §44; DLMF 22.19(i).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PendulumMotion {
    start: (f64, f64),
    /// ω₀, rad/s.
    frequency: Double,
    /// Whole turns of the start's angle, rad (a multiple of 2π).
    turns: Double,
    /// Modulus k.
    modulus: Double,
    /// x₀. For a rotation it has the sign of the rate.
    phase: Double,
    kind: PendulumRegime,
    parameter: EllipticParameter,
    /// Theta functions; `None` at rest and on the separatrix.
    kernel: Option<Kernel>,
}

/// Constants of the evaluation: sn, cn and dn as quotients of theta functions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Kernel {
    lattice: Lattice,
    /// z = πx/2K.
    angle: Angle,
    /// Factors that turn the theta functions into cos ½θ and sin ½θ, both times θ₄.
    half: [f64; 2],
    /// Factor that turns the theta function into the rate, rad/s, times θ₄.
    rate: f64,
    is_round: bool,
}

impl Kernel {
    fn of(motion: &PendulumMotion) -> Self {
        let lattice = Lattice::of(&motion.parameter);
        let [sn, cn, dn] = lattice.quotients();
        let (k, fastest) = (motion.modulus.value(), motion.fastest().value());
        let (half, rate) = match motion.kind {
            PendulumRegime::Round { sign } => ([cn, sign * sn], sign * fastest * dn),
            _ => ([dn, k * sn], fastest * cn),
        };
        let quarter = motion.parameter.quarter();
        let angle = Angle::of(motion.argument_rate() / quarter, motion.phase / quarter);
        Self { lattice, angle, half, rate, is_round: matches!(motion.kind, PendulumRegime::Round { .. }) }
    }

    /// Returns cos ½θ + i sin ½θ and the rate after a time.
    #[inline(always)]
    pub(super) fn at<T: Splat>(&self, elapsed: &Elapsed<T>) -> (Complex<T>, T) {
        let phase = if elapsed.is_within(T::splat(self.angle.reach)) {
            self.angle.at::<T, false>(elapsed)
        } else {
            self.angle.at::<T, true>(elapsed)
        };
        let place = self.lattice.place(phase);
        let [sn, cn, dn] = self.lattice.numerators(&place);
        let (re, im, rate) = if self.is_round { (cn, sn, dn) } else { (dn, sn, cn) };
        let half = Complex { re: T::splat(self.half[0]) * re, im: T::splat(self.half[1]) * im };
        // The sum of their squares is θ₄².
        let scale = half.norm_squared().map(|square| 1.0 / square.sqrt());
        (half.scaled(scale), T::splat(self.rate) * rate * scale)
    }

    /// Returns ½θ of a rotating pendulum, rad, with an error below half a turn. Returns 0 for an
    /// oscillation.
    fn round(&self, time: f64) -> f64 {
        if self.is_round { self.half[1].signum() * self.angle.about(time) } else { 0.0 }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum PendulumRegime {
    /// Equilibrium, hanging or exactly upright.
    Still,
    Oscillation,
    /// Rotation over the top or, at k = 1, asymptotic to it. `sign`: sign of the rate.
    Round {
        sign: f64,
    },
}

impl PendulumMotion {
    /// Returns the motion for ω₀ (rad/s, positive), the angle from straight down (rad) and its rate
    /// (rad/s) at time 0.
    ///
    /// # Errors
    /// A parameter error ([`MotionError::is_parameter`]) for a number that is not finite or too
    /// large, or an ω₀ that is not positive.
    pub fn of(frequency: f64, angle: f64, rate: f64) -> Result<Self, MotionError> {
        require::positive("the frequency of small swings", frequency)?;
        require::that("the angle", angle, angle.abs() < FARTHEST, "below 1e15 rad")?;
        let rule = "finite, and its square must be comparable with that of the frequency";
        require::that("the rate", rate, (0.5 * rate / frequency).abs() < FASTEST, rule)?;
        let whole = (angle / (2.0 * PI)).round();
        let turns = Double::TAU * Double::from(whole);
        let half = unit((Double::from(angle) - turns).scaled(0.5));
        let motion = Self::of_half_angle(Double::from(frequency), half, Double::from(rate));
        // π in f64 is not exactly π. An angle of exactly f64 π at rest is therefore defined as
        // upright, because no f64 is closer to it.
        if rate == 0.0 && angle.abs() == PI {
            return Ok(Self {
                start: (angle, rate),
                turns,
                kind: PendulumRegime::Still,
                kernel: None,
                ..motion
            });
        }
        Ok(Self { start: (angle, rate), turns, ..motion })
    }

    /// Returns the motion for ω₀, cos ½θ ≥ 0 and sin ½θ, and the rate, in two words. The angle
    /// starts between −π and π.
    pub(crate) fn of_half_angle(frequency: Double, half: Complex<Double>, rate: Double) -> Self {
        let (s, c) = (half.im, half.re);
        let r = rate / frequency.scaled(2.0);
        let modulus = (s.square() + r.square()).sqrt();
        let rest = (c - r.abs()) * (c + r.abs());
        let mut motion = Self {
            start: (2.0 * libm::atan2(s.value(), c.value()), rate.value()),
            frequency,
            turns: Double::default(),
            modulus,
            phase: Double::default(),
            kind: PendulumRegime::Still,
            parameter: EllipticParameter::of(Double::ONE, Double::default()),
            kernel: None,
        };
        if modulus.is_zero() || (c.is_zero() && r.is_zero()) {
            return motion;
        }
        if rest.high > 0.0 {
            motion.kind = PendulumRegime::Oscillation;
            motion.parameter = EllipticParameter::of(modulus.square(), rest);
            motion.phase = motion.parameter.first(s / modulus, r / modulus);
        } else {
            let sign = 1.0_f64.copysign(rate.high);
            motion.kind = PendulumRegime::Round { sign };
            let k2 = modulus.square();
            motion.parameter = EllipticParameter::of(Double::ONE / k2, -rest / k2);
            motion.phase = motion.parameter.first(s, c).scaled(sign);
        }
        let moves = motion.parameter.complement() > 0.0;
        motion.kernel = moves.then(|| Kernel::of(&motion));
        motion
    }

    /// Returns the angle (rad, continuous: it includes whole turns) and its rate (rad/s) at a time,
    /// s, which may be before the start.
    ///
    /// Both are NaN beyond [`PendulumMotion::reach`] and for a time that is NaN.
    pub fn at(&self, time: f64) -> (f64, f64) {
        if time == 0.0 {
            return self.start;
        }
        if !(time.abs() <= self.reach()) {
            return (f64::NAN, f64::NAN);
        }
        if self.is_still() {
            return self.start;
        }
        let elapsed = Elapsed::since::<true>(0.0, time, 1.0);
        let (half, rate) = self.half_angle(&elapsed);
        let half = libm::atan2(half.im, half.re);
        // Number of whole turns of ½θ: am(x) differs from z by less than half a turn.
        let about = self.kernel.as_ref().map_or(0.0, |kernel| kernel.round(time));
        let turns = ((about - half) / (2.0 * PI)).round();
        let angle = self.turns + Double::from(2.0 * half) + (Double::TAU * Double::from(turns)).scaled(2.0);
        (angle.value(), rate)
    }

    /// Returns cos ½θ + i sin ½θ and the rate, after a time.
    pub(super) fn half_angle(&self, elapsed: &Elapsed<f64>) -> (Complex<f64>, f64) {
        match (&self.kernel, self.kind) {
            (Some(kernel), _) => kernel.at(elapsed),
            // On the separatrix ½θ = ± gd x,  θ̇ = ± 2ω₀ sech x
            (None, PendulumRegime::Round { sign }) => {
                let x = self.phase + self.argument_rate() * elapsed.double();
                let decay = libm::exp(-x.value().abs());
                let sech = 2.0 * decay / (1.0 + decay * decay);
                let half = Complex { re: sech, im: sign * libm::tanh(x.value()) };
                (half, sign * self.fastest().value() * sech)
            }
            (None, _) => {
                let (im, re) = sin_cos(0.5 * self.start.0);
                (Complex { re, im }, 0.0)
            }
        }
    }

    /// Returns true if the pendulum is at rest, hanging or exactly upright.
    pub(super) fn is_still(&self) -> bool {
        self.kind == PendulumRegime::Still
    }

    /// Returns the theta functions; `None` at rest and on the separatrix.
    pub(super) const fn kernel(&self) -> Option<&Kernel> {
        self.kernel.as_ref()
    }

    /// Returns the rate of the argument x = x₀ + rate · t, rad/s.
    fn argument_rate(&self) -> Double {
        let is_round = matches!(self.kind, PendulumRegime::Round { .. });
        if is_round { self.modulus * self.frequency } else { self.frequency }
    }

    /// Returns the time before and after the start for which the angle is accurate to 1e-6 rad, for
    /// exact inputs, s.
    ///
    /// It is some 10²⁴ turns, and less near the separatrix. The test for the separatrix itself uses
    /// two words.
    pub fn reach(&self) -> f64 {
        let half_period = self.parameter.quarter().value() / self.argument_rate().value();
        if self.kind == PendulumRegime::Still || !half_period.is_finite() {
            return f64::MAX;
        }
        // K ≈ ½ ln(16/(1 − m)), and 1 − m is a difference of squares near 1
        let uncertain = (TWO_WORDS / self.parameter.complement()).max(TWO_WORDS);
        Drift(uncertain / half_period).reach().max(half_period)
    }

    /// Returns the largest rate 2ω₀k, rad/s.
    fn fastest(&self) -> Double {
        self.frequency.scaled(2.0) * self.modulus
    }

    /// Returns the period of an oscillation, or the time of one turn of a rotation, s; `None` at
    /// rest and on the separatrix.
    pub fn period(&self) -> Option<f64> {
        let (quarters, rate) = match self.kind {
            PendulumRegime::Still => return None,
            PendulumRegime::Oscillation => (4.0, Double::ONE),
            PendulumRegime::Round { .. } => (2.0, self.modulus),
        };
        let period = self.parameter.quarter().scaled(quarters) / (rate * self.frequency);
        Some(period.value()).filter(|period| period.is_finite())
    }
}

/// Bound on the start's angle, rad. Beyond it, f64 rounding of the angle is of order 1 rad.
const FARTHEST: f64 = 1e15;

/// Relative uncertainty of half a period: 2⁻¹⁰⁰.
const TWO_WORDS: f64 = 1e-30;

/// Bound on θ̇/2ω₀. Within it, products of k² and 1/k² keep both words.
const FASTEST: f64 = 1e140;
