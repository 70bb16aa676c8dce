//! Identification of a body from measurements of its motion.

use std::path::PathBuf;

use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use polhode::math::{Acceleration, AngularAcceleration, AngularVelocity, Attitude, Direction, Force, Torque};
use polhode::motion::torque::DragLaw;
use polhode::motion::{Motor, Wheel};
use polhode_document::layout::WIDTH;
use polhode_identify::IdentifyError;
use polhode_identify::payload::{
    EdgeKind, MotionNoise, PayloadLog, PayloadRow, WrenchNoise, WrenchSense, gravity_along,
};
use polhode_identify::read as identify;
use polhode_identify::report::IdentifyReport;
use polhode_identify::tumble::{
    AttitudeReading, Flight, FlightSearch, GyroErrors, GyroReading, TumbleOptions,
};
use polhode_source::files::Disk;
use pyo3::prelude::*;

use crate::actions::read_torques;
use crate::arrays::{matrix, numbers, rows};
use crate::error::{Raise, refused};

/// Mass, centre of mass, and the tensor about it.
type MassNumbers = (f64, [f64; 3], [[f64; 3]; 3]);

/// Result in the formats of the command, with the residuals as arrays.
#[derive(Debug, IntoPyObject)]
pub(crate) struct Identified<'py> {
    json: String,
    text: String,
    markdown: String,
    page: String,
    has_model_error: bool,
    /// Mass properties, if they are fully determined.
    body: Option<MassNumbers>,
    /// Residuals of a payload by row: fx, fy, fz, τx, τy, τz.
    wrench: Option<Bound<'py, PyArray2<f64>>>,
    /// Residuals of swing tests, one array per test.
    swings: Vec<Bound<'py, PyArray1<f64>>>,
    /// Times of the payload rows, s.
    times: Option<Bound<'py, PyArray1<f64>>>,
}

/// Identifies the body measured in a plan, from a file or a text. Paths in a text are relative to
/// `path`. Errors omit places in a text that the user did not write.
///
/// # Errors
/// `PolhodeError` if the plan cannot be read, or no body has the measured motion.
#[pyfunction]
pub(crate) fn identify_plan<'py>(
    py: Python<'py>,
    path: PathBuf,
    text: Option<String>,
    is_written: bool,
) -> PyResult<Identified<'py>> {
    let read = || match &text {
        None => identify::read(&Disk, &path),
        Some(text) => identify::from_text(&Disk, &path, text),
    };
    let found = py.detach(|| {
        let plan = read().map_err(|error| match is_written || error.path() != path {
            true => error.raise(),
            false => refused(error.message(), error.hint().as_deref()),
        })?;
        IdentifyReport::of(&plan).map_err(Raise::raise)
    })?;
    identified(py, found)
}

fn identified(py: Python<'_>, report: IdentifyReport) -> PyResult<Identified<'_>> {
    let [json, text, markdown, page] = py.detach(|| {
        let document = report.to_document();
        let json = report.to_json().to_string();
        [json, document.to_text(WIDTH), document.to_markdown(), document.to_html()]
    });
    let payload = if let IdentifyReport::Payload(payload) = &report { Some(payload) } else { None };
    let tests = if let IdentifyReport::Swing(swings) = &report { &swings.found().tests[..] } else { &[] };
    Ok(Identified {
        json,
        text,
        markdown,
        page,
        has_model_error: report.has_model_error(),
        body: report
            .body()
            .map(|body| (body.mass(), body.center_of_mass().to_array(), body.inertia().matrix())),
        wrench: payload.map(|payload| matrix(py, &payload.found().residuals)).transpose()?,
        swings: tests.iter().map(|test| PyArray1::from_slice(py, &test.left)).collect(),
        times: payload.map(|payload| PyArray1::from_slice(py, &payload.found().times)),
    })
}

/// Measurements of a flight as arrays.
#[derive(Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct FlightArrays<'py> {
    name: String,
    times: PyReadonlyArray1<'py, f64>,
    gyro: PyReadonlyArray2<'py, f64>,
    attitude_times: PyReadonlyArray1<'py, f64>,
    attitude: PyReadonlyArray2<'py, f64>,
    added: Option<[f64; 6]>,
    /// Axis and angular momentum of each wheel.
    wheels: Vec<([f64; 3], f64)>,
    torques: String,
}

/// Options of the evaluation of flights.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct FlightOptions {
    bias: bool,
    scale: bool,
    skew: bool,
    clock: bool,
    drag: String,
    gyro_noise: Option<f64>,
    attitude_noise: Option<f64>,
    outlier: f64,
}

/// Identifies a body from its flights.
///
/// # Errors
/// Same as [`identify_plan`].
#[pyfunction]
pub(crate) fn identify_flights<'py>(
    py: Python<'py>,
    title: Option<&str>,
    flights: Vec<FlightArrays<'py>>,
    options: FlightOptions,
) -> PyResult<Identified<'py>> {
    let FlightOptions { bias, scale, skew, clock, drag, gyro_noise, attitude_noise, outlier } = options;
    let drag = match drag.as_str() {
        "linear" => Some(DragLaw::Linear),
        "quadratic" => Some(DragLaw::Quadratic),
        _ => None,
    };
    let gyro = GyroErrors { bias, scale, skew, clock };
    let mut options = TumbleOptions { gyro, drag, gyro_noise, attitude_noise, ..TumbleOptions::default() };
    options.outlier = outlier;
    let flights = flights.iter().map(flight).collect::<PyResult<Vec<_>>>()?;
    let found = py
        .detach(|| IdentifyReport::of_flights(title, vec![GIVEN.to_owned()], &flights, &options))
        .map_err(Raise::raise)?;
    identified(py, found)
}

/// Source of the data as stated in a report.
const GIVEN: &str = "Arrays in Python";

fn flight(given: &FlightArrays<'_>) -> PyResult<Flight> {
    let named = |error: IdentifyError| refused(format!("{}: {error}", given.name), error.hint());
    let readings = gyro_readings(&given.times, &given.gyro)?;
    let attitudes = numbers(&given.attitude_times)?.iter().zip(rows::<4>(&given.attitude)?);
    let attitude = |(&time, wxyz): (&f64, &[f64; 4])| {
        Ok(AttitudeReading { time, attitude: Attitude::from_quaternion(*wxyz).map_err(Raise::raise)? })
    };
    let attitudes = attitudes.map(attitude).collect::<PyResult<_>>()?;
    let mut flight = Flight::new(given.name.clone(), readings, attitudes).map_err(named)?;
    if let Some(added) = given.added {
        flight = flight.with_added(added);
    }
    let wheel = |(axis, momentum): &([f64; 3], f64)| {
        Wheel::new(Direction::from_array(*axis), *momentum, Motor::HeldSpeed).map_err(Raise::raise)
    };
    flight = flight.with_wheels(given.wheels.iter().map(wheel).collect::<PyResult<_>>()?);
    Ok(flight.with_torques(read_torques(&given.torques)?))
}

fn gyro_readings(
    times: &PyReadonlyArray1<'_, f64>,
    gyro: &PyReadonlyArray2<'_, f64>,
) -> PyResult<Vec<GyroReading>> {
    let reading =
        |(&time, omega): (&f64, &[f64; 3])| GyroReading { time, omega: AngularVelocity::from_array(*omega) };
    Ok(numbers(times)?.iter().zip(rows::<3>(gyro)?).map(reading).collect())
}

/// Finds the first and the last time of each flight in a gyro log.
///
/// # Errors
/// `PolhodeError` for times that are not in ascending order.
#[pyfunction]
pub(crate) fn find_flights(
    py: Python<'_>,
    times: PyReadonlyArray1<'_, f64>,
    gyro: PyReadonlyArray2<'_, f64>,
    slowest: f64,
    shortest: f64,
    torque: f64,
) -> PyResult<Vec<[f64; 2]>> {
    let readings = gyro_readings(&times, &gyro)?;
    Flight::of_gyro("log", readings.clone()).map_err(Raise::raise)?;
    let mut search = FlightSearch { slowest, shortest, ..FlightSearch::default() };
    search.torque = torque;
    py.detach(|| polhode_identify::tumble::find_flights(&readings, &search)).map_err(Raise::raise)
}

/// Measurements of a wrist as arrays, one row per time.
#[derive(Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct WrenchArrays<'py> {
    times: PyReadonlyArray1<'py, f64>,
    omega: PyReadonlyArray2<'py, f64>,
    alpha: PyReadonlyArray2<'py, f64>,
    acceleration: PyReadonlyArray2<'py, f64>,
    /// Gravity along the sensor axes, one row per time; or one row along space axes if attitudes
    /// are given.
    gravity: PyReadonlyArray2<'py, f64>,
    attitude: Option<PyReadonlyArray2<'py, f64>>,
    force: PyReadonlyArray2<'py, f64>,
    torque: PyReadonlyArray2<'py, f64>,
}

/// Options of the evaluation of wrenches.
#[derive(Clone, Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct WrenchOptions {
    on_sensor: bool,
    bias: bool,
    /// Standard deviations of force, N, and torque, N·m.
    noise: Option<[f64; 2]>,
    covariance: Option<[[f64; 6]; 6]>,
    /// Standard deviations of ω, α and the acceleration.
    motion_noise: [f64; 3],
    kind: Option<String>,
}

/// Identifies the payload of a wrist.
///
/// # Errors
/// Same as [`identify_plan`].
#[pyfunction]
pub(crate) fn identify_wrenches<'py>(
    py: Python<'py>,
    title: Option<&str>,
    given: WrenchArrays<'py>,
    options: WrenchOptions,
) -> PyResult<Identified<'py>> {
    let log = wrench_log(&given, &options)?;
    let found = py
        .detach(|| IdentifyReport::of_payload(title, vec![GIVEN.to_owned()], &log))
        .map_err(Raise::raise)?;
    identified(py, found)
}

fn wrench_log(given: &WrenchArrays<'_>, options: &WrenchOptions) -> PyResult<PayloadLog> {
    let times = numbers(&given.times)?;
    let (omega, alpha) = (rows::<3>(&given.omega)?, rows::<3>(&given.alpha)?);
    let (acceleration, gravity) = (rows::<3>(&given.acceleration)?, rows::<3>(&given.gravity)?);
    let (force, torque) = (rows::<3>(&given.force)?, rows::<3>(&given.torque)?);
    let attitudes = given.attitude.as_ref().map(|attitude| rows::<4>(attitude)).transpose()?;
    let gravity_at = |k: usize| -> PyResult<_> {
        Ok(match (attitudes, gravity) {
            (Some(attitudes), [told, ..]) => {
                let attitude = Attitude::from_quaternion(attitudes[k]).map_err(Raise::raise)?;
                gravity_along(attitude, Acceleration::from_array(*told))
            }
            _ => Acceleration::from_array(gravity[k]),
        })
    };
    let row = |(k, &time): (usize, &f64)| {
        Ok(PayloadRow {
            time,
            omega: AngularVelocity::from_array(omega[k]),
            alpha: AngularAcceleration::from_array(alpha[k]),
            acceleration: Acceleration::from_array(acceleration[k]),
            gravity: gravity_at(k)?,
            force: Force::from_array(force[k]),
            torque: Torque::from_array(torque[k]),
        })
    };
    let all = times.iter().enumerate().map(row).collect::<PyResult<_>>()?;
    let sense = if options.on_sensor { WrenchSense::OnSensor } else { WrenchSense::OnPayload };
    let noise = match (options.noise, options.covariance) {
        (Some([force, torque]), _) => WrenchNoise::Deviations { force, torque },
        (None, Some(covariance)) => WrenchNoise::Covariance(covariance),
        (None, None) => WrenchNoise::Unknown,
    };
    let [omega, alpha, acceleration] = options.motion_noise;
    let log = PayloadLog::new(all, sense).and_then(|log| log.with_noise(noise));
    let log = log.and_then(|log| log.with_motion_noise(MotionNoise { omega, alpha, acceleration }));
    let log = log.map_err(Raise::raise)?;
    let log = if options.bias { log.with_bias() } else { log };
    Ok(match options.kind.as_deref() {
        Some("plate") => log.with_kind(EdgeKind::Lamina),
        Some(_) => log.with_kind(EdgeKind::Rod),
        None => log,
    })
}

impl Raise for IdentifyError {
    fn raise(self) -> PyErr {
        refused(&self, self.hint())
    }
}
