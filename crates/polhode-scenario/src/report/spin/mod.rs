//! The report of `polhode spin`: a free motion at once, and at any time.

mod body;
mod facts;
mod states;
mod text;
mod tumbler;

use polhode::body::Finding;
use polhode::motion::{FreeMotion, MotionError};
use polhode_document::{SourceInfo, fact, sparkline};
use serde_json::Value;

use crate::report::free_facts::FreeFacts;
use states::Printed;

pub use tumbler::TumblerReport;

/// A free motion, ready to be read.
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, State};
/// use polhode_scenario::report::SpinReport;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.01) };
/// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
/// let report = SpinReport::new(None, motion).at(&[10.0, -3.5e9])?;
/// assert!(report.to_text().contains("Flips every 19.55 s: ω starts 0.81° from"));
/// assert_eq!(report.to_json()["motion"]["states"][0]["omega_body"][1], motion.at(10.0).omega.y);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SpinReport {
    /// Source of the body; `None` if its moments were given.
    pub source: Option<SourceInfo>,
    /// Findings about the body and its start.
    pub findings: Vec<Finding>,
    motion: FreeMotion,
    states: Vec<Printed>,
    is_verbose: bool,
}

impl SpinReport {
    /// Returns the report of a free motion.
    pub const fn new(source: Option<SourceInfo>, motion: FreeMotion) -> Self {
        Self { source, findings: Vec::new(), motion, states: Vec::new(), is_verbose: false }
    }

    /// Replaces the findings.
    #[must_use]
    pub fn found(self, findings: Vec<Finding>) -> Self {
        Self { findings, ..self }
    }

    /// Adds the states at these times, in their order.
    ///
    /// q and −q are the same attitude. The first has w ≥ 0; each later one has the sign nearest to
    /// the previous one.
    ///
    /// # Errors
    /// [`MotionError::BeyondReach`] for a time too far away, [`MotionError::NotFinite`] for a state
    /// that is not finite.
    pub fn at(mut self, times: &[f64]) -> Result<Self, MotionError> {
        self.motion.require(times)?;
        let estimate = self.motion.global_error(times);
        let errors = estimate.computation().iter().zip(estimate.inputs());
        for (&time, (&computation, &inputs)) in times.iter().zip(errors) {
            let state = self.motion.at(time);
            if !(state.omega.is_finite() && state.attitude.quaternion().iter().all(|c| c.is_finite())) {
                return Err(MotionError::NotFinite { time });
            }
            self.states.push(Printed::new(&state, [computation, inputs], self.states.last()));
        }
        Ok(self)
    }

    /// Adds to the text the other convention of the periods and Poinsot's picture.
    #[must_use]
    pub fn verbose(self, is_verbose: bool) -> Self {
        Self { is_verbose, ..self }
    }

    /// Returns the text of the report, at most one screen, and a line for each requested time.
    pub fn to_text(&self) -> String {
        text::write(self, None)
    }

    /// Returns the text for a terminal of `columns` columns; the picture of ω fills the width.
    pub fn to_screen(&self, columns: usize) -> String {
        text::write(self, Some(sparkline::fitting(columns)))
    }

    /// Returns the JSON object, with the same keys for every motion; `null` where a motion has no
    /// value.
    pub fn to_json(&self) -> Value {
        Value::Object(fact::object(&facts::KEYS, &facts::of(self, &FreeFacts::of(self.motion))))
    }
}
