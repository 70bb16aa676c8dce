//! What was measured at the wrist.

use polhode::math::{
    Acceleration, AngularAcceleration, AngularVelocity, Attitude, Body, Force, Space, Torque,
};

use super::edge::EdgeKind;
use super::motion::Motion;
use super::small::{self, Matrix6, Vector6};
use crate::error::IdentifyError;

/// The wrench at one time, and the motion of the sensor. Everything is about the sensor's origin, along the sensor's axes: these are the payload's body
/// axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PayloadRow {
    /// s, ascending.
    pub time: f64,
    /// Angular velocity of the sensor relative to space, rad/s.
    pub omega: AngularVelocity<Body>,
    /// Its derivative, rad/s².
    pub alpha: AngularAcceleration<Body>,
    /// Acceleration of the sensor's origin relative to space, without gravity: zero at rest, m/s².
    pub acceleration: Acceleration<Body>,
    /// The acceleration of free fall, pointing down, m/s². [`gravity_along`] turns it to the sensor's axes.
    pub gravity: Acceleration<Body>,
    /// N.
    pub force: Force<Body>,
    /// N·m, about the sensor's origin.
    pub torque: Torque<Body>,
}

/// Gravity along the sensor's axes: g_body = Rᵀ g_space.
///
/// ```
/// use polhode::math::{Acceleration, Attitude, Direction};
/// use polhode_identify::payload::gravity_along;
/// let quarter = Attitude::about(Direction::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_2)?;
/// let down = gravity_along(quarter, Acceleration::new(0.0, 0.0, -9.81));
/// assert!((down.y + 9.81).abs() < 1e-14 && down.z.abs() < 1e-14);
/// # Ok::<(), polhode::math::RotationError>(())
/// ```
pub fn gravity_along(attitude: Attitude, gravity: Acceleration<Space>) -> Acceleration<Body> {
    attitude.inverse() * gravity
}

/// Whose wrench it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WrenchSense {
    /// What the sensor does to the payload: at rest the force points up.
    OnPayload,
    /// What the payload does to the sensor: at rest the force points down, as a scale reads.
    OnSensor,
}

impl WrenchSense {
    pub(super) const fn sign(self) -> f64 {
        match self {
            Self::OnPayload => 1.0,
            Self::OnSensor => -1.0,
        }
    }

    /// The other.
    pub const fn other(self) -> Self {
        match self {
            Self::OnPayload => Self::OnSensor,
            Self::OnSensor => Self::OnPayload,
        }
    }
}

/// Noise of the wrench: white, of mean zero but for the bias.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "there is one of each log")]
pub enum WrenchNoise {
    /// Not known: one standard deviation of the forces and one of the torques, from second differences of what the model leaves. A model that is wrong in a
    /// way that is smooth in time then still shows.
    Unknown,
    /// Standard deviations of each component.
    Deviations {
        /// N
        force: f64,
        /// N·m
        torque: f64,
    },
    /// Covariance of fx, fy, fz, τx, τy, τz.
    Covariance([[f64; 6]; 6]),
}

/// Standard deviations of each component of the motion, which is measured too. Zero, the default, is a motion that is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionNoise {
    /// rad/s
    pub omega: f64,
    /// rad/s²
    pub alpha: f64,
    /// Of the acceleration less gravity, m/s².
    pub acceleration: f64,
}

/// A log of wrenches and motion that can be used, and what is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct PayloadLog {
    rows: Vec<PayloadRow>,
    pub(super) sense: WrenchSense,
    pub(super) noise: WrenchNoise,
    pub(super) motion_noise: MotionNoise,
    pub(super) has_bias: bool,
    pub(super) kind: Option<EdgeKind>,
}

impl PayloadLog {
    /// Rows in the order of time, without bias; the noise of the wrench unknown, that of the motion zero.
    ///
    /// # Errors
    /// Where a number is not finite or times do not ascend.
    /// [`IdentifyError::AllZero`] where all forces, or all torques, are zero.
    pub fn new(rows: Vec<PayloadRow>, sense: WrenchSense) -> Result<Self, IdentifyError> {
        let mut before = f64::NEG_INFINITY;
        for row in &rows {
            for (what, values) in [
                ("an angular velocity", row.omega.to_array()),
                ("an angular acceleration", row.alpha.to_array()),
                ("an acceleration", row.acceleration.to_array()),
                ("gravity", row.gravity.to_array()),
                ("a force", row.force.to_array()),
                ("a torque", row.torque.to_array()),
            ] {
                for value in values {
                    IdentifyError::require(what, value, true, "finite")?;
                }
            }
            IdentifyError::require("a time", row.time, row.time > before, "finite and after the one before")?;
            before = row.time;
        }
        // A connected sensor has noise: zeros are columns that nothing wrote.
        let zero = |of: fn(&PayloadRow) -> [f64; 3]| rows.iter().all(|row| of(row) == [0.0; 3]);
        if !rows.is_empty() && zero(|row| row.force.to_array()) {
            return Err(IdentifyError::AllZero { what: "force" });
        }
        if !rows.is_empty() && zero(|row| row.torque.to_array()) {
            return Err(IdentifyError::AllZero { what: "torque" });
        }
        Ok(Self {
            rows,
            sense,
            noise: WrenchNoise::Unknown,
            motion_noise: MotionNoise::default(),
            has_bias: false,
            kind: None,
        })
    }

    /// The sensor reads a constant wrench besides, which is to be found.
    #[must_use]
    pub const fn with_bias(mut self) -> Self {
        self.has_bias = true;
        self
    }

    /// The payload is known to be of this kind, a sheet or a thin bar. Errors are those of such a body.
    #[must_use]
    pub const fn with_kind(mut self, kind: EdgeKind) -> Self {
        self.kind = Some(kind);
        self
    }

    /// The noise of the wrench is known.
    ///
    /// # Errors
    /// Where a standard deviation is not positive, or the covariance not symmetric and positive definite.
    pub fn with_noise(mut self, noise: WrenchNoise) -> Result<Self, IdentifyError> {
        match noise {
            WrenchNoise::Unknown => {}
            WrenchNoise::Deviations { force, torque } => {
                IdentifyError::require("the noise of a force", force, force > 0.0, "positive")?;
                IdentifyError::require("the noise of a torque", torque, torque > 0.0, "positive")?;
            }
            WrenchNoise::Covariance(c) => {
                for i in 0..6 {
                    for j in 0..i {
                        let equal = (c[i][j] - c[j][i]).abs() <= 1e-12 * (c[i][i] * c[j][j]).abs().sqrt();
                        let what = "an element of the covariance";
                        IdentifyError::require(
                            what,
                            c[i][j],
                            equal,
                            "that of the other side of the diagonal",
                        )?;
                    }
                }
                let (what, rule) = ("the covariance of the wrench", "positive definite: its least pivot");
                let pivot = if small::cholesky(&c).is_some() { 1.0 } else { small::least_pivot(&c) };
                IdentifyError::require(what, pivot, pivot > 0.0, rule)?;
            }
        }
        self.noise = noise;
        Ok(self)
    }

    /// The motion is measured, with noise.
    ///
    /// # Errors
    /// Where a standard deviation is negative.
    pub fn with_motion_noise(mut self, noise: MotionNoise) -> Result<Self, IdentifyError> {
        for (what, sd) in [
            ("the noise of an angular velocity", noise.omega),
            ("the noise of an angular acceleration", noise.alpha),
            ("the noise of an acceleration", noise.acceleration),
        ] {
            IdentifyError::require(what, sd, sd >= 0.0, "zero or positive")?;
        }
        self.motion_noise = noise;
        Ok(self)
    }

    /// As they were given.
    pub fn rows(&self) -> &[PayloadRow] {
        &self.rows
    }

    /// How many numbers are to be found.
    pub(super) const fn unknowns(&self) -> usize {
        if self.has_bias { 16 } else { 10 }
    }

    /// Of ω, α and a − g.
    pub(super) fn motion_deviations(&self) -> [f64; 9] {
        let MotionNoise { omega, alpha, acceleration } = self.motion_noise;
        [omega, omega, omega, alpha, alpha, alpha, acceleration, acceleration, acceleration]
    }
}

impl PayloadRow {
    pub(super) fn wrench(&self) -> Vector6 {
        let (f, t) = (self.force, self.torque);
        [f.x, f.y, f.z, t.x, t.y, t.z]
    }

    pub(super) fn motion(&self) -> Motion {
        let (w, a, s) = (self.omega, self.alpha, self.acceleration - self.gravity);
        Motion([w.x, w.y, w.z, a.x, a.y, a.z, s.x, s.y, s.z])
    }
}

/// A diagonal covariance.
pub(super) fn diagonal(force: f64, torque: f64) -> Matrix6 {
    let mut c = [[0.0; 6]; 6];
    for (k, row) in c.iter_mut().enumerate() {
        let sd = if k < 3 { force } else { torque };
        row[k] = sd * sd;
    }
    c
}
