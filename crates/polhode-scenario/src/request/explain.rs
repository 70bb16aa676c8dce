//! Worked solutions.

use std::path::PathBuf;
use std::sync::LazyLock;

use polhode_document::{Document, Report};
use polhode_source::Failure;
use polhode_source::files::Files;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::failed;
use super::schema::complete;
use crate::read::ScenarioFile;
use crate::report::{self, Formalism, LagrangianError};

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../../schema/explain/request.json");

/// JSON schema of the JSON of a [`Solution`].
pub static REPORT_SCHEMA: LazyLock<String> =
    LazyLock::new(|| complete(include_str!("../../schema/explain/report.json")));

/// Request for a worked solution of a scenario.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_scenario::request::explain::{Request, run};
/// use polhode_source::files::Memory;
/// let text = "[[body.part]]\nshape = 'box'\nsize = [0.1, 0.2, 0.3]\nmass = 2\n[start]\nspin = { body = [0.1, 3, 0] }\n";
/// let request = Request { file: "box.toml".into(), ..Request::default() };
/// let solution = run(&request, &Memory::from([("box.toml", text)]))?;
/// assert!(solution.to_document().sections.iter().any(|section| section.title.contains("Euler")));
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// The scenario, a TOML file.
    #[cfg_attr(feature = "arguments", arg(required = false, required_unless_present = "derive"))]
    pub file: PathBuf,
    /// Solve by Lagrange's equations: T, U, momenta, equations of motion, conserved quantities, small
    /// oscillations.
    #[cfg_attr(feature = "arguments", arg(long, conflicts_with = "hamiltonian"))]
    pub lagrangian: bool,
    /// Solve by Hamilton's canonical equations.
    #[cfg_attr(feature = "arguments", arg(long))]
    pub hamiltonian: bool,
}

/// Returns the worked solution of a scenario, step by step.
///
/// # Errors
/// [`Failure`] if a file cannot be read or the motion cannot be computed; also if a Lagrangian or
/// Hamiltonian is requested, and none is known for the scenario.
pub fn run(request: &Request, files: &dyn Files) -> Result<Solution, Failure> {
    let file = ScenarioFile::read(files, &request.file)?;
    let formalism = match (request.lagrangian, request.hamiltonian) {
        (false, false) => {
            let document = report::explain_exactly(&file.scenario, &file.exact());
            return document.map(Solution).map_err(|error| failed(&file, error));
        }
        (true, false) => Formalism::Lagrange,
        (false, true) => Formalism::Hamilton,
        (true, true) => {
            return Err(Failure::usage(
                "a Lagrangian and a Hamiltonian are requested together",
                "request one of them",
            ));
        }
    };
    report::lagrangian(&file.scenario, formalism, &file.exact()).map(Solution).map_err(|error| match error {
        LagrangianError::Motion(error) => failed(&file, error),
        error => Failure::usage(error.to_string(), error.hint()).in_file(&file.path),
    })
}

/// Worked solution of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution(pub Document);

impl Report for Solution {
    fn to_json(&self) -> Value {
        self.0.to_json()
    }

    fn to_document(&self) -> Document {
        self.0.clone()
    }
}
