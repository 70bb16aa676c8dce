//! Start of a motion, read from the first row of its log.

use polhode::infer::judge::{
    AttitudeSense, DeclaredReading, MotionLog, OmegaAxes, OmegaReading, QuaternionOrder, Reading, Readings,
    SignedAxes,
};
use polhode::math::Attitude;

use super::FreeBody;
use super::error::FirstRowError;
use crate::selection::{Tried, Undecided, chosen};

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

impl Start {
    /// Returns the start in the interpretation with which the next rows of the log follow from it.
    ///
    /// Interpretations by the names of the columns come first, then all others, as in
    /// [`Readings::of`]. One that the user declares completely is not tested.
    ///
    /// # Errors
    /// [`FirstRowError`] if the log has no ω and the body none, if no interpretation fits, or if
    /// several fit with different starts.
    pub(super) fn of(
        log: &MotionLog,
        declared: &DeclaredReading,
        body: &FreeBody,
    ) -> Result<Self, FirstRowError> {
        let all = Candidate::all(log, &declared.certain(), body)?;
        if let [only] = all[..] {
            return Ok(only.start);
        }
        let tried = |candidates: Vec<Candidate>| {
            let tried = candidates.into_iter().map(|one| one.tried(log, declared, body));
            tried.collect::<Result<Vec<Tried<Candidate>>, _>>()
        };
        let (named, all) = (tried(Candidate::all(log, declared, body)?)?, tried(all)?);
        let shown = |tried: &[Tried<Candidate>]| {
            tried.iter().map(|one| (one.of.shown(body), one.relative)).collect::<Vec<_>>()
        };
        let found = chosen(named, all, |a, b| a.start.is_same(&b.start));
        found.map(|found| found.start).map_err(|undecided| match undecided {
            Undecided::Unlike(tried) => {
                let ratio = rate(log) / tried.first().map_or(f64::NAN, |best| best.of.start.rate());
                FirstRowError::Unlike { ratio, tried: shown(&tried) }
            }
            Undecided::Ambiguous(fitting) => FirstRowError::Ambiguous { fitting: shown(&fitting) },
        })
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
    frame: OmegaAxes,
    start: Start,
}

impl Candidate {
    /// Returns the interpretations that are not excluded, without a second one of the same
    /// attitudes and start.
    fn all(log: &MotionLog, declared: &DeclaredReading, body: &FreeBody) -> Result<Vec<Self>, FirstRowError> {
        let logged = log.omega().map(|omega| omega[0]);
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
                    let numbers = log.attitude()[0];
                    let read = |logged| reading.omega(logged, OmegaReading::plain(frame), numbers).to_array();
                    let omega = body.omega.or(logged.map(read)).ok_or(FirstRowError::NoOmega)?;
                    let start = Start { quaternion: reading.quaternion(numbers), omega };
                    let is_known = |other: &Self| other.reading == reading && other.start.is_same(&start);
                    if !found.iter().any(is_known) {
                        found.push(Self { reading, frame, start });
                    }
                }
            }
        }
        Ok(found)
    }

    /// Compares the beginning of the log with the motion from this start.
    fn tried(
        self,
        log: &MotionLog,
        declared: &DeclaredReading,
        body: &FreeBody,
    ) -> Result<Tried<Self>, FirstRowError> {
        let declared = DeclaredReading {
            order: Some(self.reading.order),
            sense: Some(self.reading.sense),
            omega_axes: Some(self.frame),
            ..FreeBody::declared(log, &declared.certain())
        };
        let readings = Readings::of(log, &self.start.scenario(body)?.scenario, &declared)?;
        let [angle, relative] =
            readings.tried.first().map_or([f64::INFINITY; 2], |best| [best.attitude, best.relative]);
        Ok(Tried { of: self, angle, relative })
    }

    fn shown(&self, body: &FreeBody) -> String {
        match body.omega {
            Some(_) => self.reading.to_string(),
            None => format!("{}, {}", self.reading, OmegaReading::plain(self.frame)),
        }
    }
}

/// Returns the rotation rate between the first two rows, rad/s. It does not depend on the
/// convention of the attitudes.
fn rate(log: &MotionLog) -> f64 {
    angle(log.attitude()[0], log.attitude()[1]) / (log.times()[1] - log.times()[0])
}

/// Returns the angle between two attitudes of any convention, rad.
fn angle(a: [f64; 4], b: [f64; 4]) -> f64 {
    match (Attitude::from_quaternion(a), Attitude::from_quaternion(b)) {
        (Ok(a), Ok(b)) => a.angle_to(b),
        _ => f64::NAN,
    }
}
