//! What was found of a body by measuring it, for people and for programs.

mod estimate;
mod mistakes;
mod motion;
mod next;
mod payload;
mod picture;
mod scenario;
mod swing;
mod tumble;

use polhode::body::MassProperties;
use polhode::math::Body;
use polhode_document::{Document, Report, Section};
use serde_json::Value;

use crate::payload::{NextMotion, Payload, PayloadLog, identify_payload, next_motion};
use crate::read::{Measurement, Plan};
use crate::swing::{NextSwing, SwingEstimate, identify_swings, next_swing};
use crate::tumble::{Flight, NextFlight, Tumble, TumbleOptions, identify_tumbles, next_flight};
use crate::{IdentifyError, NextExperiment};

pub use scenario::{BodySize, NoBody};

/// A body that was found by one kind of measurement, with what it was found from.
#[derive(Clone, Debug)]
pub struct Found<F, E> {
    title: String,
    /// Lines that say what was read.
    sources: Vec<String>,
    found: F,
    next: Option<NextExperiment<E>>,
}

/// A body that was found by its tumbles.
pub type TumbleReport = Found<Tumble, NextFlight>;
/// A payload that was found.
pub type PayloadReport = Found<Payload, NextMotion>;
/// A body that was found by its swings.
pub type SwingReport = Found<SwingEstimate, NextSwing>;

impl<F, E> Found<F, E> {
    /// Returns the estimate.
    pub const fn found(&self) -> &F {
        &self.found
    }

    /// A section with what was read.
    fn measured(&self) -> Section {
        let mut section = Section::new(1, "What was measured");
        self.sources.iter().for_each(|line| section.say(format!("{line}.")));
        section
    }
}

/// What was found of a body, whatever was measured.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum IdentifyReport {
    /// By its free motion.
    Tumble(TumbleReport),
    /// By wrenches at a wrist that carries it.
    Payload(PayloadReport),
    /// By its swings.
    Swing(SwingReport),
}

impl IdentifyReport {
    /// Identifies the body that a plan measures, and says which further experiment would help most.
    ///
    /// # Errors
    /// [`IdentifyError`] if the measurements are no body's motion, or too few.
    pub fn of(plan: &Plan) -> Result<Self, IdentifyError> {
        let (title, sources) = (plan.title.as_deref(), plan.sources());
        match &plan.measurement {
            Measurement::Tumble(plan) => Self::of_flights(title, sources, &plan.flights, &plan.options),
            Measurement::Payload(plan) => Self::of_payload(title, sources, &plan.log),
            Measurement::Swing(plan) => {
                let found = identify_swings(plan)?;
                let next = next_swing(plan, &found)?;
                let title = title.unwrap_or("a body that swings").to_owned();
                Ok(Self::Swing(Found { title, sources, found, next }))
            }
        }
    }

    /// Identifies a body by its flights, and says which further one would help most; `sources` say what was read.
    ///
    /// # Errors
    /// As [`identify_tumbles`].
    pub fn of_flights(
        title: Option<&str>,
        sources: Vec<String>,
        flights: &[Flight],
        options: &TumbleOptions,
    ) -> Result<Self, IdentifyError> {
        let found = identify_tumbles(flights, options)?;
        let next = next_flight(flights, options, &found)?;
        let title = title.unwrap_or("a tumbling body").to_owned();
        Ok(Self::Tumble(Found { title, sources, found, next }))
    }

    /// Identifies a payload by the wrenches of a log, and says which further motion would help most.
    ///
    /// # Errors
    /// As [`identify_payload`].
    pub fn of_payload(
        title: Option<&str>,
        sources: Vec<String>,
        log: &PayloadLog,
    ) -> Result<Self, IdentifyError> {
        let found = identify_payload(log)?;
        let next = next_motion(log, &found)?;
        let title = title.unwrap_or("a payload").to_owned();
        Ok(Self::Payload(Found { title, sources, found, next }))
    }

    /// The body, where all of it is known.
    pub fn body(&self) -> Option<MassProperties<Body>> {
        match self {
            Self::Tumble(_) => None,
            Self::Payload(report) => report.found().body,
            Self::Swing(report) => report.known(),
        }
    }

    fn of_kind(&self) -> &dyn Report {
        match self {
            Self::Tumble(report) => report,
            Self::Payload(report) => report,
            Self::Swing(report) => report,
        }
    }

    /// The report as data.
    pub fn to_json(&self) -> Value {
        self.of_kind().to_json()
    }

    /// The report as a document: text, Markdown, a page.
    pub fn to_document(&self) -> Document {
        self.of_kind().to_document()
    }

    /// The body as a part of a scenario file. Of a tumble that shows only ratios its size and its mass have to be said.
    ///
    /// # Errors
    /// If not all of it is known, or what was found is said as well.
    pub fn to_scenario(&self, size: &BodySize) -> Result<String, NoBody> {
        match self {
            Self::Tumble(report) => report.to_scenario(size),
            Self::Payload(_) | Self::Swing(_) if size.mass.is_some() => Err(NoBody::Found { what: "mass" }),
            Self::Payload(_) | Self::Swing(_) if size.greatest_moment.is_some() => {
                Err(NoBody::Found { what: "greatest-moment" })
            }
            Self::Payload(report) => report.to_scenario(),
            Self::Swing(report) => report.to_scenario(),
        }
    }

    /// True if what is left is more than noise: the model is not all that moves the body.
    pub fn has_model_error(&self) -> bool {
        self.of_kind().has_failed()
    }
}
