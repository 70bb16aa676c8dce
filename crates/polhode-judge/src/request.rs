//! Requests to `judge`: the options of the command.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::path::PathBuf;
use std::str::FromStr;

use polhode::infer::judge::{AttitudeSense, DeclaredReading, OmegaAxes, QuaternionOrder, SignedAxes};
use polhode_scenario::request::spin::{Moments, Omega};
use polhode_source::given::{Angle, Given, Positive, Time};
use polhode_table::log::Columns;
use serde::{Deserialize, Serialize};

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../schema/request.json");

/// Logs of other programs to be judged, and the interpretation options.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_judge::{Request, run};
/// use polhode_source::files::Memory;
/// let scenario = "[[body.part]]\nshape = \"box\"\nsize = [0.1, 0.2, 0.3]\nmass = 2\n\
///     [start]\nspin = { body = [0, 3, 0] }\n[run]\nduration = 1\n";
/// let rows: String = (0..=100)
///     .map(|k| (0.01 * f64::from(k), 0.015 * f64::from(k)))
///     .map(|(t, half)| format!("{t},{},0,{},0\n", half.cos(), half.sin()))
///     .collect();
/// let files = Memory::from([("box.toml", scenario.to_owned()), ("run.csv", format!("time,qw,qx,qy,qz\n{rows}"))]);
/// let request = Request { files: vec!["box.toml".into(), "run.csv".into()], ..Request::default() };
/// let report = run(&request, &files)?;
/// assert!(!report.has_failed());
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// Scenario (a TOML file) and its runs; the runs alone if they name their scenario, or with
    /// --moments or --against.
    #[cfg_attr(feature = "arguments", arg(value_name = "SCENARIO|RUN", required_unless_present_any = ["suite", "write_suite"]))]
    pub files: Vec<PathBuf>,
    /// Principal moments of inertia about the body axes x, y, z of the run: in kg·m², or each with
    /// its unit. They replace the scenario: a free body that starts with the attitude and ω of the
    /// first row. The first of several runs gives the start.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "A,B,C", allow_hyphen_values = true))]
    pub moments: Option<Given<Moments>>,
    /// ω at the first row along body axes, with --moments: in rad/s, or "(0, 0, 30) deg/s"
    /// [default: ω of the first row; required if the run has no ω].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true))]
    pub start_omega: Option<Given<Omega>>,
    /// Another log of the same motion: the runs are compared with it row by row, not with an exact
    /// motion. It needs a row at each of their times. --moments adds T and L.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "LOG"))]
    pub against: Option<PathBuf>,
    /// Interpretation of a run's numbers.
    #[serde(flatten)]
    #[cfg_attr(feature = "arguments", command(flatten))]
    pub read_as: ReadAs,
    /// Time step of the program, s or with its unit [default: that in the run, else the spacing of
    /// its rows].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "T"))]
    pub step: Option<Given<Positive<Time>>>,
    /// Additional folder in which logs may open their scenario and its files, besides the log's own
    /// folder.
    #[serde(rename = "root")]
    #[cfg_attr(feature = "arguments", arg(long = "root", value_name = "DIR"))]
    pub roots: Vec<PathBuf>,
    /// Largest acceptable error of an attitude, rad or with its unit, and of ω relative to its
    /// largest value. Above it the exit status is 1, and a case of the suite fails [default: 0.01
    /// rad].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "ANGLE"))]
    pub limit: Option<Given<Positive<Angle>>>,
    /// Grade the runs of the suite's cases in this folder: NAME.csv, or NAME@STEP.csv for several
    /// steps (also .parquet and .jsonl). Cases that a program cannot run are lines `NAME: reason`
    /// in not-run.txt.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "DIR", conflicts_with_all = ["files", "write_suite"]))]
    pub suite: Option<PathBuf>,
}

impl Request {
    /// Returns the largest acceptable error, rad: 0.01 unless the user specifies one.
    pub fn limit(&self) -> f64 {
        /// Error that is just visible, rad.
        const LIMIT: f64 = 0.01;
        self.limit.as_ref().map_or(LIMIT, |limit| limit.value.0.into())
    }
}

/// Interpretation of a run's numbers that the user specifies; the rest is detected.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct ReadAs {
    /// Columns of quantities: time, quaternion wxyz|xyzw, matrix or euler 3-2-1 [deg], and omega
    /// body|space [deg/s].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "WHAT=NAMES, …"))]
    pub columns: Option<Given<Columns>>,
    /// Order of quaternion components [default: detected].
    #[cfg_attr(feature = "arguments", arg(long, value_enum))]
    pub quaternion: Option<Order>,
    /// Sense of rotations: body components to space, or the inverse [default: detected].
    #[cfg_attr(feature = "arguments", arg(long, value_enum))]
    pub sense: Option<Sense>,
    /// Axes of the run's ω (--start-omega states its value at the first row) [default: detected].
    #[cfg_attr(feature = "arguments", arg(long, value_enum))]
    pub omega: Option<Axes>,
    /// Axes x, y, z of the run as axes of the scenario, such as x,z,-y [default: detected].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "A,B,C", allow_hyphen_values = true))]
    pub axes: Option<Given<AxesOfRun>>,
    /// Time of the run at the scenario's time 0, s or with its unit [default: detected].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "T", allow_hyphen_values = true))]
    pub time_origin: Option<Given<Time>>,
}

/// Order of quaternion components.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Order {
    #[allow(missing_docs, reason = "the name says it, and the help of the command would repeat it")]
    Wxyz,
    #[allow(missing_docs, reason = "the name says it, and the help of the command would repeat it")]
    Xyzw,
}

/// Sense of rotations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Sense {
    #[allow(missing_docs, reason = "the name says it, and the help of the command would repeat it")]
    BodyToSpace,
    #[allow(missing_docs, reason = "the name says it, and the help of the command would repeat it")]
    SpaceToBody,
}

/// Axes of angular velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Axes {
    #[allow(missing_docs, reason = "the name says it, and the help of the command would repeat it")]
    Body,
    #[allow(missing_docs, reason = "the name says it, and the help of the command would repeat it")]
    Space,
}

/// Axes of a run as axes of its scenario, such as `x,z,-y`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxesOfRun(pub SignedAxes);

impl FromStr for AxesOfRun {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        SignedAxes::parse(text).map(Self).ok_or_else(|| {
            "expected three right-handed axes, x, y and z each once (hint: y up is x,z,-y; for left-handed axes reverse all three, \
             which gives the same rotations)"
                .to_owned()
        })
    }
}

impl ReadAs {
    /// Returns the specified interpretation; the user's options take precedence over the run's own.
    pub fn declared(&self, says: &DeclaredReading) -> DeclaredReading {
        let order = self.quaternion.map(|order| match order {
            Order::Wxyz => QuaternionOrder::ScalarFirst,
            Order::Xyzw => QuaternionOrder::ScalarLast,
        });
        let sense = self.sense.map(|sense| match sense {
            Sense::BodyToSpace => AttitudeSense::BodyToSpace,
            Sense::SpaceToBody => AttitudeSense::SpaceToBody,
        });
        let omega_axes = self.omega.map(|axes| match axes {
            Axes::Body => OmegaAxes::Body,
            Axes::Space => OmegaAxes::Space,
        });
        let said = DeclaredReading {
            order,
            sense,
            omega_axes,
            axes: self.axes.as_ref().map(|axes| axes.value.0),
            time_origin: self.time_origin.as_ref().map(|time| time.value.into()),
            ..DeclaredReading::default()
        };
        said.or(says)
    }
}
