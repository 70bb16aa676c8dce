//! Trajectories: the motion at given times, by the best method there is.

use super::error::MotionError;
use super::free::FreeMotion;
use super::inverse::Required;
use super::prescribed::Prescribed;
use super::propagate::stepper::{Balanced, StepStatistics, Stepper};
use super::rotor::Rotor;
use super::state::State;
use super::torque::{TorqueModel, total_potential, total_torque};
use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularMomentum, Torque};

/// How to compute a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Method {
    /// A closed form where there is one, DOP853 elsewhere.
    #[default]
    Auto,
    /// A closed form, or an error.
    Exact,
    /// Numerical integration by the Runge–Kutta method of Dormand and Prince, order 8.
    Dop853,
}

impl Method {
    /// The name in scenario files and summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Exact => "exact",
            Self::Dop853 => "dop853",
        }
    }
}

/// The motion of a body at given times, with the evidence of its own error.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    samples: Vec<Sample>,
    solution: Solution,
}

/// How a trajectory was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solution {
    /// In closed form.
    Exact(FreeMotion),
    /// It was given.
    Prescribed(Prescribed),
    /// By numerical integration.
    Integrated {
        /// Bound on the error of each step: attitude in rad, ω relative.
        tolerance: f64,
        /// What it cost.
        statistics: StepStatistics,
    },
}

impl Solution {
    /// The method's name in summaries: `exact`, `prescribed` or `dop853`.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Exact(_) => Method::Exact.name(),
            Self::Prescribed(_) => "prescribed",
            Self::Integrated { .. } => Method::Dop853.name(),
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
        require_ascending(start.time, times)?;
        let torque_free = torques.is_empty();
        let exact = if torque_free {
            FreeMotion::of(rotor, start)
        } else {
            Err(MotionError::NoClosedForm { why: "a torque acts on the body" })
        };
        match (method, exact) {
            (Method::Auto | Method::Exact, Ok(motion)) => Ok(Self::of_free_motion(rotor, motion, times)),
            (Method::Exact, Err(why)) => Err(why),
            _ => Self::integrate(rotor, torques, start, times, tolerance),
        }
    }

    /// A prescribed motion at each of `times` (ascending, s), with the torque that it needs.
    ///
    /// # Errors
    /// [`MotionError::Parameter`] if times are out of order.
    pub fn prescribed(rotor: &Rotor, motion: &Prescribed, times: &[f64]) -> Result<Self, MotionError> {
        require_ascending(f64::NEG_INFINITY, times)?;
        let first = times.first().map(|&t| prescribed_sample(rotor, motion, t));
        let samples = times.iter().map(|&t| {
            let mut sample = prescribed_sample(rotor, motion, t);
            if let Some(first) = first {
                // By the theorems themselves: nothing is integrated here.
                sample.work = sample.kinetic_energy - first.kinetic_energy;
                sample.impulse = sample.momentum - first.momentum;
            }
            sample
        });
        Ok(Self { samples: continuous(samples.collect()), solution: Solution::Prescribed(*motion) })
    }

    /// The motion at each time, in the order of the times.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// How it was found.
    pub const fn solution(&self) -> &Solution {
        &self.solution
    }

    fn of_free_motion(rotor: &Rotor, motion: FreeMotion, times: &[f64]) -> Self {
        let at = |&time: &f64| Balanced { state: motion.at(time), work: 0.0, impulse: AngularMomentum::ZERO };
        let samples = times.iter().map(at).map(|b| sample(rotor, &[], b)).collect();
        Self { samples: continuous(samples), solution: Solution::Exact(motion) }
    }

    fn integrate(
        rotor: &Rotor,
        torques: &[TorqueModel],
        start: State,
        times: &[f64],
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        let mut stepper = Stepper::new(rotor, torques, start, tolerance)?;
        let mut samples = Vec::with_capacity(times.len());
        let mut wanted = times.iter().copied().peekable();
        let end = times.last().copied().unwrap_or(start.time);
        while wanted.next_if(|&t| t <= stepper.time()).is_some() {
            samples.push(sample(rotor, torques, stepper.now()));
        }
        while stepper.time() < end {
            let steps = stepper.statistics().accepted;
            if steps >= MOST_STEPS {
                return Err(MotionError::TooManySteps { time: stepper.time(), steps });
            }
            let step = stepper.step(end)?;
            while let Some(t) = wanted.next_if(|&t| t <= step.end()) {
                let at = if t == step.end() { stepper.now() } else { step.at(t) };
                samples.push(sample(rotor, torques, at));
            }
        }
        let solution = Solution::Integrated { tolerance, statistics: stepper.statistics() };
        Ok(Self { samples: continuous(samples), solution })
    }
}

/// About an hour's work; more is a mistake in the units.
const MOST_STEPS: u64 = 1_000_000_000;

fn sample(rotor: &Rotor, torques: &[TorqueModel], balanced: Balanced) -> Sample {
    let Balanced { state, work, impulse } = balanced;
    Sample {
        state,
        momentum: rotor.angular_momentum_space(&state),
        torque: total_torque(torques, rotor, &state),
        kinetic_energy: rotor.kinetic_energy(state.omega),
        potential_energy: total_potential(torques, rotor, state.attitude),
        work,
        impulse,
    }
}

fn prescribed_sample(rotor: &Rotor, motion: &Prescribed, time: f64) -> Sample {
    let needed = Required::by(rotor, motion, time);
    let balanced = Balanced { state: needed.state, work: 0.0, impulse: AngularMomentum::ZERO };
    Sample { torque: needed.torque, ..sample(rotor, &[], balanced) }
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
