//! Scenarios as texts: their tables, what is noticed of them, and torques and events that Python computes.

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

/// The tables of a scenario's file, or of its text, as JSON; what it says is checked.
#[pyfunction]
pub(crate) fn scenario_tables(py: Python<'_>, path: PathBuf, text: Option<String>) -> PyResult<String> {
    let file = py.detach(|| read(path, text)).map_err(Raise::raise)?;
    let no_json = |error: &dyn std::fmt::Display| refused(format!("{}: {error}", file.path.display()), None);
    let tables: toml::Table = toml::from_str(&file.text).map_err(|error| no_json(&error.message()))?;
    serde_json::to_string(&tables).map_err(|error| no_json(&error))
}

/// What is noticed of the scenario of a text, whose files are found beside `path`.
#[pyfunction]
pub(crate) fn check_scenario(py: Python<'_>, path: PathBuf, text: String) -> PyResult<Vec<Remark>> {
    let file = py.detach(|| read(path, Some(text))).map_err(Raise::raise)?;
    Ok(remarks(file.scenario.findings()))
}

/// A scenario's file, or its text.
pub(crate) fn read(path: PathBuf, text: Option<String>) -> Result<ScenarioFile, polhode_source::FormatError> {
    match text {
        None => ScenarioFile::read(&Disk, &path),
        Some(text) => ScenarioFile::parse(&Disk, text, &path),
    }
}

/// The scenario with other times.
pub(crate) fn sampled(scenario: Scenario, times: &[f64]) -> Scenario {
    let run = scenario.run().cloned().unwrap_or_else(|| Run::evenly(0.0, 0, Method::Auto, 1e-13));
    scenario.sampled(Run { times: times.to_vec(), ..run })
}

/// A torque that Python computes: which of the scenario's it is, whether it is along space axes, and a function of time, ω, the attitude's quaternion and L
/// that gives three components.
pub(crate) type PythonTorque = (usize, bool, Py<PyAny>);

/// What an event measures, computed by Python: which of the scenario's it is, whether it depends on the body's mass, and a function of time, ω, the
/// attitude's quaternion and L that gives a number.
pub(crate) type PythonMeasure = (usize, bool, Py<PyAny>);

/// Raises what a function of Python's has raised.
pub(crate) fn heard(raised: &Raised) -> PyResult<()> {
    raised.lock().unwrap_or_else(PoisonError::into_inner).take().map_or(Ok(()), Err)
}

/// Whether one has raised something.
pub(crate) fn has_raised(raised: &Raised) -> bool {
    raised.lock().unwrap_or_else(PoisonError::into_inner).is_some()
}

/// What a function of Python's has raised.
pub(crate) type Raised = Arc<Mutex<Option<PyErr>>>;

/// The scenario with torques that Python computes in the place of some of its own.
///
/// # Errors
/// `PolhodeError` where the scenario has no such torque.
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
            models.get_mut(place).ok_or_else(|| refused(format!("there is no torque {place}"), None))?;
        *model = function(in_space, law, Arc::clone(raised));
    }
    let (names, off) = (scenario.torque_names().to_vec(), scenario.switched_off().to_vec());
    let acting = models.into_iter().zip(names).enumerate();
    let acting = acting.map(|(k, (model, name))| ActingTorque { model, name, is_on: !off.contains(&k) });
    let acting: Vec<ActingTorque> = acting.collect();
    scenario.under(acting).map_err(Raise::raise)
}

/// The scenario with events that measure what Python computes, in the place of some of its own.
///
/// # Errors
/// `PolhodeError` where the scenario has no such event.
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
            events.get_mut(place).ok_or_else(|| refused(format!("there is no event {place}"), None))?;
        *event = measuring(event, measured(needs_body, measure, Arc::clone(raised)))?;
    }
    scenario.watching(events).map_err(Raise::raise)
}

/// The event, of what a function measures.
///
/// # Errors
/// `PolhodeError` where there is no such event.
pub(crate) fn measuring(event: &Event, measure: EventFunction) -> PyResult<Event> {
    let measure = Measure::Function(measure);
    Event::new(event.name(), measure, event.value(), event.sense(), event.action()).map_err(Raise::raise)
}

/// What a function of Python's measures.
pub(crate) fn measured(needs_body: bool, measure: Py<PyAny>, raised: Raised) -> EventFunction {
    let value = move |state: &State, momentum: [f64; 3]| {
        // What ends the run may come a few calls later.
        if has_raised(&raised) {
            return f64::NAN;
        }
        let given = (state.time, state.omega.to_array(), state.attitude.quaternion(), momentum);
        let found = Python::attach(|py| measure.call1(py, given)?.extract::<f64>(py));
        found.unwrap_or_else(|error| {
            raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
            f64::NAN
        })
    };
    match needs_body {
        true => EventFunction::of_body(move |rotor, state| value(state, in_body_axes(rotor, state))),
        false => EventFunction::new(move |state| value(state, [f64::NAN; 3])),
    }
}

/// L along body axes.
fn in_body_axes(rotor: &Rotor, state: &State) -> [f64; 3] {
    (state.attitude.inverse() * rotor.angular_momentum_space(state)).to_array()
}

/// A torque that a function of Python's computes for one body.
pub(crate) fn function(in_space: bool, law: Py<PyAny>, raised: Raised) -> TorqueModel {
    TorqueModel::function("function", move |rotor: &Rotor, state: &State| {
        let momentum = in_body_axes(rotor, state);
        let given = (state.time, state.omega.to_array(), state.attitude.quaternion(), momentum);
        let found = Python::attach(|py| law.call1(py, given)?.extract::<[f64; 3]>(py));
        match found {
            Ok(torque) if in_space => state.attitude.inverse() * Torque::<Space>::from_array(torque),
            Ok(torque) => Torque::<Body>::from_array(torque),
            Err(error) => {
                raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                // It ends the integration.
                Torque::new(f64::NAN, f64::NAN, f64::NAN)
            }
        }
    })
}

/// A torque that a function of Python's computes for many members at once: of times (n,), ω (n, 3), quaternions (n, 4), L along body axes (n, 3) and the
/// numbers of the members (n,) it gives (n, 3).
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
                // None is none of theirs: it ends the integration.
                Vec::new()
            }
        }
    })
}
