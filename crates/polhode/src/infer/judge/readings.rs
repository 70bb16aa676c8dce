//! The reading of a log, found by the motion that it has to begin with.

use super::axes::SignedAxes;
use super::beginning::{BEGINNING, Beginning, COMPARED, Clock, logged_rate};
use super::declared::{AttitudeSense, DeclaredReading, OmegaAxes};
use super::difference::angle_between;
use super::error::JudgeError;
use super::log::{MotionLog, QuaternionOrder};
use super::motion::ReadMotion;
use super::omega::omega_reading;
use super::omega_reading::OmegaReading;
use super::reading::{Reading, ReadingResidual};
use super::reference::{require_judged, spread};
use super::shifted::shifted;
use crate::motion::task::scenario::Scenario;

/// A log's reading, and those that it was found among.
#[derive(Clone, Debug, PartialEq)]
pub struct Readings {
    /// Meaning of the times and attitudes.
    pub reading: Reading,
    /// Meaning of ω, if the log has any.
    pub omega: Option<OmegaReading>,
    /// All readings that were tried, best first.
    pub tried: Vec<ReadingResidual>,
    /// Number of them, from the first, that give the same motion to the last row: any of them may be meant.
    pub equivalent: usize,
    /// Whether the readings were compared from the log's own first attitude on, as none begins with that of the scenario.
    pub from_own_start: bool,
    /// True if the reading contradicts the names of the log's columns.
    pub is_against_names: bool,
}

/// A reading fits if it is off by no more than this part of the turn: a wrong law of motion is second order in the turn.
const FITS: f64 = 0.3;
/// Bound of the same below which no other way of reading is tried.
const EXACT: f64 = 1e-6;
/// Bound of the same for a reading that replaces a plainer one which fits.
const FITS_FAR_BETTER: f64 = 0.03;
/// The same from the log's own start, which any first attitude passes.
const FITS_OWN: f64 = 0.1;
/// It is the one that is meant if all others are this many times farther off.
const CLEARLY: f64 = 10.0;
/// The angle between motions that are the same, rad.
const SAME: f64 = 1e-12;
/// A first row that is off the scenario's start by less begins there, rad: programs may have single precision.
const BEGUN: f64 = 1e-4;
/// Steps of integration to the first rows: of a clock that is tried, and of one that is declared.
const MOST: [usize; 2] = [10_000, 1_000_000];
/// Ratio of the log's angular velocity to the scenario's; beyond it the unit of time is another one, or the motion is.
const RATES: core::ops::RangeInclusive<f64> = 0.2..=5.0;
/// The same for a unit that is tried: |ω| may change soon.
const RATES_TRIED: core::ops::RangeInclusive<f64> = 0.03..=30.0;
/// A log that turns at less than this part of the scenario's angular velocity stands still.
const STILL: f64 = 1e-6;

impl Readings {
    /// Finds what the numbers of a log mean: what is declared, and of the rest what begins as the scenario does.
    ///
    /// These are tried until one fits:
    ///
    /// 1. the names of the columns, with the times as they are and from the scenario's start;
    /// 2. all orders and senses;
    /// 3. other units of time;
    /// 4. other axes;
    /// 5. a first row some time after the scenario's start;
    /// 6. a first row that is the scenario's start in one reading alone: the program is wrong from its first step on;
    /// 7. the turn since the first row, as the run may start elsewhere.
    ///
    /// The times are those that the log says, unless it begins clearly better from the scenario's start. Readings that give the same
    /// motion to the last row are one. If the user declares order and sense and nothing fits, they are believed.
    ///
    /// # Errors
    /// [`JudgeError::NoReading`], [`JudgeError::FarTimes`], [`JudgeError::Ambiguous`], [`JudgeError::AmbiguousOmega`] and
    /// [`JudgeError::NoOmega`] where the log does not tell, and was not declared; as [`super::Reference::of`].
    pub fn of(log: &MotionLog, scenario: &Scenario, declared: &DeclaredReading) -> Result<Self, JudgeError> {
        require_judged(scenario)?;
        let search = Search::new(log, scenario, declared)?;
        let (found, tried) = search.found()?;
        let [best, ..] = tried[..] else { return Err(JudgeError::NoReading { tried }) };
        let near = |other: &&ReadingResidual| other.attitude <= CLEARLY * best.attitude.max(SAME);
        let fitting = if best.relative <= FITS { tried.iter().take_while(near).count() } else { 1 };
        let is_same = |other: &&ReadingResidual| is_same_motion(log, &best.reading, &other.reading);
        let equivalent = tried.iter().take(fitting).filter(is_same).count();
        // Axes that are not the scenario's are found only where the motion tells them from all others.
        let is_told = best.reading.axes == search.plain_axes() || equivalent == 1;
        if equivalent < fitting || !is_told {
            return Err(JudgeError::Ambiguous { tried, fitting });
        }
        let beginning = found.beginnings.iter().find(|beginning| beginning.clock.is_of(&best.reading));
        let omega = match (log.omega(), beginning) {
            (Some(omega), Some(beginning)) => {
                Some(omega_reading(log, omega, scenario, declared, &best.reading, beginning)?)
            }
            _ => None,
        };
        let differs = declared.order.is_some_and(|order| order != best.reading.order)
            || declared.sense.is_some_and(|sense| sense != best.reading.sense)
            || declared.omega_axes.zip(omega).is_some_and(|(frame, omega)| frame != omega.frame);
        Ok(Self {
            reading: best.reading,
            omega,
            tried,
            equivalent,
            from_own_start: found.from_own_start,
            is_against_names: differs,
        })
    }

    /// Frame of ω, if the log has any.
    pub fn omega_axes(&self) -> Option<OmegaAxes> {
        self.omega.map(|omega| omega.frame)
    }

    /// A log's motion.
    pub fn read(&self, log: &MotionLog) -> ReadMotion {
        self.reading.read(log, self.omega)
    }
}

/// Search for the reading of a log.
struct Search<'a> {
    log: &'a MotionLog,
    scenario: &'a Scenario,
    declared: &'a DeclaredReading,
    /// Beginnings with the stated unit of time.
    stated: Vec<Beginning>,
    /// Reason why the log's times as they are were not compared.
    missed: Option<JudgeError>,
    /// Angular velocity by the log's attitudes, in the stated unit, as a part of the exact one.
    rates: Option<f64>,
}

/// Place where a reading was found.
#[derive(Default)]
struct Found {
    beginnings: Vec<Beginning>,
    from_own_start: bool,
}

type Tried = Vec<ReadingResidual>;

impl<'a> Search<'a> {
    fn new(
        log: &'a MotionLog,
        scenario: &'a Scenario,
        declared: &'a DeclaredReading,
    ) -> Result<Self, JudgeError> {
        let (first, start, factor) =
            (log.times()[0], scenario.start().time, declared.time_factor.unwrap_or(1.0));
        let (mut stated, mut missed) = (Vec::new(), None);
        if let Some(origin) = declared.time_origin {
            let found = Beginning::of(log, scenario, Clock { origin, factor }, MOST[1])?;
            stated.push(found.ok_or(JudgeError::FarTimes { first: first - origin, start })?);
        } else {
            let from_start = Clock::beginning_at(start, log, factor);
            let as_said = Clock { origin: 0.0, factor };
            if as_said.time(first) > start {
                match Beginning::of(log, scenario, as_said, MOST[0]) {
                    Ok(Some(found)) => stated.push(found),
                    Ok(None) => missed = Some(JudgeError::FarTimes { first, start }),
                    Err(error) => missed = Some(error),
                }
            }
            let clock = if as_said.time(first) == start { as_said } else { from_start };
            stated.extend(Beginning::of(log, scenario, clock, MOST[1])?);
        }
        let exact = stated.iter().map(Beginning::rate).fold(0.0, f64::max);
        let rates = logged_rate(log).map(|rate| rate / (factor * exact)).filter(|ratio| ratio.is_finite());
        Ok(Self { log, scenario, declared, stated, missed, rates })
    }

    fn plain_axes(&self) -> SignedAxes {
        self.declared.axes.unwrap_or(SignedAxes::SAME)
    }

    /// The readings of the first way of reading that fits, best first.
    fn found(&self) -> Result<(Found, Tried), JudgeError> {
        let (stated, certain) = (&self.stated, self.declared.certain());
        let plain = [self.plain_axes()];
        let axes: &[SignedAxes] = if self.declared.axes.is_some() { &[] } else { &SignedAxes::ALL };
        let first = self.residuals(self.declared, &plain, stated, false);
        let in_stated =
            |tried| (Found { beginnings: stated.clone(), from_own_start: false }, times_as_said(tried));
        if fits(&first, EXACT) {
            return Ok(in_stated(first));
        }
        let any = self.residuals(&certain, &plain, stated, false);
        let factors = self.factors();
        let scaled = self.scaled(&factors);
        let ways = [
            (stated, first.clone()),
            (stated, any.clone()),
            (&scaled, self.residuals(&certain, &plain, &scaled, false)),
            (stated, self.residuals(&certain, axes, stated, false)),
            (&scaled, self.residuals(&certain, axes, &scaled, false)),
        ];
        if let Some((beginnings, tried)) = nearest(ways) {
            return Ok((
                Found { beginnings: beginnings.clone(), from_own_start: false },
                times_as_said(tried),
            ));
        }
        if let Some((tried, beginning)) = self.shifted(&any, &factors) {
            return Ok((Found { beginnings: vec![beginning], from_own_start: false }, tried));
        }
        let refused = |tried| match &self.missed {
            Some(error) => Err(error.clone()),
            None => Err(JudgeError::NoReading { tried }),
        };
        if certain.order.is_some() && certain.sense.is_some() {
            return self.declared_reading(first);
        }
        // Another unit of time that is none of those, or another motion.
        let rates = self.rates.unwrap_or(1.0);
        if rates > STILL && !RATES.contains(&rates) {
            return refused(first);
        }
        if let Some(begun) = self.begun(&first) {
            // Wrong from its first step on; and what a first attitude means nothing but the scenario's start can say.
            return Ok(in_stated(begun));
        }
        for declared in [self.declared, &certain] {
            let own = self.residuals(declared, &plain, stated, true);
            if fits(&own, FITS_OWN) {
                let (found, tried) = in_stated(own);
                return Ok((Found { from_own_start: true, ..found }, tried));
            }
        }
        refused(first)
    }

    /// Readings that the user declares, of a log that begins otherwise; from its own start if it turns as the scenario does from there.
    fn declared_reading(&self, first: Tried) -> Result<(Found, Tried), JudgeError> {
        let beginnings = self.stated.clone();
        if let Some(begun) = self.begun(&first) {
            return Ok((Found { beginnings, from_own_start: false }, times_as_said(begun)));
        }
        let own = self.residuals(self.declared, &[self.plain_axes()], &self.stated, true);
        if fits(&own, FITS) {
            return Ok((Found { beginnings, from_own_start: true }, times_as_said(own)));
        }
        Ok((Found { beginnings, from_own_start: false }, as_declared(first)))
    }

    /// Other units of time that agree with the angular velocity.
    fn factors(&self) -> Vec<f64> {
        if self.declared.time_factor.is_some() {
            return Vec::new();
        }
        let agrees = |factor: f64| self.rates.is_none_or(|ratio| RATES_TRIED.contains(&(ratio / factor)));
        Reading::TIME_FACTORS.into_iter().map(|(factor, _)| factor).filter(|&factor| agrees(factor)).collect()
    }

    /// The beginnings of other units of time.
    fn scaled(&self, factors: &[f64]) -> Vec<Beginning> {
        let start = self.scenario.start().time;
        let clocks = factors.iter().flat_map(|&factor| {
            let from_start = Clock::beginning_at(start, self.log, factor);
            let origins = match self.declared.time_origin {
                Some(origin) => vec![origin],
                None if from_start.origin == 0.0 => vec![0.0],
                None => vec![0.0, from_start.origin],
            };
            origins.into_iter().map(move |origin| Clock { origin, factor })
        });
        let beginning = |clock: Clock| Beginning::of(self.log, self.scenario, clock, MOST[0]).ok().flatten();
        // Rows of a body that does not move fit any motion that is slow enough.
        clocks.filter_map(beginning).filter(|beginning| beginning.turn() >= 0.5 * BEGINNING).collect()
    }

    /// Readings with the first row some time after the scenario's start.
    fn shifted(&self, plain: &[ReadingResidual], factors: &[f64]) -> Option<(Tried, Beginning)> {
        if self.declared.time_origin.is_some() {
            return None;
        }
        let mut readings: Vec<Reading> = Vec::new();
        for ReadingResidual { reading, .. } in plain {
            let is_known = |known: &Reading| (known.order, known.sense) == (reading.order, reading.sense);
            if !readings.iter().any(is_known) {
                readings.push(*reading);
            }
        }
        let stated = self.declared.time_factor.unwrap_or(1.0);
        let factors: Vec<f64> = core::iter::once(stated).chain(factors.iter().copied()).collect();
        let rate = self.stated.iter().map(Beginning::rate).fold(0.0, f64::max);
        shifted(self.log, self.scenario, &readings, &factors, rate)
    }

    /// All readings that are not excluded, best first; of equals the plainest.
    fn residuals(
        &self,
        declared: &DeclaredReading,
        axes: &[SignedAxes],
        beginnings: &[Beginning],
        from_own_start: bool,
    ) -> Tried {
        let orders = QuaternionOrder::ALL
            .into_iter()
            .filter(|&order| declared.order.is_none_or(|declared| declared == order));
        let senses = AttitudeSense::ALL
            .into_iter()
            .filter(|&sense| declared.sense.is_none_or(|declared| declared == sense));
        let mut tried = Vec::new();
        for beginning in beginnings {
            let Clock { origin: time_origin, factor: time_factor } = beginning.clock;
            for &axes in axes {
                for order in orders.clone() {
                    for sense in senses.clone() {
                        let reading = Reading { order, sense, axes, time_origin, time_factor };
                        tried.push(beginning.residual(self.log, reading, from_own_start));
                    }
                }
            }
        }
        tried.sort_by(|a, b| a.attitude.total_cmp(&b.attitude));
        tried
    }

    /// Puts the one reading in which the first row is the scenario's start before the others; `None` if there is none, or several.
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

/// The first way of reading that fits, unless a later one fits far better: a motion about nearly the same axis may fit roughly.
fn nearest<T>(ways: impl IntoIterator<Item = (T, Tried)>) -> Option<(T, Tried)> {
    let mut nearest: Option<(T, Tried)> = None;
    for (of, tried) in ways {
        let Some(best) = tried.first() else { continue };
        let is_nearer = match nearest.as_ref().and_then(|(_, known)| known.first()) {
            None => best.relative <= FITS,
            Some(known) => best.relative <= FITS_FAR_BETTER && CLEARLY * best.attitude < known.attitude,
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

/// The times of a log are those that it says, unless from another origin it begins clearly better: of the others those that come near are
/// put behind. A rough method's first steps are as far off as its rows are apart.
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

/// Of readings that differ by their time origin only, and none of which fits: the times are what they say.
fn as_declared(mut tried: Tried) -> Tried {
    tried.sort_by_key(|other| other.reading.time_origin != 0.0);
    tried
}

/// Whether two readings give the same motion at the same times.
fn is_same_motion(log: &MotionLog, a: &Reading, b: &Reading) -> bool {
    let same = |row: usize| {
        let numbers = log.attitude()[row];
        angle_between(a.quaternion(numbers), b.quaternion(numbers)) <= SAME
    };
    let clock = |reading: &Reading| (reading.time_origin, reading.time_factor);
    clock(a) == clock(b) && spread(log.times().len(), COMPARED).into_iter().all(same)
}
