//! The report of `polhode stability`: permanent rotations, and small oscillations about an equilibrium.

mod ground;
mod search;
mod summary;
mod text;

use polhode::body::Finding;
use polhode::motion::torque::{EnergySink, TorqueModel};
use polhode::motion::{MotionError, Rotor, Scenario, State};
use polhode::observe::PermanentRotation;
use polhode_document::SourceInfo;
use serde_json::Value;

use search::{Found, Prevented, search};

pub use ground::GroundStabilityReport;

/// Whether steady motions of a scenario's body last, ready to be read.
///
/// ```
/// use polhode::prelude::*;
/// use polhode_document::SourceInfo;
/// use polhode_report::StabilityReport;
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

/// A torque, and what it is called.
#[derive(Clone, Debug)]
struct Acting {
    /// The scenario's name of it, or else that of its model, with its number where another has the same.
    name: String,
    model: TorqueModel,
}

/// What lasts while the wheels have the momentum of one time.
#[derive(Clone, Debug)]
struct Judged {
    /// s
    time: f64,
    rotations: Result<Vec<PermanentRotation>, MotionError>,
    /// None without torques that act.
    oscillations: Option<Result<Found, Box<Prevented>>>,
    /// The names of torques that do not act then.
    idle: Vec<String>,
}

impl StabilityReport {
    /// The report of a scenario.
    pub fn of_scenario(source: SourceInfo, scenario: &Scenario) -> Self {
        let torques = scenario.torques().iter().zip(scenario.torque_names()).enumerate();
        let named = torques.map(|(k, (model, name))| {
            let is_alone =
                scenario.torques().iter().filter(|other| other.name() == model.name()).count() == 1;
            let unnamed = || match is_alone {
                true => model.name().to_owned(),
                false => format!("{}, torque {} of the scenario", model.name(), k + 1),
            };
            let name = name.clone().unwrap_or_else(unnamed);
            (Acting { name, model: model.clone() }, !scenario.switched_off().contains(&k))
        });
        let report = Self::of(source, scenario.rotor(), &named.collect::<Vec<_>>(), scenario.start());
        let findings = scenario.findings().iter().cloned().chain(scenario.taken_at_start());
        Self { findings: findings.collect(), ..report }
    }

    /// The report of a body, its torques and its start.
    pub fn new(source: SourceInfo, rotor: &Rotor, torques: &[TorqueModel], start: State) -> Self {
        let named = |model: &TorqueModel| Acting { name: model.name().to_owned(), model: model.clone() };
        let torques: Vec<_> = torques.iter().map(|model| (named(model), true)).collect();
        Self::of(source, rotor, &torques, start)
    }

    /// The same of torques that are switched on or off.
    fn of(source: SourceInfo, rotor: &Rotor, torques: &[(Acting, bool)], start: State) -> Self {
        let at_start = rotor.angular_momentum_space(&start).norm();
        // A body at rest is asked about 1 rad/s around its axis of greatest moment.
        let momentum = if at_start > 0.0 { at_start } else { rotor.principal().moments()[2] };
        let times = PermanentRotation::times(rotor);
        let is_always_driven = times.is_empty();
        let judged = |time: f64| {
            let acts = |(torque, is_on): &&(Acting, bool)| *is_on && torque.model.acts_at(time);
            let (acting, idle): (Vec<_>, Vec<_>) = torques.iter().partition(acts);
            let acting: Vec<&Acting> = acting.into_iter().map(|(torque, _)| torque).collect();
            Judged {
                time,
                rotations: PermanentRotation::all_at(rotor, momentum, time),
                oscillations: (!acting.is_empty()).then(|| search(rotor, &acting, State { time, ..start })),
                idle: idle.into_iter().map(|(torque, _)| torque.name.clone()).collect(),
            }
        };
        let always_on = torques.iter().filter(|(_, is_on)| *is_on).map(|(torque, _)| &torque.model);
        Self {
            source,
            findings: Vec::new(),
            rotor: rotor.clone(),
            momentum,
            is_of_start: at_start > 0.0,
            sink: sink(always_on),
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
fn sink<'a>(torques: impl Iterator<Item = &'a TorqueModel>) -> Option<EnergySink> {
    let coefficient = |torque: &TorqueModel| match torque {
        TorqueModel::EnergySink(sink) => sink.coefficient(),
        _ => 0.0,
    };
    EnergySink::new(torques.map(coefficient).sum()).ok()
}
