//! Trajectories: the motion at given times.

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

/// Motion of a body at given times, with quantities that test its accuracy.
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
    /// State of the ground contact or of the gimbals at the start, and at each sample; `None` for a
    /// rotor.
    start_reading: Option<Reading>,
    readings: Vec<Reading>,
}

/// Motion on the ground or in gimbals, as computed by its system.
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
    /// Creates the trajectory of a body on the ground or in gimbals. The reference point is its
    /// centre of mass or the crossing of the axes.
    ///
    /// Work and impulse of each sample are the changes of kinetic energy and momentum. The
    /// integrated works are in [`channel::ENERGY`](crate::motion::channel::ENERGY).
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] if energy or momentum leave the range of f64.
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

    /// Returns the values of a channel at the start and at each sample; `None` if the system does
    /// not have it.
    pub fn channel<T: Copy>(&self, channel: Channel<T>) -> Option<Series<'_, T>> {
        Series::of(channel, self.start_row(), &self.samples, &self.readings)
    }

    /// Returns the scalar channels of a body on the ground or a rotor in gimbals, in the order of
    /// the columns of tables. A free or pivoted rotor has none; all its quantities are in
    /// [`Trajectory::samples`].
    pub const fn channels(&self) -> &'static [Channel<f64>] {
        match self.start_reading {
            None => &[],
            Some(Reading::Contact(_)) => &channels::ground::SCALARS,
            Some(Reading::Gimbals(_)) => &channels::gimbals::SCALARS,
        }
    }

    /// Returns the changes of the contact with the ground, in the order of time; empty for other
    /// systems.
    pub fn changes(&self) -> &[ContactEvent] {
        &self.changes
    }

    /// Returns the error of the energy balance at each sample, relative to the largest sum of the
    /// absolute values of its terms.
    ///
    /// - Rotor: T minus the work of all torques.
    /// - Body on the ground: T + U minus the work of friction and of the ground.
    /// - Rotor in gimbals: T + U, with springs, minus the work of damping, motors, constant torques
    ///   and the base.
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

    /// Returns the largest of [`Trajectory::energy_departures`].
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

    /// Creates the trajectory of a prescribed motion at each of `times` (ascending, s), with the
    /// torque that it requires.
    ///
    /// # Errors
    /// A parameter error ([`MotionError::is_parameter`]) if times are out of order. Otherwise the
    /// errors of [`Required::of_motion`](crate::motion::Required::of_motion).
    pub fn prescribed(rotor: &Rotor, motion: &Prescribed, times: &[f64]) -> Result<Self, MotionError> {
        require_ascending(f64::NEG_INFINITY, times)?;
        let first = Sample::of_prescribed(rotor, motion, times.first().copied().unwrap_or(0.0))?;
        let mut samples: Vec<Sample> =
            times.iter().map(|&t| Sample::of_prescribed(rotor, motion, t)).collect::<Result<_, _>>()?;
        for sample in &mut samples {
            // From the theorems of energy and momentum: nothing is integrated here.
            sample.work = sample.kinetic_energy - first.kinetic_energy;
            sample.impulse = sample.momentum - first.momentum;
        }
        Ok(Self::assembled(first, samples, Solution::Prescribed(motion.clone())).because(MethodReason::Given))
    }

    /// Returns the motion at the start, which need not be one of the times.
    pub const fn start(&self) -> &Sample {
        &self.start
    }

    /// Returns the motion at each time, in the order of the times.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// Returns the solver, with its results.
    pub const fn solution(&self) -> &Solution {
        &self.solution
    }

    /// Returns the reason for the method.
    pub const fn reason(&self) -> &MethodReason {
        &self.reason
    }

    /// Returns the events that happened, in the order of time.
    pub fn events(&self) -> &[Crossing] {
        &self.events
    }

    /// Returns the ending of the motion.
    pub const fn ending(&self) -> &Ending {
        &self.ending
    }

    /// Returns the estimated error, if
    /// [`Simulation::run_with_error`](crate::motion::Simulation::run_with_error) computed it.
    pub const fn error(&self) -> Option<&GlobalError> {
        self.error.as_ref()
    }

    /// Creates the trajectory of a free motion at each of `times` (ascending, s, also before its
    /// start).
    ///
    /// # Errors
    /// - A parameter error ([`MotionError::is_parameter`]) if times are out of order.
    /// - [`MotionError::BeyondReach`] for a time too far away.
    /// - [`MotionError::NotFinite`] if energy or momentum leave the range of f64.
    pub fn of_motion(motion: FreeMotion, times: &[f64]) -> Result<Self, MotionError> {
        require_ascending(f64::NEG_INFINITY, times)?;
        motion.require(times)?;
        let samples = motion.at_times(times).into_iter().map(|state| Sample::of_free(&motion, state));
        let samples = samples.collect::<Result<_, _>>()?;
        let start = Sample::of_free(&motion, motion.start())?;
        Ok(Self::assembled(start, samples, Solution::ClosedForm(ClosedForm::Free(Box::new(motion)))))
    }

    /// Creates the trajectory of a closed form at each of `times`. Work is computed as the loss of
    /// potential energy, impulse as the gain of momentum. Therefore T + U tests the accuracy, but
    /// the balance of impulse does not.
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

    /// Creates a trajectory from samples, however they were computed.
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

    /// Adds the estimated error.
    pub(crate) fn with_error(self, error: Option<GlobalError>) -> Self {
        Self { error, ..self }
    }

    /// Sets the reason for the method.
    pub(crate) fn because(self, reason: MethodReason) -> Self {
        Self { reason, ..self }
    }

    /// Sets the events that happened, and the ending.
    pub(crate) fn with_events(self, events: Vec<Crossing>, ending: Ending) -> Self {
        Self { events, ending, ..self }
    }

    /// Sets the side of each event's value on which the motion ends.
    pub(crate) fn leaving_events(self, event_sides: Vec<EventSide>) -> Self {
        Self { event_sides, ..self }
    }

    /// Returns the side of each event's value on which the motion ends; empty without events.
    pub(crate) fn event_sides(&self) -> &[EventSide] {
        &self.event_sides
    }
}
