//! The evidence of a run's own error.

use crate::math::sum::Sum;
use crate::motion::run::sample::Sample;
use crate::motion::run::solution::Solution;
use crate::motion::run::trajectory::Trajectory;

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
    /// |L(t) − L(0) − J(t)| / max (|L|, 2 T/|ω|), as vectors in space: the attitude's error shows here too.
    pub momentum: f64,
    /// ||L(t)| − |L(0)|| / max |L|: an error only where there is no torque.
    pub momentum_magnitude: f64,
    /// |E(t) − E(0)| / max(|T|, |U − U(0)|), E = T + U; `None` where a torque has no potential, or there is none.
    pub total_energy: Option<f64>,
    /// max |T(t) − T(0)| / max T: an error only where there is no torque.
    pub kinetic_energy: f64,
}

impl Drift {
    /// The drift of a trajectory since its start; `None` if it has no samples, or was prescribed and so cannot drift, or is that of a body on the
    /// ground or in gimbals, whose energy is in balance with what these do ([`Trajectory::energy_drift`]).
    pub fn of(trajectory: &Trajectory) -> Option<Self> {
        let scale = Scale::of(trajectory)?;
        trajectory.samples().iter().map(|sample| scale.departure(sample)).reduce(Self::worse)
    }

    /// The drift at each sample of a trajectory, on the scale of all of them: [`Drift::of`] is the worst of each. `None` where
    /// that is.
    pub fn along(trajectory: &Trajectory) -> Option<Vec<Self>> {
        let scale = Scale::of(trajectory)?;
        Some(trajectory.samples().iter().map(|sample| scale.departure(sample)).collect())
    }

    /// The larger of each.
    fn worse(self, other: Self) -> Self {
        Self {
            work_energy: self.work_energy.max(other.work_energy),
            momentum: self.momentum.max(other.momentum),
            momentum_magnitude: self.momentum_magnitude.max(other.momentum_magnitude),
            total_energy: self.total_energy.zip(other.total_energy).map(|(a, b)| a.max(b)),
            kinetic_energy: self.kinetic_energy.max(other.kinetic_energy),
        }
    }
}

/// What departures are measured from, and relative to.
struct Scale<'a> {
    first: &'a Sample,
    /// The largest T, |L| and energy.
    kinetic: f64,
    momentum: f64,
    energy: Option<f64>,
}

impl<'a> Scale<'a> {
    fn of(trajectory: &'a Trajectory) -> Option<Self> {
        let (first, samples) = (trajectory.start(), trajectory.samples());
        let is_given = matches!(trajectory.solution(), Solution::Prescribed(_));
        let is_held = !trajectory.channels().is_empty();
        if samples.is_empty() || is_given || is_held {
            return None;
        }
        let max = |f: &dyn Fn(&Sample) -> f64| samples.iter().chain([first]).map(f).fold(0.0, f64::max);
        let kinetic = max(&|s| s.kinetic_energy);
        // L may be zero while the body turns and its wheels turn back: |I ω| is at least 2 T/|ω|.
        let carrier = |s: &Sample| {
            let rate = s.state.omega.norm();
            if rate > 0.0 { 2.0 * s.kinetic_energy / rate } else { 0.0 }
        };
        let momentum = max(&|s| s.momentum.norm().max(carrier(s)));
        let energy = first.potential_energy.map(|u0| kinetic.max(max(&|s| rise(s, u0).abs())));
        Some(Self { first, kinetic, momentum, energy })
    }

    fn departure(&self, s: &Sample) -> Drift {
        let ratio = |part: f64, whole: f64| if part == 0.0 { 0.0 } else { part / whole };
        let first = self.first;
        let mut sum = Sum::default();
        for term in [s.kinetic_energy, -first.kinetic_energy, -(s.work - first.work)] {
            sum.add(term);
        }
        let momentum = (s.momentum - first.momentum - (s.impulse - first.impulse)).norm();
        let magnitude = (s.momentum.norm() - first.momentum.norm()).abs();
        let kinetic = s.kinetic_energy - first.kinetic_energy;
        let total_energy = first.potential_energy.zip(self.energy);
        Drift {
            work_energy: ratio(sum.value().abs(), self.kinetic),
            momentum: ratio(momentum, self.momentum),
            momentum_magnitude: ratio(magnitude, self.momentum),
            total_energy: total_energy.map(|(u0, scale)| ratio((kinetic + rise(s, u0)).abs(), scale)),
            kinetic_energy: ratio(kinetic.abs(), self.kinetic),
        }
    }
}

/// How much potential energy has been gained.
fn rise(sample: &Sample, u0: f64) -> f64 {
    sample.potential_energy.unwrap_or(u0) - u0
}
