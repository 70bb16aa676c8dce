//! A scenario: one body, one motion.

use super::pendulum::Pendulum;
use super::shaft::{CorrectionMass, Reactions, Shaft};
use crate::body::assembly::BodyPart;
use crate::body::finding::Finding;
use crate::body::mass_properties::MassProperties;
use crate::body::particles::Particle;
use crate::math::frame::{Body, Space};
use crate::math::rotation::Attitude;
use crate::math::vector::{Acceleration, Direction, Position, Velocity};
use crate::motion::error::MotionError;
use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::model::event::Event;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::model::wheel::Wheel;
use crate::motion::run::global_error::ErrorEffort;
use crate::motion::run::simulation::Simulation;
use crate::motion::run::trajectory::Trajectory;
use crate::motion::solve::method::Method;

/// One body and one motion, as a scenario file describes them.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// What it is about.
    pub title: Option<String>,
    /// The parts of the body.
    pub parts: Vec<BodyPart>,
    /// All parts together.
    pub body: MassProperties<Body>,
    /// Attitude and ω at t = 0.
    pub start: State,
    /// Velocity of the centre of mass; of the pivot, which does not move, it is zero.
    pub velocity: Velocity<Space>,
    /// The point of the body that is held fixed; `None` for a free body.
    pub pivot: Option<Position<Body>>,
    /// What turns it.
    pub torques: Vec<TorqueModel>,
    /// The names of the torques, of those that have one.
    pub torque_names: Vec<Option<String>>,
    /// Which of the torques, from 0, act only once an event has switched them on.
    pub switched_off: Vec<usize>,
    /// What spins inside it.
    pub wheels: Vec<Wheel>,
    /// What to look out for on the way.
    pub events: Vec<Event>,
    /// A motion that is given instead of computed.
    pub prescribed: Option<Prescribed>,
    /// The axis from which it hangs.
    pub hanging: Option<Hanging>,
    /// The bearings on which it turns; the prescribed motion is their shaft's.
    pub shaft: Option<Mounted>,
    /// For how long and how to compute.
    pub run: Option<Run>,
    /// What was noticed on the way.
    pub findings: Vec<Finding>,
}

/// The fixed axis of a pendulum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hanging {
    /// The axis through the pivot.
    pub axis: Direction<Body>,
    /// The amplitude of its swing, rad; that of the start if `None`.
    pub amplitude: Option<f64>,
}

/// A shaft that turns.
#[derive(Clone, Debug, PartialEq)]
pub struct Mounted {
    /// The body on its line, with its bearings.
    pub shaft: Shaft,
    /// ω at t = 0, rad/s.
    pub rate: f64,
    /// dω/dt, rad/s².
    pub acceleration: f64,
    /// g in space axes, m/s²; zero where weight does not count.
    pub gravity: Acceleration<Space>,
    /// Planes and radii for correction masses, m: none, one or two.
    pub balance: Vec<[f64; 2]>,
}

impl Mounted {
    /// The masses that balance it in its planes; none without a plane.
    ///
    /// # Errors
    /// As [`Shaft::balance_in_planes`].
    pub fn correction_masses(&self) -> Result<Vec<CorrectionMass>, MotionError> {
        Self::corrections(&self.shaft, &self.balance)
    }

    /// The masses that balance a shaft in one plane, or in two, each with its radius, m.
    ///
    /// # Errors
    /// As [`Shaft::balance_in_planes`].
    pub fn corrections(shaft: &Shaft, planes: &[[f64; 2]]) -> Result<Vec<CorrectionMass>, MotionError> {
        match *planes {
            [] => Ok(Vec::new()),
            [[plane, radius]] => Ok(vec![shaft.balance_in_plane(plane, radius)?]),
            [[a, at_a], [b, at_b], ..] => Ok(shaft.balance_in_planes([a, b], [at_a, at_b])?.to_vec()),
        }
    }

    /// What the bearings and the drive do at a rate, with the body's axes standing in space so.
    pub fn reactions(&self, rate: f64, attitude: Attitude) -> Reactions {
        self.shaft.reactions(rate, self.acceleration, attitude.inverse() * self.gravity)
    }
}

/// When to sample a motion, and how to compute it.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Sample times, s, ascending.
    pub times: Vec<f64>,
    /// How to compute it.
    pub method: Method,
    /// Bound on the error of each step: attitude in rad, ω relative.
    pub tolerance: f64,
}

impl Run {
    /// `samples` evenly spaced times from 0 to `duration`, both included.
    pub fn evenly(duration: f64, samples: usize, method: Method, tolerance: f64) -> Self {
        let last = samples.saturating_sub(1).max(1) as f64;
        let times = (0..samples).map(|k| duration * (k as f64 / last)).collect();
        Self { times, method, tolerance }
    }
}

impl Scenario {
    /// The body and the point that it turns about: its centre of mass, or the pivot. Wheels that the body has no room for, which
    /// [`Scenario::simulate`] refuses, are left out.
    pub fn rotor(&self) -> Rotor {
        self.carrier().with_wheels(&self.wheels).unwrap_or_else(|_| self.carrier())
    }

    fn carrier(&self) -> Rotor {
        match self.pivot {
            None => Rotor::free(&self.body),
            Some(pivot) => Rotor::pivoted(&self.body, pivot),
        }
    }

    /// All particles of the body.
    pub fn particles(&self) -> Vec<Particle<Body>> {
        self.parts.iter().flat_map(|part| part.particles.iter().copied()).collect()
    }

    /// True if particles are all that the body is made of.
    pub fn is_all_particles(&self) -> bool {
        self.parts.iter().all(|part| !part.particles.is_empty())
    }

    /// The motion at the times of the run; `None` without a run.
    ///
    /// # Errors
    /// [`MotionError`] as [`Simulation::run`].
    pub fn simulate(&self) -> Option<Result<Trajectory, MotionError>> {
        self.trajectory(|simulation| simulation.run_watched(&mut |_| {}))
    }

    /// [`Scenario::simulate`] with the estimate of its error, telling `progress` the time (s) that an integration has reached after
    /// each step.
    ///
    /// # Errors
    /// [`MotionError`] as [`Simulation::run`].
    pub fn simulate_with_error(
        &self,
        effort: ErrorEffort,
        progress: &mut dyn FnMut(f64),
    ) -> Option<Result<Trajectory, MotionError>> {
        self.trajectory(|simulation| simulation.run_with_error(effort, progress))
    }

    fn trajectory(
        &self,
        run_by: impl FnOnce(&Simulation<'_>) -> Result<Trajectory, MotionError>,
    ) -> Option<Result<Trajectory, MotionError>> {
        let run = self.run.as_ref()?;
        let rotor = match self.carrier().with_wheels(&self.wheels) {
            Ok(rotor) => rotor,
            Err(error) => return Some(Err(error)),
        };
        if let Some(motion) = &self.prescribed {
            return Some(Trajectory::prescribed(&rotor, motion, &run.times));
        }
        Some(run_by(&Simulation {
            rotor: &rotor,
            torques: &self.torques,
            switched_off: &self.switched_off,
            start: self.start,
            events: &self.events,
            times: &run.times,
            method: run.method,
            tolerance: run.tolerance,
        }))
    }

    /// The pendulum that hangs from the scenario's axis under its gravity; `None` without an axis or without gravity.
    ///
    /// # Errors
    /// [`MotionError`] as [`Pendulum::hung`].
    pub fn pendulum(&self) -> Option<Result<Pendulum, MotionError>> {
        let hanging = self.hanging?;
        let gravity = self.torques.iter().find_map(|torque| match torque {
            TorqueModel::Gravity(gravity) => Some(gravity.acceleration),
            _ => None,
        })?;
        let g = self.start.attitude.inverse() * gravity;
        Some(Pendulum::hung(&self.rotor(), hanging.axis, g))
    }
}
