//! Distance between two motions.

use core::f64::consts::PI;

use crate::motion::model::state::State;
use crate::motion::model::state::StateError;

/// Bound on the angle, rad, up to which an effect is treated as linear. A larger effect is measured
/// again with a smaller change. Two motions farther apart do not determine the position of a third.
pub(super) const LINEAR: f64 = 0.1;

/// Largest factor by which the error of ω is increased because the attitude error was larger
/// before.
const MOST_RAISED: f64 = 30.0;

/// Distances between the states of two motions, one per state.
#[derive(Clone, Debug, Default)]
pub(super) struct Distance {
    /// Angles between the attitudes, rad.
    attitude: Vec<f64>,
    /// |δω|, rad/s.
    omega: Vec<f64>,
}

impl Distance {
    /// Computes the distances of `states` from `reference`; infinite for missing states.
    pub(super) fn between(reference: &[State], states: &[State]) -> Self {
        let mut states = states.iter();
        let apart = |reference: &State| {
            states.next().map_or((f64::INFINITY, f64::INFINITY), |state| {
                let angle = angle_between(state.attitude.quaternion(), reference.attitude.quaternion());
                (number_or_infinite(angle), number_or_infinite((state.omega - reference.omega).norm()))
            })
        };
        let (attitude, omega) = reference.iter().map(apart).unzip();
        Self { attitude, omega }
    }

    /// Returns the larger of both distances, element by element.
    pub(super) fn worse(self, other: Self) -> Self {
        let worse = |a: Vec<f64>, b: Vec<f64>| a.into_iter().zip(b).map(|(a, b)| a.max(b)).collect();
        Self { attitude: worse(self.attitude, other.attitude), omega: worse(self.omega, other.omega) }
    }

    /// Returns the sum of both distances.
    pub(super) fn plus(self, other: &Self) -> Self {
        let sum = |a: Vec<f64>, b: &[f64]| a.into_iter().zip(b).map(|(a, b)| a + b).collect();
        Self { attitude: sum(self.attitude, &other.attitude), omega: sum(self.omega, &other.omega) }
    }

    /// Sets distances above the linear range to infinity. They cannot be scaled.
    pub(super) fn within_linear(mut self) -> Self {
        for (a, w) in self.attitude.iter_mut().zip(&mut self.omega).filter(|(a, _)| !(**a <= LINEAR)) {
            (*a, *w) = (f64::INFINITY, f64::INFINITY);
        }
        self
    }

    /// Divides the distances by a number.
    pub(super) fn over(mut self, by: f64) -> Self {
        self.attitude.iter_mut().chain(&mut self.omega).for_each(|x| *x /= by);
        self
    }

    /// Returns true if all angles are at most `angle`.
    pub(super) fn is_within(&self, angle: f64) -> bool {
        self.attitude.iter().all(|a| *a <= angle)
    }

    /// Replaces the distances whose angle exceeds `angle` by those of `other`.
    pub(super) fn or_beyond(mut self, angle: f64, other: &Self) -> Self {
        for (k, (a, w)) in self.attitude.iter_mut().zip(&mut self.omega).enumerate() {
            if !(*a <= angle)
                && let (Some(other_a), Some(other_w)) = (other.attitude.get(k), other.omega.get(k))
            {
                (*a, *w) = (*other_a, *other_w);
            }
        }
        self
    }

    /// Extends the distances from the samples with indices `at` to all samples. Between two of them
    /// the larger distance is used.
    pub(super) fn at_all(&self, at: &[usize]) -> Self {
        let mut all = Self::default();
        let values = self.attitude.iter().zip(&self.omega).zip(at);
        for (((&a, &w), &k), ((&next_a, &next_w), &next)) in values.clone().zip(values.skip(1)) {
            all.attitude.push(a);
            all.omega.push(w);
            let between = next - k - 1;
            all.attitude.extend(core::iter::repeat_n(a.max(next_a), between));
            all.omega.extend(core::iter::repeat_n(w.max(next_w), between));
        }
        all.attitude.extend(self.attitude.last());
        all.omega.extend(self.omega.last());
        all
    }

    /// Returns the error at each sample. The attitude error is the largest so far. The error of ω
    /// is increased by the same factor, because both come from the same phase error.
    pub(super) fn relative_to(&self, reference: &[State], floor: StateError) -> Vec<StateError> {
        let mut largest = 0.0_f64;
        let states = reference.iter().zip(self.attitude.iter().zip(&self.omega));
        states
            .map(|(state, (&angle, &delta))| {
                largest = largest.max(angle);
                let raised = if angle > 0.0 { (largest / angle).min(MOST_RAISED) } else { 1.0 };
                let (delta, rate) = (raised * delta, state.omega.norm());
                let omega = if delta == 0.0 { 0.0 } else { known(delta / rate, f64::INFINITY) };
                StateError {
                    attitude: (known(largest, PI) + floor.attitude).min(PI),
                    omega: omega + floor.omega,
                }
            })
            .collect()
    }
}

/// Returns the angle θ of the rotation between two attitudes. The distance of their unit
/// quaternions is 2 sin(θ/4), up to a sign of one of them.
fn angle_between(p: [f64; 4], q: [f64; 4]) -> f64 {
    let distance = |sign: f64| p.iter().zip(q).map(|(p, q)| (p - sign * q) * (p - sign * q)).sum::<f64>();
    let sine = 0.5 * distance(1.0).min(distance(-1.0)).sqrt();
    if sine < 1e-4 { 4.0 * sine } else { 4.0 * libm::asin(sine.min(1.0)) }
}

/// Replaces NaN by infinity. A state beyond the reach of a closed form is NaN and therefore
/// unknown.
const fn number_or_infinite(x: f64) -> f64 {
    if x.is_nan() { f64::INFINITY } else { x }
}

/// Returns the error, or the largest possible error if it exceeds the linear range. Two motions so
/// far apart do not determine the position of a third.
fn known(error: f64, largest: f64) -> f64 {
    if error <= LINEAR { error } else { largest }
}
