//! A run: its steps, its samples, its events, and how it ends.

use super::change::{ContactEvent, ContactPhase};
use super::equations::Regime;
use super::model::Model;
use super::sample::ContactSample;
use super::setup;
use super::simulation::ContactSimulation;
use super::stepper::Stepper;
use super::trajectory::{ContactEnding, ContactTrajectory};
use super::watch::Kind;
use crate::math::frame::{Body, Part, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{Direction, Position, Vector, Velocity};
use crate::motion::error::MotionError;
use crate::motion::model::event::{Crossing, Event, EventAction};
use crate::motion::model::event_detection::{EventDetector, Found, Watched};
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::solve::limits::{LOOSEST_TOLERANCE, MOST_STEPS, TIGHTEST_TOLERANCE};
use crate::motion::solve::propagate::step_statistics::StepStatistics;
use crate::motion::solve::solver::Solver;
use crate::motion::solve::start::require_ascending;

/// The most events and changes of a run.
const MOST_EVENTS: usize = 1_000_000;

impl ContactSimulation<'_> {
    /// Computes the motion.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for times out of order, a tolerance out of range, a start that is not finite and one that
    /// violates the contact; [`MotionError::Painleve`] and [`MotionError::Undecided`] where it is not known how it begins.
    pub fn run(&self) -> Result<ContactTrajectory, MotionError> {
        self.run_watched(&mut |_| true)
    }

    /// [`ContactSimulation::run`]; `progress` is told the time after each step, and `false` ends the work.
    ///
    /// # Errors
    /// As [`ContactSimulation::run`]; [`MotionError::Stopped`] if `progress` said so.
    pub fn run_watched(
        &self,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<ContactTrajectory, MotionError> {
        let time = self.start.state.time;
        require_ascending(time, self.times)?;
        let rule = "between 1e-15 and 0.01";
        let holds = (TIGHTEST_TOLERANCE..=LOOSEST_TOLERANCE).contains(&self.tolerance);
        require::that("the tolerance", self.tolerance, holds, rule)?;
        Run::new(self)?.finish(progress)
    }
}

/// A run on its way.
pub(super) struct Run<'a> {
    of: &'a ContactSimulation<'a>,
    pub(super) stepper: Stepper,
    pub(super) changes: Vec<ContactEvent>,
    samples: Vec<ContactSample>,
    crossings: Vec<Crossing>,
    statistics: StepStatistics,
    /// The solvers of the steps so far.
    solver: Option<Solver>,
    start: ContactSample,
    ending: ContactEnding,
}

impl<'a> Run<'a> {
    /// # Errors
    /// As [`ContactSimulation::run`].
    pub(super) fn new(of: &'a ContactSimulation<'a>) -> Result<Self, MotionError> {
        let stepper = setup::started(of)?;
        // It may have no numbers before it is known which phase holds.
        let start = read(of, &stepper, of.start.state.time, stepper.variables());
        // The start as it was given, not as it comes back from other axes.
        let start = ContactSample { state: of.start.state, ..start };
        let (changes, samples, crossings) = (Vec::new(), Vec::new(), Vec::new());
        let (statistics, ending) = (StepStatistics::default(), ContactEnding::Complete);
        let mut run =
            Self { of, stepper, changes, samples, crossings, statistics, solver: None, start, ending };
        run.ending = run.settle_start()?;
        // With the forces of the phase that holds.
        let now = sample(of, &run.stepper, of.start.state.time, run.stepper.variables())?;
        Ok(Self { start: ContactSample { state: of.start.state, ..now }, ..run })
    }

    /// Runs to the last time, as far as it can.
    ///
    /// # Errors
    /// [`MotionError::Stopped`] if `progress` says so.
    pub(super) fn finish(
        mut self,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<ContactTrajectory, MotionError> {
        let rotor = Rotor::free(self.of.body);
        let mut watch = EventDetector::new(&rotor, &[], (self.of.events, &[]), &self.of.start.state);
        while self.next_wanted().is_some_and(|t| t <= self.start.state.time) {
            self.samples.push(self.start);
        }
        let end = self.of.times.last().copied().unwrap_or(self.start.state.time);
        let mut ending = core::mem::replace(&mut self.ending, ContactEnding::Complete);
        while self.stepper.time() < end && ending == ContactEnding::Complete {
            ending = match self.step(end, &mut watch) {
                Ok(ending) => ending,
                Err(cause) => ContactEnding::Failed { cause, time: self.stepper.time() },
            };
            if !progress(self.stepper.time()) {
                return Err(MotionError::Stopped { time: self.stepper.time() });
            }
        }
        if ending != ContactEnding::Complete {
            self.sample_end();
        }
        let last = self.samples.last().map_or(self.start.state.time, |last| last.state.time);
        let (ContactEnding::Stopped { time, .. }
        | ContactEnding::Changed { time, .. }
        | ContactEnding::Failed { time, .. }) = &mut ending
        else {
            return Ok(self.finished(ending));
        };
        *time = last;
        Ok(self.finished(ending))
    }

    fn finished(self, ending: ContactEnding) -> ContactTrajectory {
        let solver = self.solver.unwrap_or_else(|| self.stepper.solver());
        let Self { changes, samples, crossings, statistics, start, .. } = self;
        let samples = continuous(samples);
        ContactTrajectory { start, samples, changes, crossings, ending, solver, statistics }
    }

    /// One step, and what ends at it.
    fn step(&mut self, end: f64, watch: &mut EventDetector<'_>) -> Result<ContactEnding, MotionError> {
        let from = self.stepper.time();
        // Events of the user are looked for within each step.
        let first_look = if self.of.events.is_empty() { self.next_wanted().unwrap_or(end) } else { from };
        let longest = self.stepper.expand(end, first_look);
        if self.statistics.accepted == MOST_STEPS {
            return Err(MotionError::TooManySteps { time: from, step: longest, most: MOST_STEPS });
        }
        if longest.is_nan() {
            return Err(MotionError::NotFinite { time: from });
        }
        if !(from + longest > from) {
            return Err(MotionError::StepTooSmall { time: from, step: longest });
        }
        let mut to = if from + longest < end { from + longest } else { end };
        let mut passing = self.stepper.passing(to - from);
        if passing.is_some()
            && let Some(longest) = self.stepper.refined(end)
        {
            to = if from + longest < end { from + longest } else { end };
            passing = self.stepper.passing(to - from);
        }
        if let Some(found) = passing {
            let wanted = from + found.after;
            to = self.stepper.shorten(wanted, first_look);
            passing = passing.filter(|_| to >= wanted);
        }
        let mut stop = None;
        let found = {
            let (of, stepper) = (self.of, &self.stepper);
            let state = |time: f64| state(of, stepper, time, &stepper.variables_at(time));
            watch.look([from, to], &Watched { state: &state, rates: &|_| None })?
        };
        let mut found = found.as_slice();
        while let Some(first) = found.first() {
            let time = first.time;
            let (of, stepper) = (self.of, &self.stepper);
            let at = |time: f64| state(of, stepper, time, &stepper.variables_at(time));
            let stops = |event: usize| {
                self.of.events.get(event).is_some_and(|event| event.action() == EventAction::Stop)
            };
            let due = if stops(first.event) { watch.due(found, &at) } else { vec![*first] };
            let at = at(time);
            for crossing in &due {
                if self.crossings.len() == MOST_EVENTS {
                    return Err(MotionError::TooManyEvents { time, most: MOST_EVENTS });
                }
                let name = self.of.events.get(crossing.event).map_or("", Event::name).to_owned();
                let Found { event, rising, .. } = *crossing;
                self.crossings.push(Crossing { event, name, state: at, rising });
            }
            if stops(first.event) {
                (to, stop) = (time, Some(first.event));
                break;
            }
            found = found.get(1..).unwrap_or_default();
        }
        if self.stepper.sinks(to) {
            return Err(MotionError::Undecided { time: from });
        }
        while let Some(t) = self.next_wanted().filter(|&t| t <= to) {
            let sample = sample(self.of, &self.stepper, t, &self.stepper.variables_at(t))?;
            self.samples.push(sample);
        }
        let solver = self.stepper.solver();
        let is_other = self.solver.is_some_and(|before| before != solver);
        self.solver = Some(if is_other { Solver::CollocationAndTaylor } else { solver });
        self.stepper.advance(to - from, to);
        self.statistics.accepted += 1;
        let work = self.stepper.take_work();
        self.statistics.evaluations += work.evaluations;
        self.statistics.rejected += work.rejected;
        if let Some(event) = stop {
            return Ok(ContactEnding::Stopped { event, time: to });
        }
        let exhausted = self.stepper.exhausted();
        let Some(passed) = passing.map(|passing| passing.watch).or(exhausted) else {
            return Ok(ContactEnding::Complete);
        };
        if self.changes.len() == MOST_EVENTS {
            return Err(MotionError::TooManyEvents { time: to, most: MOST_EVENTS });
        }
        self.pass(passed)
    }

    /// The state at which the motion ends, if it is not a sample.
    fn sample_end(&mut self) {
        let time = self.stepper.time();
        if self.samples.last().is_none_or(|last| last.state.time < time)
            && let Ok(sample) = sample(self.of, &self.stepper, time, self.stepper.variables())
        {
            self.samples.push(sample);
        }
    }

    fn next_wanted(&self) -> Option<f64> {
        self.of.times.get(self.samples.len()).copied()
    }
}

/// q and −q are one attitude: each sample takes the sign nearest to the one before it.
fn continuous(mut samples: Vec<ContactSample>) -> Vec<ContactSample> {
    for k in 1..samples.len() {
        samples[k].state.attitude = samples[k].state.attitude.continuous_with(samples[k - 1].state.attitude);
    }
    samples
}

/// Attitude and ω of the variables.
fn state(of: &ContactSimulation<'_>, stepper: &Stepper, time: f64, y: &[f64]) -> State {
    let model = &stepper.model;
    let e1 = Direction::<Part>::new(y[0], y[1], y[2]);
    let e3 = Direction::<Part>::new(y[3], y[4], y[5]);
    // The axes of the ground along those of the surface are the rows of R_ground_surface.
    let surface_ground: Rotation<Part, Part> = Rotation::from_axes([e1, e3.cross(e1), e3]);
    let attitude = model.in_space * surface_ground.inverse() * model.in_body.inverse();
    let attitude = attitude.continuous_with(of.start.state.attitude);
    State { time, attitude, omega: model.in_body * Vector::new(y[6], y[7], y[8]) }
}

/// A vector along the axes of the surface, along those of the body.
fn in_body<Q>(model: &Model, v: [f64; 3]) -> Vector<Q, Body> {
    model.in_body * Vector::<Q, Part>::from_array(v)
}

/// A body and its contact at one time.
///
/// # Errors
/// [`MotionError::NotFinite`] where a number of it is not.
fn sample(
    of: &ContactSimulation<'_>,
    stepper: &Stepper,
    time: f64,
    y: &[f64],
) -> Result<ContactSample, MotionError> {
    let sample = read(of, stepper, time, y);
    let numbers = [sample.kinetic_energy, sample.normal_force, sample.contact.norm(), sample.torque.norm()];
    if numbers.iter().all(|x| x.is_finite()) { Ok(sample) } else { Err(MotionError::NotFinite { time }) }
}

/// A body and its contact at one time, finite or not.
fn read(of: &ContactSimulation<'_>, stepper: &Stepper, time: f64, y: &[f64]) -> ContactSample {
    let (model, kind) = (&stepper.model, stepper.kind());
    let state = state(of, stepper, time, y);
    let at = stepper.reading(y);
    let [friction_work, ground_work] = [2, 1].map(|k| y.get(y.len() - k).copied().unwrap_or(f64::NAN));
    let center: Position<Space> = model.in_space * Position::<Part>::from_array(at.center);
    let offset: Position<Space> = state.attitude * in_body(model, at.arm);
    let weight = of.body.mass() * of.contact.gravity.dot(center);
    let velocity: Velocity<Space> = state.attitude * in_body(model, at.velocity);
    let inertia = of.body.inertia();
    let momentum = {
        let rows = inertia.matrix();
        let [x, y, z] = state.omega.to_array();
        rows.map(|[a, b, c]| a * x + b * y + c * z)
    };
    let turning: f64 = momentum.iter().zip(state.omega.to_array()).map(|(l, w)| l * w).sum();
    let phase = match kind {
        Kind::Flying => ContactPhase::Flying,
        Kind::Touching(Regime::Rolling, _) => ContactPhase::Rolling,
        Kind::Touching(Regime::Sliding, _) => ContactPhase::Sliding,
    };
    ContactSample {
        state,
        phase,
        center,
        velocity,
        contact: center + offset,
        contact_in_body: of.body.center_of_mass() + in_body(model, at.arm),
        normal: state.attitude * in_body(model, at.normal),
        slip: state.attitude * in_body(model, at.slip),
        normal_force: at.normal_force,
        friction: state.attitude * in_body(model, at.friction),
        torque: in_body(model, at.torque),
        kinetic_energy: 0.5 * (of.body.mass() * velocity.dot(velocity) + turning),
        potential_energy: -weight,
        friction_work,
        ground_work,
    }
}
