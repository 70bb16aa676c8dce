//! Flights in a long log: where the body turns, and nothing turns it.
//!
//! While the body is free, I ω̇ + ω × I ω = 0 but for noise and air. A hand that throws or catches it makes this torque as large as I ω². So stretches in which
//! the body turns fast give a first tensor, and with that the torque of every stretch of the log is looked at.

use super::first_guess::{Rates, cross_momentum, momentum, tensor};
use super::flight::GyroReading;

/// How flights are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlightSearch {
    /// In flight the body turns at least so fast, rad/s.
    pub slowest: f64,
    /// A flight lasts at least so long, s.
    pub shortest: f64,
    /// In flight the torque is at most this part of |I ω²|.
    pub torque: f64,
}

impl Default for FlightSearch {
    /// 3 rad/s, 0.3 s, a fifth.
    fn default() -> Self {
        Self { slowest: 3.0, shortest: 0.3, torque: 0.2 }
    }
}

/// Readings between which a torque is seen.
const STRETCH: usize = 5;

/// The first and the last time of each flight in a log, s.
pub fn find_flights(readings: &[GyroReading], search: &FlightSearch) -> Vec<[f64; 2]> {
    let times: Vec<f64> = readings.iter().map(|r| r.time).collect();
    let omega: Vec<[f64; 3]> = readings.iter().map(|r| r.omega.to_array()).collect();
    let fast: Vec<bool> = readings.iter().map(|r| r.omega.norm() >= search.slowest).collect();
    // The middle halves of what is fast are likely flights.
    let cores: Vec<Rates> = runs(&fast, |k| gap(&times, k))
        .into_iter()
        .filter(|run| times[run.end - 1] - times[run.start] >= search.shortest)
        .map(|run| {
            let quarter = run.len() / 4;
            let core = run.start + quarter..run.end - quarter;
            Rates { times: times[core.clone()].to_vec(), omega: omega[core].to_vec() }
        })
        .collect();
    if cores.is_empty() {
        return Vec::new();
    }
    let tensor = tensor_of_most(cores);
    let is_free: Vec<bool> = (0..omega.len())
        .map(|k| {
            let from = k.saturating_sub(STRETCH / 2);
            let to = (k + STRETCH / 2).min(omega.len() - 1);
            fast[k] && to > from && torque(&tensor, &times[from..=to], &omega[from..=to]) <= search.torque
        })
        .collect();
    runs(&is_free, |k| gap(&times, k))
        .into_iter()
        .map(|run| [times[run.start], times[run.end - 1]])
        .filter(|[from, to]| to - from >= search.shortest)
        .collect()
}

/// The tensor with which most of the cores are nearly free: of all of them first, then again and again of those half that are nearest to free, as hands turn
/// the rest.
fn tensor_of_most(mut cores: Vec<Rates>) -> [f64; 6] {
    const ROUNDS: usize = 6;
    let mut found = tensor(&cores);
    let half = cores.len().div_ceil(2);
    for _ in 0..ROUNDS {
        let by = |core: &Rates| mean_torque(&found, core);
        cores.sort_by(|a, b| by(a).total_cmp(&by(b)));
        found = tensor(&cores[..half]);
    }
    found
}

fn mean_torque(tensor: &[f64; 6], rates: &Rates) -> f64 {
    let stretches = rates.times.windows(STRETCH).zip(rates.omega.windows(STRETCH));
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
