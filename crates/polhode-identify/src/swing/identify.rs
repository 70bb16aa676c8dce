//! Estimation of a body from swing tests.

use nalgebra::DMatrix;
use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Body, Position};

use super::measurement::{Measurement, Signal};
use super::mistake::{Mistake, mistakes};
use super::number::{CENTER, MASS, TENSOR};
use super::plan::SwingPlan;
use super::problem::{Stage, Swings};
use crate::error::IdentifyError;
use crate::estimate::{Estimate, Number};
use crate::least_squares::{Information, Outliers, Place, Solution, fit, rows_of};
use crate::residuals::{Noise, ResidualTest};

/// Result of the estimation from swing tests.
#[derive(Clone, Debug, PartialEq)]
pub struct SwingEstimate {
    /// Mass, centre, tensor about the centre of mass, gravity, and the numbers of the plan. Exact
    /// values have the standard deviation 0.
    pub estimate: Estimate,
    /// Physically consistent body. Along the directions in [`Estimate::unknown`] its values are
    /// arbitrary.
    pub body: MassProperties<Body>,
    /// Result of each test, in the order of the plan.
    pub tests: Vec<SwingResult>,
    /// Test of all counted times and amplitudes, and of the measured numbers of the plan; `None`
    /// without redundancy.
    pub counted: Option<ResidualTest>,
    /// Residuals of the measured numbers, in order, in standard deviations.
    pub left_of_numbers: Vec<f64>,
    /// Factor by which all errors were multiplied because of the residuals.
    pub widening: f64,
    /// Possible mistakes, with their detectability by the residuals of counted swings; empty
    /// without redundancy.
    pub mistakes: Vec<Mistake>,
}

/// Result of one test.
#[derive(Clone, Debug, PartialEq)]
pub struct SwingResult {
    /// Name of the test.
    pub name: String,
    /// Moment of inertia nᵀ I n of the body about the axis of the swing through the body's centre
    /// of mass; `None` for a test without the body.
    pub moment: Option<Number>,
    /// Local parameters: amplitude; for a log also phase and zero; then the damping a and β.
    pub own: Vec<Number>,
    /// Test of the residuals against the noise.
    pub residuals: ResidualTest,
    /// True for a log. Counted swings are too few for a test of their own;
    /// [`SwingEstimate::counted`] tests all of them.
    pub is_logged: bool,
    /// Residuals (measured − predicted) of each reading, in order, in standard deviations. For
    /// counted swings the times precede the amplitudes.
    pub left: Vec<f64>,
}

impl SwingEstimate {
    /// Returns the tests of the model: one per log, and one for all counted swings if they are
    /// redundant.
    pub fn model_tests(&self) -> impl Iterator<Item = &ResidualTest> {
        self.tests.iter().filter(|test| test.is_logged).map(|test| &test.residuals).chain(&self.counted)
    }
}

/// Estimates the body of a plan of swing tests.
///
/// Every measured number of the plan is estimated again together with the tensor, weighted by its
/// own error. So the covariance contains the correlation between tests that share numbers.
///
/// # Errors
/// [`IdentifyError`] if a value is out of range, a rig cannot hold the body as described, or its
/// motion is not a twist.
pub fn identify_swings(plan: &SwingPlan) -> Result<SwingEstimate, IdentifyError> {
    plan.check()?;
    let mut swings = Swings::new(plan)?;
    let coordinates = plan.coordinates();
    let shared = coordinates.of(&start(plan, &swings)?);
    let begun = fit(&swings, &coordinates, Place { shared, local: swings.locals() }, Outliers::Kept)?;
    swings.stage = Stage::All;
    let place = Place { shared: begun.place.shared, local: swings.locals() };
    let solution = fit(&swings, &coordinates, place, Outliers::Kept)?;
    said(plan, &swings, &solution)
}

/// Returns start values with a spherical tensor whose size fits the observed rates best.
fn start(plan: &SwingPlan, swings: &Swings) -> Result<Vec<f64>, IdentifyError> {
    let places = plan.places();
    let tensor = places[TENSOR].unwrap_or(0);
    let mut shared = vec![0.0; places.iter().flatten().count()];
    for (measured, place) in plan.measured().iter().zip(&places) {
        if let Some(place) = *place {
            shared[place] = measured.value;
        }
    }
    let mass = plan.measured()[MASS].value;
    let mut best: Option<(f64, Vec<f64>)> = None;
    let mut refused = IdentifyError::NotFinite { quantity: "the misfit of every tried radius of gyration" };
    for step in 0..SIZES {
        let radius = SMALLEST * libm::pow(LARGEST / SMALLEST, f64::from(step) / f64::from(SIZES - 1));
        shared[tensor..tensor + 3].fill(mass * radius * radius);
        match swings.misfit(&shared) {
            Ok(misfit) if best.as_ref().is_none_or(|(least, _)| misfit < *least) => {
                best = Some((misfit, shared.clone()));
            }
            Ok(_) => {}
            Err(error) => refused = error,
        }
    }
    best.map(|(_, shared)| shared).ok_or(refused)
}

/// Range of the trial radii of gyration, m, and their number.
const SMALLEST: f64 = 1e-3;
const LARGEST: f64 = 30.0;
const SIZES: u32 = 48;

/// Composes the result from the least-squares solution.
fn said(plan: &SwingPlan, swings: &Swings, solution: &Solution) -> Result<SwingEstimate, IdentifyError> {
    let places = plan.places();
    let found = solution.information()?;
    let values = swings.all(&solution.shared);
    let mut tests = Vec::new();
    let mut together = Together::default();
    let measured = residuals(swings, solution, 0)?;
    if !measured.is_empty() {
        together.add(&measured, solution.found_by(0, &found));
    }
    for (k, test) in plan.tests().iter().enumerate() {
        let left = residuals(swings, solution, k + 1)?;
        let share = solution.found_by(k + 1, &found);
        let (what, noise) = match &test.measurement {
            Measurement::Counted(_) => ("times and amplitudes of counted swings (normalized)", 1.0),
            Measurement::Logged(logged) if logged.signal == Signal::Angle => ("angle", logged.sd),
            Measurement::Logged(logged) => ("rate", logged.sd),
        };
        if matches!(test.measurement, Measurement::Counted(_)) {
            together.add(&left, share);
        }
        tests.push(SwingResult {
            name: test.name.clone(),
            moment: None,
            own: own(&test.measurement, solution, k + 1, &found),
            residuals: ResidualTest::of(what, Noise::told(noise), share, core::slice::from_ref(&left)),
            is_logged: matches!(test.measurement, Measurement::Logged(_)),
            left,
        });
    }
    let counted = together.test();
    let logs = tests.iter().filter(|test| test.is_logged).map(|test| &test.residuals);
    let widening = ResidualTest::widening_of(logs.chain(&counted));
    let information = with_exact(&found, &places);
    let estimate = Estimate::new(plan.names(), &values, &information).widened(widening);
    for (result, test) in tests.iter_mut().zip(plan.tests()) {
        result.moment = test.moment_gradient().map(|gradient| moment(&values, &gradient, &estimate));
        for number in &mut result.own {
            number.sd = number.sd.map(|sd| sd * widening);
        }
        require_decay(result)?;
    }
    let [xx, yy, zz, xy, xz, yz] = core::array::from_fn(|k| values[TENSOR + k]);
    let inertia = InertiaTensor::with_negative_products([xx, yy, zz], [xy, xz, yz])?;
    let center = Position::new(values[CENTER], values[CENTER + 1], values[CENTER + 2]);
    let body = MassProperties::new(values[MASS], center, inertia)?;
    let mistakes = match &counted {
        Some(test) => mistakes(plan, swings, solution, &found, test)?,
        None => Vec::new(),
    };
    Ok(SwingEstimate { estimate, body, tests, counted, left_of_numbers: measured, widening, mistakes })
}

fn moment(values: &[f64], by_elements: &[f64; 6], estimate: &Estimate) -> Number {
    let mut gradient = vec![0.0; values.len()];
    gradient[TENSOR..TENSOR + 6].copy_from_slice(by_elements);
    let value = gradient.iter().zip(values).map(|(g, v)| g * v).sum();
    Number::new("moment about the axis".to_owned(), "kg·m²", value, estimate.deviation(&gradient))
}

/// Returns the residuals of a group, in standard deviations.
fn residuals(swings: &Swings<'_>, solution: &Solution, group: usize) -> Result<Vec<f64>, IdentifyError> {
    let rows = rows_of(swings, group, &solution.shared, &solution.place.local[group])?;
    Ok(rows.measurements().flatten().collect())
}

/// Residuals of tests that are too small for a test of their own.
#[derive(Default)]
struct Together {
    /// One run per residual, because they are not a time series.
    runs: Vec<Vec<f64>>,
    found: f64,
}

impl Together {
    fn add(&mut self, residuals: &[f64], found: f64) {
        self.runs.extend(residuals.iter().map(|r| vec![*r]));
        self.found += found;
    }

    /// Returns the test if there are more measurements than parameters.
    fn test(&self) -> Option<ResidualTest> {
        (self.runs.len() as f64 > self.found + 0.5).then(|| {
            ResidualTest::of(
                "counted swings and measured inputs (normalized)",
                Noise::told(1.0),
                self.found,
                &self.runs,
            )
        })
    }
}

/// Returns an error if a damping is significantly negative, so that the amplitude would grow.
fn require_decay(result: &SwingResult) -> Result<(), IdentifyError> {
    let damping = result.own.iter().filter(|number| number.name.ends_with("damping"));
    for Number { name, unit, value, sd, .. } in damping {
        if let Some(sd) = sd.filter(|sd| *value < -NO_CHANCE * sd) {
            let (number, test) = (name.clone(), result.name.clone());
            return Err(IdentifyError::Growing { test, number, value: *value, sd, unit });
        }
    }
    Ok(())
}

/// Significance threshold, standard deviations.
const NO_CHANCE: f64 = 5.0;

/// Returns the local parameters of a test.
fn own(measurement: &Measurement, solution: &Solution, group: usize, found: &Information) -> Vec<Number> {
    let damping = measurement.damping();
    let mut names = vec![("amplitude", "rad")];
    if let Measurement::Logged(logged) = measurement {
        let unit = if logged.signal == Signal::Angle { "rad" } else { "rad/s" };
        names.extend([("phase", "rad"), ("zero", unit)]);
    }
    if damping.is_viscous() {
        names.push(("viscous damping", "1/s"));
    }
    if damping.is_quadratic() {
        names.push(("quadratic damping", "1"));
    }
    let covariance = solution.local_covariance(group, found);
    let number = |(k, ((name, unit), &value)): (usize, ((&str, &'static str), &f64))| {
        let sd = covariance.as_ref().map(|c| c[(k, k)].max(0.0).sqrt()).filter(|sd| sd.is_finite());
        Number::new(name.to_owned(), unit, value, sd)
    };
    names.into_iter().zip(&solution.place.local[group]).enumerate().map(number).collect()
}

/// Returns the information with rows and columns of zeros for exact parameters.
fn with_exact(found: &Information, places: &[Option<usize>]) -> Information {
    let shared = places.iter().flatten().count();
    found.of_other(&DMatrix::from_fn(places.len(), shared, |i, j| f64::from(u8::from(places[i] == Some(j)))))
}
