//! Measurements of a body in free flight.

use polhode::math::{AngularVelocity, Attitude, Body};
use polhode::motion::Wheel;
use polhode::motion::torque::TorqueModel;

use crate::error::IdentifyError;

/// Flight of a body: gyro readings, attitudes or both.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    name: String,
    gyro: Vec<GyroReading>,
    attitudes: Vec<AttitudeReading>,
    added: [f64; 6],
    wheels: Vec<Wheel>,
    torques: Vec<TorqueModel>,
}

/// Reading of a gyro.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GyroReading {
    /// Time, s.
    pub time: f64,
    /// Angular velocity along the sensor's axes, rad/s, as read.
    pub omega: AngularVelocity<Body>,
}

/// Measured attitude of body-fixed axes relative to space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttitudeReading {
    /// Time, s.
    pub time: f64,
    /// Rotation from the tracked body axes to space.
    pub attitude: Attitude,
}

/// Minimum number of readings in a flight: its initial ω has three parameters.
pub(crate) const LEAST_READINGS: usize = 4;

impl Flight {
    /// Creates a flight from gyro readings in order of time.
    ///
    /// # Errors
    /// [`IdentifyError::TooFew`] for fewer than four readings; [`IdentifyError::Value`] for times
    /// that do not ascend and numbers that are not finite.
    pub fn of_gyro(name: impl Into<String>, gyro: Vec<GyroReading>) -> Result<Self, IdentifyError> {
        Self::new(name, gyro, Vec::new())
    }

    /// Creates a flight from gyro readings and attitudes, each in order of time; one of the two may
    /// be empty.
    ///
    /// # Errors
    /// Same as [`Flight::of_gyro`].
    pub fn new(
        name: impl Into<String>,
        gyro: Vec<GyroReading>,
        attitudes: Vec<AttitudeReading>,
    ) -> Result<Self, IdentifyError> {
        let given = gyro.len().max(attitudes.len());
        if given < LEAST_READINGS {
            return Err(IdentifyError::TooFew {
                what: "readings of a flight",
                given,
                needed: LEAST_READINGS,
            });
        }
        for reading in &gyro {
            for value in reading.omega.to_array() {
                IdentifyError::require("a component of a gyro reading", value, true, "a number")?;
            }
        }
        ascending(gyro.iter().map(|reading| reading.time))?;
        ascending(attitudes.iter().map(|reading| reading.time))?;
        Ok(Self {
            name: name.into(),
            gyro,
            attitudes,
            added: [0.0; 6],
            wheels: Vec::new(),
            torques: Vec::new(),
        })
    }

    /// Returns the flight with an added body of known inertia.
    ///
    /// `added` is the increase Ixx, Iyy, Izz, Ixy, Ixz, Iyz of the tensor about the common centre
    /// of mass, kg·m², along the sensor's axes. Flights with and without the added body determine
    /// the size of the moments.
    #[must_use]
    pub fn with_added(self, added: [f64; 6]) -> Self {
        Self { added, ..self }
    }

    /// Returns the flight with wheels of known momentum in the body. They determine the size of the
    /// moments.
    #[must_use]
    pub fn with_wheels(self, wheels: Vec<Wheel>) -> Self {
        Self { wheels, ..self }
    }

    /// Returns the flight with known torques. They determine the size of the moments.
    #[must_use]
    pub fn with_torques(self, torques: Vec<TorqueModel>) -> Self {
        Self { torques, ..self }
    }

    /// Returns the name of the flight.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the gyro readings in order of time.
    pub fn gyro(&self) -> &[GyroReading] {
        &self.gyro
    }

    /// Returns the measured attitudes in order of time.
    pub fn attitudes(&self) -> &[AttitudeReading] {
        &self.attitudes
    }

    /// Returns the known increase of the tensor in this flight, kg·m².
    pub const fn added(&self) -> [f64; 6] {
        self.added
    }

    /// Returns the wheels in the body, whose momentum is known.
    pub fn wheels(&self) -> &[Wheel] {
        &self.wheels
    }

    /// Returns the known torques on the body.
    pub fn torques(&self) -> &[TorqueModel] {
        &self.torques
    }

    /// Returns true if an added body, a wheel or a torque determines the size of the moments.
    pub(crate) fn has_scale(&self) -> bool {
        self.added != [0.0; 6] || !self.wheels.is_empty() || !self.torques.is_empty()
    }

    /// Returns the first and last time of all readings, s.
    pub(crate) fn span(&self) -> [f64; 2] {
        let times = self.gyro.iter().map(|r| r.time).chain(self.attitudes.iter().map(|r| r.time));
        times.fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], t| [from.min(t), to.max(t)])
    }

    /// Returns the flight with only those gyro readings for which `holds` is true.
    pub(crate) fn of_gyro_readings(&self, holds: impl Fn(&GyroReading) -> bool) -> Self {
        Self { gyro: self.gyro.iter().copied().filter(holds).collect(), ..self.clone() }
    }

    /// Returns the flight with each component of all rates multiplied by a factor.
    pub(crate) fn with_rates_times(&self, factors: [f64; 3]) -> Self {
        let times = |reading: &GyroReading| {
            let omega = reading.omega.to_array();
            let omega = AngularVelocity::from_array(core::array::from_fn(|k| omega[k] * factors[k]));
            GyroReading { omega, ..*reading }
        };
        Self { gyro: self.gyro.iter().map(times).collect(), ..self.clone() }
    }

    /// Returns the part of the flight between two times; `None` if it has too few readings.
    pub(crate) fn cut(&self, from: f64, to: f64) -> Option<Self> {
        let inside = |time: f64| (from..=to).contains(&time);
        let gyro: Vec<_> = self.gyro.iter().copied().filter(|r| inside(r.time)).collect();
        let attitudes: Vec<_> = self.attitudes.iter().copied().filter(|r| inside(r.time)).collect();
        (gyro.len().max(attitudes.len()) >= LEAST_READINGS).then(|| Self { gyro, attitudes, ..self.clone() })
    }
}

fn ascending(times: impl Iterator<Item = f64>) -> Result<(), IdentifyError> {
    let mut previous = f64::NEG_INFINITY;
    for time in times {
        IdentifyError::require("a time of a flight", time, time > previous, "later than the previous one")?;
        previous = time;
    }
    Ok(())
}
