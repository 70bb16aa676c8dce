//! A run: what is refused, its steps and samples, and how it ends.

use super::equations::{ANGLES, RATES, WORKS};
use super::model::{Model, dot};
use super::sample::GimbalSample;
use super::simulation::GimbalSimulation;
use super::stepper::{Stepper, Variables};
use super::trajectory::GimbalTrajectory;
use crate::math::frame::{Part, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{AngularMomentum, Direction, Vector};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::state::State;
use crate::motion::solve::limits::{LOOSEST_TOLERANCE, MOST_STEPS, TIGHTEST_TOLERANCE};
use crate::motion::solve::propagate::step_statistics::StepStatistics;
use crate::motion::solve::start::require_ascending;

/// What M has on its diagonal, by axis.
const INERTIA: [&str; 3] = [
    "the moment of inertia about the outer axis",
    "the moment of inertia about the inner axis",
    "the moment of inertia about the rotor's axis",
];

impl GimbalSimulation<'_> {
    /// Computes the motion.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for times out of order, a tolerance out of range, an axis that is free and about which nothing has
    /// inertia, and gimbals that lock at the start. Those that lock later end the motion: [`GimbalTrajectory::failure`].
    pub fn run(&self) -> Result<GimbalTrajectory, MotionError> {
        self.run_watched(&mut |_| true)
    }

    /// [`GimbalSimulation::run`]; `progress` is told the time after each step, and `false` ends the work.
    ///
    /// # Errors
    /// As [`GimbalSimulation::run`]; [`MotionError::Stopped`] if `progress` said so.
    pub fn run_watched(
        &self,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<GimbalTrajectory, MotionError> {
        require::finite("the start's time", self.start)?;
        require_ascending(self.start, self.times)?;
        let rule = "between 1e-15 and 0.01";
        let holds = (TIGHTEST_TOLERANCE..=LOOSEST_TOLERANCE).contains(&self.tolerance);
        require::that("the tolerance", self.tolerance, holds, rule)?;
        let model = Model::of(self.body, self.gimbals);
        let stepper = Stepper::new(model, self.tolerance, self.start, self.noise);
        require_movable(&stepper)?;
        let mut run =
            Run { of: self, stepper, base: 0.0, samples: Vec::new(), statistics: StepStatistics::default() };
        run.base = run.base_energy(&run.stepper.variables());
        let start = run.sample(self.start, &run.stepper.variables())?;
        run.finish(start, progress)
    }
}

/// # Errors
/// A parameter's error where an axis that is free has no inertia about it, or two of them turn the same.
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

/// A run on its way.
struct Run<'a> {
    of: &'a GimbalSimulation<'a>,
    stepper: Stepper,
    /// ω₀ · L at the start.
    base: f64,
    samples: Vec<GimbalSample>,
    statistics: StepStatistics,
}

impl Run<'_> {
    /// # Errors
    /// [`MotionError::Stopped`] if `progress` says so.
    fn finish(
        mut self,
        start: GimbalSample,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<GimbalTrajectory, MotionError> {
        while self.next_wanted().is_some_and(|t| t <= self.of.start) {
            self.samples.push(start);
        }
        let end = self.of.times.last().copied().unwrap_or(self.of.start);
        let mut cause = None;
        while self.stepper.time() < end && cause.is_none() {
            cause = self.step(end).err();
            if !progress(self.stepper.time()) {
                return Err(MotionError::Stopped { time: self.stepper.time() });
            }
        }
        if cause.is_some() {
            self.sample_end();
        }
        let last = self.samples.last().map_or(self.of.start, |last| last.state.time);
        let ending = cause.map(|cause| (last, cause));
        let mut samples = self.samples;
        let mut before = start.state.attitude;
        for sample in &mut samples {
            sample.state.attitude = sample.state.attitude.continuous_with(before);
            before = sample.state.attitude;
        }
        Ok(GimbalTrajectory { start, samples, ending, statistics: self.statistics })
    }

    fn step(&mut self, end: f64) -> Result<(), MotionError> {
        let from = self.stepper.time();
        let longest = self.stepper.expand();
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
        let locks = self.stepper.locks(to - from);
        if let Some(after) = locks {
            to = from + after;
        }
        while let Some(t) = self.next_wanted().filter(|&t| t <= to) {
            let sample = self.sample(t, &self.stepper.variables_at(t))?;
            self.samples.push(sample);
        }
        self.stepper.advance(to - from, to);
        self.statistics.accepted += 1;
        self.statistics.evaluations += self.stepper.terms();
        match locks {
            Some(_) => {
                let angle = self.stepper.variables().high[ANGLES + 1];
                Err(MotionError::GimbalLock { time: to, angle })
            }
            None => Ok(()),
        }
    }

    /// The state at which the motion ends, if it is not a sample.
    fn sample_end(&mut self) {
        let time = self.stepper.time();
        if self.samples.last().is_none_or(|last| last.state.time < time)
            && let Ok(sample) = self.sample(time, &self.stepper.variables())
        {
            self.samples.push(sample);
        }
    }

    fn next_wanted(&self) -> Option<f64> {
        self.of.times.get(self.samples.len()).copied()
    }

    /// ω₀ · L
    fn base_energy(&self, at: &Variables) -> f64 {
        dot(self.stepper.model.turning, self.stepper.model.reading(&at.high).momentum)
    }

    /// The attitude of the base.
    fn base_attitude(&self, time: f64) -> Rotation<Space, Space> {
        let turned = self.of.gimbals.base().angular_velocity() * (time - self.of.start);
        Rotation::from_rotation_vector(Direction::from_array(turned.to_array()))
    }

    /// # Errors
    /// [`MotionError::NotFinite`] where a number is not.
    fn sample(&self, time: f64, at: &Variables) -> Result<GimbalSample, MotionError> {
        let (model, high) = (&self.stepper.model, &at.high);
        let reading = model.reading(high);
        let base = self.base_attitude(time);
        // In two words, as an angle may be that of many turns.
        let turn = |k: usize| {
            let axis =
                Direction::<Part>::from_array(core::array::from_fn(|i| if i == k { 1.0 } else { 0.0 }));
            Rotation::turn(axis, high[ANGLES + k]) * Rotation::turn(axis, at.low[ANGLES + k])
        };
        let of_rotor: Rotation<Part, Part> = turn(0) * turn(1) * turn(2);
        let attitude: Attitude = base * model.in_base * of_rotor * model.in_body.inverse();
        let momentum: AngularMomentum<Space> =
            base * (model.in_base * AngularMomentum::<Part>::from_array(reading.momentum));
        let omega = model.in_body * Vector::<_, Part>::from_array(reading.omega);
        let three = |from: usize| [high[from], high[from + 1], high[from + 2]];
        let angles = three(ANGLES);
        let turned = |k: usize| angles[k] - model.axes[k].angle();
        let sample = GimbalSample {
            state: State { time, attitude, omega },
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
