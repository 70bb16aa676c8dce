//! The meaning of a log's angular velocities, found by those of the exact motion.

use super::axes::SignedAxes;
use super::beginning::{Beginning, COMPARED};
use super::declared::{DeclaredReading, OmegaAxes};
use super::difference::angle_between;
use super::error::JudgeError;
use super::log::MotionLog;
use super::omega_reading::{OmegaReading, OmegaResidual};
use super::reading::Reading;
use super::reference::{spread, states_within};
use crate::motion::model::state::State;
use crate::motion::task::scenario::Scenario;

/// A reading fits if ω is off by no more than this part of |ω|.
const FITS: f64 = 0.3;
/// Bound of the same below which no other reading is tried.
const EXACT: f64 = 1e-6;
/// It is the one that is meant if all others are this many times farther off.
const CLEARLY: f64 = 10.0;
/// Relative difference of angular velocities that are the same.
const SAME: f64 = 1e-12;
/// A first row that is off by less than this part begins as the scenario: programs may have single precision.
const BEGUN: f64 = 1e-4;
/// Attitudes farther off than this, rad, say nothing of ω.
const FOLLOWED: f64 = 0.1;
/// Steps of integration to the last row.
const MOST: usize = 200_000;

/// The rows that ω is compared in.
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
            distance(a, b) <= SAME * distance(a, [0.0; 3])
        };
        spread(self.omega.len(), COMPARED).into_iter().all(same)
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
}

/// Finds the meaning of a log's angular velocities. Tried in turn: as declared; in the stated unit, along body or space axes; in
/// another unit or with exchanged and negated components, if only one of these fits.
///
/// # Errors
/// [`JudgeError::AmbiguousOmega`] where several readings fit and differ, [`JudgeError::NoOmega`] where none fits.
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
    if rows.is_same(body, space) && rows.off(body) <= FITS {
        return Ok(OmegaReading::plain(declared.omega_axes.unwrap_or(OmegaAxes::Body)));
    }
    let meant = declared.omega_axes;
    let [of_body, of_space] = [body, space].map(|plain| rows.off(plain));
    // No other reading has to be tried.
    let exact = match meant {
        Some(OmegaAxes::Body) => (of_body <= EXACT).then_some(body),
        Some(OmegaAxes::Space) => (of_space <= EXACT).then_some(space),
        None if of_body <= EXACT && CLEARLY * of_body.max(SAME) < of_space => Some(body),
        None if of_space <= EXACT && CLEARLY * of_space.max(SAME) < of_body => Some(space),
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
    let plain = |other: &&OmegaResidual| {
        other.reading.is_plain() && meant.is_none_or(|frame| frame == other.reading.frame)
    };
    let Some(best) = tried.first().copied() else {
        return Err(JudgeError::NoOmega { tried });
    };
    let is_clear = |one: &OmegaResidual, other: &OmegaResidual| {
        CLEARLY * one.relative.max(SAME) < other.relative || rows.is_same(one.reading, other.reading)
    };
    if let Some(plain) = tried.iter().find(plain).filter(|plain| plain.relative <= FITS)
        && !(CLEARLY * best.relative.max(SAME) < plain.relative)
    {
        let other =
            tried.iter().find(|other| other.reading.is_plain() && other.reading.frame != plain.reading.frame);
        if meant.is_some() || other.is_none_or(|other| is_clear(plain, other)) {
            return Ok(plain.reading);
        }
    } else if best.relative <= FITS && tried[1..].iter().all(|other| is_clear(&best, other)) {
        return Ok(best.reading);
    }
    // Of a wrong law of motion the first row may be all that is right.
    let begun: Vec<OmegaReading> = [body, space]
        .into_iter()
        .filter(|plain| meant.is_none_or(|frame| frame == plain.frame) && rows.first_off(*plain) < BEGUN)
        .collect();
    match begun[..] {
        [only] => return Ok(only),
        [one, other] if CLEARLY * rows.first_off(one) <= rows.first_off(other) => return Ok(one),
        [one, other] if CLEARLY * rows.first_off(other) <= rows.first_off(one) => return Ok(other),
        _ => {}
    }
    Err(match best.relative <= FITS {
        true => JudgeError::AmbiguousOmega { tried },
        false => JudgeError::NoOmega { tried },
    })
}

/// All readings that are tried, the plainest first.
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

/// The beginning, and rows up to the last as long as their attitudes follow the exact motion.
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
