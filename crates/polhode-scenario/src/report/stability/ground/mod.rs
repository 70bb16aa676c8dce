//! Report of `polhode stability` for a body on the ground.

mod answer;
mod facts;
mod words;

use polhode::body::Finding;
use polhode::motion::contact::{ContactStart, Grip};
use polhode::motion::{GroundContact, MotionError, Scenario};
use polhode::observe::SteadyOnGround;
use polhode_document::SourceInfo;
use serde_json::Value;

use super::screen;

/// Stability of the steady motion nearest to the start of a scenario with a `[contact]`.
#[derive(Clone, Debug)]
pub struct GroundStabilityReport {
    /// Source of the body.
    pub source: SourceInfo,
    /// Findings about the scenario.
    pub findings: Vec<Finding>,
    steady: SteadyOnGround,
    /// True if dry friction holds the point of contact up to its limit.
    is_dry: bool,
    is_verbose: bool,
}

impl GroundStabilityReport {
    /// Creates the report of a scenario whose body is on this ground.
    ///
    /// # Errors
    /// The errors of [`SteadyOnGround::near`].
    pub fn of_scenario(
        source: SourceInfo,
        scenario: &Scenario,
        ground: &GroundContact,
    ) -> Result<Self, MotionError> {
        let start = ContactStart { state: scenario.start(), at: ground.at, velocity: ground.velocity };
        let steady = SteadyOnGround::near(scenario.body(), &ground.contact, &start)?;
        let is_dry = matches!(ground.contact.law.grip(), Grip::Friction(friction) if friction.sticking > 0.0);
        Ok(Self { source, findings: scenario.findings().to_vec(), steady, is_dry, is_verbose: false })
    }

    /// Adds details to the text: axes, rates that are zero, the geometry.
    #[must_use]
    pub fn verbose(self, is_verbose: bool) -> Self {
        Self { is_verbose, ..self }
    }

    /// Returns the text: the answer, then the facts.
    pub fn to_text(&self) -> String {
        screen(&self.source, &answer::lines(self), &facts::of(self), &self.findings, self.is_verbose)
    }

    /// Returns one object with the same keys for every scenario.
    pub fn to_json(&self) -> Value {
        facts::json(self)
    }

    /// Threshold of the spin that is nearest, rad/s.
    fn threshold(&self) -> Option<f64> {
        self.steady.stable_spins.as_ref().and_then(|spins| spins.nearest(self.steady.spin))
    }

    /// Spin relative to the threshold, less 1.
    fn margin(&self) -> Option<f64> {
        self.threshold().map(|threshold| self.steady.spin / threshold - 1.0)
    }

    fn slips_at_start(&self) -> bool {
        self.steady.slip_at_start > 1e-9 * self.steady.omega.norm()
    }
}
