//! The report of `polhode stability`: permanent rotations, and small oscillations about an equilibrium.

mod summary;
mod text;

use polhode::body::Finding;
use polhode::math::{AngularVelocity, Direction, Space};
use polhode::motion::torque::{EnergySink, TorqueModel};
use polhode::motion::{MotionError, Rotor, Scenario, State};
use polhode::observe::{OrbitalEquilibrium, PermanentRotation, SmallOscillations, SteadyTop};
use serde_json::Value;

use crate::source::SourceInfo;

/// Whether steady motions of a scenario's body last, ready to be read.
///
/// ```
/// use polhode::prelude::*;
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
    /// Friction inside.
    sink: Option<EnergySink>,
    /// At each time from which on the wheels keep their momentum; at the start if there is none.
    judged: Vec<Judged>,
    /// True if a motor never stops.
    is_always_driven: bool,
}

/// What lasts while the wheels have the momentum of one time.
#[derive(Clone, Debug)]
struct Judged {
    /// s
    time: f64,
    rotations: Result<Vec<PermanentRotation>, MotionError>,
    /// None without torques.
    oscillations: Option<Result<Found, MotionError>>,
}

/// Small oscillations, and how their equilibrium was found.
#[derive(Clone, Debug)]
struct Found {
    start: State,
    place: Place,
    /// The turn from the start's attitude, rad; of a top that of its axis.
    turned: f64,
    /// How much its ω in space differs from the start's, rad/s.
    omega_off: f64,
    oscillations: SmallOscillations,
    /// All attitudes at rest relative to a circular orbit, the nearest first.
    on_orbit: Vec<(OrbitalEquilibrium, SmallOscillations)>,
}

#[derive(Clone, Debug)]
enum Place {
    /// The start is an equilibrium.
    Start,
    /// The nearest one that keeps its place relative to the orbit.
    Orbit(Box<OrbitalEquilibrium>),
    /// A steady motion of a heavy symmetric top: that with the start's momenta, and upright with the start's spin if that is another.
    Top(Box<SteadyTop>, Option<Box<SteadyTop>>),
    /// The nearest one with the start's ω in space.
    Nearest,
    /// The nearest one that turns about the vertical, as fast as the start does about it.
    Vertical,
    /// The nearest one at rest.
    Rest,
}

impl StabilityReport {
    /// The report of a scenario.
    pub fn of_scenario(source: SourceInfo, scenario: &Scenario) -> Self {
        let report = Self::new(source, scenario.rotor(), scenario.torques(), scenario.start());
        Self { findings: scenario.findings().to_vec(), ..report }
    }

    /// The report of a body, its torques and its start.
    pub fn new(source: SourceInfo, rotor: &Rotor, torques: &[TorqueModel], start: State) -> Self {
        let at_start = rotor.angular_momentum_space(&start).norm();
        // A body at rest is asked about 1 rad/s around its axis of greatest moment.
        let momentum = if at_start > 0.0 { at_start } else { rotor.principal().moments()[2] };
        let times = PermanentRotation::times(rotor);
        let is_always_driven = times.is_empty();
        let judged = |time: f64| Judged {
            time,
            rotations: PermanentRotation::all_at(rotor, momentum, time),
            oscillations: (!torques.is_empty()).then(|| found(rotor, torques, State { time, ..start })),
        };
        Self {
            source,
            findings: Vec::new(),
            rotor: rotor.clone(),
            momentum,
            is_of_start: at_start > 0.0,
            sink: sink(torques),
            judged: if is_always_driven {
                vec![judged(start.time)]
            } else {
                times.into_iter().map(judged).collect()
            },
            is_always_driven,
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

/// All friction inside, as one sink.
fn sink(torques: &[TorqueModel]) -> Option<EnergySink> {
    let coefficient = |torque: &TorqueModel| match torque {
        TorqueModel::EnergySink(sink) => sink.coefficient(),
        _ => 0.0,
    };
    EnergySink::new(torques.iter().map(coefficient).sum()).ok()
}

/// The oscillations about the start if it is an equilibrium, else about the one that is meant: at rest relative to an orbit, the steady
/// motion of a top, the nearest that turns as the start does, or about the vertical, or is at rest.
fn found(rotor: &Rotor, torques: &[TorqueModel], start: State) -> Result<Found, MotionError> {
    let about = |state: State| SmallOscillations::about(rotor, torques, state);
    let near = |omega: AngularVelocity<Space>| {
        let omega = start.attitude.inverse() * omega;
        about(SmallOscillations::equilibrium_near(rotor, torques, State { omega, ..start })?)
    };
    let on_orbit: Vec<(OrbitalEquilibrium, SmallOscillations)> =
        OrbitalEquilibrium::all(rotor, torques, start)
            .ok()
            .flatten()
            .unwrap_or_default()
            .into_iter()
            .filter_map(|equilibrium| Some((equilibrium.clone(), about(equilibrium.state).ok()?)))
            .collect();
    let found = |place: Place, oscillations: SmallOscillations| {
        let equilibrium = oscillations.equilibrium;
        Found {
            start,
            place,
            turned: equilibrium.attitude.angle_to(start.attitude),
            omega_off: (equilibrium.omega_space() - start.omega_space()).norm(),
            oscillations,
            on_orbit: on_orbit.clone(),
        }
    };
    if let Ok(oscillations) = about(start) {
        return Ok(found(Place::Start, oscillations));
    }
    if let Some((equilibrium, oscillations)) = on_orbit.first() {
        return Ok(found(Place::Orbit(Box::new(equilibrium.clone())), oscillations.clone()));
    }
    if let Some(found) = top(rotor, torques, start) {
        return Ok(found);
    }
    let spin = start.omega_space();
    if let Ok(oscillations) = near(spin) {
        return Ok(found(Place::Nearest, oscillations));
    }
    if let Some(up) = vertical(torques)
        && let Ok(oscillations) = near(AngularVelocity::from_array((up * up.dot(spin)).to_array()))
    {
        return Ok(found(Place::Vertical, oscillations));
    }
    near(AngularVelocity::ZERO).map(|oscillations| found(Place::Rest, oscillations))
}

/// The steady motion of a heavy symmetric top that turns.
fn top(rotor: &Rotor, torques: &[TorqueModel], start: State) -> Option<Found> {
    let [TorqueModel::Gravity(gravity)] = torques else { return None };
    if start.omega.norm() == 0.0 {
        return None;
    }
    let steady = SteadyTop::with_momenta_of(rotor, gravity, start).ok()?;
    let upright =
        SteadyTop::upright(rotor, gravity, start).ok().filter(|upright| upright.angle != steady.angle);
    // An axis that starts upright is meant to be so, whether or not it stays.
    let lever = start.attitude * rotor.lever();
    let is_upright = lever.angle_to(-gravity.acceleration) < UPRIGHT;
    let (steady, other) = match upright {
        Some(upright) if is_upright => (upright, Some(steady)),
        upright => (steady, upright),
    };
    let [turned, omega_off] = steady.distance_from(rotor, &start);
    let oscillations = steady.oscillations.clone();
    let place = Place::Top(Box::new(steady), other.map(Box::new));
    Some(Found { start, place, turned, omega_off, oscillations, on_orbit: Vec::new() })
}

/// An axis nearer to the vertical than this starts upright, rad.
const UPRIGHT: f64 = 1e-6;

/// Against gravity.
fn vertical(torques: &[TorqueModel]) -> Option<Direction<Space>> {
    torques.iter().find_map(|torque| match torque {
        TorqueModel::Gravity(gravity) => (-gravity.acceleration).direction(),
        _ => None,
    })
}
