//! What a wrist carries, as it was found.

use polhode::body::MassProperties;
use polhode::math::Body;

use super::edge::Edge;
use super::finding::PayloadFinding;
use super::outliers::LeftOut;
use crate::estimate::Estimate;
use crate::principal::PrincipalEstimate;
use crate::residuals::ResidualTest;

/// A payload that was found. The origin is the sensor's, axes are the sensor's.
///
/// Errors are those of least squares without the constraint, widened by what the residuals show. The constraint brings no possible body farther from the
/// answer, in the norm of these errors, as the possible bodies are a convex set: so the ellipsoid of a confidence holds the truth at least as often as it says,
/// at the edge too. There [`Edge`] says what more is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Payload {
    /// `mass`; `moment x` … (m c); `Ixx about the origin` …; `bias fx` …, if it was to be found. The wrench is linear in these.
    pub about_origin: Estimate,
    /// `mass`; `center x` …; `Ixx` … about the centre of mass; `bias fx` …
    pub about_center: Estimate,
    /// The payload, if all of it is known.
    pub body: Option<MassProperties<Body>>,
    /// Least squares without regard to what is possible.
    pub unconstrained: Unconstrained,
    /// If the answer is at the edge of what is possible.
    pub edge: Option<Edge>,
    /// Times of the rows, s.
    pub times: Vec<f64>,
    /// Of forces, and of torques. With a covariance, torques are those that forces do not predict.
    pub tests: [ResidualTest; 2],
    /// Measured less predicted, of each row: fx, fy, fz in N, τx, τy, τz in N·m.
    pub residuals: Vec<[f64; 6]>,
    /// Wrenches that were left out.
    pub left_out: Vec<LeftOut>,
    /// What is odd.
    pub findings: Vec<PayloadFinding>,
}

impl Payload {
    /// Principal moments and axes about the centre of mass; `None` of a point, which has none.
    pub fn principal(&self) -> Option<PrincipalEstimate> {
        let principal = PrincipalEstimate::of_tensor(&self.about_center, 4);
        (principal.moments[2] > 0.0).then_some(principal)
    }
}

/// Numbers of least squares that need not be a body's.
#[derive(Clone, Debug, PartialEq)]
pub struct Unconstrained {
    /// In the order of [`Payload::about_origin`].
    pub numbers: Vec<f64>,
    /// Whether they are a possible body's.
    pub is_possible: bool,
    /// The least eigenvalue of ∫ x xᵀ dm about the centre of mass, kg·m²: negative of what is impossible. `None` if the mass is not positive.
    pub least_second_moment: Option<f64>,
    /// By how much χ² rises where the body has to be possible.
    pub chi_square_rise: f64,
}
