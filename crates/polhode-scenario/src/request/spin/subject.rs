//! Spinning body and its initial state.

use std::path::Path;

use polhode::body::{BodyError, Finding, InertiaTensor, MassProperties, PrincipalFrame, Symmetry};
use polhode::math::{AngularMomentum, AngularVelocity, Attitude, Body, Position};
use polhode::motion::{FreeMotion, Mechanism, Rotor, Scenario, State};
use polhode_document::SourceInfo;
use polhode_source::files::Files;
use polhode_source::{Failure, shown};

use super::given::{Moments, Omega};
use crate::read::ScenarioFile;

/// Body, from a scenario or from options.
#[derive(Debug)]
pub(crate) enum Subject {
    Scenario {
        path: String,
        scenario: Box<Scenario>,
        text: String,
    },
    Moments([f64; 3]),
    /// Body given by a tensor alone; its mass is arbitrary and does not affect the motion.
    Tensor(Box<MassProperties<Body>>),
}

impl Subject {
    pub(crate) fn of_file(files: &dyn Files, file: &Path) -> Result<Self, Failure> {
        let ScenarioFile { scenario, text, .. } = ScenarioFile::read(files, file)?;
        let path = file.display().to_string();
        let why = if !scenario.torques().is_empty() {
            "a torque acts on the body"
        } else if !scenario.wheels().is_empty() {
            "wheels spin in the body"
        } else if scenario.history().is_some() {
            "the mass properties change"
        } else if scenario.ground().is_some() {
            "the body is on the ground"
        } else if matches!(scenario.mechanism(), Mechanism::Gimbals(_)) {
            "the body hangs in gimbals"
        } else if scenario.pivot().is_some() {
            "the body is held at a pivot"
        } else if scenario.prescribed().is_some() {
            "the motion is prescribed"
        } else {
            return Ok(Self::Scenario { path, scenario: Box::new(scenario), text });
        };
        Err(Failure::usage(
            format!("{} is not a free motion: {why}", shown(file)),
            "polhode simulate computes it as it is; polhode spin shows a body that is thrown and left alone",
        ))
    }

    /// Creates the body from moments about body axes; unphysical moments are accepted only if
    /// `allowed`.
    pub(crate) fn of_moments(moments: Moments, allowed: bool) -> Result<Self, Failure> {
        let Moments(moments) = moments;
        match InertiaTensor::<Body>::diagonal(moments) {
            Err(BodyError::TriangleInequality { moments: [i1, i2, i3] }) if !allowed => {
                let [sum, excess] = [i1 + i2, i3 - (i1 + i2)].map(short);
                let [i1, i2, i3, sum, excess] = [i1, i2, i3, sum, excess].map(plain);
                Err(Failure::usage(
                    format!(
                        "the moments are unphysical: {i1} + {i2} = {sum} is less than {i3} kg·m², by {excess} \
                         (any two moments are together at least the third)"
                    ),
                    "check the moments and their units; --allow-unphysical computes the motion all the same",
                ))
            }
            _ => Ok(Self::Moments(moments)),
        }
    }

    pub(crate) fn of_tensor(tensor: InertiaTensor<Body>) -> Result<Self, Failure> {
        let body = MassProperties::new(1.0, Position::ZERO, tensor);
        body.map(|body| Self::Tensor(Box::new(body)))
            .map_err(|error| Failure::usage(error.to_string(), "check --inertia"))
    }

    /// Returns the state at t = 0.
    pub(crate) fn start(&self, omega: Option<Omega>, attitude: Option<Attitude>) -> Result<State, Failure> {
        let start = match (self, omega) {
            (Self::Scenario { scenario, .. }, _) => scenario.start(),
            (Self::Moments(_) | Self::Tensor(_), Some(_)) => {
                State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO }
            }
            (Self::Moments(_) | Self::Tensor(_), None) => {
                return Err(Failure::usage(
                    "moments and tensors say how hard the body is to turn, not how it turns: --omega is missing",
                    "add --omega x,y,z along body axes, or --periods to ask which spin has two given periods",
                ));
            }
        };
        Ok(State {
            attitude: attitude.unwrap_or(start.attitude),
            omega: omega.map_or(start.omega, |Omega(omega)| AngularVelocity::from_array(omega)),
            ..start
        })
    }

    pub(crate) fn motion(&self, start: State) -> Result<FreeMotion, Failure> {
        let motion = match self {
            Self::Scenario { path, scenario, .. } => FreeMotion::of(&Rotor::free(scenario.body()), start)
                .map_err(|error| Failure::Motion { path: path.clone(), error })?,
            Self::Moments(moments) => FreeMotion::of_moments(*moments, start)
                .map_err(|error| Failure::usage(error.to_string(), "check --moments and --omega"))?,
            Self::Tensor(body) => FreeMotion::of(&Rotor::free(body), start)
                .map_err(|error| Failure::usage(error.to_string(), "check --inertia and --omega"))?,
        };
        let at_rest = start.omega == AngularVelocity::ZERO;
        let in_range = |x: f64| x.is_finite() && (x >= f64::MIN_POSITIVE || at_rest);
        if in_range(motion.kinetic_energy()) && in_range(motion.momentum().norm()) {
            return Ok(motion);
        }
        if motion.principal().symmetry() == Symmetry::Rod && motion.momentum() == AngularMomentum::ZERO {
            return Err(Failure::usage(
                "a rod that turns about its own line has neither energy nor angular momentum: its spin is not determined",
                "give ω a component across the rod",
            ));
        }
        Err(Failure::usage(
            "the energy or |L| of this spin is beyond the range of numbers, 2.2e-308 to 1.8e308",
            "check the units and the exponents",
        ))
    }

    /// Returns the principal moments and axes of a physical body.
    pub(crate) fn principal(&self) -> Result<PrincipalFrame<Body>, Failure> {
        match self {
            Self::Scenario { scenario, .. } => Ok(scenario.body().principal()),
            Self::Tensor(body) => Ok(body.principal()),
            Self::Moments(moments) => match InertiaTensor::diagonal(*moments) {
                Ok(tensor) => Ok(PrincipalFrame::of(&tensor)),
                Err(error) => Err(Failure::usage(error.to_string(), "check --moments")),
            },
        }
    }

    pub(crate) fn source(&self) -> Option<SourceInfo> {
        let Self::Scenario { path, scenario, .. } = self else { return None };
        let title = scenario.title().unwrap_or("scenario");
        Some(
            SourceInfo::new(path.clone(), "scenario")
                .described(title)
                .with("title", scenario.title().map(str::to_owned))
                .with("parts", scenario.parts().len()),
        )
    }

    /// Returns the subject of a plot.
    pub(crate) fn title(&self) -> String {
        match self {
            Self::Scenario { path, scenario, .. } => {
                scenario.title().map(str::to_owned).unwrap_or_else(|| path.clone())
            }
            Self::Moments([a, b, c]) => format!("moments {a}, {b}, {c} kg·m²"),
            Self::Tensor(body) => elements(body),
        }
    }

    pub(crate) fn findings(&self) -> Vec<Finding> {
        match self {
            Self::Scenario { scenario, .. } => scenario.findings().to_vec(),
            Self::Moments(_) | Self::Tensor(_) => Vec::new(),
        }
    }

    /// Returns the scenario with this start, its text and its path; `None` for moments and tensors.
    pub(crate) fn started(&self, start: State) -> Result<Option<(Scenario, &str, &Path)>, Failure> {
        let Self::Scenario { path, scenario, text } = self else { return Ok(None) };
        let started = Scenario::clone(scenario).not_sampled().starting(start);
        let scenario = started.map_err(|error| Failure::Motion { path: path.clone(), error })?;
        Ok(Some((scenario, text, Path::new(path))))
    }

    /// Returns the metadata of a table of the motion: keys and values.
    pub(crate) fn metadata(&self) -> Vec<(String, String)> {
        let pair = |key: &str, value: &str| (key.to_owned(), value.to_owned());
        match self {
            Self::Scenario { path, scenario, .. } => {
                let title = scenario.title().map(|title| pair("polhode.title", title));
                title.into_iter().chain([pair("polhode.source", path)]).collect()
            }
            Self::Moments([a, b, c]) => {
                vec![pair("polhode.source", &format!("moments {a}, {b}, {c} kg·m²"))]
            }
            Self::Tensor(body) => vec![pair("polhode.source", &elements(body))],
        }
    }
}

/// Formats a tensor on one line.
fn elements(body: &MassProperties<Body>) -> String {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
    format!("tensor {xx}, {yy}, {zz}, {xy}, {xz}, {yz} kg·m²")
}

/// Formats a number without exponent if it is of moderate size.
fn plain(x: f64) -> String {
    if x != 0.0 && !(1e-9..1e16).contains(&x.abs()) { format!("{x:e}") } else { x.to_string() }
}

/// Rounds a number to seven digits, which removes rounding errors of a sum.
fn short(x: f64) -> f64 {
    format!("{x:.6e}").parse().unwrap_or(x)
}
