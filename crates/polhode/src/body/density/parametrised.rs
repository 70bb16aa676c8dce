//! Solids as smooth images of the unit cube.

use crate::body::shape::Shape;
use crate::body::shape::r#box::BoxShape;
use crate::body::shape::capsule::Capsule;
use crate::body::shape::cone::Cone;
use crate::body::shape::cylinder::Cylinder;
use crate::body::shape::ellipsoid::Ellipsoid;
use crate::body::shape::sphere::Sphere;
use crate::body::shape::tetrahedron::Tetrahedron;
use crate::body::shape::torus::Torus;
use crate::body::shape::triangular_prism::TriangularPrism;
use crate::math::number::PI;

/// Solid that is the image of the unit cube under one or several smooth maps, its *charts*, whose
/// images do not overlap.
///
/// A function over the solid becomes an analytic function over the cube, for which product rules
/// converge fast. The function is never evaluated outside the solid.
///
/// ```
/// use polhode::body::density::Parametrised;
/// use polhode::body::shape::Cylinder;
/// let ([x, y, z], jacobian) = Cylinder::new(2.0, 3.0)?.point(0, [0.5, 0.25, 0.75]);
/// assert!(x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 0.75);
/// assert!((jacobian - std::f64::consts::PI * 2.0 * 2.0 * 3.0).abs() < 1e-13); // m³ per unit of the cube
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
pub trait Parametrised: Shape {
    /// Returns the number of charts.
    fn charts(&self) -> usize {
        1
    }

    /// Returns the image of (u, v, w) in the unit cube under chart `chart` (from 0): the point, m,
    /// in the shape's own axes, and the Jacobian determinant |∂(x, y, z)/∂(u, v, w)|, m³.
    fn point(&self, chart: usize, uvw: [f64; 3]) -> ([f64; 3], f64);
}

impl Parametrised for BoxShape {
    fn point(&self, _chart: usize, [u, v, w]: [f64; 3]) -> ([f64; 3], f64) {
        let [a, b, c] = self.size;
        ([a * (u - 0.5), b * (v - 0.5), c * (w - 0.5)], a * b * c)
    }
}

impl Parametrised for Sphere {
    /// Returns the point at the relative radius r/R = k + (1 − k) u, where k = inner radius / R.
    fn point(&self, _chart: usize, [u, v, w]: [f64; 3]) -> ([f64; 3], f64) {
        let Self { radius, inner_radius: inner } = *self;
        let wall = (radius - inner) / radius;
        let (point, jacobian) = ball([radius; 3], [inner / radius + wall * u, v, w], PI);
        (point, wall * jacobian)
    }
}

impl Parametrised for Ellipsoid {
    fn point(&self, _chart: usize, uvw: [f64; 3]) -> ([f64; 3], f64) {
        ball(self.semi_axes, uvw, PI)
    }
}

impl Parametrised for Cylinder {
    fn point(&self, _chart: usize, [u, v, w]: [f64; 3]) -> ([f64; 3], f64) {
        let Self { radius, inner_radius: inner, length } = *self;
        let (sin, cos) = libm::sincos(2.0 * PI * v);
        let wall = radius - inner;
        let r = inner + wall * u;
        ([r * cos, r * sin, length * (w - 0.5)], 2.0 * PI * wall * r * length)
    }
}

/// Charts: 0 is the cylinder, 1 the upper cap, 2 the lower cap.
impl Parametrised for Capsule {
    fn charts(&self) -> usize {
        3
    }

    fn point(&self, chart: usize, uvw: [f64; 3]) -> ([f64; 3], f64) {
        let Self { radius, length } = *self;
        if chart == 0 {
            return Cylinder { radius, inner_radius: 0.0, length }.point(0, uvw);
        }
        let side = if chart == 1 { 1.0 } else { -1.0 };
        let ([x, y, z], jacobian) = ball([radius; 3], uvw, 0.5 * PI);
        ([x, y, side * (0.5 * length + z)], jacobian)
    }
}

impl Parametrised for Cone {
    fn point(&self, _chart: usize, [u, v, w]: [f64; 3]) -> ([f64; 3], f64) {
        let Self { base_radius, top_radius, height } = *self;
        let (sin, cos) = libm::sincos(2.0 * PI * v);
        let edge = base_radius + (top_radius - base_radius) * w;
        let r = edge * u;
        ([r * cos, r * sin, height * w], 2.0 * PI * edge * r * height)
    }
}

impl Parametrised for Torus {
    fn point(&self, _chart: usize, [u, v, w]: [f64; 3]) -> ([f64; 3], f64) {
        let (sin_tube, cos_tube) = libm::sincos(2.0 * PI * v);
        let (sin_ring, cos_ring) = libm::sincos(2.0 * PI * w);
        let r = self.tube_radius * u;
        let from_axis = self.ring_radius + r * cos_tube;
        let jacobian = 4.0 * PI * PI * self.tube_radius * r * from_axis;
        ([from_axis * cos_ring, from_axis * sin_ring, r * sin_tube], jacobian)
    }
}

impl Parametrised for Tetrahedron {
    /// Returns x = o + u [a + v (b − a) + v w (c − b)], with the edges a, b, c from the first
    /// corner o, and |∂x/∂(u, v, w)| = u² v |a · b × c|.
    fn point(&self, _chart: usize, [u, v, w]: [f64; 3]) -> ([f64; 3], f64) {
        let [o, a, b, c] = self.vertices;
        let shares = [u * (1.0 - v), u * v * (1.0 - w), u * v * w];
        let at = core::array::from_fn(|k| {
            o[k] + shares[0] * (a[k] - o[k]) + shares[1] * (b[k] - o[k]) + shares[2] * (c[k] - o[k])
        });
        (at, 6.0 * self.spread().extent().measure() * u * u * v)
    }
}

impl Parametrised for TriangularPrism {
    /// Returns (x, y) = o + u [a + v (b − a)], with the edges a, b from the first corner o and
    /// |∂(x, y)/∂(u, v)| = u |a × b|; z is uniform along the length.
    fn point(&self, _chart: usize, [u, v, w]: [f64; 3]) -> ([f64; 3], f64) {
        let [o, a, b] = self.triangle.vertices;
        let [x, y] = core::array::from_fn(|k| o[k] + u * ((1.0 - v) * (a[k] - o[k]) + v * (b[k] - o[k])));
        ([x, y, self.length * (w - 0.5)], 2.0 * self.triangle.area() * u * self.length)
    }
}

/// Returns the image of (r, v, w) in the part of an ellipsoid from the pole to the polar angle
/// `widest`: x = (a r sin θ cos φ, b r sin θ sin φ, c r cos θ) with θ = `widest` v, φ = 2π w.
fn ball([a, b, c]: [f64; 3], [r, v, w]: [f64; 3], widest: f64) -> ([f64; 3], f64) {
    let (sin_theta, cos_theta) = libm::sincos(widest * v);
    let (sin_phi, cos_phi) = libm::sincos(2.0 * PI * w);
    let across = r * sin_theta;
    let jacobian = 2.0 * PI * widest * a * b * c * r * across;
    ([a * across * cos_phi, b * across * sin_phi, c * r * cos_theta], jacobian)
}
