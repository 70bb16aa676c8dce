//! Extrema of a motion.

use polhode::body::Symmetry;
use polhode::math::{AngularMomentum, Body, Direction};
use polhode::motion::{Rotor, Sample, Solution, Trajectory};
use polhode::observe::Drift;

/// Extrema of a motion: over all time for free motion, over the samples otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Extrema {
    /// Smallest and largest |ω|, rad/s.
    pub(super) omega: Option<[f64; 2]>,
    /// Smallest and largest angle between L and the principal axis of the least moment, rad.
    pub(super) from_least: Option<[f64; 2]>,
    /// Smallest and largest angle between L and the principal axis of the greatest moment, rad.
    pub(super) from_greatest: Option<[f64; 2]>,
    /// Largest |N|, N·m.
    pub(super) torque: Option<f64>,
    /// Work–energy error, as in [`Drift::work_energy`].
    pub(super) energy_drift: Option<f64>,
    /// Momentum error, as in [`Drift::momentum`].
    pub(super) momentum_drift: Option<f64>,
}

impl Extrema {
    /// Computes the extrema over the start and the samples of a trajectory.
    pub(super) fn of(rotor: &Rotor, trajectory: &Trajectory, drift: Option<Drift>) -> Self {
        let samples = || std::iter::once(trajectory.start()).chain(trajectory.samples());
        let principal = rotor.principal();
        let from = |k: usize| {
            let axis = principal.axis(k);
            let angle = |s: &Sample| angle(axis, s.state.attitude.inverse() * s.momentum);
            range(samples().filter_map(angle)).filter(|_| is_determined(principal.symmetry(), k))
        };
        let exact =
            matches!(trajectory.solution(), Solution::ClosedForm(polhode::motion::ClosedForm::Free(_)));
        Self {
            omega: range(samples().map(|s| s.state.omega.norm())),
            from_least: from(0),
            from_greatest: from(2),
            torque: range(samples().map(|s| s.torque.norm())).map(|[_, most]| most).filter(|_| !exact),
            energy_drift: drift.map(|drift| drift.work_energy),
            momentum_drift: drift.map(|drift| drift.momentum),
        }
    }
}

/// Returns the angle between an axis and L, rad; `None` if L is zero.
pub(super) fn angle(axis: Direction<Body>, momentum: AngularMomentum<Body>) -> Option<f64> {
    (momentum != AngularMomentum::ZERO).then(|| axis.angle_to(momentum))
}

/// Returns the smallest and largest value; `None` if empty, or if one is not finite.
fn range(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let ends = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
    ends.iter().all(|x| x.is_finite()).then_some(ends)
}

/// Returns true if the tensor determines this extreme axis.
pub(super) const fn is_determined(symmetry: Symmetry, axis: usize) -> bool {
    match symmetry {
        Symmetry::Asymmetric => true,
        Symmetry::Oblate => axis == 2,
        Symmetry::Prolate | Symmetry::Rod => axis == 0,
        Symmetry::Spherical | Symmetry::Point => false,
    }
}
