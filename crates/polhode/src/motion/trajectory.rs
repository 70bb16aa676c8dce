//! Trajectories: the motion at given times, by the best method there is.

use super::error::MotionError;
use super::free::FreeMotion;
use super::inverse::Required;
use super::prescribed::Prescribed;
use super::propagate::stepper::{Balanced, Rule, StepStatistics, Stepper};
use super::rotor::Rotor;
use super::state::State;
use super::torque::{TorqueModel, total_potential, total_torque};
use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularMomentum, Torque};

/// How to compute a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Method {
    /// A closed form where there is one, Taylor's method elsewhere.
    #[default]
    Auto,
    /// A closed form, or an error.
    Exact,
    /// Numerical integration by Taylor's method, order 20 at the tightest tolerances.
    Taylor,
    /// Numerical integration by the Runge–Kutta method of Dormand and Prince, order 8.
    Dop853,
}

impl Method {
    /// The name in a text for people.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Auto => "the method that suits",
            Self::Exact => "closed form",
            Self::Taylor => "Taylor's method",
            Self::Dop853 => "DOP853",
        }
    }

    /// The name in scenario files and summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Exact => "exact",
            Self::Taylor => "taylor",
            Self::Dop853 => "dop853",
        }
    }
}

/// The motion of a body at given times, with the evidence of its own error.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    start: Sample,
    samples: Vec<Sample>,
    solution: Solution,
}

/// How a trajectory was found.
#[derive(Clone, Debug, PartialEq)]
pub enum Solution {
    /// In closed form.
    Exact(Box<FreeMotion>),
    /// It was given.
    Prescribed(Prescribed),
    /// By numerical integration.
    Integrated {
        /// By which method.
        method: Method,
        /// Bound on the error of each step: attitude in rad, ω relative.
        tolerance: f64,
        /// What it cost.
        statistics: StepStatistics,
    },
}

impl Solution {
    /// The method's name in summaries: `exact`, `prescribed`, `taylor` or `dop853`.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Exact(_) => Method::Exact.name(),
            Self::Prescribed(_) => "prescribed",
            Self::Integrated { method, .. } => method.name(),
        }
    }
}

/// The motion at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Time, attitude and ω.
    pub state: State,
    /// L about the point that the body turns about, space axes, kg·m²/s.
    pub momentum: AngularMomentum<Space>,
    /// The torque about that point, body axes, N·m.
    pub torque: Torque<Body>,
    /// T_rot about that point, J.
    pub kinetic_energy: f64,
    /// Potential energy of all torques, J; `None` if some torque has none.
    pub potential_energy: Option<f64>,
    /// The work that the torque has done since the start, ∫ N · ω dt, J.
    pub work: f64,
    /// The angular impulse of the torque since the start, ∫ N dt, space axes, N·m·s.
    pub impulse: AngularMomentum<Space>,
}

impl Trajectory {
    /// The motion from `start` at each of `times` (ascending, s, none before the start).
    ///
    /// `tolerance` bounds the error of each integration step, attitude in rad and ω relative; closed forms ignore it.
    ///
    /// # Errors
    /// [`MotionError`]: times out of order, no closed form for [`Method::Exact`], or a tolerance out of reach.
    ///
    /// # Example
    /// ```
    /// use polhode::*;
    /// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
    /// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.3, 0.5, 0.9) };
    /// let motion = Trajectory::compute(&body, &[], start, &[0.0, 10.0], Method::Auto, 1e-13)?;
    /// // 50-digit reference: fixtures/free_asymmetric.toml
    /// assert!((motion.samples()[1].state.omega.x - -0.428_074_674_276_547_2).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn compute(
        rotor: &Rotor,
        torques: &[TorqueModel],
        start: State,
        times: &[f64],
        method: Method,
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        Self::compute_watched(rotor, torques, start, times, method, tolerance, &mut |_| {})
    }

    /// [`Trajectory::compute`], telling `watch` the time (s) that the integration has reached after each step.
    ///
    /// # Errors
    /// As [`Trajectory::compute`].
    pub fn compute_watched(
        rotor: &Rotor,
        torques: &[TorqueModel],
        start: State,
        times: &[f64],
        method: Method,
        tolerance: f64,
        watch: &mut dyn FnMut(f64),
    ) -> Result<Self, MotionError> {
        require_ascending(start.time, times)?;
        require_finite(rotor, torques, &start)?;
        let exact = if !torques.is_empty() {
            Err(MotionError::NoClosedForm { why: "a torque acts on the body" })
        } else if !rotor.wheels().is_empty() {
            Err(MotionError::NoClosedForm { why: "wheels spin in the body" })
        } else {
            FreeMotion::of(rotor, start)
        };
        match (method, exact) {
            (Method::Auto | Method::Exact, Ok(motion)) => Self::of_motion(motion, times),
            (Method::Exact, Err(why)) => Err(why),
            _ => {
                let rule = if method == Method::Dop853 { Rule::Dop853 } else { Rule::Taylor };
                Self::integrate(Stepper::new(rule, rotor, torques, start, tolerance)?, start, times, watch)
            }
        }
    }

    /// A prescribed motion at each of `times` (ascending, s), with the torque that it needs.
    ///
    /// # Errors
    /// [`MotionError::Parameter`] if times are out of order; else as [`Required::by`].
    pub fn prescribed(rotor: &Rotor, motion: &Prescribed, times: &[f64]) -> Result<Self, MotionError> {
        require_ascending(f64::NEG_INFINITY, times)?;
        let first = prescribed_sample(rotor, motion, times.first().copied().unwrap_or(0.0))?;
        let mut samples: Vec<Sample> =
            times.iter().map(|&t| prescribed_sample(rotor, motion, t)).collect::<Result<_, _>>()?;
        for sample in &mut samples {
            // By the theorems themselves: nothing is integrated here.
            sample.work = sample.kinetic_energy - first.kinetic_energy;
            sample.impulse = sample.momentum - first.momentum;
        }
        Ok(Self {
            start: first,
            samples: continuous(samples),
            solution: Solution::Prescribed(motion.clone()),
        })
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

    /// A free motion at each of `times` (ascending, s; before its start too).
    ///
    /// # Errors
    /// [`MotionError::Parameter`] if times are out of order, [`MotionError::NotFinite`] where energy or momentum leave the range
    /// of f64.
    pub fn of_motion(motion: FreeMotion, times: &[f64]) -> Result<Self, MotionError> {
        require_ascending(f64::NEG_INFINITY, times)?;
        let samples = motion.at_times(times).into_iter().map(|state| free_sample(&motion, state));
        let samples = samples.collect::<Result<_, _>>()?;
        let start = free_sample(&motion, motion.start())?;
        Ok(Self { start, samples: continuous(samples), solution: Solution::Exact(Box::new(motion)) })
    }

    fn integrate(
        mut stepper: Stepper<'_>,
        start: State,
        times: &[f64],
        watch: &mut dyn FnMut(f64),
    ) -> Result<Self, MotionError> {
        let (rotor, torques) = stepper.subject();
        let mut samples = Vec::with_capacity(times.len());
        let mut wanted = times.iter().copied().peekable();
        let end = times.last().copied().unwrap_or(start.time);
        // The start as it was given, not as it comes back from principal axes.
        let given = sample(rotor, torques, before_work(start))?;
        while wanted.next_if(|&t| t <= start.time).is_some() {
            samples.push(given);
        }
        while stepper.time() < end {
            stepper.step(end)?;
            require_patience(&stepper, end)?;
            watch(stepper.time());
            while let Some(t) = wanted.next_if(|&t| t <= stepper.time()) {
                let at = if t == stepper.time() { stepper.now() } else { stepper.at(t) };
                samples.push(sample(rotor, torques, at)?);
            }
        }
        let method = match stepper.rule() {
            Rule::Taylor => Method::Taylor,
            Rule::Dop853 => Method::Dop853,
        };
        let (tolerance, statistics) = (stepper.tolerance(), stepper.statistics());
        let solution = Solution::Integrated { method, tolerance, statistics };
        Ok(Self { start: given, samples: continuous(samples), solution })
    }
}

/// Minutes of work; more is a mistake in the units.
const MOST_STEPS: u64 = 100_000_000;

/// Steps after which the step has found its size.
const FIRST_STEPS: u64 = 64;

/// Gives up as soon as it can be seen that the end is too many steps away.
fn require_patience(stepper: &Stepper<'_>, end: f64) -> Result<(), MotionError> {
    let (done, step) = (stepper.statistics().accepted, stepper.next_step());
    let left = (end - stepper.time()) / step;
    if done < FIRST_STEPS || done as f64 + left <= MOST_STEPS as f64 {
        return Ok(());
    }
    Err(MotionError::TooManySteps { time: stepper.time(), step, most: MOST_STEPS })
}

fn before_work(state: State) -> Balanced {
    Balanced { state, work: 0.0, impulse: AngularMomentum::ZERO }
}

/// # Errors
/// As [`sample`].
fn free_sample(motion: &FreeMotion, state: State) -> Result<Sample, MotionError> {
    let in_body = motion.angular_momentum(&state);
    finite(Sample {
        state,
        momentum: state.attitude * in_body,
        torque: Torque::ZERO,
        kinetic_energy: 0.5 * state.omega.dot(in_body),
        potential_energy: None,
        work: 0.0,
        impulse: AngularMomentum::ZERO,
    })
}

/// # Errors
/// [`MotionError::NotFinite`] where energy or momentum leave the range of f64.
fn sample(rotor: &Rotor, torques: &[TorqueModel], balanced: Balanced) -> Result<Sample, MotionError> {
    let Balanced { state, work, impulse } = balanced;
    finite(Sample {
        state,
        momentum: rotor.angular_momentum_space(&state),
        torque: total_torque(torques, rotor, &state),
        kinetic_energy: rotor.kinetic_energy(state.omega),
        potential_energy: total_potential(torques, rotor, &state),
        work,
        impulse,
    })
}

fn finite(sample: Sample) -> Result<Sample, MotionError> {
    let Sample { state, .. } = sample;
    let attitude: f64 = state.attitude.quaternion().iter().sum();
    let finite = attitude.is_finite()
        && sample.momentum.is_finite()
        && sample.torque.is_finite()
        && sample.kinetic_energy.is_finite();
    if finite { Ok(sample) } else { Err(MotionError::NotFinite { time: state.time }) }
}

fn prescribed_sample(rotor: &Rotor, motion: &Prescribed, time: f64) -> Result<Sample, MotionError> {
    let needed = Required::by(rotor, motion, time)?;
    let sample = sample(rotor, &[], before_work(needed.state))?;
    Ok(Sample { torque: needed.torque, ..sample })
}

/// q and −q are one attitude: each sample takes the sign nearest to the one before it.
fn continuous(mut samples: Vec<Sample>) -> Vec<Sample> {
    for k in 1..samples.len() {
        samples[k].state.attitude = samples[k].state.attitude.continuous_with(samples[k - 1].state.attitude);
    }
    samples
}

fn require_ascending(start: f64, times: &[f64]) -> Result<(), MotionError> {
    let mut last = start;
    for &value in times {
        if !value.is_finite() || value < last {
            let rule = "finite, and not before the time that precedes it";
            return Err(MotionError::Parameter { what: "the time", value, rule });
        }
        last = value;
    }
    Ok(())
}

/// A start is input: what is wrong with it is not the computation's fault.
fn require_finite(rotor: &Rotor, torques: &[TorqueModel], start: &State) -> Result<(), MotionError> {
    let (energy, momentum) = (rotor.kinetic_energy(start.omega), rotor.angular_momentum(start.omega).norm());
    for (what, value) in [
        ("the start's time", start.time),
        ("the start's attitude", start.attitude.quaternion().iter().sum()),
        ("the start's angular velocity", start.omega.norm()),
        ("the start's kinetic energy", energy),
        ("the start's angular momentum", momentum),
        ("the torque", torques.iter().map(|torque| torque.scale(rotor, start)).sum()),
    ] {
        if !value.is_finite() {
            return Err(MotionError::Parameter { what, value, rule: "finite" });
        }
    }
    Ok(())
}
