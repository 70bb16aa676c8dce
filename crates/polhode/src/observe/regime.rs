//! Which kind of free motion a state belongs to, and the period of ω in the body.

use crate::body::principal::Symmetry;
use crate::math::elliptic::complete_k;
use crate::math::frame::Principal;
use crate::math::real::PI;
use crate::math::symmetric3::power_of_two_near;
use crate::math::vector::AngularVelocity;
use crate::motion::free::PermanentAxis;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;

/// The kind of a free motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Regime {
    /// ω = 0.
    AtRest,
    /// ω along a principal axis: it stays there.
    Permanent(PermanentAxis),
    /// Two equal moments: ω circles the symmetry axis.
    Symmetric,
    /// D < i2: long-axis mode, L circles axis 1.
    LongAxis,
    /// D > i2: short-axis mode, L circles axis 3.
    ShortAxis,
    /// D = i2: ω creeps to the intermediate axis and never arrives.
    Separatrix,
}

/// The free motion of a state, classified, with its period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeRegime {
    /// The kind of motion.
    pub regime: Regime,
    /// The time after which ω repeats in the body, s; `None` where it never moves or never repeats.
    pub period: Option<f64>,
    /// The time between reversals of ω's component along the intermediate axis, s, for three different moments.
    pub flip_interval: Option<f64>,
    /// Growth rate of a departure from permanent rotation about the intermediate axis, 1/s, where ω is within 0.5 rad
    /// of it.
    pub growth_rate: Option<f64>,
}

impl Regime {
    /// The name in summaries.
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

    /// In words.
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

impl FreeRegime {
    /// The torque-free motion that a state belongs to.
    ///
    /// With D = L²/2T the mode follows from the sign of
    /// L² − 2 T i2 = i1 (i1 − i2) ω1² + i3 (i3 − i2) ω3², and the period of ω is 4 K(m) / λ.
    ///
    /// ```
    /// use polhode::*;
    /// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
    /// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.01) };
    /// let free = FreeRegime::of(&body, &start);
    /// assert_eq!(free.regime, Regime::ShortAxis);
    /// assert!((free.period.unwrap() / 39.105_734_197_268_72 - 1.0).abs() < 1e-15);
    /// # Ok::<(), polhode::BodyError>(())
    /// ```
    ///
    /// Source: Landau & Lifshitz, Mechanics, §37, with 1 − m formed from the sum above, which does not cancel.
    pub fn of(rotor: &Rotor, state: &State) -> Self {
        let principal = rotor.principal();
        let moments = principal.moments();
        let w = principal.rotation().inverse() * state.omega;
        let still = |regime| Self { regime, period: None, flip_interval: None, growth_rate: None };
        if w == AngularVelocity::ZERO {
            return still(Regime::AtRest);
        }
        let growth_rate = growth_rate(moments, w);
        if let Some(axis) = PermanentAxis::of(principal, state.omega) {
            return Self { growth_rate, ..still(Regime::Permanent(axis)) };
        }
        let [i1, i2, i3] = moments;
        match principal.symmetry() {
            Symmetry::Asymmetric => Self { growth_rate, ..asymmetric(moments, w) },
            symmetry => {
                let rate =
                    if symmetry == Symmetry::Oblate { (i3 - i2) / i2 * w.z } else { (i1 - i2) / i2 * w.x };
                Self { period: Some(2.0 * PI / rate.abs()), ..still(Regime::Symmetric) }
            }
        }
    }
}

/// With moments and rates in units of powers of two near the largest: exact, and no square leaves the range of f64.
fn asymmetric(moments: [f64; 3], w: AngularVelocity<Principal>) -> FreeRegime {
    let (largest, fastest) = (power_of_two_near(moments[2]), power_of_two_near(w.max_abs()));
    let ([i1, i2, i3], w) = (moments.map(|i| i / largest), w / fastest);
    // L² − 2 T i2: positive for short-axis mode
    let excess = i3 * (i3 - i2) * w.z * w.z - i1 * (i2 - i1) * w.x * w.x;
    // Labels so that L circles axis c: short-axis mode (a, c) = (1, 3), long-axis mode (3, 1).
    let (a, c, wc) = if excess >= 0.0 { (i1, i3, w.z) } else { (i3, i1, w.x) };
    // amplitude of ω along c: a_c² = ω_c² + i2 (i2 − a) / (c (c − a)) ω_2²
    let amplitude2 = wc * wc + i2 * (i2 - a) / (c * (c - a)) * w.y * w.y;
    // λ² = a_c² (c − a)(c − i2) / (a i2),  1 − m = (L² − 2 T i2) / (c (c − i2) a_c²)
    let lambda = (amplitude2 * ((c - a) / a) * ((c - i2) / i2)).sqrt() * fastest;
    let m1 = excess / (c * (c - i2) * amplitude2);
    let quarter = complete_k(m1) / lambda;
    let regime = match excess {
        0.0 => Regime::Separatrix,
        e if e > 0.0 => Regime::ShortAxis,
        _ => Regime::LongAxis,
    };
    let finite = |t: f64| t.is_finite().then_some(t);
    FreeRegime {
        regime,
        period: finite(4.0 * quarter),
        flip_interval: finite(2.0 * quarter),
        growth_rate: None,
    }
}

/// A state nearer to the intermediate axis than this is about its instability: cos 0.5 rad.
const NEAR: f64 = 0.877_582_561_890_372_8;

/// √((i3 − i2)(i2 − i1) / (i1 i3)) |ω2|, for three different moments and ω near axis 2.
fn growth_rate([i1, i2, i3]: [f64; 3], w: AngularVelocity<Principal>) -> Option<f64> {
    let rate = ((i3 - i2) / i3 * ((i2 - i1) / i1)).sqrt() * w.y.abs();
    (rate > 0.0 && rate.is_finite() && w.y.abs() > NEAR * w.norm()).then_some(rate)
}
