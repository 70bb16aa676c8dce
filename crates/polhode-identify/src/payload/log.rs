//! Measurements at the wrist.

use polhode::math::{
    Acceleration, AngularAcceleration, AngularVelocity, Attitude, Body, Force, Space, Torque,
};

use super::edge::EdgeKind;
use super::motion::Motion;
use super::small::{self, Matrix6, Vector6};
use crate::error::IdentifyError;

/// Wrench and sensor motion at one time. All vectors are about the sensor's origin and along its
/// axes, which are the payload's body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PayloadRow {
    /// Time, s; ascending.
    pub time: f64,
    /// Angular velocity of the sensor relative to space, rad/s.
    pub omega: AngularVelocity<Body>,
    /// Angular acceleration of the sensor, rad/s².
    pub alpha: AngularAcceleration<Body>,
    /// Acceleration of the sensor's origin relative to space, without gravity, m/s²: zero at rest.
    pub acceleration: Acceleration<Body>,
    /// Gravitational acceleration, pointing down, m/s². [`gravity_along`] expresses it in the
    /// sensor's axes.
    pub gravity: Acceleration<Body>,
    /// Force, N; sense as in [`WrenchSense`].
    pub force: Force<Body>,
    /// Torque about the sensor's origin, N·m.
    pub torque: Torque<Body>,
}

/// Returns gravity along the sensor's axes: `g_body = Rᵀ g_space`, with R the attitude (sensor to
/// space).
///
/// ```
/// use polhode::math::{Acceleration, Attitude, Direction};
/// use polhode_identify::payload::gravity_along;
/// let quarter = Attitude::from_axis_angle(Direction::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_2)?;
/// let down = gravity_along(quarter, Acceleration::new(0.0, 0.0, -9.81));
/// assert!((down.y + 9.81).abs() < 1e-14 && down.z.abs() < 1e-14);
/// # Ok::<(), polhode::math::RotationError>(())
/// ```
pub fn gravity_along(attitude: Attitude, gravity: Acceleration<Space>) -> Acceleration<Body> {
    attitude.inverse() * gravity
}

/// Sense of the measured wrench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WrenchSense {
    /// Wrench of the sensor on the payload: at rest the force points up.
    OnPayload,
    /// Wrench of the payload on the sensor: at rest the force points down, as on a scale.
    OnSensor,
}

impl WrenchSense {
    pub(super) const fn sign(self) -> f64 {
        match self {
            Self::OnPayload => 1.0,
            Self::OnSensor => -1.0,
        }
    }

    /// Returns the opposite sense.
    pub const fn other(self) -> Self {
        match self {
            Self::OnPayload => Self::OnSensor,
            Self::OnSensor => Self::OnPayload,
        }
    }
}

/// White noise of the wrench, with zero mean apart from the bias.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "there is one of each log")]
pub enum WrenchNoise {
    /// Noise estimated from second differences of the residuals: one standard deviation for forces
    /// and one for torques. Model errors that are smooth in time remain detectable.
    Unknown,
    /// Standard deviations of each component.
    Deviations {
        /// Force, N.
        force: f64,
        /// Torque, N·m.
        torque: f64,
    },
    /// Covariance of fx, fy, fz, τx, τy, τz, in N and N·m.
    Covariance([[f64; 6]; 6]),
}

/// Standard deviations of each component of the measured motion. Zero, the default, means an exact
/// motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionNoise {
    /// Angular velocity, rad/s.
    pub omega: f64,
    /// Angular acceleration, rad/s².
    pub alpha: f64,
    /// Acceleration minus gravity, m/s².
    pub acceleration: f64,
}

/// Checked log of wrenches and motion, with its noise and options.
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
    /// Creates a log from rows in order of time, with no bias, unknown wrench noise and exact
    /// motion.
    ///
    /// # Errors
    /// [`IdentifyError::Value`] for numbers that are not finite or times that do not ascend.
    /// [`IdentifyError::AllZero`] if all forces, or all torques, are zero.
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
            IdentifyError::require(
                "a time",
                row.time,
                row.time > before,
                "finite and later than the previous one",
            )?;
            before = row.time;
        }
        // A connected sensor has noise, so zeros mean an empty column.
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

    /// Adds a constant wrench bias of the sensor to the estimated parameters.
    #[must_use]
    pub const fn with_bias(mut self) -> Self {
        self.has_bias = true;
        self
    }

    /// Constrains the payload to this kind, such as a sheet or a thin bar. Errors are those of such
    /// a body.
    #[must_use]
    pub const fn with_kind(mut self, kind: EdgeKind) -> Self {
        self.kind = Some(kind);
        self
    }

    /// Sets the noise of the wrench.
    ///
    /// # Errors
    /// [`IdentifyError::Value`] for a standard deviation that is not positive, or a covariance that
    /// is not symmetric and positive definite.
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
                            "equal to the element on the other side of the diagonal",
                        )?;
                    }
                }
                let (what, rule) = (
                    "the smallest pivot of the wrench's covariance",
                    "positive: the covariance must be positive definite",
                );
                let pivot = if small::cholesky(&c).is_some() { 1.0 } else { small::least_pivot(&c) };
                IdentifyError::require(what, pivot, pivot > 0.0, rule)?;
            }
        }
        self.noise = noise;
        Ok(self)
    }

    /// Sets the noise of the measured motion.
    ///
    /// # Errors
    /// [`IdentifyError::Value`] for a negative standard deviation.
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

    /// Returns the rows as passed to [`PayloadLog::new`].
    pub fn rows(&self) -> &[PayloadRow] {
        &self.rows
    }

    /// Returns the number of estimated parameters.
    pub(super) const fn unknowns(&self) -> usize {
        if self.has_bias { 16 } else { 10 }
    }

    /// Returns the standard deviations of ω, α and a − g.
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

/// Returns the diagonal covariance of these standard deviations.
pub(super) fn diagonal(force: f64, torque: f64) -> Matrix6 {
    let mut c = [[0.0; 6]; 6];
    for (k, row) in c.iter_mut().enumerate() {
        let sd = if k < 3 { force } else { torque };
        row[k] = sd * sd;
    }
    c
}
