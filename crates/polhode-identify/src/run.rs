//! Execution of a request.

use std::path::{Path, PathBuf};

use polhode_document::{Document, Report};
use polhode_source::files::Files;
use polhode_source::given::{Mass, Positive};
use polhode_source::{Failure, shown};
use serde_json::Value;

use crate::IdentifyError;
use crate::given_plan::{GivenPlan, parts};
use crate::read;
use crate::report::{BodySize, IdentifyReport};
use crate::request::Request;

/// Display name of a plan composed from options.
const OPTIONS: &str = "the options";

/// Estimates the body from the measurements of a request.
///
/// # Errors
/// [`Failure`] for files that cannot be read, measurements that do not fit a body, and a requested
/// body that is not determined.
pub fn run(request: &Request, files: &dyn Files) -> Result<Identified, Failure> {
    let plan = match request.plan()? {
        GivenPlan::File(plan) => read::read(files, &plan)?,
        GivenPlan::Text(text) => read::from_text(files, Path::new(OPTIONS), &text)?,
    };
    let place = request.files.first().map_or(Path::new(OPTIONS), PathBuf::as_path);
    let report = IdentifyReport::of(&plan).map_err(|error| refused(place, error))?;
    let body = || {
        let body = report.to_scenario(&size(request)?);
        body.map_err(|why| Failure::usage(why.to_string(), why.hint()).in_file(place))
    };
    let body = request.body.then(body).transpose()?;
    Ok(Identified { report, body, is_strict: request.strict })
}

/// JSON schema of the data of [`Identified`].
pub const REPORT_SCHEMA: &str = include_str!("../schema/report.json");

/// Result of a [`Request`].
#[derive(Clone, Debug)]
pub struct Identified {
    pub report: IdentifyReport,
    /// Body as part of a scenario file, if requested.
    pub body: Option<String>,
    /// True if residuals larger than the noise count as a failure (`--strict`).
    pub is_strict: bool,
}

impl Report for Identified {
    fn to_json(&self) -> Value {
        self.report.to_json()
    }

    fn to_document(&self) -> Document {
        self.report.to_document()
    }

    fn has_failed(&self) -> bool {
        self.is_strict && self.report.has_model_error()
    }
}

/// Returns the mass and greatest moment stated in the request.
fn size(request: &Request) -> Result<BodySize, Failure> {
    const HINT: &str = "for example --mass \"350 g\"";
    let mass = |text: &String| {
        let (value, sd) = parts("--mass", text)?;
        if sd.is_some() {
            let message = "--mass has a standard deviation, but a scenario stores only the value";
            return Err(Failure::usage(message, HINT));
        }
        let mass: Result<Positive<Mass>, String> = value.parse();
        mass.map(|mass| mass.0.0).map_err(|why| Failure::usage(format!("--mass: {why}"), HINT))
    };
    // Without a file, `--mass` is the mass of the swung body, and the report contains it.
    let given = request.mass.as_ref().filter(|_| !request.files.is_empty());
    let greatest_moment = request.greatest_moment.as_ref().map(|moment| moment.value.0.0);
    Ok(BodySize { mass: given.map(mass).transpose()?, greatest_moment })
}

fn refused(place: &Path, error: IdentifyError) -> Failure {
    let hint = error.hint().unwrap_or_default();
    match error {
        IdentifyError::Motion(error) => Failure::Motion { path: shown(place), error },
        error => Failure::usage(error.to_string(), hint).in_file(place),
    }
}
