//! Start of a motion, read from the first row of its log.

use polhode::infer::judge::{
    AttitudeSense, DeclaredReading, LogError, MotionLog, OmegaAxes, OmegaReading, QuaternionOrder, Reading,
    Readings, SignedAxes,
};
use polhode::math::Attitude;

use super::FreeBody;
use super::error::FirstRowError;
use crate::selection::{FITS, REPLACES, Tried, Undecided, chosen};

/// Attitude and angular velocity at the first row of a log.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// R_space_body as a quaternion (w, x, y, z) of the length that it has in the log.
    pub(super) quaternion: [f64; 4],
    /// Angular velocity, body axes, rad/s.
    pub(super) omega: [f64; 3],
}

/// Difference of equal starts, rad and relative: the rounding of two conversions.
const SAME: f64 = 1e-12;
/// Residual (relative) below which no other interpretation is tried.
const EXACT: f64 = 1e-6;
/// Number of places in which an interpretation contrary to the names is compared.
const PLACES: usize = 4;

impl Start {
    /// Returns the start in the interpretation with which the next rows of the log follow from it.
    ///
    /// Interpretations by the names of the columns come first. The others include an ω with wrong
    /// signs: −ω along body axes is at first like conjugate attitudes with ω along space axes.
    /// Attitudes from space to body, unless the names state them, therefore are among the others.
    /// An interpretation that the user declares completely is not tested.
    ///
    /// # Errors
    /// [`FirstRowError`] if the log has no ω and the body none, if no interpretation fits, or if
    /// several fit with different starts.
    pub(super) fn of(
        log: &MotionLog,
        declared: &DeclaredReading,
        body: &FreeBody,
    ) -> Result<Self, FirstRowError> {
        let certain = Candidate::all(log, &declared.certain(), body, &[SignedAxes::SAME])?;
        if let [only] = certain[..] {
            return Ok(only.start);
        }
        let named = Candidate::all(log, declared, body, &[SignedAxes::SAME])?.into_iter();
        let mut named = named.map(|one| one.tried(log, declared, body)).collect::<Result<Vec<_>, _>>()?;
        named.sort_by(|a, b| a.angle.total_cmp(&b.angle));
        let sense = declared.sense.unwrap_or(AttitudeSense::BodyToSpace);
        let is_plain = |one: &Tried<Candidate>| one.of.reading.sense == sense;
        let is_rival = |one: &Tried<Candidate>| is_plain(one) && one.fits(FITS) && one.is_near(&named[0]);
        if !named.iter().any(is_rival) {
            named.retain(is_plain);
        }
        let mut all = Vec::new();
        if !named.iter().any(|one| one.relative <= EXACT) {
            let mirrored = Candidate::all(log, &declared.certain(), body, &signs())?;
            let is_new = |one: &Candidate| !certain.iter().any(|other| other.is_same(one));
            let others = certain.iter().copied().chain(mirrored.into_iter().filter(is_new));
            all.extend(others.map(|one| one.tried_everywhere(log, declared, body)));
        }
        let shown = |tried: &[Tried<Candidate>]| {
            tried.iter().map(|one| (one.of.shown(body), one.relative)).collect::<Vec<_>>()
        };
        let found = chosen(named.clone(), all, |a, b| a.start.is_same(&b.start));
        let is_given = body.omega.is_some();
        match found {
            Ok(found) => Ok(found.start),
            Err(Undecided::Ambiguous(fitting)) => {
                let rank = |one: &&Tried<Candidate>| (!is_plain(one), !one.of.is_scalar_first());
                match fitting.iter().min_by_key(rank) {
                    // A body at rest stays at rest in every interpretation.
                    Some(one) if fitting.iter().all(|one| one.of.start.rate() == 0.0) => Ok(one.of.start),
                    _ => Err(FirstRowError::Ambiguous { fitting: shown(&fitting), is_given }),
                }
            }
            Err(Undecided::Unlike(_)) => {
                let stated = named.first().map_or(f64::NAN, |best| best.of.start.rate());
                if stated == 0.0 {
                    let row = (1..log.times().len()).find(|&row| rate(log, row) > 0.0).unwrap_or(1);
                    return Err(FirstRowError::AtRest { row, rate: rate(log, row) });
                }
                let ratio = rate(log, 1) / stated;
                Err(FirstRowError::Unlike { ratio, tried: shown(&named), is_given })
            }
        }
    }

    /// Returns the start by the first row of a log.
    fn of_first(
        log: &MotionLog,
        reading: Reading,
        omega: OmegaReading,
        body: &FreeBody,
    ) -> Result<Self, FirstRowError> {
        let numbers = log.attitude()[0];
        let read = |logged: &[[f64; 3]]| reading.omega(logged[0], omega, numbers).to_array();
        let omega = body.omega.or(log.omega().map(read)).ok_or(FirstRowError::NoOmega)?;
        Ok(Self { quaternion: reading.quaternion(numbers), omega })
    }

    /// Returns |ω|, rad/s.
    fn rate(&self) -> f64 {
        let [x, y, z] = self.omega;
        x.hypot(y).hypot(z)
    }

    fn is_same(&self, other: &Self) -> bool {
        let apart = (0..3).map(|k| (self.omega[k] - other.omega[k]).abs()).fold(0.0, f64::max);
        angle(self.quaternion, other.quaternion) <= SAME && apart <= SAME * self.rate()
    }
}

/// Interpretation of a first row, with the start that it gives.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    reading: Reading,
    omega: OmegaReading,
    start: Start,
}

impl Candidate {
    /// Returns the interpretations that are not excluded, with each of the components of ω, and
    /// without a second one of the same attitudes and start.
    fn all(
        log: &MotionLog,
        declared: &DeclaredReading,
        body: &FreeBody,
        components: &[SignedAxes],
    ) -> Result<Vec<Self>, FirstRowError> {
        let mut found: Vec<Self> = Vec::new();
        for order in
            QuaternionOrder::ALL.into_iter().filter(|one| declared.order.is_none_or(|said| said == *one))
        {
            for sense in
                AttitudeSense::ALL.into_iter().filter(|one| declared.sense.is_none_or(|said| said == *one))
            {
                for frame in OmegaAxes::ALL
                    .into_iter()
                    .filter(|one| declared.omega_axes.is_none_or(|said| said == *one))
                {
                    let axes = SignedAxes::SAME;
                    let reading = Reading { order, sense, axes, time_origin: 0.0, time_factor: 1.0 };
                    for &components in components {
                        let omega = OmegaReading { components, ..OmegaReading::plain(frame) };
                        let start = Start::of_first(log, reading, omega, body)?;
                        let one = Self { reading, omega, start };
                        if !found.iter().any(|other| other.is_same(&one)) {
                            found.push(one);
                        }
                    }
                }
            }
        }
        Ok(found)
    }

    fn is_scalar_first(&self) -> bool {
        self.reading.order == QuaternionOrder::ScalarFirst
    }

    fn is_same(&self, other: &Self) -> bool {
        self.reading == other.reading && self.start.is_same(&other.start)
    }

    /// Compares the beginning of a log with the motion from its first row.
    fn tried(
        self,
        log: &MotionLog,
        declared: &DeclaredReading,
        body: &FreeBody,
    ) -> Result<Tried<Self>, FirstRowError> {
        let declared = DeclaredReading {
            order: Some(self.reading.order),
            sense: Some(self.reading.sense),
            omega_axes: Some(self.omega.frame),
            ..FreeBody::declared(log, &declared.certain())
        };
        let start = Start::of_first(log, self.reading, self.omega, body)?;
        let readings = Readings::of(log, &start.scenario(body)?.scenario, &declared)?;
        let [angle, relative] =
            readings.tried.first().map_or([f64::INFINITY; 2], |best| [best.attitude, best.relative]);
        Ok(Tried { of: self, angle, relative })
    }

    /// Compares rows in several places with the motion, and returns the largest residual: the first
    /// rows may fit by chance. A given ω is only that of the first row.
    fn tried_everywhere(self, log: &MotionLog, declared: &DeclaredReading, body: &FreeBody) -> Tried<Self> {
        let unlike = Tried { of: self, angle: f64::INFINITY, relative: f64::INFINITY };
        let mut worst = self.tried(log, declared, body).unwrap_or(unlike);
        for place in 1..PLACES {
            let row = place * log.times().len() / PLACES;
            if body.omega.is_some() || !worst.fits(REPLACES) || row + 3 > log.times().len() {
                break;
            }
            let there = from(row, log).ok().and_then(|rest| self.tried(&rest, declared, body).ok());
            let there = there.unwrap_or(unlike);
            worst.angle = worst.angle.max(there.angle);
            worst.relative = worst.relative.max(there.relative);
        }
        worst
    }

    fn shown(&self, body: &FreeBody) -> String {
        match body.omega {
            Some(_) => self.reading.to_string(),
            None => format!("{}, {}", self.reading, self.omega),
        }
    }
}

/// Returns the components of ω with all choices of signs.
fn signs() -> Vec<SignedAxes> {
    let is_in_order = |axes: &SignedAxes| axes.to_scenario([1.0, 2.0, 3.0]).map(f64::abs) == [1.0, 2.0, 3.0];
    SignedAxes::ALL.into_iter().chain(SignedAxes::ALL.map(SignedAxes::reversed)).filter(is_in_order).collect()
}

/// Returns the rows of a log from `row` on.
fn from(row: usize, log: &MotionLog) -> Result<MotionLog, LogError> {
    let rest = MotionLog::new(log.times()[row..].to_vec(), log.attitude()[row..].to_vec())?;
    match log.omega() {
        Some(omega) => rest.with_omega(omega[row..].to_vec()),
        None => Ok(rest),
    }
}

/// Returns the rotation rate since the previous row, rad/s. It does not depend on the convention of
/// the attitudes.
fn rate(log: &MotionLog, row: usize) -> f64 {
    let angle = angle(log.attitude()[row - 1], log.attitude()[row]);
    if angle <= SAME { 0.0 } else { angle / (log.times()[row] - log.times()[row - 1]) }
}

/// Returns the angle between two attitudes of any convention, rad.
fn angle(a: [f64; 4], b: [f64; 4]) -> f64 {
    match (Attitude::from_quaternion(a), Attitude::from_quaternion(b)) {
        (Ok(a), Ok(b)) => a.angle_to(b),
        _ => f64::NAN,
    }
}
