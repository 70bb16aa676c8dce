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
    /// Where the body came from; `None` if its moments were given.
    pub source: Option<SourceInfo>,
    /// What was noticed on the way.
    pub findings: Vec<Finding>,
    motion: FreeMotion,
    states: Vec<Printed>,
    is_verbose: bool,
}

impl SpinReport {
    /// The report of a free motion.
    pub const fn new(source: Option<SourceInfo>, motion: FreeMotion) -> Self {
        Self { source, findings: Vec::new(), motion, states: Vec::new(), is_verbose: false }
    }

    /// The same with what was noticed on the way.
    #[must_use]
    pub fn found(self, findings: Vec<Finding>) -> Self {
        Self { findings, ..self }
    }

    /// The same with the states at some times, in their order.
    ///
    /// q and −q are one attitude: the first has w ≥ 0, and each of the others the sign nearest to the one
    /// before it.
    ///
    /// # Errors
    /// [`MotionError::BeyondReach`] for a time too far away, [`MotionError::NotFinite`] for a state that is
    /// not a number.
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

    /// One screen for people, and a line for each requested time.
    pub fn to_text(&self) -> String {
        text::write(self, None)
    }

    /// The same for a terminal of so many columns, with a picture of ω as wide as that allows.
    pub fn to_screen(&self, columns: usize) -> String {
        text::write(self, Some(sparkline::fitting(columns)))
    }

    /// One object with the same keys for every motion, `null` where a motion does not have one.
    pub fn to_json(&self) -> Value {
        Value::Object(fact::object(&facts::KEYS, &facts::of(self, &FreeFacts::of(self.motion))))
    }
}
