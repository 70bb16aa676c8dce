//! A tensor to begin with, from Euler's equations in the mean over short stretches.
//!
//! I (ω(t₂) − ω(t₁)) + ∫ ω × I ω dt = 0 is linear in the six elements: the tensor, but for its scale, is the direction in which the sum of squares is least.

use nalgebra::{DMatrix, DVector};
use polhode::math::{Body, Rotation};

use super::flight::Flight;
use super::gap::gaps;
use crate::decomposition::{Svd, lu, svd};
use crate::error::IdentifyError;

/// Readings in a stretch: the turn of a fast body in 50 ms, and more than the noise of two readings.
const STRETCH: usize = 5;
/// How much the tensor of a sphere counts beside the measurements: what they do not say at all is taken from it.
const SPHERE: f64 = 1e-4;

/// The tensor of all flights. Where known tensors a and b are added to some, the scale s is that at which they agree:
/// t J_b − s J_a = b − a, I = s J_a − a.
pub(crate) fn tensor_with_scale(flights: &[Flight]) -> Result<[f64; 6], IdentifyError> {
    let of = |wanted: &dyn Fn(&Flight) -> bool| {
        let wanted = flights.iter().filter(|flight| wanted(flight));
        tensor(&wanted.flat_map(|flight| Rates::of(flight).without_gaps()).collect::<Vec<_>>())
    };
    let added = || flights.iter().map(Flight::added);
    // Flights without anything added are preferred: nothing is subtracted from their tensor.
    let a = added().find(|added| *added == [0.0; 6]).or_else(|| added().next()).unwrap_or_default();
    let Some(b) = added().find(|added| *added != a) else { return of(&|_| true) };
    let (of_a, of_b) = (of(&|flight| flight.added() == a)?, of(&|flight| flight.added() == b)?);
    let difference: [f64; 6] = core::array::from_fn(|k| b[k] - a[k]);
    let columns = DMatrix::from_fn(6, 2, |i, k| if k == 0 { of_b[i] } else { -of_a[i] });
    let Svd { u, values, v_t } = svd("the first tensors of two bodies", columns)?;
    let mut along = u.tr_mul(&DVector::from_row_slice(&difference));
    for (x, s) in along.iter_mut().zip(&values) {
        *x = if *s > f64::EPSILON { *x / s } else { 0.0 };
    }
    let scale = v_t.tr_mul(&along)[1];
    if scale > 0.0 {
        return Ok(core::array::from_fn(|k| scale * of_a[k] - a[k]));
    }
    let size = difference.iter().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
    Ok(of_a.map(|element| element * size))
}

/// A of ω_gyro = A ω_tracked, by the rotation of least squares of the rates.
///
/// Source: Kabsch, Acta Cryst. A32 (1976) 922.
pub(crate) fn tracked_axes(flights: &[Flight]) -> Result<Rotation<Body, Body>, IdentifyError> {
    let mut sum = DMatrix::zeros(3, 3);
    for flight in flights.iter().filter(|flight| !flight.gyro().is_empty() && flight.attitudes().len() > 1) {
        let gyro = Rates::of(flight);
        let tracked = Rates::of_attitudes(flight);
        for (&time, &omega) in tracked.times.iter().zip(&tracked.omega) {
            sum += DVector::from_row_slice(&gyro.at(time)) * DVector::from_row_slice(&omega).transpose();
        }
    }
    let Svd { u, v_t, .. } = svd("the covariance of the gyro's and the tracked rates", sum)?;
    let sign = (&u * &v_t).determinant().signum();
    let r = u * DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 1.0, sign])) * v_t;
    Ok(Rotation::from_matrix(core::array::from_fn(|i| core::array::from_fn(|j| r[(i, j)])))
        .unwrap_or_else(|_| Rotation::identity()))
}

/// The tensor of least squares, of trace 3, not necessarily a possible one.
pub(super) fn tensor(flights: &[Rates]) -> Result<[f64; 6], IdentifyError> {
    let mut square = DMatrix::zeros(6, 6);
    for Rates { times, omega } in flights {
        for start in (0..omega.len().saturating_sub(STRETCH)).step_by(2) {
            let mut rows = DMatrix::zeros(3, 6);
            let ends = momentum(difference(omega[start + STRETCH], omega[start]));
            for i in 0..3 {
                for k in 0..6 {
                    rows[(i, k)] = ends[i][k];
                }
            }
            for k in start..start + STRETCH {
                let half = 0.5 * (times[k + 1] - times[k]);
                for at in [k, k + 1] {
                    let turning = cross_momentum(omega[at]);
                    for i in 0..3 {
                        for k in 0..6 {
                            rows[(i, k)] += half * turning[i][k];
                        }
                    }
                }
            }
            square += rows.transpose() * rows;
        }
    }
    // least squares of A (sphere + x), with x held at zero where A says nothing
    let sphere = DVector::from_row_slice(&[1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    let size = if square.trace() > 0.0 { square.trace() } else { 1.0 };
    let hold = SPHERE * size / 6.0;
    let damped = &square + DMatrix::identity(6, 6) * hold;
    let solved = lu("the normal matrix of the first tensor", damped)?.solve(&(-&square * &sphere));
    let x = solved.unwrap_or_else(|| DVector::zeros(6));
    let found = sphere + x;
    let trace = found[0] + found[1] + found[2];
    let scale = if trace > 0.1 { 3.0 / trace } else { 1.0 };
    Ok(core::array::from_fn(|k| found[k] * scale))
}

/// Rates along the body's axes.
#[derive(Clone)]
pub(crate) struct Rates {
    pub(crate) times: Vec<f64>,
    pub(crate) omega: Vec<[f64; 3]>,
}

impl Rates {
    /// Of a gyro, or of attitudes where there is none.
    pub(crate) fn of(flight: &Flight) -> Self {
        if !flight.gyro().is_empty() {
            return Self {
                times: flight.gyro().iter().map(|r| r.time).collect(),
                omega: flight.gyro().iter().map(|r| r.omega.to_array()).collect(),
            };
        }
        Self::of_attitudes(flight)
    }

    /// A component.
    pub(super) fn channel(&self, k: usize) -> Vec<f64> {
        self.omega.iter().map(|omega| omega[k]).collect()
    }

    /// Its middle half.
    pub(super) fn middle(&self) -> Self {
        let quarter = self.times.len() / 4;
        self.part(quarter..self.times.len() - quarter)
    }

    /// The parts between gaps, those that are too short for a stretch left out.
    pub(super) fn without_gaps(&self) -> Vec<Self> {
        let mut from = 0;
        let mut parts = Vec::new();
        for [_, to] in gaps(&self.times) {
            let next = self.times.partition_point(|&t| t < to);
            parts.push(from..next);
            from = next;
        }
        parts.push(from..self.times.len());
        parts.into_iter().filter(|part| part.len() > STRETCH).map(|part| self.part(part)).collect()
    }

    fn part(&self, part: core::ops::Range<usize>) -> Self {
        Self { times: self.times[part.clone()].to_vec(), omega: self.omega[part].to_vec() }
    }

    /// log(R₁ᵀR₂)/Δt half way between.
    fn of_attitudes(flight: &Flight) -> Self {
        let pairs = flight.attitudes().windows(2);
        pairs.fold(Self { times: Vec::new(), omega: Vec::new() }, |mut rates, pair| {
            let step = pair[1].time - pair[0].time;
            let turn = (pair[0].attitude.inverse() * pair[1].attitude).log();
            rates.times.push(0.5 * (pair[0].time + pair[1].time));
            rates.omega.push((turn / step).to_array());
            rates
        })
    }

    /// ω at a time: a straight line through the readings around it.
    pub(crate) fn at(&self, time: f64) -> [f64; 3] {
        const AROUND: usize = 3;
        let next = self.times.partition_point(|&t| t < time);
        let (from, to) = (next.saturating_sub(AROUND), (next + AROUND).min(self.times.len()));
        let (times, omega) = (&self.times[from..to], &self.omega[from..to]);
        let n = times.len() as f64;
        let mean = times.iter().sum::<f64>() / n;
        let spread: f64 = times.iter().map(|t| (t - mean) * (t - mean)).sum();
        core::array::from_fn(|k| {
            let level = omega.iter().map(|w| w[k]).sum::<f64>() / n;
            let slope = times.iter().zip(omega).map(|(t, w)| (t - mean) * w[k]).sum::<f64>();
            if spread > 0.0 { level + slope / spread * (time - mean) } else { level }
        })
    }
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| a[k] - b[k])
}

/// I ω as rows of what multiplies xx, yy, zz, xy, xz, yz.
pub(super) fn momentum([x, y, z]: [f64; 3]) -> [[f64; 6]; 3] {
    [[x, 0.0, 0.0, y, z, 0.0], [0.0, y, 0.0, x, 0.0, z], [0.0, 0.0, z, 0.0, x, y]]
}

/// ω × I ω
pub(super) fn cross_momentum(omega: [f64; 3]) -> [[f64; 6]; 3] {
    let rows = momentum(omega);
    let [x, y, z] = omega;
    let of = |a: f64, i: usize, b: f64, j: usize| core::array::from_fn(|k| a * rows[i][k] - b * rows[j][k]);
    [of(y, 2, z, 1), of(z, 0, x, 2), of(x, 1, y, 0)]
}
