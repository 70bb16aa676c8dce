//! Meaning of the numbers of a log.

use core::fmt;

use super::axes::SignedAxes;
use super::declared::{AttitudeSense, OmegaAxes};
use super::difference::to_body;
use super::log::{MotionLog, QuaternionOrder};
use super::motion::ReadMotion;
use super::omega_reading::OmegaReading;
use crate::math::frame::Body;
use crate::math::vector::AngularVelocity;

/// Meaning of a log's times and attitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Order of the quaternion's numbers.
    pub order: QuaternionOrder,
    /// Direction of the rotations.
    pub sense: AttitudeSense,
    /// Axes of the log, of space and of the body, as axes of the scenario.
    pub axes: SignedAxes,
    /// The log's time at the scenario's time 0, in s of the log's clock.
    pub time_origin: f64,
    /// Seconds per stated second of the log's clock: 1 if the unit is the stated one.
    pub time_factor: f64,
}

/// Residual of a reading: the difference between the beginning of the log and that of the scenario.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReadingResidual {
    /// Reading of the log.
    pub reading: Reading,
    /// RMS angle between the attitudes of the log and the exact ones over the beginning, rad.
    pub attitude: f64,
    /// This angle relative to the rotation angle of the exact motion in the beginning.
    pub relative: f64,
}

impl Reading {
    /// Units of time that are tried, as factors of the stated one, with an example of each.
    pub(super) const TIME_FACTORS: [(f64, &'static str); 8] = [
        (1e-3, "ms for s"),
        (1e-6, "µs for s"),
        (1e-9, "ns for s"),
        (60.0, "min for s"),
        (1e3, "s for ms"),
        (1e6, "s for µs"),
        (1e9, "s for ns"),
        (1.0 / 60.0, "s for min"),
    ];

    /// Returns the scenario's time for a time of the log, s.
    pub fn time(&self, logged: f64) -> f64 {
        (logged - self.time_origin) * self.time_factor
    }

    /// Returns a quaternion of the log as R_space_body, scalar first, along the scenario's axes.
    pub fn quaternion(&self, numbers: [f64; 4]) -> [f64; 4] {
        let [w, x, y, z] = self.order.scalar_first(numbers);
        let [x, y, z] = self.axes.to_scenario([x, y, z]);
        match self.sense {
            AttitudeSense::BodyToSpace => [w, x, y, z],
            AttitudeSense::SpaceToBody => [w, -x, -y, -z],
        }
    }

    /// Returns an angular velocity of the log along body axes, rad/s; `numbers` are those of the
    /// attitude in the same row.
    pub fn omega(&self, omega: [f64; 3], meant: OmegaReading, numbers: [f64; 4]) -> AngularVelocity<Body> {
        let omega = self.axes.to_scenario(meant.components.to_scenario(omega).map(|c| c * meant.factor));
        AngularVelocity::from_array(match meant.frame {
            OmegaAxes::Space => to_body(self.quaternion(numbers), omega),
            OmegaAxes::Body => omega,
        })
    }

    /// Returns a log's motion; without ω if its meaning is unknown.
    pub fn read(&self, log: &MotionLog, omega: Option<OmegaReading>) -> ReadMotion {
        let times = log.times().iter().map(|&time| self.time(time)).collect();
        let attitude = log.attitude().iter().map(|&numbers| self.quaternion(numbers)).collect();
        let omega = log.omega().zip(omega).map(|(omega, meant)| {
            omega
                .iter()
                .zip(log.attitude())
                .map(|(&omega, &numbers)| self.omega(omega, meant, numbers))
                .collect()
        });
        ReadMotion { times, attitude, omega }
    }
}

/// Text such as `quaternions w, x, y, z of body to space, axes (x, z, −y), times from 2 s`; axes
/// and times are included if they differ from the scenario's.
impl fmt::Display for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.order {
            QuaternionOrder::ScalarFirst => "quaternions w, x, y, z",
            QuaternionOrder::ScalarLast => "quaternions x, y, z, w",
        })?;
        f.write_str(match self.sense {
            AttitudeSense::BodyToSpace => " of body to space",
            AttitudeSense::SpaceToBody => " of space to body",
        })?;
        if self.axes != SignedAxes::SAME {
            write!(f, ", axes {}", self.axes)?;
        }
        if self.time_origin != 0.0 {
            write!(f, ", times from {} s", self.time_origin)?;
        }
        if self.time_factor != 1.0 {
            let known = Self::TIME_FACTORS.iter().find(|(factor, _)| *factor == self.time_factor);
            write!(f, ", times × {}", self.time_factor)?;
            if let Some((_, example)) = known {
                write!(f, " (such as {example})")?;
            }
        }
        Ok(())
    }
}
