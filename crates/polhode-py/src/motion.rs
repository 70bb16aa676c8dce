//! The motion of a scenario.

use std::path::PathBuf;

use numpy::{PyArray1, PyReadonlyArray1};
use polhode::motion::gimbal::GimbalSample;
use polhode::motion::{
    Ending, ErrorEffort, GlobalError, Method, Run, Scenario, StateError, Trajectory, TrajectoryDerivatives,
};
use polhode_formats::scenario::ScenarioFile;
use polhode_formats::table::{Column, columns};
use polhode_report::{
    MotionReport, PageInput, PageSubject, SourceInfo, VERSION, explain_motion, page_data, page_of,
};
use pyo3::prelude::*;

use crate::arrays::numbers;
use crate::derivatives::{Derived, derived_run, parameters};
use crate::error::{Raise, refused};
use crate::finding::{Remark, remarks};
use crate::interrupt::watched;

/// What the page of a scenario without a title is called.
const UNTITLED: &str = "motion";

/// A scenario and the motion that was computed of it.
#[pyclass(frozen, name = "Motion", module = "polhode._native")]
#[derive(Debug)]
pub(crate) struct PyMotion {
    path: PathBuf,
    text: String,
    scenario: Scenario,
    trajectory: Trajectory,
    /// With the keys of the parameters.
    derivatives: Option<(TrajectoryDerivatives, Vec<String>)>,
}

/// An event: its name, when (s), whether what it watches was rising, ω and attitude there.
type Happened = (String, f64, bool, [f64; 3], [f64; 4]);

/// Computes the motion of a scenario: of a file, or of a text, whose files are found beside `path`. `times` take the place of its run's. Its derivatives
/// by the start, the inertia and numbers of torques by their keys, if these are given.
///
/// # Errors
/// `PolhodeError` if there is no such motion, `KeyboardInterrupt`.
#[pyfunction]
pub(crate) fn simulate(
    py: Python<'_>,
    path: PathBuf,
    text: Option<String>,
    times: Option<PyReadonlyArray1<'_, f64>>,
    error: &str,
    derivatives: Option<Vec<String>>,
) -> PyResult<PyMotion> {
    let effort = match error {
        "thorough" => ErrorEffort::Thorough,
        "cheap" => ErrorEffort::Cheap,
        _ => ErrorEffort::Auto,
    };
    let read = || match text {
        None => ScenarioFile::read(&path),
        Some(text) => ScenarioFile::parse(text, &path),
    };
    let mut file = py.detach(read).map_err(Raise::raise)?;
    if let Some(times) = times {
        let times = numbers(&times)?.to_vec();
        let run = file.scenario.run().cloned().unwrap_or_else(|| Run::evenly(0.0, 0, Method::Auto, 1e-13));
        file.scenario = file.scenario.sampled(Run { times, ..run });
    }
    let by = derivatives.as_ref().map(|keys| parameters(keys, file.scenario.torques())).transpose()?;
    let Some(motion) = watched(py, |look| file.scenario.simulate_with_error(effort, look))? else {
        return Err(refused(
            format!("{} has no [run] section, so there is no time to simulate", path.display()),
            Some("give times, or write [run] with duration = \"10 s\" and samples = 1001"),
        ));
    };
    let placed = |error| file.placed(&error).map_or_else(|| error.raise(), Raise::raise);
    let trajectory = motion.map_err(placed)?;
    let derived = match by {
        Some(by) => watched(py, |look| file.scenario.derivatives_watched(&by, look))?,
        None => None,
    };
    let derivatives = derived.transpose().map_err(placed)?.zip(derivatives);
    Ok(PyMotion { path, text: file.text, trajectory, scenario: file.scenario, derivatives })
}

#[pymethods]
impl PyMotion {
    /// The columns of the trajectory's table, by name.
    fn columns<'py>(&self, py: Python<'py>) -> Vec<(String, Bound<'py, PyArray1<f64>>)> {
        let rows = self.trajectory.samples().len();
        let of = |column: &Column| (0..rows).map(|row| column.value(&self.trajectory, row)).collect();
        let columns = || {
            let columns = columns(&self.trajectory, &(&self.scenario).into());
            columns.iter().map(|column| (column.name.to_string(), of(column))).collect()
        };
        let columns: Vec<(String, Vec<f64>)> = py.detach(columns);
        columns.into_iter().map(|(name, values)| (name, PyArray1::from_vec(py, values))).collect()
    }

    #[getter]
    fn work<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let work = match (self.trajectory.contact(), self.trajectory.gimbals()) {
            (Some(contact), _) => contact.samples().iter().map(|s| s.friction_work + s.ground_work).collect(),
            (None, Some(gimbals)) => gimbals.samples().iter().map(GimbalSample::work).collect(),
            (None, None) => self.trajectory.samples().iter().map(|sample| sample.work).collect(),
        };
        PyArray1::from_vec(py, work)
    }

    #[getter]
    fn events(&self) -> Vec<Happened> {
        let events = self.trajectory.events().iter();
        events
            .map(|event| {
                let state = event.state;
                let (omega, attitude) = (state.omega.to_array(), state.attitude.canonical_quaternion());
                (event.name.clone(), state.time, event.rising, omega, attitude)
            })
            .collect()
    }

    /// Of the computation and of the last bit of the inputs: the attitude's, rad, and ω's, relative. `None` of a prescribed motion.
    #[getter]
    fn error<'py>(&self, py: Python<'py>) -> Option<ErrorColumns<'py>> {
        Some(error_columns(py, self.trajectory.error()?))
    }

    /// Its derivatives, if they were asked for.
    fn derivatives<'py>(&self, py: Python<'py>) -> PyResult<Option<Derived<'py>>> {
        let of = |(run, keys): &(TrajectoryDerivatives, Vec<String>)| {
            derived_run(py, self.scenario.rotor(), run, keys, self.scenario.events())
        };
        self.derivatives.as_ref().map(of).transpose()
    }

    /// `complete`, `stopped`, `contact` or `failed`, the event that stopped it, the change of the contact or the cause of failure, and when (s).
    #[getter]
    fn ending(&self) -> (&'static str, Option<String>, Option<f64>) {
        match self.trajectory.ending() {
            Ending::Complete => ("complete", None, None),
            Ending::Stopped { event, time } => {
                let name = self.scenario.events().get(*event).map(|event| event.name().to_owned());
                ("stopped", name, Some(*time))
            }
            Ending::Contact { change, time } => ("contact", Some(change.to_string()), Some(*time)),
            Ending::Failed { time, cause } => ("failed", Some(cause.to_string()), Some(*time)),
        }
    }

    /// What was noticed: code, severity, message, place.
    #[getter]
    fn findings(&self) -> Vec<Remark> {
        remarks(&self.report().findings())
    }

    #[getter]
    fn title(&self) -> Option<&str> {
        self.scenario.title()
    }

    /// The object that is `summary.json`.
    fn json(&self, py: Python<'_>) -> String {
        py.detach(|| self.report().summary_json().to_string())
    }

    /// The text that `polhode simulate` prints.
    fn text(&self, py: Python<'_>) -> String {
        py.detach(|| self.report().to_text())
    }

    /// What the page that `polhode simulate` writes holds besides the viewer.
    fn page_data(&self, py: Python<'_>) -> String {
        py.detach(|| {
            // What cannot be explained, as a pendulum whose axis cannot hold it, can still be shown.
            let explanation = explain_motion(&self.scenario, &self.trajectory).ok();
            page_data(&PageInput {
                title: self.scenario.title().unwrap_or(UNTITLED),
                source: &format!("polhode {VERSION} in Python"),
                scenario_text: Some(&self.text),
                subject: PageSubject::Scenario(&self.scenario),
                trajectory: &self.trajectory,
                explanation: explanation.as_ref(),
                whole: true,
            })
        })
    }
}

/// The page of a motion's title and of its `page_data`.
#[pyfunction]
pub(crate) fn motion_page(title: Option<&str>, data: &str) -> String {
    page_of(title.unwrap_or(UNTITLED), data)
}

impl PyMotion {
    fn report(&self) -> MotionReport<'_> {
        let title = self.scenario.title().unwrap_or("scenario");
        let source = SourceInfo::new(self.path.display().to_string(), "scenario").described(title);
        MotionReport::new(source, &self.scenario, &self.trajectory)
    }
}

/// Of the computation and of the last bit of the inputs: the attitude's error, rad, and ω's, relative.
pub(crate) type ErrorColumns<'py> = [[Bound<'py, PyArray1<f64>>; 2]; 2];

pub(crate) fn error_columns<'py>(py: Python<'py>, estimate: &GlobalError) -> ErrorColumns<'py> {
    [estimate.computation(), estimate.inputs()].map(|errors| {
        let column =
            |value: fn(&StateError) -> f64| PyArray1::from_vec(py, errors.iter().map(value).collect());
        [column(|e| e.attitude), column(|e| e.omega)]
    })
}
