//! Free motion in closed form: its kind, its periods, and the state at any time.

mod given;
mod sampling;
mod subject;

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use polhode::motion::{FreeMotion, Scenario, Trajectory};
use polhode::observe::AxisConvention;
use polhode_document::{Document, Report};
use polhode_source::Failure;
use polhode_source::files::Files;
use polhode_source::given::{Given, Times};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::schema::complete;
use crate::report::{MotionFigures, SpinReport, TumblerReport};
use subject::Subject;

pub use given::{Moments, Omega, Periods, Quaternion, Tensor};
pub use sampling::Sampling;

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../../../schema/spin/request.json");

/// JSON schema of the JSON of an [`Answer`].
pub static REPORT_SCHEMA: LazyLock<String> =
    LazyLock::new(|| complete(include_str!("../../../schema/spin/report.json")));

/// Request for the motion of a free body with a given start, or for the spins with two observed
/// periods.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_scenario::request::spin::{Request, run};
/// use polhode_source::files::Memory;
/// let (moments, omega) = (Some("1, 2, 3".parse()?), Some("0.01, 1, 0.01".parse()?));
/// let request = Request { moments, omega, at: vec!["10 s".parse()?], ..Request::default() };
/// let answer = run(&request, &Memory::default()).map_err(|error| error.to_string())?;
/// assert_eq!(answer.to_json()["motion"]["regime"], "short_axis");
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// A scenario, a TOML file without torques.
    #[cfg_attr(feature = "arguments", arg(group = "subject"))]
    pub file: Option<PathBuf>,
    /// Moments of inertia about the body axes x, y, z, which are principal: in kg·m², or each with its
    /// unit.
    #[cfg_attr(
        feature = "arguments",
        arg(long, value_name = "A,B,C", group = "subject", allow_hyphen_values = true)
    )]
    pub moments: Option<Given<Moments>>,
    /// The inertia tensor about the centre of mass, along body axes, off-diagonal = −∫xy dm: in kg·m², or
    /// each with its unit.
    #[cfg_attr(
        feature = "arguments",
        arg(long, value_name = "XX,YY,ZZ,XY,XZ,YZ", group = "subject", allow_hyphen_values = true)
    )]
    pub inertia: Option<Given<Tensor>>,
    /// ω at the start along body axes: in rad/s, or "(0, 0, 30) deg/s" [default: the scenario's].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true))]
    pub omega: Option<Given<Omega>>,
    /// Attitude at the start: a quaternion, body to space, scalar first [default: the scenario's, else
    /// 1,0,0,0].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "W,X,Y,Z", allow_hyphen_values = true))]
    pub attitude: Option<Given<Quaternion>>,
    /// Compute the motion of unphysical moments, i1 + i2 < i3, all the same.
    #[cfg_attr(feature = "arguments", arg(long, conflicts_with_all = ["file", "inertia"]))]
    pub allow_unphysical: bool,
    /// Print ω and the attitude at these times: in s, or each with its unit; 0:1:0.1 are those from 0 to 1
    /// in steps of 0.1; negative ones are before the start.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "T,…", allow_hyphen_values = true))]
    pub at: Vec<Given<Times>>,
    /// The inverse: all spins with these two periods of a tumbling body, P_φ of precession and P_ψ of
    /// rotation.
    #[cfg_attr(feature = "arguments", arg(
        long,
        value_name = "P_PHI,P_PSI",
        allow_hyphen_values = true,
        requires = "convention",
        conflicts_with_all = FORWARD
    ))]
    pub periods: Option<Given<Periods>>,
    /// The axis that --periods speak of.
    #[cfg_attr(feature = "arguments", arg(long, value_enum, value_name = "AXIS", requires = "periods", conflicts_with_all = FORWARD))]
    pub convention: Option<Convention>,
    /// Print the details too: the other convention of the periods, Poinsot's picture, the parameter m.
    #[cfg_attr(feature = "arguments", arg(short, long))]
    pub verbose: bool,
}

/// Options that require a known start, in conflict with `--periods`. If an option conflicts with a
/// given one, clap does not check its `requires`. Options that go with `--duration` or `--curves`
/// are therefore listed too.
#[cfg(feature = "arguments")]
const FORWARD: [&str; 16] = [
    "allow_unphysical",
    "omega",
    "attitude",
    "at",
    "at_file",
    "duration",
    "samples",
    "every",
    "table",
    "curves",
    "chord_error",
    "html",
    "output",
    "plot",
    "force",
    "verbose",
];

/// Axis to which two observed periods refer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Convention {
    /// The longest axis, that of least moment: most on comets (Samarasinha & A'Hearn 1991).
    Long,
    /// The shortest axis, that of greatest moment: most on light curves of asteroids (Kaasalainen 2001).
    Short,
}

/// Finds the free motion of a body, or all spins with two periods.
///
/// # Errors
/// [`Failure`] if a file cannot be read, for a body that is not free or not physical, and for an
/// incomplete start.
pub fn run(request: &Request, files: &dyn Files) -> Result<Answer, Failure> {
    let subject = match (&request.file, &request.moments, &request.inertia) {
        (Some(file), ..) => Subject::of_file(files, file)?,
        (None, Some(moments), _) => Subject::of_moments(moments.value, request.allow_unphysical)?,
        (None, None, Some(tensor)) => Subject::of_tensor(tensor.value.0)?,
        (None, None, None) => {
            return Err(Failure::usage(
                "there is no body",
                "name a scenario, or give --moments or --inertia",
            ));
        }
    };
    match (&request.periods, request.convention) {
        (Some(periods), Some(convention)) => {
            inverse(&subject, periods.value, convention).map(|spins| Answer::Spins(Box::new(spins)))
        }
        _ => Spin::new(subject, request).map(|spin| Answer::Motion(Box::new(spin))),
    }
}

fn inverse(
    subject: &Subject,
    Periods(periods): Periods,
    convention: Convention,
) -> Result<TumblerReport, Failure> {
    let convention = match convention {
        Convention::Long => AxisConvention::LongAxis,
        Convention::Short => AxisConvention::ShortAxis,
    };
    TumblerReport::new(subject.source(), subject.principal()?, periods, convention).map_err(|error| {
        // A ratio that is too small about the long axis is too small about the short one, too.
        let hint = match convention {
            AxisConvention::ShortAxis => {
                "try --convention long, or twice or half of a period: a light curve may show either"
            }
            AxisConvention::LongAxis => "try twice or half of a period: a light curve may show either",
        };
        Failure::usage(error.to_string(), hint)
    })
}

/// Answer to a [`Request`].
#[derive(Debug)]
pub enum Answer {
    /// Motion with a known start.
    Motion(Box<Spin>),
    /// All spins with two given periods.
    Spins(Box<TumblerReport>),
}

impl Report for Answer {
    fn to_json(&self) -> Value {
        match self {
            Self::Motion(spin) => spin.report.to_json(),
            Self::Spins(spins) => spins.to_json(),
        }
    }

    fn to_document(&self) -> Document {
        Document::of_text("Free motion", &self.to_text(None))
    }

    fn to_text(&self, columns: Option<usize>) -> String {
        match (self, columns) {
            (Self::Motion(spin), Some(columns)) => spin.report.to_screen(columns),
            (Self::Motion(spin), None) => spin.report.to_text(),
            (Self::Spins(spins), _) => spins.to_text(),
        }
    }
}

/// Free motion of a body.
#[derive(Debug)]
pub struct Spin {
    subject: Subject,
    /// The computed motion.
    pub motion: FreeMotion,
    /// Requested times, s.
    pub times: Vec<f64>,
    report: SpinReport,
}

impl Spin {
    fn new(subject: Subject, request: &Request) -> Result<Self, Failure> {
        let omega = request.omega.as_ref().map(|omega| omega.value);
        let attitude = request.attitude.as_ref().map(|attitude| attitude.value.0);
        let motion = subject.motion(subject.start(omega, attitude)?)?;
        let times: Vec<f64> = request.at.iter().flat_map(|at| at.value.0.iter().copied()).collect();
        let report = SpinReport::new(subject.source(), motion).found(subject.findings()).at(&times);
        let report = report.map_err(|error| Failure::Motion { path: "--at".to_owned(), error })?;
        Ok(Self { subject, motion, times, report: report.verbose(request.verbose) })
    }

    /// Returns the scenario with the start of the motion, its text and its path; `None` for moments
    /// and tensors.
    ///
    /// # Errors
    /// [`Failure`] if the scenario does not accept this start.
    pub fn scenario(&self) -> Result<Option<(Scenario, &str, &Path)>, Failure> {
        self.subject.started(self.motion.start())
    }

    /// Returns the plots of the motion along a trajectory of it.
    pub fn figures<'a>(&'a self, trajectory: &'a Trajectory) -> MotionFigures<'a> {
        MotionFigures::of_motion(&self.subject.title(), &self.motion, trajectory)
    }

    /// Returns the metadata of a table of the motion: keys and values.
    pub fn metadata(&self) -> Vec<(String, String)> {
        self.subject.metadata()
    }
}
