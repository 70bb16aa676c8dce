//! The motion of one member of an ensemble.

use super::member::Member;
use crate::motion::error::MotionError;
use crate::motion::model::event::Crossing;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::run::ending::Ending;
use crate::motion::run::simulation::Simulation;
use crate::motion::solve::method::Method;

/// How far a member came.
#[derive(Debug)]
pub(super) struct MemberMotion {
    /// At the times, as far as it came; the last one may be that of the ending, between two of them.
    pub(super) states: Vec<State>,
    pub(super) crossings: Vec<Crossing>,
    pub(super) ending: Ending,
}

impl MemberMotion {
    /// Without events.
    pub(super) fn of_states(states: Vec<State>, failure: Option<MotionError>) -> Self {
        let time = states.last().map_or(f64::NAN, |last| last.time);
        let ending = failure.map_or(Ending::Complete, |cause| Ending::Failed { time, cause });
        Self { states, crossings: Vec::new(), ending }
    }

    /// The states of a member alone, under torques that are its own, or stand for them.
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

    /// The same with its events; `None` if `goes_on`, which is asked after each step, gave false.
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

    /// Its state at each of so many times: where it came no further, that in which it stays.
    pub(super) fn at_all(&self, times: usize, start: State) -> impl Iterator<Item = State> + '_ {
        let last = self.states.last().copied().unwrap_or(start);
        self.states.iter().copied().chain(core::iter::repeat(last)).take(times)
    }
}
