//! Report of `polhode simulate`: the motion of a body, and the accuracy of the numbers.

mod text;
mod underflow;

use polhode::body::Finding;
use polhode::motion::{Sample, Scenario, Trajectory};
use polhode_document::fact::{self, Fact, Facts};
use polhode_document::{SourceInfo, finding, sparkline};
use polhode_shape::report::block::{self, Geometry};
use serde_json::{Map, Value};

use crate::report::VERSION;
use crate::report::facts::{self, Known, state_at};

/// Keys of `summary.json` after those of the body; `null` where a motion has no value.
const KEYS: [&str; 23] = [
    "complete",
    "end",
    "turns_about",
    "orbit",
    "start",
    "run",
    "motion",
    "energy",
    "drift",
    "error",
    "required",
    "pendulum",
    "heavy_top",
    "final",
    "pointings",
    "at",
    "torques",
    "wheels",
    "mass_history",
    "contact",
    "gimbals",
    "events",
    "findings",
];

/// Report on the motion of a scenario.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::Run;
/// use polhode_document::SourceInfo;
/// use polhode_scenario::report::MotionReport;
/// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
/// let omega = AngularVelocity::new(0.01, 1.0, 0.01);
/// let scenario = Scenario::new(MassProperties::new(1.0, Position::ZERO, inertia)?)
///     .titled("A tumbling book")
///     .starting(State { time: 0.0, attitude: Attitude::identity(), omega })?
///     .sampled(Run::evenly(40.0, 401, Method::Auto, 1e-12));
/// let Some(trajectory) = scenario.simulate().transpose()? else { return Ok(()) };
/// let report = MotionReport::new(SourceInfo::new("book.toml", "scenario"), &scenario, &trajectory);
/// assert!(report.to_text().contains("short-axis mode"));
/// assert_eq!(report.summary_json()["motion"]["regime"], "short_axis");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct MotionReport<'a> {
    /// Source of the scenario.
    pub source: SourceInfo,
    scenario: &'a Scenario,
    trajectory: &'a Trajectory,
    at: &'a [Sample],
    is_verbose: bool,
}

impl<'a> MotionReport<'a> {
    /// Returns the report of a scenario's motion; `trajectory` is the result of
    /// [`Scenario::simulate`].
    pub const fn new(source: SourceInfo, scenario: &'a Scenario, trajectory: &'a Trajectory) -> Self {
        Self { source, scenario, trajectory, at: &[], is_verbose: false }
    }

    /// Adds the states at the requested times.
    #[must_use]
    pub fn at(self, samples: &'a [Sample]) -> Self {
        Self { at: samples, ..self }
    }

    /// Adds to the text the method of computation and other details of occasional interest.
    #[must_use]
    pub fn verbose(self, is_verbose: bool) -> Self {
        Self { is_verbose, ..self }
    }

    /// Returns the text of the report, at most one screen.
    pub fn to_text(&self) -> String {
        text::write(self, sparkline::COLUMNS)
    }

    /// Returns the text for a terminal of `columns` columns; the picture of ω fills the width.
    pub fn to_screen(&self, columns: usize) -> String {
        text::write(self, sparkline::fitting(columns))
    }

    /// Returns the findings about the scenario and its motion.
    pub fn findings(&self) -> Vec<Finding> {
        findings(self.scenario, self.trajectory)
    }

    /// Returns the content of `summary.json`: body, start, run, kind of motion, error, and end.
    pub fn summary_json(&self) -> Value {
        let known = Known::of(self.scenario, self.trajectory);
        let mut sections = facts::of(&known);
        let at = |sample| fact::object(&[], &[Facts::new("", state_at(&known, sample))]).remove("at");
        let at = self.at.iter().map(at).collect::<Option<Value>>();
        let findings = finding::to_json(&self.findings());
        sections.push(Facts::new(
            "",
            vec![Fact::data("at", at.unwrap_or_default()), Fact::data("findings", findings)],
        ));
        let mut object = Map::new();
        object.insert("polhode".to_owned(), VERSION.into());
        object.insert("title".to_owned(), self.scenario.title().into());
        object.insert("source".to_owned(), self.source.to_json());
        let body = self.scenario.body();
        block::insert(&mut object, body, Geometry::of_parts(self.scenario.parts(), body.mass()));
        object.extend(fact::object(&KEYS, &sections));
        Value::Object(object)
    }
}

/// Returns the findings about a scenario, its motion, and the error of the motion.
pub(crate) fn findings(scenario: &Scenario, trajectory: &Trajectory) -> Vec<Finding> {
    let of_motion = underflow::finding(scenario, trajectory).into_iter().chain(trajectory.findings());
    scenario.findings().iter().cloned().chain(of_motion).collect()
}
