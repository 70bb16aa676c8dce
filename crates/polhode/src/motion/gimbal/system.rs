//! A rotor in its gimbals as a stepwise system: checks, steps and samples.

use core::convert::Infallible;

use super::equations::{ANGLES, RATES, WORKS};
use super::model::{Model, dot};
use super::problem::GimbalProblem;
use super::state::GimbalState;
use super::stepper::{Stepper, Variables};
use crate::math::frame::{Part, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{AngularMomentum, Direction, Vector};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::state::State;
use crate::motion::solve::limits::{require_step, require_tolerance};
use crate::motion::solve::propagate::step_statistics::StepStatistics;
use crate::motion::solve::start::require_ascending;
use crate::motion::solve::system::System;

/// Names of the diagonal elements of M, by axis.
const INERTIA: [&str; 3] = [
    "the moment of inertia about the outer axis",
    "the moment of inertia about the inner axis",
    "the moment of inertia about the rotor's axis",
];

/// Checks that every free axis can move independently.
///
/// # Errors
/// A parameter's error if a free axis has no inertia about it, or if two free axes coincide.
fn require_movable(stepper: &Stepper) -> Result<(), MotionError> {
    let model = &stepper.model;
    let high = stepper.variables().high;
    let inertia = model.dynamics(1.0, &high).inertia;
    for k in (0..3).filter(|&k| model.is_free(k)) {
        require::positive(INERTIA[k], inertia[k][k])?;
    }
    let rule = "off ±90 deg: there the rotor's axis lies along the outer one, and gimbals without inertia are not held apart";
    require::that("the angle of the inner gimbal", high[ANGLES + 1], stepper.least_pivot() > 0.0, rule)
}

/// Integration of a rotor in its gimbals.
pub(in crate::motion) struct InGimbals<'a> {
    of: &'a GimbalProblem<'a>,
    stepper: Stepper,
    /// ω₀ · L at the start, J.
    base: f64,
    pub(in crate::motion) statistics: StepStatistics,
    /// End of the current step, s, and true if the gimbals lock there.
    to: f64,
    locks: bool,
}

impl System for InGimbals<'_> {
    type Sample = GimbalState;
    type Change = Infallible;

    fn time(&self) -> f64 {
        self.stepper.time()
    }

    fn begin(&mut self, end: f64, _: f64) -> Result<f64, MotionError> {
        let from = self.stepper.time();
        let longest = self.stepper.expand();
        require_step(from, longest, self.statistics.accepted)?;
        self.to = if from + longest < end { from + longest } else { end };
        let locks = self.stepper.locks(self.to - from);
        if let Some(after) = locks {
            self.to = from + after;
        }
        self.locks = locks.is_some();
        Ok(self.to)
    }

    fn state_at(&self, time: f64) -> State {
        self.state(time, &self.stepper.variables_at(time))
    }

    fn sample_at(&self, time: f64) -> Result<GimbalState, MotionError> {
        self.sample(time, &self.stepper.variables_at(time))
    }

    fn cut(&mut self, time: f64) -> State {
        self.to = time;
        self.state_at(time)
    }

    fn take(&mut self) {
        self.stepper.advance(self.to - self.stepper.time(), self.to);
        self.statistics.accepted += 1;
        self.statistics.evaluations += self.stepper.terms();
    }

    fn finish(&mut self, _: f64) -> Result<Option<Infallible>, MotionError> {
        if self.locks {
            let angle = self.stepper.variables().high[ANGLES + 1];
            return Err(MotionError::GimbalLock { time: self.to, angle });
        }
        Ok(None)
    }
}

impl<'a> InGimbals<'a> {
    /// Creates the system at its start; also returns the first sample.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if times are out of order, if the
    /// tolerance is out of range, if a free axis has no inertia about it, or if the gimbals are
    /// locked at the start. A later gimbal lock ends the motion ([`MotionError::GimbalLock`]).
    pub(in crate::motion) fn new(of: &'a GimbalProblem<'a>) -> Result<(Self, GimbalState), MotionError> {
        require::finite("the start's time", of.start)?;
        require_ascending(of.start, of.times)?;
        require_tolerance(of.tolerance)?;
        let stepper = Stepper::new(Model::of(of.body, of.gimbals), of.tolerance, of.start, of.noise);
        require_movable(&stepper)?;
        let statistics = StepStatistics::default();
        let system = Self { of, stepper, base: 0.0, statistics, to: of.start, locks: false };
        let base = system.base_energy(&system.stepper.variables());
        let system = Self { base, ..system };
        let start = system.sample_at(of.start)?;
        Ok((system, start))
    }

    /// Returns ω₀ · L, J.
    fn base_energy(&self, at: &Variables) -> f64 {
        dot(self.stepper.model.turning, self.stepper.model.reading(&at.high).momentum)
    }

    /// Returns the attitude of the base.
    fn base_attitude(&self, time: f64) -> Rotation<Space, Space> {
        let turned = self.of.gimbals.base().angular_velocity() * (time - self.of.start);
        Rotation::from_rotation_vector(Direction::from_array(turned.to_array()))
    }

    /// Returns attitude and ω of the rotor, relative to space.
    fn state(&self, time: f64, at: &Variables) -> State {
        let (model, high) = (&self.stepper.model, &at.high);
        // Both words are used, as an angle may contain many turns.
        let turn = |k: usize| {
            let axis =
                Direction::<Part>::from_array(core::array::from_fn(|i| if i == k { 1.0 } else { 0.0 }));
            Rotation::turn(axis, high[ANGLES + k]) * Rotation::turn(axis, at.low[ANGLES + k])
        };
        let of_rotor: Rotation<Part, Part> = turn(0) * turn(1) * turn(2);
        let attitude: Attitude =
            self.base_attitude(time) * model.in_base * of_rotor * model.in_body.inverse();
        let omega = model.in_body * Vector::<_, Part>::from_array(model.reading(high).omega);
        State { time, attitude, omega }
    }

    /// Returns a sample.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] if a number is not finite.
    fn sample(&self, time: f64, at: &Variables) -> Result<GimbalState, MotionError> {
        let (model, high) = (&self.stepper.model, &at.high);
        let reading = model.reading(high);
        let base = self.base_attitude(time);
        let momentum: AngularMomentum<Space> =
            base * (model.in_base * AngularMomentum::<Part>::from_array(reading.momentum));
        let three = |from: usize| [high[from], high[from + 1], high[from + 2]];
        let angles = three(ANGLES);
        let turned = |k: usize| angles[k] - model.axes[k].angle();
        let sample = GimbalState {
            state: self.state(time, at),
            angles,
            rates: three(RATES),
            holding: model.dynamics(1.0, high).holding,
            momentum,
            torque: model.in_body * Vector::<_, Part>::from_array(reading.torque),
            kinetic_energy: reading.kinetic_energy,
            potential_energy: reading.potential_energy,
            spring_energy: (0..3).map(|k| model.axes[k].spring_energy(angles[k])).sum(),
            damping_work: high[WORKS],
            motor_work: high[WORKS + 1],
            torque_work: (0..3).map(|k| model.axes[k].torque() * turned(k)).sum(),
            base_work: self.base_energy(at) - self.base,
        };
        let numbers = sample.rates.iter().chain(&sample.angles).chain(&sample.holding);
        let is_finite = numbers.chain([&sample.kinetic_energy]).all(|x| x.is_finite())
            && sample.torque.is_finite()
            && sample.momentum.is_finite();
        if is_finite { Ok(sample) } else { Err(MotionError::NotFinite { time }) }
    }
}
