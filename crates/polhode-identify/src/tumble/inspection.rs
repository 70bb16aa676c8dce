//! Detection of flaws in the readings.

use super::cut::{free_span, tensor_of_most};
use super::first_guess::Rates;
use super::flaw::Flaw;
use super::flight::Flight;
use super::gap::gaps;
use super::range::GyroRange;
use super::tumble::Tumble;
use crate::error::IdentifyError;

/// Largest torque that air drag may cause, relative to the mean moment times ω².
const TORQUE: f64 = 0.2;
/// Allowance for noise in the torque, standard deviations.
const NOISE: f64 = 6.0;

/// Returns the flaws of flights, given the estimate.
pub(super) fn flaws(
    flights: &[Flight],
    range: &GyroRange,
    found: &Tumble,
) -> Result<Vec<Flaw>, IdentifyError> {
    let mut flaws: Vec<Flaw> = range.reached(flights).into_iter().map(Flaw::Saturated).collect();
    for flight in flights {
        let times: Vec<f64> = flight.gyro().iter().map(|r| r.time).collect();
        let tracked: Vec<f64> = flight.attitudes().iter().map(|r| r.time).collect();
        for times in [times, tracked] {
            flaws.extend(gaps(&times).map(|[from, to]| Flaw::Gap {
                flight: flight.name().to_owned(),
                from,
                to,
            }));
        }
    }
    let noise = found.residuals.first().map_or(0.0, |test| test.noise);
    let left_out: Vec<&[f64]> = found.flights.iter().map(|fit| &fit.left_out[..]).collect();
    flaws.extend(hands(flights, range, noise, &left_out)?);
    Ok(flaws)
}

/// Returns the flights that a hand turns at the beginning or end. `left_out` has the times of
/// discarded readings of each fitted flight.
pub(super) fn hands(
    flights: &[Flight],
    range: &GyroRange,
    noise: f64,
    left_out: &[&[f64]],
) -> Result<Vec<Flaw>, IdentifyError> {
    let left_out = left_out.iter().copied().chain(core::iter::repeat(&[][..]));
    let free: Vec<(&Flight, &[f64], Rates)> = flights
        .iter()
        .zip(left_out)
        // A known wheel or torque is not a hand.
        .filter(|(f, _)| !f.gyro().is_empty() && f.wheels().is_empty() && f.torques().is_empty())
        .map(|(f, left_out)| (f, left_out, Rates::of(&f.of_gyro_readings(|reading| range.holds(reading)))))
        .filter(|(.., rates)| rates.times.len() >= LEAST)
        .collect();
    if free.is_empty() {
        return Ok(Vec::new());
    }
    let tensor = tensor_of_most(free.iter().map(|(.., rates)| rates.middle().without_gaps()).collect())?;
    let hand = |(flight, left_out, rates): (&Flight, &[f64], Rates)| {
        let given = [rates.times[0], rates.times[rates.times.len() - 1]];
        let [begin, end] = free_span(&rates, &tensor, TORQUE, NOISE * noise).unwrap_or(given);
        let [first, last] = used_span(&rates.times, left_out);
        let free = [begin.max(first), end.min(last)];
        (free != given).then(|| Flaw::Hand { flight: flight.name().to_owned(), free, given })
    };
    Ok(free.into_iter().filter_map(hand).collect())
}

/// Returns the first and last time of the readings, without discarded readings at the ends if there
/// are at least [`SEVERAL`].
fn used_span(times: &[f64], left_out: &[f64]) -> [f64; 2] {
    let is_used = |time: &f64| !left_out.contains(time);
    let last = times.len() - 1;
    let first_used = times.iter().position(is_used).filter(|&k| k >= SEVERAL);
    let last_used = times.iter().rposition(is_used).filter(|&k| last - k >= SEVERAL);
    [times[first_used.unwrap_or(0)], times[last_used.unwrap_or(last)]]
}

/// Minimum number of discarded readings at an end that shortens the flight.
const SEVERAL: usize = 4;

/// Minimum number of readings for the detection of a hand.
const LEAST: usize = 20;
