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
/// Largest rotation between two rows at rest, rad: the rounding of quaternions.
const STILL: f64 = 1e-12;

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
    /// attitudes rotate as ω states.
    ///
    /// # Errors
    /// [`Failure`] if nothing declares the meaning and ω does not determine it.
    pub(crate) fn of(
        path: &Path,
        log: &MotionLog,
        declared: &DeclaredReading,
        hint: Hint,
    ) -> Result<Self, Failure> {
        let conventions = hint.conventions(log.omega().is_some());
        let refused_with = |message: String, hint: &str| Err(Failure::usage(message, hint).in_file(path));
        let refused = |message: String| refused_with(message, conventions);
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
            Err(Undecided::Unlike(tried)) => {
                let (pairs, largest) = turning_pairs(log);
                if pairs.is_empty() {
                    let why = if largest > FOLLOWED {
                        "the attitude rotates by more than 1 rad from row to row"
                    } else {
                        "the attitude does not rotate"
                    };
                    return refused(format!("{why}, so ω does not determine the conventions of the log"));
                }
                let (ratio, shown) = (number(rate_ratio(log, &pairs), 4), shown(&tried));
                let message = format!(
                    "the attitudes of the log do not rotate as its ω states; their rate is {ratio} times |ω|: {shown}"
                );
                refused_with(message, &format!("{}; or {conventions}", hint.units()))
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

    /// Returns true if a declaration, such as the name of a column, states another meaning.
    pub(crate) fn contradicts(&self, declared: &DeclaredReading) -> bool {
        declared.order.is_some_and(|order| order != self.reading.order)
            || declared.sense.is_some_and(|sense| sense != self.reading.sense)
            || self.omega.is_some_and(|omega| declared.omega_axes.is_some_and(|frame| frame != omega.frame))
    }

    /// Returns true if a convention of a log that the user does not declare differs from `other`.
    pub(crate) fn differs(&self, other: &Self, log: &MotionLog, declared: &DeclaredReading) -> bool {
        let certain = declared.certain();
        let by_other = Self { omega: self.omega.and(other.omega), ..*self };
        certain.order.is_none() && self.reading.order != other.reading.order
            || certain.sense.is_none() && self.reading.sense != other.reading.sense
            || certain.omega_axes.is_none()
                && by_other.omega.is_some()
                && !is_same_omega(&self.read(log), &by_other.read(log))
    }

    /// Compares the rotation between two rows, R_kᵀ R_(k+1) = exp(θ), with ½ (ω_k + ω_(k+1)) Δt.
    fn tried(self, log: &MotionLog) -> Tried<Self> {
        let motion = self.read(log);
        let (mut off, mut turned) = (0.0, 0.0);
        let omega = motion.omega.as_deref().unwrap_or_default();
        let (pairs, _) = turning_pairs(log);
        for &k in &pairs {
            let [Ok(from), Ok(to)] = [k, k + 1].map(|k| Attitude::from_quaternion(motion.attitude[k])) else {
                continue;
            };
            let theta = (from.inverse() * to).log().to_array();
            let [a, b] = [k, k + 1].map(|k| omega.get(k).map_or([0.0; 3], |omega| omega.to_array()));
            let step = motion.times[k + 1] - motion.times[k];
            let expected = [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]) * step);
            off += square([0, 1, 2].map(|i| theta[i] - expected[i]));
            turned += square(theta);
        }
        let relative = if turned > 0.0 { f64::sqrt(off / turned) } else { f64::INFINITY };
        Tried { of: self, angle: f64::sqrt(off / pairs.len().max(1) as f64), relative }
    }
}

/// Options, or lines of a log, by which the user may declare a meaning.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Hint {
    /// Options, which describe the run.
    Options,
    /// Line before the header, which describes the other log.
    Line,
}

impl Hint {
    const fn conventions(self, has_omega: bool) -> &'static str {
        match (self, has_omega) {
            (Self::Options, true) => {
                "state its conventions: --quaternion wxyz or xyzw, --sense body-to-space or space-to-body, --omega body or space"
            }
            (Self::Options, false) => {
                "state its conventions: --quaternion wxyz or xyzw, --sense body-to-space or space-to-body"
            }
            (Self::Line, true) => {
                "state its conventions in a line before its header: # columns = \"quaternion wxyz body-to-space = qw qx qy qz, omega body = wx wy wz\""
            }
            (Self::Line, false) => {
                "state its conventions in a line before its header: # columns = \"quaternion wxyz body-to-space = qw qx qy qz\""
            }
        }
    }

    const fn units(self) -> &'static str {
        match self {
            Self::Options => {
                "check the units of ω and of the times (deg/s for rad/s is a factor of 57.3): --columns \"omega deg/s = wx wy wz\""
            }
            Self::Line => {
                "check the units of ω and of the times (deg/s for rad/s is a factor of 57.3): a line before its header: # columns = \"omega deg/s = wx wy wz\""
            }
        }
    }
}

/// Returns the first rows of up to [`COMPARED`] pairs, spread over those between which the attitude
/// rotates, and the largest rotation between two rows, rad. They do not depend on the conventions.
fn turning_pairs(log: &MotionLog) -> (Vec<usize>, f64) {
    let angles: Vec<f64> = (1..log.times().len()).map(|k| angle(log, k)).collect();
    let turning: Vec<usize> =
        (0..angles.len()).filter(|&k| angles[k] > STILL && angles[k] <= FOLLOWED).collect();
    let every = turning.len().div_ceil(COMPARED).max(1);
    (turning.into_iter().step_by(every).collect(), angles.into_iter().fold(0.0, f64::max))
}

/// Returns the rotation since the previous row, rad.
fn angle(log: &MotionLog, row: usize) -> f64 {
    let [from, to] = [row - 1, row].map(|row| Attitude::from_quaternion(log.attitude()[row]));
    from.and_then(|from| Ok(from.angle_to(to?))).unwrap_or(0.0)
}

/// Returns the rotation of the attitude relative to that by |ω|.
fn rate_ratio(log: &MotionLog, pairs: &[usize]) -> f64 {
    let turned: f64 = pairs.iter().map(|&k| angle(log, k + 1)).sum();
    let omega = log.omega().unwrap_or_default();
    let size = |row: usize| omega.get(row).map_or(0.0, |&omega| square(omega).sqrt());
    let step = |k: usize| log.times()[k + 1] - log.times()[k];
    turned / pairs.iter().map(|&k| 0.5 * (size(k) + size(k + 1)) * step(k)).sum::<f64>()
}

fn square(v: [f64; 3]) -> f64 {
    v.iter().map(|c| c * c).sum()
}

/// Returns true if two motions have the same ω, as in a rotation about one axis of body and space.
fn is_same_omega(a: &ReadMotion, b: &ReadMotion) -> bool {
    let (a, b) = (a.omega.as_deref().unwrap_or_default(), b.omega.as_deref().unwrap_or_default());
    let largest = a.iter().map(|omega| omega.norm()).fold(0.0, f64::max);
    a.iter().zip(b).all(|(&a, &b)| (a - b).norm() <= SAME_OMEGA * largest)
}
