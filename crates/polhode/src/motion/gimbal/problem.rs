//! The initial value problem of a rotor in its gimbals.

use super::suspension::Gimbals;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::motion::model::event::Event;
use crate::motion::model::event_detection::EventSide;
use crate::motion::solve::propagate::noise::StepNoise;

/// Initial value problem of a body as the rotor of two gimbals, sampled at `times`. The axes
/// contain the initial angles and rates.
///
/// Taylor series integrate it, with compensated rounding of the variables. The balance of energy
/// checks the result.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct GimbalProblem<'a> {
    pub(in crate::motion) body: &'a MassProperties<Body>,
    pub(in crate::motion) gimbals: &'a Gimbals,
    /// Time of the start, s.
    pub(in crate::motion) start: f64,
    pub(in crate::motion) times: &'a [f64],
    pub(in crate::motion) events: &'a [Event],
    pub(in crate::motion) event_sides: &'a [EventSide],
    /// Bound on the error of each step, relative to the sizes of the variables.
    pub(in crate::motion) tolerance: f64,
    /// Perturbation of a comparison run.
    pub(in crate::motion) noise: Option<StepNoise>,
}
