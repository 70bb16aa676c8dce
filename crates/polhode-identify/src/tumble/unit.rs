//! Rates in another unit than they are taken for, or along axes that are left-handed.
//!
//! ω̇ is quadratic in ω: rates that are all κ times too large turn κ times too slowly for free motion, of any body. Axes that are left-handed are κ = −1.

use core::cell::OnceCell;

use polhode::motion::torque::DragLaw;

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
/// Of what rates vary by: as much is left if they are taken for steady.
const STEADY: f64 = 0.3;
const DEGREES: f64 = 180.0 / core::f64::consts::PI;
/// By what rates have to be multiplied: in deg/s, in rpm, in rev/s; and in rad/s, where they were taken for deg/s.
const UNITS: [f64; 4] = [1.0 / DEGREES, core::f64::consts::PI / 30.0, core::f64::consts::TAU, DEGREES];

/// That the rates of the first flights do not move as they have to in another unit, or reversed, where they do not as they are.
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
        // What turns too fast to be followed in this unit is in another.
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
    // Without drag the motions are in closed form: only what is better so is looked at with it.
    let without = options.drag.map(|_| left([1.0; 3], None).0);
    let is_likely =
        |factors| without.is_none_or(|as_they_are| left(factors, None).0 * BETTER_IF_NOISE < as_they_are);
    let as_they_are = OnceCell::new();
    // What hardly varies fits in every unit.
    let most = f64::min(SMALL, STEADY * varying(&first));
    let better = |(other, is_noise): (f64, bool)| {
        let (as_they_are, _) = *as_they_are.get_or_init(|| left([1.0; 3], options.drag));
        let better = if is_noise { BETTER_IF_NOISE } else { BETTER };
        // Where nothing was found as they are, only what fits well says more.
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

/// That a flight turns by less than half a turn from reading to reading: what turns faster cannot be followed.
///
/// # Errors
/// [`IdentifyError::Value`]
pub(super) fn require_fine(flights: &[Flight]) -> Result<(), IdentifyError> {
    for flight in flights.iter().filter(|flight| flight.gyro().len() > 1) {
        let [from, to] = flight.span();
        let rates: f64 = flight.gyro().iter().map(|r| r.omega.norm()).sum();
        let readings = flight.gyro().len() as f64;
        let turn = rates / readings * (to - from) / (readings - 1.0);
        let rule = "less than π: are the times in s, or the rates in rad/s?";
        IdentifyError::require(
            "the turn from reading to reading, rad,",
            turn,
            turn < core::f64::consts::PI,
            rule,
        )?;
    }
    Ok(())
}

/// How far rates are from their mean in each flight, over the rates.
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

/// What is left, over the rates.
fn share_left(flights: &[Flight], found: &Tumble) -> f64 {
    let square = |all: &mut dyn Iterator<Item = [f64; 3]>| all.flatten().map(|x| x * x).sum::<f64>();
    let left = square(&mut found.flights.iter().flat_map(|flight| flight.gyro_residuals.iter().copied()));
    let rates = square(&mut flights.iter().flat_map(|f| f.gyro().iter().map(|r| r.omega.to_array())));
    (left / rates).sqrt()
}
