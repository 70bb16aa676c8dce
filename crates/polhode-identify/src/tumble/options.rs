//! What is asked of tumbles.

use polhode::motion::torque::DragLaw;

use super::range::GyroRange;
use super::sensor::GyroErrors;

/// How flights are read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TumbleOptions {
    /// What is found of the gyro.
    pub gyro: GyroErrors,
    /// Drag that is found with the body, and how it grows with ω: its matrix along the gyro's axes.
    pub drag: Option<DragLaw>,
    /// Standard deviation of a gyro's component, rad/s; found from the readings if none is given.
    pub gyro_noise: Option<f64>,
    /// Its range, beyond which readings are none; found from the readings if none is given.
    pub gyro_range: Option<GyroRange>,
    /// Standard deviation of a component of the attitude, rad; it has to be given if there are attitudes.
    pub attitude_noise: Option<f64>,
    /// Beyond so many standard deviations a reading is left out, and counted.
    pub outlier: f64,
}

impl Default for TumbleOptions {
    /// A bias, noise and range that are found, outliers beyond 6 standard deviations.
    fn default() -> Self {
        let gyro = GyroErrors { bias: true, ..GyroErrors::default() };
        Self { gyro, drag: None, gyro_noise: None, gyro_range: None, attitude_noise: None, outlier: 6.0 }
    }
}
