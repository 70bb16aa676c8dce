//! Reports of an identified body, as text and JSON.

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

/// Result of one kind of measurement, with its sources.
#[derive(Clone, Debug)]
pub struct Found<F, E> {
    title: String,
    /// Lines that describe the input.
    sources: Vec<String>,
    found: F,
    next: Option<NextExperiment<E>>,
}

/// Report of a body identified from tumbles.
pub type TumbleReport = Found<Tumble, NextFlight>;
/// Report of an identified payload.
pub type PayloadReport = Found<Payload, NextMotion>;
/// Report of a body identified from swings.
pub type SwingReport = Found<SwingEstimate, NextSwing>;

impl<F, E> Found<F, E> {
    /// Returns the estimate.
    pub const fn found(&self) -> &F {
        &self.found
    }

    /// Returns a section that describes the input.
    fn measured(&self) -> Section {
        let mut section = Section::new(1, "Data");
        self.sources.iter().for_each(|line| section.say(format!("{line}.")));
        section
    }
}

/// Report of an identified body, for any kind of measurement.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum IdentifyReport {
    /// Body identified from its free motion.
    Tumble(TumbleReport),
    /// Payload identified from wrenches at a wrist.
    Payload(PayloadReport),
    /// Body identified from its swings.
    Swing(SwingReport),
}

impl IdentifyReport {
    /// Identifies the body of a plan, and determines the most useful next experiment.
    ///
    /// # Errors
    /// [`IdentifyError`] if the measurements do not fit the motion of a body, or are too few.
    pub fn of(plan: &Plan) -> Result<Self, IdentifyError> {
        let (title, sources) = (plan.title.as_deref(), plan.sources());
        match &plan.measurement {
            Measurement::Tumble(plan) => Self::of_flights(title, sources, &plan.flights, &plan.options),
            Measurement::Payload(plan) => Self::of_payload(title, sources, &plan.log),
            Measurement::Swing(plan) => {
                let found = identify_swings(plan)?;
                let next = next_swing(plan, &found)?;
                let title = title.unwrap_or("Body from swing tests").to_owned();
                Ok(Self::Swing(Found { title, sources, found, next }))
            }
        }
    }

    /// Identifies a body from its flights, and determines the most useful next flight. `sources`
    /// describe the input.
    ///
    /// # Errors
    /// Same as [`identify_tumbles`].
    pub fn of_flights(
        title: Option<&str>,
        sources: Vec<String>,
        flights: &[Flight],
        options: &TumbleOptions,
    ) -> Result<Self, IdentifyError> {
        let found = identify_tumbles(flights, options)?;
        let next = next_flight(flights, options, &found)?;
        let title = title.unwrap_or("Body from free motion").to_owned();
        Ok(Self::Tumble(Found { title, sources, found, next }))
    }

    /// Identifies a payload from the wrenches of a log, and determines the most useful next motion.
    /// `sources` describe the input.
    ///
    /// # Errors
    /// Same as [`identify_payload`].
    pub fn of_payload(
        title: Option<&str>,
        sources: Vec<String>,
        log: &PayloadLog,
    ) -> Result<Self, IdentifyError> {
        let found = identify_payload(log)?;
        let next = next_motion(log, &found)?;
        let title = title.unwrap_or("Payload").to_owned();
        Ok(Self::Payload(Found { title, sources, found, next }))
    }

    /// Returns the body if all its mass properties are determined.
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

    /// Returns the report as JSON.
    pub fn to_json(&self) -> Value {
        self.of_kind().to_json()
    }

    /// Returns the report as a document, which can be printed as text, Markdown or HTML.
    pub fn to_document(&self) -> Document {
        self.of_kind().to_document()
    }

    /// Returns the body as part of a scenario file. For a tumble, `size` must give the mass, and
    /// the greatest moment if only ratios are determined.
    ///
    /// # Errors
    /// [`NoBody`] if the body is not completely determined, or if `size` gives an estimated value.
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

    /// Returns true if the residuals are larger than the noise or correlated: the model is
    /// incomplete.
    pub fn has_model_error(&self) -> bool {
        self.of_kind().has_failed()
    }
}
