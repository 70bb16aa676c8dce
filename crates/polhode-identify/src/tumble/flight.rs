//! What was measured of a body while nothing but itself turned it.

use polhode::math::{AngularVelocity, Attitude, Body};
use polhode::motion::Wheel;
use polhode::motion::torque::TorqueModel;

use crate::error::IdentifyError;

/// One flight of a body: a gyro's readings, or attitudes, or both, while it was free.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    name: String,
    gyro: Vec<GyroReading>,
    attitudes: Vec<AttitudeReading>,
    added: [f64; 6],
    wheels: Vec<Wheel>,
    torques: Vec<TorqueModel>,
}

/// A reading of a gyro.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GyroReading {
    /// s
    pub time: f64,
    /// Along the sensor's axes, rad/s, as it was read.
    pub omega: AngularVelocity<Body>,
}

/// A measured attitude: of axes fixed in the body, in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttitudeReading {
    /// s
    pub time: f64,
    /// From the axes of the body that are tracked to space.
    pub attitude: Attitude,
}

/// Readings that a flight needs at least: what it starts with takes three numbers.
pub(crate) const LEAST_READINGS: usize = 4;

impl Flight {
    /// A flight by its gyro's readings, in the order of time.
    ///
    /// # Errors
    /// [`IdentifyError::TooFew`] for fewer than four readings; [`IdentifyError::Value`] for times that do not ascend and numbers that are not finite.
    pub fn of_gyro(name: impl Into<String>, gyro: Vec<GyroReading>) -> Result<Self, IdentifyError> {
        Self::new(name, gyro, Vec::new())
    }

    /// A flight by a gyro's readings and by attitudes, each in the order of time; one of the two may be empty.
    ///
    /// # Errors
    /// As [`Flight::of_gyro`].
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
                IdentifyError::require("a component of a gyro's reading", value, true, "a number")?;
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

    /// The same flight of the body with something added whose tensor is known: Ixx, Iyy, Izz, Ixy, Ixz, Iyz by which the tensor about the common centre of mass is
    /// greater, kg·m², along the sensor's axes. Flights with and without it say how large the moments are.
    #[must_use]
    pub fn with_added(self, added: [f64; 6]) -> Self {
        Self { added, ..self }
    }

    /// The same flight with wheels that turn in the body with known momentum: they say how large the moments are.
    #[must_use]
    pub fn with_wheels(self, wheels: Vec<Wheel>) -> Self {
        Self { wheels, ..self }
    }

    /// The same flight under known torques: they say how large the moments are.
    #[must_use]
    pub fn with_torques(self, torques: Vec<TorqueModel>) -> Self {
        Self { torques, ..self }
    }

    /// What it is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The gyro's readings.
    pub fn gyro(&self) -> &[GyroReading] {
        &self.gyro
    }

    /// The measured attitudes.
    pub fn attitudes(&self) -> &[AttitudeReading] {
        &self.attitudes
    }

    /// By how much the tensor is greater in this flight, kg·m².
    pub const fn added(&self) -> [f64; 6] {
        self.added
    }

    /// The wheels that turn in the body.
    pub fn wheels(&self) -> &[Wheel] {
        &self.wheels
    }

    /// The torques that are known.
    pub fn torques(&self) -> &[TorqueModel] {
        &self.torques
    }

    /// True if something known in it says how large the moments are.
    pub(crate) fn has_scale(&self) -> bool {
        self.added != [0.0; 6] || !self.wheels.is_empty() || !self.torques.is_empty()
    }

    /// The first and the last time, s.
    pub(crate) fn span(&self) -> [f64; 2] {
        let times = self.gyro.iter().map(|r| r.time).chain(self.attitudes.iter().map(|r| r.time));
        times.fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], t| [from.min(t), to.max(t)])
    }

    /// The same with some of the gyro's readings.
    pub(crate) fn of_gyro_readings(&self, holds: impl Fn(&GyroReading) -> bool) -> Self {
        Self { gyro: self.gyro.iter().copied().filter(holds).collect(), ..self.clone() }
    }

    /// The same with the components of all rates times factors.
    pub(crate) fn with_rates_times(&self, factors: [f64; 3]) -> Self {
        let times = |reading: &GyroReading| {
            let omega = reading.omega.to_array();
            let omega = AngularVelocity::from_array(core::array::from_fn(|k| omega[k] * factors[k]));
            GyroReading { omega, ..*reading }
        };
        Self { gyro: self.gyro.iter().map(times).collect(), ..self.clone() }
    }

    /// The part of it from one time to another; `None` if too little is in it.
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
        IdentifyError::require("a time of a flight", time, time > previous, "later than the one before")?;
        previous = time;
    }
    Ok(())
}
