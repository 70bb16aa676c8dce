//! Free rigid body whose motion starts at the first row of a log: a scenario without a file.

mod error;
mod start;

use std::path::Path;

use polhode::body::InertiaTensor;
use polhode::infer::judge::{DeclaredByName, DeclaredReading, MotionLog, OmegaAxes, SignedAxes};
use polhode::math::Body;
use polhode_document::number::number;
use polhode_scenario::read::ScenarioFile;
use polhode_source::Failure;
use polhode_source::files::Memory;

pub use error::FirstRowError;
use start::Start;

/// Free rigid body whose motion starts at the first row of a log.
///
/// ```
/// use polhode::infer::judge::{DeclaredReading, MotionLog};
/// use polhode_judge::FreeBody;
/// // A rotation about the third axis, quaternions scalar first, from 2 s.
/// let row = |k: u32| (0.05 * f64::from(k), 0.0, 0.3 * 0.05 * f64::from(k) / 2.0);
/// let times: Vec<f64> = (0..50).map(|k| 2.0 + row(k).0).collect();
/// let attitude = (0..50).map(|k| [row(k).2.cos(), 0.0, 0.0, row(k).2.sin()]).collect();
/// let log = MotionLog::new(times, attitude)?.with_omega(vec![[0.0, 0.0, 0.3]; 50])?;
/// let body = FreeBody::new([1.0, 2.0, 2.5], None)?;
/// let file = body.scenario(&log, &DeclaredReading::default())?;
/// assert_eq!(file.scenario.start().omega.to_array(), [0.0, 0.0, 0.3]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeBody {
    moments: [f64; 3],
    omega: Option<[f64; 3]>,
}

impl FreeBody {
    /// Creates a body from its principal moments about the body axes of the log, kg·m². `omega` is
    /// the angular velocity at the first row, body axes, rad/s; if `None`, that of the log.
    ///
    /// # Errors
    /// [`Failure`] for moments that no body has.
    pub fn new(moments: [f64; 3], omega: Option<[f64; 3]>) -> Result<Self, Failure> {
        InertiaTensor::<Body>::diagonal(moments)
            .map(|_| Self { moments, omega })
            .map_err(|error| Failure::usage(error.to_string(), "check --moments and its units"))
    }

    /// Returns the scenario of the body that starts at time 0 with the first row of a log.
    ///
    /// # Errors
    /// [`FirstRowError`] if the first row does not determine the start.
    pub fn scenario(
        &self,
        log: &MotionLog,
        declared: &DeclaredReading,
    ) -> Result<ScenarioFile, FirstRowError> {
        Start::of(log, declared, self)?.scenario(self)
    }

    /// Returns the declarations for the log with the first row: its axes and its clock are those of
    /// the scenario. If ω is 0 in all rows, its axes have no effect, and are declared.
    pub fn declared(log: &MotionLog, declared: &DeclaredReading) -> DeclaredReading {
        let is_at_rest = log.omega().is_some_and(|omega| omega.iter().all(|omega| *omega == [0.0; 3]));
        let frame = declared.omega_axes.or(is_at_rest.then_some(OmegaAxes::Body));
        let by_name =
            DeclaredByName { omega_axes: declared.by_name.omega_axes && !is_at_rest, ..declared.by_name };
        let (axes, time_origin) = (Some(SignedAxes::SAME), Some(log.times()[0]));
        DeclaredReading { axes, time_origin, omega_axes: frame, by_name, ..*declared }
    }
}

impl Start {
    /// Returns the scenario of a body with this start, as a scenario file would define it.
    fn scenario(&self, body: &FreeBody) -> Result<ScenarioFile, FirstRowError> {
        let [a, b, c] = body.moments.map(|moment| number(moment, 6));
        let text = format!(
            "title = \"Free body, moments {a}, {b}, {c} kg·m²\"\n[[body.part]]\nshape = \"tensor\"\nmass = 1\n\
             moments = {:?}\n[start]\nattitude = {{ quaternion = {:?} }}\nspin = {{ body = {:?} }}\n",
            body.moments, self.quaternion, self.omega
        );
        // Messages about the motion name the option.
        Ok(ScenarioFile::parse(&Memory::default(), text, Path::new("--moments"))?)
    }
}
