//! The rows of a run that causes are compared over.

use super::law::BodyVector;
use crate::infer::judge::motion::ReadMotion;
use crate::math::rotation::{Attitude, Rotation};
use crate::motion::model::state::State;

/// Beyond this error the phases of a motion mean nothing, rad.
const LOST: f64 = 1.5;

/// How far a body turns while it is compared, rad: at least, if the run is so long, and at most.
const TURNING: [f64; 2] = [6.0, 120.0];

/// At least so many rows, if the run has them.
const LEAST_ROWS: usize = 12;

/// How many rows are compared.
const COMPARED: usize = 160;

/// How much an error of ω relative to ω counts beside one of the attitude in rad.
const OMEGA_WEIGHT: f64 = 0.3;

/// Rows of the run and the exact states there.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    pub(super) times: Vec<f64>,
    pub(super) run: Vec<Attitude>,
    pub(super) omega: Option<Vec<BodyVector>>,
    pub(super) exact: Vec<State>,
    /// rms |ω| of the exact motion, rad/s.
    pub(super) rate: f64,
    /// The time between two rows of the run, s: of the first two.
    pub(super) spacing: f64,
}

/// How far states are from the run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Misfit {
    /// rms of the angle between the attitudes, rad.
    pub(super) attitude: f64,
    /// rms |δω| relative to rms |ω|; zero where the run has no ω.
    pub(super) omega: f64,
}

impl Misfit {
    /// Both in one.
    pub(super) fn size(self) -> f64 {
        libm::hypot(self.attitude, OMEGA_WEIGHT * self.omega)
    }
}

/// The part of a run that tells: from the start until the exact motion is lost.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window<'a> {
    motion: &'a ReadMotion,
    exact: &'a [State],
    /// The first row and one past the last.
    first: usize,
    end: usize,
}

impl<'a> Window<'a> {
    /// `None` if there are fewer than two rows from the start on.
    pub(super) fn of(motion: &'a ReadMotion, exact: &'a [State], start: f64) -> Option<Self> {
        let rows = motion.times.len().min(exact.len()).min(motion.attitude.len());
        let first = motion.times.partition_point(|&time| time < start);
        let mut window = Self { motion, exact, first, end: rows };
        // A coarse look finds about where to end, a finer one where.
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

    /// Rows spread evenly over it.
    pub(super) fn rows(&self) -> Rows {
        self.rows_until(f64::INFINITY)
    }

    /// Rows spread evenly over it until a time, two at least.
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

    /// Its end, s.
    pub(super) fn end(&self) -> f64 {
        self.motion.times[self.end - 1]
    }

    /// The run between two times as states, every `stride` rows, with ω from the log or else from the attitudes before and after.
    pub(super) fn states(&self, most: usize) -> Vec<State> {
        let stride = (self.end - self.first) / most + 1;
        (self.first..self.end).step_by(stride).filter_map(|k| self.state(k)).collect()
    }

    /// A row as a state.
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

    /// The first row.
    pub(super) const fn first(&self) -> usize {
        self.first
    }

    /// All rows.
    pub(super) const fn range(&self) -> core::ops::Range<usize> {
        self.first..self.end
    }

    /// The times of all rows.
    pub(super) fn times(&self) -> &'a [f64] {
        &self.motion.times[self.range()]
    }

    /// The attitude of a row.
    pub(super) fn attitude(&self, row: usize) -> Option<Attitude> {
        attitude(self.motion, row)
    }
}

fn attitude(motion: &ReadMotion, row: usize) -> Option<Attitude> {
    Rotation::from_quaternion(*motion.attitude.get(row)?).ok()
}

/// The rotation vector in the body that leads from one attitude to another, of π rad at most.
pub(super) fn rotation_vector(from: Attitude, to: Attitude) -> BodyVector {
    let [w, x, y, z] = (from.inverse() * to).canonical_quaternion();
    let v = BodyVector::new(x, y, z);
    let sine = v.norm();
    if sine == 0.0 { v } else { v * (2.0 * libm::atan2(sine, w) / sine) }
}

impl Rows {
    /// How far states, as many as there are, are from the run; nothing is known of none.
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

    /// How far the exact states of the first rows are.
    pub(super) fn base(&self, count: usize) -> Misfit {
        self.misfit(&self.exact[..count.min(self.exact.len())])
    }

    /// The rotation vectors from states to the run, one component after the other.
    pub(super) fn differences(&self, states: &[State]) -> Vec<f64> {
        let vectors = states.iter().zip(&self.run);
        vectors.flat_map(|(state, run)| rotation_vector(state.attitude, *run).to_array()).collect()
    }
}
