//! Solutions by the equations of Lagrange and Hamilton.
//!
//! A module for each kind of system recognizes it in a scenario, and returns its T and U in symbols
//! with the motion in its coordinates. All else follows from these: `system` has the mechanics,
//! `verify` compares it with the computed motion, `case` makes the document.

mod case;
mod error;
mod euler_angles;
mod fixed_axis;
mod in_symbols;
mod permanent;
mod precession;
mod rolling;
mod system;
mod top;
mod verify;
mod write;

use polhode::motion::torque::TorqueModel;
use polhode::motion::{Ending, Event, EventAction, Mechanism, Scenario, Trajectory};
use polhode_document::Document;

use crate::symbolic::Exact;
use case::Case;
pub use error::LagrangianError;

/// Form of the equations of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formalism {
    /// Lagrange's equations for coordinates and velocities.
    Lagrange,
    /// Hamilton's canonical equations for coordinates and momenta.
    Hamilton,
}

/// Returns the solution of a scenario by Lagrange's or Hamilton's equations: coordinates, T and U,
/// equations of motion, conserved quantities and small oscillations in symbols. The equations are
/// verified along the computed motion.
///
/// ```
/// use polhode::motion::{Run, Suspension};
/// use polhode::prelude::*;
/// use polhode_scenario::report::{Formalism, lagrangian};
/// use polhode_scenario::symbolic::Exact;
/// let body = MassProperties::new(2.0, Position::new(0.3, 0.0, 0.0), InertiaTensor::diagonal([0.1, 0.2, 0.25])?)?;
/// let gravity = UniformGravity { acceleration: Acceleration::new(9.81, 0.0, 0.0) };
/// let pendulum = Scenario::new(body)
///     .held_at(Position::ZERO)?
///     .with_torques([TorqueModel::Gravity(gravity)])?
///     .suspended_from(Suspension { axis: Direction::new(0.0, 0.0, 1.0), amplitude: None })?;
/// let text = lagrangian(&pendulum, Formalism::Lagrange, &Exact::None)?.to_text(100);
/// assert!(text.contains("I θ\u{308} + M g d sin θ = 0"), "{text}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`LagrangianError`] for a scenario that is none of the supported systems, or whose motion cannot
/// be computed.
pub fn lagrangian(
    scenario: &Scenario,
    formalism: Formalism,
    exact: &Exact,
) -> Result<Document, LagrangianError> {
    require_constant(scenario)?;
    let run = scenario.simulate().transpose()?;
    if let Some(Ending::Failed { cause, .. }) = run.as_ref().map(Trajectory::ending) {
        return Err(cause.clone().into());
    }
    recognized(scenario, run.as_ref())?.document(scenario, formalism, exact.symbols())
}

/// Returns the system of a scenario.
fn recognized(scenario: &Scenario, run: Option<&Trajectory>) -> Result<Case, LagrangianError> {
    if let Some(ground) = scenario.ground() {
        return rolling::rolling(scenario, ground, run);
    }
    if let (Some(hanging), Some(pendulum)) = (scenario.suspension(), scenario.pendulum().transpose()?) {
        let axis = hanging.axis.direction().unwrap_or(hanging.axis);
        return fixed_axis::pendulum(scenario, &pendulum, axis, run);
    }
    match scenario.torques() {
        [] => top::free(scenario, run),
        [TorqueModel::Gravity(gravity)] => top::heavy(scenario, gravity, run),
        [TorqueModel::Torsion(wire)] => fixed_axis::torsion_pendulum(scenario, wire, run),
        [torque] => Err(LagrangianError::because(format!("a torque of model {} acts", torque.name()))),
        torques => Err(LagrangianError::because(format!("{} torques act", torques.len()))),
    }
}

/// Refuses motions that are prescribed, and bodies that change or have parts that move.
fn require_constant(scenario: &Scenario) -> Result<(), LagrangianError> {
    let switches = |event: &Event| matches!(event.action(), EventAction::Switch { .. });
    let why = if scenario.shaft().is_some() || scenario.prescribed().is_some() {
        "its motion is prescribed"
    } else if scenario.history().is_some() {
        "the mass properties of the body change"
    } else if matches!(scenario.mechanism(), Mechanism::Gimbals(_)) {
        "the body is in gimbals"
    } else if !scenario.wheels().is_empty() {
        "the body has momentum wheels"
    } else if !scenario.switched_off().is_empty() || scenario.events().iter().any(switches) {
        "events switch its torques"
    } else {
        return Ok(());
    };
    Err(LagrangianError::because(why))
}

#[cfg(test)]
mod tests;
