//! Many bodies, each with its own start, under the same torques.

use std::num::NonZero;
use std::path::Path;

use numpy::ndarray::Array3;
use numpy::{IntoPyArray as _, PyArray3, PyReadonlyArray1, PyReadonlyArray2};
use polhode::{
    Advance, AngularVelocity, Attitude, Body, Ensemble, InertiaTensor, MassProperties, Member, Position,
    Rotor, Scenario, State, TorqueModel,
};
use polhode_formats::scenario;
use pyo3::prelude::*;

use crate::arrays::{numbers, rows};
use crate::error::{Raise as _, refused};
use crate::free_motion::signed;

/// Members between two looks for Ctrl-C: enough for the lanes of all threads.
const PIECE: usize = 4096;

/// ω (n, t, 3), attitudes (n, t, 4), and those that could go no further: the member, when it was last good (s), and why.
type Flights<'py> =
    (Bound<'py, PyArray3<f64>>, Bound<'py, PyArray3<f64>>, Vec<(usize, f64, String)>);

/// Many bodies, each with its own start, under the same torques.
#[pyclass(frozen, name = "Ensemble", module = "polhode._native")]
#[derive(Clone, Debug)]
pub(crate) struct PyEnsemble {
    /// Each of as many members as are computed without looking up.
    pieces: Vec<Ensemble>,
}

#[pymethods]
impl PyEnsemble {
    /// Free bodies with these tensors (n, 9) about their centres of mass, ω (n, 3) and attitudes (n, 4), and `[[torque]]`s as a
    /// scenario has them.
    #[staticmethod]
    fn of(
        py: Python<'_>,
        tensors: PyReadonlyArray2<'_, f64>,
        omega: PyReadonlyArray2<'_, f64>,
        attitude: PyReadonlyArray2<'_, f64>,
        torques: &str,
    ) -> PyResult<Self> {
        let (tensors, omega, attitude) =
            (rows::<9>(&tensors)?, rows::<3>(&omega)?, rows::<4>(&attitude)?);
        let torques = read_torques(torques)?;
        py.detach(|| {
            let mut pieces = Vec::new();
            let mut piece = Vec::with_capacity(PIECE.min(tensors.len()));
            for (k, ((tensor, omega), wxyz)) in tensors.iter().zip(omega).zip(attitude).enumerate() {
                let start = State {
                    time: 0.0,
                    attitude: Attitude::from_quaternion(*wxyz).map_err(|error| of_member(k, &error))?,
                    omega: AngularVelocity::from_array(*omega),
                };
                piece.push(Member { rotor: rotor(k, tensor)?, torques: torques.clone(), start });
                if piece.len() == PIECE || k + 1 == tensors.len() {
                    let whole = std::mem::replace(&mut piece, Vec::with_capacity(PIECE));
                    let before = PIECE * pieces.len();
                    let ensemble = Ensemble::new(whole)
                        .map_err(|failure| of_member(before + failure.member, &failure.cause))?;
                    pieces.push(ensemble);
                }
            }
            Ok(Self { pieces })
        })
    }

    fn __len__(&self) -> usize {
        self.pieces.iter().map(Ensemble::len).sum()
    }

    /// All members at all times, on so many threads; `step` (s) asks for Runge–Kutta, else the best method for each at `tolerance`.
    fn at<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
        threads: usize,
        step: Option<f64>,
        tolerance: f64,
    ) -> PyResult<Flights<'py>> {
        let times = numbers(&times)?;
        let advance = step.map_or(Advance::Auto { tolerance }, |step| Advance::RungeKutta4 { step });
        let threads = NonZero::new(threads).unwrap_or(NonZero::<usize>::MIN);
        let count = self.__len__() * times.len();
        let (mut omega, mut attitude) = (Vec::with_capacity(3 * count), Vec::with_capacity(4 * count));
        let mut failures = Vec::new();
        for (k, piece) in self.pieces.iter().enumerate() {
            py.check_signals()?;
            let flights = py.detach(|| {
                let flights = piece.at(times, advance, threads)?;
                for states in flights.states.chunks(times.len().max(1)) {
                    let mut before = None;
                    for state in states {
                        omega.extend(state.omega.to_array());
                        attitude.extend(signed(state.attitude, &mut before));
                    }
                }
                Ok(flights)
            });
            let flights = flights.map_err(|error: polhode::MotionError| error.raise())?;
            for failure in flights.failures {
                let last = ((failure.member + 1) * times.len()).checked_sub(1);
                let time = last.and_then(|last| flights.states.get(last)).map_or(0.0, |state| state.time);
                failures.push((PIECE * k + failure.member, time, failure.cause.to_string()));
            }
        }
        let shaped = |numbers, columns| cube(py, numbers, [self.__len__(), times.len(), columns]);
        Ok((shaped(omega, 3)?, shaped(attitude, 4)?, failures))
    }
}

fn cube(py: Python<'_>, numbers: Vec<f64>, shape: [usize; 3]) -> PyResult<Bound<'_, PyArray3<f64>>> {
    let cube = Array3::from_shape_vec(shape, numbers).map_err(|error| refused(error.to_string(), None))?;
    Ok(cube.into_pyarray(py))
}

fn rotor(member: usize, tensor: &[f64; 9]) -> PyResult<Rotor> {
    let [xx, xy, xz, yx, yy, yz, zx, zy, zz] = *tensor;
    let inertia = InertiaTensor::<Body>::from_matrix([[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]]);
    // Of a free body the mass does not matter.
    let body = inertia.and_then(|inertia| MassProperties::new(1.0, Position::ZERO, inertia));
    body.map(|body| Rotor::free(&body)).map_err(|error| of_member(member, &error))
}

fn of_member(member: usize, error: &dyn std::error::Error) -> PyErr {
    refused(format!("member {member}: {error}"), None)
}

/// The torques of a text that holds nothing else.
fn read_torques(text: &str) -> PyResult<Vec<TorqueModel>> {
    /// A body for them to act on. It comes last, so that lines count as the user's do.
    const BODY: &str = "\n[[body.part]]\nshape = \"tensor\"\nmass = 1\nmoments = [1, 1, 1]\n";
    if text.trim().is_empty() {
        return Ok(Vec::new());
    }
    let scenario = scenario::parse(&format!("{text}{BODY}"), Path::new("torques")).map_err(|error| error.raise())?;
    let hint = Some("a scenario's other sections say what an ensemble's arguments say");
    match only_torques(&scenario) {
        true => Ok(scenario.torques),
        false => Err(refused("torques may hold [[torque]] tables only, of free bodies, all switched on", hint)),
    }
}

fn only_torques(scenario: &Scenario) -> bool {
    let Scenario { parts, start, pivot, switched_off, wheels, events, prescribed, hanging, shaft, run, .. } = scenario;
    parts.len() == 1
        && start.omega == AngularVelocity::ZERO
        && start.attitude == Attitude::identity()
        && (pivot.is_none() && hanging.is_none() && shaft.is_none() && prescribed.is_none())
        && (switched_off.is_empty() && wheels.is_empty() && events.is_empty() && run.is_none())
}
