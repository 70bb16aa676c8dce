//! Result of a payload identification.

use polhode::body::MassProperties;
use polhode::math::Body;

use super::edge::Edge;
use super::finding::PayloadFinding;
use super::outliers::LeftOut;
use crate::estimate::Estimate;
use crate::principal::PrincipalEstimate;
use crate::residuals::ResidualTest;

/// Estimated payload, about the sensor's origin and along its axes.
///
/// Errors are those of unconstrained least squares, widened by the residuals. The physically
/// consistent bodies are a convex set, so in the norm of these errors the constraint moves the
/// estimate closer to every consistent body. A confidence ellipsoid therefore contains the truth at
/// least as often as stated, at the boundary too. [`Edge`] gives tighter errors there.
#[derive(Clone, Debug, PartialEq)]
pub struct Payload {
    /// Parameters in which the wrench is linear: `mass`; `moment x` … (m c); `Ixx about the origin`
    /// …; `bias fx` …, if estimated.
    pub about_origin: Estimate,
    /// The same estimate as `mass`; `center x` …; `Ixx` … about the centre of mass; `bias fx` …
    pub about_center: Estimate,
    /// Mass properties; `None` unless all of them are determined.
    pub body: Option<MassProperties<Body>>,
    /// Least squares without the constraint of physical consistency.
    pub unconstrained: Unconstrained,
    /// Boundary of physical consistency on which the estimate lies, if any.
    pub edge: Option<Edge>,
    /// Times of the rows, s.
    pub times: Vec<f64>,
    /// Residual tests of forces and of torques. With a full covariance, the torques are conditional
    /// on the forces.
    pub tests: [ResidualTest; 2],
    /// Residuals (measured − predicted) of each row: fx, fy, fz in N, τx, τy, τz in N·m.
    pub residuals: Vec<[f64; 6]>,
    /// Wrenches left out as outliers.
    pub left_out: Vec<LeftOut>,
    /// Suspicious properties of the log.
    pub findings: Vec<PayloadFinding>,
}

impl Payload {
    /// Returns principal moments and axes about the centre of mass; `None` for a point mass, which
    /// has none.
    pub fn principal(&self) -> Option<PrincipalEstimate> {
        let principal = PrincipalEstimate::of_tensor(&self.about_center, 4);
        (principal.moments[2] > 0.0).then_some(principal)
    }
}

/// Unconstrained least-squares parameters, which need not be physically consistent.
#[derive(Clone, Debug, PartialEq)]
pub struct Unconstrained {
    /// Values in the order of [`Payload::about_origin`].
    pub numbers: Vec<f64>,
    /// True if the values are physically consistent.
    pub is_possible: bool,
    /// Smallest eigenvalue of ∫ x xᵀ dm about the centre of mass, kg·m²: negative if inconsistent.
    /// `None` if the mass is not positive.
    pub least_second_moment: Option<f64>,
    /// Increase of χ² caused by the constraint.
    pub chi_square_rise: f64,
}
