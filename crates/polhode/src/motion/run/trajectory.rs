//! Trajectories: the motion at given times, by the best method there is.

use super::ending::{Ending, MethodReason};
use super::estimated_error::GlobalError;
use super::sample::{Sample, continuous};
use super::solution::Solution;
use crate::motion::contact::{ContactSample, ContactTrajectory};
use crate::motion::error::MotionError;
use crate::motion::gimbal::{GimbalSample, GimbalTrajectory};
use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::model::event::Crossing;
use crate::motion::model::event_detection::EventSide;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::{TorqueModel, total_potential};
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::free::FreeMotion;
use crate::motion::solve::propagate::balanced::Balanced;
use crate::motion::solve::solver::Solver;
use crate::motion::solve::start::require_ascending;

/// The motion of a body at given times, with the evidence of its own error.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    start: Sample,
    samples: Vec<Sample>,
    solution: Solution,
    reason: MethodReason,
    events: Vec<Crossing>,
    ending: Ending,
    event_sides: Vec<EventSide>,
    error: Option<GlobalError>,
    contact: Option<Box<ContactTrajectory>>,
    gimbals: Option<Box<GimbalTrajectory>>,
}

impl Trajectory {
    /// A motion on the ground. Of each sample the work and the impulse are by the theorems themselves: what is integrated is in
    /// [`Trajectory::contact`].
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] where energy or momentum leave the range of f64.
    pub(crate) fn of_contact(
        rotor: &Rotor,
        motion: ContactTrajectory,
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        let of = |s: &ContactSample, first| Sample::held(rotor, s.state, s.torque, first);
        let first = of(motion.start(), None)?;
        let samples = motion.samples().iter().map(|sample| of(sample, Some(&first)));
        let samples = samples.collect::<Result<_, _>>()?;
        let statistics = motion.statistics();
        let (solver, tolerance) = (motion.solver(), Some(tolerance));
        let solution = Solution::Integrated { solver, tolerance, statistics };
        let (events, ending) = (motion.events().to_vec(), Ending::of_contact(motion.ending()));
        let trajectory = Self::assembled(first, samples, solution).because(MethodReason::Contact);
        Ok(Self { contact: Some(Box::new(motion)), ..trajectory.with_events(events, ending) })
    }

    /// The contact with the ground at each sample, of a body that has one.
    pub fn contact(&self) -> Option<&ContactTrajectory> {
        self.contact.as_deref()
    }

    /// A motion in gimbals, of the rotor about the crossing of their axes. Of each sample the work and the impulse are by the theorems themselves: what is
    /// integrated is in [`Trajectory::gimbals`].
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] where energy or momentum leave the range of f64.
    pub(crate) fn of_gimbals(
        rotor: &Rotor,
        motion: GimbalTrajectory,
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        let of = |s: &GimbalSample, first| Sample::held(rotor, s.state, s.torque, first);
        let first = of(motion.start(), None)?;
        let samples = motion.samples().iter().map(|sample| of(sample, Some(&first)));
        let samples = samples.collect::<Result<_, _>>()?;
        let statistics = motion.statistics();
        let solution =
            Solution::Integrated { solver: Solver::Taylor, tolerance: Some(tolerance), statistics };
        let failed = |(time, cause): (f64, &MotionError)| Ending::Failed { time, cause: cause.clone() };
        let ending = motion.failure().map_or(Ending::Complete, failed);
        let trajectory = Self::assembled(first, samples, solution).because(MethodReason::Gimbals);
        Ok(Self { gimbals: Some(Box::new(motion)), ending, ..trajectory })
    }

    /// The gimbals at each sample, of a rotor that hangs in them.
    pub fn gimbals(&self) -> Option<&GimbalTrajectory> {
        self.gimbals.as_deref()
    }

    /// A prescribed motion at each of `times` (ascending, s), with the torque that it needs.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if times are out of order; else as [`Required::by`](crate::motion::Required::by).
    pub fn prescribed(rotor: &Rotor, motion: &Prescribed, times: &[f64]) -> Result<Self, MotionError> {
        require_ascending(f64::NEG_INFINITY, times)?;
        let first = Sample::of_prescribed(rotor, motion, times.first().copied().unwrap_or(0.0))?;
        let mut samples: Vec<Sample> =
            times.iter().map(|&t| Sample::of_prescribed(rotor, motion, t)).collect::<Result<_, _>>()?;
        for sample in &mut samples {
            // By the theorems themselves: nothing is integrated here.
            sample.work = sample.kinetic_energy - first.kinetic_energy;
            sample.impulse = sample.momentum - first.momentum;
        }
        Ok(Self::assembled(first, samples, Solution::Prescribed(motion.clone())).because(MethodReason::Given))
    }

    /// The motion at the start, which need not be one of the times.
    pub const fn start(&self) -> &Sample {
        &self.start
    }

    /// The motion at each time, in the order of the times.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// How it was found.
    pub const fn solution(&self) -> &Solution {
        &self.solution
    }

    /// Why it was found so.
    pub const fn reason(&self) -> &MethodReason {
        &self.reason
    }

    /// The events that happened, in the order of time.
    pub fn events(&self) -> &[Crossing] {
        &self.events
    }

    /// How it ended.
    pub const fn ending(&self) -> &Ending {
        &self.ending
    }

    /// The estimate of its error, if it was asked for: [`Simulation::run_with_error`](crate::motion::Simulation::run_with_error).
    pub const fn error(&self) -> Option<&GlobalError> {
        self.error.as_ref()
    }

    /// A free motion at each of `times` (ascending, s; before its start too).
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if times are out of order, [`MotionError::BeyondReach`] for one too far away,
    /// [`MotionError::NotFinite`] where energy or momentum leave the range
    /// of f64.
    pub fn of_motion(motion: FreeMotion, times: &[f64]) -> Result<Self, MotionError> {
        require_ascending(f64::NEG_INFINITY, times)?;
        motion.require(times)?;
        let samples = motion.at_times(times).into_iter().map(|state| Sample::of_free(&motion, state));
        let samples = samples.collect::<Result<_, _>>()?;
        let start = Sample::of_free(&motion, motion.start())?;
        Ok(Self::assembled(start, samples, Solution::Exact(ClosedForm::Free(Box::new(motion)))))
    }

    /// A motion in closed form at each of `times`. Its work is the potential energy lost and its impulse the momentum gained: so
    /// T + U is evidence of its error, the balance of impulse is not.
    pub(crate) fn of_closed_form(
        motion: ClosedForm,
        rotor: &Rotor,
        torques: &[TorqueModel],
        times: &[f64],
    ) -> Result<Self, MotionError> {
        if let ClosedForm::Free(motion) = motion {
            return Self::of_motion(*motion, times);
        }
        motion.require(times)?;
        let start = motion.start();
        let (potential, momentum) =
            (total_potential(torques, rotor, &start), rotor.angular_momentum_space(&start));
        let sample = |state: State| {
            let now = total_potential(torques, rotor, &state);
            let work = now.zip(potential).map_or(0.0, |(now, first)| first - now);
            let impulse = rotor.angular_momentum_space(&state) - momentum;
            Sample::of(rotor, torques.iter(), now, Balanced { state, work, impulse })
        };
        let mut samples = Vec::with_capacity(times.len());
        for state in motion.at_times(times) {
            samples.push(sample(state)?);
        }
        Ok(Self::assembled(sample(start)?, samples, Solution::Exact(motion)))
    }

    /// A trajectory of samples, whichever way they were found.
    pub(crate) fn assembled(start: Sample, samples: Vec<Sample>, solution: Solution) -> Self {
        Self {
            start,
            samples: continuous(samples),
            solution,
            reason: MethodReason::Asked,
            events: Vec::new(),
            ending: Ending::Complete,
            event_sides: Vec::new(),
            error: None,
            contact: None,
            gimbals: None,
        }
    }

    /// The estimate of its error comes with it.
    pub(crate) fn with_error(self, error: Option<GlobalError>) -> Self {
        Self { error, ..self }
    }

    /// Says why the method is what it is.
    pub(crate) fn because(self, reason: MethodReason) -> Self {
        Self { reason, ..self }
    }

    /// What happened on the way, and how it ended.
    pub(crate) fn with_events(self, events: Vec<Crossing>, ending: Ending) -> Self {
        Self { events, ending, ..self }
    }

    /// On which side of each event's value it ends.
    pub(crate) fn leaving_events(self, event_sides: Vec<EventSide>) -> Self {
        Self { event_sides, ..self }
    }

    /// On which side of each event's value it ends; empty if it watched none.
    pub(crate) fn event_sides(&self) -> &[EventSide] {
        &self.event_sides
    }
}
