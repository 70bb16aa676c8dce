//! Scenarios as texts: their tables, their findings, and torques and events computed in Python.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use numpy::{PyArray1, PyReadonlyArray2};
use polhode::math::{Body, Space, Torque};
use polhode::motion::torque::{MemberState, TorqueModel};
use polhode::motion::{ActingTorque, Event, EventFunction, Measure, Method, Rotor, Run, Scenario, State};

use polhode_scenario::read::ScenarioFile;
use polhode_source::files::Disk;
use pyo3::prelude::*;

use crate::arrays::{rows, table};
use crate::error::{Raise, refused};
use crate::finding::{Remark, remarks};
use crate::function::PythonFunction;

/// Returns the tables of a scenario from a file or a text, as JSON; the scenario is checked.
#[pyfunction]
pub(crate) fn scenario_tables(py: Python<'_>, path: PathBuf, text: Option<String>) -> PyResult<String> {
    let file = py.detach(|| read(path, text)).map_err(Raise::raise)?;
    let no_json = |error: &dyn std::fmt::Display| refused(format!("{}: {error}", file.path.display()), None);
    let tables: toml::Table = toml::from_str(&file.text).map_err(|error| no_json(&error.message()))?;
    serde_json::to_string(&tables).map_err(|error| no_json(&error))
}

/// Scenario that was read once, for several computations.
#[pyclass(frozen, name = "ReadScenario", module = "polhode._native")]
#[derive(Debug)]
pub(crate) struct PyScenario(ScenarioFile);

#[pymethods]
impl PyScenario {
    /// Reads the scenario of a text. Paths in it are relative to `path`.
    #[staticmethod]
    fn of_text(py: Python<'_>, path: PathBuf, text: String) -> PyResult<Self> {
        py.detach(|| read(path, Some(text))).map(Self).map_err(Raise::raise)
    }

    /// Findings: code, severity, message, place.
    #[getter]
    fn findings(&self) -> Vec<Remark> {
        remarks(self.0.scenario.findings())
    }
}

/// Scenario that is known already, or the path and the text of one. Without a text, the path is
/// that of a file.
#[derive(FromPyObject)]
pub(crate) enum ScenarioSource<'py> {
    Known(PyRef<'py, PyScenario>),
    File(PathBuf, Option<String>),
}

impl ScenarioSource<'_> {
    /// Reads the scenario, if it is not known.
    pub(crate) fn read(self, py: Python<'_>) -> PyResult<ScenarioFile> {
        match self {
            Self::Known(known) => Ok(known.0.clone()),
            Self::File(path, text) => py.detach(|| read(path, text)).map_err(Raise::raise),
        }
    }
}

/// Reads a scenario from a file or a text.
pub(crate) fn read(path: PathBuf, text: Option<String>) -> Result<ScenarioFile, polhode_source::FormatError> {
    match text {
        None => ScenarioFile::read(&Disk, &path),
        Some(text) => ScenarioFile::parse(&Disk, text, &path),
    }
}

/// Returns the scenario with other times.
pub(crate) fn sampled(scenario: Scenario, times: &[f64]) -> Scenario {
    let run = scenario.run().cloned().unwrap_or_else(|| Run::evenly(0.0, 0, Method::Auto, 1e-13));
    scenario.sampled(Run { times: times.to_vec(), ..run })
}

/// Torque computed in Python: number of the torque in the scenario, true for components along space
/// axes, and the function.
pub(crate) type PythonTorque = (usize, bool, PythonFunction);

/// Event measure computed in Python: number of the event in the scenario, true if it depends on the
/// mass of the body, and the function.
pub(crate) type PythonMeasure = (usize, bool, PythonFunction);

/// Raises the exception of a Python function, if there is one.
pub(crate) fn heard(raised: &Raised) -> PyResult<()> {
    raised.lock().unwrap_or_else(PoisonError::into_inner).take().map_or(Ok(()), Err)
}

/// Returns true if a Python function has raised an exception.
pub(crate) fn has_raised(raised: &Raised) -> bool {
    raised.lock().unwrap_or_else(PoisonError::into_inner).is_some()
}

/// Exception of a Python function.
pub(crate) type Raised = Arc<Mutex<Option<PyErr>>>;

/// Returns the scenario with some torques replaced by Python functions.
///
/// # Errors
/// `PolhodeError` if the scenario has no torque of that number.
pub(crate) fn with_functions(
    scenario: Scenario,
    functions: Vec<PythonTorque>,
    raised: &Raised,
) -> PyResult<Scenario> {
    if functions.is_empty() {
        return Ok(scenario);
    }
    let mut models = scenario.torques().to_vec();
    for (place, in_space, law) in functions {
        let model =
            models.get_mut(place).ok_or_else(|| refused(format!("torque {place} does not exist"), None))?;
        *model = function(in_space, law, Arc::clone(raised));
    }
    let (names, off) = (scenario.torque_names().to_vec(), scenario.switched_off().to_vec());
    let acting = models.into_iter().zip(names).enumerate();
    let acting = acting.map(|(k, (model, name))| ActingTorque { model, name, is_on: !off.contains(&k) });
    let acting: Vec<ActingTorque> = acting.collect();
    scenario.with_torques(acting).map_err(Raise::raise)
}

/// Returns the scenario with some event measures replaced by Python functions.
///
/// # Errors
/// `PolhodeError` if the scenario has no event of that number.
pub(crate) fn with_measures(
    scenario: Scenario,
    measures: Vec<PythonMeasure>,
    raised: &Raised,
) -> PyResult<Scenario> {
    if measures.is_empty() {
        return Ok(scenario);
    }
    let mut events = scenario.events().to_vec();
    for (place, needs_body, measure) in measures {
        let event =
            events.get_mut(place).ok_or_else(|| refused(format!("event {place} does not exist"), None))?;
        *event = measuring(event, measured(needs_body, measure, Arc::clone(raised)))?;
    }
    scenario.watching(events).map_err(Raise::raise)
}

/// Returns the event with a function as its measure.
///
/// # Errors
/// `PolhodeError` if the event is invalid.
pub(crate) fn measuring(event: &Event, measure: EventFunction) -> PyResult<Event> {
    let measure = Measure::Function(measure);
    Event::new(event.name(), measure, event.value(), event.sense(), event.action()).map_err(Raise::raise)
}

/// Returns the event function that calls a Python function.
pub(crate) fn measured(needs_body: bool, measure: PythonFunction, raised: Raised) -> EventFunction {
    let value = move |rotor: Option<&Rotor>, state: &State| {
        // The run may end only some calls after the exception.
        if has_raised(&raised) {
            return f64::NAN;
        }
        measure.number(rotor, state).unwrap_or_else(|error| {
            raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
            f64::NAN
        })
    };
    match needs_body {
        true => EventFunction::of_body(move |rotor, state| value(Some(rotor), state)),
        false => EventFunction::new(move |state| value(None, state)),
    }
}

/// Returns L, body axes.
fn in_body_axes(rotor: &Rotor, state: &State) -> [f64; 3] {
    (state.attitude.inverse() * rotor.angular_momentum_space(state)).to_array()
}

/// Returns a torque computed by a Python function for one body.
pub(crate) fn function(in_space: bool, law: PythonFunction, raised: Raised) -> TorqueModel {
    TorqueModel::function("function", move |rotor: &Rotor, state: &State| {
        match law.vector(rotor, state) {
            Ok(torque) if in_space => state.attitude.inverse() * Torque::<Space>::from_array(torque),
            Ok(torque) => Torque::<Body>::from_array(torque),
            Err(error) => {
                raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                // NaN ends the integration.
                Torque::new(f64::NAN, f64::NAN, f64::NAN)
            }
        }
    })
}

/// Returns a torque computed by a Python function for many members at once. It maps times (n,), ω
/// (n, 3), quaternions (n, 4), L along body axes (n, 3) and member numbers (n,) to torques (n, 3).
pub(crate) fn vectorized(in_space: bool, law: Py<PyAny>, raised: Raised) -> TorqueModel {
    TorqueModel::vectorized_function("function", move |asked: &[MemberState<'_>]| {
        let found = Python::attach(|py| -> PyResult<Vec<[f64; 3]>> {
            let time = PyArray1::from_iter(py, asked.iter().map(|one| one.state.time));
            let member = PyArray1::from_iter(py, asked.iter().map(|one| one.member));
            let omega = asked.iter().flat_map(|one| one.state.omega.to_array()).collect();
            let attitude = asked.iter().flat_map(|one| one.state.attitude.quaternion()).collect();
            let momentum =
                asked.iter().flat_map(|MemberState { rotor, state, .. }| in_body_axes(rotor, state));
            let (omega, attitude) = (table(py, omega, 3)?, table(py, attitude, 4)?);
            let momentum = table(py, momentum.collect(), 3)?;
            let found = law.call1(py, (time, omega, attitude, momentum, member))?;
            let found = found.extract::<PyReadonlyArray2<'_, f64>>(py)?;
            Ok(rows::<3>(&found)?.to_vec())
        });
        let turned = |(one, torque): (&MemberState<'_>, [f64; 3])| match in_space {
            true => one.state.attitude.inverse() * Torque::<Space>::from_array(torque),
            false => Torque::<Body>::from_array(torque),
        };
        match found {
            Ok(torques) => asked.iter().zip(torques).map(turned).collect(),
            Err(error) => {
                raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                // An empty result ends the integration.
                Vec::new()
            }
        }
    })
}
