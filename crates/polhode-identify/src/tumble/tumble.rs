//! Result of the estimation from tumbles.

use polhode::motion::State;
use polhode::motion::torque::DragLaw;

use super::flaw::Flaw;
use super::flight::Flight;
use super::model::{CHANNELS, Tumbles};
use crate::error::IdentifyError;
use crate::estimate::Estimate;
use crate::least_squares::{Outliers, Solution, rows_of};
use crate::principal::PrincipalEstimate;
use crate::residuals::{Noise, ResidualTest};
use crate::six::{ELEMENTS, between};

/// Body estimated from its tumbles.
#[derive(Clone, Debug, PartialEq)]
pub struct Tumble {
    /// Elements of the tensor, of drag, and gyro errors.
    ///
    /// If nothing known determines the size, tensor and drag are divided by the greatest moment,
    /// and the unobservable direction scales all of them.
    pub estimate: Estimate,
    /// Principal moments and axes, with errors.
    pub principal: PrincipalEstimate,
    /// True if the moments are in kg·m²; false if only their ratios are determined.
    pub scale_is_known: bool,
    /// Fit of each flight, in order.
    pub flights: Vec<FlightFit>,
    /// Tests of the residuals against the noise, by kind of reading.
    pub residuals: Vec<ResidualTest>,
    /// Factor by which all errors were widened because of the residuals.
    pub widening: f64,
    /// Flaws in the readings.
    pub flaws: Vec<Flaw>,
}

/// Fit of one flight.
#[derive(Clone, Debug, PartialEq)]
pub struct FlightFit {
    /// Name of the flight.
    pub name: String,
    /// State at the reference time; the attitude is meaningful only if attitudes were measured.
    pub state: State,
    /// Standard deviations of ω at the reference time, rad/s.
    pub omega_sd: [f64; 3],
    /// Reduced χ² of the readings that were used.
    pub reduced_chi_square: f64,
    /// Number of readings used.
    pub used: usize,
    /// Times of readings that were left out, s.
    pub left_out: Vec<f64>,
    /// Residuals of the gyro (measured − predicted), rad/s, at its times.
    pub gyro_residuals: Vec<[f64; 3]>,
    /// Residuals of the attitudes, rad, at their times.
    pub attitude_residuals: Vec<[f64; 3]>,
}

impl Tumble {
    pub(super) fn of(
        problem: &Tumbles<'_>,
        solution: &Solution,
        outliers: Outliers,
    ) -> Result<Self, IdentifyError> {
        let information = solution.information()?;
        let scale_is_known = problem.flights.iter().any(Flight::has_scale);
        let (unit, over) = if scale_is_known { ("kg·m²", "") } else { ("1", "/I3") };
        let mut names: Vec<(String, &'static str)> =
            ELEMENTS.map(|element| (format!("I{element}{over}"), unit)).to_vec();
        if let Some(law) = problem.drag {
            let unit = drag_unit(law, scale_is_known);
            names.extend(ELEMENTS.map(|element| (format!("drag {element}{over}"), unit)));
        }
        names.extend(problem.gyro.names());
        if problem.tracked.is_some() {
            names.extend(["x", "y", "z"].map(|axis| (format!("tracked axes {axis}"), "rad")));
        }
        let estimate = Estimate::new(names, &solution.shared, &information);

        let mut flights = Vec::new();
        let (mut gyro_runs, mut attitude_runs) = (Vec::new(), Vec::new());
        for (k, flight) in problem.flights.iter().enumerate() {
            let local = &solution.place.local[k];
            let rows = rows_of(problem, k, &solution.shared, local)?;
            let (_, weights) = outliers.weigh(&rows);
            let residuals: Vec<[f64; 3]> = rows.measurements().map(|r| [r[0], r[1], r[2]]).collect();
            let (gyro, attitudes) = residuals.split_at(flight.gyro().len());
            let (gyro_weights, attitude_weights) = weights.split_at(flight.gyro().len());
            runs(gyro, gyro_weights, &mut gyro_runs);
            runs(attitudes, attitude_weights, &mut attitude_runs);
            let times = flight.gyro().iter().map(|r| r.time).chain(flight.attitudes().iter().map(|r| r.time));
            let left_out: Vec<f64> =
                times.zip(&weights).filter(|(_, w)| **w == 0.0).map(|(t, _)| t).collect();
            let used = residuals.len() - left_out.len();
            let square: f64 = residuals
                .iter()
                .zip(&weights)
                .filter(|(_, w)| **w > 0.0)
                .map(|(r, _)| r.iter().map(|x| x * x).sum::<f64>())
                .sum();
            let covariance = solution.local_covariance(k, &information);
            flights.push(FlightFit {
                name: flight.name().to_owned(),
                state: problem.state(k, local),
                omega_sd: core::array::from_fn(|i| {
                    covariance.as_ref().map_or(f64::INFINITY, |c| c[(i, i)].max(0.0).sqrt())
                }),
                reduced_chi_square: square / ((CHANNELS * used) as f64 - local.len() as f64).max(1.0),
                used,
                left_out,
                gyro_residuals: gyro.iter().map(|r| r.map(|x| x * problem.gyro_noise.deviation)).collect(),
                attitude_residuals: attitudes.iter().map(|r| r.map(|x| x * problem.attitude_noise)).collect(),
            });
        }
        let numbers = (solution.shared.len() + solution.place.local.iter().map(Vec::len).sum::<usize>()
            - information.unknown.ncols()) as f64;
        let total = gyro_runs.iter().chain(&attitude_runs).map(Vec::len).sum::<usize>() as f64;
        let share = |runs: &[Vec<f64>]| numbers * runs.iter().map(Vec::len).sum::<usize>() as f64 / total;
        let kinds = [
            ("angular velocity", problem.gyro_noise, gyro_runs),
            ("attitude", Noise::told(problem.attitude_noise), attitude_runs),
        ];
        let measured = kinds.into_iter().filter(|(.., runs)| !runs.is_empty());
        let residuals: Vec<ResidualTest> =
            measured.map(|(what, noise, runs)| ResidualTest::of(what, noise, share(&runs), &runs)).collect();
        let widening = ResidualTest::widening_of(&residuals);
        let estimate = estimate.widened(widening);
        for flight in &mut flights {
            flight.omega_sd = flight.omega_sd.map(|sd| sd * widening);
        }
        let mut principal = PrincipalEstimate::of_tensor(&estimate, 0);
        let estimate = if scale_is_known {
            estimate
        } else {
            // The greatest moment is v·I v.
            let greatest = principal.moments[2];
            principal.moments = principal.moments.map(|moment| moment / greatest);
            let mut estimate =
                estimate.relative(6 + problem.drag_count(), &between(principal.axes[2], principal.axes[2]));
            estimate.numbers.iter_mut().take(6).for_each(|element| element.largest_sd = ELEMENT_RANGE);
            estimate
        };
        Ok(Self { estimate, principal, scale_is_known, flights, residuals, widening, flaws: Vec::new() })
    }
}

/// Width of the possible range of an element divided by the greatest moment: [0, 1] on the
/// diagonal, [−½, ½] off it.
const ELEMENT_RANGE: f64 = 1.0;

const fn drag_unit(law: DragLaw, scale_is_known: bool) -> &'static str {
    match (law, scale_is_known) {
        (DragLaw::Linear, true) => "N·m·s",
        (DragLaw::Quadratic, true) => "N·m·s²",
        (DragLaw::Linear, false) => "1/s",
        (DragLaw::Quadratic, false) => "1",
    }
}

/// Appends the residuals of used readings, one run per channel.
fn runs(residuals: &[[f64; 3]], weights: &[f64], runs: &mut Vec<Vec<f64>>) {
    if residuals.is_empty() {
        return;
    }
    for channel in 0..CHANNELS {
        let used = residuals.iter().zip(weights).filter(|(_, w)| **w > 0.0);
        runs.push(used.map(|(r, _)| r[channel]).collect());
    }
}
