//! Simulations with derivatives of the motion with respect to its start, the inertia, and
//! parameters of the torques.

use super::derivative_log::{CrossingDerivatives, DerivativeLog};
use super::ending::Ending;
use super::march::March;
use super::rotor_problem::RotorProblem;
use super::simulation::{Problem, Simulation};
use super::turning::Turning;
use crate::motion::error::MotionError;
use crate::motion::model::event::Event;
use crate::motion::model::state_derivatives::StateDerivatives;
use crate::motion::model::torque::TorqueParameter;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::stepper::{Rule, Stepper};

/// Derivatives of a motion at given times.
#[derive(Clone, Debug, PartialEq)]
pub struct TrajectoryDerivatives {
    /// State at each time, and its derivatives with respect to the start and to the inertia.
    pub states: Vec<StateDerivatives>,
    /// Derivatives of θ1 θ2 θ3 ω1 ω2 ω3 with respect to each parameter, for each time.
    pub by_parameters: Vec<Vec<[f64; 6]>>,
    /// Events that happened, in the order of time.
    pub events: Vec<CrossingDerivatives>,
    /// Ending of the motion.
    pub ending: Ending,
}

impl Simulation<'_> {
    /// Computes the motion like [`Simulation::run`], with derivatives.
    ///
    /// The derivatives are with respect to the start, the inertia tensor about the reference point
    /// of the body (for fixed mass and lever), and parameters of torques. They follow from
    /// variational equations, which are expanded in the same Taylor series as the motion. An event
    /// that switches a torque changes the derivatives, because its time depends on the same
    /// quantities.
    ///
    /// # Errors
    /// - The errors of [`Simulation::run`].
    /// - [`MotionError::NotSmooth`] for a torque without a power series.
    /// - [`MotionError::NoParameter`] for an unknown parameter.
    /// - [`MotionError::NoMotionDerivatives`] for a method without derivatives, a rod, changing
    ///   mass properties, and an event without derivatives; also if a torque has no derivatives at
    ///   some state of the motion, or two switches happen simultaneously.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// use polhode::motion::torque::TorqueParameter;
    /// // Spun up from rest by N along z, which is a principal axis: ω = N t/I, so ∂ω/∂N = t/I, ∂ω/∂I = −N t/I².
    /// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
    /// let torques = [TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.5)))];
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
    /// let rotor = Rotor::free(&body);
    /// let parameters = [TorqueParameter { torque: 0, name: "z" }];
    /// let motion = Simulation::new(&rotor, &torques, start, &[4.0]).run_with_derivatives(&parameters)?;
    /// assert!((motion.by_parameters[0][0][5] - 4.0 / 2.5).abs() < 1e-14);
    /// assert!((motion.states[0].by_inertia[5][2] + 0.5 * 4.0 / (2.5 * 2.5)).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run_with_derivatives(
        &self,
        parameters: &[TorqueParameter],
    ) -> Result<TrajectoryDerivatives, MotionError> {
        self.run_with_derivatives_watched(parameters, &mut |_| true)
    }

    /// Like [`Simulation::run_with_derivatives`], with progress reports. `progress` receives the
    /// time (s) after each step; if it returns `false`, the computation stops.
    ///
    /// # Errors
    /// The errors of [`Simulation::run_with_derivatives`], and [`MotionError::Stopped`].
    pub fn run_with_derivatives_watched(
        &self,
        parameters: &[TorqueParameter],
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<TrajectoryDerivatives, MotionError> {
        let time = self.begins();
        let problem = match self.problem()? {
            Problem::Rotor(problem) => problem,
            Problem::Ground(_) => {
                let why = "it is that of a body on the ground";
                return Err(MotionError::NoMotionDerivatives { why, time });
            }
            Problem::Gimbals(_) => {
                let why = "it is that of a rotor in gimbals";
                return Err(MotionError::NoMotionDerivatives { why, time });
            }
        };
        let RotorProblem {
            rotor,
            torques,
            switched_off,
            start,
            events,
            times,
            tolerance,
            method,
            history,
            ..
        } = problem;
        problem.require_possible()?;
        let why_not = |why| Err(MotionError::NoMotionDerivatives { why, time: start.time });
        if history.is_some() {
            return why_not("the mass properties change with time");
        }
        if !matches!(method, Method::Auto | Method::Taylor) {
            return why_not("they are found by Taylor's method");
        }
        if rotor.principal().moments()[0] == 0.0 {
            return why_not("a rod has no inertia about its own line");
        }
        if let Some(why) = events.iter().find_map(Event::roughness) {
            return why_not(why);
        }
        for (torque, model) in torques.iter().enumerate() {
            if let Some(why) = model.model().roughness() {
                return Err(MotionError::NotSmooth { torque, why });
            }
        }
        let parameters =
            parameters.iter().map(|parameter| parameter.of(torques)).collect::<Result<_, _>>()?;
        let stepper =
            Stepper::new(Rule::Taylor, (rotor, None), torques, switched_off, start, tolerance, false)?;
        let stepper = stepper.differentiated(parameters);
        let turning = Turning::new(stepper, events).with_derivatives();
        let first = turning.first(start)?;
        let mut march = March::new(turning, problem.detector(), times);
        let ending = march.run(first, None, progress)?;
        if let Ending::Failed { cause: cause @ MotionError::NoMotionDerivatives { .. }, .. } = ending {
            return Err(cause);
        }
        let DerivativeLog { states, by_parameters, events, .. } =
            march.system.derivatives.unwrap_or_default();
        Ok(TrajectoryDerivatives { states, by_parameters, events, ending })
    }
}
