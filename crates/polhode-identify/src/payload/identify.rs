//! Estimation of a payload from a log.

use nalgebra::{DMatrix, DVector};
use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Body, Position, symmetric_eigen};

use super::about;
use super::answer::{Payload, Unconstrained};
use super::edge::{self, Edge};
use super::finding::PayloadFinding;
use super::log::{PayloadLog, WrenchNoise, diagonal};
use super::outliers::{self, LeftOut, Outliers};
use super::regression::{Pass, Regression};
use super::small::Matrix6;
use super::{mistake, noise, possible, shape};
use crate::ON_EARTH;
use crate::decomposition::symmetric_eigen as eigen;
use crate::error::IdentifyError;
use crate::least_squares::{Information, columns};
use crate::residuals::{Noise, ResidualTest};

/// Maximum number of passes over the rows.
const MOST_PASSES: usize = 60;
/// Number of passes that update unknown noise. It converges by then, unless the model is wrong.
const NOISE_PASSES: usize = 20;
/// Convergence threshold: largest change of the parameters in a pass, standard deviations.
const SETTLED: f64 = 1e-4;
/// Convergence threshold that is accepted when passes run out.
const NEARLY_SETTLED: f64 = 0.03;
/// Thresholds of unobservable directions: largest share of the information that may be noise of the
/// motion. If the passes do not converge with one, the next is tried. Convergence fails for
/// directions near the threshold and for diverging parameters; a lower threshold removes them.
const MOSTLY_NOISE: [f64; 4] = [0.5, 0.25, 0.1, 0.03];
/// Threshold below which the information on a direction is rounding, relative to its terms.
const ROUNDING: f64 = 1e-7;
/// Lower bound on the noise, relative to the largest measurement.
const NO_NOISE: f64 = 1e-9;
/// Change along an unobservable direction below which a parameter still counts as determined, in
/// its standard deviations.
const HARDLY: f64 = 0.3;
/// Significant increase of χ² with at most six degrees of freedom: probability one in a million.
const NO_CHANCE: f64 = 38.0;

/// Estimates mass, centre and tensor of the payload of a force–torque sensor.
///
/// # Errors
/// [`IdentifyError::TooFew`] for too few rows; [`IdentifyError::NoConvergence`] if the iteration
/// does not converge, for example if noise hides the motion.
pub fn identify_payload(log: &PayloadLog) -> Result<Payload, IdentifyError> {
    let settled = settle(log)?;
    let (information, root) = settled.information()?;
    let Fit { free, numbers, rise } = settled.fit(&information, &root)?;
    let numbers = numbers.as_slice();

    let tests = settled.tests(&information);
    let widening = ResidualTest::widening_of(&tests);
    let is_possible = possible::is_possible(free.as_slice());
    let unconstrained = Unconstrained {
        is_possible,
        least_second_moment: (free[0] > 0.0)
            .then(|| symmetric_eigen(possible::moments_about_center(free.as_slice())).0[0]),
        chi_square_rise: rise,
        numbers: free.as_slice().to_vec(),
    };
    let (edge, of_kind) = match log.kind {
        Some(kind) => (None, edge::of_kind(numbers, kind, &information)?),
        None if is_possible => (None, None),
        None => (Edge::of(numbers, free.as_slice(), &information)?, None),
    };
    let mut findings = findings(log, &unconstrained, &tests, &information);
    findings.extend(settled.outliers.too_many.map(|count| PayloadFinding::ManyOutliers { count }));
    if tests.iter().any(ResidualTest::is_too_large) {
        findings.extend(mistake::likeliest(log, &settled.noise, &settled.regression.weights));
    }
    let information = of_kind.unwrap_or(information);
    let about_center = about::about_center(numbers, &information).widened(widening);
    let is_known = about_center.numbers.iter().take(10).all(|number| number.sd.is_some());
    let values: Vec<f64> = about_center.numbers.iter().map(|number| number.value).collect();
    Ok(Payload {
        body: if is_known { Some(body(&values)?) } else { None },
        about_origin: about::about_origin(numbers, &information).widened(widening),
        about_center,
        unconstrained,
        edge: edge.map(|edge| edge.widened(widening)),
        times: log.rows().iter().map(|row| row.time).collect(),
        left_out: settled.left_out(),
        residuals: settled.pass.left,
        tests,
        findings,
    })
}

/// State of the iteration: parameters and motions, at the end converged.
struct Settled<'a> {
    log: &'a PayloadLog,
    mostly_noise: f64,
    regression: Regression<'a>,
    outliers: Outliers,
    /// Covariance of the wrench.
    noise: Matrix6,
    /// Rows at these parameters.
    pass: Pass,
    numbers: DVector<f64>,
}

/// Fit to one triangle.
struct Fit {
    /// Unconstrained parameters.
    free: DVector<f64>,
    numbers: DVector<f64>,
    /// Increase of χ² of the parameters over the unconstrained ones.
    rise: f64,
}

fn settle(log: &PayloadLog) -> Result<Settled<'_>, IdentifyError> {
    let [first, others @ ..] = MOSTLY_NOISE;
    let has_noise = log.motion_deviations().iter().any(|&sd| sd > 0.0);
    settle_with(log, first).or_else(|error| match error {
        IdentifyError::NoConvergence { .. } | IdentifyError::NotFinite { .. } if has_noise => {
            let settled = others.into_iter().find_map(|mostly_noise| settle_with(log, mostly_noise).ok());
            settled.ok_or(IdentifyError::NoConvergence { steps: MOST_PASSES })
        }
        error => Err(error),
    })
}

fn settle_with(log: &PayloadLog, mostly_noise: f64) -> Result<Settled<'_>, IdentifyError> {
    let count = log.unknowns();
    let needed = count.div_ceil(6) + if log.noise == WrenchNoise::Unknown { LEAST_FOR_NOISE } else { 1 };
    if log.rows().len() < needed {
        return Err(IdentifyError::TooFew { what: "rows", given: log.rows().len(), needed });
    }
    let mut regression = Regression::new(log);
    let mut outliers = Outliers::new();
    let unknown_noise = log.noise == WrenchNoise::Unknown;
    let mut wrench_noise = match log.noise {
        WrenchNoise::Unknown => diagonal(1.0, 1.0),
        WrenchNoise::Deviations { force, torque } => diagonal(force, torque),
        WrenchNoise::Covariance(covariance) => covariance,
    };
    let mut numbers = DVector::zeros(count);
    // Parameters, and unknown noise, first converge without noise of the motion. Residuals are
    // judged once it is included.
    let near = if unknown_noise { 3 } else { 0 };
    let ready = near + usize::from(log.motion_deviations().iter().any(|&sd| sd > 0.0));
    for number in 0..MOST_PASSES {
        let is_judged = number > ready;
        let pass = regression.pass(numbers.as_slice(), &wrench_noise, |residuals, weights| {
            if is_judged {
                outliers.weigh(residuals, weights);
            }
        })?;
        let mut settled =
            Settled { log, mostly_noise, regression, outliers, noise: wrench_noise, pass, numbers };
        let (information, root) = settled.information()?;
        let Fit { numbers: next, rise, free } = settled.fit(&information, &root)?;
        // A wrench of the wrong sense has no plausible motion: the iteration would diverge.
        if number == near && is_negative(free.as_slice(), &information).is_none() {
            settled.regression.regard_motion_noise();
        }
        // Relative to the cost of the constraint, like the accuracy of the interior-point method.
        let step = (settled.rows() * (&next - &settled.numbers)).norm() / (1.0 + rise.max(0.0).sqrt());
        let is_improved = unknown_noise && (1..NOISE_PASSES).contains(&number);
        let next_noise = if is_improved { settled.found_noise(&information) } else { settled.noise };
        let change = (0..6).map(|k| (next_noise[k][k] / settled.noise[k][k] - 1.0).abs()).fold(0.0, f64::max);
        let is_last = number + 1 == MOST_PASSES && step < NEARLY_SETTLED;
        if is_judged && (step < SETTLED && change < 1e-3 && !settled.outliers.changed || is_last) {
            return Ok(settled);
        }
        Settled { regression, outliers, .. } = settled;
        (numbers, wrench_noise) = (next, next_noise);
    }
    Err(IdentifyError::NoConvergence { steps: MOST_PASSES })
}

/// Number of rows beyond those for the parameters that a noise estimate needs.
const LEAST_FOR_NOISE: usize = 10;

impl Settled<'_> {
    /// Returns the derivatives of all rows as a triangle.
    fn rows(&self) -> DMatrix<f64> {
        self.pass.triangle.columns(0, self.numbers.len()).into_owned()
    }

    /// Returns the information on the parameters, without information that is only noise of the
    /// motion. If noise has the share s in a direction's information, its variance is multiplied by
    /// 1/(1 − s)².
    ///
    /// The second value is the factor of (RᵀR)⁻¹ in the observable directions, used for steps.
    fn information(&self) -> Result<(Information, DMatrix<f64>), IdentifyError> {
        let information = Information::of(&self.rows())?;
        if !self.regression.has_motion_noise() {
            let root = information.root.clone();
            return Ok((information, root));
        }
        let n = self.numbers.len();
        let noise = self.regression.noise_information(self.numbers.as_slice(), &self.noise)?;
        let shares = information.root.transpose() * noise * &information.root;
        let shares = eigen("the information lost to noise of the motion", shares)?;
        let (mut known, mut unknown) = (Vec::new(), columns(&information.unknown));
        let (mut only_noise, mut steps) = (Vec::new(), Vec::new());
        for (turn, &share) in shares.eigenvectors.column_iter().zip(&shares.eigenvalues) {
            let direction = &information.root * turn;
            if share < self.mostly_noise {
                known.push(&direction / (1.0 - share));
                steps.push(direction);
            } else {
                only_noise.push(direction);
            }
        }
        let variance = |i: usize| known.iter().map(|d| d[i] * d[i]).sum::<f64>();
        for direction in only_noise {
            let element = |i: usize| {
                let x = direction[i];
                if x * x > HARDLY * HARDLY * variance(i) { x } else { 0.0 }
            };
            unknown.push(DVector::from_fn(n, |i, _| element(i)));
        }
        let root = Information::with(n, &steps, &[]).root;
        Ok((Information::with(n, &known, &unknown), root))
    }

    fn fit(&self, information: &Information, root: &DMatrix<f64>) -> Result<Fit, IdentifyError> {
        let n = self.numbers.len();
        let triangle = &self.pass.triangle;
        // Without the last row, which no parameters can explain.
        let rows = triangle.nrows().min(n);
        let mut r = triangle.view((0, 0), (rows, n)).into_owned();
        let mut z: DVector<f64> = triangle.view((0, n), (rows, 1)).column(0).into_owned();
        // Remove the rows' components along unobservable directions: noise or rounding.
        let norms: Vec<f64> = r.column_iter().map(|column| column.norm()).collect();
        for direction in information.unknown.column_iter() {
            let said = &r * direction;
            let size: f64 = norms.iter().zip(&direction).map(|(norm, x)| norm * x.abs()).sum();
            if said.norm() > ROUNDING * size {
                let unit = &said / said.norm();
                let (along, part) = (unit.tr_mul(&r), unit.dot(&z));
                r -= &unit * along;
                z -= &unit * part;
            }
        }
        // Solves Rᵀ z by the covariance, then repeats for the remainder: the covariance squares the
        // condition number.
        let mut free = self.numbers.clone();
        for _ in 0..4 {
            let left = &z - &r * (&free - &self.numbers);
            free += root * (root.transpose() * r.tr_mul(&left));
        }
        let mut numbers = if possible::is_possible(free.as_slice()) {
            free.clone()
        } else {
            possible::least_squares(&r, &z, &self.numbers, &free, &information.unknown)?
        };
        if let Some(kind) = self.log.kind {
            numbers = shape::least_squares(&r, &z, &self.numbers, &numbers, kind)?;
        }
        let rise = (&z - &r * (&numbers - &self.numbers)).norm_squared()
            - (&z - &r * (&free - &self.numbers)).norm_squared();
        Ok(Fit { free, numbers, rise })
    }

    /// Returns the effective numbers of parameters estimated from force and from torque.
    fn found(&self, information: &Information) -> [f64; 2] {
        let n = self.numbers.len();
        [&self.pass.force, &self.pass.torque].map(|t| (t.columns(0, n) * &information.root).norm_squared())
    }

    fn found_noise(&self, information: &Information) -> Matrix6 {
        let [by_force, by_torque] =
            [0, 1].map(|k| (&self.pass.differences[k] * &information.covariance).trace());
        let [force, torque] = self.pass.propagated;
        let sd = |first: usize, propagated: f64, found: f64| {
            let size = self.log.rows().iter().flat_map(|row| row.wrench().into_iter().skip(first).take(3));
            let rounding = NO_NOISE * size.fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
            noise::from_differences(&self.pass.left, &self.regression.weights, first, propagated, found)
                .max(rounding)
        };
        diagonal(sd(0, force, by_force), sd(3, torque, by_torque))
    }

    fn tests(&self, information: &Information) -> [ResidualTest; 2] {
        let found = self.found(information);
        let test = |what, first: usize, found| {
            let kept = |i: usize| {
                let rows = self.pass.residuals.iter().zip(&self.regression.weights);
                rows.filter(|(_, w)| **w > 0.0).map(|(r, _)| r[first + i]).collect::<Vec<f64>>()
            };
            let variance = (0..3).map(|i| self.noise[first + i][first + i]).sum::<f64>() / 3.0;
            let runs = [kept(0), kept(1), kept(2)];
            let mut noise = Noise::told(variance.sqrt());
            if self.log.noise == WrenchNoise::Unknown {
                noise.degrees_of_freedom = noise::degrees_of_freedom(runs[0].len());
            }
            ResidualTest::of(what, noise, found, &runs)
        };
        [test("force", 0, found[0]), test("torque", 3, found[1])]
    }

    fn left_out(&self) -> Vec<LeftOut> {
        let rows = self.pass.residuals.iter().zip(&self.regression.weights).enumerate();
        rows.filter(|(_, (_, w))| **w == 0.0)
            .map(|(row, (r, _))| LeftOut { row, size: outliers::size(r) })
            .collect()
    }
}

/// Returns a finding if the mass is significantly negative.
fn is_negative(numbers: &[f64], information: &Information) -> Option<PayloadFinding> {
    let mut by_mass = vec![0.0; numbers.len()];
    by_mass[0] = 1.0;
    let sd = information.deviation(&by_mass)?;
    (numbers[0] < -5.0 * sd).then_some(PayloadFinding::NegativeMass { mass: numbers[0], sd })
}

fn findings(
    log: &PayloadLog,
    unconstrained: &Unconstrained,
    tests: &[ResidualTest; 2],
    information: &Information,
) -> Vec<PayloadFinding> {
    let mut all = Vec::new();
    all.extend(is_negative(&unconstrained.numbers, information));
    let chi_square_rise = unconstrained.chi_square_rise;
    // Compared with the residuals of the unconstrained fit.
    let (chi_square, count) = tests.iter().fold((-chi_square_rise, 0.0), |(sum, count), test| {
        (sum + test.reduced_chi_square * test.degrees_of_freedom, count + test.degrees_of_freedom)
    });
    if chi_square_rise > NO_CHANCE * f64::max(1.0, chi_square / count) {
        all.push(match log.kind {
            Some(kind) => PayloadFinding::NotOfKind { kind, chi_square_rise },
            None => PayloadFinding::ImpossibleBeyondNoise { chi_square_rise },
        });
    }
    let sizes = log.rows().iter().map(|row| row.gravity.norm());
    let (least, most) = sizes.fold((f64::INFINITY, 0.0_f64), |(a, b), g| (a.min(g), b.max(g)));
    if most - least > 0.01 * most {
        all.push(PayloadFinding::GravityVaries { least, most });
    } else if most > 0.0 && !ON_EARTH.contains(&most) {
        all.push(PayloadFinding::UnusualGravity { size: most });
    }
    all
}

/// Returns the body of m, c and the tensor about the centre of mass. At the boundary a relative
/// 1e-12 compensates for rounding.
fn body(values: &[f64]) -> Result<MassProperties<Body>, IdentifyError> {
    let center = Position::new(values[1], values[2], values[3]);
    let own = |scale: f64| {
        let [xx, yy, zz] = [4, 5, 6].map(|k| values[k]);
        let more = scale * f64::max(xx, f64::max(yy, zz));
        InertiaTensor::with_negative_products(
            [xx + more, yy + more, zz + more],
            [values[7], values[8], values[9]],
        )
    };
    Ok(MassProperties::new(values[0], center, own(0.0).or_else(|_| own(1e-12))?)?)
}
