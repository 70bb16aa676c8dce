//! Motion of a scenario.

use std::path::{Path, PathBuf};

use numpy::{PyArray1, PyReadonlyArray1};
use polhode::motion::channel;
use polhode::motion::torque::TorqueModel;
use polhode::motion::{
    Ending, ErrorEffort, Event, Measure, MotionError, Run, Scenario, Trajectory, TrajectoryDerivatives,
};
use polhode_document::SourceInfo;
use polhode_document::VERSION;
use polhode_scenario::read::{ScenarioFile, exact};
use polhode_scenario::report::{
    MotionReport, PageInput, PageSubject, explain_motion, has_triangles, page_data, page_data_within, page_of,
};
use polhode_table::output::Table;
use pyo3::prelude::*;

use crate::arrays::{ErrorColumns, States, error_columns, numbers, table};
use crate::derivatives::{Derived, derived_run, parameters};
use crate::error::{Raise, refused};
use crate::finding::{Remark, remarks};
use crate::interrupt::watched;
use crate::required::columns;
use crate::scenario::{
    self, PythonMeasure, PythonTorque, Raised, ScenarioSource, has_raised, heard, with_functions,
    with_measures,
};

/// Title of the page of a scenario without a title.
const UNTITLED: &str = "motion";

/// Scenario with its computed motion.
#[pyclass(frozen, name = "Motion", module = "polhode._native")]
#[derive(Debug)]
pub(crate) struct PyMotion {
    path: PathBuf,
    text: String,
    scenario: Scenario,
    trajectory: Trajectory,
    /// Derivatives, with the keys of their parameters.
    derivatives: Option<(TrajectoryDerivatives, Vec<String>)>,
    /// Exception raised by a Python function of a torque or event.
    raised: Raised,
    /// True if the motion continues another one.
    is_continued: bool,
}

/// Event: name, time in s, true if its measure was rising, ω and attitude.
type Happened = (String, f64, bool, [f64; 3], [f64; 4]);

/// Computes the motion of a scenario.
/// `times` replace those of its run. `derivatives` lists the keys of torque parameters; if given,
/// the derivatives with respect to the initial state, the inertia and these parameters are
/// computed. Functions in `own` replace torques and event measures of the scenario.
///
/// # Errors
/// `PolhodeError` if the motion cannot be computed, `KeyboardInterrupt`.
#[pyfunction]
pub(crate) fn simulate(
    py: Python<'_>,
    source: ScenarioSource<'_>,
    times: Option<PyReadonlyArray1<'_, f64>>,
    error: &str,
    derivatives: Option<Vec<String>>,
    own: (Vec<PythonTorque>, Vec<PythonMeasure>),
) -> PyResult<PyMotion> {
    let mut file = source.read(py)?;
    let raised = Raised::default();
    file.scenario = with_functions(file.scenario, own.0, &raised)?;
    file.scenario = with_measures(file.scenario, own.1, &raised)?;
    if let Some(times) = times {
        file.scenario = scenario::sampled(file.scenario, numbers(&times)?);
    }
    let by = derivatives.as_ref().map(|keys| parameters(keys, file.scenario.torques())).transpose()?;
    let Some(motion) = computed(py, &file.scenario, error, &raised)? else {
        return Err(refused(
            format!("{} has no [run] section, which sets the simulated time", file.path.display()),
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
    let ScenarioFile { scenario, path, text, .. } = file;
    Ok(PyMotion { path, text, trajectory, scenario, derivatives, raised, is_continued: false })
}

/// Computes the motion of a scenario with the error estimate selected by `error`; `None` without a
/// run. By default it is cheap if Python is called.
///
/// # Errors
/// Exceptions of Python functions, and `KeyboardInterrupt`.
fn computed(
    py: Python<'_>,
    scenario: &Scenario,
    error: &str,
    raised: &Raised,
) -> PyResult<Option<Result<Trajectory, MotionError>>> {
    let effort = match error {
        "none" => None,
        "thorough" => Some(ErrorEffort::Thorough),
        "cheap" => Some(ErrorEffort::Cheap),
        _ if has_functions(scenario) => Some(ErrorEffort::Cheap),
        _ => Some(ErrorEffort::Auto),
    };
    let motion = watched(py, |look| {
        let look = &mut |time: f64| look(time) && !has_raised(raised);
        match effort {
            Some(effort) => scenario.simulate_with_error(effort, look),
            None => scenario.simulate_watched(look),
        }
    })?;
    heard(raised).map(|()| motion)
}

#[pymethods]
impl PyMotion {
    /// Returns the columns of the trajectory table and the work: name, unit, description, values.
    fn columns<'py>(
        &self,
        py: Python<'py>,
    ) -> Vec<(String, &'static str, &'static str, Bound<'py, PyArray1<f64>>)> {
        let all = || {
            let each = columns(&Table::of(&self.trajectory, &(&self.scenario).into())).into_iter();
            let work = ("work_j".to_owned(), "J", "work of the torque since the start", self.work());
            each.chain([work]).collect()
        };
        let columns: Vec<(String, &str, &str, Vec<f64>)> = py.detach(all);
        let given = columns.into_iter();
        given
            .map(|(name, unit, description, values)| {
                (name, unit, description, PyArray1::from_vec(py, values))
            })
            .collect()
    }

    /// Returns ω and attitudes at further times between the start and the last sample, in any
    /// order. The motion is computed again with these times among its samples.
    fn at<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<States<'py>> {
        let asked = numbers(&times)?;
        let run = self.scenario.run().ok_or_else(|| refused("the scenario has no [run] section", None))?;
        let mut all: Vec<f64> = run.times.iter().chain(asked).copied().collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        let scenario = self.scenario.clone().sampled(Run { times: all, ..run.clone() });
        let again = computed(py, &scenario, "none", &self.raised)?;
        let again =
            again.ok_or_else(|| refused("the scenario has no [run] section", None))?.map_err(Raise::raise)?;
        let samples = again.samples();
        let (mut omega, mut attitude) = (Vec::new(), Vec::new());
        for &time in asked {
            let place = samples.partition_point(|sample| sample.state.time < time);
            let sample = samples.get(place).filter(|sample| sample.state.time == time);
            let state = sample
                .ok_or_else(|| refused(format!("the motion has no state at t = {time} s"), None))?
                .state;
            omega.extend(state.omega.to_array());
            attitude.extend(state.attitude.quaternion());
        }
        Ok((table(py, omega, 3)?, table(py, attitude, 4)?))
    }

    /// Returns the continuation of the motion from its end, at these times.
    fn after(&self, py: Python<'_>, times: PyReadonlyArray1<'_, f64>, error: &str) -> PyResult<Self> {
        let times = numbers(&times)?.to_vec();
        let scenario = self.scenario.continued_after(&self.trajectory, times).map_err(Raise::raise)?;
        let motion = computed(py, &scenario, error, &self.raised)?;
        let motion = motion.ok_or_else(|| refused("the scenario has no [run] section", None))?;
        Ok(Self {
            path: self.path.clone(),
            text: self.text.clone(),
            trajectory: motion.map_err(Raise::raise)?,
            scenario,
            derivatives: None,
            raised: Raised::clone(&self.raised),
            is_continued: true,
        })
    }

    /// Path and text of the scenario.
    #[getter]
    fn source(&self) -> (&Path, &str) {
        (&self.path, &self.text)
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

    /// Error estimates from the computation and from input rounding: attitude, rad, and ω,
    /// relative. `None` for a prescribed motion.
    #[getter]
    fn error<'py>(&self, py: Python<'py>) -> Option<ErrorColumns<'py>> {
        Some(error_columns(py, self.trajectory.error()?))
    }

    /// Derivatives of the motion, if they were requested.
    fn derivatives<'py>(&self, py: Python<'py>) -> PyResult<Option<Derived<'py>>> {
        let of = |(run, keys): &(TrajectoryDerivatives, Vec<String>)| {
            derived_run(py, self.scenario.rotor(), run, keys, self.scenario.events())
        };
        self.derivatives.as_ref().map(of).transpose()
    }

    /// End of the motion: `complete`, `stopped`, `contact` or `failed`; then the event, change of
    /// contact or cause, and the time, s.
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

    /// Findings: code, severity, message, place.
    #[getter]
    fn findings(&self) -> Vec<Remark> {
        remarks(&self.report().findings())
    }

    #[getter]
    fn title(&self) -> Option<&str> {
        self.scenario.title()
    }

    /// Returns the contents of `summary.json`.
    fn json(&self, py: Python<'_>) -> String {
        py.detach(|| self.report().summary_json().to_string())
    }

    /// Returns the text that `polhode simulate` prints.
    fn text(&self, py: Python<'_>) -> String {
        py.detach(|| self.report().to_text())
    }

    /// True if the body has a mesh, which `page_data` may have to simplify.
    #[getter]
    fn has_triangles(&self) -> bool {
        has_triangles(&PageSubject::Scenario(&self.scenario))
    }

    /// Returns the data of the page of `polhode simulate`, without the viewer; `triangles` limits
    /// the size of the mesh, bytes.
    fn page_data(&self, py: Python<'_>, triangles: Option<usize>) -> String {
        py.detach(|| {
            // A motion without an explanation can still be displayed, such as a pendulum whose axis
            // cannot carry it. A continuation is explained with the original motion.
            let explanation = explain_motion(
                &self.scenario,
                &self.trajectory,
                &exact(&self.text, &self.path, &self.scenario),
            )
            .ok();
            let explanation = explanation.filter(|_| !self.is_continued);
            let input = PageInput {
                title: self.scenario.title().unwrap_or(UNTITLED),
                source: &format!("polhode {VERSION} in Python"),
                // A text cannot contain a Python function, or start at the end of another motion.
                scenario_text: (!has_functions(&self.scenario) && !self.is_continued).then_some(&*self.text),
                subject: PageSubject::Scenario(&self.scenario),
                trajectory: &self.trajectory,
                explanation: explanation.as_ref(),
                whole: true,
            };
            triangles.map_or_else(|| page_data(&input), |bytes| page_data_within(&input, bytes))
        })
    }
}

/// Returns the page for a title and the result of `page_data`.
#[pyfunction]
pub(crate) fn motion_page(title: Option<&str>, data: &str) -> String {
    page_of(title.unwrap_or(UNTITLED), data)
}

/// Returns true if Python computes a torque or the measure of an event.
fn has_functions(scenario: &Scenario) -> bool {
    let of_event = |event: &Event| matches!(event.measure(), Measure::Function(_));
    scenario.torques().iter().any(|torque| matches!(torque, TorqueModel::Own(_)))
        || scenario.events().iter().any(of_event)
}

impl PyMotion {
    /// Returns the work of the torque since the start at each sample, J.
    fn work(&self) -> Vec<f64> {
        let energy = self.trajectory.channel(channel::ENERGY);
        energy.map_or_else(Vec::new, |energy| energy.iter().map(|energy| energy.work).collect())
    }

    fn report(&self) -> MotionReport<'_> {
        let title = self.scenario.title().unwrap_or("scenario");
        let source = SourceInfo::new(self.path.display().to_string(), "scenario").described(title);
        MotionReport::new(source, &self.scenario, &self.trajectory)
    }
}
