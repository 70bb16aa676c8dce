//! Trajectories: the motion at given times, by the best method there is.

use super::channel::{Channel, Reading, Row, Series};
use super::channels;
use super::ending::{Ending, MethodReason};
use super::estimated_error::GlobalError;
use super::sample::{Sample, continuous};
use super::solution::Solution;
use crate::motion::contact::ContactEvent;
use crate::motion::error::MotionError;
use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::model::event::Crossing;
use crate::motion::model::event_detection::EventSide;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::{TorqueModel, total_potential};
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::free::FreeMotion;
use crate::motion::solve::propagate::balanced::Balanced;
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
    changes: Vec<ContactEvent>,
    /// State of what holds the body at the start, and at each sample; of a rotor none.
    start_reading: Option<Reading>,
    readings: Vec<Reading>,
}

/// A motion on the ground or in gimbals, as its system has computed it.
pub(in crate::motion) struct HeldMotion {
    pub(in crate::motion) start: Reading,
    pub(in crate::motion) readings: Vec<Reading>,
    pub(in crate::motion) changes: Vec<ContactEvent>,
    pub(in crate::motion) crossings: Vec<Crossing>,
    pub(in crate::motion) event_sides: Vec<EventSide>,
    pub(in crate::motion) ending: Ending,
    pub(in crate::motion) reason: MethodReason,
    pub(in crate::motion) solution: Solution,
}

impl Trajectory {
    /// A motion on the ground or in gimbals, of a rotor about its centre of mass or the crossing of
    /// the axes. Work and impulse of each sample are by the theorems themselves; the works that were
    /// integrated are in [`channel::ENERGY`](crate::motion::channel::ENERGY).
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] where energy or momentum leave the range of f64.
    pub(in crate::motion) fn held(rotor: &Rotor, motion: HeldMotion) -> Result<Self, MotionError> {
        let of = |reading: &Reading, first| Sample::held(rotor, reading.state(), reading.torque(), first);
        let first = of(&motion.start, None)?;
        let samples = motion.readings.iter().map(|reading| of(reading, Some(&first)));
        let samples = samples.collect::<Result<_, _>>()?;
        let assembled = Self::assembled(first, samples, motion.solution)
            .because(motion.reason)
            .with_events(motion.crossings, motion.ending)
            .leaving_events(motion.event_sides);
        let mut readings = motion.readings;
        for (reading, sample) in readings.iter_mut().zip(&assembled.samples) {
            reading.put_state(sample.state);
        }
        Ok(Self { changes: motion.changes, start_reading: Some(motion.start), readings, ..assembled })
    }

    /// Values of a channel at the start and at each sample; `None` if the system does not have it.
    pub fn channel<T: Copy>(&self, channel: Channel<T>) -> Option<Series<'_, T>> {
        Series::of(channel, self.start_row(), &self.samples, &self.readings)
    }

    /// The scalar channels that a body on the ground or a rotor in gimbals has, in the order of tables; of a free or
    /// pivoted rotor none, as all of it is in [`Trajectory::samples`].
    pub const fn channels(&self) -> &'static [Channel<f64>] {
        match self.start_reading {
            None => &[],
            Some(Reading::Contact(_)) => &channels::ground::SCALARS,
            Some(Reading::Gimbals(_)) => &channels::gimbals::SCALARS,
        }
    }

    /// The changes of the contact with the ground, in the order of time; of other systems none.
    pub fn changes(&self) -> &[ContactEvent] {
        &self.changes
    }

    /// Change of energy less work at each sample, relative to the largest of all energies and works
    /// together: T less the work of all torques; of a body on the ground T + U less the work of
    /// friction and of the ground; of a rotor in gimbals T + U with that of springs less the work of
    /// damping, motors, constant torques and the base.
    pub fn energy_departures(&self) -> Vec<f64> {
        let [first, size] = self.start_row().balance();
        let balances: Vec<[f64; 2]> = self.rows().map(Row::balance).collect();
        let scale = balances.iter().map(|[_, size]| *size).fold(size, f64::max);
        let departure = |[balance, _]: &[f64; 2]| match (balance - first).abs() {
            0.0 => 0.0,
            change => change / scale,
        };
        balances.iter().map(departure).collect()
    }

    /// Largest of [`Trajectory::energy_departures`].
    pub fn energy_drift(&self) -> f64 {
        self.energy_departures().into_iter().fold(0.0, f64::max)
    }

    const fn start_row(&self) -> Row<'_> {
        Row { sample: &self.start, reading: self.start_reading.as_ref() }
    }

    fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        let row = |(k, sample)| Row { sample, reading: self.readings.get(k) };
        self.samples.iter().enumerate().map(row)
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
        Ok(Self::assembled(start, samples, Solution::ClosedForm(ClosedForm::Free(Box::new(motion)))))
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
        Ok(Self::assembled(sample(start)?, samples, Solution::ClosedForm(motion)))
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
            changes: Vec::new(),
            start_reading: None,
            readings: Vec::new(),
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
