//! Report of `polhode stability`: permanent rotations, and small oscillations about an equilibrium.

mod answer;
mod facts;
mod ground;
mod oscillations;
mod search;
mod words;

use polhode::body::Finding;
use polhode::motion::torque::{EnergySink, TorqueModel};
use polhode::motion::{MotionError, Rotor, Scenario, State};
use polhode::observe::PermanentRotation;
use polhode_document::fact::Facts;
use polhode_document::layout::{WIDTH, plain_spaces, wrap};
use polhode_document::{SourceInfo, finding};
use serde_json::Value;

use search::{Found, Prevented, search};

pub use ground::GroundStabilityReport;

/// Stability of the steady motions of a scenario's body.
///
/// ```
/// use polhode::prelude::*;
/// use polhode_document::SourceInfo;
/// use polhode_scenario::report::StabilityReport;
/// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
/// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 1.0, 0.0) };
/// let report = StabilityReport::new(SourceInfo::new("body.toml", "scenario"), &body, &[], start);
/// // Growth rate √((2 − 1)(3 − 2)/(1·3)) ω with ω = 1 rad/s, that of |L| = 2 along axis 2.
/// assert!(report.to_text().contains("about axis 2 unstable (e-folding time 1.732 s)"));
/// # Ok::<(), BodyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct StabilityReport {
    /// Source of the body.
    pub source: SourceInfo,
    /// Findings about the scenario.
    pub findings: Vec<Finding>,
    rotor: Rotor,
    /// |L| of the permanent rotations, kg·m²/s.
    momentum: f64,
    /// True if the momentum is that of the start.
    is_of_start: bool,
    /// Friction inside the body, as an energy sink.
    sink: Option<EnergySink>,
    /// Results at each time from which on the wheels keep their momentum, or else at the start.
    judged: Vec<Judged>,
    /// True if a motor never stops.
    is_always_driven: bool,
    is_verbose: bool,
}

/// Torque and its name.
#[derive(Clone, Debug)]
struct Acting {
    /// Name in the scenario, or else that of the model, with a number if several have this model.
    name: String,
    model: TorqueModel,
}

/// Stability of the steady motions while the wheels have their momentum at one time.
#[derive(Clone, Debug)]
struct Judged {
    /// Time, s.
    time: f64,
    rotations: Result<Vec<PermanentRotation>, MotionError>,
    /// True if a torque other than internal friction acts.
    is_driven: bool,
    /// Oscillations about the equilibrium, or the reasons why none was found; `None` if no torque
    /// acts.
    oscillations: Option<Result<Found, Box<Prevented>>>,
    /// Names of the torques that are off at this time.
    idle: Vec<String>,
}

impl StabilityReport {
    /// Creates the report of a scenario.
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

    /// Creates the report of a body, its torques and its start.
    pub fn new(source: SourceInfo, rotor: &Rotor, torques: &[TorqueModel], start: State) -> Self {
        let named = |model: &TorqueModel| Acting { name: model.name().to_owned(), model: model.clone() };
        let torques: Vec<_> = torques.iter().map(|model| (named(model), true)).collect();
        Self::of(source, rotor, &torques, start)
    }

    /// Adds details to the text: spins without the torques, attitudes, rates that are zero.
    #[must_use]
    pub fn verbose(self, is_verbose: bool) -> Self {
        Self { is_verbose, ..self }
    }

    /// Creates the report of a body with torques that are switched on or off.
    fn of(source: SourceInfo, rotor: &Rotor, torques: &[(Acting, bool)], start: State) -> Self {
        let at_start = rotor.angular_momentum_space(&start).norm();
        // For a body at rest, the momentum is that of 1 rad/s about its axis of greatest moment.
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
                is_driven: acting.iter().any(|torque| !matches!(torque.model, TorqueModel::EnergySink(_))),
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
            is_verbose: false,
        }
    }

    /// Returns the text: the answer, then the facts.
    pub fn to_text(&self) -> String {
        screen(&self.source, &answer::lines(self), &facts::of(self), &self.findings, self.is_verbose)
    }

    /// Returns one object with the same keys for every scenario.
    pub fn to_json(&self) -> Value {
        facts::json(self)
    }
}

/// Returns the text of a report.
fn screen(
    source: &SourceInfo,
    answer: &[String],
    facts: &[Facts],
    findings: &[Finding],
    is_verbose: bool,
) -> String {
    let mut lines = vec![source.heading()];
    lines.extend(answer.iter().flat_map(|line| wrap(line, "", WIDTH)));
    let mut text = lines.join("\n") + "\n\n";
    text.extend(facts.iter().map(|facts| facts.to_text(is_verbose)));
    plain_spaces(&(text + &finding::to_text(findings)))
}

/// Combines all internal friction to one sink.
fn sink<'a>(torques: impl Iterator<Item = &'a TorqueModel>) -> Option<EnergySink> {
    let coefficient = |torque: &TorqueModel| match torque {
        TorqueModel::EnergySink(sink) => sink.coefficient(),
        _ => 0.0,
    };
    EnergySink::new(torques.map(coefficient).sum()).ok()
}
