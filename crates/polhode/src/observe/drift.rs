//! The evidence of a run's own error.

use crate::math::sum::Sum;
use crate::motion::trajectory::{Sample, Solution, Trajectory};

/// How far a computed motion departs from the balances that the true one keeps, at its worst sample.
///
/// The work–energy theorem T(t) − T(0) = W and the impulse–momentum theorem L(t) − L(0) = J hold for every torque;
/// without torque they say that T and L are constant. All are relative to the largest T, |L| or energy among the start and
/// the samples.
///
/// Small drift is necessary for a good solution, not sufficient: a wrong phase along the right polhode shows here
/// as nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// |T(t) − T(0) − W(t)| / max T.
    pub work_energy: f64,
    /// |L(t) − L(0) − J(t)| / max |L|, as vectors in space: the attitude's error shows here too.
    pub momentum: f64,
    /// ||L(t)| − |L(0)|| / max |L|: an error only where there is no torque.
    pub momentum_magnitude: f64,
    /// |E(t) − E(0)| / max(|T|, |U − U(0)|), E = T + U; `None` where a torque has no potential, or there is none.
    pub total_energy: Option<f64>,
    /// max |T(t) − T(0)| / max T: an error only where there is no torque.
    pub kinetic_energy: f64,
}

impl Drift {
    /// The drift of a trajectory since its start; `None` if it has no samples, or was prescribed and so cannot drift.
    pub fn of(trajectory: &Trajectory) -> Option<Self> {
        let (first, samples) = (trajectory.start(), trajectory.samples());
        if samples.is_empty() || matches!(trajectory.solution(), Solution::Prescribed(_)) {
            return None;
        }
        let max = |f: &dyn Fn(&Sample) -> f64| samples.iter().chain([first]).map(f).fold(0.0, f64::max);
        let ratio = |part: f64, whole: f64| if part == 0.0 { 0.0 } else { part / whole };
        let largest_t = max(&|s| s.kinetic_energy);
        let largest_l = max(&|s| s.momentum.norm());
        let l0 = first.momentum;
        let work_energy = max(&|s| {
            let mut sum = Sum::default();
            for term in [s.kinetic_energy, -first.kinetic_energy, -(s.work - first.work)] {
                sum.add(term);
            }
            sum.value().abs()
        });
        let momentum = max(&|s| (s.momentum - l0 - (s.impulse - first.impulse)).norm());
        let magnitude = max(&|s| (s.momentum.norm() - l0.norm()).abs());
        let kinetic = max(&|s| (s.kinetic_energy - first.kinetic_energy).abs());
        let total_energy = first.potential_energy.map(|u0| {
            let rise = |s: &Sample| s.potential_energy.unwrap_or(u0) - u0;
            let departure = max(&|s| (s.kinetic_energy - first.kinetic_energy + rise(s)).abs());
            ratio(departure, largest_t.max(max(&|s| rise(s).abs())))
        });
        Some(Self {
            work_energy: ratio(work_energy, largest_t),
            momentum: ratio(momentum, largest_l),
            momentum_magnitude: ratio(magnitude, largest_l),
            total_energy,
            kinetic_energy: ratio(kinetic, largest_t),
        })
    }
}
