//! Log of a motion as another program wrote it, before the meaning of its numbers is known.

use core::fmt;

/// Order of the four numbers of a quaternion in a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum QuaternionOrder {
    /// Scalar first: w, x, y, z.
    ScalarFirst,
    /// Scalar last: x, y, z, w.
    ScalarLast,
}

impl QuaternionOrder {
    /// Both orders.
    pub const ALL: [Self; 2] = [Self::ScalarFirst, Self::ScalarLast];

    /// Returns the quaternion with the scalar first.
    pub const fn scalar_first(self, [a, b, c, d]: [f64; 4]) -> [f64; 4] {
        match self {
            Self::ScalarFirst => [a, b, c, d],
            Self::ScalarLast => [d, a, b, c],
        }
    }
}

/// Times, attitudes, and optionally angular velocities, row by row, as a program wrote them.
///
/// The four numbers of an attitude are proportional to a quaternion. A [`super::ReadMotion`] is the
/// motion after the order of the numbers, the direction of the rotation and the axes of the angular
/// velocity have been determined.
///
/// ```
/// use polhode::infer::judge::MotionLog;
/// let log = MotionLog::new(vec![0.0, 0.1], vec![[1.0, 0.0, 0.0, 0.0], [0.8, 0.0, 0.6, 0.0]])?;
/// assert_eq!(log.times().len(), 2);
/// assert!(MotionLog::new(vec![0.1, 0.0], vec![[1.0, 0.0, 0.0, 0.0]; 2]).is_err());
/// # Ok::<(), polhode::infer::judge::LogError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MotionLog {
    times: Vec<f64>,
    attitude: Vec<[f64; 4]>,
    omega: Option<Vec<[f64; 3]>>,
}

/// Error of a log. Rows count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LogError {
    /// The log has fewer than two rows.
    TooShort {
        /// Number of rows.
        rows: usize,
    },
    /// The number of attitudes, or of angular velocities, differs from the number of times.
    Lengths {
        /// Name of the quantity.
        what: &'static str,
        /// Number of its rows.
        count: usize,
        /// Number of times.
        times: usize,
    },
    /// A time is not later than the one before.
    NotLater {
        /// Index of the row.
        row: usize,
        /// Time of the row, s.
        time: f64,
        /// Time of the row before, s.
        before: f64,
    },
    /// A number is NaN or infinite.
    NotFinite {
        /// Index of the row.
        row: usize,
        /// Name of the number.
        what: &'static str,
        /// Value of the number.
        value: f64,
    },
    /// A quaternion has length 0.
    ZeroQuaternion {
        /// Index of the row.
        row: usize,
    },
    /// A quaternion has a length far from 1.
    Length {
        /// Index of the row.
        row: usize,
        /// Length of the quaternion.
        length: f64,
    },
}

impl fmt::Display for LogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooShort { rows } => write!(f, "a motion needs at least 2 rows, but this one has {rows}"),
            Self::Lengths { what, count, times } => write!(f, "there are {count} {what} but {times} times"),
            Self::NotLater { row, time, before } => {
                write!(
                    f,
                    "row {row}: the time {time} s is not later than {before} s, that of the previous row"
                )
            }
            Self::NotFinite { row, what, value } => {
                write!(f, "row {row}: {what} is {value}, but must be finite")
            }
            Self::ZeroQuaternion { row } => {
                write!(f, "row {row}: the quaternion is zero, but must have length 1")
            }
            Self::Length { row, length } => {
                write!(f, "row {row}: the quaternion's length is {length:e}, but must be near 1")
            }
        }
    }
}

impl core::error::Error for LogError {}

impl MotionLog {
    /// Returns the log of times (s, ascending) and attitudes.
    ///
    /// # Errors
    /// [`LogError`] for fewer than two rows, different numbers of times and attitudes, numbers that
    /// are not finite, times that are not ascending, and quaternions whose length is zero or
    /// outside 1e-3 … 1e3.
    pub fn new(times: Vec<f64>, attitude: Vec<[f64; 4]>) -> Result<Self, LogError> {
        let rows = times.len();
        if rows < 2 {
            return Err(LogError::TooShort { rows });
        }
        require_rows("attitudes", attitude.len(), rows)?;
        for (row, time) in times.iter().enumerate() {
            require_finite(row, "the time", *time)?;
        }
        if let Some(k) = (1..rows).find(|&k| times[k] <= times[k - 1]) {
            return Err(LogError::NotLater { row: k, time: times[k], before: times[k - 1] });
        }
        for (row, quaternion) in attitude.iter().enumerate() {
            quaternion.iter().try_for_each(|&c| require_finite(row, "a number of the attitude", c))?;
            if quaternion.iter().all(|&c| c == 0.0) {
                return Err(LogError::ZeroQuaternion { row });
            }
            let length = quaternion.iter().fold(0.0, |length: f64, c| length.hypot(*c));
            if !LENGTHS.contains(&length) {
                return Err(LogError::Length { row, length });
            }
        }
        Ok(Self { times, attitude, omega: None })
    }

    /// Returns the log with angular velocities, rad/s.
    ///
    /// # Errors
    /// [`LogError`] for numbers that are not finite, or if the number of rows differs from that of
    /// the times.
    pub fn with_omega(self, omega: Vec<[f64; 3]>) -> Result<Self, LogError> {
        require_rows("angular velocities", omega.len(), self.times.len())?;
        for (row, vector) in omega.iter().enumerate() {
            vector.iter().try_for_each(|&c| require_finite(row, "a number of ω", c))?;
        }
        Ok(Self { omega: Some(omega), ..self })
    }

    /// Returns the times of the rows, s.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Returns the numbers of the attitudes.
    pub fn attitude(&self) -> &[[f64; 4]] {
        &self.attitude
    }

    /// Returns the numbers of the angular velocities, rad/s, if there are any.
    pub fn omega(&self) -> Option<&[[f64; 3]]> {
        self.omega.as_deref()
    }

    /// Returns true if every number except the times has at most the 24 bits of single precision.
    pub fn is_single_precision(&self) -> bool {
        let single = |c: &f64| f64::from(*c as f32) == *c;
        let omega = self.omega.iter().flatten().flatten();
        self.attitude.iter().flatten().chain(omega).all(single)
    }
}

/// Accepted lengths of quaternions. Those of programs that never normalise drift, but not this far.
const LENGTHS: core::ops::RangeInclusive<f64> = 1e-3..=1e3;

fn require_rows(what: &'static str, count: usize, times: usize) -> Result<(), LogError> {
    if count == times { Ok(()) } else { Err(LogError::Lengths { what, count, times }) }
}

fn require_finite(row: usize, what: &'static str, value: f64) -> Result<(), LogError> {
    if value.is_finite() { Ok(()) } else { Err(LogError::NotFinite { row, what, value }) }
}
