//! Rates in another unit than they are taken for.
//!
//! ω̇ is quadratic in ω: rates that are all κ times too large turn κ times too slowly for free motion, of any body.

use super::flight::Flight;
use super::options::TumbleOptions;
use super::tumble::Tumble;
use crate::error::IdentifyError;
use crate::residuals::ResidualTest;

/// Flights that are looked at.
const MOST: usize = 4;
/// A unit is wrong if another leaves so many times less, or if it leaves nothing but noise.
const BETTER: f64 = 10.0;
const BETTER_IF_NOISE: f64 = 2.0;
/// Of the rates; more is no motion of a free body.
const SMALL: f64 = 0.1;
const DEGREES: f64 = 180.0 / core::f64::consts::PI;

/// That the rates of the first flights do not move freely in degrees, or radians, where they do not as they are.
///
/// # Errors
/// [`IdentifyError::Unit`]
pub(super) fn require_right(
    flights: &[Flight],
    options: &TumbleOptions,
    identified: impl Fn(&[Flight], &TumbleOptions) -> Result<Tumble, IdentifyError>,
) -> Result<(), IdentifyError> {
    let first: Vec<Flight> =
        flights.iter().filter(|flight| !flight.gyro().is_empty()).take(MOST).cloned().collect();
    if first.is_empty() {
        return Ok(());
    }
    let left = |factor: f64| {
        let scaled: Vec<Flight> = first.iter().map(|flight| flight.with_rates_times(factor)).collect();
        let gyro_noise = options.gyro_noise.map(|noise| noise * factor);
        let found = identified(&scaled, &TumbleOptions { gyro_noise, ..*options });
        found.map_or((f64::INFINITY, false), |found| {
            let is_noise = !found.residuals.iter().any(ResidualTest::is_too_large);
            (share_left(&scaled, &found), is_noise)
        })
    };
    let (as_they_are, _) = left(1.0);
    for factor in [1.0 / DEGREES, DEGREES] {
        let (other, is_noise) = left(factor);
        let better = if is_noise { BETTER_IF_NOISE } else { BETTER };
        if other < SMALL && other * better < as_they_are {
            return Err(IdentifyError::Unit { factor, better: as_they_are.min(1.0) / other });
        }
    }
    Ok(())
}

/// What is left, over the rates.
fn share_left(flights: &[Flight], found: &Tumble) -> f64 {
    let square = |all: &mut dyn Iterator<Item = [f64; 3]>| all.flatten().map(|x| x * x).sum::<f64>();
    let left = square(&mut found.flights.iter().flat_map(|flight| flight.gyro_residuals.iter().copied()));
    let rates = square(&mut flights.iter().flat_map(|f| f.gyro().iter().map(|r| r.omega.to_array())));
    (left / rates).sqrt()
}
