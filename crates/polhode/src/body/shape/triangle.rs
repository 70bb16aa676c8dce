//! Triangle in the plane z = 0, shared by the triangular plate and the prism.

use crate::body::error::BodyError;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};

/// Triangle with a positive area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Triangle {
    /// Corners (x, y), m.
    pub(in crate::body) vertices: [[f64; 2]; 3],
}

/// Area threshold relative to the product of the edges; a smaller area may be rounding only.
const FLAT: f64 = 4.0 * f64::EPSILON;

impl Triangle {
    /// Returns the triangle with the given corners in either orientation. `vertex` and `area` are
    /// the names of the coordinates and of the area in errors.
    pub(super) fn new(
        vertices: [[f64; 2]; 3],
        vertex: &'static str,
        area: &'static str,
    ) -> Result<Self, BodyError> {
        if let Some(&value) = vertices.iter().flatten().find(|x| !x.is_finite()) {
            return Err(BodyError::Parameter { what: vertex, value, rule: "finite" });
        }
        let triangle = Self { vertices };
        let edges = triangle.edges();
        // Lengths are scaled by a power of two near the size: this is exact, and no product
        // overflows.
        let unit = power_of_two_near(edges.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs())));
        let [u, v] = edges.map(|edge| edge.map(|x| x / unit));
        let norm = |[x, y]: [f64; 2]| libm::hypot(x, y);
        let spans = cross(u, v).abs() / 2.0 > FLAT * norm(u) * norm(v);
        if !spans {
            let rule = "positive: its corners may not lie on one line";
            return Err(BodyError::Parameter { what: area, value: triangle.area(), rule });
        }
        Ok(triangle)
    }

    /// Returns the edges from the first corner to the others.
    fn edges(&self) -> [[f64; 2]; 2] {
        let [o, a, b] = self.vertices;
        [a, b].map(|p| [p[0] - o[0], p[1] - o[1]])
    }

    pub(in crate::body) fn area(&self) -> f64 {
        let [u, v] = self.edges();
        0.5 * cross(u, v).abs()
    }

    pub(super) fn perimeter(&self) -> f64 {
        let [u, v] = self.edges();
        [u, v, [v[0] - u[0], v[1] - u[1]]].into_iter().map(|[x, y]| libm::hypot(x, y)).sum()
    }

    /// Returns the centroid p̄ and the second moments about it per unit area, ⟨x xᵀ⟩ = 1/12 Σ
    /// (p_k − p̄)(p_k − p̄)ᵀ: the sum over the corners, each with a twelfth of the mass.
    ///
    /// Source: ∫ L₁ᵃ L₂ᵇ L₃ᶜ dA = 2A a! b! c!/(a + b + c + 2)! in area coordinates; Eisenberg,
    /// Malvern, Int. J. Numer. Methods Eng. 7 (1973) 574.
    pub(super) fn moments(&self) -> ([f64; 2], Symmetric3) {
        let [u, v] = self.edges();
        // Relative to the first corner, so that a position far from the origin costs no digits.
        let center: [f64; 2] = [0, 1].map(|k| (u[k] + v[k]) / 3.0);
        let corners = [[0.0; 2], u, v].map(|p| [p[0] - center[0], p[1] - center[1], 0.0]);
        let sum = corners.into_iter().fold(Symmetric3::default(), |sum, d| sum + Symmetric3::outer(d));
        let [x, y] = self.vertices[0];
        ([x + center[0], y + center[1]], sum * (1.0 / 12.0))
    }
}

fn cross([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    a * d - b * c
}
