//! Search for the reading of a log: groups of readings are tried in turn until one fits.

use super::axes::SignedAxes;
use super::beginning::{BEGINNING, Beginning, CLEARLY, COMPARED, Clock, logged_rate};
use super::declared::{AttitudeSense, DeclaredReading};
use super::difference::angle_between;
use super::error::JudgeError;
use super::log::{MotionLog, QuaternionOrder};
use super::reading::{Reading, ReadingResidual};
use super::reference::spread;
use super::shifted::{Shifted, shifted};
use crate::motion::task::scenario::Scenario;

/// Largest residual of a reading that fits, relative to the rotation angle.
///
/// The error of a wrong law of motion is of second order in the angle. The error of a wrong reading
/// is as large as the angle itself.
pub(super) const FITS: f64 = 0.3;
/// Residual (relative) below which no other group is tried: the rounding of rows at intervals of
/// 0.1 rad.
const EXACT: f64 = 1e-6;
/// Largest residual (relative) of a group that replaces a simpler one which fits roughly.
const REPLACES: f64 = 0.03;
/// Largest residual (relative) from the log's own start, where the first row fits any reading.
const FITS_OWN: f64 = 0.1;
/// Angle between equal motions, rad: the rounding of two conversions.
pub(super) const SAME: f64 = 1e-12;
/// Largest angle between a first row and the scenario's start that count as equal, rad; single
/// precision and four digits satisfy it.
const BEGUN: f64 = 1e-4;
/// Maximum number of integration steps to the first rows: for clocks that are tried, and for rows
/// that may be far apart.
const MOST: [usize; 2] = [10_000, 1_000_000];
/// Range of the ratio of the log's angular velocity to the scenario's. Outside it only the first
/// rows agree, and nothing is compared.
const RATES: core::ops::RangeInclusive<f64> = 0.2..=5.0;
/// Ratio below which the log is constant: the program does not step.
const STILL: f64 = 1e-6;
/// Rotation angle of a beginning, rad, over which |ω| is still that of the start.
const NEAR_START: f64 = 1.0;
/// Largest number of rows by which stated times may be early and count as a mistake, not as the
/// origin of another clock.
const LATE_ROWS: f64 = 3.0;
/// Fraction of the row spacing within which times are equal.
const ROW_PART: f64 = 1e-3;

/// Search for the reading of a log.
pub(super) struct Search<'a> {
    log: &'a MotionLog,
    scenario: &'a Scenario,
    declared: &'a DeclaredReading,
    /// Beginnings with the stated unit of time.
    stated: Vec<Beginning>,
    /// Reason why a beginning with the stated unit was not compared.
    missed: Option<JudgeError>,
    /// Angular velocity from the log's attitudes, in the stated unit, relative to that of the
    /// scenario near its start.
    ratio: Option<f64>,
}

/// Readings of the group that fits, best first.
#[derive(Debug)]
pub(super) struct Found {
    pub(super) tried: Tried,
    /// Beginnings with which they were compared.
    pub(super) beginnings: Vec<Beginning>,
    pub(super) from_own_start: bool,
    /// True if the first row is some time after the scenario's start.
    pub(super) is_shifted: bool,
}

type Tried = Vec<ReadingResidual>;

impl<'a> Search<'a> {
    pub(super) fn new(
        log: &'a MotionLog,
        scenario: &'a Scenario,
        declared: &'a DeclaredReading,
    ) -> Result<Self, JudgeError> {
        let (first, start, factor) =
            (log.times()[0], scenario.start().time, declared.time_factor.unwrap_or(1.0));
        let (mut stated, mut missed, rate) = (Vec::new(), None, logged_rate(log));
        if let Some(origin) = declared.time_origin {
            let found = Beginning::of(log, scenario, Clock { origin, factor }, MOST[1])?;
            stated.push(found.ok_or(JudgeError::FarTimes { first: first - origin, start })?);
        } else {
            let as_said = Clock { origin: 0.0, factor };
            if as_said.time(first) > start {
                match Beginning::of(log, scenario, as_said, MOST[0]) {
                    Ok(Some(found)) => stated.push(found),
                    Ok(None) => missed = Some(JudgeError::FarTimes { first, start }),
                    Err(error) => missed = Some(error),
                }
            }
            let is_said = as_said.time(first) == start;
            let clock = if is_said { as_said } else { Clock::beginning_at(start, log, factor) };
            // Rows that are close together take few steps if the unit is correct.
            match Beginning::of(log, scenario, clock, MOST[usize::from(rate.is_none())]) {
                Ok(found) => stated.extend(found),
                Err(error) => missed = Some(error),
            }
        }
        let near = stated.iter().filter(|beginning| beginning.turn() <= NEAR_START);
        let exact = near.map(Beginning::rate).fold(scenario.start().omega.norm(), f64::max);
        let ratio = rate.map(|rate| rate / (factor * exact)).filter(|ratio| ratio.is_finite());
        Ok(Self { log, scenario, declared, stated, missed, ratio })
    }

    pub(super) fn plain_axes(&self) -> SignedAxes {
        self.declared.axes.unwrap_or(SignedAxes::SAME)
    }

    /// Returns the readings of the first group that fits.
    pub(super) fn found(&self) -> Result<Found, JudgeError> {
        let certain = self.declared.certain();
        let named = self.residuals(self.declared, &[self.plain_axes()], &self.stated, false);
        if fits(&named, EXACT) {
            return Ok(self.in_stated(named));
        }
        let any = self.residuals(&certain, &[self.plain_axes()], &self.stated, false);
        if let Some(found) = self.beginning_with_start(&named, &any) {
            return Ok(found);
        }
        let is_searched = match self.later() {
            Shifted::Found(tried, beginning) => {
                let beginnings = vec![beginning];
                return Ok(Found { tried, beginnings, from_own_start: false, is_shifted: true });
            }
            Shifted::Nowhere => true,
            Shifted::NotSearched => false,
        };
        if certain.order.is_some() && certain.sense.is_some() && !named.is_empty() {
            return Ok(self.as_declared(named));
        }
        let other_rate = self.ratio.filter(|ratio| *ratio > STILL && !RATES.contains(ratio));
        if other_rate.is_none()
            && let Some(found) = self.wrong_from_start(&named)
        {
            return Ok(found);
        }
        Err(match (&self.missed, other_rate) {
            (Some(error @ JudgeError::Motion(_)), _) => error.clone(),
            (_, Some(ratio)) => JudgeError::OtherRate { ratio, tried: named },
            (Some(error), None) => error.clone(),
            (None, None) if !is_searched => JudgeError::NotSearched { tried: named },
            (None, None) => JudgeError::NoReading { tried: named },
        })
    }

    fn in_stated(&self, tried: Tried) -> Found {
        let (tried, beginnings) = (times_as_said(tried), self.stated.clone());
        Found { tried, beginnings, from_own_start: false, is_shifted: false }
    }

    /// Returns readings of a log that begins like the scenario: other orders and senses, units of
    /// time and axes.
    fn beginning_with_start(&self, named: &Tried, any: &Tried) -> Option<Found> {
        let (stated, certain, plain) = (&self.stated, self.declared.certain(), [self.plain_axes()]);
        let axes: &[SignedAxes] = if self.declared.axes.is_some() { &[] } else { &SignedAxes::ALL };
        let scaled = self.scaled();
        let ways = [
            (stated, named.clone()),
            (stated, any.clone()),
            (&scaled, self.residuals(&certain, &plain, &scaled, false)),
            (stated, self.residuals(&certain, axes, stated, false)),
            (&scaled, self.residuals(&certain, axes, &scaled, false)),
        ];
        let (beginnings, tried) = nearest(ways)?;
        Some(Found { beginnings: beginnings.clone(), ..self.in_stated(tried) })
    }

    /// Returns beginnings with other units of time in which the log rotates as fast as the scenario
    /// at its first row.
    fn scaled(&self) -> Vec<Beginning> {
        let start = self.scenario.start().time;
        let clocks = self.factors().flat_map(|factor| {
            let from_start = Clock::beginning_at(start, self.log, factor);
            let origins = match self.declared.time_origin {
                Some(origin) => vec![origin],
                None if from_start.origin == 0.0 => vec![0.0],
                None => vec![0.0, from_start.origin],
            };
            origins.into_iter().map(move |origin| Clock { origin, factor })
        });
        let beginning = |clock: Clock| Beginning::of(self.log, self.scenario, clock, MOST[0]).ok().flatten();
        // Rows of a body at rest fit any motion that is slow enough.
        let is_told = |found: &Beginning| found.turn() >= 0.5 * BEGINNING && found.has_same_rate(self.log);
        clocks.filter_map(beginning).filter(is_told).collect()
    }

    /// Returns the units of time that are tried, as factors of the stated one.
    fn factors(&self) -> impl Iterator<Item = f64> {
        let is_certain = self.declared.time_factor.is_some();
        Reading::TIME_FACTORS.into_iter().map(|(factor, _)| factor).filter(move |_| !is_certain)
    }

    /// Returns readings with the first row some time after the scenario's start.
    fn later(&self) -> Shifted {
        if self.declared.time_origin.is_some() {
            return Shifted::Nowhere;
        }
        let stated = Clock { origin: 0.0, factor: self.declared.time_factor.unwrap_or(1.0) };
        let readings = meanings(&self.declared.certain(), &[self.plain_axes()], stated);
        shifted(self.log, self.scenario, &readings, stated.factor, &self.factors().collect::<Vec<_>>())
    }

    /// Returns the time by which the rows are later than stated, s, if the determined clock shows
    /// that the stated one is wrong.
    ///
    /// The stated clock is wrong if it begins at the scenario's start, or is one to three whole
    /// rows early. Any other clock has a different origin.
    pub(super) fn late_by(&self, found: &Reading) -> Option<f64> {
        let [first, second, ..] = self.log.times() else { return None };
        let (stated, spacing) = (first * found.time_factor, (second - first) * found.time_factor);
        let since_start = (stated - self.scenario.start().time) / spacing;
        let shift = found.time(*first) - stated;
        let rows = shift / spacing;
        let is_whole = (rows - rows.round()).abs() <= ROW_PART && rows.round() <= LATE_ROWS;
        let is_wrong = since_start.abs() <= ROW_PART || since_start > 0.0 && is_whole;
        (rows > ROW_PART && is_wrong).then_some(shift)
    }

    /// Returns the residual of a reading with the stated clock, if that was compared.
    pub(super) fn residual_as_stated(&self, reading: Reading) -> Option<ReadingResidual> {
        let stated = self.stated.iter().find(|beginning| beginning.clock.is_of(&reading))?;
        Some(stated.residual(self.log, reading, false))
    }

    /// Returns the readings that the user declares, for a log that begins differently; from its own
    /// start if it rotates like the scenario from there.
    fn as_declared(&self, mut named: Tried) -> Found {
        if let Some(begun) = self.begun(&named) {
            return self.in_stated(begun);
        }
        let own = self.residuals(self.declared, &[self.plain_axes()], &self.stated, true);
        if fits(&own, FITS) {
            return Found { from_own_start: true, ..self.in_stated(own) };
        }
        // If none fits, the times are those stated in the log.
        named.sort_by_key(|other| other.reading.time_origin != 0.0);
        Found { tried: named, beginnings: self.stated.clone(), from_own_start: false, is_shifted: false }
    }

    /// Returns readings of a program that is wrong from its first step, or has a different start.
    fn wrong_from_start(&self, named: &Tried) -> Option<Found> {
        if let Some(begun) = self.begun(named) {
            return Some(self.in_stated(begun));
        }
        for declared in [*self.declared, self.declared.certain()] {
            let own = self.residuals(&declared, &[self.plain_axes()], &self.stated, true);
            if fits(&own, FITS_OWN) {
                return Some(Found { from_own_start: true, ..self.in_stated(own) });
            }
        }
        None
    }

    /// Returns all readings that are not excluded, best first; of equal ones the simplest first.
    fn residuals(
        &self,
        declared: &DeclaredReading,
        axes: &[SignedAxes],
        beginnings: &[Beginning],
        from_own_start: bool,
    ) -> Tried {
        let mut tried: Tried = beginnings
            .iter()
            .flat_map(|beginning| {
                let readings = meanings(declared, axes, beginning.clock).into_iter();
                readings.map(|reading| beginning.residual(self.log, reading, from_own_start))
            })
            .collect();
        tried.sort_by(|a, b| a.attitude.total_cmp(&b.attitude));
        tried
    }

    /// Moves the one reading whose first row is the scenario's start to the front; `None` if there
    /// is none, or several.
    fn begun(&self, tried: &[ReadingResidual]) -> Option<Tried> {
        let off = |other: &ReadingResidual| {
            let beginning = self.stated.iter().find(|beginning| beginning.clock.is_of(&other.reading));
            beginning.map_or(f64::INFINITY, |beginning| beginning.first_angle(self.log, &other.reading))
        };
        let [at] = (0..tried.len()).filter(|&k| off(&tried[k]) < BEGUN).collect::<Vec<_>>()[..] else {
            return None;
        };
        let mut tried = tried.to_vec();
        tried[..=at].rotate_right(1);
        Some(tried)
    }
}

/// Returns all meanings of a log's columns that are not excluded.
fn meanings(declared: &DeclaredReading, axes: &[SignedAxes], clock: Clock) -> Vec<Reading> {
    let Clock { origin: time_origin, factor: time_factor } = clock;
    let is_allowed = |order: &QuaternionOrder| declared.order.is_none_or(|declared| declared == *order);
    let is_told = |sense: &AttitudeSense| declared.sense.is_none_or(|declared| declared == *sense);
    let mut readings = Vec::new();
    for &axes in axes {
        for order in QuaternionOrder::ALL.into_iter().filter(is_allowed) {
            for sense in AttitudeSense::ALL.into_iter().filter(is_told) {
                readings.push(Reading { order, sense, axes, time_origin, time_factor });
            }
        }
    }
    readings
}

/// Returns the first group that fits, unless a later one fits much better: a motion about nearly
/// the same axis may fit roughly.
fn nearest<T>(ways: impl IntoIterator<Item = (T, Tried)>) -> Option<(T, Tried)> {
    let mut nearest: Option<(T, Tried)> = None;
    for (of, tried) in ways {
        let Some(best) = tried.first() else { continue };
        let is_nearer = match nearest.as_ref().and_then(|(_, known)| known.first()) {
            None => best.relative <= FITS,
            Some(known) => best.relative <= REPLACES && CLEARLY * best.attitude < known.attitude,
        };
        if is_nearer {
            nearest = Some((of, tried));
        }
    }
    nearest
}

fn fits(tried: &[ReadingResidual], most: f64) -> bool {
    tried.first().is_some_and(|best| best.relative <= most)
}

/// Keeps only the readings with the stated times, unless another origin gives a clearly better
/// beginning. The first steps of an inaccurate method are in error by about one row, so a shifted
/// clock may fit slightly better.
fn times_as_said(mut tried: Tried) -> Tried {
    let Some(best) = tried.first().copied() else { return tried };
    let is_said = |other: &ReadingResidual| {
        other.reading.time_origin == 0.0 && other.reading.time_factor == best.reading.time_factor
    };
    let said = tried.iter().find(|other| is_said(other)).copied();
    if said.is_some_and(|said| said.relative <= FITS && said.attitude <= CLEARLY * best.attitude) {
        tried.sort_by_key(|other| !is_said(other));
        let count = tried.iter().take_while(|other| is_said(other)).count();
        tried.truncate(count);
    }
    tried
}

/// Returns true if two readings give the same motion at the same times.
pub(super) fn is_same_motion(log: &MotionLog, a: &Reading, b: &Reading) -> bool {
    let same = |row: usize| {
        let numbers = log.attitude()[row];
        angle_between(a.quaternion(numbers), b.quaternion(numbers)) <= SAME
    };
    let clock = |reading: &Reading| (reading.time_origin, reading.time_factor);
    clock(a) == clock(b) && spread(log.times().len(), COMPARED).into_iter().all(same)
}
