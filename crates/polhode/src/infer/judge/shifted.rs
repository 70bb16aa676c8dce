//! Clocks under which a log begins some time after the scenario's start.

use super::beginning::{BEGINNING, Beginning, COMPARED, Clock};
use super::difference::{angle_between, rotation_vector};
use super::log::MotionLog;
use super::reading::{Reading, ReadingResidual};
use super::reference::{spread, states_within};
use crate::motion::model::state::State;
use crate::motion::task::scenario::Scenario;

/// Turn between two states of the exact motion that a first row is compared with, rad.
const TURN: f64 = 0.05;
/// Number of these states.
const LOOKED: usize = 8192;
/// Steps of integration.
const MOST: usize = 20_000;
/// Approaches of the exact motion to the first row that are followed.
const FOLLOWED: usize = 24;
/// Angle within which an approach counts, on the grid and at its nearest, rad.
const APPROACH: [f64; 2] = [0.2, 0.02];
/// A clock fits if the attitudes are off by no more than this part of the turn: it is fitted to them.
const FITS: f64 = 0.05;
/// Ratio of residuals of clocks that fit equally well, and the residual that rounding makes, rad.
const NEAR: f64 = 10.0;
const ROUNDING: f64 = 1e-9;
/// Angle between motions that are the same, rad, besides the residuals.
const SAME: f64 = 1e-6;

/// Finds the clocks that fit: readings, best first, and the beginning of the best one. Of clocks that give the same motion to the last
/// row only the earliest is kept. The clocks of `readings` are ignored.
pub(super) fn shifted(
    log: &MotionLog,
    scenario: &Scenario,
    readings: &[Reading],
    factors: &[f64],
    rate: f64,
) -> Option<(Vec<ReadingResidual>, Beginning)> {
    let start = scenario.start();
    let step = TURN / rate;
    if !step.is_finite() {
        return None;
    }
    let grid: Vec<f64> = (0..LOOKED).map(|k| start.time + step * k as f64).collect();
    let states = states_within(scenario, start, &grid, MOST).ok()??;
    let mut found = Vec::new();
    for &reading in readings {
        let first = reading.quaternion(log.attitude()[0]);
        for time in approaches(scenario, &states, first) {
            found.extend(factors.iter().filter_map(|&factor| fitted(log, scenario, reading, time, factor)));
        }
    }
    found.sort_by(|(a, _), (b, _)| a.attitude.total_cmp(&b.attitude));
    let best = found.first()?.0;
    let is_same = |(other, _): &(ReadingResidual, Beginning)| {
        let is_near = other.attitude <= NEAR * best.attitude.max(ROUNDING);
        *other == best || is_near && is_same_motion(log, scenario, &best, other)
    };
    let (same, others): (Vec<_>, Vec<_>) = found.into_iter().partition(is_same);
    let first = |(tried, _): &(ReadingResidual, Beginning)| tried.reading.time(log.times()[0]);
    let (earliest, beginning) = same.into_iter().min_by(|a, b| first(a).total_cmp(&first(b)))?;
    let others = others.into_iter().map(|(other, _)| other);
    Some((core::iter::once(earliest).chain(others).collect(), beginning))
}

/// The times at which the exact motion passes an attitude, s.
fn approaches(scenario: &Scenario, states: &[State], attitude: [f64; 4]) -> Vec<f64> {
    let angle = |state: &State| angle_between(state.attitude.quaternion(), attitude);
    let angles: Vec<f64> = states.iter().map(angle).collect();
    let at = |k: usize| angles.get(k).copied().unwrap_or(f64::INFINITY);
    let is_near = |k: &usize| at(*k) < APPROACH[0] && at(*k) <= at(k.wrapping_sub(1)) && at(*k) <= at(k + 1);
    let mut near: Vec<usize> = (0..angles.len()).filter(is_near).collect();
    near.sort_by(|&a, &b| at(a).total_cmp(&at(b)));
    near.truncate(FOLLOWED);
    near.sort_unstable();
    let nearest = |k: usize| {
        let from = states[k.saturating_sub(2)];
        let (mut time, mut state) = (states[k].time, states[k]);
        for _ in 0..4 {
            // Least squares of |θ − δt ω|
            let theta = rotation_vector(state.attitude.quaternion(), attitude);
            time = (time + shift([(theta, &state)])).max(from.time);
            [state] = *states_within(scenario, from, &[time], MOST).ok()??.first_chunk()?;
        }
        (angle(&state) < APPROACH[1]).then_some(time)
    };
    near.into_iter().filter_map(nearest).collect()
}

/// δt = Σ θ · ω / Σ |ω|², s
fn shift<'a>(rows: impl IntoIterator<Item = ([f64; 3], &'a State)>) -> f64 {
    let (mut across, mut square) = (0.0, f64::MIN_POSITIVE);
    for (theta, state) in rows {
        let omega = state.omega.to_array();
        across += (0..3).map(|k| theta[k] * omega[k]).sum::<f64>();
        square += omega.iter().map(|c| c * c).sum::<f64>();
    }
    across / square
}

/// The clock near one with which the log begins at `time` that fits the beginning best, if that fits.
fn fitted(
    log: &MotionLog,
    scenario: &Scenario,
    reading: Reading,
    time: f64,
    factor: f64,
) -> Option<(ReadingResidual, Beginning)> {
    let (mut time, mut best) = (time, None::<(ReadingResidual, Beginning)>);
    for _ in 0..3 {
        let clock = Clock::beginning_at(time, log, factor);
        let beginning = Beginning::of(log, scenario, clock, MOST).ok()??;
        let reading = Reading { time_origin: clock.origin, time_factor: factor, ..reading };
        let residual = beginning.residual(log, reading, false);
        let theta = |(&row, exact): (&usize, &State)| {
            rotation_vector(exact.attitude.quaternion(), reading.quaternion(log.attitude()[row]))
        };
        let rows = beginning.rows.iter().zip(&beginning.exact);
        let later = shift(rows.map(|(row, exact)| (theta((row, exact)), exact)));
        time = (time + later).max(scenario.start().time);
        if best.as_ref().is_none_or(|(known, _)| residual.attitude < known.attitude) {
            best = Some((residual, beginning));
        }
    }
    best.filter(|(residual, beginning)| residual.relative <= FITS && beginning.turn() >= 0.5 * BEGINNING)
}

/// True if two readings with clocks of their own give the same motion: their rows are off the exact states alike.
fn is_same_motion(log: &MotionLog, scenario: &Scenario, a: &ReadingResidual, b: &ReadingResidual) -> bool {
    let rows = spread(log.times().len(), COMPARED);
    let exact = |reading: &Reading| {
        let times: Vec<f64> = rows.iter().map(|&row| reading.time(log.times()[row])).collect();
        states_within(scenario, scenario.start(), &times, MOST).ok().flatten()
    };
    let (Some(of_a), Some(of_b)) = (exact(&a.reading), exact(&b.reading)) else { return false };
    let most = SAME + 10.0 * a.attitude.max(b.attitude);
    rows.iter().zip(of_a.iter().zip(&of_b)).all(|(&row, (exact_a, exact_b))| {
        let numbers = log.attitude()[row];
        let apart = |reading: &Reading, exact: &State| {
            rotation_vector(exact.attitude.quaternion(), reading.quaternion(numbers))
        };
        let (left, right) = (apart(&a.reading, exact_a), apart(&b.reading, exact_b));
        (0..3).map(|k| (left[k] - right[k]).powi(2)).sum::<f64>().sqrt() <= most
    })
}
