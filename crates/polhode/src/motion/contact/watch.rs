//! Watched functions, which are positive while a phase lasts.

use super::equations::{Kinetics, Pivot, Regime};
use super::law::{ContactLaw, Grip};
use super::model::{GroundForm, Model, SurfaceForm};
use crate::math::algebra::{Components, Field};

/// Kind of a phase, which selects the equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Touching(Regime, Pivot),
    Flying,
}

/// Both sides of a contact, and the law between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sides<'a> {
    pub(super) model: &'a Model,
    pub(super) law: &'a ContactLaw,
    /// Length of a lying cylinder, if it is finite.
    pub(super) length: Option<f64>,
}

/// Function that is positive while a phase lasts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Watch {
    /// Normal force N.
    NormalForce,
    /// Margin of static friction, µₛ² N² − `F_t`².
    Grip,
    /// Slip speed |u|.
    SlipSpeed,
    /// Divisor of N.
    Inertance,
    /// Signed rate of turning about the normal.
    Turning,
    /// Margin of pivoting friction, µₚ² N² − τₚ².
    Holding,
    /// Rolling rate |`ω_t`|.
    RollingRate,
    /// Height of the other rim above the rim in contact.
    OtherRim,
    /// Inclination of a rim's axis to the normal, minus the threshold of zero.
    Slope,
    /// (½ N l)² minus the square of the torque that keeps the axis level.
    Ends,
    /// Determinant of 1 + r′K.
    Fit,
    /// Distance from the ground.
    Gap,
}

/// Threshold of zero for the slope of a disk and for the difference of curvatures.
const LEAST: f64 = 1e-8;

/// Returns the functions that may end a phase.
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
    /// Returns the value of a watched function.
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
            // For a disk that falls straight over, the root continues through zero.
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

    /// True if a rim's axis is along the normal. Then rounding determines the point of contact.
    pub(super) fn lies_flat(&self, at: &Kinetics<f64>) -> bool {
        let Components([x, y, _]) = at.normal;
        matches!(self.surface, SurfaceForm::Rim { radius, .. } if radius != 0.0) && x.hypot(y) <= LEAST
    }

    /// True if the curvatures of ground and body agree. Then rounding determines the point of
    /// contact.
    pub(super) fn osculates(&self, at: &Kinetics<f64>) -> bool {
        self.ground != GroundForm::Plane && at.fit <= LEAST
    }

    /// Returns the torque about z × n that keeps the axis of a cylinder level, in addition to that
    /// of a central force.
    #[inline(always)]
    fn leveling<S: Field>(&self, one: S, at: &Kinetics<S>) -> S {
        let force = at.tangential + at.normal * at.normal_force;
        let needed = at.omega_rate.image(&self.inertia) + at.omega.cross(at.omega.image(&self.inertia))
            - at.arm.cross(force);
        let zero = one.times(0.0);
        Components([zero, zero, one]).cross(at.normal).dot(needed)
    }
}
