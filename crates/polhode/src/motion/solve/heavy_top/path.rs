//! Kinds of motion of a heavy symmetric top, by the path of its axis.

use crate::math::double::Double;
use crate::math::number::PI;
use crate::math::triple::Triple;

use super::constants::Constants;
use super::nutation::Nutation;

/// Kind of motion of the axis of a heavy symmetric top.
///
/// Tolerances for equality: 10⁻⁹ rad for angles, 10⁻⁹ relative for rates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TopPath {
    /// The axis stays upright.
    Sleeping {
        /// True if the spin is above the sleeping-top threshold, so that a small disturbance stays
        /// small.
        stable: bool,
    },
    /// The axis stays straight down.
    Hanging,
    /// Pendulum in one vertical plane: no angular momentum about the vertical or the axis.
    Planar,
    /// Steady precession at a constant angle, the slower of the two.
    SteadySlow,
    /// Steady precession at a constant angle, the faster of the two.
    SteadyFast,
    /// Steady precession without spin (conical pendulum).
    Conical,
    /// The axis approaches the vertical asymptotically.
    Separatrix,
    /// The axis passes through the vertical, above or below the pivot.
    ThroughVertical,
    /// Precession stops at the highest points, where the path has cusps.
    Cusps,
    /// Precession reverses around the highest points, where the path has loops.
    Loops,
    /// Precession never reverses; the path is a wave.
    Waves,
}

impl TopPath {
    /// Returns the name used in summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sleeping { .. } => "sleeping",
            Self::Hanging => "hanging",
            Self::Planar => "planar",
            Self::SteadySlow => "steady_slow",
            Self::SteadyFast => "steady_fast",
            Self::Conical => "conical",
            Self::Separatrix => "separatrix",
            Self::ThroughVertical => "through_vertical",
            Self::Cusps => "cusps",
            Self::Loops => "loops",
            Self::Waves => "waves",
        }
    }

    /// Returns a description for people.
    pub const fn description(self) -> &'static str {
        match self {
            Self::Sleeping { stable: true } => "asleep: upright, and fast enough to stay so",
            Self::Sleeping { stable: false } => "upright, but too slow to stay so after a push",
            Self::Hanging => "hanging straight down",
            Self::Planar => "a pendulum in one vertical plane",
            Self::SteadySlow => "steady precession, the slower of two",
            Self::SteadyFast => "steady precession, the faster of two",
            Self::Conical => "steady precession without spin: a conical pendulum",
            Self::Separatrix => "towards the vertical, reached after infinite time",
            Self::ThroughVertical => "the axis passes through the vertical",
            Self::Cusps => "cusps: precession stops at the highest points",
            Self::Loops => "loops: precession goes backwards at the highest points",
            Self::Waves => "waves: precession never reverses",
        }
    }

    pub(super) fn of(top: &Constants, nutation: Option<&Nutation>) -> Self {
        let Some(nutation) = nutation else {
            // a² > 2β: ω3 > 2√(MglA)/C
            let stable = top.a.square().value() >= 2.0 * top.beta.value();
            return if top.from_top.value() < 1.0 { Self::Sleeping { stable } } else { Self::Hanging };
        };
        let [v1, v2, v3] = nutation.from_top.map(Double::value);
        let [w1, w2, _] = nutation.from_bottom.map(Double::value);
        let (a, beta) = (top.a.value(), top.beta.value());
        let [b_minus_a, b_plus_a] = [top.b_minus_a, top.b_plus_a].map(Triple::value);
        let root = beta.sqrt();
        let none = |rate: f64| rate.abs() <= CLOSE * root.max(a.abs());
        if none(a) && none(b_minus_a) && none(b_plus_a) {
            return Self::Planar;
        }
        if nutation.parameter.complement() == 0.0 {
            return Self::Separatrix;
        }
        let [highest, lowest] = [angle(v2, w2), angle(v1, w1)];
        if lowest - highest <= CLOSE {
            let cosine = 0.5 * (w1 - v1);
            // A cos θ φ̇² − C ω3 φ̇ + M g l = 0: the product of its roots is M g l/(A cos θ), their sum a/cos θ.
            let rate = (b_minus_a + a * v1) / (v1 * w1);
            return if none(a) {
                Self::Conical
            } else if rate * rate * cosine.abs() > 0.5 * beta {
                Self::SteadyFast
            } else {
                Self::SteadySlow
            };
        }
        if highest <= CLOSE && v3.abs() > 0.0 || PI - lowest <= CLOSE {
            return Self::ThroughVertical;
        }
        // φ̇ sin²θ = b − a cos θ = b − a + av
        let [at_highest, at_lowest] = [v2, v1].map(|v| b_minus_a + a * v);
        if at_highest.abs() <= CLOSE * (b_minus_a.abs() + a.abs() * v2) {
            Self::Cusps
        } else if (at_highest > 0.0) == (at_lowest > 0.0) {
            Self::Waves
        } else {
            Self::Loops
        }
    }
}

/// Tolerance for equality, rad or relative.
const CLOSE: f64 = 1e-9;

/// Returns θ, rad, from 1 − cos θ and 1 + cos θ.
pub(super) fn angle(from_top: f64, from_bottom: f64) -> f64 {
    2.0 * libm::atan2(from_top.sqrt(), from_bottom.sqrt())
}

/// Rates of steady precession φ̇ at an angle θ and a spin ω3: the roots of A cos θ φ̇² − C ω3 φ̇ +
/// M g l = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyPrecession {
    /// Root of smaller absolute value, rad/s.
    pub slow: f64,
    /// Root of larger absolute value, rad/s; `None` for a horizontal axis, where the equation is
    /// linear.
    pub fast: Option<f64>,
}

impl SteadyPrecession {
    /// Solves the equation for the moments A and C, the weight's M g l, cos θ and ω3; `None` if (C
    /// ω3)² < 4 A M g l cos θ.
    pub(super) fn of([across, along]: [f64; 2], weight: f64, cosine: f64, spin: f64) -> Option<Self> {
        let b = along * spin;
        let square = b * b - 4.0 * across * weight * cosine;
        if !(square >= 0.0) {
            return None;
        }
        // the larger of C ω3 ± √…; the other root follows from the product of the roots
        let sum = 0.5 * (b + square.sqrt().copysign(b));
        let slow = weight / sum;
        let fast = sum / (across * cosine);
        slow.is_finite().then(|| Self { slow, fast: fast.is_finite().then_some(fast) })
    }
}
