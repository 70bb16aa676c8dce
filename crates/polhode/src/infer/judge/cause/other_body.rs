//! Estimation of the inertia tensor that the run implies.

use super::law::{BodyVector, Law};
use super::name::Cause;
use super::rows::Window;
use super::trial::Trials;
use crate::body::inertia::InertiaTensor;
use crate::math::frame::{Body, Space};
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Direction;
use crate::motion::model::state::State;

/// Maximum number of rows over which the torque is integrated.
const SUMMED: usize = 4096;

/// Smallest relevant difference of a tensor, relative to its largest moment; a smaller one is the
/// error of a method.
const NOTICED: f64 = 0.01;

/// Ridge term relative to the sum of squares; it keeps elements that the motion does not determine
/// close to those of the scenario.
const RIDGE: f64 = 1e-10;

/// Weight of the trace if the motion determines only ratios.
const TRACE: f64 = 1e3;

/// Smallest relevant difference, and the largest remaining fraction of the error for which it
/// applies.
const NOTICED_OF_ALL: [f64; 2] = [1e-3, 1e-3];

/// Number of iterations of the fit to the attitudes.
const ROUNDS: usize = 6;

impl Trials<'_> {
    /// Tries the tensor with which the body would move like the run. First, the tensor for which
    /// R I ω + R h − ∫ R N dt is constant along the run, by least squares; then the tensor whose
    /// motion is closest to the run's attitudes.
    pub(super) fn try_other_tensor(&mut self) {
        let law = self.law.clone();
        let has_scale = law.torque_count() > 0 || law.has_wheels();
        // An impossible tensor indicates that the wheels or a torque are wrong, not the tensor.
        let possible = |tensor: &Symmetric3| InertiaTensor::<Body>::from_symmetric(*tensor).is_ok();
        let begun = implied(&self.window, &law, has_scale).filter(possible);
        let count = self.tried.len();
        // If a cause already explains the run, no other tensor is fitted to the attitudes.
        let is_open = !self.tried.iter().any(|tried| tried.passes);
        let nearest = is_open.then(|| self.nearest(begun.unwrap_or(*law.tensor()), has_scale)).flatten();
        for tensor in [begun, nearest] {
            let Some(tensor) = tensor.filter(possible) else { continue };
            let difference = (tensor + *law.tensor() * -1.0).max_abs() / law.tensor().max_abs();
            self.try_law(Cause::OtherTensor { tensor: tensor.rows(), has_scale }, &law.with_tensor(tensor));
            if let Some(tried) = self.tried.last_mut() {
                let [least, left] = NOTICED_OF_ALL;
                let explains_all = 1.0 - tried.explained <= left && difference > least;
                tried.passes &= difference > NOTICED || explains_all;
            }
        }
        let best = self.tried.drain(count..).min_by(|a, b| a.score.total_cmp(&b.score));
        self.tried.extend(best);
    }

    /// Returns the tensor whose motion from the same start is closest to the run's attitudes, by
    /// the Gauss–Newton method.
    fn nearest(&self, begun: Symmetric3, has_scale: bool) -> Option<Symmetric3> {
        let scale = 1e-4 * self.law.tensor().max_abs();
        let mut tensor = begun;
        for _ in 0..ROUNDS {
            let differences = |tensor: Symmetric3| {
                let states = self.motion(&self.law.with_tensor(tensor));
                (states.len() == self.rows.times.len()).then(|| self.rows.differences(&states))
            };
            let here = differences(tensor)?;
            let slopes = (0..6)
                .map(|k| {
                    let there = differences(tensor + unit(k) * scale)?;
                    Some(there.iter().zip(&here).map(|(there, here)| there - here).collect::<Vec<f64>>())
                })
                .collect::<Option<Vec<_>>>()?;
            let mut normal = [[0.0; 7]; 6];
            for (i, line) in normal.iter_mut().enumerate() {
                let along = |other: &[f64]| slopes[i].iter().zip(other).map(|(a, b)| a * b).sum::<f64>();
                line.iter_mut().zip(&slopes).for_each(|(element, other)| *element = along(other));
                line[6] = -along(&here);
            }
            let change = Symmetric3::from_elements(solved(kept(normal, has_scale))?) * scale;
            tensor = tensor + change;
            if change.max_abs() < 1e-9 * tensor.max_abs() {
                break;
            }
        }
        Some(tensor)
    }
}

/// Returns the symmetric matrix with 1 at one element.
fn unit(k: usize) -> Symmetric3 {
    let mut elements = [0.0; 6];
    elements[k] = 1.0;
    Symmetric3::from_elements(elements)
}

/// Adds regularisation for what the motion does not determine: the trace if only ratios are
/// determined, and elements without effect.
fn kept(mut normal: [[f64; 7]; 6], has_scale: bool) -> [[f64; 7]; 6] {
    let whole: f64 = (0..6).map(|k| normal[k][k]).sum();
    for (k, line) in normal.iter_mut().enumerate() {
        line[k] += RIDGE * whole;
        if k < 3 && !has_scale {
            line.iter_mut().take(3).for_each(|element| *element += TRACE * whole);
        }
    }
    normal
}

fn implied(window: &Window<'_>, law: &Law<'_>, has_scale: bool) -> Option<Symmetric3> {
    let states = window.states(SUMMED);
    let units: [Symmetric3; 6] = core::array::from_fn(unit);
    let space = |state: &State, v: BodyVector| -> Direction<Space> { state.attitude * v };
    // The unknown is the difference from the scenario's tensor: six columns, and the right-hand
    // side.
    let mut rows: Vec<[Direction<Space>; 7]> = Vec::with_capacity(states.len());
    let mut impulse = Direction::<Space>::ZERO;
    let mut before: Option<(f64, Direction<Space>)> = None;
    for state in &states {
        let torque = space(state, law.outer_torque(state));
        if let Some((time, last)) = before {
            impulse += (torque + last) * (0.5 * (state.time - time));
        }
        before = Some((state.time, torque));
        let momentum =
            |tensor: &Symmetric3| space(state, BodyVector::from_array(tensor.apply(state.omega.to_array())));
        let known = momentum(law.tensor()) + space(state, law.wheel_momentum(state.time));
        let [a, b, c, d, e, f] = units.each_ref().map(momentum);
        rows.push([a, b, c, d, e, f, impulse - known]);
    }
    let count = rows.len() as f64;
    let mean: [Direction<Space>; 7] =
        core::array::from_fn(|k| rows.iter().fold(Direction::ZERO, |sum, row| sum + row[k]) * (1.0 / count));
    let mut normal = [[0.0; 7]; 6];
    for row in &rows {
        let centred: [Direction<Space>; 7] = core::array::from_fn(|k| row[k] - mean[k]);
        for (i, line) in normal.iter_mut().enumerate() {
            for (element, column) in line.iter_mut().zip(&centred) {
                *element += centred[i].dot(*column);
            }
        }
    }
    Some(*law.tensor() + Symmetric3::from_elements(solved(kept(normal, has_scale))?))
}

/// Solves a positive definite system by Gaussian elimination; the right-hand side is the last
/// column.
fn solved(mut lines: [[f64; 7]; 6]) -> Option<[f64; 6]> {
    for k in 0..6 {
        let pivot = lines[k][k];
        if !(pivot > 0.0) {
            return None;
        }
        let from = lines[k];
        for line in lines.iter_mut().skip(k + 1) {
            let factor = line[k] / pivot;
            for (element, above) in line.iter_mut().zip(from) {
                *element -= factor * above;
            }
        }
    }
    let mut x = [0.0; 6];
    for k in (0..6).rev() {
        let known: f64 = (k + 1..6).map(|l| lines[k][l] * x[l]).sum();
        x[k] = (lines[k][6] - known) / lines[k][k];
    }
    x.iter().all(|x| x.is_finite()).then_some(x)
}
