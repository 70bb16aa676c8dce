//! What ends a phase: functions that are positive as long as it goes on.

use super::equations::{Kinetics, Pivot, Regime};
use super::law::{ContactLaw, Grip};
use super::model::{GroundForm, Model, SurfaceForm};
use crate::math::algebra::{Components, Field};

/// Which equations hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Touching(Regime, Pivot),
    Flying,
}

/// The two sides of a contact, and the law between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sides<'a> {
    pub(super) model: &'a Model,
    pub(super) law: &'a ContactLaw,
    /// Of a cylinder that lies, if it has ends.
    pub(super) length: Option<f64>,
}

/// A function that is positive as long as a phase goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Watch {
    /// N
    NormalForce,
    /// µₛ² N² − F_t²
    Grip,
    /// |u|
    SlipSpeed,
    /// What N is divided by.
    Inertance,
    /// The rate at which the body turns about the normal, in its sense.
    Turning,
    /// µₚ² N² − τₚ²
    Holding,
    /// |ω_t|
    RollingRate,
    /// How much the rim that is touched is lower than the other one.
    OtherRim,
    /// How much the axis of a rim is off the normal, less what counts as nothing.
    Slope,
    /// (½ N l)² less the square of the torque that keeps the axis level.
    Ends,
    /// The determinant of 1 + r′K.
    Fit,
    /// The distance from the ground.
    Gap,
}

/// The slope of a disk, and the room between curvatures, that counts as none.
const LEAST: f64 = 1e-8;

/// What may end a phase.
pub(super) fn watches(Sides { model, law, length }: Sides<'_>, kind: Kind) -> Vec<Watch> {
    let Kind::Touching(regime, pivot) = kind else { return vec![Watch::Gap] };
    let mut watches = vec![Watch::NormalForce];
    match regime {
        Regime::Rolling if *law.grip() != Grip::NoSlip => watches.push(Watch::Grip),
        Regime::Rolling => {}
        Regime::Sliding => {
            watches.push(Watch::Inertance);
            if model.kinetic != 0.0 {
                watches.push(Watch::SlipSpeed);
            }
        }
    }
    if model.pivoting != 0.0 {
        watches.push(if pivot == Pivot::Held { Watch::Holding } else { Watch::Turning });
    }
    if model.rolling != 0.0 {
        watches.push(Watch::RollingRate);
    }
    if matches!(model.surface, SurfaceForm::Rim { height, .. } if height != 0.0) {
        watches.push(Watch::OtherRim);
    }
    if model.axis_inertia.is_some() && length.is_some() {
        watches.push(Watch::Ends);
    }
    if matches!(model.surface, SurfaceForm::Rim { radius, .. } if radius != 0.0) {
        watches.push(Watch::Slope);
    }
    if model.ground != GroundForm::Plane {
        watches.push(Watch::Fit);
    }
    watches
}

impl Model {
    /// The value of what is watched.
    #[inline(always)]
    pub(super) fn watched<S: Field>(
        &self,
        one: S,
        at: &Kinetics<S>,
        watch: Watch,
        law: &ContactLaw,
        length: Option<f64>,
        pivot: Pivot,
    ) -> S {
        let n = at.normal;
        let (relative, force) = (at.relative, at.normal_force);
        match watch {
            Watch::NormalForce => force,
            Watch::Grip => {
                let most = law.friction().sticking;
                (force * force).times(most * most) - at.tangential.dot(at.tangential)
            }
            Watch::SlipSpeed => at.slip.dot(at.slip).root(),
            Watch::Inertance => at.inertance,
            Watch::Turning => match pivot {
                Pivot::Turning(sense) => relative.dot(n).times(sense),
                Pivot::Held => one,
            },
            Watch::Holding => (force * force).times(self.pivoting * self.pivoting) - at.holding * at.holding,
            Watch::RollingRate => {
                let along = relative - n * relative.dot(n);
                along.dot(along).root()
            }
            Watch::OtherRim => match self.surface {
                SurfaceForm::Rim { height, .. } => n.0[2].times(-height),
                SurfaceForm::Ellipsoid { .. } => one,
            },
            // Of a disk that falls straight over the root goes on through zero.
            Watch::Slope => (n.0[0] * n.0[0] + n.0[1] * n.0[1]).root() - one.times(LEAST),
            Watch::Ends => {
                let half = 0.5 * length.unwrap_or(f64::INFINITY);
                let level = self.leveling(one, at);
                (force * force).times(half * half) - level * level
            }
            Watch::Fit => at.fit,
            Watch::Gap => one,
        }
    }

    /// True of a rim whose axis is along the normal: where it touches the ground, rounding decides.
    pub(super) fn lies_flat(&self, at: &Kinetics<f64>) -> bool {
        let Components([x, y, _]) = at.normal;
        matches!(self.surface, SurfaceForm::Rim { radius, .. } if radius != 0.0) && x.hypot(y) <= LEAST
    }

    /// True where the ground is as curved as the body: rounding decides here too.
    pub(super) fn osculates(&self, at: &Kinetics<f64>) -> bool {
        self.ground != GroundForm::Plane && at.fit <= LEAST
    }

    /// The torque about z × n that keeps the axis of a cylinder level, beside that of a force in its middle.
    #[inline(always)]
    fn leveling<S: Field>(&self, one: S, at: &Kinetics<S>) -> S {
        let force = at.tangential + at.normal * at.normal_force;
        let needed = at.omega_rate.image(&self.inertia) + at.omega.cross(at.omega.image(&self.inertia))
            - at.arm.cross(force);
        let zero = one.times(0.0);
        Components([zero, zero, one]).cross(at.normal).dot(needed)
    }
}
