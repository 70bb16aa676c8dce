//! Error for features that this build does not include.

use pyo3::exceptions::PyAttributeError;
use pyo3::prelude::*;

/// Features of the default build; true if this build includes the feature.
const FEATURES: [(&str, bool); 7] = [
    ("budget", cfg!(feature = "budget")),
    ("identify", cfg!(feature = "identify")),
    ("judge", cfg!(feature = "judge")),
    ("live", cfg!(feature = "live")),
    ("png", cfg!(feature = "png")),
    ("robot", cfg!(feature = "robot")),
    ("sweep", cfg!(feature = "sweep")),
];

/// Refuses a name that the module does not have. Python calls it as the module's `__getattr__` (PEP
/// 562).
///
/// # Errors
/// `AttributeError` in all cases; it lists the missing features.
#[pyfunction(name = "__getattr__")]
pub(crate) fn missing(name: &str) -> PyResult<Py<PyAny>> {
    let left_out = FEATURES.iter().filter(|(_, is_built)| !is_built).map(|(name, _)| *name);
    let left_out = left_out.collect::<Vec<_>>().join(", ");
    let message =
        format!("this build of polhode has no {name}; it was built without the features {left_out}");
    Err(PyAttributeError::new_err(message))
}
