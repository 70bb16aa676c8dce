//! A body on the ground as a stepwise system: its steps, the ends of its phases, and its samples.

use super::change::{ContactChange, ContactEvent, ContactPhase};
use super::equations::Regime;
use super::model::Model;
use super::problem::ContactProblem;
use super::setup;
use super::state::ContactState;
use super::stepper::{Passing, Stepper};
use super::watch::Kind;
use crate::math::frame::{Body, Part, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{Direction, Position, Vector, Velocity};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;
use crate::motion::solve::limits::{MOST_EVENTS, require_step, require_tolerance};
use crate::motion::solve::propagate::step_statistics::StepStatistics;
use crate::motion::solve::start::require_ascending;
use crate::motion::solve::system::System;

/// Integration of a body on the ground.
pub(in crate::motion) struct OnGround<'a> {
    of: &'a ContactProblem<'a>,
    pub(super) stepper: Stepper,
    pub(in crate::motion) changes: Vec<ContactEvent>,
    pub(in crate::motion) statistics: StepStatistics,
    /// True if steps were computed by collocation, and by Taylor series.
    has_collocated: bool,
    has_expanded: bool,
    /// End of the current step, s, and the end of the phase there.
    to: f64,
    passing: Option<Passing>,
}

impl<'a> OnGround<'a> {
    /// Creates the system at its start. Also returns the first sample, and the change that ends the
    /// motion immediately, if there is one.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if times are out of order, if the
    /// tolerance is out of range, or if the start is not finite or violates the contact.
    /// [`MotionError::Painleve`] and [`MotionError::Undecided`] if the first phase is not
    /// determined.
    pub(in crate::motion) fn new(
        of: &'a ContactProblem<'a>,
    ) -> Result<(Self, ContactState, Option<ContactChange>), MotionError> {
        let time = of.start.state.time;
        require_ascending(time, of.times)?;
        require_tolerance(of.tolerance)?;
        let stepper = setup::started(of)?;
        let mut system = Self {
            of,
            stepper,
            changes: Vec::new(),
            statistics: StepStatistics::default(),
            has_collocated: false,
            has_expanded: false,
            to: time,
            passing: None,
        };
        let halted = system.settle_start()?;
        // Forces of the phase that holds; the start as given, without rounding by the change of
        // axes.
        let start = ContactState { state: of.start.state, ..system.sample_at(time)? };
        Ok((system, start, halted))
    }

    /// Returns true if steps so far used collocation, and true if they used Taylor series. Before
    /// the first step this refers to the next step.
    pub(in crate::motion) fn solvers(&self) -> [bool; 2] {
        match [self.has_collocated, self.has_expanded] {
            [false, false] => [self.stepper.is_collocation(), !self.stepper.is_collocation()],
            solvers => solvers,
        }
    }
}

impl System for OnGround<'_> {
    type Sample = ContactState;
    type Change = ContactChange;

    fn time(&self) -> f64 {
        self.stepper.time()
    }

    fn begin(&mut self, end: f64, first_look: f64) -> Result<f64, MotionError> {
        let from = self.stepper.time();
        let longest = self.stepper.expand(end, first_look);
        require_step(from, longest, self.statistics.accepted)?;
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
        (self.to, self.passing) = (to, passing);
        Ok(to)
    }

    fn state_at(&self, time: f64) -> State {
        state(self.of, &self.stepper, time, &self.stepper.variables_at(time))
    }

    fn sample_at(&self, time: f64) -> Result<ContactState, MotionError> {
        sample(self.of, &self.stepper, time, &self.stepper.variables_at(time))
    }

    fn cut(&mut self, time: f64) -> State {
        self.to = time;
        self.state_at(time)
    }

    fn permit(&self, until: f64) -> Result<(), MotionError> {
        match self.stepper.sinks(until) {
            true => Err(MotionError::Undecided { time: self.stepper.time() }),
            false => Ok(()),
        }
    }

    fn take(&mut self) {
        let is_collocation = self.stepper.is_collocation();
        self.has_collocated |= is_collocation;
        self.has_expanded |= !is_collocation;
        self.stepper.advance(self.to - self.stepper.time(), self.to);
        self.statistics.accepted += 1;
        let work = self.stepper.take_work();
        self.statistics.evaluations += work.evaluations;
        self.statistics.rejected += work.rejected;
    }

    fn finish(&mut self, _: f64) -> Result<Option<ContactChange>, MotionError> {
        let passed = self.passing.map(|passing| passing.watch).or_else(|| self.stepper.exhausted());
        let Some(passed) = passed else { return Ok(None) };
        if self.changes.len() == MOST_EVENTS {
            return Err(MotionError::TooManyEvents { time: self.to, most: MOST_EVENTS });
        }
        self.pass(passed)
    }
}

/// Returns attitude and ω from the variables.
fn state(of: &ContactProblem<'_>, stepper: &Stepper, time: f64, y: &[f64]) -> State {
    let model = &stepper.model;
    let e1 = Direction::<Part>::new(y[0], y[1], y[2]);
    let e3 = Direction::<Part>::new(y[3], y[4], y[5]);
    // The axes of the ground along those of the surface are the rows of `R_ground_surface`.
    let surface_ground: Rotation<Part, Part> = Rotation::from_axes([e1, e3.cross(e1), e3]);
    let attitude = model.in_space * surface_ground.inverse() * model.in_body.inverse();
    let attitude = attitude.continuous_with(of.start.state.attitude);
    State { time, attitude, omega: model.in_body * Vector::new(y[6], y[7], y[8]) }
}

/// Converts a vector from the axes of the surface to those of the body.
fn in_body<Q>(model: &Model, v: [f64; 3]) -> Vector<Q, Body> {
    model.in_body * Vector::<Q, Part>::from_array(v)
}

/// Returns a sample of the body and its contact.
///
/// # Errors
/// [`MotionError::NotFinite`] if one of its numbers is not finite.
fn sample(
    of: &ContactProblem<'_>,
    stepper: &Stepper,
    time: f64,
    y: &[f64],
) -> Result<ContactState, MotionError> {
    let sample = read(of, stepper, time, y);
    let numbers = [sample.kinetic_energy, sample.normal_force, sample.contact.norm(), sample.torque.norm()];
    if numbers.iter().all(|x| x.is_finite()) { Ok(sample) } else { Err(MotionError::NotFinite { time }) }
}

/// Returns a sample of the body and its contact, finite or not.
fn read(of: &ContactProblem<'_>, stepper: &Stepper, time: f64, y: &[f64]) -> ContactState {
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
    ContactState {
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
