//! Torques, powers and forces required for a prescribed motion.

use std::path::PathBuf;
use std::str::FromStr;
use std::sync::LazyLock;

use polhode::body::Particle;
use polhode::math::{Body, Position};
use polhode::motion::Scenario;
use polhode_document::{Document, Report};
use polhode_source::files::Files;
use polhode_source::given::{Given, Times, positive, quantity};
use polhode_source::unit::{self, Dimension};
use polhode_source::{Failure, shown};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::schema::complete;
use super::source;
use crate::read::ScenarioFile;
use crate::report::RequiredReport;

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../../schema/torque/request.json");

/// JSON schema of the JSON of a [`RequiredReport`].
pub static REPORT_SCHEMA: LazyLock<String> =
    LazyLock::new(|| complete(include_str!("../../schema/torque/report.json")));

/// Request for the torque required for the prescribed motion of a scenario.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_scenario::request::torque::{Request, run};
/// use polhode_source::files::Memory;
/// let text = "[[body.part]]\nshape = 'box'\nsize = [0.1, 0.2, 0.3]\nmass = 2\n\
///     [prescribed]\naxis = [1, 1, 0]\nrate = '3 rad/s'\n";
/// let request = Request { file: "box.toml".into(), at: vec!["0 s, 1 s".parse()?], ..Request::default() };
/// let needed = run(&request, &Memory::from([("box.toml", text)])).map_err(|error| error.to_string())?;
/// assert_eq!(needed.to_json()["at"].as_array().unwrap().len(), 2);
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// The scenario, a TOML file with [prescribed] or [shaft].
    pub file: PathBuf,
    /// Print the torque at these times too: in s, or each with its unit; 0:1:0.1 are those from 0 to 1 in
    /// steps of 0.1.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "T,…", allow_hyphen_values = true))]
    pub at: Vec<Given<Times>>,
    /// Print the force on a mass fixed to the body here too: mass, x, y, z in body axes, in SI or each with
    /// its unit.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "M,X,Y,Z", allow_hyphen_values = true))]
    pub point: Vec<Given<PointMass>>,
    /// Print the details too: ω, L and T at the largest torque, means in space axes, a shaft's rate.
    #[cfg_attr(feature = "arguments", arg(short, long))]
    pub verbose: bool,
}

/// Mass fixed to a body at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointMass(pub Particle<Body>);

/// Computes the torque required for the prescribed motion of a scenario.
///
/// # Errors
/// [`Failure`] if a file cannot be read, for a scenario without a prescribed motion, and for times
/// outside it.
pub fn run(request: &Request, files: &dyn Files) -> Result<RequiredReport, Failure> {
    let ScenarioFile { scenario, path, .. } = ScenarioFile::read(files, &request.file)?;
    require_motion(&scenario, &shown(&path))?;
    let at: Vec<f64> = request.at.iter().flat_map(|at| at.value.0.iter().copied()).collect();
    let points: Vec<_> = request.point.iter().map(|point| point.value.0).collect();
    RequiredReport::new(source(&path, &scenario), &scenario, &at, &points)
        .map(|report| report.verbose(request.verbose))
        .map_err(|error| Failure::of_motion(&path, error))
}

impl Report for RequiredReport {
    fn to_json(&self) -> Value {
        Self::to_json(self)
    }

    fn to_document(&self) -> Document {
        Document::of_text("Torque", &Self::to_text(self))
    }

    fn to_text(&self, _columns: Option<usize>) -> String {
        Self::to_text(self)
    }
}

/// Returns an error with advice if no motion is prescribed.
fn require_motion(scenario: &Scenario, path: &str) -> Result<(), Failure> {
    if scenario.prescribed().is_some() {
        return Ok(());
    }
    let hint = "write [prescribed] with axis = [0, 0, 1] and rate = \"3 rad/s\", or [shaft]";
    Err(if scenario.run().is_some() {
        let message =
            format!("{path} has a [run] but no [prescribed] motion: its motion is computed, not given");
        Failure::usage(
            message,
            format!(
                "`polhode simulate` computes it; for the torque of a given motion {hint}, in place of [start]"
            ),
        )
    } else {
        Failure::usage(
            format!("{path} has no [prescribed] motion, which is needed to compute a torque"),
            hint,
        )
    })
}

impl FromStr for PointMass {
    type Err = String;

    /// Reads `0.5 kg, 0, 10 cm, 0`.
    fn from_str(text: &str) -> Result<Self, String> {
        let parts: Vec<&str> = text.split(',').map(str::trim).collect();
        let [mass, place @ ..] = parts.as_slice() else {
            return Err("a mass and a place belong here".to_owned());
        };
        if place.len() != 3 {
            return Err(format!(
                "a mass and three coordinates belong here (m,x,y,z), not {} numbers",
                parts.len()
            ));
        }
        let mass = positive(quantity(mass, Dimension::MASS)?)?;
        if let Some((bare, with)) = unit::bare_beside_units(parts.iter().copied()) {
            return Err(format!(
                "{with:?} has a unit and {bare:?} has none (hint: give each its own, or none)"
            ));
        }
        let mut at = [0.0; 3];
        for (slot, text) in at.iter_mut().zip(place) {
            *slot = quantity(text, Dimension::LENGTH)?;
        }
        Particle::new(mass, Position::from_array(at)).map(Self).map_err(|error| error.to_string())
    }
}
