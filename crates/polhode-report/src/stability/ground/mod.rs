//! The report of `polhode stability` on a body on the ground.

mod summary;
mod text;

use polhode::body::Finding;
use polhode::motion::contact::{ContactStart, Grip};
use polhode::motion::{GroundContact, MotionError, Scenario};
use polhode::observe::SteadyOnGround;
use polhode_document::SourceInfo;
use serde_json::Value;

/// Which steady motion the start of a scenario with a `[contact]` is near to, and whether that lasts.
#[derive(Clone, Debug)]
pub struct GroundStabilityReport {
    /// Where the body came from.
    pub source: SourceInfo,
    /// What was noticed on the way.
    pub findings: Vec<Finding>,
    steady: SteadyOnGround,
    /// True if dry friction holds the point of contact as long as it can.
    is_dry: bool,
}

impl GroundStabilityReport {
    /// The report of a scenario whose body is so on the ground.
    ///
    /// # Errors
    /// As [`SteadyOnGround::near`].
    pub fn of_scenario(
        source: SourceInfo,
        scenario: &Scenario,
        ground: &GroundContact,
    ) -> Result<Self, MotionError> {
        let start = ContactStart { state: scenario.start(), at: ground.at, velocity: ground.velocity };
        let steady = SteadyOnGround::near(scenario.body(), &ground.contact, &start)?;
        let is_dry = matches!(ground.contact.law.grip(), Grip::Friction(friction) if friction.sticking > 0.0);
        Ok(Self { source, findings: scenario.findings().to_vec(), steady, is_dry })
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
