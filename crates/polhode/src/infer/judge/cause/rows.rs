//! Rows of a run over which causes are compared.

use super::law::BodyVector;
use crate::infer::judge::motion::ReadMotion;
use crate::math::rotation::{Attitude, Rotation};
use crate::motion::model::state::State;

/// Error above which the phases of a motion are meaningless, rad.
const LOST: f64 = 1.5;

/// Rotation angle of the body over which it is compared, rad: minimum (if the run is long enough)
/// and maximum.
const TURNING: [f64; 2] = [6.0, 120.0];

/// Minimum number of rows, if the run has them.
const LEAST_ROWS: usize = 12;

/// Number of rows that are compared.
const COMPARED: usize = 160;

/// Weight of the relative error of ω compared with an attitude error in rad.
const OMEGA_WEIGHT: f64 = 0.3;

/// Rows of the run and the exact states at their times.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    pub(super) times: Vec<f64>,
    pub(super) run: Vec<Attitude>,
    pub(super) omega: Option<Vec<BodyVector>>,
    pub(super) exact: Vec<State>,
    /// RMS of |ω| of the exact motion, rad/s.
    pub(super) rate: f64,
    /// Time between the first two rows of the run, s.
    pub(super) spacing: f64,
}

/// Misfit between states and the run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Misfit {
    /// RMS angle between the attitudes, rad.
    pub(super) attitude: f64,
    /// RMS of |δω| relative to RMS of |ω|; zero if the run has no ω.
    pub(super) omega: f64,
}

impl Misfit {
    /// Returns both misfits combined, rad.
    pub(super) fn size(self) -> f64 {
        libm::hypot(self.attitude, OMEGA_WEIGHT * self.omega)
    }
}

/// Informative part of a run: from the start until the exact motion and the run diverge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window<'a> {
    motion: &'a ReadMotion,
    exact: &'a [State],
    /// Index of the first row, and one past the last.
    first: usize,
    end: usize,
}

impl<'a> Window<'a> {
    /// Returns the window; `None` if there are fewer than two rows from the start on.
    pub(super) fn of(motion: &'a ReadMotion, exact: &'a [State], start: f64) -> Option<Self> {
        let rows = motion.times.len().min(exact.len()).min(motion.attitude.len());
        let first = motion.times.partition_point(|&time| time < start);
        let mut window = Self { motion, exact, first, end: rows };
        // A coarse pass locates the end approximately, a finer one exactly.
        while window.end > first {
            let stride = (window.end - first) / 2048 + 1;
            let end = window.told(stride);
            let done = stride == 1 || end - first > 16 * stride;
            window.end = end;
            if done {
                break;
            }
        }
        (window.end >= first + 2).then_some(window)
    }

    fn told(&self, stride: usize) -> usize {
        let (mut turned, mut before, mut is_lost, mut looked) = (0.0, None, false, 0);
        for k in (self.first..self.end).step_by(stride) {
            let (Some(state), Some(run)) = (self.exact.get(k), attitude(self.motion, k)) else { return k };
            if !state.omega.is_finite() {
                return k;
            }
            let since = state.time - before.unwrap_or(state.time);
            turned += state.omega.norm() * since;
            before = Some(state.time);
            looked += 1;
            is_lost |= run.angle_to(state.attitude) > LOST;
            let enough = is_lost && turned > TURNING[0] && looked >= LEAST_ROWS;
            if enough || (turned > TURNING[1] && looked >= LEAST_ROWS) {
                return (k + 1).max(self.first + 2);
            }
        }
        self.end
    }

    /// Returns rows spread evenly over the window.
    pub(super) fn rows(&self) -> Rows {
        self.rows_until(f64::INFINITY)
    }

    /// Returns rows spread evenly over the window until a time, at least two.
    pub(super) fn rows_until(&self, time: f64) -> Rows {
        let within = self.motion.times.partition_point(|&t| t <= time);
        let end = self.end.min(within).max((self.first + 2).min(self.end));
        let last = (end - self.first).saturating_sub(1);
        let count = COMPARED.min(last + 1);
        let spread = |k: usize| self.first + k * last / (count - 1).max(1);
        let chosen: Vec<usize> = (0..count).map(spread).collect();
        let mut run = Vec::with_capacity(count);
        let mut kept = Vec::with_capacity(count);
        for k in chosen {
            if let Some(attitude) = attitude(self.motion, k) {
                run.push(attitude);
                kept.push(k);
            }
        }
        let omega = self.motion.omega.as_ref().map(|omega| {
            kept.iter().map(|&k| omega.get(k).map_or(BodyVector::ZERO, |v| v.as_quantity())).collect()
        });
        let exact: Vec<State> = kept.iter().map(|&k| self.exact[k]).collect();
        let square: f64 = exact.iter().map(|state| state.omega.dot(state.omega)).sum();
        Rows {
            times: kept.iter().map(|&k| self.motion.times[k]).collect(),
            run,
            omega,
            rate: (square / exact.len().max(1) as f64).sqrt(),
            exact,
            spacing: self.motion.times[self.first + 1] - self.motion.times[self.first],
        }
    }

    /// Returns the end of the window, s.
    pub(super) fn end(&self) -> f64 {
        self.motion.times[self.end - 1]
    }

    /// Returns the run as at most `most` states, with ω from the log, or otherwise from the
    /// attitudes before and after.
    pub(super) fn states(&self, most: usize) -> Vec<State> {
        let stride = (self.end - self.first) / most + 1;
        (self.first..self.end).step_by(stride).filter_map(|k| self.state(k)).collect()
    }

    /// Returns a row as a state.
    pub(super) fn state(&self, k: usize) -> Option<State> {
        let (time, here) = (*self.motion.times.get(k)?, attitude(self.motion, k)?);
        if let Some(omega) = &self.motion.omega {
            return Some(State { time, attitude: here, omega: *omega.get(k)? });
        }
        let [before, after] = [k.checked_sub(1)?, k + 1];
        let span = self.motion.times.get(after)? - self.motion.times[before];
        let turned = rotation_vector(attitude(self.motion, before)?, attitude(self.motion, after)?);
        Some(State { time, attitude: here, omega: (turned / span).as_quantity() })
    }

    /// Returns the index of the first row.
    pub(super) const fn first(&self) -> usize {
        self.first
    }

    /// Returns the range of all rows.
    pub(super) const fn range(&self) -> core::ops::Range<usize> {
        self.first..self.end
    }

    /// Returns the times of all rows, s.
    pub(super) fn times(&self) -> &'a [f64] {
        &self.motion.times[self.range()]
    }

    /// Returns the attitude of a row.
    pub(super) fn attitude(&self, row: usize) -> Option<Attitude> {
        attitude(self.motion, row)
    }
}

fn attitude(motion: &ReadMotion, row: usize) -> Option<Attitude> {
    Rotation::from_quaternion(*motion.attitude.get(row)?).ok()
}

/// Returns the rotation vector along body axes from one attitude to another, of at most π rad.
pub(super) fn rotation_vector(from: Attitude, to: Attitude) -> BodyVector {
    let [w, x, y, z] = (from.inverse() * to).canonical_quaternion();
    let v = BodyVector::new(x, y, z);
    let sine = v.norm();
    if sine == 0.0 { v } else { v * (2.0 * libm::atan2(sine, w) / sine) }
}

impl Rows {
    /// Returns the misfit of states, as far as they reach; infinite if there are none.
    pub(super) fn misfit(&self, states: &[State]) -> Misfit {
        let count = states.len().min(self.run.len());
        if count == 0 {
            return Misfit { attitude: f64::INFINITY, omega: f64::INFINITY };
        }
        let mean = |sum: f64| (sum / count as f64).sqrt();
        let angles = states.iter().zip(&self.run).map(|(state, run)| state.attitude.angle_to(*run).powi(2));
        let rates = self.omega.iter().flatten().zip(states).map(|(omega, state)| {
            let difference = state.omega.as_quantity() - *omega;
            difference.dot(difference)
        });
        let rate = if self.rate > 0.0 { self.rate } else { 1.0 };
        Misfit { attitude: mean(angles.sum()), omega: mean(rates.sum()) / rate }
    }

    /// Returns the misfit of the exact states of the first rows.
    pub(super) fn base(&self, count: usize) -> Misfit {
        self.misfit(&self.exact[..count.min(self.exact.len())])
    }

    /// Returns the rotation vectors from states to the run, as a list of components.
    pub(super) fn differences(&self, states: &[State]) -> Vec<f64> {
        let vectors = states.iter().zip(&self.run);
        vectors.flat_map(|(state, run)| rotation_vector(state.attitude, *run).to_array()).collect()
    }
}
