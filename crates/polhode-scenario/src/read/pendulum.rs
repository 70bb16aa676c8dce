//! `[pendulum]`: a fixed axis that suspends the body.

use std::f64::consts::PI;

use polhode::body::{Finding, Severity};
use polhode::math::Direction;
use polhode::motion::torque::TorqueModel;
use polhode::motion::{Pendulum, Scenario, Suspension, Swing};
use polhode_source::FormatError;
use polhode_source::toml::reader::Table;
use polhode_source::unit::Dimension;

/// Reads `[pendulum]` and adds it to a scenario that is complete otherwise.
pub(crate) fn pendulum(root: &Table<'_>, scenario: Scenario) -> Result<Scenario, FormatError> {
    let Some(value) = root.get("pendulum") else { return Ok(scenario) };
    let table = value.table()?;
    table.allow(&["axis", "amplitude"])?;
    let torques = root.get("torque").map_or(Ok(Vec::new()), |list| list.tables("torque"))?;
    for torque in &torques {
        let model = torque.require("model", "model = \"gravity\"")?;
        if model.string()? != "gravity" {
            return Err(model
                .invalid("\"gravity\": gravity is the only torque on a pendulum")
                .with_hint("leave out this torque, or leave out [pendulum]"));
        }
        if let Some(value) = super::torque::schedule::KEYS.iter().find_map(|key| torque.get(key)) {
            let rule = "left out: a pendulum needs gravity at all times";
            return Err(value
                .invalid(rule)
                .with_hint("leave out the times of this torque, or leave out [pendulum]"));
        }
        if let Some(value) = torque.get("on").filter(|on| on.boolean() == Ok(false)) {
            let rule = "true: a pendulum needs gravity at all times";
            return Err(value.invalid(rule).with_hint("leave out on, or leave out [pendulum]"));
        }
    }
    if torques.is_empty() {
        let hint = "a pendulum needs weight: add [[torque]] with model = \"gravity\" and pivot = [0, 0, 0]";
        return Err(table.missing("torque", "").with_hint(hint));
    }
    let axis = table.require("axis", "axis = [0, 0, 1]")?;
    let amplitude = match table.get("amplitude") {
        None => None,
        Some(value) => match value.positive(Dimension::ANGLE)? {
            angle if angle < PI => Some(angle),
            _ => {
                return Err(value
                    .invalid("below 180 deg")
                    .with_hint("beyond it the body rotates over the top"));
            }
        },
    };
    let direction = Direction::from_array(axis.numbers()?);
    let hung = scenario.suspended_from(Suspension { axis: direction, amplitude });
    let hung = hung.map_err(|e| {
        axis.motion(e)
            .with_hint("gravity must not be along the axis, and the centre of mass must not be on it")
    })?;
    let pendulum = hung.pendulum().and_then(Result::ok);
    let otherwise = pendulum.and_then(|pendulum| swings_otherwise(&hung, &pendulum));
    let leaves = leaves_its_axis(&hung, direction);
    Ok(hung.noting(otherwise).noting(leaves))
}

/// Returns a finding if the run starts with another amplitude than the one stated for the period.
fn swings_otherwise(scenario: &Scenario, pendulum: &Pendulum) -> Option<Finding> {
    /// Relative tolerance for rounding and the printed digits of an angle.
    const TOLERANCE: f64 = 1e-6;
    scenario.run()?;
    let Suspension { axis, amplitude } = scenario.suspension()?;
    let stated = amplitude?;
    let rate = axis.direction()?.dot(scenario.start().omega);
    let starts = match pendulum.swing(pendulum.angle(), rate) {
        Swing::Oscillation { amplitude, .. } if (amplitude - stated).abs() <= TOLERANCE * stated => {
            return None;
        }
        Swing::Oscillation { amplitude, .. } => format!("swings by {}", degrees(amplitude)),
        Swing::Rest => "hangs at rest".to_owned(),
        Swing::Separatrix | Swing::Revolution { .. } => "goes over the top".to_owned(),
    };
    Some(Finding {
        code: "pendulum.amplitude",
        severity: Severity::Warning,
        message: format!(
            "the amplitude of the pendulum is given as {}, but the run {starts}",
            degrees(stated)
        ),
        place: None,
    })
}

/// Formats an angle in degrees, rounded to 1e-6.
fn degrees(angle: f64) -> String {
    format!("{} deg", (angle.to_degrees() * 1e6).round() / 1e6)
}

/// Returns a finding if the body leaves its axis: a run holds it at a point only, so torques may
/// tilt it.
fn leaves_its_axis(scenario: &Scenario, axis: Direction<polhode::math::Body>) -> Option<Finding> {
    /// Angles below this are rounding errors, rad.
    const ROUNDING: f64 = 1e-9;
    scenario.run()?;
    let n = axis.direction()?;
    let rotor = scenario.rotor();
    let omega = polhode::math::AngularVelocity::from_array(n.to_array());
    let along = |v: [f64; 3]| {
        let v = Direction::from_array(v);
        let across = v - n * n.dot(v);
        across.norm() <= ROUNDING * v.norm()
    };
    let start = scenario.start();
    let weightless = |torque: &TorqueModel| along(torque.torque(rotor, &start).to_array());
    let stays = along(rotor.angular_momentum(omega).to_array())
        && along(start.omega.to_array())
        && n.dot(rotor.lever()).abs() <= ROUNDING * rotor.lever().norm()
        && scenario.torques().iter().all(weightless);
    (!stays).then(|| Finding {
        code: "pendulum.axis",
        severity: Severity::Warning,
        message: "the run holds the body only at its pivot, so it will leave the pendulum's axis".to_owned(),
        place: None,
    })
}
