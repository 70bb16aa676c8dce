//! Plans of `polhode identify` in TOML: measurements of a body.
//!
//! ```toml
//! title = "A racket, thrown"
//!
//! [tumble]                            # or [swing], or [payload]
//! log = "racket.csv"                  # times and rates of a gyro
//! flights = "find"                    # or [[tumble.flight]] with from and to
//! drag = "quadratic"
//! ```
//!
//! A quantity is a string with its unit, or a number in SI units. An unknown key and an impossible
//! or ambiguous value are errors with a place in the file.

mod effect;
mod gravity;
mod gyro_log;
mod number_log;
mod payload;
mod read_log;
mod swing;
mod tumble;
mod wrench_columns;
mod wrench_log;
mod wrench_quantity;

use std::path::Path;

use polhode_source::files::Files;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::toml::source::Source;
use polhode_source::toml::{document, root_names, text_of};
use polhode_source::{FormatError, FormatErrorKind};
use polhode_table::log::named_quantities;

use crate::IdentifyError;
use crate::swing::SwingPlan;

pub use payload::PayloadPlan;
pub use read_log::ReadLog;
pub use tumble::TumblePlan;

/// Plan of an identification: measurements, ready to be identified.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Title of the plan.
    pub title: Option<String>,
    /// Kind and data of the measurement.
    pub measurement: Measurement,
    /// Logs of swings; those of other kinds are part of `measurement`.
    pub logs: Vec<ReadLog>,
}

impl Plan {
    /// Returns a description of the logs, line by line.
    pub fn sources(&self) -> Vec<String> {
        let lines = |logs: &[ReadLog]| logs.iter().flat_map(ReadLog::lines).collect();
        match &self.measurement {
            Measurement::Tumble(plan) => {
                let mut all: Vec<String> = lines(&plan.logs);
                if plan.found {
                    all.push(
                        "Flights were found where the body rotates fast without an external torque"
                            .to_owned(),
                    );
                }
                all.extend(plan.cut_off.iter().cloned());
                all
            }
            Measurement::Payload(plan) => lines(std::slice::from_ref(&plan.source)),
            Measurement::Swing(_) => lines(&self.logs),
        }
    }
}

/// Measurement of a body.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
#[allow(clippy::large_enum_variant, reason = "there is one of each plan")]
pub enum Measurement {
    /// Free motion.
    Tumble(TumblePlan),
    /// Periods of swings.
    Swing(SwingPlan),
    /// Wrenches at a wrist, with its motion.
    Payload(PayloadPlan),
}

/// Tables for kinds of measurement; a plan has exactly one.
const KINDS: [&str; 3] = ["tumble", "swing", "payload"];

/// Returns true for the text of a plan. It need not be valid.
pub fn is_plan(text: &str) -> bool {
    root_names(text).any(|name| KINDS.contains(&name))
}

/// Returns true for the text of a log with times, and with angular velocities or attitudes.
pub fn is_log(text: &[u8]) -> bool {
    let found = named_quantities(text);
    found.omega || found.attitude
}

/// Reads a plan.
///
/// # Errors
/// [`FormatError`], with the place, if the plan or a named file cannot be read, or if the content
/// is invalid.
pub fn read(files: &dyn Files, path: &Path) -> Result<Plan, FormatError> {
    from_text(files, path, &text_of(files, path)?)
}

/// Reads a plan from its text. Logs are relative to the path, which errors name.
///
/// # Errors
/// Same as [`read()`].
pub fn from_text(files: &dyn Files, path: &Path, text: &str) -> Result<Plan, FormatError> {
    let source = Source::new(files, path, text);
    let entries = document(source)?;
    let root = Table::root(source, &entries);
    root.allow(&[&["title"], &KINDS[..]].concat())?;
    let title = root.get("title").map(|title| title.string().map(str::to_owned)).transpose()?;
    let kind = root.at_most_one(&KINDS, "a plan has one kind of measurement")?;
    let Some(kind) = kind else {
        return Err(root
            .missing("tumble", "[tumble], [swing] or [payload], such as [tumble] with log = \"gyro.csv\""));
    };
    let table = kind.table()?;
    let mut logs = Vec::new();
    let measurement = match kind.key() {
        "payload" => Measurement::Payload(payload::plan(&table)?),
        "swing" => Measurement::Swing(swing::plan(&table, &mut logs)?),
        _ => Measurement::Tumble(tumble::plan(&table)?),
    };
    Ok(Plan { title, measurement, logs })
}

/// Returns an identification error at the place of a value.
fn at(value: &Value<'_>, error: &IdentifyError) -> FormatError {
    value.error(FormatErrorKind::subject(error, error.hint()))
}
