//! The report of `polhode stability`: permanent rotations, and small oscillations about an equilibrium.

mod summary;
mod text;

use polhode::{Finding, MotionError, PermanentRotation, Rotor, Scenario, SmallOscillations, State};
use serde_json::Value;

use crate::source::SourceInfo;

/// Whether steady motions of a scenario's body last, ready to be read.
///
/// ```
/// use polhode::*;
/// use polhode_report::{SourceInfo, StabilityReport};
/// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
/// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 1.0, 0.0) };
/// let report = StabilityReport::new(SourceInfo::new("body.toml", "scenario"), &body, &[], start);
/// // √((2 − 1)(3 − 2)/(1·3)) ω
/// assert!(report.to_text().contains("a departure grows at 0.577")); // |L| = 2, as at the start, along axis 2: ω = 1 rad/s
/// # Ok::<(), BodyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct StabilityReport {
    /// Where the body came from.
    pub source: SourceInfo,
    /// What was noticed on the way.
    pub findings: Vec<Finding>,
    rotor: Rotor,
    /// |L| that the permanent rotations have, kg·m²/s.
    momentum: f64,
    /// True if it is that of the start.
    is_of_start: bool,
    rotations: Result<Vec<PermanentRotation>, MotionError>,
    /// None without torques.
    oscillations: Option<Result<Found, MotionError>>,
}

/// Small oscillations, and how their equilibrium was found.
#[derive(Clone, Debug)]
struct Found {
    place: Place,
    /// The turn from the start's attitude, rad.
    turned: f64,
    oscillations: SmallOscillations,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// The start is an equilibrium.
    Start,
    /// The nearest one with the start's ω in space.
    Nearest,
    /// The nearest one at rest.
    Rest,
}

impl StabilityReport {
    /// The report of a scenario.
    pub fn of_scenario(source: SourceInfo, scenario: &Scenario) -> Self {
        let report = Self::new(source, &scenario.rotor(), &scenario.torques, scenario.start);
        Self { findings: scenario.findings.clone(), ..report }
    }

    /// The report of a body, its torques and its start.
    pub fn new(source: SourceInfo, rotor: &Rotor, torques: &[polhode::TorqueModel], start: State) -> Self {
        let at_start = rotor.angular_momentum_space(&start).norm();
        // A body at rest is asked about 1 rad/s around its axis of greatest moment.
        let momentum = if at_start > 0.0 { at_start } else { rotor.principal().moments()[2] };
        Self {
            source,
            findings: Vec::new(),
            rotor: rotor.clone(),
            momentum,
            is_of_start: at_start > 0.0,
            rotations: PermanentRotation::all(rotor, momentum),
            oscillations: (!torques.is_empty()).then(|| found(rotor, torques, start)),
        }
    }

    /// One screen for people.
    pub fn to_text(&self) -> String {
        text::write(self)
    }

    /// One object with the same keys for every scenario.
    pub fn to_json(&self) -> Value {
        summary::of(self)
    }
}

/// The oscillations about the start if it is an equilibrium, else about the nearest one that turns as the start does, else about the
/// nearest one at rest.
fn found(rotor: &Rotor, torques: &[polhode::TorqueModel], start: State) -> Result<Found, MotionError> {
    let about = |place: Place, equilibrium: State| {
        let oscillations = SmallOscillations::about(rotor, torques, equilibrium)?;
        Ok(Found { place, turned: equilibrium.attitude.angle_to(start.attitude), oscillations })
    };
    let near = |state| SmallOscillations::equilibrium_near(rotor, torques, state);
    let rest = State { omega: polhode::AngularVelocity::ZERO, ..start };
    about(Place::Start, start)
        .or_else(|_| about(Place::Nearest, near(start)?))
        .or_else(|_| about(Place::Rest, near(rest)?))
}
