//! Search for clocks with which a log begins some time after the scenario's start.

use super::beginning::{BEGINNING, Beginning, CLEARLY, COMPARED, Clock, logged_rate};
use super::difference::{angle_between, rotation_vector};
use super::error::JudgeError;
use super::log::MotionLog;
use super::reading::{Reading, ReadingResidual};
use super::reference::{spread, states_within};
use crate::motion::model::state::State;
use crate::motion::task::scenario::Scenario;

/// Rotation angle between two states of the exact motion with which a first row is compared, rad.
const TURN: f64 = 0.05;
/// Number of these states; they span 400 rad.
const LOOKED: usize = 8192;
/// Maximum numbers of integration steps over these states, and over a motion that may rotate
/// farther.
const MOST: [usize; 2] = [20_000, 4000];
/// Number of rounds in which the duration of this rotation is estimated, and number of states in
/// each.
const ROUNDS: usize = 16;
const PROFILE: usize = 512;
/// Maximum number of approaches of the exact motion to the first row that are refined.
const FOLLOWED: usize = 24;
/// Largest angle of an approach, on the grid and after refinement, rad.
const APPROACH: [f64; 2] = [0.2, 0.02];
/// Largest residual (relative to the rotation angle) of a clock that fits; a fitted clock has a
/// smaller residual than other readings.
const FITS_FITTED: f64 = 0.05;
/// Residual due to rounding, rad.
const ROUNDING: f64 = 1e-9;
/// Largest angle between motions that count as equal, rad, in addition to the residuals.
const SAME_SHIFTED: f64 = 1e-6;
/// Range of the ratio of the log's angular velocity to the exact one for a unit that is tried; |ω|
/// may change soon after the first row.
const RATES_TRIED: core::ops::RangeInclusive<f64> = 0.03..=30.0;

/// Result of the search for the time of a first row.
#[derive(Debug)]
pub(super) enum Shifted {
    /// Readings, best first, and the beginning of the best one.
    Found(Vec<ReadingResidual>, Beginning),
    /// No clock fits the log.
    Nowhere,
    /// The exact motion cannot be computed.
    NotSearched,
}

/// Finds the clocks that fit, in the stated unit of time and in others. The clocks of `readings`
/// are ignored.
///
/// Only the earliest of the clocks that give the same motion up to the last row is kept.
pub(super) fn shifted(
    log: &MotionLog,
    scenario: &Scenario,
    readings: &[Reading],
    stated: f64,
    others: &[f64],
) -> Shifted {
    let rows = log.times();
    let duration = stated * (rows[rows.len() - 1] - rows[0]);
    let Some(states) = searched(scenario, duration) else { return Shifted::NotSearched };
    let rate = logged_rate(log);
    let mut found = Vec::new();
    for &reading in readings {
        let first = reading.quaternion(log.attitude()[0]);
        for near in approaches(scenario, &states, first) {
            found.extend(fitted(log, scenario, reading, near.time, stated));
            let agrees = |factor: &&f64| {
                rate.is_some_and(|rate| RATES_TRIED.contains(&(rate / (**factor * near.omega.norm()))))
            };
            // Rows of a motion that is slow enough fit any unit.
            let scaled = others.iter().filter(agrees);
            let scaled = scaled.filter_map(|&factor| fitted(log, scenario, reading, near.time, factor));
            found.extend(scaled.filter(|(_, beginning)| beginning.has_same_rate(log)));
        }
    }
    found.sort_by(|(a, _), (b, _)| a.attitude.total_cmp(&b.attitude));
    let Some(&(best, _)) = found.first() else { return Shifted::Nowhere };
    let is_same = |(other, _): &(ReadingResidual, Beginning)| {
        let is_near = other.attitude <= CLEARLY * best.attitude.max(ROUNDING);
        *other == best || is_near && is_same_motion(log, scenario, &best, other)
    };
    let (same, others): (Vec<_>, Vec<_>) = found.into_iter().partition(is_same);
    let first = |(tried, _): &(ReadingResidual, Beginning)| tried.reading.time(log.times()[0]);
    let earliest = same.into_iter().min_by(|a, b| first(a).total_cmp(&first(b)));
    let Some((earliest, beginning)) = earliest else { return Shifted::Nowhere };
    let others = others.into_iter().map(|(other, _)| other);
    Shifted::Found(core::iter::once(earliest).chain(others).collect(), beginning)
}

/// Returns states of the exact motion from the start, at intervals of [`TURN`], at most [`LOOKED`]
/// or as far as the motion reaches.
///
/// Returns `None` if they cannot be computed. `duration` (s) is a first guess for a body at rest.
fn searched(scenario: &Scenario, duration: f64) -> Option<Vec<State>> {
    let start = scenario.start();
    let wanted = TURN * LOOKED as f64;
    let mut span = Some(wanted / start.omega.norm()).filter(|span| span.is_finite()).unwrap_or(duration);
    let (mut longest, mut times) = (f64::INFINITY, None);
    for _ in 0..ROUNDS {
        let even: Vec<f64> = (0..=PROFILE).map(|k| start.time + span * (k as f64 / PROFILE as f64)).collect();
        let profile = match states_within(scenario, start, &even, MOST[1]) {
            Ok(Some(profile)) => profile,
            Err(JudgeError::Ends { end, .. }) if end > start.time && end < start.time + span => {
                longest = end - start.time;
                span = longest * (1.0 - 1e-9);
                continue;
            }
            _ => {
                longest = span;
                span *= 0.5;
                continue;
            }
        };
        let (turned, at) = turns(&profile);
        let end = at.last().map_or(0.0, |end| end - start.time);
        times = Some(at);
        // The profile is too coarse or too short.
        if turned > 2.0 * wanted {
            span = end.max(span / PROFILE as f64);
        } else if turned < 0.5 * wanted && 2.0 * span < longest {
            span *= 2.0;
        } else {
            break;
        }
    }
    states_within(scenario, start, &times?, MOST[0]).ok()?
}

/// Returns ∫ |ω| dt by the trapezoidal rule, rad, and at most [`LOOKED`] times (s) at which it is a
/// multiple of [`TURN`].
fn turns(states: &[State]) -> (f64, Vec<f64>) {
    let (mut turned, mut times) = (0.0, Vec::with_capacity(LOOKED));
    times.extend(states.first().map(|first| first.time));
    for pair in states.windows(2) {
        let (from, to) = (&pair[0], &pair[1]);
        let part = 0.5 * (from.omega.norm() + to.omega.norm()) * (to.time - from.time);
        while times.len() < LOOKED && TURN * times.len() as f64 <= turned + part {
            let share = (TURN * times.len() as f64 - turned) / part;
            times.push(from.time + share * (to.time - from.time));
        }
        turned += part;
    }
    (turned, times)
}

/// Returns states of the exact motion at the times at which it passes an attitude.
fn approaches(scenario: &Scenario, states: &[State], attitude: [f64; 4]) -> Vec<State> {
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
            // Least squares of |θ − δt ω|.
            let theta = rotation_vector(state.attitude.quaternion(), attitude);
            time = (time + shift([(theta, &state)])).max(from.time);
            [state] = *states_within(scenario, from, &[time], MOST[0]).ok()??.first_chunk()?;
        }
        (angle(&state) < APPROACH[1]).then_some(state)
    };
    near.into_iter().filter_map(nearest).collect()
}

/// Returns δt = Σ θ · ω / Σ |ω|², s.
fn shift<'a>(rows: impl IntoIterator<Item = ([f64; 3], &'a State)>) -> f64 {
    let (mut across, mut square) = (0.0, f64::MIN_POSITIVE);
    for (theta, state) in rows {
        let omega = state.omega.to_array();
        across += (0..3).map(|k| theta[k] * omega[k]).sum::<f64>();
        square += omega.iter().map(|c| c * c).sum::<f64>();
    }
    across / square
}

/// Returns the clock, close to one with which the log begins at `time`, that fits the beginning
/// best, if it fits.
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
        let beginning = Beginning::of(log, scenario, clock, MOST[0]).ok()??;
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
    best.filter(|(residual, beginning)| {
        residual.relative <= FITS_FITTED && beginning.turn() >= 0.5 * BEGINNING
    })
}

/// Returns true if two readings with different clocks give the same motion: their rows have the
/// same errors relative to the exact states.
fn is_same_motion(log: &MotionLog, scenario: &Scenario, a: &ReadingResidual, b: &ReadingResidual) -> bool {
    let rows = spread(log.times().len(), COMPARED);
    let exact = |reading: &Reading| {
        let times: Vec<f64> = rows.iter().map(|&row| reading.time(log.times()[row])).collect();
        states_within(scenario, scenario.start(), &times, MOST[0]).ok().flatten()
    };
    let (Some(of_a), Some(of_b)) = (exact(&a.reading), exact(&b.reading)) else { return false };
    let most = SAME_SHIFTED + CLEARLY * a.attitude.max(b.attitude);
    rows.iter().zip(of_a.iter().zip(&of_b)).all(|(&row, (exact_a, exact_b))| {
        let numbers = log.attitude()[row];
        let apart = |reading: &Reading, exact: &State| {
            rotation_vector(exact.attitude.quaternion(), reading.quaternion(numbers))
        };
        let (left, right) = (apart(&a.reading, exact_a), apart(&b.reading, exact_b));
        (0..3).map(|k| (left[k] - right[k]).powi(2)).sum::<f64>().sqrt() <= most
    })
}
