//! Checks of a scenario before it runs.

use super::asked::Mechanism;
use super::scenario::Scenario;
use crate::body::finding::{Finding, Severity};
use crate::math::frame::Body;
use crate::math::vector::Position;
use crate::motion::contact::problem::LOOSEST;
use crate::motion::model::event::EventAction;
use crate::motion::model::torque::{MagneticField, TorqueModel};
use crate::motion::model::wheel::Wheel;

impl Scenario {
    /// Checks the scenario before it runs. Reports gravity, torques and runs without effect, and
    /// energies below the range of f64.
    pub fn check(&self) -> Vec<Finding> {
        let finding = |code, severity, message| Finding { code, severity, message, place: None };
        let mut found = Vec::new();
        let has_gravity = self.torques().iter().any(|torque| matches!(torque, TorqueModel::Gravity(_)));
        // A lever within the rounding of the centre of mass counts as zero.
        let is_balanced = |pivot: Position<Body>| {
            let center = self.body().center_of_mass();
            (center - pivot).norm() <= 1e-14 * (center.norm() + pivot.norm())
        };
        if has_gravity && self.pivot().is_some_and(is_balanced) {
            let message = "the centre of mass is at the pivot: gravity does not turn the body";
            found.push(finding("gravity.balanced", Severity::Info, message.to_owned()));
        }
        let is_still = self.start().omega.norm() == 0.0
            && self.torques().is_empty()
            && self.mechanism() == Mechanism::Rotor
            && self.prescribed().is_none()
            && !self.wheels().iter().any(Wheel::is_driven);
        if is_still && self.run().is_some() {
            let message = "the body starts without spin and nothing turns it";
            found.push(finding("start.rest", Severity::Warning, message.to_owned()));
        }
        if let (Some(_), Some(run)) = (self.ground(), self.run())
            && run.tolerance > LOOSEST
        {
            let message = format!(
                "the tolerance is {:e} a step, not {:e}: what a contact does next depends on signs",
                LOOSEST, run.tolerance
            );
            found.push(finding("run.tolerance", Severity::Info, message));
        }
        let omega = self.start().omega;
        if self.prescribed().is_none() && self.rotor().kinetic_energy_underflows(omega) {
            let message = format!(
                "T at the start is below 2.2e-308 J, the range of numbers with all their digits, and comes out as {:e}: energies, their \
                 drift and all that follows from ω² or L² say nothing. Without torque the motion is that at a greater rate, only slower",
                self.rotor().kinetic_energy(omega)
            );
            found.push(finding("start.underflow", Severity::Warning, message));
        }
        let acts_on_orbit = |torque: &TorqueModel| {
            let torque =
                if let TorqueModel::Scheduled(scheduled) = torque { &scheduled.torque } else { torque };
            match torque {
                TorqueModel::GravityGradient(_) => true,
                TorqueModel::Magnetic(magnetic) => !matches!(magnetic.field, MagneticField::Uniform(_)),
                _ => false,
            }
        };
        if self.orbit().is_some() && self.run().is_some() && !self.torques().iter().any(acts_on_orbit) {
            let message = "no torque depends on the orbit: the gravity gradient is a [[torque]] of its own";
            found.push(finding("orbit.idle", Severity::Info, message.to_owned()));
        }
        found.extend(self.idle_history());
        found.extend(self.flow_left_out());
        let is_switched_on = |k: usize| {
            let action = EventAction::Switch { torque: k, on: true };
            self.events().iter().any(|event| event.action() == action)
        };
        if let Some(&idle) = self.switched_off().iter().find(|&&k| !is_switched_on(k)) {
            let name = self.torque_names().get(idle).cloned().flatten().unwrap_or_default();
            let message = format!("the torque \"{name}\" is off, and no event switches it on");
            found.push(finding("torque.off", Severity::Warning, message));
        }
        found
    }
}
