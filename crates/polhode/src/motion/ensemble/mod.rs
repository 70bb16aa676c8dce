//! Many bodies, each with its own start and its own torques, at the same times.

use super::error::MotionError;
use super::rotor::Rotor;
use super::state::State;
use super::torque::TorqueModel;

/// A body of an ensemble, and its motion.
#[derive(Clone, Debug)]
pub struct Member {
    /// The body and the point that it turns about.
    pub rotor: Rotor,
    /// What turns it.
    pub torques: Vec<TorqueModel>,
    /// Where it starts.
    pub start: State,
}

/// How to compute the motions of an ensemble.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Advance {
    /// The best for each: a closed form, else Taylor's method, else DOP853.
    Auto {
        /// As [`Simulation::tolerance`](super::simulation::Simulation::tolerance).
        tolerance: f64,
    },
    /// Steps of the classical Runge–Kutta method, all of one length: as accurate as the step is short.
    RungeKutta4 {
        /// The step, s; the last before each time may be shorter.
        step: f64,
    },
}

/// Where the members of an ensemble were at some times.
#[derive(Clone, Debug, PartialEq)]
pub struct Flights {
    /// Member by member, and time by time within each. A member that could go no further stays at its last good state: the state's own
    /// time says so.
    pub states: Vec<State>,
    /// Those that could go no further, ascending.
    pub failures: Vec<Failure>,
}

/// Why a member could go no further.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The member, from 0.
    pub member: usize,
    /// The cause.
    pub cause: MotionError,
}
