//! Free motion in closed form.

use numpy::{PyArray1, PyArray2, PyArrayMethods as _, PyReadonlyArray1};
use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{AngularVelocity, Attitude, Body, Position};
use polhode::motion::{FreeMotion, FreeMotionDerivatives, Method, Rotor, Run, State, Trajectory};
use polhode::observe::FreeRegime;
use polhode_document::VERSION;
use polhode_scenario::report::{PageInput, PageSubject, SpinReport, page};
use pyo3::prelude::*;

use crate::arrays::{ErrorColumns, Signs, error_columns, numbers, row, rows_mut};
use crate::derivatives::{Derived, derived_states};
use crate::error::{Raise, refused};
use crate::interrupt::Watch;
use crate::mass_properties::principal_axes;

/// Number of states computed together, small enough to stay in the cache until their signs are
/// chosen.
const PIECE: usize = 256;

/// Smallest number of times for which other Python threads may run meanwhile; about 10 µs of work.
const DETACHED: usize = 512;

/// Angular velocity and attitude at one time.
type State1<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

/// Times, angular velocities and attitudes.
type Few<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>);

/// Torque-free motion of a body.
#[pyclass(frozen, name = "FreeMotion", module = "polhode._native")]
#[derive(Clone, Debug)]
pub(crate) struct PyFreeMotion {
    motion: FreeMotion,
    /// Inertia tensor; `None` for moments that violate the triangle inequality.
    inertia: Option<InertiaTensor<Body>>,
}

#[pymethods]
impl PyFreeMotion {
    /// Creates a motion from moments along the body axes; unphysical moments are accepted only if
    /// `unphysical`.
    #[staticmethod]
    fn of_moments(moments: [f64; 3], omega: [f64; 3], wxyz: [f64; 4], unphysical: bool) -> PyResult<Self> {
        let inertia = match InertiaTensor::diagonal(moments) {
            Err(error) if !unphysical => return Err(error.raise()),
            inertia => inertia.ok(),
        };
        let motion = FreeMotion::of_moments(moments, start(omega, wxyz)?).map_err(Raise::raise)?;
        Self::in_range(motion, inertia)
    }

    /// Creates a motion from a tensor about the centre of mass.
    #[staticmethod]
    fn of_tensor(tensor: [[f64; 3]; 3], omega: [f64; 3], wxyz: [f64; 4]) -> PyResult<Self> {
        let inertia = InertiaTensor::from_matrix(tensor).map_err(Raise::raise)?;
        let motion = FreeMotion::of(&rotor(inertia)?, start(omega, wxyz)?).map_err(Raise::raise)?;
        Self::in_range(motion, Some(inertia))
    }

    /// Returns ω (3,) and the attitude (4,) at a time.
    fn at_time<'py>(&self, py: Python<'py>, time: f64) -> PyResult<State1<'py>> {
        self.motion.require(&[time]).map_err(Raise::raise)?;
        let state = self.motion.at(time);
        Ok((row(py, state.omega.to_array()), row(py, Signs::default().signed(state.attitude.quaternion()))))
    }

    /// Returns times (n,), ω (n, 3) and attitudes (n, 4) in new arrays; for a small number of
    /// times.
    fn few<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Few<'py>> {
        let given = numbers(&times)?;
        let [omega, attitude] = [3, 4].map(|columns| PyArray2::zeros(py, [given.len(), columns], false));
        let given = PyArray1::from_slice(py, given);
        self.fill(py, times, omega.clone(), attitude.clone())?;
        Ok((given, omega, attitude))
    }

    /// Writes ω (n, 3) and attitudes (n, 4) at the times into given arrays.
    fn fill<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
        omega: Bound<'py, PyArray2<f64>>,
        attitude: Bound<'py, PyArray2<f64>>,
    ) -> PyResult<()> {
        let times = numbers(&times)?;
        self.motion.require(times).map_err(Raise::raise)?;
        let (mut omega, mut attitude) = (omega.try_readwrite()?, attitude.try_readwrite()?);
        let (omega, attitude) = (rows_mut::<3>(&mut omega)?, rows_mut::<4>(&mut attitude)?);
        let mut signs = Signs::default();
        let places = omega.chunks_mut(PIECE).zip(attitude.chunks_mut(PIECE));
        let mut pieces = times.chunks(PIECE).zip(places).map(|(piece, (omega, attitude))| {
            self.motion.fill_rows(piece, omega, attitude);
            signs.sign(attitude);
        });
        // Short work keeps the lock: releasing it would take longer.
        if times.len() < DETACHED {
            pieces.for_each(drop);
            return Ok(());
        }
        let mut watch = Watch::new();
        py.detach(|| pieces.all(|()| watch.goes_on()));
        watch.ended()
    }

    /// Returns error estimates of the states at the times.
    fn error<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<ErrorColumns<'py>> {
        let times = numbers(&times)?;
        self.motion.require(times).map_err(Raise::raise)?;
        Ok(error_columns(py, &py.detach(|| self.motion.global_error(times))))
    }

    /// Returns states at the times with derivatives with respect to the initial state and the
    /// inertia tensor.
    fn derivatives<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Derived<'py>> {
        let times = numbers(&times)?;
        self.motion.require(times).map_err(Raise::raise)?;
        let Some(inertia) = self.inertia else {
            return Err(refused(
                "moments that are not physical have no derivatives with respect to an inertia tensor",
                Some("leave allow_unphysical out to see why they are not physical"),
            ));
        };
        let rotor = rotor(inertia)?;
        let motion = FreeMotionDerivatives::of(&rotor, self.motion.start()).map_err(Raise::raise)?;
        let mut states = Vec::with_capacity(times.len());
        let mut watch = Watch::new();
        py.detach(|| {
            for piece in times.chunks(PIECE) {
                states.extend(motion.at_times(piece));
                if !watch.goes_on() {
                    break;
                }
            }
        });
        watch.ended()?;
        if let Some(unknown) = states.iter().find(|of| of.by_start[0][0].is_nan()) {
            return Err(refused(
                format!("at t = {} s the derivatives are too large for a double", unknown.state.time),
                Some("near the intermediate axis they grow as exp(growth_rate * t): use earlier times"),
            ));
        }
        derived_states(py, &rotor, &states)
    }

    #[getter]
    fn regime(&self) -> &'static str {
        self.motion.regime().name()
    }

    #[getter]
    fn regime_in_words(&self) -> &'static str {
        self.motion.regime().description()
    }

    #[getter]
    fn period(&self) -> Option<f64> {
        self.motion.period()
    }

    #[getter]
    fn flip_interval(&self) -> Option<f64> {
        FreeRegime::of_motion(&self.motion).flip_interval
    }

    #[getter]
    fn kinetic_energy(&self) -> f64 {
        self.motion.kinetic_energy()
    }

    /// Angular momentum, space axes, kg·m²/s.
    #[getter]
    fn momentum<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        row(py, self.motion.momentum().to_array())
    }

    #[getter]
    fn moments<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        row(py, self.motion.principal().moments())
    }

    #[getter]
    fn axes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        principal_axes(py, self.motion.principal())
    }

    /// Returns the JSON that `polhode spin --json` prints.
    fn json(&self, py: Python<'_>) -> String {
        py.detach(|| SpinReport::new(None, self.motion).to_json().to_string())
    }

    /// Returns the text that `polhode spin` prints.
    fn text(&self, py: Python<'_>) -> String {
        py.detach(|| SpinReport::new(None, self.motion).to_text())
    }

    /// Returns the page of the motion from 0 to `duration`, s.
    fn page(&self, py: Python<'_>, duration: f64) -> PyResult<String> {
        /// Number of samples of the page.
        const SAMPLES: usize = 2001;
        py.detach(|| {
            let times = Run::evenly(duration, SAMPLES, Method::Exact, 0.0).times;
            let trajectory = Trajectory::of_motion_with_error(self.motion, &times).map_err(Raise::raise)?;
            Ok(page(&PageInput {
                title: "Free motion",
                source: &format!("polhode {VERSION} in Python"),
                scenario_text: None,
                subject: PageSubject::Moments(self.motion.principal()),
                trajectory: &trajectory,
                explanation: None,
                whole: true,
            }))
        })
    }
}

impl PyFreeMotion {
    /// Creates the object; an error if the energy or the angular momentum is not finite.
    fn in_range(motion: FreeMotion, inertia: Option<InertiaTensor<Body>>) -> PyResult<Self> {
        if motion.kinetic_energy().is_finite() && motion.momentum().norm().is_finite() {
            return Ok(Self { motion, inertia });
        }
        let message = "the energy or |L| of this motion is too large for a double (at most 1.8e308)";
        Err(refused(message, Some("check the units and the exponents")))
    }
}

/// Returns a free rotor with mass 1 kg; the mass does not affect its rotation.
fn rotor(inertia: InertiaTensor<Body>) -> PyResult<Rotor> {
    MassProperties::new(1.0, Position::ZERO, inertia).map(|body| Rotor::free(&body)).map_err(Raise::raise)
}

fn start(omega: [f64; 3], wxyz: [f64; 4]) -> PyResult<State> {
    let attitude = Attitude::from_quaternion(wxyz).map_err(Raise::raise)?;
    Ok(State { time: 0.0, attitude, omega: AngularVelocity::from_array(omega) })
}
