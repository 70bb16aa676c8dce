//! The motion of a pendulum in time: swinging, going round, or between the two.
//!
//! With s = sin ½θ, r = θ̇/2ω₀ and k² = s² + r² of the start,
//!
//! - k < 1: sin ½θ = k sn(x|k²), r = k cn, x = x₀ + ω₀t;
//! - k > 1: ½θ = ± am(x|1/k²), r = ± k dn, x = x₀ + ω₀kt;
//! - k = 1: ½θ = ± gd(x), r = ± sech x.
//!
//! 1 − k² = cos²½θ − r² is taken from the start in two words, so that motions next to upside down keep their digits.

use crate::math::complex::Complex;
use crate::math::double::Double;
use crate::math::elliptic::{Amplitude, EllipticParameter, unit};
use crate::math::real::PI;

use super::reach::Drift;
use crate::motion::error::MotionError;

/// A pendulum's angle and rate at any time, θ̈ = −ω₀² sin θ.
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
/// 4·10⁻¹⁶ of the amplitude and of the largest rate, or of the angle itself once it has gone round, against references of 32
/// digits, the same after thousands of periods. Exactly on the separatrix (k = 1, where the least push decides) the
/// hyperbolic functions have one word. Measured by `tests/all/pendulum_motion.rs`.
///
/// Source: Whittaker, Analytical Dynamics, §44; DLMF 22.19(i).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PendulumMotion {
    start: (f64, f64),
    /// ω₀
    frequency: Double,
    /// Whole turns of the start's angle, times 2π.
    turns: Double,
    /// k
    modulus: Double,
    /// x₀, signed as the motion where it goes round.
    phase: Double,
    kind: Kind,
    parameter: EllipticParameter,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// Hanging, or exactly upside down.
    Still,
    Oscillation,
    /// Over the top or, at k = 1, up to it: with the sign of the rate.
    Round {
        sign: f64,
    },
}

impl PendulumMotion {
    /// By ω₀ (rad/s, positive), the angle from straight down (rad) and its rate (rad/s) at time 0.
    ///
    /// # Errors
    /// [`MotionError::Parameter`] for a number that is not finite, or an ω₀ that is not positive.
    pub fn of(frequency: f64, angle: f64, rate: f64) -> Result<Self, MotionError> {
        let finite = "finite, with a square in the range of numbers beside the frequency's";
        if !(frequency > 0.0 && frequency.is_finite()) {
            let rule = "positive and finite";
            return Err(MotionError::Parameter {
                what: "the frequency of small swings",
                value: frequency,
                rule,
            });
        }
        if !(angle.abs() < FARTHEST) {
            return Err(MotionError::Parameter { what: "the angle", value: angle, rule: "below 1e15 rad" });
        }
        if !((0.5 * rate / frequency).abs() < FASTEST) {
            return Err(MotionError::Parameter { what: "the rate", value: rate, rule: finite });
        }
        let whole = (angle / (2.0 * PI)).round();
        let turns = Double::TAU * Double::from(whole);
        let half = unit((Double::from(angle) - turns).scaled(0.5));
        let motion = Self::of_half_angle(Double::from(frequency), half, Double::from(rate));
        // Half of π in two words is not π: the double nearest to it is as near to upside down as an angle can be said.
        let kind = if rate == 0.0 && angle.abs() == PI { Kind::Still } else { motion.kind };
        Ok(Self { start: (angle, rate), turns, kind, ..motion })
    }

    /// By ω₀, cos ½θ ≥ 0 and sin ½θ, and the rate, in two words; angles from −π … π on.
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
            kind: Kind::Still,
            parameter: EllipticParameter::of(Double::ONE, Double::default()),
        };
        if modulus.is_zero() || (c.is_zero() && r.is_zero()) {
            return motion;
        }
        if rest.high > 0.0 {
            motion.kind = Kind::Oscillation;
            motion.parameter = EllipticParameter::of(modulus.square(), rest);
            motion.phase = motion.parameter.first(s / modulus, r / modulus);
        } else {
            let sign = 1.0_f64.copysign(rate.high);
            motion.kind = Kind::Round { sign };
            let k2 = modulus.square();
            motion.parameter = EllipticParameter::of(Double::ONE / k2, -rest / k2);
            motion.phase = motion.parameter.first(s, c).scaled(sign);
        }
        motion
    }

    /// The angle (rad, continuous: it counts the turns) and its rate (rad/s) at a time, s; before the start too.
    ///
    /// Neither is a number beyond [`PendulumMotion::reach`], and at a time that is none.
    pub fn at(&self, time: f64) -> (f64, f64) {
        if time == 0.0 {
            return self.start;
        }
        if !(time.abs() <= self.reach()) {
            return (f64::NAN, f64::NAN);
        }
        match self.kind {
            Kind::Still => self.start,
            Kind::Oscillation => {
                let at = self.amplitude(time);
                // ½θ from its sine k sn and cosine dn
                let half = libm::atan2((self.modulus * at.sn).value(), at.dn.value());
                let angle = (self.turns + Double::from(2.0 * at.sign() * half)).value();
                (angle, at.sign() * (self.fastest() * at.cn).value())
            }
            Kind::Round { sign } => {
                let at = self.amplitude(time);
                let angle = (self.turns + at.angle().scaled(2.0 * sign)).value();
                (angle, sign * (self.fastest() * at.dn).value())
            }
        }
    }

    /// cos ½θ + i sin ½θ, of either sign, and the rate, after a time; `None` if it stands still.
    pub(crate) fn half_angle(&self, time: Double) -> Option<(Complex<Double>, f64)> {
        let at = self.amplitude_after(time);
        let sign = at.sign();
        match self.kind {
            Kind::Still => None,
            Kind::Oscillation => {
                let half = Complex { re: at.dn, im: (self.modulus * at.sn).scaled(sign) };
                Some((half, sign * (self.fastest() * at.cn).value()))
            }
            Kind::Round { sign } => {
                let half = Complex { re: at.cn, im: at.sn.scaled(sign) };
                Some((half, sign * (self.fastest() * at.dn).value()))
            }
        }
    }

    fn amplitude(&self, time: f64) -> Amplitude {
        self.amplitude_after(Double::from(time))
    }

    fn amplitude_after(&self, time: Double) -> Amplitude {
        let elapsed = self.frequency * time;
        let round = matches!(self.kind, Kind::Round { .. });
        let elapsed = if round { self.modulus * elapsed } else { elapsed };
        self.parameter.amplitude(self.phase + elapsed)
    }

    /// For how long before and after its start the motion is known, s, to 1e-6 rad for inputs that are exact: some 10²⁴ turns, and less
    /// next to the separatrix. Whether it is on the separatrix two words decide.
    pub fn reach(&self) -> f64 {
        let round = matches!(self.kind, Kind::Round { .. });
        let rate = (if round { self.modulus * self.frequency } else { self.frequency }).value();
        let half_period = self.parameter.quarter().value() / rate;
        if self.kind == Kind::Still || !half_period.is_finite() {
            return f64::MAX;
        }
        // K ≈ ½ ln(16/(1 − m)), and 1 − m is a difference of squares near 1
        let uncertain = (TWO_WORDS / self.parameter.complement()).max(TWO_WORDS);
        Drift(uncertain / half_period).reach().max(half_period)
    }

    /// 2ω₀k
    fn fastest(&self) -> Double {
        self.frequency.scaled(2.0) * self.modulus
    }

    /// The period of an oscillation, or the time of one turn, s; `None` for a pendulum that stands still or never returns.
    pub fn period(&self) -> Option<f64> {
        let (quarters, rate) = match self.kind {
            Kind::Still => return None,
            Kind::Oscillation => (4.0, Double::ONE),
            Kind::Round { .. } => (2.0, self.modulus),
        };
        let period = self.parameter.quarter().scaled(quarters) / (rate * self.frequency);
        Some(period.value()).filter(|period| period.is_finite())
    }
}

/// Beyond it an angle's rounding is as large as a radian.
const FARTHEST: f64 = 1e15;

/// Of half a turn, relative: 2⁻¹⁰⁰.
const TWO_WORDS: f64 = 1e-30;

/// k² and 1/k² stay in the range where products keep both words.
const FASTEST: f64 = 1e140;
