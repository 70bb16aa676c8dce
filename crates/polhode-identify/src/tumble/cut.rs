//! Flights in a long log: where the body turns, and nothing turns it.
//!
//! While the body is free, I ω̇ + ω × I ω = 0 but for noise and air. A hand that throws or catches it makes this torque as large as I ω². So stretches in which
//! the body turns fast give a first tensor, and with that the torque of every stretch of the log is looked at.

use super::first_guess::{Rates, cross_momentum, momentum, tensor};
use super::flight::GyroReading;
use super::range::GyroRange;
use crate::error::IdentifyError;

/// How flights are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlightSearch {
    /// In flight the body turns at least so fast, rad/s.
    pub slowest: f64,
    /// A flight lasts at least so long, s.
    pub shortest: f64,
    /// In flight the torque is at most this part of |I ω²|.
    pub torque: f64,
    /// The gyro's range; found from the readings if none is given.
    pub gyro_range: Option<GyroRange>,
}

impl Default for FlightSearch {
    /// 3 rad/s, 0.3 s, a fifth.
    fn default() -> Self {
        Self { slowest: 3.0, shortest: 0.3, torque: 0.2, gyro_range: None }
    }
}

/// Readings between which a torque is seen.
const STRETCH: usize = 5;

/// The first and the last time of each flight in a log, s. Readings at a limit of the gyro end no flight; what turns the body then is not known.
pub fn find_flights(readings: &[GyroReading], search: &FlightSearch) -> Result<Vec<[f64; 2]>, IdentifyError> {
    let range = search.gyro_range.unwrap_or_else(|| GyroRange::shown_by(readings));
    let is_inside: Vec<bool> = readings.iter().map(|reading| range.holds(reading)).collect();
    let times: Vec<f64> = readings.iter().map(|r| r.time).collect();
    let omega: Vec<[f64; 3]> = readings.iter().map(|r| r.omega.to_array()).collect();
    let fast: Vec<bool> = readings.iter().map(|r| r.omega.norm() >= search.slowest).collect();
    // The middle halves of what is fast are likely flights.
    let cores: Vec<Vec<Rates>> = runs(&fast, |k| gap(&times, k))
        .into_iter()
        .filter(|run| times[run.end - 1] - times[run.start] >= search.shortest)
        .map(|run| {
            let quarter = run.len() / 4;
            let core = run.start + quarter..run.end - quarter;
            let of = |values: core::ops::Range<usize>| Rates {
                times: times[values.clone()].to_vec(),
                omega: omega[values].to_vec(),
            };
            let inside = runs(&is_inside[core.clone()], |_| false).into_iter();
            inside.map(|part| of(core.start + part.start..core.start + part.end)).collect()
        })
        .collect();
    if cores.is_empty() {
        return Ok(Vec::new());
    }
    let tensor = tensor_of_most(cores)?;
    let around = |k: usize| k.saturating_sub(STRETCH / 2)..(k + STRETCH / 2 + 1).min(omega.len());
    let is_seen: Vec<bool> = (0..omega.len()).map(|k| around(k).all(|k| is_inside[k])).collect();
    let is_free: Vec<bool> = (0..omega.len())
        .map(|k| {
            let stretch = around(k);
            let torque = || torque(&tensor, &times[stretch.clone()], &omega[stretch.clone()]);
            fast[k] && (!is_seen[k] || (stretch.len() > 1 && torque() <= search.torque))
        })
        .collect();
    Ok(runs(&is_free, |k| gap(&times, k))
        .into_iter()
        .filter_map(|run| {
            let mut seen = run.filter(|k| is_seen[*k]);
            let first = seen.next()?;
            Some([times[first], times[seen.next_back().unwrap_or(first)]])
        })
        .filter(|[from, to]| to - from >= search.shortest)
        .collect())
}

/// The tensor with which most of the cores are nearly free: of all of them first, then again and again of those half that are nearest to free, as hands turn
/// the rest.
pub(super) fn tensor_of_most(mut cores: Vec<Vec<Rates>>) -> Result<[f64; 6], IdentifyError> {
    const ROUNDS: usize = 6;
    let mut found = tensor(&cores.concat())?;
    let half = cores.len().div_ceil(2);
    for _ in 0..ROUNDS {
        let by = |core: &[Rates]| mean_torque(&found, core);
        cores.sort_by(|a, b| by(a).total_cmp(&by(b)));
        found = tensor(&cores[..half].concat())?;
    }
    Ok(found)
}

fn mean_torque(tensor: &[f64; 6], core: &[Rates]) -> f64 {
    let stretches =
        core.iter().flat_map(|rates| rates.times.windows(STRETCH).zip(rates.omega.windows(STRETCH)));
    let (sum, count) =
        stretches.fold((0.0, 0.0), |(sum, count), (t, w)| (sum + torque(tensor, t, w), count + 1.0));
    if count > 0.0 { sum / count } else { f64::INFINITY }
}

/// Whether the log has a gap before a reading: three times as long as the one before it, or more.
fn gap(times: &[f64], k: usize) -> bool {
    k >= 2 && times[k] - times[k - 1] > 3.0 * (times[k - 1] - times[k - 2])
}

/// |I Δω/Δt + mean ω × I ω| over |I| mean ω², of a stretch.
fn torque(tensor: &[f64; 6], times: &[f64], omega: &[[f64; 3]]) -> f64 {
    let times_tensor =
        |rows: [[f64; 6]; 3]| rows.map(|row| row.iter().zip(tensor).map(|(a, b)| a * b).sum::<f64>());
    let last = omega.len() - 1;
    let duration = times[last] - times[0];
    let ends = core::array::from_fn(|k| omega[last][k] - omega[0][k]);
    let mut sum: [f64; 3] = times_tensor(momentum(ends));
    let mut square = 0.0;
    for k in 0..last {
        let half = 0.5 * (times[k + 1] - times[k]);
        for w in [omega[k], omega[k + 1]] {
            let turning: [f64; 3] = times_tensor(cross_momentum(w));
            for (sum, turning) in sum.iter_mut().zip(turning) {
                *sum += half * turning;
            }
            square += half * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        }
    }
    let size = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
    let mean = (tensor[0] + tensor[1] + tensor[2]) / 3.0;
    if duration > 0.0 && square > 0.0 { size / (mean * square) } else { f64::INFINITY }
}

/// From when to when a flight is free, which it is in the middle: where the torque is at most a part of |I ω²|, beyond what noise of the readings makes.
/// `None` if it is nowhere.
pub(super) fn free_span(rates: &Rates, tensor: &[f64; 6], limit: f64, noise: f64) -> Option<[f64; 2]> {
    let last = rates.times.len().checked_sub(STRETCH)?;
    let is_free = |k: usize| {
        let (times, omega) = (&rates.times[k..k + STRETCH], &rates.omega[k..k + STRETCH]);
        let duration = times[STRETCH - 1] - times[0];
        let square = omega.iter().flatten().map(|w| w * w).sum::<f64>() / STRETCH as f64;
        torque(tensor, times, omega) <= limit + noise * NOISE_OF_ENDS / (duration * square)
    };
    let free: Vec<usize> = (0..=last).filter(|&k| is_free(k)).collect();
    let (first, last_free) = (*free.first()?, *free.last()?);
    // A reading that is wrong is in as many stretches as a stretch has readings; half of the first free stretch may not be free.
    let half = STRETCH / 2;
    let begin = if first > STRETCH { first + half } else { 0 };
    let end = if last - last_free > STRETCH { last_free + STRETCH - half } else { rates.times.len() };
    Some([rates.times[begin], rates.times[end - 1]])
}

/// √6: two readings of three components each.
const NOISE_OF_ENDS: f64 = 2.449_489_742_783_178;

/// Where something holds without a break.
fn runs(holds: &[bool], breaks_before: impl Fn(usize) -> bool) -> Vec<core::ops::Range<usize>> {
    let mut runs: Vec<core::ops::Range<usize>> = Vec::new();
    for (k, _) in holds.iter().enumerate().filter(|(_, holds)| **holds) {
        match runs.last_mut() {
            Some(run) if run.end == k && !breaks_before(k) => run.end = k + 1,
            _ => runs.push(k..k + 1),
        }
    }
    runs
}
