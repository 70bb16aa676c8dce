//! Flight after the body has left the ground: the centre of mass falls, and the body turns
//! torque-free.

use super::equations::{AXES, OMEGA};
use super::model::{GroundForm, Model, SurfaceForm};
use crate::math::algebra::{Components, Field};

/// Indices of the variables of a flight: e₁, e₃, ω; centre of mass along the axes of the ground,
/// and its velocity; work of friction and of the ground.
pub(super) const CENTER: usize = 9;
pub(super) const CENTER_RATE: usize = 12;
pub(super) const COUNT: usize = 17;

impl Model {
    /// True if the distance of the flying body from the ground can be computed.
    pub(super) fn may_fly(&self) -> bool {
        let is_ball = matches!(self.surface, SurfaceForm::Rim { radius: 0.0, .. });
        let is_thick = matches!(self.surface, SurfaceForm::Rim { height, .. } if height != 0.0);
        self.axis_inertia.is_none() && !is_thick && (self.ground == GroundForm::Plane || is_ball)
    }

    /// Returns the rates of the variables, and the distance from the ground.
    pub(super) fn flight<S: Field>(&self, one: S, y: &[S]) -> (Vec<S>, S) {
        let vector = |k: usize| Components([y[k], y[k + 1], y[k + 2]]);
        let (e1, e3, omega) = (vector(AXES), vector(AXES + 3), vector(OMEGA));
        let turned = (-omega.cross(omega.image(&self.inertia))).image(&self.inverse_inertia);
        let zero = one.times(0.0);
        let falling = self.gravity.map(|g| one.times(g));
        let mut rates: Vec<S> = [e1.cross(omega), e3.cross(omega), turned].iter().flat_map(|v| v.0).collect();
        rates.extend(vector(CENTER_RATE).0);
        rates.extend(falling);
        rates.extend([zero, zero]);
        (rates, self.gap(one, y))
    }

    /// Returns the distance of the body from the ground.
    fn gap<S: Field>(&self, one: S, y: &[S]) -> S {
        let vector = |k: usize| Components([y[k], y[k + 1], y[k + 2]]);
        let (e1, e3, center) = (vector(AXES), vector(AXES + 3), vector(CENTER));
        let offset = Components(self.offset.map(|x| one.times(x)));
        let along = |v: Components<S>| Components([e1.dot(v), e3.cross(e1).dot(v), e3.dot(v)]);
        match self.ground {
            GroundForm::Plane => {
                let lowest = offset + self.surface.point(one, e3);
                center.0[2] + e3.dot(lowest)
            }
            GroundForm::Sphere { radius } | GroundForm::Cylinder { radius } => {
                let Components([x, y, z]) = center + along(offset);
                let across = if matches!(self.ground, GroundForm::Sphere { .. }) {
                    x * x + y * y + z * z
                } else {
                    x * x + y * y
                };
                // Inside: ρ − a − |c|. Outside, where ρ is negative: |c| + ρ − a.
                let from_axis = across.root().times(-radius.signum());
                let tube = match self.surface {
                    SurfaceForm::Rim { tube, .. } => tube,
                    SurfaceForm::Ellipsoid { .. } => f64::NAN,
                };
                from_axis + one.times(radius - tube)
            }
        }
    }
}
