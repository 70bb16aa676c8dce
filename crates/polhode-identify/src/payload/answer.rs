//! What a wrist carries, as it was found.

use nalgebra::DMatrix;
use polhode::body::MassProperties;
use polhode::math::{Body, symmetric_eigen};

use super::edge::Edge;
use super::finding::PayloadFinding;
use super::motion::PLACES;
use super::outliers::LeftOut;
use super::possible::moments_about_center;
use crate::estimate::Estimate;
use crate::least_squares::Information;
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
    /// Of forces, and of torques. With a covariance, torques are those that forces do not predict.
    pub tests: [ResidualTest; 2],
    /// Wrenches that were left out.
    pub left_out: Vec<LeftOut>,
    /// What is odd.
    pub findings: Vec<PayloadFinding>,
}

impl Payload {
    /// Principal moments and axes about the centre of mass; `None` of a point, which has none.
    pub fn principal(&self) -> Option<PrincipalEstimate> {
        let principal = PrincipalEstimate::of(&self.about_center, 4);
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

const AXES: [&str; 3] = ["x", "y", "z"];
const ELEMENTS: [&str; 6] = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];
const CHANNELS: [(&str, &str); 6] =
    [("fx", "N"), ("fy", "N"), ("fz", "N"), ("tx", "N·m"), ("ty", "N·m"), ("tz", "N·m")];

type Name = (String, &'static str);

fn names(first: &str, unit: &'static str, suffix: &str, count: usize) -> Vec<Name> {
    let mut all = vec![("mass".to_owned(), "kg")];
    all.extend(AXES.map(|axis| (format!("{first} {axis}"), unit)));
    all.extend(ELEMENTS.map(|element| (format!("{element}{suffix}"), "kg·m²")));
    all.extend(CHANNELS.map(|(channel, unit)| (format!("bias {channel}"), unit)));
    all.truncate(count);
    all
}

pub(super) fn about_origin(numbers: &[f64], information: &Information) -> Estimate {
    Estimate::new(names("moment", "kg·m", " about the origin", numbers.len()), numbers, information)
}

/// The same of m, c and the tensor about the centre of mass.
pub(super) fn about_center(numbers: &[f64], information: &Information) -> Estimate {
    let (values, jacobian) = to_center(numbers);
    Estimate::new(names("center", "m", "", numbers.len()), &values, &information.of_other(&jacobian))
}

/// Second moments, less what rounding has below zero where c is far off.
fn not_negative(g: [f64; 6]) -> [f64; 6] {
    let (values, vectors) = symmetric_eigen(g);
    if values[0] >= 0.0 {
        return g;
    }
    PLACES.map(|(i, j)| (0..3).map(|k| values[k].max(0.0) * vectors[k][i] * vectors[k][j]).sum())
}

/// m, c, I about the centre of mass, …, and their derivative by m, m c, I about the origin, …
pub(super) fn to_center(numbers: &[f64]) -> (Vec<f64>, DMatrix<f64>) {
    let n = numbers.len();
    let m = numbers[0];
    let c = [1, 2, 3].map(|k| numbers[k] / m);
    let mut values = numbers.to_vec();
    let mut jacobian = DMatrix::identity(n, n);
    let g = not_negative(moments_about_center(numbers));
    let own = [g[1] + g[2], g[0] + g[2], g[0] + g[1], -g[3], -g[4], -g[5]];
    for k in 0..3 {
        values[1 + k] = c[k];
        jacobian[(1 + k, 0)] = -c[k] / m;
        jacobian[(1 + k, 1 + k)] = 1.0 / m;
    }
    let square: f64 = c.iter().map(|c| c * c).sum();
    for (k, (i, j)) in PLACES.into_iter().enumerate() {
        values[4 + k] = own[k];
        // I_c = I − (h² δ_ij − h_i h_j)/m
        let same = if i == j { 1.0 } else { 0.0 };
        jacobian[(4 + k, 0)] = square * same - c[i] * c[j];
        for l in 0..3 {
            let by_i = if l == i { c[j] } else { 0.0 };
            let by_j = if l == j { c[i] } else { 0.0 };
            jacobian[(4 + k, 1 + l)] = by_i + by_j - 2.0 * c[l] * same;
        }
    }
    (values, jacobian)
}
