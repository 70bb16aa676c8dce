//! Motion of one member of an ensemble.

use super::member::Member;
use crate::motion::error::MotionError;
use crate::motion::model::event::Crossing;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::run::ending::Ending;
use crate::motion::run::rotor_problem::sample;
use crate::motion::run::simulation::Simulation;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::stepper::Stepper;
use crate::motion::solve::propagate::taylor::Acting;

/// Motion of a member, as far as it was computed.
#[derive(Debug)]
pub(super) struct MemberMotion {
    /// States at the times reached. The last one may be that of the ending, between two times.
    pub(super) states: Vec<State>,
    pub(super) crossings: Vec<Crossing>,
    pub(super) ending: Ending,
}

impl MemberMotion {
    /// Creates the motion of a member without events.
    pub(super) fn of_states(states: Vec<State>, failure: Option<MotionError>) -> Self {
        let time = states.last().map_or(f64::NAN, |last| last.time);
        let ending = failure.map_or(Ending::Complete, |cause| Ending::Failed { time, cause });
        Self { states, crossings: Vec::new(), ending }
    }

    /// Computes the states of a member separately. `torques`: its own torques, or replacements for
    /// them.
    pub(super) fn alone(
        Member { rotor, switched_off, start, .. }: &Member,
        torques: &[TorqueModel],
        times: &[f64],
        (method, tolerance): (Method, f64),
    ) -> Self {
        let simulation = Simulation::new(rotor, torques, *start, times).switched_off(switched_off);
        let mut states = Vec::with_capacity(times.len());
        let failure = simulation.method(method).tolerance(tolerance).fill(&mut states).err();
        Self::of_states(states, failure)
    }

    /// Computes the states of a member separately by Taylor's method.
    pub(super) fn of_acting(
        Member { rotor, torques, start, .. }: &Member,
        acting: &Acting,
        times: &[f64],
        tolerance: f64,
    ) -> Self {
        let mut states = Vec::with_capacity(times.len());
        let stepper = Stepper::of_acting(acting, rotor, torques, *start, tolerance);
        let failure = stepper.and_then(|stepper| sample(stepper, times, &mut states)).err();
        Self::of_states(states, failure)
    }

    /// Computes a member separately, with its events. `goes_on` is called after each step; `None`
    /// if it returned false.
    pub(super) fn watched(
        Member { rotor, switched_off, start, events, .. }: &Member,
        torques: &[TorqueModel],
        times: &[f64],
        (method, tolerance): (Method, f64),
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Option<Self> {
        let simulation = Simulation::new(rotor, torques, *start, times).switched_off(switched_off);
        let simulation = simulation.events(events).method(method).tolerance(tolerance);
        match simulation.run_watched(&mut |_| goes_on()) {
            Ok(motion) => Some(Self {
                states: motion.samples().iter().map(|sample| sample.state).collect(),
                crossings: motion.events().to_vec(),
                ending: motion.ending().clone(),
            }),
            Err(MotionError::Stopped { .. }) => None,
            Err(cause) => Some(Self::of_states(Vec::new(), Some(cause))),
        }
    }

    /// Returns the state at each of `times` times. After the end of the motion the last state is
    /// repeated.
    pub(super) fn at_all(&self, times: usize, start: State) -> impl Iterator<Item = State> + '_ {
        let last = self.states.last().copied().unwrap_or(start);
        self.states.iter().copied().chain(core::iter::repeat(last)).take(times)
    }
}
