//! Meaning of the numbers of a log, determined from the log alone.

use std::path::Path;

use polhode::infer::judge::{
    AttitudeSense, DeclaredReading, MotionLog, OmegaAxes, OmegaReading, QuaternionOrder, ReadMotion, Reading,
    SignedAxes,
};
use polhode::math::Attitude;
use polhode_document::number::number;
use polhode_source::Failure;

use crate::selection::{Tried, Undecided, chosen};

/// Maximum number of pairs of rows in which attitudes and ω are compared.
const COMPARED: usize = 256;
/// Largest rotation between two rows that represent a continuous motion, rad.
const FOLLOWED: f64 = 1.0;

/// Relative difference of equal angular velocities: the rounding of two conversions.
const SAME_OMEGA: f64 = 1e-12;

/// Meaning of the attitudes of a log, and of its ω if it has any.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interpretation {
    pub(crate) reading: Reading,
    pub(crate) omega: Option<OmegaReading>,
}

impl Interpretation {
    /// Determines the meaning of a log: the declared one, and otherwise the one in which the
    /// attitudes rotate as ω states. `hint` is the advice how to declare it.
    ///
    /// # Errors
    /// [`Failure`] if nothing declares the meaning and ω does not determine it.
    pub(crate) fn of(
        path: &Path,
        log: &MotionLog,
        declared: &DeclaredReading,
        hint: &str,
    ) -> Result<Self, Failure> {
        let refused = |message: String| Err(Failure::usage(message, hint).in_file(path));
        let all = Self::all(log, &declared.certain());
        if let [only] = all[..] {
            return Ok(only);
        }
        let named = Self::all(log, declared);
        if log.omega().is_none() {
            return match named[..] {
                [only] => Ok(only),
                _ => refused(
                    "the log has no ω, which would determine the order and the sense of its attitudes"
                        .to_owned(),
                ),
            };
        }
        let tried = |candidates: Vec<Self>| candidates.into_iter().map(|one| one.tried(log)).collect();
        let is_same =
            |a: &Self, b: &Self| a.reading == b.reading && is_same_omega(&a.read(log), &b.read(log));
        let shown = |tried: &[Tried<Self>]| {
            let one = |tried: &Tried<Self>| {
                let omega = tried.of.omega.map_or_else(String::new, |omega| format!(", {omega}"));
                format!("{}{omega} (error {} of the rotation)", tried.of.reading, number(tried.relative, 2))
            };
            tried.iter().take(4).map(one).collect::<Vec<_>>().join("; ")
        };
        match chosen(tried(named), tried(all), is_same) {
            Ok(found) => Ok(found),
            Err(Undecided::Unlike(tried)) if tried.iter().all(|one| one.relative.is_infinite()) => refused(
                "no two rows of the log rotate by up to 1 rad, so ω does not determine its conventions"
                    .to_owned(),
            ),
            Err(Undecided::Unlike(tried)) => {
                refused(format!("the attitudes of the log do not rotate as its ω states: {}", shown(&tried)))
            }
            Err(Undecided::Ambiguous(fitting)) => {
                refused(format!("{} interpretations of the log fit: {}", fitting.len(), shown(&fitting)))
            }
        }
    }

    /// Returns the interpretations that are not excluded.
    fn all(log: &MotionLog, declared: &DeclaredReading) -> Vec<Self> {
        let (axes, time_origin) =
            (declared.axes.unwrap_or(SignedAxes::SAME), declared.time_origin.unwrap_or(0.0));
        let frames = match log.omega() {
            Some(_) => OmegaAxes::ALL.map(|frame| Some(OmegaReading::plain(frame))).to_vec(),
            None => vec![None],
        };
        let mut all = Vec::new();
        for order in QuaternionOrder::ALL {
            for sense in AttitudeSense::ALL {
                let reading = Reading { order, sense, axes, time_origin, time_factor: 1.0 };
                all.extend(frames.iter().map(|&omega| Self { reading, omega }));
            }
        }
        all.retain(|one| {
            declared.order.is_none_or(|order| order == one.reading.order)
                && declared.sense.is_none_or(|sense| sense == one.reading.sense)
                && one.omega.is_none_or(|omega| declared.omega_axes.is_none_or(|frame| frame == omega.frame))
        });
        all
    }

    /// Returns the motion of a log with this meaning.
    pub(crate) fn read(&self, log: &MotionLog) -> ReadMotion {
        self.reading.read(log, self.omega)
    }

    /// Compares the rotation between two rows, R_kᵀ R_(k+1) = exp(θ), with ½ (ω_k + ω_(k+1)) Δt.
    fn tried(self, log: &MotionLog) -> Tried<Self> {
        let motion = self.read(log);
        let (mut off, mut turned, mut count) = (0.0, 0.0, 0.0);
        let omega = motion.omega.as_deref().unwrap_or_default();
        let pairs = motion.times.windows(2).zip(motion.attitude.windows(2)).zip(omega.windows(2));
        for ((times, attitudes), omega) in pairs.take(COMPARED) {
            let [Ok(from), Ok(to)] = [0, 1].map(|k| Attitude::from_quaternion(attitudes[k])) else {
                continue;
            };
            let theta = (from.inverse() * to).log().to_array();
            let [a, b] = [0, 1].map(|k| omega[k].to_array());
            let expected = [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]) * (times[1] - times[0]));
            let square = |of: &dyn Fn(usize) -> f64| (0..3).map(|i| of(i).powi(2)).sum::<f64>();
            let size = square(&|i| theta[i]);
            if size > FOLLOWED * FOLLOWED {
                continue;
            }
            off += square(&|i| theta[i] - expected[i]);
            turned += size;
            count += 1.0;
        }
        let relative = if turned > 0.0 { f64::sqrt(off / turned) } else { f64::INFINITY };
        Tried { of: self, angle: f64::sqrt(off / f64::max(count, 1.0)), relative }
    }
}

/// Returns true if two motions have the same ω, as in a rotation about one axis of body and space.
fn is_same_omega(a: &ReadMotion, b: &ReadMotion) -> bool {
    let (a, b) = (a.omega.as_deref().unwrap_or_default(), b.omega.as_deref().unwrap_or_default());
    let largest = a.iter().map(|omega| omega.norm()).fold(0.0, f64::max);
    a.iter().zip(b).all(|(&a, &b)| (a - b).norm() <= SAME_OMEGA * largest)
}
