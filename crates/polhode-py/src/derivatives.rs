//! Derivatives of states as arrays, and propagated covariances.

use numpy::ndarray::ArrayView2;
use numpy::{PyArray1, PyArray2, PyArray3, PyReadonlyArray2, PyReadonlyArray3};
use polhode::math::{AngularVelocity, Attitude};
use polhode::motion::torque::{TorqueModel, TorqueParameter};
use polhode::motion::{CrossingDerivatives, Event, Rotor, State, StateDerivatives, TrajectoryDerivatives};
use pyo3::prelude::*;

use crate::arrays::{Signs, cube, matrix, row, table};
use crate::error::refused;
use crate::mass_derivatives::gradient_row;

/// States and their derivatives (n, 6, …): rows θ1 θ2 θ3 ω1 ω2 ω3, columns of `StateDerivatives`,
/// and parameters.
#[derive(Debug, IntoPyObject)]
pub(crate) struct Derived<'py> {
    times: Bound<'py, PyArray1<f64>>,
    omega: Bound<'py, PyArray2<f64>>,
    attitude: Bound<'py, PyArray2<f64>>,
    by_start: Bound<'py, PyArray3<f64>>,
    by_inertia: Bound<'py, PyArray3<f64>>,
    by_parameters: Bound<'py, PyArray3<f64>>,
    inertia_by_mass_properties: Bound<'py, PyArray2<f64>>,
    parameters: Vec<String>,
    events: Vec<DerivedEvent<'py>>,
}

/// Event with the derivatives of its state and time.
#[derive(Debug, IntoPyObject)]
pub(crate) struct DerivedEvent<'py> {
    name: String,
    time: f64,
    omega: Bound<'py, PyArray1<f64>>,
    attitude: Bound<'py, PyArray1<f64>>,
    by_start: Bound<'py, PyArray2<f64>>,
    by_inertia: Bound<'py, PyArray2<f64>>,
    by_parameters: Bound<'py, PyArray2<f64>>,
    time_by_start: Bound<'py, PyArray1<f64>>,
    time_by_inertia: Bound<'py, PyArray1<f64>>,
    time_by_parameters: Bound<'py, PyArray1<f64>>,
}

/// Converts the states of a motion without parameters and events.
pub(crate) fn derived_states<'py>(
    py: Python<'py>,
    rotor: &Rotor,
    states: &[StateDerivatives],
) -> PyResult<Derived<'py>> {
    derived(py, rotor, states, &[], Vec::new(), Vec::new())
}

/// Converts a whole run with derivatives with respect to the named parameters, and its events.
pub(crate) fn derived_run<'py>(
    py: Python<'py>,
    rotor: &Rotor,
    run: &TrajectoryDerivatives,
    parameters: &[String],
    events: &[Event],
) -> PyResult<Derived<'py>> {
    let event = |crossing: &CrossingDerivatives| -> PyResult<DerivedEvent<'py>> {
        let StateDerivatives { state, by_start, by_inertia } = &crossing.state;
        let name = events.get(crossing.event).map_or_else(String::new, |event| event.name().to_owned());
        Ok(DerivedEvent {
            name,
            time: state.time,
            omega: row(py, state.omega.to_array()),
            attitude: row(py, state.attitude.canonical_quaternion()),
            by_start: matrix(py, by_start)?,
            by_inertia: matrix(py, by_inertia)?,
            by_parameters: by_parameters(py, &crossing.by_parameters)?,
            time_by_start: row(py, crossing.time_by_start),
            time_by_inertia: row(py, crossing.time_by_inertia),
            time_by_parameters: PyArray1::from_slice(py, &crossing.time_by_parameters),
        })
    };
    let crossings = run.events.iter().map(event).collect::<PyResult<_>>()?;
    derived(py, rotor, &run.states, &run.by_parameters, parameters.to_vec(), crossings)
}

fn derived<'py>(
    py: Python<'py>,
    rotor: &Rotor,
    states: &[StateDerivatives],
    by_parameters: &[Vec<[f64; 6]>],
    parameters: Vec<String>,
    events: Vec<DerivedEvent<'py>>,
) -> PyResult<Derived<'py>> {
    let n = states.len();
    let mut signs = Signs::default();
    let attitude: Vec<_> = states.iter().map(|of| signs.signed(of.state.attitude.quaternion())).collect();
    let omega: Vec<_> = states.iter().map(|of| of.state.omega.to_array()).collect();
    let of = |what: fn(&StateDerivatives) -> &[[f64; 6]; 6]| {
        cube(py, states.iter().flat_map(|of| what(of).as_flattened()).copied().collect(), [n, 6, 6])
    };
    let columns = by_parameters.iter().flat_map(|columns| transposed(columns)).collect();
    Ok(Derived {
        times: PyArray1::from_iter(py, states.iter().map(|of| of.state.time)),
        omega: matrix(py, &omega)?,
        attitude: matrix(py, &attitude)?,
        by_start: of(|of| &of.by_start)?,
        by_inertia: of(|of| &of.by_inertia)?,
        by_parameters: cube(py, columns, [n, 6, parameters.len()])?,
        inertia_by_mass_properties: matrix(py, &inertia_by_mass_properties(rotor))?,
        parameters,
        events,
    })
}

/// Returns the derivatives of the inertia tensor about the pivot with respect to the mass
/// properties.
fn inertia_by_mass_properties(rotor: &Rotor) -> [[f64; 10]; 6] {
    let by_inertia = core::array::from_fn(|i| core::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
    let itself = StateDerivatives { state: NOWHERE, by_start: [[0.0; 6]; 6], by_inertia };
    itself.by_mass_properties(rotor).map(|of| gradient_row(&of))
}

/// Placeholder for derivatives that do not depend on the state.
const NOWHERE: State = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };

/// Transposes columns of six into six rows.
fn transposed(columns: &[[f64; 6]]) -> Vec<f64> {
    (0..6).flat_map(|i| columns.iter().map(move |column| column[i])).collect()
}

fn by_parameters<'py>(py: Python<'py>, columns: &[[f64; 6]]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    match columns.len() {
        0 => Ok(PyArray2::zeros(py, [6, 0], false)),
        count => table(py, transposed(columns), count),
    }
}

/// Finds torque parameters by the keys of a scenario, such as `torque[0].stiffness`.
///
/// # Errors
/// `PolhodeError` for an unknown key, with the list of known keys.
pub(crate) fn parameters(keys: &[String], torques: &[TorqueModel]) -> PyResult<Vec<TorqueParameter>> {
    let known = |torque: usize| {
        let names = torques.get(torque).map_or(&[][..], TorqueModel::parameters);
        names.iter().copied().chain(["factor"])
    };
    let one = |(k, key): (usize, &String)| {
        let named = key.strip_prefix("torque[").and_then(|rest| rest.split_once("]."));
        let found = named.and_then(|(number, name)| {
            let torque = number.parse().ok().filter(|&torque: &usize| torque < torques.len())?;
            Some(TorqueParameter { torque, name: known(torque).find(|own| *own == name)? })
        });
        found.ok_or_else(|| {
            let all = (0..torques.len())
                .flat_map(|torque| known(torque).map(move |n| format!("torque[{torque}].{n}")));
            let all: Vec<String> = all.collect();
            let hint = match &all[..] {
                [] => {
                    "the scenario has no torque: derivatives=[] gives those with respect to start and inertia"
                        .to_owned()
                }
                _ => format!("known parameters: {}", all.join(", ")),
            };
            let message =
                format!("derivatives[{k}] = {key:?} must be a parameter of a torque of the scenario");
            refused(message, Some(&hint))
        })
    };
    keys.iter().enumerate().map(one).collect()
}

/// Computes J C Jᵀ at each time: derivatives (n, 6, 6), (n, 6, 6) and (n, 6, p), covariance (12 +
/// p, 12 + p).
///
/// # Errors
/// `PolhodeError` for arrays of inconsistent shapes.
#[pyfunction]
pub(crate) fn carried_covariance<'py>(
    py: Python<'py>,
    by_start: PyReadonlyArray3<'py, f64>,
    by_inertia: PyReadonlyArray3<'py, f64>,
    by_parameters: PyReadonlyArray3<'py, f64>,
    joint: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let joint: Vec<Vec<f64>> = joint.as_array().rows().into_iter().map(|row| row.to_vec()).collect();
    let [by_start, by_inertia, by_parameters] =
        [&by_start, &by_inertia, &by_parameters].map(|by| by.as_array());
    let each = by_start.outer_iter().zip(by_inertia.outer_iter()).zip(by_parameters.outer_iter());
    let at =
        |((start, inertia), others): ((ArrayView2<'_, f64>, ArrayView2<'_, f64>), ArrayView2<'_, f64>)| {
            let square =
                |of: &ArrayView2<'_, f64>| core::array::from_fn(|i| core::array::from_fn(|j| of[[i, j]]));
            let columns: Vec<[f64; 6]> =
                others.columns().into_iter().map(|column| core::array::from_fn(|i| column[i])).collect();
            (
                StateDerivatives { state: NOWHERE, by_start: square(&start), by_inertia: square(&inertia) },
                columns,
            )
        };
    let all: Vec<_> = each.map(at).collect();
    let carried = py.detach(|| {
        all.iter().map(|(of, columns)| of.joint_covariance(columns, &joint)).collect::<Option<Vec<_>>>()
    });
    let carried =
        carried.ok_or_else(|| refused("a covariance matrix has one row and one column per number", None))?;
    cube(py, carried.as_flattened().as_flattened().to_vec(), [carried.len(), 6, 6])
}
