//! Requests to `identify`: the options of the command.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::path::PathBuf;

use polhode_source::given::{Given, Inertia, Positive};
use serde::{Deserialize, Serialize};

/// Heading of the options for counted swings.
#[cfg(feature = "arguments")]
const SWINGS: &str = "Swings about one axis (\"±\" or \"+-\" before a standard deviation)";
/// Heading of the options for logs of a gyro.
#[cfg(feature = "arguments")]
const GYRO: &str = "Logs of a gyro";

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../schema/request.json");

/// Measurements of a body's motion: a plan, logs of a gyro, or counted swings about one axis.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_identify::{Request, run};
/// use polhode_source::files::Memory;
/// let request = Request {
///     pendulum: true,
///     mass: Some("742 g".to_owned()),
///     distance: Some("8.2 cm ± 0.5 mm".to_owned()),
///     swings: Some("50".to_owned()),
///     time: Some("41.2 s ± 0.1 s".to_owned()),
///     amplitude: Some("8 deg ± 1 deg".to_owned()),
///     ..Request::default()
/// };
/// let found = run(&request, &Memory::default())?;
/// let moment = found.to_json()["tests"][0]["moment"]["value"].as_f64().unwrap();
/// assert!((moment - 5.26e-3).abs() < 1e-4); // kg m²
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
#[allow(clippy::struct_excessive_bools, reason = "each is an option of the command")]
pub struct Request {
    /// Plan file, or gyro logs: CSV, Parquet or JSON lines.
    #[cfg_attr(feature = "arguments", arg(value_name = "FILE"))]
    pub files: Vec<PathBuf>,
    /// Columns of the log, with quantity and unit: "time ms = t, omega deg/s = gx gy gz".
    #[cfg_attr(feature = "arguments", arg(long, value_name = "COLUMNS", help_heading = GYRO))]
    pub columns: Option<String>,
    /// Treat the whole log as one flight; the default finds the flights in it.
    #[cfg_attr(feature = "arguments", arg(long, help_heading = GYRO))]
    pub whole: bool,
    /// Estimate the air drag too: "linear" or "quadratic".
    #[cfg_attr(feature = "arguments", arg(long, value_name = "LAW", help_heading = GYRO))]
    pub drag: Option<String>,
    /// Bifilar suspension: two parallel wires of equal length, the centre of mass midway between
    /// them; moment about the vertical.
    #[cfg_attr(feature = "arguments", arg(long, help_heading = SWINGS))]
    pub bifilar: bool,
    /// Trifilar suspension: three parallel wires of equal length, the centre of mass in the middle;
    /// moment about the vertical.
    #[cfg_attr(feature = "arguments", arg(long, help_heading = SWINGS))]
    pub trifilar: bool,
    /// Compound pendulum: the body swings about a level axis; moment about the parallel axis
    /// through its centre of mass.
    #[cfg_attr(feature = "arguments", arg(long, help_heading = SWINGS))]
    pub pendulum: bool,
    /// Mass of the body; with --body, mass of the thrown body.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "MASS", help_heading = SWINGS))]
    pub mass: Option<String>,
    /// Distance between wires (--bifilar, --trifilar), or from the axis to the centre of mass
    /// (--pendulum).
    #[cfg_attr(feature = "arguments", arg(long, value_name = "LENGTH", help_heading = SWINGS))]
    pub distance: Option<String>,
    /// Length of the wires.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "LENGTH", help_heading = SWINGS))]
    pub length: Option<String>,
    /// Number of whole periods counted.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "COUNT", help_heading = SWINGS))]
    pub swings: Option<String>,
    /// Total time of the periods, with its standard deviation: "31.4 s ± 0.1 s".
    #[cfg_attr(feature = "arguments", arg(long, value_name = "TIME", help_heading = SWINGS))]
    pub time: Option<String>,
    /// Amplitude at the middle of the time, "10 deg ± 1 deg"; or at its beginning and end, "12 deg,
    /// 9 deg ± 1 deg".
    #[cfg_attr(feature = "arguments", arg(long, value_name = "ANGLES", help_heading = SWINGS))]
    pub amplitude: Option<String>,
    /// Gravity, if not 9.80665 m/s^2.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "ACCELERATION", help_heading = SWINGS))]
    pub gravity: Option<String>,
    /// Print the body as part of a scenario file; for a tumble, also its first flight. Options must
    /// state values that free motion does not determine.
    #[cfg_attr(feature = "arguments", arg(long, group = "form"))]
    pub body: bool,
    // `requires` alone would accept the other output forms.
    /// Greatest principal moment, for --body when tumbles determine only ratios.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "MOMENT", requires = "body", conflicts_with_all = ["json", "markdown", "html"]))]
    pub greatest_moment: Option<Given<Positive<Inertia>>>,
    /// Exit with status 1 if the residuals are larger than the noise or correlated.
    #[cfg_attr(feature = "arguments", arg(long))]
    pub strict: bool,
}
