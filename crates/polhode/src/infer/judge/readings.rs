//! The reading of a log, found by the motion that it has to begin with.

use super::axes::SignedAxes;
use super::declared::{AttitudeSense, DeclaredReading, OmegaAxes};
use super::difference::{angle_between, conjugate, product};
use super::error::JudgeError;
use super::log::{MotionLog, QuaternionOrder};
use super::motion::ReadMotion;
use super::reading::{Reading, ReadingResidual};
use super::reference::{spread, states};
use crate::math::frame::Body;
use crate::math::vector::AngularVelocity;
use crate::motion::model::state::State;
use crate::motion::task::scenario::Scenario;

/// A log's reading, and those that it was found among.
#[derive(Clone, Debug, PartialEq)]
pub struct Readings {
    /// What its numbers mean.
    pub reading: Reading,
    /// Along which axes its ω is, if it has any.
    pub omega_axes: Option<OmegaAxes>,
    /// All readings that were tried, best first.
    pub tried: Vec<ReadingResidual>,
    /// How many of them, from the first, give the same motion to the last row, so that it does not matter which of them is meant.
    pub equivalent: usize,
    /// Whether the readings were compared from the log's own first attitude on, as none begins with that of the scenario.
    pub from_own_start: bool,
}

/// The beginning of a motion: until it has turned so far, rad, and three rows at least.
const BEGINNING: f64 = 0.1;
/// A reading fits if it is off by no more than this part of the turn: a wrong law of motion is second order in the turn.
const FITS: f64 = 0.3;
/// It is the one that is meant if all others are so many times farther off.
const CLEARLY: f64 = 10.0;
/// How many rows are compared.
const COMPARED: usize = 64;
/// The angle between motions that are the same, rad.
const SAME: f64 = 1e-12;
/// What is taken for the turn of a motion that hardly turns, and of one that turns farther from row to row than attitudes can be apart, rad.
const NO_TURN: f64 = 1e-3;
const WHOLE_TURN: f64 = 1.0;
/// A first row that is off the scenario's start by less begins there, rad: programs may have single precision.
const BEGUN: f64 = 1e-4;

impl Readings {
    /// What the numbers of a log mean: what is declared, and of the rest what begins as the scenario does.
    ///
    /// Orders and senses are tried first. Where none fits, a first row that is the scenario's start in one reading alone tells it; then other
    /// axes are tried, and, as the run may start elsewhere, the turn since its first row. The times are those that the log says, unless
    /// from the scenario's start it begins clearly better. Readings that give the same motion to the last row are one. Where order and
    /// sense are declared and nothing fits, they are believed.
    ///
    /// # Errors
    /// [`JudgeError::NoReading`], [`JudgeError::Ambiguous`] and [`JudgeError::AmbiguousOmega`] where the log does not tell, and was not
    /// declared; as [`super::Reference::of`].
    pub fn of(log: &MotionLog, scenario: &Scenario, declared: &DeclaredReading) -> Result<Self, JudgeError> {
        let beginnings = time_origins(log, scenario, declared)
            .into_iter()
            .map(|origin| Beginning::of(log, scenario, origin))
            .collect::<Result<Vec<_>, _>>()?;
        let plain = [declared.axes.unwrap_or(SignedAxes::SAME)];
        let others: &[SignedAxes] = if declared.axes.is_some() { &[] } else { &SignedAxes::ALL };
        let attempt = |axes: &[SignedAxes], from_own_start| {
            let tried = residuals(log, declared, axes, from_own_start, &beginnings);
            (tried, from_own_start)
        };
        let fits = |(tried, _): &(Vec<ReadingResidual>, bool)| {
            tried.first().is_some_and(|best| best.relative <= FITS)
        };
        let first = attempt(&plain, false);
        let is_declared = declared.order.is_some() && declared.sense.is_some();
        let (tried, from_own_start) = if fits(&first) {
            first
        } else if let Some(begun) = begun(&first.0, log, &beginnings) {
            // Wrong from its first step on; and what a first attitude means nothing but the scenario's start can say.
            (begun, false)
        } else if let Some(found) = [attempt(others, false), attempt(&plain, true)].into_iter().find(fits) {
            found
        } else if is_declared {
            (as_declared(first.0), false)
        } else {
            return Err(JudgeError::NoReading { tried: first.0 });
        };
        let tried = times_as_said(tried);
        let [best, ..] = tried[..] else { return Err(JudgeError::NoReading { tried }) };
        let near = |other: &&ReadingResidual| other.attitude <= CLEARLY * best.attitude.max(SAME);
        let fitting = if best.relative <= FITS { tried.iter().take_while(near).count() } else { 1 };
        let is_same = |other: &&ReadingResidual| is_same_motion(log, &best.reading, &other.reading);
        let equivalent = tried.iter().take(fitting).filter(is_same).count();
        // Axes that are not the scenario's are found only where the motion tells them from all others.
        let is_told = best.reading.axes == plain[0] || equivalent == 1;
        if equivalent < fitting || !is_told {
            return Err(JudgeError::Ambiguous { tried, fitting });
        }
        let beginning = beginnings.iter().find(|beginning| beginning.origin == best.reading.time_origin);
        let omega_axes = match (log.omega(), beginning, declared.omega_axes) {
            (Some(_), _, Some(declared)) => Some(declared),
            (Some(omega), Some(beginning), None) => Some(omega_axes(log, omega, &best.reading, beginning)?),
            _ => None,
        };
        Ok(Self { reading: best.reading, omega_axes, tried, equivalent, from_own_start })
    }

    /// A log's motion.
    pub fn read(&self, log: &MotionLog) -> ReadMotion {
        self.reading.read(log, self.omega_axes)
    }
}

/// The first rows of a log, with the exact states there if its times are read so.
struct Beginning {
    origin: f64,
    rows: Vec<usize>,
    exact: Vec<State>,
}

impl Beginning {
    fn of(log: &MotionLog, scenario: &Scenario, origin: f64) -> Result<Self, JudgeError> {
        let times = log.times();
        let upto = |last: usize| {
            let rows = spread(last + 1, COMPARED);
            let at: Vec<f64> = rows.iter().map(|&row| times[row] - origin).collect();
            states(scenario, &at).map(|exact| Self { origin, rows, exact })
        };
        let mut last = times.len().min(3) - 1;
        let mut found = upto(last)?;
        while last + 1 < times.len() {
            last = (2 * last).min(times.len() - 1);
            let further = upto(last)?;
            if further.turn() > BEGINNING {
                break;
            }
            found = further;
        }
        Ok(found)
    }

    /// ∫ |ω| dt by the trapezoidal rule, rad.
    fn turn(&self) -> f64 {
        let part = |pair: &[State]| {
            0.5 * (pair[0].omega.norm() + pair[1].omega.norm()) * (pair[1].time - pair[0].time)
        };
        self.exact.windows(2).map(part).sum()
    }

    fn residual(&self, log: &MotionLog, reading: Reading, from_own_start: bool) -> ReadingResidual {
        let read = |row: usize| reading.quaternion(log.attitude()[row]);
        // S = R_read(0) R_exact(0)ᵀ, if that is left out of the comparison
        let own = self.exact.first().map(|first| product(read(0), conjugate(first.attitude.quaternion())));
        let start =
            if from_own_start { own.map_or([1.0, 0.0, 0.0, 0.0], conjugate) } else { [1.0, 0.0, 0.0, 0.0] };
        let square = |(&row, exact): (&usize, &State)| {
            angle_between(exact.attitude.quaternion(), product(start, read(row))).powi(2)
        };
        let squares: f64 = self.rows.iter().zip(&self.exact).map(square).sum();
        let attitude = (squares / self.rows.len().max(1) as f64).sqrt();
        ReadingResidual { reading, attitude, relative: attitude / self.turn().clamp(NO_TURN, WHOLE_TURN) }
    }
}

/// The times as they are, or from the scenario's start; what is declared alone if it is.
fn time_origins(log: &MotionLog, scenario: &Scenario, declared: &DeclaredReading) -> Vec<f64> {
    let (first, start) = (log.times()[0], scenario.start().time);
    // Rounded so that the first row is not before the start.
    let from_start = first - start;
    let from_start = if first - from_start < start { from_start.next_down() } else { from_start };
    match declared.time_origin {
        Some(origin) => vec![origin],
        None if first == start => vec![0.0],
        None if first < start => vec![from_start],
        None => vec![0.0, from_start],
    }
}

/// All readings that are not excluded, best first; of equals the plainest.
fn residuals(
    log: &MotionLog,
    declared: &DeclaredReading,
    axes: &[SignedAxes],
    from_own_start: bool,
    beginnings: &[Beginning],
) -> Vec<ReadingResidual> {
    let orders =
        QuaternionOrder::ALL.into_iter().filter(|&order| declared.order.is_none_or(|said| said == order));
    let senses =
        AttitudeSense::ALL.into_iter().filter(|&sense| declared.sense.is_none_or(|said| said == sense));
    let mut tried = Vec::new();
    for beginning in beginnings {
        for &axes in axes {
            for order in orders.clone() {
                for sense in senses.clone() {
                    let reading = Reading { order, sense, axes, time_origin: beginning.origin };
                    tried.push(beginning.residual(log, reading, from_own_start));
                }
            }
        }
    }
    tried.sort_by(|a, b| a.attitude.total_cmp(&b.attitude));
    tried
}

/// The times of a log are those that it says, unless from another origin it begins clearly better: of the others those that come near are
/// put behind. A rough method's first steps are as far off as its rows are apart.
fn times_as_said(mut tried: Vec<ReadingResidual>) -> Vec<ReadingResidual> {
    let is_said = |other: &ReadingResidual| other.reading.time_origin == 0.0;
    let best = tried.first().map_or(0.0, |best| best.attitude);
    let said = tried.iter().find(|other| is_said(other)).copied();
    if said.is_some_and(|said| said.relative <= FITS && said.attitude <= CLEARLY * best) {
        tried.sort_by_key(|other| !is_said(other));
        let count = tried.iter().take_while(|other| is_said(other)).count();
        tried.truncate(count);
    }
    tried
}

/// The one reading in which the first row is the scenario's start, first of those that were tried; `None` if it is so in none of them, or in
/// several.
fn begun(
    tried: &[ReadingResidual],
    log: &MotionLog,
    beginnings: &[Beginning],
) -> Option<Vec<ReadingResidual>> {
    let off = |other: &ReadingResidual| {
        let beginning = beginnings.iter().find(|beginning| beginning.origin == other.reading.time_origin);
        let exact = beginning.and_then(|beginning| beginning.exact.first());
        exact.map_or(f64::INFINITY, |exact| {
            angle_between(exact.attitude.quaternion(), other.reading.quaternion(log.attitude()[0]))
        })
    };
    let [at] = (0..tried.len()).filter(|&k| off(&tried[k]) < BEGUN).collect::<Vec<_>>()[..] else {
        return None;
    };
    let mut tried = tried.to_vec();
    tried[..=at].rotate_right(1);
    Some(tried)
}

/// Of readings that differ by their time origin only, and none of which fits: the times are what they say.
fn as_declared(mut tried: Vec<ReadingResidual>) -> Vec<ReadingResidual> {
    tried.sort_by_key(|other| other.reading.time_origin != 0.0);
    tried
}

/// Whether two readings give the same motion at the same times.
fn is_same_motion(log: &MotionLog, a: &Reading, b: &Reading) -> bool {
    let same = |row: usize| {
        let numbers = log.attitude()[row];
        angle_between(a.quaternion(numbers), b.quaternion(numbers)) <= SAME
    };
    a.time_origin == b.time_origin && spread(log.times().len(), COMPARED).into_iter().all(same)
}

/// Along which axes ω is: those along which it begins as the scenario's.
///
/// # Errors
/// [`JudgeError::AmbiguousOmega`] where neither is clearly nearer, and they are not the same.
fn omega_axes(
    log: &MotionLog,
    omega: &[[f64; 3]],
    reading: &Reading,
    beginning: &Beginning,
) -> Result<OmegaAxes, JudgeError> {
    let read = |row: usize, axes| reading.omega(omega[row], axes, log.attitude()[row]);
    let rms = |of: &dyn Fn(usize, &State) -> AngularVelocity<Body>| {
        let squares = |(&row, exact): (&usize, &State)| of(row, exact).norm().powi(2);
        beginning.rows.iter().zip(&beginning.exact).map(squares).sum::<f64>().sqrt()
    };
    let size = rms(&|_, exact| exact.omega);
    let off = |axes| rms(&|row, exact| read(row, axes) - exact.omega) / size;
    let (body, space) = (off(OmegaAxes::Body), off(OmegaAxes::Space));
    let rows = spread(log.times().len(), COMPARED);
    let is_same = |&row: &usize| {
        let (body, space) = (read(row, OmegaAxes::Body), read(row, OmegaAxes::Space));
        (body - space).norm() <= SAME * body.norm()
    };
    // Of a wrong law of motion the first row may be all that is right.
    let first = |axes| match beginning.exact.first() {
        Some(exact) => (read(0, axes) - exact.omega).norm() / exact.omega.norm(),
        None => f64::INFINITY,
    };
    let told = |[body, space]: [f64; 2]| match () {
        () if CLEARLY * body <= space => Some(OmegaAxes::Body),
        () if CLEARLY * space <= body => Some(OmegaAxes::Space),
        () => None,
    };
    if rows.iter().all(is_same) {
        return Ok(OmegaAxes::Body);
    }
    let begun = Some(OmegaAxes::ALL.map(first)).filter(|[body, space]| body.min(*space) < BEGUN);
    told([body, space]).or_else(|| told(begun?)).ok_or(JudgeError::AmbiguousOmega { body, space })
}
