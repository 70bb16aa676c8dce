//! Estimation of a body from its flights.

use polhode::math::{Body, Rotation};

use super::first_guess::{Rates, tensor_with_scale, tracked_axes};
use super::flaw::Flaw;
use super::flight::{Flight, GyroReading};
use super::inspection::{flaws, hands};
use super::model::{CHANNELS, Reference, Tumbles};
use super::motion::turn;
use super::noise::noise;
use super::options::TumbleOptions;
use super::range::GyroRange;
use super::sensor::GyroErrors;
use super::tumble::Tumble;
use super::unit;
use crate::coordinates::{Coordinates, Part};
use crate::error::IdentifyError;
use crate::least_squares::{Outliers, Place, approach, fit_robustly};
use crate::residuals::{Noise, ResidualTest};

/// Largest rotation of a piece in the first fit, rad, and its growth factor in each further fit.
const FIRST_TURN: f64 = 3.0;
const GROWTH: f64 = 4.0;
/// Threshold of full weight in the fits of pieces, standard deviations.
const FULL: f64 = 4.0;

/// Estimates the body whose free motion predicts the readings best.
///
/// The parameters are the tensor along the gyro's axes, the requested gyro errors, and each
/// flight's ω. The scale of the tensor is determined only if something known distinguishes flights
/// (an added body, a wheel, a torque). Flights are first cut into short pieces, so that no
/// predicted phase is wrong by a turn.
///
/// # Errors
/// - [`IdentifyError::TooFew`] for fewer readings than parameters
/// - [`IdentifyError::Missing`] for attitudes without their noise
/// - [`IdentifyError::Value`] for invalid options, and if the body turns by half a turn or more
///   between readings
/// - [`IdentifyError::OneBody`] if all flights have the same body added
/// - [`IdentifyError::Saturated`] for a flight with too few readings inside the gyro's range
/// - [`IdentifyError::Unit`] and [`IdentifyError::LeftHanded`] if the rates fit only in another
///   unit, or with an axis reversed
/// - [`IdentifyError::NotFree`] if nothing fits and a hand turns the body in a flight
/// - [`IdentifyError::Steady`] for constant rates
/// - [`IdentifyError::NoConvergence`] if the fit does not converge
pub fn identify_tumbles(flights: &[Flight], options: &TumbleOptions) -> Result<Tumble, IdentifyError> {
    let readings: Vec<GyroReading> =
        flights.iter().flat_map(|flight| flight.gyro().iter().copied()).collect();
    let range = options.gyro_range.unwrap_or_else(|| GyroRange::shown_by(&readings));
    let (all, flights) = (flights, range.inside(flights)?);
    require_two_bodies(&flights)?;
    let found = unit::require_fine(&flights).and_then(|()| identified(&flights, options));
    let is_doubtful = match &found {
        Ok(found) => found.residuals.iter().any(ResidualTest::is_too_large),
        Err(error) => matches!(
            error,
            IdentifyError::NoConvergence { .. }
                | IdentifyError::NotFinite { .. }
                | IdentifyError::Value { .. }
        ),
    };
    if is_doubtful {
        unit::require_right(&flights, options, identified)?;
    }
    let found = found.map_err(|error| {
        let hands = if is_doubtful { hands(all, &range, 0.0, &[]).unwrap_or_default() } else { Vec::new() };
        match hands.into_iter().next() {
            Some(Flaw::Hand { flight, free, .. }) => IdentifyError::NotFree { flight, free },
            _ => error,
        }
    })?;
    Ok(Tumble { flaws: flaws(all, &range, &found)?, ..found })
}

/// Estimates the body like [`identify_tumbles`], without tests of unit, handedness and range.
fn identified(flights: &[Flight], options: &TumbleOptions) -> Result<Tumble, IdentifyError> {
    let has_gyro = flights.iter().any(|flight| !flight.gyro().is_empty());
    let has_attitudes = flights.iter().any(|flight| !flight.attitudes().is_empty());
    let gyro = if has_gyro { options.gyro } else { GyroErrors::default() };
    let given: usize = flights.iter().map(|f| CHANNELS * (f.gyro().len() + f.attitudes().len())).sum();
    let needed = 7 + gyro.count() + if options.drag.is_some() { 6 } else { 0 } + flights.len() * 3;
    if given < needed {
        return Err(IdentifyError::TooFew { what: "measured values in flights", given, needed });
    }
    let positive = |what, value: f64| IdentifyError::require(what, value, value > 0.0, "positive");
    positive("the outlier threshold", options.outlier)?;
    let attitude_noise = match options.attitude_noise {
        None if has_attitudes => return Err(IdentifyError::Missing { what: "the noise of the attitudes" }),
        noise => noise.unwrap_or(1.0),
    };
    positive("the noise of the attitudes", attitude_noise)?;
    let gyro_noise = if has_gyro { gyro_noise(flights, options)? } else { Noise::told(1.0) };
    if !has_attitudes && options.drag.is_none() && !flights.iter().any(Flight::has_scale) {
        require_change(flights, gyro_noise)?;
    }
    let tracked = (has_gyro && has_attitudes).then(|| tracked_axes(flights)).transpose()?;

    let mut shared = tensor_with_scale(flights)?.to_vec();
    if options.drag.is_some() {
        shared.extend(first_drag(&shared));
    }
    shared.extend(vec![0.0; gyro.count() + if tracked.is_some() { 3 } else { 0 }]);
    let mut most = FIRST_TURN;
    let mut states = Vec::new();
    loop {
        let pieces = pieces(flights, most);
        let is_whole = pieces.len() == flights.len();
        let cut: Vec<Flight> = pieces.iter().map(|piece| piece.flight.clone()).collect();
        let references = cut.iter().map(|flight| Reference::of(flight, gyro.clock)).collect();
        let problem = Tumbles {
            flights: &cut,
            references,
            gyro,
            gyro_noise,
            attitude_noise,
            drag: options.drag,
            tracked,
        };
        let coordinates = coordinates(&problem);
        let local = (0..cut.len()).map(|k| first_local(&problem, k, &pieces[k], &states, &shared)).collect();
        let place = Place { shared: coordinates.of(&shared), local };
        if is_whole {
            let (last, outliers) = fit_robustly(&problem, &coordinates, place, options.outlier)?;
            return Tumble::of(&problem, &last, outliers);
        }
        let found = approach(&problem, &coordinates, place, Outliers::Damped(FULL))?;
        shared.clone_from(&found.shared);
        states = (0..cut.len())
            .map(|k| (pieces[k].number, cut[k].span(), problem.state(k, &found.place.local[k])))
            .collect();
        most *= GROWTH;
    }
}

/// Returns an error if all flights have the same body added, and nothing else is known.
///
/// They determine I + added up to scale, and so neither the size of I nor its ratios.
fn require_two_bodies(flights: &[Flight]) -> Result<(), IdentifyError> {
    let is_same = |flight: &Flight| {
        flight.added() == flights[0].added() && flight.wheels().is_empty() && flight.torques().is_empty()
    };
    if flights.first().is_some_and(|first| first.added() != [0.0; 6]) && flights.iter().all(is_same) {
        return Err(IdentifyError::OneBody { flights: flights.len() });
    }
    Ok(())
}

/// Returns an error if the rates do not change by more than the noise.
fn require_change(flights: &[Flight], noise: Noise) -> Result<(), IdentifyError> {
    let from_mean = |flight: &Flight, k: usize| -> Vec<f64> {
        let rates = || flight.gyro().iter().map(|reading| reading.omega.to_array()[k]);
        let mean = rates().sum::<f64>() / flight.gyro().len() as f64;
        rates().map(|rate| (rate - mean) / noise.deviation).collect()
    };
    let runs: Vec<Vec<f64>> =
        flights.iter().flat_map(|flight| [0, 1, 2].map(|k| from_mean(flight, k))).collect();
    let left = ResidualTest::of("change of the rates", noise, runs.len() as f64, &runs);
    if left.is_too_large() || left.is_correlated() {
        return Ok(());
    }
    Err(IdentifyError::Steady { noise: noise.deviation })
}

/// Returns the coordinates of the shared parameters.
fn coordinates(problem: &Tumbles<'_>) -> Coordinates {
    let mut parts = vec![Part::Tensor];
    parts.extend(problem.drag.map(|_| Part::Positive3));
    parts.push(Part::Free(problem.shared() - 6 - problem.drag_count()));
    Coordinates::new(parts)
}

/// Returns initial drag that lowers the rate by about 1 % in a second.
fn first_drag(tensor: &[f64]) -> [f64; 6] {
    let mean = (tensor[0] + tensor[1] + tensor[2]) / 3.0;
    [0.01 * mean, 0.01 * mean, 0.01 * mean, 0.0, 0.0, 0.0]
}

fn gyro_noise(flights: &[Flight], options: &TumbleOptions) -> Result<Noise, IdentifyError> {
    if let Some(noise) = options.gyro_noise {
        IdentifyError::require("the gyro's noise", noise, noise > 0.0, "positive")?;
        return Ok(Noise::told(noise));
    }
    let channels: Vec<Vec<Vec<f64>>> = flights
        .iter()
        .filter(|flight| !flight.gyro().is_empty())
        .map(|flight| Rates::of(flight).without_gaps())
        .flat_map(|runs| [0, 1, 2].map(|k| runs.iter().map(|run| run.channel(k)).collect()))
        .collect();
    match noise(&channels) {
        Some(noise) if noise.deviation > 0.0 => Ok(noise),
        _ => Err(IdentifyError::Missing {
            what: "the gyro's noise (it cannot be estimated from these readings)",
        }),
    }
}

/// Part of a flight.
struct Piece {
    flight: Flight,
    /// Index of the flight.
    number: usize,
}

/// Cuts flights into pieces that turn by at most `turn`, rad.
fn pieces(flights: &[Flight], turn: f64) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for (number, flight) in flights.iter().enumerate() {
        let rates = Rates::of(flight);
        let [from, to] = flight.span();
        let mean = rates.omega.iter().map(|w| (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]).sqrt()).sum::<f64>()
            / rates.omega.len().max(1) as f64;
        // At most one piece per reading: in a wrong unit the rotation may be arbitrarily large.
        let most = (flight.gyro().len() + flight.attitudes().len()) as f64;
        let count = ((to - from) * mean / turn).ceil().clamp(1.0, most);
        let width = (to - from) / count;
        // A boundary belongs to the piece before it. Readings too few for a piece join the next
        // piece, or the last.
        let mut starts = vec![from];
        let end = |k: f64| if k == count { to } else { from + k * width };
        let mut own: Vec<Flight> = Vec::new();
        for k in 1..=count as usize {
            let start = starts[starts.len() - 1];
            if let Some(cut) = flight.cut(start, end(k as f64)) {
                own.push(cut);
                starts.push(end(k as f64).next_up());
            }
        }
        if let [.., last, next] = starts[..]
            && next <= to
        {
            own.pop();
            own.extend(flight.cut(last, to));
        }
        pieces.extend(own.into_iter().map(|flight| Piece { flight, number }));
    }
    pieces
}

impl Reference {
    /// Returns the start of a flight with its first measured attitude. With an estimated clock the
    /// time is earlier, because the clock may move readings before the first.
    fn of(flight: &Flight, clock: bool) -> Self {
        let [from, _] = flight.span();
        let attitude = flight.attitudes().first().map_or_else(Rotation::identity, |reading| reading.attitude);
        Self { time: if clock { from - MOST_CLOCK } else { from }, attitude }
    }
}

/// Upper bound on the offset of an estimated clock, s.
const MOST_CLOCK: f64 = 0.25;

/// Returns the initial values of a flight's local parameters: from the nearest piece of the
/// previous fit, or from the readings at its reference.
fn first_local(
    problem: &Tumbles<'_>,
    k: usize,
    piece: &Piece,
    states: &[(usize, [f64; 2], polhode::motion::State)],
    shared: &[f64],
) -> Vec<f64> {
    let time = problem.references[k].time;
    let around = states
        .iter()
        .filter(|(number, ..)| *number == piece.number)
        .min_by(|(_, a, _), (_, b, _)| beyond(*a, time).total_cmp(&beyond(*b, time)));
    let fitted = around.and_then(|(.., state)| problem.flown(k, shared).state_at(*state, time).ok());
    let omega = fitted.map_or_else(|| Rates::of(&piece.flight).at(time), |state| state.omega.to_array());
    let mut local = omega.to_vec();
    if problem.local(k) == 6 {
        // The first attitude belongs to the tracked axes, and to a slightly later time:
        // R = R_measured A⁻¹ exp(−ω Δt).
        let axes: Rotation<Body, Body> = problem.tracked.unwrap_or_else(Rotation::identity);
        let later = piece.flight.attitudes().first().map_or(0.0, |reading| reading.time - time);
        local.extend((axes.inverse() * turn(omega.map(|w| -w * later))).log().to_array());
    }
    local
}

/// Returns the distance of a time from an interval, s; 0 inside.
fn beyond([from, to]: [f64; 2], time: f64) -> f64 {
    (from - time).max(time - to).max(0.0)
}
