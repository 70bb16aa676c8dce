//! Initial estimate of the tensor, from Euler's equations integrated over short intervals.
//!
//! I (ω(t₂) − ω(t₁)) + ∫ ω × I ω dt = 0 is linear in the six elements of I. Its least-squares
//! solution determines the tensor up to scale.

use nalgebra::{DMatrix, DVector};
use polhode::math::{Body, Rotation};

use super::flight::Flight;
use super::gap::gaps;
use crate::decomposition::{Svd, lu, svd};
use crate::error::IdentifyError;

/// Number of steps in an interval: enough for ω to change by more than the noise of two readings; a
/// fast body turns noticeably in 50 ms.
const STRETCH: usize = 5;
/// Weight of the regularization towards a sphere. It decides only where the measurements determine
/// nothing.
const SPHERE: f64 = 1e-4;

/// Estimates the tensor of all flights.
///
/// If known tensors a and b are added in some flights, the scale s follows from agreement of both:
/// t J_b − s J_a = b − a, I = s J_a − a. Here J_a and J_b are the tensors with the added body, up
/// to scale.
pub(crate) fn tensor_with_scale(flights: &[Flight]) -> Result<[f64; 6], IdentifyError> {
    let of = |wanted: &dyn Fn(&Flight) -> bool| {
        let wanted = flights.iter().filter(|flight| wanted(flight));
        tensor(&wanted.flat_map(|flight| Rates::of(flight).without_gaps()).collect::<Vec<_>>())
    };
    let added = || flights.iter().map(Flight::added);
    // Flights without an added body are preferred, because nothing must be subtracted from their
    // tensor.
    let a = added().find(|added| *added == [0.0; 6]).or_else(|| added().next()).unwrap_or_default();
    let Some(b) = added().find(|added| *added != a) else { return of(&|_| true) };
    let (of_a, of_b) = (of(&|flight| flight.added() == a)?, of(&|flight| flight.added() == b)?);
    let difference: [f64; 6] = core::array::from_fn(|k| b[k] - a[k]);
    let columns = DMatrix::from_fn(6, 2, |i, k| if k == 0 { of_b[i] } else { -of_a[i] });
    let Svd { u, values, v_t } = svd("the initial tensors of two bodies", columns)?;
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

/// Estimates the rotation A of ω_gyro = A ω_tracked by least squares.
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

/// Returns the least-squares tensor with trace 3, which need not be physically consistent.
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
    // Least squares of A (sphere + x), regularized so that x = 0 where A determines nothing.
    let sphere = DVector::from_row_slice(&[1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    let size = if square.trace() > 0.0 { square.trace() } else { 1.0 };
    let hold = SPHERE * size / 6.0;
    let damped = &square + DMatrix::identity(6, 6) * hold;
    let solved = lu("the normal matrix of the initial tensor", damped)?.solve(&(-&square * &sphere));
    let x = solved.unwrap_or_else(|| DVector::zeros(6));
    let found = sphere + x;
    let trace = found[0] + found[1] + found[2];
    let scale = if trace > 0.1 { 3.0 / trace } else { 1.0 };
    Ok(core::array::from_fn(|k| found[k] * scale))
}

/// Time series of angular velocity along body axes.
#[derive(Clone)]
pub(crate) struct Rates {
    pub(crate) times: Vec<f64>,
    pub(crate) omega: Vec<[f64; 3]>,
}

impl Rates {
    /// Returns the rates of the gyro, or those of the attitudes without a gyro.
    pub(crate) fn of(flight: &Flight) -> Self {
        if !flight.gyro().is_empty() {
            return Self {
                times: flight.gyro().iter().map(|r| r.time).collect(),
                omega: flight.gyro().iter().map(|r| r.omega.to_array()).collect(),
            };
        }
        Self::of_attitudes(flight)
    }

    /// Returns one component of the rates.
    pub(super) fn channel(&self, k: usize) -> Vec<f64> {
        self.omega.iter().map(|omega| omega[k]).collect()
    }

    /// Returns the middle half of the series.
    pub(super) fn middle(&self) -> Self {
        let quarter = self.times.len() / 4;
        self.part(quarter..self.times.len() - quarter)
    }

    /// Returns the parts between gaps, without those too short for an interval.
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

    /// Computes rates from successive attitudes: log(R₁ᵀR₂)/Δt at the middle time.
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

    /// Returns ω at a time, by a line fitted to the three readings on each side.
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

/// Returns I ω as rows of coefficients of xx, yy, zz, xy, xz, yz.
pub(super) fn momentum([x, y, z]: [f64; 3]) -> [[f64; 6]; 3] {
    [[x, 0.0, 0.0, y, z, 0.0], [0.0, y, 0.0, x, 0.0, z], [0.0, 0.0, z, 0.0, x, y]]
}

/// Returns ω × I ω as rows of coefficients of xx, yy, zz, xy, xz, yz.
pub(super) fn cross_momentum(omega: [f64; 3]) -> [[f64; 6]; 3] {
    let rows = momentum(omega);
    let [x, y, z] = omega;
    let of = |a: f64, i: usize, b: f64, j: usize| core::array::from_fn(|k| a * rows[i][k] - b * rows[j][k]);
    [of(y, 2, z, 1), of(z, 0, x, 2), of(x, 1, y, 0)]
}
