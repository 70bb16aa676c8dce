//! Python functions of the state of one body.

use numpy::{PyArray1, PyArrayMethods, PyUntypedArray};
use polhode::motion::{Rotor, State};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyList, PyTuple};

use crate::error::refused;

/// Python function of the state of one body.
#[derive(Debug)]
pub(crate) struct PythonFunction {
    function: Py<PyAny>,
    /// Arguments, in the order of its parameters.
    parts: Vec<Part>,
    /// Python function that converts a result of any type, or refuses it; it also takes the time.
    checked: Py<PyAny>,
}

/// Part of the state that a function takes.
#[derive(Clone, Copy, Debug)]
enum Part {
    Time,
    Omega,
    OmegaSpace,
    Quaternion,
    Momentum,
    MomentumSpace,
}

impl Part {
    fn of(name: &str) -> Option<Self> {
        match name {
            "t" => Some(Self::Time),
            "omega" => Some(Self::Omega),
            "omega_space" => Some(Self::OmegaSpace),
            "quaternion" => Some(Self::Quaternion),
            "momentum" => Some(Self::Momentum),
            "momentum_space" => Some(Self::MomentumSpace),
            _ => None,
        }
    }

    /// Returns the value in a state. Without a rotor, L is NaN.
    fn value<'py>(self, py: Python<'py>, rotor: Option<&Rotor>, state: &State) -> Bound<'py, PyAny> {
        let array = |numbers: &[f64]| PyArray1::from_slice(py, numbers).into_any();
        let momentum = || rotor.map(|rotor| rotor.angular_momentum_space(state));
        match self {
            Self::Time => PyFloat::new(py, state.time).into_any(),
            Self::Omega => array(&state.omega.to_array()),
            Self::OmegaSpace => array(&state.omega_space().to_array()),
            Self::Quaternion => array(&state.attitude.quaternion()),
            Self::Momentum => {
                let along_body = momentum().map(|momentum| state.attitude.inverse() * momentum);
                array(&along_body.map_or([f64::NAN; 3], polhode::math::Vector::to_array))
            }
            Self::MomentumSpace => array(&momentum().map_or([f64::NAN; 3], polhode::math::Vector::to_array)),
        }
    }
}

/// Reads a function, the names of its parts of the state, and the function that converts results.
impl<'a, 'py> FromPyObject<'a, 'py> for PythonFunction {
    type Error = PyErr;

    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        let (function, names, checked) = given.extract::<(Py<PyAny>, Vec<String>, Py<PyAny>)>()?;
        let part = |name: &String| {
            Part::of(name).ok_or_else(|| refused(format!("the state has no part {name}"), None))
        };
        let parts = names.iter().map(part).collect::<PyResult<_>>()?;
        Ok(Self { function, parts, checked })
    }
}

impl PythonFunction {
    fn call<'py>(
        &self,
        py: Python<'py>,
        rotor: Option<&Rotor>,
        state: &State,
    ) -> PyResult<Bound<'py, PyAny>> {
        let given = PyTuple::new(py, self.parts.iter().map(|part| part.value(py, rotor, state)))?;
        self.function.bind(py).call1(given)
    }

    /// Returns the three components that the function returns.
    pub(crate) fn vector(&self, rotor: &Rotor, state: &State) -> PyResult<[f64; 3]> {
        Python::attach(|py| {
            let found = self.call(py, Some(rotor), state)?;
            match plain(&found) {
                Some(components) => Ok(components),
                None => self.checked.bind(py).call1((found, state.time))?.extract(),
            }
        })
    }

    /// Returns the number that the function returns. Without a rotor, L is NaN.
    pub(crate) fn number(&self, rotor: Option<&Rotor>, state: &State) -> PyResult<f64> {
        Python::attach(|py| {
            let found = self.call(py, rotor, state)?;
            self.checked.bind(py).call1((found, state.time))?.extract()
        })
    }
}

/// Returns the components of an array of three doubles or a list of three floats; `None` for any
/// other type, including subclasses, which may have units or masks.
fn plain(found: &Bound<'_, PyAny>) -> Option<[f64; 3]> {
    if let Ok(list) = found.cast_exact::<PyList>() {
        let number = |k: usize| Some(list.get_item(k).ok()?.cast_exact::<PyFloat>().ok()?.value());
        return (list.len() == 3).then(|| Some([number(0)?, number(1)?, number(2)?])).flatten();
    }
    if !found.get_type().is(found.py().get_type::<PyUntypedArray>()) {
        return None;
    }
    let array = found.cast::<PyArray1<f64>>().ok()?.try_readonly().ok()?;
    array.as_slice().ok()?.try_into().ok()
}
