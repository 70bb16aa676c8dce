//! Comparison of a run with another log of the same motion.

mod interpretation;
mod partners;

use std::path::Path;

use polhode::body::{InertiaTensor, MassProperties};
use polhode::infer::judge::{DeclaredReading, Growth, RateErrors, ReadMotion, RowErrors, Split};
use polhode::math::{AngularVelocity, Attitude, Body, Position};
use polhode::motion::{Rotor, State};
use polhode_source::{Failure, shown};
use polhode_table::log::{ReadColumns, RunLog};

pub(crate) use interpretation::{Hint, Interpretation};
use partners::Partners;

/// Other log, with its meaning.
#[derive(Clone, Debug)]
pub(crate) struct Other {
    pub(crate) path: String,
    pub(crate) engine: Option<String>,
    pub(crate) ignored: Vec<String>,
    pub(crate) is_single_precision: bool,
    pub(crate) interpretation: Interpretation,
    /// True if the interpretation contradicts the names of the columns.
    pub(crate) is_against_names: bool,
    pub(crate) motion: ReadMotion,
    read: Vec<ReadColumns>,
    /// Principal moments about the body axes, kg·m², if they are stated.
    moments: Option<[f64; 3]>,
}

/// Differences of a run from another log, row by row.
#[derive(Clone, Debug)]
pub(crate) struct Differences {
    pub(crate) interpretation: Interpretation,
    /// True if the interpretation contradicts the names of the columns.
    pub(crate) is_against_names: bool,
    /// True if the other log has the same columns with another meaning.
    pub(crate) has_other_meaning: bool,
    pub(crate) motion: ReadMotion,
    pub(crate) errors: RowErrors,
    pub(crate) split: Split,
    pub(crate) growth: Growth,
    /// Rotation that rounding and the differences of the times explain, rad.
    pub(crate) floor: f64,
    /// True if the moments are stated, so that energy and angular momentum are known.
    pub(crate) has_moments: bool,
}

impl Other {
    /// Interprets the other log.
    ///
    /// # Errors
    /// The errors of [`Interpretation::of`].
    pub(crate) fn of(path: &Path, log: &RunLog, moments: Option<[f64; 3]>) -> Result<Self, Failure> {
        let interpretation = Interpretation::of(path, &log.log, &log.says, Hint::Line)?;
        Ok(Self {
            path: shown(path),
            engine: log.engine.clone(),
            ignored: log.not_read(),
            is_single_precision: log.log.is_single_precision(),
            motion: interpretation.read(&log.log),
            is_against_names: interpretation.contradicts(&log.says),
            interpretation,
            read: log.read.clone(),
            moments,
        })
    }

    /// Returns the differences of a run, whose meaning may be declared, from this log at the run's
    /// times.
    ///
    /// # Errors
    /// The errors of [`Interpretation::of`]; and [`Failure`] if this log has no row at a time of the
    /// run.
    pub(crate) fn differences(
        &self,
        path: &Path,
        log: &RunLog,
        declared: &DeclaredReading,
    ) -> Result<Differences, Failure> {
        let interpretation = Interpretation::of(path, &log.log, declared, Hint::Options)?;
        let mut motion = interpretation.read(&log.log);
        let partners = Partners::of(&motion.times, &self.motion.times).map_err(|time| {
            let message = format!("the run has a row at {time} s, but {} has none at this time", self.path);
            let hint = "write both logs at the same times (the other log may have more rows); --time-origin sets the run's time at time 0 of the other log";
            Failure::usage(message, hint).in_file(path)
        })?;
        let state = |(&row, &time): (&usize, &f64)| {
            let omega = self.motion.omega.as_ref().map_or(AngularVelocity::ZERO, |omega| omega[row]);
            let attitude = Attitude::from_quaternion(self.motion.attitude[row]).map_err(|error| {
                Failure::usage(error.to_string(), "check the quaternions of the other log")
            })?;
            Ok(State { time, attitude, omega })
        };
        let rows = partners.rows.iter().zip(&motion.times);
        let exact = rows.map(state).collect::<Result<Vec<State>, Failure>>()?;
        if self.motion.omega.is_none() {
            motion.omega = None;
        }
        let tensor = InertiaTensor::<Body>::diagonal(self.moments.unwrap_or([1.0; 3]));
        let body = tensor.and_then(|tensor| MassProperties::new(1.0, Position::ZERO, tensor));
        let body =
            body.map_err(|error| Failure::usage(error.to_string(), "check --moments and its units"))?;
        let mut errors = RowErrors::of(&Rotor::free(&body), &motion, &exact);
        if let (Some(rates), Some(omega)) = (&mut errors.rates, &motion.omega)
            && exact.iter().all(|state| state.omega.norm() == 0.0)
        {
            relate_to_run(rates, omega, self.moments.unwrap_or([1.0; 3]));
        }
        let split = Split::of(&motion, &exact);
        let floor = ROUNDING + partners.apart * fastest(&exact);
        let growth = Growth::of(&motion.times, &errors.angles(), floor);
        let has_moments = self.moments.is_some();
        let has_other_meaning =
            log.read == self.read && interpretation.differs(&self.interpretation, &log.log, declared);
        Ok(Differences {
            interpretation,
            is_against_names: interpretation.contradicts(declared),
            has_other_meaning,
            motion,
            errors,
            split,
            growth,
            floor,
            has_moments,
        })
    }
}

/// Relates differences from a log at rest to the largest values of the run.
fn relate_to_run(rates: &mut RateErrors, omega: &[AngularVelocity<Body>], moments: [f64; 3]) {
    let related = |size: &dyn Fn([f64; 3]) -> f64| {
        let sizes: Vec<f64> = omega.iter().map(|omega| size(omega.to_array())).collect();
        let largest = sizes.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        sizes.into_iter().map(|size| size / largest).collect()
    };
    let norm = |[x, y, z]: [f64; 3]| x.hypot(y).hypot(z);
    let momentum = |omega: [f64; 3]| [0, 1, 2].map(|i| moments[i] * omega[i]);
    rates.omega = related(&norm);
    rates.kinetic_energy = related(&|omega| (0..3).map(|i| momentum(omega)[i] * omega[i]).sum());
    rates.momentum = related(&|omega| norm(momentum(omega)));
}

/// Rotation that rounding two quaternions to f64 may cause, rad.
const ROUNDING: f64 = 1e-15;

/// Returns the largest rotation rate between two rows, rad/s.
fn fastest(states: &[State]) -> f64 {
    let rate = |pair: &[State]| pair[0].attitude.angle_to(pair[1].attitude) / (pair[1].time - pair[0].time);
    states.windows(2).map(rate).fold(0.0, f64::max)
}
