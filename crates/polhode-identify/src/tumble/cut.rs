//! Detection of flights in a long log: intervals of fast rotation without external torque.
//!
//! Free motion satisfies I ω̇ + ω × I ω = 0, except for noise and air drag. A hand that throws or
//! catches the body exerts a torque of the order of I ω². Intervals of fast rotation give a first
//! tensor. With this tensor the torque of every interval of the log is computed.

use super::first_guess::{Rates, cross_momentum, momentum, tensor};
use super::flight::GyroReading;
use super::range::GyroRange;
use crate::error::IdentifyError;

/// Options of the flight detection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlightSearch {
    /// Lower bound on the angular speed in flight, rad/s.
    pub slowest: f64,
    /// Lower bound on the duration of a flight, s.
    pub shortest: f64,
    /// Upper bound on the torque in flight, relative to the mean moment times ω².
    pub torque: f64,
    /// Range of the gyro; estimated from the readings if `None`.
    pub gyro_range: Option<GyroRange>,
}

impl Default for FlightSearch {
    /// Returns the default: 3 rad/s, 0.3 s, torque ratio 0.2, range from the readings.
    fn default() -> Self {
        Self { slowest: 3.0, shortest: 0.3, torque: 0.2, gyro_range: None }
    }
}

/// Number of readings in an interval for the torque estimate.
const STRETCH: usize = 5;

/// Returns the first and last time of each flight in a log, s. Readings at a limit of the gyro do
/// not end a flight, although the torque is unknown there.
pub fn find_flights(readings: &[GyroReading], search: &FlightSearch) -> Result<Vec<[f64; 2]>, IdentifyError> {
    let range = search.gyro_range.unwrap_or_else(|| GyroRange::shown_by(readings));
    let is_inside: Vec<bool> = readings.iter().map(|reading| range.holds(reading)).collect();
    let times: Vec<f64> = readings.iter().map(|r| r.time).collect();
    let omega: Vec<[f64; 3]> = readings.iter().map(|r| r.omega.to_array()).collect();
    let fast: Vec<bool> = readings.iter().map(|r| r.omega.norm() >= search.slowest).collect();
    // The middle half of each fast interval is probably flight.
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

/// Estimates the tensor for which most of the cores are nearly free. Starts from all cores, then
/// iterates with the half that has the smallest torque, because hands turn the others.
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

/// Returns true if the time step before a reading is more than three times the previous step: a
/// gap.
fn gap(times: &[f64], k: usize) -> bool {
    k >= 2 && times[k] - times[k - 1] > 3.0 * (times[k - 1] - times[k - 2])
}

/// Returns the torque |I Δω/Δt + mean of ω × I ω| of an interval, divided by the mean moment times
/// the mean of ω².
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

/// Returns the interval in which a flight is free, s; `None` if it is free nowhere. The torque must
/// be at most `limit` times the mean moment times ω², plus an allowance for noise.
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
    // One wrong reading affects at most `STRETCH` intervals, so up to that many intervals at an end
    // are ignored. In the first free interval, the first half may still not be free.
    let half = STRETCH / 2;
    let begin = if first > STRETCH { first + half } else { 0 };
    let end = if last - last_free > STRETCH { last_free + STRETCH - half } else { rates.times.len() };
    Some([rates.times[begin], rates.times[end - 1]])
}

/// Noise factor of the difference of two readings with three components each: √6.
const NOISE_OF_ENDS: f64 = 2.449_489_742_783_178;

/// Returns the maximal index ranges without a break in which `holds` is true.
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
