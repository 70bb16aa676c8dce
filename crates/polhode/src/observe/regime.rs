//! Which kind of free motion a state belongs to, and the period of ω in the body.

use crate::body::principal::Symmetry;
use crate::math::elliptic::complete_k;
use crate::math::frame::Principal;
use crate::math::vector::AngularVelocity;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;

/// The kind of a free motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Regime {
    /// ω = 0.
    AtRest,
    /// ω along a principal axis (1, 2 or 3): it stays there.
    Permanent {
        /// The axis, 1 to 3.
        axis: u8,
    },
    /// i1 = i2 = i3: every rotation is permanent.
    Spherical,
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
    /// Growth rate of a departure from permanent rotation about the intermediate axis, 1/s.
    pub growth_rate: Option<f64>,
}

impl Regime {
    /// The name in summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::AtRest => "at_rest",
            Self::Permanent { .. } => "permanent",
            Self::Spherical => "spherical",
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
            Self::Permanent { axis: 1 } => "permanent rotation about the axis of least moment",
            Self::Permanent { axis: 2 } => {
                "permanent rotation about the axis of intermediate moment (unstable)"
            }
            Self::Permanent { .. } => "permanent rotation about the axis of greatest moment",
            Self::Spherical => "permanent rotation (the three moments are equal)",
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
        let w = principal.rotation().inverse() * state.omega;
        let still = |regime| Self { regime, period: None, flip_interval: None, growth_rate: None };
        let moving: Vec<u8> = (1..).zip(w.to_array()).filter(|(_, w)| *w != 0.0).map(|(k, _)| k).collect();
        match (moving.as_slice(), principal.symmetry()) {
            ([], _) => still(Regime::AtRest),
            (_, Symmetry::Spherical | Symmetry::Point) => still(Regime::Spherical),
            ([axis], symmetry) => Self {
                growth_rate: (*axis == 2 && symmetry == Symmetry::Asymmetric)
                    .then(|| growth_rate(principal.moments(), w.y)),
                ..still(Regime::Permanent { axis: *axis })
            },
            (_, Symmetry::Asymmetric) => asymmetric(principal.moments(), w),
            (_, symmetry) => {
                let [i1, i2, i3] = principal.moments();
                let rate =
                    if symmetry == Symmetry::Oblate { (i3 - i2) / i2 * w.z } else { (i1 - i2) / i2 * w.x };
                let period = (rate != 0.0).then(|| 2.0 * core::f64::consts::PI / rate.abs());
                // Without spin about the symmetry axis the axis across it is principal, too.
                Self { period, ..still(Regime::Symmetric) }
            }
        }
    }
}

fn asymmetric([i1, i2, i3]: [f64; 3], w: AngularVelocity<Principal>) -> FreeRegime {
    // L² − 2 T i2: positive for short-axis mode
    let excess = i3 * (i3 - i2) * w.z * w.z - i1 * (i2 - i1) * w.x * w.x;
    // Labels so that L circles axis c: short-axis mode (a, c) = (1, 3), long-axis mode (3, 1).
    let (a, c, wc) = if excess >= 0.0 { (i1, i3, w.z) } else { (i3, i1, w.x) };
    // amplitude of ω along c: a_c² = ω_c² + i2 (i2 − a) / (c (c − a)) ω_2²
    let amplitude2 = wc * wc + i2 * (i2 - a) / (c * (c - a)) * w.y * w.y;
    // λ² = a_c² (c − a)(c − i2) / (a i2),  1 − m = (L² − 2 T i2) / (c (c − i2) a_c²)
    let lambda = (amplitude2 * ((c - a) / a) * ((c - i2) / i2)).sqrt();
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
        growth_rate: Some(growth_rate([i1, i2, i3], w.y)),
    }
}

/// √((i3 − i2)(i2 − i1) / (i1 i3)) |ω2|: how fast a small departure from rotation about axis 2 grows.
fn growth_rate([i1, i2, i3]: [f64; 3], w: f64) -> f64 {
    ((i3 - i2) / i3 * ((i2 - i1) / i1)).sqrt() * w.abs()
}
