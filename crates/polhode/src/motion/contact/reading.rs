//! Quantities of a sample, computed from the variables.

use super::equations::{AXES, PLACE, Regime};
use super::flight::{CENTER, CENTER_RATE};
use super::model::{GroundForm, Model};
use super::stepper::Stepper;
use super::watch::{Kind, Watch};
use crate::math::algebra::Components;

/// Quantities of a sample. Lengths and forces are along the axes of the surface, the centre of mass
/// along the axes of the ground.
pub(super) struct Reading {
    pub(super) center: [f64; 3],
    pub(super) arm: [f64; 3],
    pub(super) velocity: [f64; 3],
    pub(super) normal: [f64; 3],
    pub(super) slip: [f64; 3],
    pub(super) normal_force: f64,
    pub(super) friction: [f64; 3],
    pub(super) torque: [f64; 3],
}

impl Stepper {
    pub(super) fn reading(&self, y: &[f64]) -> Reading {
        let model = &self.model;
        let Some(mut at) = self.kinetics(y) else {
            return of_flight(model, y);
        };
        // Friction at the moment before slip begins equals the holding force.
        if let (true, Kind::Touching(_, pivot)) = (at.normal_force.is_nan(), self.kind()) {
            at = model.kinetics(1.0, y, Regime::Rolling, pivot);
        }
        let [e1, e2, e3] = at.axes;
        let along = |v: Components<f64>| [e1.dot(v), e2.dot(v), e3.dot(v)];
        let arm = along(at.arm);
        let position = model.ground.position([y[PLACE], y[PLACE + 1], y[PLACE + 2]]);
        let force = at.tangential + at.normal.scaled(at.normal_force);
        Reading {
            center: [0, 1, 2].map(|k| position[k] - arm[k]),
            arm: at.arm.0,
            velocity: at.velocity.0,
            normal: at.normal.0,
            slip: at.slip.0,
            normal_force: at.normal_force,
            friction: at.tangential.0,
            torque: (at.arm.cross(force) + at.resistance).0,
        }
    }

    /// True if a flying body is below the ground at a time of the step: then only rounding lifted
    /// it off.
    pub(super) fn sinks(&self, time: f64) -> bool {
        let is_below = || self.model.flight(1.0, &self.variables_at(time)).1 < -1e-9 * self.size();
        self.kind() == Kind::Flying && is_below()
    }

    /// Returns the watched function that has become too small to continue: the series do not extend
    /// beyond its zero.
    pub(super) fn exhausted(&self) -> Option<Watch> {
        let y = self.variables();
        let watches = self.watches();
        let singular = [Watch::SlipSpeed, Watch::Slope, Watch::Fit, Watch::RollingRate];
        if !watches.iter().any(|watch| singular.contains(watch)) {
            return None;
        }
        let at = self.kinetics(y)?;
        if watches.contains(&Watch::SlipSpeed) && at.slip.dot(at.slip).sqrt() <= self.least_slip(y) {
            return Some(Watch::SlipSpeed);
        }
        if self.model.lies_flat(&at) {
            return Some(Watch::Slope);
        }
        if self.model.osculates(&at) {
            return Some(Watch::Fit);
        }
        let across = at.relative - at.normal.scaled(at.relative.dot(at.normal));
        let is_still = across.dot(across).sqrt() <= 1e-13 * self.rate(y);
        (watches.contains(&Watch::RollingRate) && is_still).then_some(Watch::RollingRate)
    }
}

/// Computes the quantities of a flight. The contact is the point that is nearest to the ground.
fn of_flight(model: &Model, y: &[f64]) -> Reading {
    let vector = |k: usize| Components([y[k], y[k + 1], y[k + 2]]);
    let (e1, e3, center, velocity) = (vector(AXES), vector(AXES + 3), vector(CENTER), vector(CENTER_RATE));
    let e2 = e3.cross(e1);
    let in_body = |Components([a, b, c]): Components<f64>| e1.scaled(a) + e2.scaled(b) + e3.scaled(c);
    let offset = Components(model.offset);
    let middle = center + Components([e1.dot(offset), e2.dot(offset), e3.dot(offset)]);
    let Components([x, y, z]) = middle;
    let normal = match model.ground {
        GroundForm::Plane => e3,
        GroundForm::Sphere { radius } => in_body(middle.scaled(-radius.signum() / x.hypot(y).hypot(z))),
        GroundForm::Cylinder { radius } => {
            in_body(Components([x, y, 0.0]).scaled(-radius.signum() / x.hypot(y)))
        }
    };
    Reading {
        center: center.0,
        arm: (offset + model.surface.point(1.0, normal)).0,
        velocity: in_body(velocity).0,
        normal: normal.0,
        slip: [0.0; 3],
        normal_force: 0.0,
        friction: [0.0; 3],
        torque: [0.0; 3],
    }
}
