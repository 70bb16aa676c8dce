//! Steady motions and their stability.

use std::path::PathBuf;
use std::sync::LazyLock;

use polhode::motion::Mechanism;
use polhode_document::{Document, Report};
use polhode_source::files::Files;
use polhode_source::{Failure, shown};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::schema::complete;
use super::source;
use crate::read::ScenarioFile;
use crate::report::{GroundStabilityReport, StabilityReport};

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../../schema/stability/request.json");

/// JSON schema of the JSON of a [`Stability`].
pub static REPORT_SCHEMA: LazyLock<String> =
    LazyLock::new(|| complete(include_str!("../../schema/stability/report.json")));

/// Request for the stability of a scenario's steady motions.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_scenario::request::stability::{Request, run};
/// use polhode_source::files::Memory;
/// let text = "[[body.part]]\nshape = 'box'\nsize = [0.1, 0.2, 0.3]\nmass = 2\n[start]\nspin = { body = [0.1, 3, 0] }\n";
/// let request = Request { file: "box.toml".into(), ..Request::default() };
/// let report = run(&request, &Memory::from([("box.toml", text)]))?;
/// assert_eq!(report.to_json()["permanent_rotations"].as_array().unwrap().len(), 6);
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// The scenario, a TOML file.
    pub file: PathBuf,
    /// Print the details too: spins without the torques, attitudes and axes, rates that are zero.
    #[cfg_attr(feature = "arguments", arg(short, long))]
    pub verbose: bool,
}

/// Finds the steady motions of a scenario's body and their stability.
///
/// # Errors
/// [`Failure`] if the file cannot be read, or [its motion](Stability::of_scenario) has no steady
/// motions.
pub fn run(request: &Request, files: &dyn Files) -> Result<Stability, Failure> {
    let file = ScenarioFile::read(files, &request.file)?;
    Ok(Stability::of_scenario(&file)?.verbose(request.verbose))
}

/// Stability of the steady motions of a body.
#[derive(Clone, Debug)]
pub enum Stability {
    /// Body without contact: permanent rotations and small oscillations.
    Free(Box<StabilityReport>),
    /// Body on the ground: the steady motion closest to the start.
    OnGround(Box<GroundStabilityReport>),
}

impl Stability {
    /// Finds the steady motions of a scenario's body and their stability.
    ///
    /// # Errors
    /// [`Failure`] for prescribed motions, changing bodies, and gimbals.
    pub fn of_scenario(ScenarioFile { scenario, path, .. }: &ScenarioFile) -> Result<Self, Failure> {
        let name = shown(path);
        if scenario.prescribed().is_some() {
            return Err(Failure::usage(
                format!("the motion of {name} is prescribed, so its stability is not defined"),
                "delete [prescribed], or use `polhode explain` for the torque that the motion requires",
            ));
        }
        if scenario.history().is_some() {
            return Err(Failure::usage(
                format!("the mass properties of {name} change, so steady motions are not defined"),
                "`polhode simulate` computes its motion; delete [mass_history] for the body at the start",
            ));
        }
        if matches!(scenario.mechanism(), Mechanism::Gimbals(_)) {
            return Err(Failure::usage(
                format!("the body of {name} is in gimbals, whose steady motions are not computed"),
                "`polhode simulate` computes its motion: start close to the steady one",
            ));
        }
        let source = source(path, scenario);
        Ok(match scenario.ground() {
            Some(ground) => {
                let report = GroundStabilityReport::of_scenario(source, scenario, ground);
                Self::OnGround(Box::new(report.map_err(|error| Failure::of_motion(path, error))?))
            }
            None => Self::Free(Box::new(StabilityReport::of_scenario(source, scenario))),
        })
    }

    /// Returns the report with or without details in its text.
    #[must_use]
    pub fn verbose(self, verbose: bool) -> Self {
        match self {
            Self::Free(report) => Self::Free(Box::new(report.verbose(verbose))),
            Self::OnGround(report) => Self::OnGround(Box::new(report.verbose(verbose))),
        }
    }
}

impl Report for Stability {
    fn to_json(&self) -> Value {
        match self {
            Self::Free(report) => report.to_json(),
            Self::OnGround(report) => report.to_json(),
        }
    }

    fn to_document(&self) -> Document {
        Document::of_text("Stability", &self.to_text(None))
    }

    fn to_text(&self, _columns: Option<usize>) -> String {
        match self {
            Self::Free(report) => report.to_text(),
            Self::OnGround(report) => report.to_text(),
        }
    }
}
