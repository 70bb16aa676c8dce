//! The report of `polhode simulate`: how a body moves, and how good the numbers are.

mod facts;
mod summary;
mod text;
mod underflow;

use polhode::body::Finding;
use polhode::motion::{Sample, Scenario, Trajectory};
use polhode_document::SourceInfo;
use polhode_document::sparkline;
use serde_json::Value;

/// A motion, ready to be read.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::Run;
/// use polhode_document::SourceInfo;
/// use polhode_report::MotionReport;
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
    /// Where the scenario came from.
    pub source: SourceInfo,
    scenario: &'a Scenario,
    trajectory: &'a Trajectory,
    at: &'a [Sample],
}

impl<'a> MotionReport<'a> {
    /// The report of a scenario's motion; `trajectory` is what [`Scenario::simulate`] found.
    pub const fn new(source: SourceInfo, scenario: &'a Scenario, trajectory: &'a Trajectory) -> Self {
        Self { source, scenario, trajectory, at: &[] }
    }

    /// With states at times of their own, which were asked for.
    #[must_use]
    pub fn at(self, samples: &'a [Sample]) -> Self {
        Self { at: samples, ..self }
    }

    /// One screen for people.
    pub fn to_text(&self) -> String {
        text::write(self, sparkline::COLUMNS)
    }

    /// The same for a terminal of so many columns: the picture of ω is as wide as that allows.
    pub fn to_screen(&self, columns: usize) -> String {
        text::write(self, sparkline::fitting(columns))
    }

    /// What was noticed about the scenario and its motion.
    pub fn findings(&self) -> Vec<Finding> {
        findings(self.scenario, self.trajectory)
    }

    /// The content of `summary.json`: the body, the start, the run, the kind of motion, its error, its end.
    pub fn summary_json(&self) -> Value {
        summary::of(self)
    }
}

/// What was noticed about a scenario, its motion, and the error of that.
pub(crate) fn findings(scenario: &Scenario, trajectory: &Trajectory) -> Vec<Finding> {
    let of_motion = underflow::finding(scenario, trajectory).into_iter().chain(trajectory.findings());
    scenario.findings().iter().cloned().chain(of_motion).collect()
}
