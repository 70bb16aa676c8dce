//! Checks of motions computed by other programs.

use std::path::{Path, PathBuf};

use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use polhode::infer::judge::{
    AttitudeSense, DeclaredReading, JudgeError, LogError, MotionLog, OmegaAxes, QuaternionOrder, RateErrors,
    SignedAxes,
};
use polhode_judge::{FreeBody, JudgeReport, JudgedRun, judge_hint};
use polhode_scenario::read::ScenarioFile;
use polhode_source::files::Disk;
use polhode_table::log as run_log;
use polhode_table::log::{Columns, RunLog, matrix_quaternion};
use pyo3::prelude::*;

use crate::arrays::{Signs, matrix, numbers, rows};
use crate::error::{PolhodeError, Raise, refused};
use crate::finding::{Remark, remarks};

/// Motion with which a run is compared: that of a scenario, or of a free body that starts at the
/// first row. `text` is the same as in `simulate`.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Compared {
    path: PathBuf,
    text: Option<String>,
    moments: Option<[f64; 3]>,
    start_omega: Option<[f64; 3]>,
}

impl Compared {
    /// Returns the scenario, and the declarations for a log that is judged by it.
    fn scenario(
        self,
        log: &MotionLog,
        declared: DeclaredReading,
    ) -> PyResult<(ScenarioFile, DeclaredReading)> {
        if let Some(moments) = self.moments {
            let body = FreeBody::new(moments, self.start_omega)
                .map_err(|failure| refused(failure.message(), failure.hint().as_deref()))?;
            let scenario = body.scenario(log, &declared);
            let scenario = scenario.map_err(|error| refused(&error, Some(error.hint())))?;
            return Ok((scenario, FreeBody::declared(log, &declared)));
        }
        let scenario = match self.text {
            None => ScenarioFile::read(&Disk, &self.path),
            Some(text) => ScenarioFile::parse(&Disk, text, &self.path),
        };
        Ok((scenario.map_err(Raise::raise)?, declared))
    }
}

/// Conventions of a run as stated by the user; the others are detected.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Said {
    quaternion: Option<String>,
    sense: Option<String>,
    omega_axes: Option<String>,
    axes: Option<String>,
    time_origin: Option<f64>,
    step: Option<f64>,
    engine: Option<String>,
}

impl Said {
    /// Merges the statements of the user and of the run; the user's take precedence.
    fn declared(&self, says: &DeclaredReading) -> PyResult<DeclaredReading> {
        let order = self.quaternion.as_deref().map(|order| match order {
            "xyzw" => QuaternionOrder::ScalarLast,
            _ => QuaternionOrder::ScalarFirst,
        });
        let sense = self.sense.as_deref().map(|sense| match sense {
            "space_to_body" => AttitudeSense::SpaceToBody,
            _ => AttitudeSense::BodyToSpace,
        });
        let omega_axes = self.omega_axes.as_deref().map(|axes| match axes {
            "space" => OmegaAxes::Space,
            _ => OmegaAxes::Body,
        });
        let right_handed = |text: &String| {
            SignedAxes::parse(text).ok_or_else(|| {
                refused(
                    format!("axes = {text:?} must be three right-handed axes, x, y and z each once"),
                    Some("y up is \"x,z,-y\"; for left-handed axes reverse all three, which gives the same rotations"),
                )
            })
        };
        let said = DeclaredReading {
            order,
            sense,
            omega_axes,
            axes: self.axes.as_ref().map(right_handed).transpose()?,
            time_origin: self.time_origin,
            ..DeclaredReading::default()
        };
        Ok(said.or(says))
    }
}

/// Judgement: its rows as arrays, and the report in the formats of the command.
#[derive(Debug, IntoPyObject)]
pub(crate) struct Judged<'py> {
    times: Bound<'py, PyArray1<f64>>,
    attitude: Bound<'py, PyArray2<f64>>,
    omega: Option<Bound<'py, PyArray2<f64>>>,
    exact_attitude: Bound<'py, PyArray2<f64>>,
    exact_omega: Bound<'py, PyArray2<f64>>,
    attitude_error: Bound<'py, PyArray1<f64>>,
    attitude_error_vector: Bound<'py, PyArray2<f64>>,
    omega_error: Option<Bound<'py, PyArray1<f64>>>,
    kinetic_energy_error: Option<Bound<'py, PyArray1<f64>>>,
    momentum_error: Option<Bound<'py, PyArray1<f64>>>,
    momentum_direction_error: Option<Bound<'py, PyArray1<f64>>>,
    is_exact: bool,
    findings: Vec<Remark>,
    json: String,
    text: String,
    markdown: String,
    page: String,
}

/// Judges arrays: times, attitudes as quaternions or 3 × 3 matrices (nine numbers), and angular
/// velocities.
///
/// # Errors
/// `PolhodeError` for data that are not a motion, and for a motion that cannot be judged.
#[pyfunction]
pub(crate) fn judge_arrays<'py>(
    py: Python<'py>,
    compared: Compared,
    times: PyReadonlyArray1<'py, f64>,
    attitude: PyReadonlyArray2<'py, f64>,
    omega: Option<PyReadonlyArray2<'py, f64>>,
    said: Said,
) -> PyResult<Judged<'py>> {
    let is_matrix = attitude.as_array().ncols() == 9;
    let quaternions = if is_matrix { quaternions(rows(&attitude)?)? } else { rows(&attitude)?.to_vec() };
    let no_motion = |error: LogError| refused(error, None);
    let log = MotionLog::new(numbers(&times)?.to_vec(), quaternions).map_err(no_motion)?;
    let log = match omega {
        Some(omega) => log.with_omega(rows(&omega)?.to_vec()).map_err(no_motion)?,
        None => log,
    };
    let says = DeclaredReading {
        order: is_matrix.then_some(QuaternionOrder::ScalarFirst),
        ..DeclaredReading::default()
    };
    let declared = said.declared(&says)?;
    let (scenario, run) = py.detach(|| {
        let (scenario, declared) = compared.scenario(&log, declared)?;
        let run = JudgedRun::of(None, &scenario.scenario, &log, &declared, said.step)
            .map_err(|error| unjudged(&scenario, None, &error))?;
        Ok::<_, PyErr>((scenario, JudgedRun { engine: said.engine, ..run }))
    })?;
    judged(py, &scenario, run)
}

/// Judges the log of a program; `columns` uses the notation of [`Columns`].
///
/// # Errors
/// Same as [`judge_arrays`], and an error if the log cannot be read.
#[pyfunction]
pub(crate) fn judge_file<'py>(
    py: Python<'py>,
    compared: Compared,
    run: PathBuf,
    columns: Option<&str>,
    said: Said,
) -> PyResult<Judged<'py>> {
    let columns = columns.map(Columns::parse).transpose();
    let columns = columns.map_err(|error| refused(format!("columns: {error}"), Some(&error.hint())))?;
    let (scenario, run) = py.detach(|| {
        let read = run_log::read(&Disk, &run, columns.as_ref()).map_err(Raise::raise)?;
        let ignored = read.not_read();
        let RunLog { log, says, step, engine, .. } = read;
        let (scenario, declared) = compared.scenario(&log, said.declared(&says)?)?;
        let judged = JudgedRun::of(Some(&run), &scenario.scenario, &log, &declared, said.step.or(step))
            .map_err(|error| unjudged(&scenario, Some(&run), &error))?;
        Ok::<_, PyErr>((scenario, JudgedRun { engine: said.engine.or(engine), ignored, ..judged }))
    })?;
    judged(py, &scenario, run)
}

/// Returns the exception for a run that cannot be judged; `run` is its file, if it has one.
fn unjudged(scenario: &ScenarioFile, run: Option<&Path>, error: &JudgeError) -> PyErr {
    if let JudgeError::Motion(error) = error {
        return scenario.placed(error).map_or_else(|| error.clone().raise(), Raise::raise);
    }
    let path = match error {
        JudgeError::NoMotion | JudgeError::Changing | JudgeError::OnGround | JudgeError::InGimbals => {
            Some(scenario.path.as_path())
        }
        _ => run,
    };
    let path = path.map(|path| path.display().to_string());
    PolhodeError::new_err((error.to_string(), judge_hint(error), path))
}

/// Converts matrices to quaternions.
fn quaternions(matrices: &[[f64; 9]]) -> PyResult<Vec<[f64; 4]>> {
    let one = |(row, numbers): (usize, &[f64; 9])| {
        matrix_quaternion(*numbers)
            .map_err(|error| refused(format!("attitude[{row}]: {error}"), Some(error.hint())))
    };
    matrices.iter().enumerate().map(one).collect()
}

fn judged<'py>(py: Python<'py>, file: &ScenarioFile, run: JudgedRun) -> PyResult<Judged<'py>> {
    let is_exact = run.is_exact();
    let (motion, exact, errors) = (
        run.judgement.motion.clone(),
        run.judgement.reference.states().to_vec(),
        run.judgement.errors.clone(),
    );
    let (report, document) = py.detach(|| {
        let report = JudgeReport::new(&file.scenario, vec![run]);
        let document = report.to_document();
        (report, document)
    });
    let (mut signs, mut exact_signs) = (Signs::default(), Signs::default());
    let attitude: Vec<_> = motion.attitude.iter().map(|&wxyz| signs.signed(wxyz)).collect();
    let exact_attitude: Vec<_> =
        exact.iter().map(|state| exact_signs.signed(state.attitude.quaternion())).collect();
    let omega: Option<Vec<_>> =
        motion.omega.map(|omega| omega.into_iter().map(polhode::math::AngularVelocity::to_array).collect());
    let exact_omega: Vec<_> = exact.iter().map(|state| state.omega.to_array()).collect();
    let column = |of: fn(&RateErrors) -> &Vec<f64>| {
        errors.rates.as_ref().map(|rates| PyArray1::from_slice(py, of(rates)))
    };
    Ok(Judged {
        times: PyArray1::from_vec(py, motion.times),
        attitude: matrix(py, &attitude)?,
        omega: omega.map(|omega| matrix(py, &omega)).transpose()?,
        exact_attitude: matrix(py, &exact_attitude)?,
        exact_omega: matrix(py, &exact_omega)?,
        attitude_error: PyArray1::from_vec(py, errors.angles()),
        attitude_error_vector: matrix(py, &errors.attitude)?,
        omega_error: column(|rates| &rates.omega),
        kinetic_energy_error: column(|rates| &rates.kinetic_energy),
        momentum_error: column(|rates| &rates.momentum),
        momentum_direction_error: column(|rates| &rates.momentum_direction),
        is_exact,
        findings: remarks(file.scenario.findings()),
        json: report.to_json().to_string(),
        text: document.to_text(polhode_document::layout::WIDTH),
        markdown: document.to_markdown(),
        page: document.to_html(),
    })
}
