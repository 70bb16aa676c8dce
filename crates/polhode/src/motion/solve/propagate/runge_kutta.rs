//! DOP853 with error control, compensated summation, and samples between steps.

use std::rc::Rc;

use super::balanced::Balanced;
use super::chart::{self, Chart, N, Y};
use super::dop853::{self, STAGES, Stages};
use super::noise::Noise;
use super::orientation::Orientation;
use super::piece::Piece;
use super::step_statistics::StepStatistics;
use crate::math::frame::{Body, Principal};
use crate::math::sum::two_sum;
use crate::math::vector::{AngularVelocity, Vector};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;

/// Rounding of a torque N, in units of the rate √(N/I) that it causes.
const NOISE: f64 = 16.0 * f64::EPSILON;

/// Adaptive DOP853 for the motion of one body.
///
/// `tolerance` bounds the error of a step: the root mean square of the attitude error (rad) and the
/// relative error of ω. The latter is relative to the largest |ω| so far, but at least to the
/// effect of rounding of the torque.
pub(super) struct RungeKutta<'a> {
    chart: Chart<'a>,
    orientation: Orientation,
    time: f64,
    y: Y,
    /// Rounding errors of the sums, added back in the next step.
    carry: Y,
    k0: Y,
    h: f64,
    tolerance: f64,
    omega_scale: f64,
    /// Effect of the rounding of the torque on ω, rad/s: a lower limit of the error control.
    omega_noise: f64,
    /// Factor of the steps whose length the tolerance does not determine: the first step, and steps
    /// of the largest rotation.
    stretch: f64,
    statistics: StepStatistics,
    last: Option<Step<'a>>,
}

/// Accepted step, with the state at its start.
#[derive(Clone, Debug)]
struct Step<'a> {
    chart: Chart<'a>,
    orientation: Orientation,
    start: f64,
    y: Y,
    carry: Y,
    k0: Y,
}

/// Trial step. Its stages are evaluated one by one, so that torques may be computed elsewhere.
#[derive(Debug)]
pub(super) struct Attempt<'a> {
    chart: Chart<'a>,
    start: f64,
    y: Y,
    stages: Stages<N>,
    h: f64,
    end_time: f64,
    /// Step allowed by the tolerance, s.
    wanted: f64,
    /// Time to the limit that no step crosses, s.
    rest: f64,
    pub(super) was_rejected: bool,
}

/// Result of a trial step.
#[derive(Debug)]
pub(super) struct End {
    increment: Y,
    y: Y,
    /// Factor of the length of the next step.
    factor: f64,
}

impl Attempt<'_> {
    /// Returns the state of stage s.
    pub(super) fn place(&self, s: usize) -> State {
        let (t, y) = self.stages.place(s, self.start, &self.y);
        self.chart.state(t, &y)
    }

    /// Computes the derivative of stage s.
    pub(super) fn evaluate(&mut self, s: usize) {
        let (t, y) = self.stages.place(s, self.start, &self.y);
        self.stages.set(s, self.chart.derivative(t, &y));
    }

    /// Returns the state at the end of the step.
    pub(super) fn end(&self, end: &End) -> State {
        self.chart.state(self.end_time, &end.y)
    }

    /// Returns the state at the end of the step, after all stages.
    pub(super) fn reached(&self) -> State {
        self.chart.state(self.end_time, &sum(&self.y, &self.stages.increment()))
    }
}

impl<'a> RungeKutta<'a> {
    /// Prepares the integration from a state.
    ///
    /// # Errors
    /// [`MotionError::TorqueWithoutInertia`] if the torque cannot be balanced.
    pub(super) fn new(piece: Rc<Piece<'a>>, start: State, tolerance: f64) -> Result<Self, MotionError> {
        let principal = piece.rotor.principal();
        let r = principal.rotation();
        let torque_rate = (piece.largest_torque / principal.moments()[2]).sqrt();
        let chart = Chart { piece, center: start.attitude * r };
        let y = chart::at_center(r.inverse() * start.omega, 0.0, Vector::ZERO);
        chart.require_determined(start.time, &y)?;
        let k0 = chart.derivative(start.time, &y);
        let omega_scale = chart::omega(&y).norm();
        let rate = omega_scale + omega_rate(&k0).norm().sqrt();
        Ok(Self {
            orientation: Orientation::new(chart.center),
            chart,
            time: start.time,
            y,
            carry: [0.0; N],
            k0,
            // 2 % of a radian: the first step is certainly not too long, and the next steps can
            // grow.
            h: if rate > 0.0 { 0.02 / rate } else { f64::INFINITY },
            tolerance,
            omega_scale,
            omega_noise: NOISE * torque_rate,
            stretch: 1.0,
            statistics: StepStatistics { evaluations: 1, ..StepStatistics::default() },
            last: None,
        })
    }

    /// Continues with other acting torques.
    ///
    /// # Errors
    /// Those of [`RungeKutta::new`].
    pub(super) fn change(&mut self, piece: Rc<Piece<'a>>) -> Result<(), MotionError> {
        let torque_rate = (piece.largest_torque / piece.rotor.principal().moments()[2]).sqrt();
        self.omega_noise = self.omega_noise.max(NOISE * torque_rate);
        self.chart.piece = piece;
        self.chart.require_determined(self.time, &self.y)?;
        self.k0 = self.chart.derivative(self.time, &self.y);
        self.statistics.evaluations += 1;
        // The previous step length does not apply to the new torques.
        let rate = chart::omega(&self.y).norm() + omega_rate(&self.k0).norm().sqrt();
        self.h = if rate > 0.0 { self.stretch * 0.02 / rate } else { f64::INFINITY };
        Ok(())
    }

    pub(super) fn time(&self) -> f64 {
        self.time
    }

    /// Returns the next step that the tolerance allows, s.
    pub(super) fn next_step(&self) -> f64 {
        let speed = chart::omega(&self.y).norm();
        if speed > 0.0 { self.h.min(self.stretch * chart::LARGEST_TURN / speed) } else { self.h }
    }

    pub(super) fn statistics(&self) -> StepStatistics {
        self.statistics
    }

    /// Returns the state now, with work and impulse.
    pub(super) fn now(&self) -> Balanced {
        balanced(&self.chart, self.time, &self.y)
    }

    /// Takes one step forward, not beyond `until`.
    ///
    /// # Errors
    /// [`MotionError::StepTooSmall`], [`MotionError::NotFinite`] or
    /// [`MotionError::TorqueWithoutInertia`]. The stepper keeps the last good state.
    pub(super) fn step(&mut self, until: f64) -> Result<(), MotionError> {
        let mut attempt = self.attempt(until)?;
        loop {
            for s in 1..STAGES {
                attempt.evaluate(s);
            }
            let Some(end) = self.judge(&attempt)? else {
                attempt = Attempt { was_rejected: true, ..self.attempt(until)? };
                continue;
            };
            return self.finish(&attempt, &end);
        }
    }

    /// Prepares a trial step, as long as the tolerance allows.
    ///
    /// # Errors
    /// [`MotionError::StepTooSmall`] if the step does not advance the time.
    pub(super) fn attempt(&self, until: f64) -> Result<Attempt<'a>, MotionError> {
        let wanted = self.next_step();
        let rest = until - self.time;
        let h = if wanted >= rest { rest } else { wanted };
        if !(self.time + h > self.time) {
            return Err(MotionError::StepTooSmall { time: self.time, step: h });
        }
        // The rounding of the time belongs to the step.
        let end_time = if wanted >= rest { until } else { self.time + h };
        Ok(Attempt {
            chart: self.chart.clone(),
            start: self.time,
            y: self.y,
            stages: Stages::begin(&self.k0, end_time - self.time),
            h: end_time - self.time,
            end_time,
            wanted,
            rest,
            was_rejected: false,
        })
    }

    /// Returns the result of a trial step, or `None` if its error is too large. Updates the
    /// proposed step length.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] if even a very short step gives NaN or infinity.
    pub(super) fn judge(&mut self, attempt: &Attempt<'a>) -> Result<Option<End>, MotionError> {
        let (stages, h) = (&attempt.stages, attempt.h);
        self.statistics.evaluations += 11;
        let increment = stages.increment();
        let y = sum(&self.y, &increment);
        let error = self.error(stages, &y);
        if error.is_nan() || y.iter().any(|c| !c.is_finite()) {
            if h <= 1e-12 * self.time.abs().max(1e-300) {
                return Err(MotionError::NotFinite { time: self.time });
            }
            self.h = 0.1 * h;
            self.statistics.rejected += 1;
            return Ok(None);
        }
        // Hairer's constants: safety factor 0.9, change between 1/3 and 6, exponent 1/8.
        let factor = (0.9 / error.sqrt().sqrt().sqrt()).clamp(1.0 / 3.0, 6.0);
        if error > 1.0 {
            self.h = h * factor.min(1.0);
            self.statistics.rejected += 1;
            return Ok(None);
        }
        Ok(Some(End { increment, y, factor }))
    }

    /// Accepts a trial step. The torque at its end must be known.
    ///
    /// # Errors
    /// [`MotionError::TorqueWithoutInertia`] if this torque cannot be balanced.
    pub(super) fn finish(&mut self, attempt: &Attempt<'a>, end: &End) -> Result<(), MotionError> {
        let Attempt { chart, h, end_time, wanted, rest, was_rejected, .. } = attempt;
        chart.require_determined(*end_time, &end.y)?;
        let k_end = chart.derivative(*end_time, &end.y);
        let (orientation, carry) = (self.orientation, self.carry);
        let step =
            Step { chart: chart.clone(), orientation, start: self.time, y: self.y, carry, k0: self.k0 };
        self.accept(&end.increment, *end_time, &k_end);
        self.statistics.evaluations += 1;
        self.statistics.accepted += 1;
        // A step shortened by `until` does not limit the next one.
        let grown = h * if *was_rejected { end.factor.min(1.0) } else { end.factor };
        self.h = if wanted >= rest { grown.max(*wanted) } else { grown };
        self.last = Some(step);
        Ok(())
    }

    /// Prepares a shorter step from the start of the last one to a time within it: dense output, as
    /// in [`RungeKutta::at`].
    pub(super) fn shorter(&self, time: f64) -> Option<Attempt<'a>> {
        let Step { chart, start, y, k0, .. } = self.last.as_ref()?;
        let h = time - start;
        Some(Attempt {
            chart: chart.clone(),
            start: *start,
            y: *y,
            stages: Stages::begin(k0, h),
            h,
            end_time: time,
            wanted: h,
            rest: h,
            was_rejected: false,
        })
    }

    /// Returns the state within the last step (dense output), by a shorter step from the same
    /// start.
    ///
    /// Each sample costs eleven evaluations. The standard polynomial of order 7 costs three
    /// evaluations per step, but is less accurate. On Orekit's test (fixtures/free_top.toml, every
    /// order and sign of its rates) its error was up to 57 times the tolerance, and here below 5
    /// times.
    pub(super) fn at(&self, time: f64) -> Balanced {
        let Some(step) = &self.last else { return self.now() };
        let f = |t: f64, y: &Y| step.chart.derivative(t, y);
        let stages = dop853::step(&f, step.start, &step.y, &step.k0, time - step.start);
        balanced(&step.chart, time, &sum(&step.y, &stages.increment()))
    }

    /// Returns to a time within the last step.
    pub(super) fn cut(&mut self, time: f64) {
        let Some(step) = self.last.clone().filter(|_| time != self.time) else { return };
        let f = |t: f64, y: &Y| step.chart.derivative(t, y);
        let increment = dop853::step(&f, step.start, &step.y, &step.k0, time - step.start).increment();
        let end = sum(&step.y, &increment);
        let k_end = f(time, &end);
        (self.orientation, self.y, self.carry) = (step.orientation, step.y, step.carry);
        self.chart = step.chart.clone();
        self.accept(&increment, time, &k_end);
        self.statistics.evaluations += 12;
    }

    /// Multiplies the lengths of the steps that the tolerance does not determine.
    pub(super) fn stretch(&mut self, factor: f64) {
        self.h *= factor;
        self.stretch = factor;
    }

    /// Perturbs the state at the end of the last step.
    pub(super) fn perturb(&mut self, noise: &mut Noise) {
        let Some(last) = &self.last else { return };
        let (before, after) = (chart::omega(&last.y).to_array(), chart::omega(&self.y).to_array());
        self.orientation.turn(Vector::from_array(noise.turn(self.time - last.start, before, after)));
        self.chart.center = self.orientation.rotation();
        for (y, more) in self.y[3..6].iter_mut().zip(noise.rate(before, after)) {
            *y += more;
        }
        self.k0 = self.chart.derivative(self.time, &self.y);
    }

    /// Adds a jump to ω, body axes. [`RungeKutta::change`] must follow.
    pub(super) fn kick(&mut self, more: AngularVelocity<Body>) {
        let more = self.chart.piece.rotor.principal().rotation().inverse() * more;
        for (y, more) in self.y[3..6].iter_mut().zip(more.to_array()) {
            *y += more;
        }
    }

    /// Moves to the end of the step, and recentres the chart there.
    fn accept(&mut self, increment: &Y, time: f64, k_end: &Y) {
        let mut y = self.y;
        for (i, dy) in increment.iter().enumerate() {
            (y[i], self.carry[i]) = two_sum(self.y[i], dy + self.carry[i]);
        }
        self.orientation.turn(chart::theta(&y));
        self.chart.center = self.orientation.rotation();
        self.time = time;
        self.y = chart::at_center(chart::omega(&y), chart::work(&y), chart::impulse(&y));
        self.carry[..3].fill(0.0);
        self.omega_scale = self.omega_scale.max(chart::omega(&y).norm());
        // In the new chart θ = 0 and θ̇ is the rate of rotation; the other rates do not depend on
        // the chart.
        self.k0 = *k_end;
        self.k0[..3].copy_from_slice(&self.chart.turning(time, chart::omega(&y)).to_array());
    }

    /// Returns the error divided by the tolerance; the step is accepted if this is at most 1.
    fn error(&self, stages: &Stages<N>, end: &Y) -> f64 {
        let scale = self.omega_scale.max(chart::omega(end).norm());
        let squared = |e: &Y| {
            let attitude = chart::angle(e) / self.tolerance;
            let omega = omega_rate(e).norm();
            let omega = if omega == 0.0 { 0.0 } else { omega / (scale * self.tolerance + self.omega_noise) };
            0.5 * (attitude * attitude + omega * omega)
        };
        let (e5, e3) = stages.errors();
        let (e5, e3) = (squared(&e5), squared(&e3));
        if e5 == 0.0 { 0.0 } else { e5 / (e5 + 0.01 * e3).sqrt() }
    }
}

fn sum(y: &Y, dy: &Y) -> Y {
    core::array::from_fn(|i| y[i] + dy[i])
}

fn balanced(chart: &Chart<'_>, time: f64, y: &Y) -> Balanced {
    Balanced { state: chart.state(time, y), work: chart::work(y), impulse: chart::impulse(y) }
}

/// Returns the ω part of a derivative or of an error.
fn omega_rate(dy: &Y) -> AngularVelocity<Principal> {
    chart::omega(dy)
}

impl core::fmt::Debug for RungeKutta<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("RungeKutta").field("time", &self.time).field("h", &self.h).finish_non_exhaustive()
    }
}
