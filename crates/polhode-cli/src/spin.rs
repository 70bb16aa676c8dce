//! `polhode spin`

mod body;
mod curves;
mod files;
mod when;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use polhode::body::InertiaTensor;
use polhode::math::{Attitude, Body, Space};
use polhode::motion::FreeMotion;
use polhode::observe::{AxisConvention, TumblingPeriods};
use polhode_document::json::pretty;
use polhode_scenario::report::{MotionFigures, SpinReport, TumblerReport};
use polhode_source::unit::Dimension;

use crate::failure::Failure;
use crate::plot::{Drawn, PlotFlags};
use crate::stdout::{columns, print};
use body::{Moments, Omega, Subject};
use files::FileFlags;
use polhode_source::given::{numbers, positive, rotation};
use when::TimeFlags;

/// Free motion at once: its kind, its periods, and the state at any time, past or future.
///
/// The body is a scenario's (about its centre of mass, from its [start]; its [run] is not asked) or is given by its moments of
/// inertia about the body axes x, y, z, or by its inertia tensor. The motion is exact: ω by Jacobi's elliptic functions and the attitude by theta
/// functions, so a time 10⁹ periods away costs as much as the next second.
///
/// A number without a unit is SI. A list takes a unit for each number or one for all: "(0, 0, 30) deg/s". Nothing is
/// written unless --duration, --curves, --html, -o or --plot is given.
#[derive(Debug, Args)]
#[command(
    after_help = "\
Examples:
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01
  polhode spin examples/t-handle.toml --at 0,10,1e9
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01 --at-file times.txt --json | jq .motion.states
  polhode spin examples/t-handle.toml --duration \"20 s\" --every \"10 ms\" --table csv --curves -o t-handle-free
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01 --html=spin.html
  polhode spin --inertia 3.1,4.2,5.3,0.4,-0.3,0.2 --omega 0.1,2,0.3 --at 0:10:0.5
  polhode spin --moments 1,2,3 --omega 0.01,1,0.01 --plot polhodes=polhodes.svg --plot herpolhode=herpolhode.svg
  polhode spin --moments 3.0836,3.235,1 --periods \"7.40 d, 5.38 d\" --convention long",
    group = clap::ArgGroup::new("subject").required(true),
    group = clap::ArgGroup::new("folder").args(["duration", "curves", "output"]).multiple(true),
    group = clap::ArgGroup::new("written").args(["duration", "curves", "output", "html", "plot"]).multiple(true)
)]
pub(crate) struct Spin {
    /// A scenario, a TOML file without torques.
    #[arg(group = "subject")]
    file: Option<PathBuf>,
    /// Moments of inertia about the body axes x, y, z, which are principal: in kg·m², or each with its unit.
    #[arg(long, value_name = "A,B,C", group = "subject", value_parser = moments, allow_hyphen_values = true)]
    moments: Option<Moments>,
    /// The inertia tensor about the centre of mass, along body axes, off-diagonal = −∫xy dm: in kg·m², or each with its unit.
    #[arg(long, value_name = "XX,YY,ZZ,XY,XZ,YZ", group = "subject", value_parser = tensor, allow_hyphen_values = true)]
    inertia: Option<InertiaTensor<Body>>,
    /// ω at the start along body axes: in rad/s, or "(0, 0, 30) deg/s" [default: the scenario's].
    #[arg(long, value_name = "X,Y,Z", value_parser = omega, allow_hyphen_values = true)]
    omega: Option<Omega>,
    /// Attitude at the start: a quaternion, body to space, scalar first [default: the scenario's, else 1,0,0,0].
    #[arg(long, value_name = "W,X,Y,Z", value_parser = rotation::<Space, Body>, allow_hyphen_values = true)]
    attitude: Option<Attitude>,
    /// Compute the motion of unphysical moments, i1 + i2 < i3, all the same.
    #[arg(long, conflicts_with_all = ["file", "inertia"])]
    allow_unphysical: bool,
    #[command(flatten)]
    times: TimeFlags,
    /// The inverse: all spins with these two periods of a tumbling body, P_φ of precession and P_ψ of rotation.
    #[arg(
        long,
        value_name = "P_PHI,P_PSI",
        value_parser = periods,
        allow_hyphen_values = true,
        requires = "convention",
        conflicts_with_all = FORWARD
    )]
    periods: Option<TumblingPeriods>,
    /// The axis that --periods speak of.
    #[arg(long, value_enum, value_name = "AXIS", requires = "periods", conflicts_with_all = FORWARD)]
    convention: Option<Convention>,
    /// Print JSON: the same keys for every motion.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    files: FileFlags,
    #[command(flatten)]
    plots: PlotFlags,
}

/// What a motion needs whose start is known. Of an option that requires another clap asks nothing where that other conflicts with
/// what is given: what goes with --duration or --curves stands here too.
const FORWARD: [&str; 15] = [
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
];

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Convention {
    /// The longest axis, that of least moment: most on comets (Samarasinha & A'Hearn 1991).
    Long,
    /// The shortest axis, that of greatest moment: most on light curves of asteroids (Kaasalainen 2001).
    Short,
}

impl Spin {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let subject = match (&self.file, self.moments, self.inertia) {
            (Some(file), ..) => Subject::of_file(file)?,
            (None, Some(moments), _) => Subject::of_moments(moments, self.allow_unphysical)?,
            (None, None, Some(tensor)) => Subject::of_tensor(tensor)?,
            (None, None, None) => {
                return Err(Failure::usage(
                    "there is no body",
                    "name a scenario, or give --moments or --inertia",
                ));
            }
        };
        match (self.periods, self.convention) {
            (Some(periods), Some(convention)) => self.inverse(&subject, periods, convention),
            _ => self.forward(&subject),
        }
    }

    fn forward(&self, subject: &Subject) -> Result<(), Failure> {
        let motion = subject.motion(subject.start(self.omega, self.attitude)?)?;
        let times = self.times.read()?;
        let target = self.files.target(self.file.as_deref())?;
        self.files.check_html()?;
        self.plots.check(self.files.force(), None)?;
        let report = SpinReport::new(subject.source(), motion).found(subject.findings()).at(&times);
        let report = report.map_err(|error| Failure::motion("--at".to_owned(), error))?;
        let json = pretty(&report.to_json()) + "\n";
        let plots = self.plots(subject, &motion)?;
        let page = subject.page(self.file.as_deref(), motion.start(), motion.principal())?;
        let mut written = self.files.write_html(&motion, &page.page(), &times)?;
        if let Some(target) = target {
            written +=
                &self.files.write(&target, &json, &motion, &subject.metadata(), &page.page(), &times)?;
        }
        let plotted = plots.map_or_else(|| Ok(String::new()), Drawn::publish)?;
        if self.json {
            return print(&json);
        }
        let text = columns().map_or_else(|| report.to_text(), |columns| report.to_screen(columns));
        print(&(text + &written + &plotted))
    }

    /// The plots, if there are to be some.
    fn plots(&self, subject: &Subject, motion: &FreeMotion) -> Result<Option<Drawn>, Failure> {
        if !self.plots.wanted() {
            return Ok(None);
        }
        let trajectory = self.files.to_be_drawn(motion)?;
        self.plots
            .draw(&MotionFigures::of_motion(&subject.title(), motion, &trajectory), self.files.force(), None)
            .map(Some)
    }

    fn inverse(
        &self,
        subject: &Subject,
        periods: TumblingPeriods,
        convention: Convention,
    ) -> Result<(), Failure> {
        let convention = match convention {
            Convention::Long => AxisConvention::LongAxis,
            Convention::Short => AxisConvention::ShortAxis,
        };
        let report =
            TumblerReport::new(subject.source(), subject.principal()?, periods, convention).map_err(|error| {
                let hint = "try the other --convention, or a period twice or half as long: a light curve may show either";
                Failure::usage(error.to_string(), hint)
            })?;
        if self.json {
            return print(&(pretty(&report.to_json()) + "\n"));
        }
        print(&report.to_text())
    }
}

fn moments(text: &str) -> Result<Moments, String> {
    let moments = numbers(text, "a,b,c", Dimension::INERTIA)?;
    let mut sorted = moments;
    sorted.sort_by(f64::total_cmp);
    let [least, second, third] = sorted;
    if !(least >= 0.0) {
        return Err(format!("{least} is negative, and a moment of inertia is a sum of squares"));
    }
    if second == 0.0 {
        return Err("a body with two moments of 0 is a point".to_owned());
    }
    if least == 0.0 && second != third {
        return Err("only a rod has a moment of 0, and its other two are equal".to_owned());
    }
    Ok(Moments(moments))
}

fn tensor(text: &str) -> Result<InertiaTensor<Body>, String> {
    let [xx, yy, zz, xy, xz, yz] = numbers(text, "xx,yy,zz,xy,xz,yz", Dimension::INERTIA)?;
    InertiaTensor::with_negative_products([xx, yy, zz], [xy, xz, yz]).map_err(|error| error.to_string())
}

fn omega(text: &str) -> Result<Omega, String> {
    numbers(text, "x,y,z", Dimension::ANGULAR_VELOCITY).map(Omega)
}

fn periods(text: &str) -> Result<TumblingPeriods, String> {
    let [precession, rotation] = numbers(text, "P_phi,P_psi", Dimension::TIME)?;
    Ok(TumblingPeriods { precession: positive(precession)?, rotation: positive(rotation)? })
}
