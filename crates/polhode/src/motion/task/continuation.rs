//! Continuation of a motion from its end.

use super::asked::Mechanism;
use super::run::Run;
use super::scenario::Scenario;
use crate::motion::error::MotionError;
use crate::motion::model::event::{Event, EventAction};
use crate::motion::run::ending::Ending;
use crate::motion::run::trajectory::Trajectory;

impl Scenario {
    /// Continues the scenario from the end of its motion, which an event may have stopped, with new
    /// sample times.
    ///
    /// The same torques are switched on, and the motion is on the same side of each event's value.
    /// Both motions together equal one uninterrupted motion, except for rounding and step errors.
    /// Work, impulse and the error estimate start again from zero.
    ///
    /// ```
    /// use polhode::motion::{Run, Scenario};
    /// use polhode::prelude::*;
    /// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
    /// let torque = TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.5)));
    /// let scenario = Scenario::new(body).with_torques([torque])?.sampled(Run::evenly(2.0, 3, Method::Auto, 1e-13));
    /// let first = scenario.simulate().ok_or("it has a run")??;
    /// let second = scenario.continued_after(&first, vec![2.0, 10.0])?.simulate().ok_or("it has a run")??;
    /// assert!((second.samples()[1].state.omega.z - 0.5 * 10.0 / 2.5).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`MotionError::NotContinued`] if the motion failed, or for a body on the ground or in
    /// gimbals, whose state is more than attitude and ω. The errors of
    /// [`MassHistory::at`](crate::motion::MassHistory::at).
    pub fn continued_after(&self, motion: &Trajectory, times: Vec<f64>) -> Result<Self, MotionError> {
        let none = |why| Err(MotionError::NotContinued { why });
        match self.mechanism() {
            Mechanism::Ground(_) => {
                return none(
                    "it is that of a body on the ground, whose state is more than its attitude and ω",
                );
            }
            Mechanism::Gimbals(_) => {
                return none("it is that of a rotor in gimbals, whose state is more than its attitude and ω");
            }
            Mechanism::Rotor => {}
        }
        if matches!(motion.ending(), Ending::Failed { .. } | Ending::Contact { .. }) {
            return none("it could not be computed further");
        }
        let Some(run) = self.run() else { return none("the scenario has no [run]") };
        let Some(last) = motion.samples().last() else { return none("it has no samples") };
        let continued = self.clone().sampled(Run { times, ..run.clone() });
        if self.prescribed().is_some() {
            return Ok(continued);
        }
        let mut switched_off = self.switched_off().to_vec();
        for crossing in motion.events() {
            if let Some(EventAction::Switch { torque, on }) =
                self.events().get(crossing.event).map(Event::action)
            {
                switched_off.retain(|&k| k != torque);
                if !on {
                    switched_off.push(torque);
                }
            }
        }
        switched_off.sort_unstable();
        let continued = continued.starting(last.state)?.changed(|task| {
            task.switched_off = switched_off;
            task.event_sides = motion.event_sides().to_vec();
        });
        match self.history() {
            None => Ok(continued),
            Some(history) => continued.changing(history.clone()),
        }
    }
}
