//! What the numbers of a log mean.

use core::fmt;

use super::axes::SignedAxes;
use super::declared::{AttitudeSense, OmegaAxes};
use super::difference::to_body;
use super::log::{MotionLog, QuaternionOrder};
use super::motion::ReadMotion;
use crate::math::frame::Body;
use crate::math::vector::AngularVelocity;

/// What the numbers of a log mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// The order of its quaternions.
    pub order: QuaternionOrder,
    /// Which way its rotations go.
    pub sense: AttitudeSense,
    /// Its axes, of space and of the body.
    pub axes: SignedAxes,
    /// The log's time at the scenario's time 0, s.
    pub time_origin: f64,
}

/// How well a log begins as its scenario, if it is read so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReadingResidual {
    /// The reading.
    pub reading: Reading,
    /// The angle between the attitudes that are read and the exact ones, rad: root of the mean square over the beginning.
    pub attitude: f64,
    /// The same as a part of the angle that the exact motion turns through in the beginning.
    pub relative: f64,
}

impl Reading {
    /// A quaternion of the log: R_space_body, scalar first, in the scenario's axes.
    pub fn quaternion(&self, numbers: [f64; 4]) -> [f64; 4] {
        let [w, x, y, z] = self.order.scalar_first(numbers);
        let [x, y, z] = self.axes.to_scenario([x, y, z]);
        match self.sense {
            AttitudeSense::BodyToSpace => [w, x, y, z],
            AttitudeSense::SpaceToBody => [w, -x, -y, -z],
        }
    }

    /// An angular velocity of the log, in body axes; `numbers` are those of the attitude beside it.
    pub fn omega(&self, omega: [f64; 3], axes: OmegaAxes, numbers: [f64; 4]) -> AngularVelocity<Body> {
        let omega = self.axes.to_scenario(omega);
        AngularVelocity::from_array(match axes {
            OmegaAxes::Space => to_body(self.quaternion(numbers), omega),
            OmegaAxes::Body => omega,
        })
    }

    /// A log's motion; without ω where it is not said along which axes that is.
    pub fn read(&self, log: &MotionLog, omega_axes: Option<OmegaAxes>) -> ReadMotion {
        let times = log.times().iter().map(|time| time - self.time_origin).collect();
        let attitude = log.attitude().iter().map(|&numbers| self.quaternion(numbers)).collect();
        let omega = log.omega().zip(omega_axes).map(|(omega, axes)| {
            omega
                .iter()
                .zip(log.attitude())
                .map(|(&omega, &numbers)| self.omega(omega, axes, numbers))
                .collect()
        });
        ReadMotion { times, attitude, omega }
    }
}

/// `quaternions w, x, y, z of body to space, axes (x, z, −y), times from 2 s`: axes and times where they are not the scenario's.
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
        Ok(())
    }
}
