//! Ensembles: many bodies, each with its own initial state.

use std::num::NonZero;
use std::path::PathBuf;

use numpy::ndarray::Array3;
use numpy::{IntoPyArray as _, PyArray3, PyReadonlyArray1, PyReadonlyArray2};
use polhode::body::{Finding, InertiaTensor, MassProperties};
use polhode::math::{AngularVelocity, Attitude, Body, Position};
use polhode::motion::{
    Ensemble, EnsembleOutcome, Member, MemberCrossing, MemberFailure, MemberStop, Method, MotionError, Rotor,
    State,
};
use pyo3::prelude::*;

use crate::actions::{Functions, Placed, PythonActions, PythonFunctions, SharedActions};
use crate::arrays::{Signs, numbers, room, rows};
use crate::error::{Raise, raised_by, refused};
use crate::finding::{Remark, remarks};
use crate::interrupt::Watch;
use crate::scenario::{self, has_raised, heard};
use crate::threads::available_threads;

/// Default tolerance of a run.
const TOLERANCE: f64 = 1e-13;

/// States of all members, (n, t, 8): t, w, x, y, z, ω1, ω2, ω3. Then the members that failed
/// (number, last good time in s, reason), the members stopped by an event (number, event, time in
/// s), and all events.
type States<'py> =
    (Bound<'py, PyArray3<f64>>, Vec<(usize, f64, String)>, Vec<(usize, Option<String>, f64)>, Vec<Happened>);

/// Event of a member: member, name, time in s, true if its measure was rising, ω and attitude.
type Happened = (usize, String, f64, bool, [f64; 3], [f64; 4]);

/// Bodies: optional masses (n,) and centres of mass (n, 3), and tensors (n, 9).
type Bodies<'py> =
    (Option<(PyReadonlyArray1<'py, f64>, PyReadonlyArray2<'py, f64>)>, PyReadonlyArray2<'py, f64>);

/// Many bodies, each with its own initial state.
#[pyclass(frozen, name = "Ensemble", module = "polhode._native")]
#[derive(Clone, Debug)]
pub(crate) struct PyEnsemble {
    ensemble: Ensemble,
    findings: Vec<Finding>,
    functions: Functions,
}

#[pymethods]
impl PyEnsemble {
    /// Creates an ensemble of bodies with ω (n, 3) and attitudes (n, 4), held at pivots (n, 3) if
    /// given. The second element of `actions` (n,) assigns actions to members; without it all
    /// members share the first ones.
    #[staticmethod]
    fn of(
        py: Python<'_>,
        bodies: Bodies<'_>,
        pivots: Option<PyReadonlyArray2<'_, f64>>,
        omega: PyReadonlyArray2<'_, f64>,
        attitude: PyReadonlyArray2<'_, f64>,
        actions: (Vec<PythonActions>, Option<Vec<usize>>),
        functions: PythonFunctions,
    ) -> PyResult<Self> {
        let (known, tensors) = &bodies;
        let tensors = rows::<9>(tensors)?;
        let known =
            known.as_ref().map(|(masses, centers)| PyResult::Ok((numbers(masses)?, rows::<3>(centers)?)));
        let known = known.transpose()?;
        let (omega, attitude) = (rows::<3>(&omega)?, rows::<4>(&attitude)?);
        let pivots = pivots.as_ref().map(rows::<3>).transpose()?;
        let ((actions, which), functions) = (actions, Functions::new(functions));
        let mut watch = Watch::new();
        let made = py.detach(|| {
            let read = |actions: &PythonActions| SharedActions::read(actions, pivots.is_some(), &functions);
            let actions = actions.iter().map(read).collect::<PyResult<Vec<_>>>()?;
            let of_member = |k: usize| {
                let of_it = which.as_ref().map_or(Some(0), |which| which.get(k).copied());
                of_it
                    .and_then(|which| actions.get(which))
                    .ok_or_else(|| refused("the member has no torques", None))
            };
            let body = |k: usize, tensor: &[f64; 9]| {
                let place = known.and_then(|(masses, centers)| Some((*masses.get(k)?, *centers.get(k)?)));
                // The mass of a free body does not affect its rotation.
                let (mass, center) = place.unwrap_or((1.0, [0.0; 3]));
                body(mass, center, tensor).map_err(|error| refused_member(k, &error, error.hint()))
            };
            let each = tensors.iter().zip(omega).zip(attitude).enumerate();
            let mut last: Option<(usize, Rotor)> = None;
            let members = each.map(|(k, ((tensor, omega), wxyz))| {
                go_on(k, &mut watch)?;
                let shared = of_member(k)?;
                let pivot = |k: usize| {
                    let pivot =
                        pivots.and_then(|pivots| pivots.get(k)).map(|pivot| Position::from_array(*pivot));
                    PyResult::Ok(pivot.or(of_member(k)?.actions.pivot()))
                };
                let mass = |k: usize| known.map(|(masses, centers)| (masses.get(k), centers.get(k)));
                // Members often share a body, and its principal axes are known then.
                let is_same = |other: usize| {
                    PyResult::Ok(
                        tensors.get(other) == Some(tensor)
                            && mass(other) == mass(k)
                            && pivot(other)? == pivot(k)?,
                    )
                };
                let rotor = match last.take() {
                    Some((other, rotor)) if is_same(other)? => rotor,
                    _ => match (body(k, tensor)?, pivot(k)?) {
                        (body, None) => Rotor::free(&body),
                        (_, Some(_)) if known.is_none() => return Err(massless()),
                        (body, Some(pivot)) => Rotor::pivoted(&body, pivot),
                    },
                };
                last = Some((k, rotor.clone()));
                let attitude =
                    Attitude::from_quaternion(*wxyz).map_err(|error| refused_member(k, &error, None))?;
                let start = State { time: 0.0, attitude, omega: AngularVelocity::from_array(*omega) };
                let rotor = shared.actions.with_wheels(rotor, start.omega);
                Ok(shared.on(rotor.map_err(|error| raised_by(&format!("member {k}: "), error))?, start))
            });
            let members = members.collect::<PyResult<_>>()?;
            Self::new(members, actions.iter().flat_map(|shared| shared.actions.findings()), &functions)
        });
        watch.ended()?;
        heard(&functions.raised)?;
        made
    }

    /// Creates an ensemble of scenarios: their paths, texts, and assigned Python functions.
    #[staticmethod]
    fn of_scenarios(
        py: Python<'_>,
        scenarios: Vec<(PathBuf, String, Placed)>,
        functions: PythonFunctions,
    ) -> PyResult<Self> {
        let functions = Functions::new(functions);
        let mut watch = Watch::new();
        let made = py.detach(|| {
            let mut findings = Vec::new();
            let members = scenarios.into_iter().enumerate().map(|(k, (path, text, placed))| {
                go_on(k, &mut watch)?;
                let read = scenario::read(path, Some(text));
                let scenario = read.map_err(|error| raised_by(&format!("member {k}: "), error))?.scenario;
                let own =
                    scenario.run().filter(|run| run.method != Method::Auto || run.tolerance != TOLERANCE);
                if own.is_some() {
                    let hint = Some("delete it: Ensemble.at has an argument tolerance and chooses the method of each member");
                    return Err(refused(
                        format!("member {k}: its [run] sets a method or a tolerance"),
                        hint,
                    ));
                }
                findings.extend_from_slice(scenario.findings());
                let mut member =
                    scenario.member().map_err(|error| refused_member(k, &error, error.hint()))?;
                functions.replace(&mut member.torques, &mut member.events, &placed)?;
                Ok(member)
            });
            let members = members.collect::<PyResult<_>>()?;
            Self::new(members, &findings, &functions)
        });
        watch.ended()?;
        heard(&functions.raised)?;
        made
    }

    fn __len__(&self) -> usize {
        self.ensemble.len()
    }

    /// Findings without duplicates: code, severity, message, place.
    #[getter]
    fn findings(&self) -> Vec<Remark> {
        remarks(&self.findings)
    }

    /// Computes all members at all times on `threads` threads, by the method named or, for "auto",
    /// each by its best one, at `tolerance`. Without a number, the threads are as many as the process
    /// may use.
    fn at<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
        threads: Option<usize>,
        tolerance: f64,
        method: &str,
    ) -> PyResult<States<'py>> {
        let times = numbers(&times)?;
        let named = [Method::Auto, Method::Exact, Method::Taylor, Method::Dop853];
        let method = named.into_iter().find(|known| known.name() == method);
        let method = method.ok_or_else(|| refused("the method is unknown", None))?;
        let Functions { raised, is_called, .. } = &self.functions;
        // The system needs longer to count its processors than a body to move.
        let can_share = !*is_called && self.ensemble.most_threads() > 1;
        let threads = if can_share { threads.unwrap_or_else(available_threads) } else { 1 };
        let threads = NonZero::new(threads).unwrap_or(NonZero::<usize>::MIN);
        let (mut watch, shape) = (Watch::new(), [self.ensemble.len(), times.len(), 8]);
        room::<[f64; 8]>(
            &format!("the states of {} members at {} times", shape[0], shape[1]),
            shape[0].checked_mul(shape[1]),
        )?;
        let computed: Result<_, MotionError> = py.detach(|| {
            let mut rows = vec![[0.0; 8]; self.ensemble.len() * times.len()];
            let goes_on = &mut |_| watch.goes_on() && !has_raised(raised);
            let outcome = self.ensemble.fill(times, (method, tolerance), threads, &mut rows, goes_on)?;
            rows.chunks_mut(times.len().max(1)).for_each(continuous);
            Ok((rows, outcome))
        });
        watch.ended()?;
        heard(raised)?;
        let (rows, EnsembleOutcome { failures, stops, crossings }) = computed.map_err(Raise::raise)?;
        let last_good = |member: usize| {
            let last = ((member + 1) * times.len()).checked_sub(1).and_then(|last| rows.get(last));
            last.map_or(0.0, |&[time, ..]| time)
        };
        let failed = |f: &MemberFailure| (f.member, last_good(f.member), f.cause.to_string());
        let failed = failures.iter().map(failed).collect();
        let stopped = |stop: &MemberStop| {
            let member = self.ensemble.members().get(stop.member);
            let event = member.and_then(|member| member.events.get(stop.event));
            (stop.member, event.map(|event| event.name().to_owned()), stop.time)
        };
        let stopped = stops.iter().map(stopped).collect();
        let happened = |MemberCrossing { member, crossing }: MemberCrossing| {
            let state = crossing.state;
            let (omega, attitude) = (state.omega.to_array(), state.attitude.canonical_quaternion());
            (member, crossing.name, state.time, crossing.rising, omega, attitude)
        };
        let happened = crossings.into_iter().map(happened).collect();
        let rows = Array3::from_shape_vec(shape, rows.into_flattened());
        let rows = rows.map_err(|error| refused(error, None))?;
        Ok((rows.into_pyarray(py), failed, stopped, happened))
    }
}

impl PyEnsemble {
    fn new<'a>(
        members: Vec<Member>,
        findings: impl IntoIterator<Item = &'a Finding>,
        functions: &Functions,
    ) -> PyResult<Self> {
        let ensemble = Ensemble::new(members)
            .map_err(|failure| refused_member(failure.member, &failure.cause, failure.cause.hint()))?;
        let mut each: Vec<Finding> = Vec::new();
        for finding in findings {
            if !each.contains(finding) {
                each.push(finding.clone());
            }
        }
        Ok(Self { ensemble, findings: each, functions: functions.clone() })
    }
}

/// Looks for a signal at some of the members.
///
/// # Errors
/// An error for which the signal's exception is raised instead.
fn go_on(member: usize, watch: &mut Watch) -> PyResult<()> {
    if member.is_multiple_of(64) && !watch.goes_on() {
        return Err(refused("interrupted", None));
    }
    Ok(())
}

/// Chooses the signs of quaternions: the first gets w ≥ 0, each other one the sign closest to its
/// predecessor.
fn continuous(rows: &mut [[f64; 8]]) {
    let mut signs = Signs::default();
    for [_, w, x, y, z, ..] in rows {
        [*w, *x, *y, *z] = signs.signed([*w, *x, *y, *z]);
    }
}

fn body(
    mass: f64,
    center: [f64; 3],
    tensor: &[f64; 9],
) -> Result<MassProperties<Body>, polhode::body::BodyError> {
    let [xx, xy, xz, yx, yy, yz, zx, zy, zz] = *tensor;
    let inertia = InertiaTensor::<Body>::from_matrix([[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]])?;
    MassProperties::new(mass, Position::from_array(center), inertia)
}

fn refused_member(member: usize, error: &dyn std::error::Error, hint: Option<&str>) -> PyErr {
    refused(format!("member {member}: {error}"), hint)
}

fn massless() -> PyErr {
    let hint = Some("give body: mass properties contain both");
    refused("a body that is held at a pivot needs its mass and its centre of mass", hint)
}
