//! Rates in another unit than they are taken for, or along axes that are left-handed.
//!
//! ω̇ is quadratic in ω: rates that are all κ times too large turn κ times too slowly for free motion, of any body. Axes that are left-handed are κ = −1.

use super::flight::Flight;
use super::handedness;
use super::options::TumbleOptions;
use super::tumble::Tumble;
use crate::error::IdentifyError;
use crate::residuals::ResidualTest;

/// Flights that are looked at, of those with something known in them and of those without.
const MOST: usize = 4;
/// Rates are wrong if others leave so many times less, or if they leave nothing but noise.
const BETTER: f64 = 10.0;
const BETTER_IF_NOISE: f64 = 2.0;
/// Of the rates; more is no motion of a free body.
const SMALL: f64 = 0.05;
const DEGREES: f64 = 180.0 / core::f64::consts::PI;

/// That the rates of the first flights do not move as they have to in degrees, or radians, or reversed, where they do not as they are.
///
/// # Errors
/// [`IdentifyError::Unit`], [`IdentifyError::LeftHanded`]
pub(super) fn require_right(
    flights: &[Flight],
    options: &TumbleOptions,
    identified: impl Fn(&[Flight], &TumbleOptions) -> Result<Tumble, IdentifyError>,
) -> Result<(), IdentifyError> {
    let of = |has_scale: bool| {
        let wanted = flights.iter().filter(move |f| !f.gyro().is_empty() && f.has_scale() == has_scale);
        wanted.take(MOST).cloned()
    };
    let first: Vec<Flight> = of(false).chain(of(true)).collect();
    if first.is_empty() {
        return Ok(());
    }
    let left = |factors: [f64; 3]| {
        let scaled: Vec<Flight> = first.iter().map(|flight| flight.with_rates_times(factors)).collect();
        let gyro_noise = options.gyro_noise.map(|noise| noise * factors[0].abs());
        let found = identified(&scaled, &TumbleOptions { gyro_noise, ..*options });
        found.map_or((f64::INFINITY, false), |found| {
            let is_noise = !found.residuals.iter().any(ResidualTest::is_too_large);
            (share_left(&scaled, &found), is_noise)
        })
    };
    let (as_they_are, _) = left([1.0; 3]);
    let better = |factors: [f64; 3]| {
        let (other, is_noise) = left(factors);
        let better = if is_noise { BETTER_IF_NOISE } else { BETTER };
        (other < SMALL && other * better < as_they_are).then(|| as_they_are.min(1.0) / other)
    };
    for factor in [1.0 / DEGREES, DEGREES] {
        if let Some(better) = better([factor; 3]) {
            return Err(IdentifyError::Unit { factor, better });
        }
    }
    let reversed = handedness::left_handed(&first).iter();
    let reversed = reversed.filter_map(|&(axes, factors)| Some((axes, better(factors)?)));
    match reversed.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((axes, better)) => Err(IdentifyError::LeftHanded { axes, better }),
        None => Ok(()),
    }
}

/// What is left, over the rates.
fn share_left(flights: &[Flight], found: &Tumble) -> f64 {
    let square = |all: &mut dyn Iterator<Item = [f64; 3]>| all.flatten().map(|x| x * x).sum::<f64>();
    let left = square(&mut found.flights.iter().flat_map(|flight| flight.gyro_residuals.iter().copied()));
    let rates = square(&mut flights.iter().flat_map(|f| f.gyro().iter().map(|r| r.omega.to_array())));
    (left / rates).sqrt()
}
