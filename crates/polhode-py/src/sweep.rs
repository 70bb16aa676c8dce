//! Sweep plans, their members, and their results, as tables by column.

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use numpy::{PyArray1, PyArrayMethods as _, PyReadonlyArray1};
use polhode_source::files::Disk;
use polhode_sweep::{Batch, BatchError, Column, Dataset, Plan, SweepError, Values};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;

use crate::arrays::{numbers, room};
use crate::error::{Raise, refused, system_number};
use crate::finding::{Remark, remarks};

/// Column for Python: name, unit, description, values, and a mask of valid values (`None` if all
/// are valid).
type Given<'py> = (String, String, String, Bound<'py, PyAny>, Option<Bound<'py, PyArray1<bool>>>);

/// Scenario with the variables that differ from member to member.
#[pyclass(frozen, name = "Plan", module = "polhode._native")]
#[derive(Clone, Debug)]
pub(crate) struct PyPlan {
    plan: Plan,
    path: PathBuf,
}

#[pymethods]
impl PyPlan {
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let plan = py.detach(|| Plan::read(&Disk, &path)).map_err(Raise::raise)?;
        Ok(Self { plan, path })
    }

    /// Creates a plan from a text; paths in it are relative to `path`.
    #[staticmethod]
    fn parse(py: Python<'_>, text: String, path: PathBuf) -> PyResult<Self> {
        let plan = py.detach(|| Plan::parse(&Disk, text, &path)).map_err(Raise::raise)?;
        Ok(Self { plan, path })
    }

    #[getter]
    fn text(&self) -> &str {
        self.plan.text()
    }

    #[getter]
    fn path(&self) -> &Path {
        &self.path
    }

    #[getter]
    fn members(&self) -> u64 {
        self.plan.members()
    }

    #[getter]
    fn digest(&self) -> String {
        self.plan.digest()
    }

    #[getter]
    fn wants_trajectories(&self) -> bool {
        self.plan.wants_trajectories()
    }

    /// Name, unit and description of each variable.
    #[getter]
    fn variables(&self) -> Vec<(String, String, String)> {
        let variables = self.plan.variables().iter();
        variables.map(|v| (v.name.clone(), v.unit.clone(), v.description.clone())).collect()
    }

    /// Findings: code, severity, message, place.
    #[getter]
    fn findings(&self) -> Vec<Remark> {
        remarks(&self.plan.findings())
    }

    /// Returns the inputs of the members from `start` to `stop`, exclusive.
    fn inputs<'py>(&self, py: Python<'py>, start: u64, stop: u64) -> PyResult<Vec<Given<'py>>> {
        let count = stop.saturating_sub(start);
        let columns = 1 + self.plan.variables().len();
        // The data exist twice: in Rust columns and in arrays.
        let both = usize::try_from(count).ok().and_then(|count| count.checked_mul(2 * columns));
        room::<f64>(&format!("the inputs of {count} members"), both)?;
        let rows = py.detach(|| polhode_sweep::inputs(&self.plan, start..stop));
        Ok(given(py, rows))
    }

    /// Simulates the members of the rows; returns the rows with the results.
    fn simulate<'py>(
        &self,
        py: Python<'py>,
        inputs: Vec<(String, Bound<'py, PyAny>)>,
    ) -> PyResult<Vec<Given<'py>>> {
        let inputs = self.taken(inputs)?;
        let rows = py.detach(|| polhode_sweep::simulate(&self.plan, &inputs)).map_err(Raise::raise)?;
        Ok(given(py, rows))
    }

    /// Returns the trajectories of the members of the rows.
    fn trajectories<'py>(
        &self,
        py: Python<'py>,
        inputs: Vec<(String, Bound<'py, PyAny>)>,
    ) -> PyResult<Vec<Given<'py>>> {
        let inputs = self.taken(inputs)?;
        let rows = py.detach(|| polhode_sweep::trajectories(&self.plan, &inputs)).map_err(Raise::raise)?;
        Ok(given(py, rows))
    }
}

impl PyPlan {
    /// Converts input columns, integers or floats, by name; the plan defines the columns.
    fn taken(&self, columns: Vec<(String, Bound<'_, PyAny>)>) -> PyResult<Batch> {
        let known = polhode_sweep::inputs(&self.plan, 0..0);
        let column = |(name, values): (String, Bound<'_, PyAny>)| {
            let values = plain_values(&name, &values)?;
            let column = known.column(&name).map_err(Raise::raise)?;
            Ok(Column { values, ..column.clone() })
        };
        let columns = columns.into_iter().map(column).collect::<PyResult<_>>()?;
        Batch::new(columns).map_err(Raise::raise)
    }
}

/// Results of a sweep in a folder, locked during the lifetime of the object.
#[pyclass(frozen, name = "Dataset", module = "polhode._native")]
#[derive(Debug)]
pub(crate) struct PyDataset {
    dataset: Dataset,
}

#[pymethods]
impl PyDataset {
    /// Opens the folder; `mode` is `create`, `resume` or `replace`.
    #[staticmethod]
    fn open(py: Python<'_>, folder: PathBuf, plan: &PyPlan, mode: &str) -> PyResult<Self> {
        let dataset = py.detach(|| match mode {
            "resume" => Dataset::resume(&folder, &plan.plan),
            "replace" => Dataset::replace(&folder, &plan.plan),
            _ => Dataset::create(&folder, &plan.plan),
        });
        Ok(Self { dataset: dataset.map_err(Raise::raise)? })
    }

    /// Returns the first member of a part, and the member after its last.
    fn rows(&self, part: u64) -> (u64, u64) {
        let rows = self.dataset.rows(part);
        (rows.start, rows.end)
    }

    #[getter]
    fn parts(&self) -> u64 {
        self.dataset.parts()
    }

    fn missing(&self, py: Python<'_>) -> PyResult<Vec<u64>> {
        py.detach(|| self.dataset.missing()).map_err(Raise::raise)
    }

    /// Stores the rows of a part; `columns` include units and descriptions.
    fn write(&self, py: Python<'_>, part: u64, columns: Vec<Given<'_>>) -> PyResult<()> {
        let rows = whole(columns)?;
        py.detach(|| self.dataset.write(part, &rows)).map_err(Raise::raise)
    }

    /// Stores the trajectories of a part.
    fn write_trajectories(&self, py: Python<'_>, part: u64, columns: Vec<Given<'_>>) -> PyResult<()> {
        let rows = whole(columns)?;
        py.detach(|| self.dataset.write_trajectories(part, &rows)).map_err(Raise::raise)
    }

    /// Computes the missing members in threads of this process, and reports the number of finished
    /// members to `progress`.
    fn compute(&self, py: Python<'_>, plan: &PyPlan, threads: usize, progress: Py<PyAny>) -> PyResult<()> {
        let (stop, why) = (AtomicBool::new(false), Mutex::new(None));
        let told = |reached: polhode_sweep::Progress| {
            let heard = Python::attach(|py| {
                py.check_signals()?;
                progress.call1(py, (reached.done, reached.members)).map(|_| ())
            });
            if let (Err(error), Ok(mut why)) = (heard, why.lock()) {
                stop.store(true, Ordering::Relaxed);
                why.get_or_insert(error);
            }
        };
        py.detach(|| self.dataset.compute(&plan.plan, threads, &stop, &told)).map_err(Raise::raise)?;
        match why.into_inner() {
            Ok(Some(error)) => Err(error),
            _ => Ok(()),
        }
    }

    /// Writes the summary of all parts; returns it as JSON and as text.
    fn finish(&self, py: Python<'_>, plan: &PyPlan, threads: usize) -> PyResult<(String, String)> {
        let swept = py.detach(|| self.dataset.finish(&plan.plan, threads)).map_err(Raise::raise)?;
        Ok((swept.summary.to_json().to_string(), swept.summary.to_text()))
    }
}

impl Raise for BatchError {
    fn raise(self) -> PyErr {
        refused(self, None)
    }
}

impl Raise for SweepError {
    /// Returns `OSError` for errors of the operating system.
    fn raise(self) -> PyErr {
        match &self {
            Self::Read { path, error } | Self::Write { path, error } => match system_number(error.kind()) {
                Some(number) => {
                    let words = error.to_string();
                    let words = words.split(" (os error").next().unwrap_or_default().to_owned();
                    PyOSError::new_err((number, words, path.display().to_string()))
                }
                None => PyOSError::new_err(self.to_string()),
            },
            _ => refused(&self, self.hint()),
        }
    }
}

fn given(py: Python<'_>, batch: Batch) -> Vec<Given<'_>> {
    batch.columns().iter().map(|column| column_given(py, column)).collect()
}

fn column_given<'py>(py: Python<'py>, column: &Column) -> Given<'py> {
    let (values, there) = match &column.values {
        Values::Whole(values) => (PyArray1::from_slice(py, values).into_any(), None),
        Values::Numbers(values) => (PyArray1::from_slice(py, values).into_any(), None),
        Values::Perhaps(values) => {
            let there = PyArray1::from_iter(py, values.iter().map(Option::is_some));
            // Missing values are masked, so this zero is never used.
            let numbers = PyArray1::from_iter(py, values.iter().map(|value| value.unwrap_or_default()));
            (numbers.into_any(), Some(there))
        }
        Values::Text(values) => match values.into_pyobject(py) {
            Ok(list) => (list, None),
            Err(_) => (py.None().into_bound(py), None),
        },
    };
    (column.name.clone(), column.unit.clone(), column.description.clone(), values, there)
}

/// Converts complete rows back from the format of `given`.
fn whole(columns: Vec<Given<'_>>) -> PyResult<Batch> {
    let column = |(name, unit, description, values, there): Given<'_>| {
        let values = match there {
            Some(there) => {
                let (values, there) = (values.extract::<PyReadonlyArray1<'_, f64>>()?, there.readonly());
                let there = there.as_slice().map_err(|error| refused(error.to_string(), None))?;
                let each = numbers(&values)?.iter().zip(there);
                Values::Perhaps(each.map(|(value, there)| there.then_some(*value)).collect())
            }
            None => plain_values(&name, &values)?,
        };
        Ok(Column { name, unit, description, values })
    };
    let columns = columns.into_iter().map(column).collect::<PyResult<_>>()?;
    Batch::new(columns).map_err(Raise::raise)
}

fn plain_values(name: &str, values: &Bound<'_, PyAny>) -> PyResult<Values> {
    if let Ok(whole) = values.extract::<PyReadonlyArray1<'_, u64>>() {
        let whole = whole.as_slice().map_err(|error| refused(error.to_string(), None))?;
        return Ok(Values::Whole(whole.to_vec()));
    }
    if let Ok(array) = values.extract::<PyReadonlyArray1<'_, f64>>() {
        return Ok(Values::Numbers(numbers(&array)?.to_vec()));
    }
    values
        .extract::<Vec<Option<String>>>()
        .map(Values::Text)
        .map_err(|_| refused(format!("column {name} must contain integers, numbers or text"), None))
}
