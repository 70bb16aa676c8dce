//! Drift: violation of conservation laws by a computed motion.

use crate::math::sum::Sum;
use crate::motion::run::sample::Sample;
use crate::motion::run::solution::Solution;
use crate::motion::run::trajectory::Trajectory;

/// Largest violations of the balance laws over the samples of a computed motion.
///
/// The work–energy theorem T(t) − T(0) = W and the impulse–momentum theorem L(t) − L(0) = J hold
/// for every torque. Without torque, T and L are constant. All values are relative to the largest
/// T, |L| or energy among the start and the samples.
///
/// Small drift is necessary for a good solution, but not sufficient: a phase error along the
/// correct polhode is not visible here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// Relative error of the work–energy balance: |T(t) − T(0) − W(t)| / max T.
    pub work_energy: f64,
    /// Relative error of the impulse–momentum balance: |L(t) − L(0) − J(t)| / max (|L|, 2 T/|ω|),
    /// as vectors in space. It includes the error of the attitude.
    pub momentum: f64,
    /// Relative change of |L|: ||L(t)| − |L(0)|| / max |L|. It is an error only without torque.
    pub momentum_magnitude: f64,
    /// Relative change of the total energy E = T + U: |E(t) − E(0)| / max(|T|, |U − U(0)|). `None`
    /// without torque, or if a torque has no potential.
    pub total_energy: Option<f64>,
    /// Relative change of the kinetic energy: max |T(t) − T(0)| / max T. It is an error only
    /// without torque.
    pub kinetic_energy: f64,
}

impl Drift {
    /// Computes the drift of a trajectory since its start. Returns `None` if it has no samples, or
    /// if the motion was prescribed. Also returns `None` for a body on the ground or in gimbals,
    /// whose energy balance includes the work of these ([`Trajectory::energy_drift`]).
    pub fn of(trajectory: &Trajectory) -> Option<Self> {
        let scale = Scale::of(trajectory)?;
        trajectory.samples().iter().map(|sample| scale.departure(sample)).reduce(Self::worse)
    }

    /// Computes the drift at each sample of a trajectory, on the scale of all samples;
    /// [`Drift::of`] returns the largest of each value. `None` in the same cases.
    pub fn at_samples(trajectory: &Trajectory) -> Option<Vec<Self>> {
        let scale = Scale::of(trajectory)?;
        Some(trajectory.samples().iter().map(|sample| scale.departure(sample)).collect())
    }

    /// Returns the larger value of each component.
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

/// Reference sample and scales of the drift.
struct Scale<'a> {
    first: &'a Sample,
    /// Largest T, J, |L|, kg·m²/s, and energy, J.
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
        // L may be zero while the wheels counter-rotate: |I ω| is at least 2 T/|ω|.
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

/// Returns the gain of potential energy, J.
fn rise(sample: &Sample, u0: f64) -> f64 {
    sample.potential_energy.unwrap_or(u0) - u0
}
