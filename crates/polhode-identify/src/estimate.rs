//! Estimated parameters with their uncertainty.

use core::f64::consts::PI;
use core::fmt;

use nalgebra::{DMatrix, DVector};

use crate::decomposition::symmetric_eigen;
use crate::error::IdentifyError;
use crate::least_squares::{Information, KNOWN, changes_along};

/// Estimated parameters, their covariance and their unobservable directions.
///
/// The measurements do not determine the directions in [`Estimate::unknown`]: a change along one of
/// them predicts the same measurements. The covariance describes all other directions.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Parameters in a fixed order.
    pub numbers: Vec<Number>,
    /// Covariance of the parameters, in the products of their units.
    pub covariance: Vec<Vec<f64>>,
    /// Unobservable directions, each of length 1 in the parameters' units.
    pub unknown: Vec<Vec<f64>>,
}

/// Estimated parameter with its uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// Name of the parameter: `Ixx`, `bias x`, `wire length` …
    pub name: String,
    /// Unit: `kg·m²`, `rad/s`; `1` for a ratio.
    pub unit: &'static str,
    /// Estimated value, in `unit`.
    pub value: f64,
    /// Standard deviation, in `unit`; `None` if the parameter changes along an unobservable
    /// direction.
    pub sd: Option<f64>,
    /// Upper bound on the standard deviation of a determined parameter: [`ANGLE`] for an angle, the
    /// width of the possible range for a ratio of moments, infinite otherwise.
    pub largest_sd: f64,
}

/// Standard deviation of an angle that is uniform in ±π: π/√3 rad.
pub const ANGLE: f64 = PI / 1.732_050_807_568_877_2;

/// Threshold below which an eigenvalue of the correlation matrix is rounding.
const NONE: f64 = 1e-14;

/// Reason why a parameter is not determined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Undetermined {
    /// The parameter changes along an unobservable direction.
    UnknownDirection,
    /// The standard deviation is larger than the possible range allows.
    BeyondRange {
        /// Standard deviation of the parameter.
        sd: f64,
        /// Upper bound on the standard deviation of a determined parameter.
        largest: f64,
    },
}

impl Undetermined {
    /// Returns the reason that follows from a standard deviation; `None` if the parameter is
    /// determined.
    pub fn of(sd: Option<f64>, largest: f64) -> Option<Self> {
        match sd {
            None => Some(Self::UnknownDirection),
            Some(sd) if sd > largest || sd.is_infinite() => Some(Self::BeyondRange { sd, largest }),
            Some(_) => None,
        }
    }
}

impl fmt::Display for Undetermined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownDirection => f.write_str("it changes along an unobservable direction"),
            Self::BeyondRange { sd, .. } if sd.is_infinite() => {
                f.write_str("its standard deviation is infinite")
            }
            Self::BeyondRange { sd, largest } => {
                write!(
                    f,
                    "its standard deviation, {sd:.2e}, exceeds {largest:.3}, the largest that its range allows"
                )
            }
        }
    }
}

impl Number {
    pub(crate) fn new(name: String, unit: &'static str, value: f64, sd: Option<f64>) -> Self {
        let largest_sd = if unit == "rad" { ANGLE } else { f64::INFINITY };
        Self { name, unit, value, sd, largest_sd }
    }

    /// Returns the reason why the parameter is not determined; `None` if it is determined.
    pub fn undetermined(&self) -> Option<Undetermined> {
        Undetermined::of(self.sd, self.largest_sd)
    }
}

impl Estimate {
    pub(crate) fn new(
        names: impl IntoIterator<Item = (String, &'static str)>,
        values: &[f64],
        information: &Information,
    ) -> Self {
        let n = values.len();
        let unit = |k: usize| (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
        let numbers = names.into_iter().zip(values).enumerate().map(|(k, ((name, unit_name), &value))| {
            Number::new(name, unit_name, value, information.deviation(&unit(k)))
        });
        Self {
            numbers: numbers.collect(),
            covariance: (0..n).map(|i| (0..n).map(|j| information.covariance[(i, j)]).collect()).collect(),
            unknown: information
                .unknown
                .column_iter()
                .map(|column| column.iter().copied().collect())
                .collect(),
        }
    }

    /// Returns the covariance and the unobservable directions as an [`Information`].
    pub(crate) fn information(&self) -> Result<Information, IdentifyError> {
        let n = self.numbers.len();
        let c = &self.covariance;
        let unit = |k: usize| if c[k][k] > 0.0 { c[k][k].sqrt() } else { 1.0 };
        let correlations = DMatrix::from_fn(n, n, |i, j| c[i][j] / (unit(i) * unit(j)));
        let eigen = symmetric_eigen("the covariance of the estimate", correlations)?;
        let known: Vec<_> = eigen
            .eigenvalues
            .iter()
            .zip(eigen.eigenvectors.column_iter())
            .filter(|(value, _)| **value > NONE)
            .map(|(value, column)| DVector::from_fn(n, |i, _| column[i] * value.sqrt() * unit(i)))
            .collect();
        let unknown: Vec<_> = self.unknown.iter().map(|part| DVector::from_column_slice(part)).collect();
        Ok(Information::with(n, &known, &unknown))
    }

    /// Returns the parameter with a name.
    pub fn get(&self, name: &str) -> Option<&Number> {
        self.numbers.iter().find(|number| number.name == name)
    }

    /// Returns the correlation of two parameters; `None` if one is not determined or has no error.
    pub fn correlation(&self, i: usize, j: usize) -> Option<f64> {
        let (a, b) = (self.numbers.get(i)?.sd?, self.numbers.get(j)?.sd?);
        (a > 0.0 && b > 0.0).then(|| self.covariance[i][j] / (a * b))
    }

    /// Returns the standard deviation √(gᵀ C g) of a function with gradient g; `None` if the
    /// function changes along an unobservable direction.
    pub fn deviation(&self, gradient: &[f64]) -> Option<f64> {
        if self.unknown.iter().any(|unknown| changes_along(gradient, unknown)) {
            return None;
        }
        let variance: f64 = gradient
            .iter()
            .zip(&self.covariance)
            .map(|(a, row)| a * row.iter().zip(gradient).map(|(c, b)| c * b).sum::<f64>())
            .sum();
        Some(variance.max(0.0).sqrt())
    }

    /// Returns the parameters with the first `count` of them, x, divided by a linear function u·x.
    ///
    /// x/(u·x) has the covariance G C Gᵀ/(u·x)² with G = 1 − x uᵀ/(u·x). It is determined even if
    /// the size of x is not.
    pub(crate) fn relative(mut self, count: usize, u: &[f64]) -> Self {
        let n = self.numbers.len();
        let size: f64 = self.numbers.iter().zip(u).map(|(number, u)| u * number.value).sum();
        let over = |k: usize| if k < count { 1.0 / size } else { 1.0 };
        for k in 0..n {
            self.numbers[k].value *= over(k);
            self.covariance[k].iter_mut().enumerate().for_each(|(j, c)| *c *= over(k) * over(j));
        }
        for unknown in &mut self.unknown {
            unknown.iter_mut().enumerate().for_each(|(k, part)| *part *= over(k));
            let length = unknown.iter().map(|part| part * part).sum::<f64>().sqrt();
            unknown.iter_mut().for_each(|part| *part /= length);
        }
        let x: Vec<f64> = self.numbers.iter().map(|number| number.value).collect();
        // C − x (uᵀC) on rows, then on columns
        for _ in 0..2 {
            let along: Vec<f64> =
                (0..n).map(|j| u.iter().enumerate().map(|(i, u)| u * self.covariance[i][j]).sum()).collect();
            for (row, x) in self.covariance.iter_mut().zip(&x).take(count) {
                for (element, along) in row.iter_mut().zip(&along) {
                    *element -= x * along;
                }
            }
            self.covariance = (0..n).map(|i| (0..n).map(|j| self.covariance[j][i]).collect()).collect();
        }
        // An unobservable size of x does not change x/(u·x).
        let others: Vec<&Vec<f64>> =
            self.unknown.iter().filter(|unknown| !is_along(unknown, &x[..count])).collect();
        for (k, number) in self.numbers.iter_mut().enumerate() {
            if k < count {
                let gradient: Vec<f64> = (0..n)
                    .map(|i| f64::from(u8::from(i == k)) - u.get(i).map_or(0.0, |u| x[k] * u))
                    .collect();
                let is_unknown = others.iter().any(|unknown| changes_along(&gradient, unknown));
                number.sd = (!is_unknown).then(|| self.covariance[k][k].max(0.0).sqrt());
            }
        }
        self
    }

    /// Returns the estimate with all errors multiplied by a factor.
    pub(crate) fn widened(mut self, factor: f64) -> Self {
        for number in &mut self.numbers {
            number.sd = number.sd.map(|sd| sd * factor);
        }
        self.covariance.iter_mut().flatten().for_each(|c| *c *= factor * factor);
        self
    }
}

/// Returns true if a direction is parallel to the vector of the first numbers.
fn is_along(direction: &[f64], numbers: &[f64]) -> bool {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let cosine = dot(direction, numbers) / (dot(direction, direction) * dot(numbers, numbers)).sqrt();
    1.0 - f64::abs(cosine) < KNOWN
}
