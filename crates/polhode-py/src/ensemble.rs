//! Many bodies, each with its own start, under the same torques.

use std::num::NonZero;
use std::path::Path;

use numpy::ndarray::Array3;
use numpy::{IntoPyArray as _, PyArray3, PyReadonlyArray1, PyReadonlyArray2};
use polhode::body::{Finding, InertiaTensor, MassProperties};
use polhode::math::{AngularVelocity, Attitude, Body, Position};
use polhode::motion::torque::TorqueModel;
use polhode::motion::{Ensemble, Member, MemberFailure, Method, MotionError, Rotor, Scenario, State};
use polhode_formats::scenario;
use pyo3::prelude::*;

use crate::arrays::{Signs, numbers, room, rows};
use crate::error::{Raise, refused};
use crate::finding::{Remark, remarks};
use crate::interrupt::Watch;
use crate::scenario::{Raised, function, has_raised, heard, vectorized};

/// A row for each member and time, t, w, x, y, z, ω1, ω2, ω3 (n, t, 8), and those that could go no further: the member, when it was
/// last good (s), and why.
type States<'py> = (Bound<'py, PyArray3<f64>>, Vec<(usize, f64, String)>);

/// Many bodies, each with its own start, under the same torques.
#[pyclass(frozen, name = "Ensemble", module = "polhode._native")]
#[derive(Clone, Debug)]
pub(crate) struct PyEnsemble {
    ensemble: Ensemble,
    findings: Vec<Finding>,
    /// By its torques that Python computes.
    raised: Raised,
    /// Whether Python computes a torque for one member at a time: it does so for no two of them at once.
    is_called: bool,
}

/// A torque that Python computes: which of the torques it is, whether it is along space axes, a function, and whether that is of many members at once.
type PythonTorque = (usize, bool, Py<PyAny>, bool);

#[pymethods]
impl PyEnsemble {
    /// Free bodies with these tensors (n, 9) about their centres of mass, ω (n, 3) and attitudes (n, 4), and `[[torque]]`s as a
    /// scenario has them, some of which `functions` take the place of.
    #[staticmethod]
    fn of(
        py: Python<'_>,
        tensors: PyReadonlyArray2<'_, f64>,
        omega: PyReadonlyArray2<'_, f64>,
        attitude: PyReadonlyArray2<'_, f64>,
        torques: &str,
        functions: Vec<PythonTorque>,
    ) -> PyResult<Self> {
        let (tensors, omega, attitude) = (rows::<9>(&tensors)?, rows::<3>(&omega)?, rows::<4>(&attitude)?);
        let (mut torques, findings) = read_torques(torques)?;
        let (raised, is_called) = (Raised::default(), functions.iter().any(|(_, _, _, many)| !many));
        for (place, in_space, law, many) in functions {
            let torque = torques.get_mut(place);
            let torque = torque.ok_or_else(|| refused(format!("there is no torque {place}"), None))?;
            let made = if many { vectorized } else { function };
            *torque = made(in_space, law, Raised::clone(&raised));
        }
        let made = py.detach(|| {
            let each = tensors.iter().zip(omega).zip(attitude).enumerate();
            let members = each.map(|(k, ((tensor, omega), wxyz))| {
                let attitude =
                    Attitude::from_quaternion(*wxyz).map_err(|error| of_member(k, &error, None))?;
                let start = State { time: 0.0, attitude, omega: AngularVelocity::from_array(*omega) };
                Ok(Member { rotor: rotor(k, tensor)?, torques: torques.clone(), start })
            });
            let members = members.collect::<PyResult<_>>()?;
            let ensemble = Ensemble::new(members)
                .map_err(|failure| of_member(failure.member, &failure.cause, failure.cause.hint()))?;
            Ok(Self { ensemble, findings, raised: Raised::clone(&raised), is_called })
        });
        heard(&raised)?;
        made
    }

    fn __len__(&self) -> usize {
        self.ensemble.len()
    }

    /// What was noticed about the torques: code, severity, message, place.
    #[getter]
    fn findings(&self) -> Vec<Remark> {
        remarks(&self.findings)
    }

    /// All members at all times, on so many threads, by the best method for each at `tolerance`.
    fn at<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
        threads: usize,
        tolerance: f64,
    ) -> PyResult<States<'py>> {
        let times = numbers(&times)?;
        let threads = NonZero::new(if self.is_called { 1 } else { threads }).unwrap_or(NonZero::<usize>::MIN);
        let (mut watch, shape) = (Watch::new(), [self.ensemble.len(), times.len(), 8]);
        room::<[f64; 8]>(
            &format!("the states of {} members at {} times", shape[0], shape[1]),
            shape[0].checked_mul(shape[1]),
        )?;
        let computed: Result<_, MotionError> = py.detach(|| {
            let mut rows = vec![[0.0; 8]; self.ensemble.len() * times.len()];
            let goes_on = &mut |_| watch.goes_on() && !has_raised(&self.raised);
            let failures =
                self.ensemble.fill(times, (Method::Auto, tolerance), threads, &mut rows, goes_on)?;
            rows.chunks_mut(times.len().max(1)).for_each(continuous);
            Ok((rows, failures))
        });
        watch.ended()?;
        heard(&self.raised)?;
        let (rows, failures) = computed.map_err(Raise::raise)?;
        let last_good = |member: usize| {
            let last = ((member + 1) * times.len()).checked_sub(1).and_then(|last| rows.get(last));
            last.map_or(0.0, |&[time, ..]| time)
        };
        let failed = |f: &MemberFailure| (f.member, last_good(f.member), f.cause.to_string());
        let failed = failures.iter().map(failed).collect();
        let rows = Array3::from_shape_vec(shape, rows.into_flattened());
        Ok((rows.map_err(|error| refused(error, None))?.into_pyarray(py), failed))
    }
}

/// q and −q are one attitude: the first has w ≥ 0, each of the others the sign nearest to the one before it.
fn continuous(rows: &mut [[f64; 8]]) {
    let mut signs = Signs::default();
    for [_, w, x, y, z, ..] in rows {
        [*w, *x, *y, *z] = signs.signed([*w, *x, *y, *z]);
    }
}

fn rotor(member: usize, tensor: &[f64; 9]) -> PyResult<Rotor> {
    let [xx, xy, xz, yx, yy, yz, zx, zy, zz] = *tensor;
    let inertia = InertiaTensor::<Body>::from_matrix([[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]]);
    // Of a free body the mass does not matter.
    let body = inertia.and_then(|inertia| MassProperties::new(1.0, Position::ZERO, inertia));
    body.map(|body| Rotor::free(&body)).map_err(|error| of_member(member, &error, error.hint()))
}

fn of_member(member: usize, error: &dyn std::error::Error, hint: Option<&str>) -> PyErr {
    refused(format!("member {member}: {error}"), hint)
}

/// The torques of a text that holds nothing else, and what was noticed about them.
pub(crate) fn read_torques(text: &str) -> PyResult<(Vec<TorqueModel>, Vec<Finding>)> {
    /// A body for them to act on. It comes last, so that lines count as the user's do.
    const BODY: &str = "\n[[body.part]]\nshape = \"tensor\"\nmass = 1\nmoments = [1, 1, 1]\n";
    if text.trim().is_empty() {
        return Ok((Vec::new(), Vec::new()));
    }
    let scenario = scenario::parse(&format!("{text}{BODY}"), Path::new("torques")).map_err(Raise::raise)?;
    let hint = Some("a scenario's other sections say what an ensemble's arguments say");
    match only_torques(&scenario) {
        true => Ok((scenario.torques().to_vec(), scenario.findings().to_vec())),
        false => {
            Err(refused("torques may hold [[torque]] tables only, of free bodies, all switched on", hint))
        }
    }
}

fn only_torques(scenario: &Scenario) -> bool {
    let start = scenario.start();
    // A [sweep] leaves nothing in the scenario but a finding.
    let is_plan = scenario.findings().iter().any(|finding| finding.code == "sweep.nominal");
    let is_plain = scenario.parts().len() == 1 && scenario.title().is_none() && !is_plan;
    let is_at_rest = start.omega == AngularVelocity::ZERO && start.attitude == Attitude::identity();
    let is_free =
        scenario.pivot().is_none() && scenario.prescribed().is_none() && scenario.suspension().is_none();
    let acts = scenario.switched_off().is_empty() && scenario.events().is_empty();
    let no_more = scenario.wheels().is_empty() && scenario.history().is_none() && scenario.run().is_none();
    let no_more = no_more && scenario.ground().is_none() && scenario.gimbals().is_none();
    is_plain && is_at_rest && is_free && acts && no_more
}
