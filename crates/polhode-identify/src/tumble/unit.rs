//! Detection of rates in a wrong unit, or along left-handed axes.
//!
//! ω̇ is quadratic in ω. If all rates are read too large by a factor κ, they change too slowly by κ
//! for the free motion of any body. Left-handed axes correspond to κ = −1.

use core::cell::OnceCell;

use polhode::motion::torque::DragLaw;

use super::flight::Flight;
use super::handedness;
use super::options::TumbleOptions;
use super::tumble::Tumble;
use crate::error::IdentifyError;
use crate::residuals::ResidualTest;

/// Maximum number of flights tested, separately with and without a known scale.
const MOST: usize = 4;
/// Minimum ratio of residuals that proves an error; the second value holds if only noise remains.
const BETTER: f64 = 10.0;
const BETTER_IF_NOISE: f64 = 2.0;
/// Upper bound on the residual of free motion, relative to the rates.
const SMALL: f64 = 0.05;
/// Upper bound on the residual, relative to the variation of the rates; a constant rate leaves 1.
const STEADY: f64 = 0.3;
const DEGREES: f64 = 180.0 / core::f64::consts::PI;
/// Conversion factors to rad/s of rates in deg/s, rpm, rev/s; and of rates in rad/s that were read
/// as deg/s.
const UNITS: [f64; 4] = [1.0 / DEGREES, core::f64::consts::PI / 30.0, core::f64::consts::TAU, DEGREES];

/// Returns an error if the rates of the first flights fit in another unit or with reversed axes,
/// but do not fit as read.
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
    let left = |factors: [f64; 3], drag: Option<DragLaw>| {
        let scaled: Vec<Flight> = first.iter().map(|flight| flight.with_rates_times(factors)).collect();
        // Rates too fast for the sampling in this unit belong to another unit.
        if require_fine(&scaled).is_err() {
            return (f64::INFINITY, false);
        }
        let gyro_noise = options.gyro_noise.map(|noise| noise * factors[0].abs());
        let found = identified(&scaled, &TumbleOptions { gyro_noise, drag, ..*options });
        found.map_or((f64::INFINITY, false), |found| {
            let is_noise = !found.residuals.iter().any(ResidualTest::is_too_large);
            (share_left(&scaled, &found), is_noise)
        })
    };
    // Without drag the motion has a closed form. So candidates are first screened without it.
    let without = options.drag.map(|_| left([1.0; 3], None).0);
    let is_likely =
        |factors| without.is_none_or(|as_they_are| left(factors, None).0 * BETTER_IF_NOISE < as_they_are);
    let as_they_are = OnceCell::new();
    // Nearly constant rates fit in every unit.
    let most = f64::min(SMALL, STEADY * varying(&first));
    let better = |(other, is_noise): (f64, bool)| {
        let (as_they_are, _) = *as_they_are.get_or_init(|| left([1.0; 3], options.drag));
        let better = if is_noise { BETTER_IF_NOISE } else { BETTER };
        // If the fit of the rates as read failed, only a fit down to the noise is evidence.
        let says = is_noise || as_they_are.is_finite();
        (says && other < most && other * better < as_they_are).then(|| as_they_are.min(1.0) / other)
    };
    let tried = UNITS.into_iter().filter(|&factor| is_likely([factor; 3]));
    let tried = tried.map(|factor| (factor, left([factor; 3], options.drag)));
    if let Some((factor, least)) = tried.min_by(|a, b| a.1.0.total_cmp(&b.1.0))
        && let Some(better) = better(least)
    {
        return Err(IdentifyError::Unit { factor, better });
    }
    let reversed = handedness::left_handed(&first).iter();
    let reversed = reversed.filter(|(_, factors)| is_likely(*factors));
    let reversed = reversed.filter_map(|&(axes, factors)| Some((axes, better(left(factors, options.drag))?)));
    match reversed.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((axes, better)) => Err(IdentifyError::LeftHanded { axes, better }),
        None => Ok(()),
    }
}

/// Returns an error if a flight turns by half a turn or more between readings: such motion is
/// undersampled.
///
/// # Errors
/// [`IdentifyError::Value`]
pub(super) fn require_fine(flights: &[Flight]) -> Result<(), IdentifyError> {
    for flight in flights.iter().filter(|flight| flight.gyro().len() > 1) {
        let [from, to] = flight.span();
        let rates: f64 = flight.gyro().iter().map(|r| r.omega.norm()).sum();
        let readings = flight.gyro().len() as f64;
        let turn = rates / readings * (to - from) / (readings - 1.0);
        let rule = "less than π; check that times are in s and rates in rad/s";
        IdentifyError::require(
            "the rotation from one reading to the next, rad,",
            turn,
            turn < core::f64::consts::PI,
            rule,
        )?;
    }
    Ok(())
}

/// Returns the root mean square deviation of the rates from each flight's mean, relative to the
/// rates.
fn varying(flights: &[Flight]) -> f64 {
    let (mut varying, mut all) = (0.0, 0.0);
    for flight in flights {
        let count = flight.gyro().len() as f64;
        for axis in 0..3 {
            let rates = || flight.gyro().iter().map(|r| r.omega.to_array()[axis]);
            let mean = rates().sum::<f64>() / count;
            varying += rates().map(|w| (w - mean) * (w - mean)).sum::<f64>();
            all += rates().map(|w| w * w).sum::<f64>();
        }
    }
    (varying / all).sqrt()
}

/// Returns the root mean square residual, relative to the rates.
fn share_left(flights: &[Flight], found: &Tumble) -> f64 {
    let square = |all: &mut dyn Iterator<Item = [f64; 3]>| all.flatten().map(|x| x * x).sum::<f64>();
    let left = square(&mut found.flights.iter().flat_map(|flight| flight.gyro_residuals.iter().copied()));
    let rates = square(&mut flights.iter().flat_map(|f| f.gyro().iter().map(|r| r.omega.to_array())));
    (left / rates).sqrt()
}
