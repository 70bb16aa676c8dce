//! Free motions of many bodies in one call, each at its own times: the batches of JAX and PyTorch.

use numpy::ndarray::{Array3, Array4};
use numpy::{IntoPyArray as _, PyArray3, PyArray4, PyReadonlyArray2};
use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{AngularVelocity, Attitude, Body, Position};
use polhode::motion::{FreeMotion, FreeMotionDerivatives, Rotor, State, StateDerivatives};
use pyo3::prelude::*;

use crate::arrays::{Signs, rows};
use crate::error::refused;
use crate::interrupt::Watch;

/// States (b, n, 7), w, x, y, z and ω; derivatives (b, n, 6, 6) with respect to the start and to the
/// inertia tensor, without elements if they were not requested.
type Motions<'py> = (Bound<'py, PyArray3<f64>>, [Bound<'py, PyArray4<f64>>; 2]);

/// Computes the free motions of bodies with tensors (b, 9), attitudes (b, 4) and ω (b, 3) at times
/// (b, n). Returns `None` if a body, a start or a time is not valid.
#[pyfunction]
pub(crate) fn free_motions<'py>(
    py: Python<'py>,
    inertia: PyReadonlyArray2<'py, f64>,
    attitude: PyReadonlyArray2<'py, f64>,
    omega: PyReadonlyArray2<'py, f64>,
    times: PyReadonlyArray2<'py, f64>,
    with_derivatives: bool,
) -> PyResult<Option<Motions<'py>>> {
    let (tensors, attitudes, omegas) = (rows::<9>(&inertia)?, rows::<4>(&attitude)?, rows::<3>(&omega)?);
    let (count, each) = (tensors.len(), times.as_array().ncols());
    let times = times.as_slice().map_err(|error| refused(error.to_string(), None))?;
    let mut states = Vec::with_capacity(count * each);
    let mut derivatives = [Vec::new(), Vec::new()];
    let mut watch = Watch::new();
    let is_known = py.detach(|| {
        for (k, ((tensor, wxyz), omega)) in tensors.iter().zip(attitudes).zip(omegas).enumerate() {
            let times = times.get(k * each..(k + 1) * each)?;
            let found = motion(tensor, *wxyz, *omega, times, with_derivatives)?;
            let mut signs = Signs::default();
            for StateDerivatives { state, by_start, by_inertia } in found {
                let [w, x, y, z] = signs.signed(state.attitude.quaternion());
                let [a, b, c] = state.omega.to_array();
                states.extend([w, x, y, z, a, b, c]);
                if with_derivatives {
                    derivatives[0].extend_from_slice(by_start.as_flattened());
                    derivatives[1].extend_from_slice(by_inertia.as_flattened());
                }
            }
            if !watch.goes_on() {
                break;
            }
        }
        Some(())
    });
    watch.ended()?;
    if is_known.is_none() {
        return Ok(None);
    }
    let states = Array3::from_shape_vec([count, each, 7], states).map_err(|error| refused(error, None))?;
    let shape = if with_derivatives { [count, each, 6, 6] } else { [0; 4] };
    let [by_start, by_inertia] = derivatives.map(|all| Array4::from_shape_vec(shape, all));
    let by_start = by_start.map_err(|error| refused(error, None))?.into_pyarray(py);
    let by_inertia = by_inertia.map_err(|error| refused(error, None))?.into_pyarray(py);
    Ok(Some((states.into_pyarray(py), [by_start, by_inertia])))
}

/// Returns the states of one body, with their derivatives if they are wanted.
fn motion(
    tensor: &[f64; 9],
    wxyz: [f64; 4],
    omega: [f64; 3],
    times: &[f64],
    with_derivatives: bool,
) -> Option<Vec<StateDerivatives>> {
    let [xx, xy, xz, yx, yy, yz, zx, zy, zz] = *tensor;
    let inertia = InertiaTensor::<Body>::from_matrix([[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]]).ok()?;
    let rotor = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia).ok()?);
    let attitude = Attitude::from_quaternion(wxyz).ok()?;
    let start = State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) };
    if !with_derivatives {
        let motion = FreeMotion::of(&rotor, start).ok()?;
        motion.require(times).ok()?;
        let states = times.iter().map(|time| motion.at(*time));
        let none = [[0.0; 6]; 6];
        return Some(
            states.map(|state| StateDerivatives { state, by_start: none, by_inertia: none }).collect(),
        );
    }
    let motion = FreeMotionDerivatives::of(&rotor, start).ok()?;
    motion.motion().require(times).ok()?;
    let found = motion.at_times(times);
    (!found.iter().any(|of| of.by_start[0][0].is_nan())).then_some(found)
}
