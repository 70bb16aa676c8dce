//! Results of a scenario: its motion, the derivatives of the motion, and its pendulum.

use super::asked::Mechanism;
use super::pendulum::Pendulum;
use super::run::Run;
use super::scenario::Scenario;
use crate::motion::contact::ContactStart;
use crate::motion::error::MotionError;
use crate::motion::model::torque::{TorqueModel, TorqueParameter};
use crate::motion::run::derivatives::TrajectoryDerivatives;
use crate::motion::run::ensemble::Member;
use crate::motion::run::global_error::ErrorEffort;
use crate::motion::run::simulation::Simulation;
use crate::motion::run::trajectory::Trajectory;

impl Scenario {
    /// Computes the motion at the times of the run; `None` without a run.
    ///
    /// # Errors
    /// The errors of [`Simulation::run`].
    pub fn simulate(&self) -> Option<Result<Trajectory, MotionError>> {
        self.simulate_watched(&mut |_| true)
    }

    /// Computes [`Scenario::simulate`] and calls `progress` after each step with the time reached,
    /// s. If `progress` returns `false`, the computation ends.
    ///
    /// # Errors
    /// The errors of [`Simulation::run_watched`].
    pub fn simulate_watched(
        &self,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Option<Result<Trajectory, MotionError>> {
        self.trajectory(|simulation| simulation.run_watched(progress))
    }

    /// Computes [`Scenario::simulate_watched`] with an estimate of the error.
    ///
    /// # Errors
    /// The errors of [`Simulation::run`].
    pub fn simulate_with_error(
        &self,
        effort: ErrorEffort,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Option<Result<Trajectory, MotionError>> {
        self.trajectory(|simulation| simulation.run_with_error(effort, progress))
    }

    /// Computes the derivatives of the motion at the times of the run; `None` without a run.
    ///
    /// # Errors
    /// The errors of [`Simulation::run_with_derivatives_watched`].
    /// [`MotionError::NoMotionDerivatives`] for a prescribed motion.
    pub fn derivatives_watched(
        &self,
        parameters: &[TorqueParameter],
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Option<Result<TrajectoryDerivatives, MotionError>> {
        let run = self.run()?;
        if self.prescribed().is_some() {
            let why = "it is prescribed, whatever the body is";
            return Some(Err(MotionError::NoMotionDerivatives { why, time: self.start().time }));
        }
        Some(self.simulation(run).run_with_derivatives_watched(parameters, progress))
    }

    fn trajectory(
        &self,
        run_by: impl FnOnce(&Simulation<'_>) -> Result<Trajectory, MotionError>,
    ) -> Option<Result<Trajectory, MotionError>> {
        let run = self.run()?;
        if let Some(motion) = self.prescribed() {
            return Some(Trajectory::prescribed(self.rotor(), motion, &run.times));
        }
        Some(run_by(&self.simulation(run)))
    }

    fn simulation<'a>(&'a self, run: &'a Run) -> Simulation<'a> {
        let simulation = match self.mechanism() {
            Mechanism::Rotor => Simulation::new(self.rotor(), self.torques(), self.start(), &run.times),
            Mechanism::Ground(ground) => {
                let start = ContactStart { state: self.start(), at: ground.at, velocity: ground.velocity };
                Simulation::on_ground(self.body(), &ground.contact, start, &run.times)
            }
            Mechanism::Gimbals(gimbals) => {
                Simulation::in_gimbals(self.body(), gimbals, self.start().time, &run.times)
            }
        };
        simulation
            .changing(self.history())
            .switched_off(self.switched_off())
            .events(self.events())
            .event_sides(self.event_sides())
            .method(run.method)
            .tolerance(run.tolerance)
    }

    /// Returns the ensemble member with the same motion.
    ///
    /// ```
    /// use polhode::motion::Ensemble;
    /// use polhode::prelude::*;
    /// use std::num::NonZero;
    /// let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
    /// let body = MassProperties::new(2.0, Position::new(0.0, 0.1, 0.5), inertia)?;
    /// let gravity = TorqueModel::Gravity(UniformGravity::STANDARD);
    /// let scenario = Scenario::new(body).held_at(Position::ZERO)?.with_torques([gravity])?;
    /// let start = |spin| State { omega: AngularVelocity::new(0.3, -0.2, spin), ..scenario.start() };
    /// let members = [3.0, 4.0, 5.0].map(|spin| scenario.clone().starting(start(spin))?.member());
    /// let ensemble = Ensemble::new(members.into_iter().collect::<Result<_, _>>()?)?;
    /// let found = ensemble.at(&[0.5, 1.0], Method::Auto, 1e-13, NonZero::<usize>::MIN)?;
    /// assert!(found.failures.is_empty() && found.states.len() == 6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`MotionError::Exclusive`] for a body on the ground, in gimbals or on a shaft, for changing
    /// mass properties, and for a prescribed motion.
    pub fn member(&self) -> Result<Member, MotionError> {
        let is_there = [
            (
                "contact",
                matches!(self.mechanism(), Mechanism::Ground(_)),
                "its members are free, or held at a point",
            ),
            (
                "gimbals",
                matches!(self.mechanism(), Mechanism::Gimbals(_)),
                "its members are free, or held at a point",
            ),
            ("shaft", self.shaft().is_some(), "its members turn freely"),
            ("prescribed", self.prescribed().is_some(), "what its members do is computed"),
            ("mass_history", self.history().is_some(), "the mass properties of its members stay as they are"),
        ];
        if let Some((part, _, why)) = is_there.into_iter().find(|(_, is_there, _)| *is_there) {
            return Err(MotionError::Exclusive { parts: ["an ensemble", part], why });
        }
        let member = Member::new(self.rotor().clone(), self.torques().to_vec(), self.start());
        Ok(member.switched_off(self.switched_off().to_vec()).watching(self.events().to_vec()))
    }

    /// Returns the pendulum that hangs from the scenario's axis under its gravity; `None` without
    /// an axis or without gravity.
    ///
    /// # Errors
    /// The errors of [`Pendulum::hung`].
    pub fn pendulum(&self) -> Option<Result<Pendulum, MotionError>> {
        let hanging = self.suspension()?;
        let gravity = self.torques().iter().find_map(|torque| match torque {
            TorqueModel::Gravity(gravity) => Some(gravity.acceleration),
            _ => None,
        })?;
        let g = self.start().attitude.inverse() * gravity;
        Some(Pendulum::hung(self.rotor(), hanging.axis, g))
    }
}
