//! Classification of the free motion of a state, and the period of ω in the body.

use crate::body::principal::Symmetry;
use crate::math::frame::Principal;
use crate::math::vector::AngularVelocity;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::solve::free::{FreeMotion, Regime};

/// Kind of free motion of a state, with its period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeRegime {
    /// Kind of free motion.
    pub regime: Regime,
    /// Period of ω in the body, s; `None` if ω is constant or not periodic.
    pub period: Option<f64>,
    /// Time between reversals of the component of ω along the intermediate axis, s, for three
    /// different moments.
    pub flip_interval: Option<f64>,
    /// Growth rate of a deviation from permanent rotation about the intermediate axis, 1/s; `None`
    /// unless ω is within 0.5 rad of that axis.
    pub growth_rate: Option<f64>,
}

impl FreeRegime {
    /// Classifies the torque-free motion of a state.
    ///
    /// The mode follows from D = L²/2T, by the sign of
    /// L² − 2 T i2 = i1 (i1 − i2) ω1² + i3 (i3 − i2) ω3², and the period of ω is 4 K(m) / λ.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// use polhode::motion::Regime;
    /// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
    /// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.01) };
    /// let free = FreeRegime::of(&body, &start);
    /// assert_eq!(free.regime, Regime::ShortAxis);
    /// assert!((free.period.unwrap() / 39.105_734_197_268_72 - 1.0).abs() < 1e-15);
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    ///
    /// Source: Landau & Lifshitz, Mechanics, §37, with 1 − m computed from the sum above, which
    /// does not cancel.
    pub fn of(rotor: &Rotor, state: &State) -> Self {
        match FreeMotion::of(rotor, *state) {
            Ok(motion) => Self::of_motion(&motion),
            Err(_) => Self { regime: Regime::AtRest, period: None, flip_interval: None, growth_rate: None },
        }
    }

    /// Classifies a free motion.
    pub fn of_motion(motion: &FreeMotion) -> Self {
        let (regime, period, principal) = (motion.regime(), motion.period(), motion.principal());
        let asymmetric = principal.symmetry() == Symmetry::Asymmetric;
        let w = principal.rotation().inverse() * motion.start().omega;
        Self {
            regime,
            period,
            flip_interval: period
                .filter(|_| matches!(regime, Regime::LongAxis | Regime::ShortAxis))
                .map(|period| 0.5 * period),
            growth_rate: growth_rate(principal.moments(), w).filter(|_| asymmetric),
        }
    }
}

/// Cosine of 0.5 rad: if ω is nearer to the intermediate axis than this angle, the growth rate is
/// reported.
const NEAR: f64 = 0.877_582_561_890_372_8;

/// Returns √((i3 − i2)(i2 − i1) / (i1 i3)) |ω2|, 1/s, for three different moments and ω near axis
/// 2.
fn growth_rate([i1, i2, i3]: [f64; 3], w: AngularVelocity<Principal>) -> Option<f64> {
    let rate = ((i3 - i2) / i3 * ((i2 - i1) / i1)).sqrt() * w.y.abs();
    (rate > 0.0 && rate.is_finite() && w.y.abs() > NEAR * w.norm()).then_some(rate)
}
