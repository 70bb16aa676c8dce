//! Determination of the meaning of a log's angular velocities, by comparison with the exact motion.

use super::axes::SignedAxes;
use super::beginning::{Beginning, CLEARLY, COMPARED};
use super::declared::{DeclaredReading, OmegaAxes};
use super::difference::angle_between;
use super::error::JudgeError;
use super::log::MotionLog;
use super::omega_reading::{OmegaReading, OmegaResidual};
use super::reading::Reading;
use super::reference::{spread, states_within};
use crate::motion::model::state::State;
use crate::motion::task::scenario::Scenario;

/// Largest error of ω of a reading that fits, relative to |ω|; wrong components or a wrong unit
/// cause a larger error.
const OMEGA_FITS: f64 = 0.3;
/// Relative error of ω below which no other reading is tried; single precision satisfies it.
const OMEGA_EXACT: f64 = 1e-6;
/// Relative difference of equal angular velocities: the rounding of two conversions.
const OMEGA_SAME: f64 = 1e-12;
/// Largest relative error of a first row that begins like the scenario; single precision and four
/// digits satisfy it.
const OMEGA_BEGUN: f64 = 1e-4;
/// Attitude error, rad, above which a row gives no information on ω.
const FOLLOWED: f64 = 0.1;
/// Maximum number of integration steps to the last row.
const MOST: usize = 200_000;

/// Rows in which ω is compared.
struct Rows<'a> {
    log: &'a MotionLog,
    omega: &'a [[f64; 3]],
    reading: &'a Reading,
    compared: Vec<(usize, State)>,
}

impl Rows<'_> {
    fn read(&self, row: usize, meant: OmegaReading) -> [f64; 3] {
        self.reading.omega(self.omega[row], meant, self.log.attitude()[row]).to_array()
    }

    fn off(&self, meant: OmegaReading) -> f64 {
        let (mut off, mut size) = (0.0, 0.0);
        for (row, exact) in &self.compared {
            let exact = exact.omega.to_array();
            off += distance(self.read(*row, meant), exact).powi(2);
            size += distance(exact, [0.0; 3]).powi(2);
        }
        (off / size).sqrt()
    }

    fn first_off(&self, meant: OmegaReading) -> f64 {
        let Some((row, exact)) = self.compared.first() else { return f64::INFINITY };
        let exact = exact.omega.to_array();
        distance(self.read(*row, meant), exact) / distance(exact, [0.0; 3])
    }

    fn is_same(&self, a: OmegaReading, b: OmegaReading) -> bool {
        let same = |row: usize| {
            let (a, b) = (self.read(row, a), self.read(row, b));
            distance(a, b) <= OMEGA_SAME * distance(a, [0.0; 3])
        };
        spread(self.omega.len(), COMPARED).into_iter().all(same)
    }

    /// Returns the simplest of the readings that fit; `None` if there is none, or if another one is
    /// equally simple and different.
    ///
    /// Returns neither a mirrored ω nor one along other axes if the two cannot be distinguished, as
    /// for motion about one axis.
    fn plainest(&self, fitting: &[OmegaResidual], meant: Option<OmegaAxes>) -> Option<OmegaReading> {
        let kind = |reading: OmegaReading| match reading {
            _ if reading.is_plain() => Kind::Plain,
            _ if reading.components == SignedAxes::SAME => Kind::Unit,
            _ if reading.has_axes(self.reading.sense) => Kind::Axes,
            _ => Kind::Mirrored,
        };
        let rank = |reading: OmegaReading| (kind(reading), meant.is_some_and(|frame| frame != reading.frame));
        let one = fitting.iter().map(|one| one.reading).min_by_key(|&one| rank(one))?;
        let is_rival = |other: OmegaReading| {
            rank(other) == rank(one) && !self.is_same(one, other)
                || [kind(one), kind(other)] == [Kind::Axes, Kind::Mirrored]
        };
        (!fitting.iter().any(|other| is_rival(other.reading))).then_some(one)
    }
}

/// Kinds of readings, the simplest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Plain,
    Unit,
    Axes,
    /// Mirrored components, a mistake: see [`OmegaReading::has_axes`].
    Mirrored,
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
}

/// Determines the meaning of a log's angular velocities. Of readings that fit about equally well,
/// the simplest is used.
///
/// It tries the declared reading, body and space axes in the stated unit, other units, and
/// exchanged and negated components.
///
/// # Errors
/// [`JudgeError::AmbiguousOmega`] if several readings fit and differ; [`JudgeError::NoOmega`] if
/// none fits.
pub(super) fn omega_reading(
    log: &MotionLog,
    omega: &[[f64; 3]],
    scenario: &Scenario,
    declared: &DeclaredReading,
    reading: &Reading,
    beginning: &Beginning,
) -> Result<OmegaReading, JudgeError> {
    if let Some(frame) = declared.certain().omega_axes {
        return Ok(OmegaReading::plain(frame));
    }
    let compared = compared(log, scenario, reading, beginning);
    let rows = Rows { log, omega, reading, compared };
    let [body, space] = OmegaAxes::ALL.map(OmegaReading::plain);
    if rows.is_same(body, space) && rows.off(body) <= OMEGA_FITS {
        return Ok(OmegaReading::plain(declared.omega_axes.unwrap_or(OmegaAxes::Body)));
    }
    let meant = declared.omega_axes;
    let [of_body, of_space] = [body, space].map(|plain| rows.off(plain));
    // In this case no other reading is tried.
    let is_exact = |one: f64, other: f64| one <= OMEGA_EXACT && CLEARLY * one.max(OMEGA_SAME) < other;
    let exact = match meant {
        Some(OmegaAxes::Body) => (of_body <= OMEGA_EXACT).then_some(body),
        Some(OmegaAxes::Space) => (of_space <= OMEGA_EXACT).then_some(space),
        None if is_exact(of_body, of_space) => Some(body),
        None if is_exact(of_space, of_body) => Some(space),
        None => None,
    };
    if let Some(exact) = exact {
        return Ok(exact);
    }
    let mut tried: Vec<OmegaResidual> = readings(declared)
        .map(|reading| OmegaResidual { reading, relative: rows.off(reading) })
        .filter(|tried| tried.relative.is_finite())
        .collect();
    tried.sort_by(|a, b| a.relative.total_cmp(&b.relative));
    let best = tried.first().map_or(f64::INFINITY, |best| best.relative);
    let bound = OMEGA_FITS.min(CLEARLY * best.max(OMEGA_SAME));
    let fitting: Vec<OmegaResidual> = tried.iter().copied().take_while(|one| one.relative <= bound).collect();
    if let Some(one) = rows.plainest(&fitting, meant) {
        return Ok(one);
    }
    // With a wrong law of motion, only the first row may be correct.
    let begun: Vec<OmegaReading> = [body, space]
        .into_iter()
        .filter(|plain| {
            meant.is_none_or(|frame| frame == plain.frame) && rows.first_off(*plain) < OMEGA_BEGUN
        })
        .collect();
    match begun[..] {
        [only] => return Ok(only),
        [one, other] if CLEARLY * rows.first_off(one) <= rows.first_off(other) => return Ok(one),
        [one, other] if CLEARLY * rows.first_off(other) <= rows.first_off(one) => return Ok(other),
        _ => {}
    }
    Err(match fitting.is_empty() {
        false => JudgeError::AmbiguousOmega { tried: fitting },
        true => JudgeError::NoOmega { tried },
    })
}

/// Returns all readings that are tried, the simplest first.
fn readings(declared: &DeclaredReading) -> impl Iterator<Item = OmegaReading> {
    let is_certain = declared.omega_factor.is_some();
    let factors = OmegaReading::FACTORS.into_iter().filter(move |(factor, _)| !is_certain || *factor == 1.0);
    factors.flat_map(|(factor, _)| {
        let both = SignedAxes::ALL.into_iter().chain(SignedAxes::ALL.map(SignedAxes::reversed));
        both.flat_map(move |components| {
            OmegaAxes::ALL.map(|frame| OmegaReading { frame, components, factor })
        })
    })
}

/// Returns the beginning, and later rows as long as their attitudes are close to the exact motion.
fn compared(
    log: &MotionLog,
    scenario: &Scenario,
    reading: &Reading,
    beginning: &Beginning,
) -> Vec<(usize, State)> {
    let mut compared: Vec<(usize, State)> =
        beginning.rows.iter().copied().zip(beginning.exact.iter().copied()).collect();
    let Some(&(last, _)) = compared.last() else { return compared };
    let Some((_, first)) = compared.first().copied() else { return compared };
    let later: Vec<usize> =
        spread(log.times().len(), COMPARED).into_iter().filter(|row| *row > last).collect();
    let times: Vec<f64> = later.iter().map(|&row| reading.time(log.times()[row])).collect();
    let Ok(Some(exact)) = states_within(scenario, first, &times, MOST) else { return compared };
    let follows = |(row, exact): &(usize, State)| {
        angle_between(exact.attitude.quaternion(), reading.quaternion(log.attitude()[*row])) < FOLLOWED
    };
    compared.extend(later.into_iter().zip(exact).take_while(follows));
    compared
}
