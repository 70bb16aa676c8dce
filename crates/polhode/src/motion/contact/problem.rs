//! The initial value problem of a body on the ground.

use super::arrangement::Contact;
use super::start::ContactStart;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::motion::model::event::Event;
use crate::motion::model::event_detection::EventSide;
use crate::motion::solve::propagate::noise::StepNoise;

/// Initial value problem of a body on the ground, sampled at `times`.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct ContactProblem<'a> {
    pub(in crate::motion) body: &'a MassProperties<Body>,
    pub(in crate::motion) contact: &'a Contact,
    pub(in crate::motion) start: ContactStart,
    pub(in crate::motion) times: &'a [f64],
    pub(in crate::motion) events: &'a [Event],
    pub(in crate::motion) event_sides: &'a [EventSide],
    pub(in crate::motion) tolerance: f64,
    /// Perturbation of a comparison run.
    pub(in crate::motion) noise: Option<StepNoise>,
}

/// Loosest bound on the error of a step on the ground, relative to the sizes of the variables.
/// Changes of the contact depend on signs, and looser steps would hardly be longer.
pub(in crate::motion) const LOOSEST: f64 = 1e-12;

impl ContactProblem<'_> {
    /// Returns the bound on the error of each step.
    pub(in crate::motion) const fn bound(&self) -> f64 {
        self.tolerance.min(LOOSEST)
    }
}
