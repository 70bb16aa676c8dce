//! Boundary of physical consistency: laminae, rods, points.

use core::fmt;

use nalgebra::DMatrix;
use polhode::math::symmetric_eigen;

use super::about::about_center;
use super::possible::moments_about_center;
use crate::decomposition::qr;
use crate::error::IdentifyError;
use crate::estimate::Estimate;
use crate::least_squares::{Information, columns};

/// Kind of a body without extent in some directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeKind {
    /// No extent in one direction: a plate.
    Lamina,
    /// No extent in two directions: a thin bar.
    Rod,
    /// No extent in any direction.
    Point,
}

impl EdgeKind {
    /// Returns the number of directions without extent.
    pub(super) const fn thin(self) -> usize {
        match self {
            Self::Lamina => 1,
            Self::Rod => 2,
            Self::Point => 3,
        }
    }
}

impl fmt::Display for EdgeKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Lamina => "a lamina",
            Self::Rod => "a rod",
            Self::Point => "a point",
        })
    }
}

/// Boundary of physical consistency on which the estimate lies. The estimate has no extent in some
/// directions, because noise makes the unconstrained second moment there negative.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// Kind of the boundary.
    pub kind: EdgeKind,
    /// Directions without extent.
    pub thin: Vec<Thin>,
    /// Estimate about the centre, if the payload really lies on this boundary. Its errors are
    /// smaller, because it varies only along the boundary. `None` if the measurements do not
    /// determine these directions.
    pub along: Option<Estimate>,
}

/// Direction without extent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thin {
    /// Unit vector, sensor axes.
    pub direction: [f64; 3],
    /// Second moment ∫ x² dm along the direction, from the centre of mass, of unconstrained least
    /// squares: mostly negative, kg·m².
    pub unconstrained: f64,
    /// Standard deviation of the second moment, kg·m².
    pub sd: f64,
    /// Upper bound on ∫ x² dm at 95 % confidence, kg·m²: 1.645 standard deviations above the
    /// estimate or above zero, whichever is larger.
    pub at_most: f64,
}

impl Thin {
    /// Returns the thickness of a uniform plate of this mass with the largest second moment
    /// `at_most`: √(12 ∫ x² dm / m), m.
    pub fn thickness_at_most(&self, mass: f64) -> f64 {
        (12.0 * self.at_most / mass).sqrt()
    }
}

/// One-sided 95 % quantile of the normal distribution.
const ONE_SIDED: f64 = 1.645;
/// Threshold below which a second moment is zero, standard deviations.
const NONE: f64 = 1e-3;

impl Edge {
    /// Returns the boundary of an estimate; `None` if the estimate lies inside.
    pub(super) fn of(
        numbers: &[f64],
        unconstrained: &[f64],
        information: &Information,
    ) -> Result<Option<Self>, IdentifyError> {
        let (values, vectors) = symmetric_eigen(moments_about_center(numbers));
        let mut thin = Vec::new();
        for (value, direction) in values.into_iter().zip(vectors) {
            let slope = gradient(numbers, direction, direction);
            let Some(sd) = information.deviation(&slope) else { continue };
            if value < NONE * sd {
                let change: f64 = slope
                    .iter()
                    .zip(numbers)
                    .zip(unconstrained)
                    .map(|((s, here), free)| s * (free - here))
                    .sum();
                let at_most = (value + change).max(0.0) + ONE_SIDED * sd;
                thin.push(Thin { direction, unconstrained: value + change, sd, at_most });
            }
        }
        let kind = match thin.len() {
            1 => EdgeKind::Lamina,
            2 => EdgeKind::Rod,
            3 => EdgeKind::Point,
            _ => return Ok(None),
        };
        let normals: Vec<_> = thin.iter().map(|thin| thin.direction).collect();
        let along = along(numbers, &normals, information)?.map(|along| about_center(numbers, &along));
        Ok(Some(Self { kind, thin, along }))
    }

    /// Returns the boundary with all errors multiplied by a factor.
    pub(super) fn widened(mut self, factor: f64) -> Self {
        for thin in &mut self.thin {
            thin.sd *= factor;
            thin.at_most = thin.unconstrained.max(0.0) + ONE_SIDED * thin.sd;
        }
        self.along = self.along.map(|along| along.widened(factor));
        self
    }
}

/// Returns the information on a body of this kind.
pub(super) fn of_kind(
    numbers: &[f64],
    kind: EdgeKind,
    information: &Information,
) -> Result<Option<Information>, IdentifyError> {
    let (_, vectors) = symmetric_eigen(moments_about_center(numbers));
    along(numbers, &vectors[..kind.thin()], information)
}

/// Returns the information under the constraint nᵀ G n' = 0 for all normals n, n'. `None` if the
/// measurements do not determine these elements.
fn along(
    numbers: &[f64],
    normals: &[[f64; 3]],
    information: &Information,
) -> Result<Option<Information>, IdentifyError> {
    let n = numbers.len();
    let slopes: Vec<_> = (0..normals.len())
        .flat_map(|i| (0..=i).map(move |j| (i, j)))
        .map(|(i, j)| gradient(numbers, normals[i], normals[j]))
        .collect();
    // With δ = root e, e of unit variance, the components of e across the boundary are removed.
    let mut across = DMatrix::zeros(information.root.ncols(), slopes.len());
    for (k, slope) in slopes.into_iter().enumerate() {
        if information.deviation(&slope).is_none() {
            return Ok(None);
        }
        let scaled = information.root.tr_mul(&DMatrix::from_vec(n, 1, slope));
        across.set_column(k, &(&scaled / scaled.norm()).column(0));
    }
    let q = qr("the directions perpendicular to the limit of physical bodies", across)?.q();
    let rest = &information.root - &information.root * &q * q.transpose();
    Ok(Some(Information::with(n, &columns(&rest), &columns(&information.unknown))))
}

/// Returns the gradient of aᵀ G b by the parameters, with G = ½ tr(I) 1 − I − h hᵀ/m.
pub(super) fn gradient(numbers: &[f64], a: [f64; 3], b: [f64; 3]) -> Vec<f64> {
    let m = numbers[0];
    let c = [1, 2, 3].map(|k| numbers[k] / m);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (ca, cb, ab) = (dot(c, a), dot(c, b), dot(a, b));
    let mut slope = vec![0.0; numbers.len()];
    slope[0] = ca * cb;
    for k in 0..3 {
        slope[1 + k] = -(ca * b[k] + cb * a[k]);
        slope[4 + k] = 0.5 * ab - a[k] * b[k];
    }
    for (k, (i, j)) in [(0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
        slope[7 + k] = -(a[i] * b[j] + a[j] * b[i]);
    }
    slope
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::six::PLACES;

    /// Returns aᵀ G b of the parameters.
    fn along_two(numbers: &[f64], a: [f64; 3], b: [f64; 3]) -> f64 {
        let mut g = [[0.0; 3]; 3];
        for (element, (i, j)) in moments_about_center(numbers).into_iter().zip(PLACES) {
            g[i][j] = element;
            g[j][i] = element;
        }
        (0..3).map(|i| (0..3).map(|j| a[i] * g[i][j] * b[j]).sum::<f64>()).sum()
    }

    #[test]
    fn the_gradient_is_that_of_differences() {
        let numbers = [1.7, 0.42, -0.8, 0.51, 0.9, 0.71, 0.77, -0.12, 0.083, -0.17];
        let (a, b) = ([0.48, -0.6, 0.64], [0.3, 0.2, -0.7]);
        for (k, slope) in gradient(&numbers, a, b).into_iter().enumerate() {
            let at = |step: f64| {
                let mut moved = numbers;
                moved[k] += step;
                along_two(&moved, a, b)
            };
            let measured = (at(1e-5) - at(-1e-5)) / 2e-5;
            assert!((slope - measured).abs() < 1e-9, "{k}: {slope}, {measured}");
            assert!(slope.abs() > 1e-3, "{k}");
        }
    }
}
