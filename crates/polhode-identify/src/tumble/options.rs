//! Options of the estimation from tumbles.

use polhode::motion::torque::DragLaw;

use super::range::GyroRange;
use super::sensor::GyroErrors;

/// Options of [`identify_tumbles`](super::identify_tumbles).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TumbleOptions {
    /// Gyro errors to be estimated.
    pub gyro: GyroErrors,
    /// Law of drag against ω, if drag is to be estimated; its matrix is along the gyro's axes.
    pub drag: Option<DragLaw>,
    /// Standard deviation of a gyro component, rad/s; estimated from the readings if `None`.
    pub gyro_noise: Option<f64>,
    /// Range of the gyro; estimated from the readings if `None`. Readings outside are discarded.
    pub gyro_range: Option<GyroRange>,
    /// Standard deviation of an attitude component, rad; required if there are attitudes.
    pub attitude_noise: Option<f64>,
    /// Outlier threshold, standard deviations; readings beyond it are left out and counted.
    pub outlier: f64,
}

impl Default for TumbleOptions {
    /// Returns the default: bias estimated, noise and range from the readings, outliers beyond 6
    /// standard deviations.
    fn default() -> Self {
        let gyro = GyroErrors { bias: true, ..GyroErrors::default() };
        Self { gyro, drag: None, gyro_noise: None, gyro_range: None, attitude_noise: None, outlier: 6.0 }
    }
}
