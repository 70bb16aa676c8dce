//! Exact orientation tests: the side of a plane or a line on which a point lies.
//!
//! The f64 result is used if its sign is certain. Otherwise the crate `robust` evaluates the
//! expansions of Shewchuk, Discrete Comput. Geom. 18 (1997) 305.

use robust::{Coord, Coord3D, orient2d, orient3d};

use crate::body::triangle_mesh::normal;

/// Returns a positive value if p is on the side of the plane through a, b, c to which the normal
/// (b − a) × (c − a) points, and 0 if it is in the plane.
#[inline(always)]
pub(crate) fn side([a, b, c]: [[f64; 3]; 3], p: [f64; 3]) -> f64 {
    let from = |q: [f64; 3]| [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (from(a), from(b), from(c));
    let products = [[bx * cy, cx * by], [cx * ay, ax * cy], [ax * by, bx * ay]];
    let [n, m, k] = products.map(|[u, v]| v - u);
    let determinant = az * n + bz * m + cz * k;
    let [n, m, k] = products.map(|[u, v]| u.abs() + v.abs());
    let permanent = n * az.abs() + m * bz.abs() + k * cz.abs();
    if determinant.abs() > SURE_3D * permanent || permanent == 0.0 {
        return determinant;
    }
    exact_side([a, b, c], p)
}

/// Error bound (7 + 56 ε) ε, ε = 2⁻⁵³ (Shewchuk's o3derrboundA), rounded up.
const SURE_3D: f64 = 7.772e-16;

#[cold]
fn exact_side(triangle: [[f64; 3]; 3], p: [f64; 3]) -> f64 {
    let coord = |[x, y, z]: [f64; 3]| Coord3D { x, y, z };
    let [a, b, c] = triangle.map(coord);
    -orient3d(a, b, c, coord(p))
}

/// Plane of a triangle in f64, for quick tests of many points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    corner: [f64; 3],
    normal: [f64; 3],
    /// Bound of the error of a distance along each axis, relative to that distance.
    bound: f64,
}

impl Plane {
    #[inline(always)]
    pub(crate) fn of([a, b, c]: &[[f64; 3]; 3]) -> Self {
        let [bx, by, bz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let [cx, cy, cz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
        let ([p, q, r], [u, v, w]) = ([by * cz, bz * cx, bx * cy], [bz * cy, bx * cz, by * cx]);
        let products = (p.abs() + u.abs()).max(q.abs() + v.abs()).max(r.abs() + w.abs());
        Self { corner: *a, normal: [p - u, q - v, r - w], bound: SURE_PLANE * products }
    }

    /// Returns a value with the sign of [`side`] if that sign is certain, otherwise 0.
    #[inline(always)]
    pub(crate) fn certain_side(&self, p: &[f64; 3]) -> f64 {
        let Self { corner: a, normal: n, bound } = self;
        let [x, y, z] = [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let side = n[0] * x + n[1] * y + n[2] * z;
        let error = bound * (x.abs() + y.abs() + z.abs()) + f64::MIN_POSITIVE;
        if side.abs() > error { side } else { 0.0 }
    }
}

/// Error bound of the terms of [`Plane::certain_side`], ε = 2⁻⁵³: a term has three differences, two
/// products and three sums, so that it is exact to about 8 ε; doubled for the rounding of the bound.
const SURE_PLANE: f64 = 1.8e-15;

/// Returns a positive value if a, b, p are in counter-clockwise order, and 0 if they are collinear.
pub(crate) fn turn(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    let coord = |[x, y]: [f64; 2]| Coord { x, y };
    orient2d(coord(a), coord(b), coord(p))
}

/// Returns the same value as `turn` if the f64 sign is certain, otherwise 0.
#[inline(always)]
pub(crate) fn certain_turn(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    let (left, right) = ((a[0] - p[0]) * (b[1] - p[1]), (a[1] - p[1]) * (b[0] - p[0]));
    let turn = left - right;
    if turn.abs() > SURE_2D * (left.abs() + right.abs()) + f64::MIN_POSITIVE { turn } else { 0.0 }
}

/// Error bound (3 + 16 ε) ε, ε = 2⁻⁵³ (Shewchuk's ccwerrboundA), rounded up.
const SURE_2D: f64 = 3.331e-16;

/// Returns the two coordinates perpendicular to an axis, such that rotation about the axis is
/// positive.
pub(crate) fn across(axis: usize, p: [f64; 3]) -> [f64; 2] {
    [p[(axis + 1) % 3], p[(axis + 2) % 3]]
}

/// Returns an axis along which the triangle has projected area, and the sign of that area; `None`
/// if its corners are collinear.
pub(crate) fn facing([a, b, c]: [[f64; 3]; 3]) -> Option<(usize, f64)> {
    let normal = normal([a, b, c]);
    let mut axes = [0, 1, 2];
    axes.sort_by(|&i, &j| normal[j].abs().total_cmp(&normal[i].abs()));
    axes.into_iter().find_map(|axis| {
        let area = turn(across(axis, a), across(axis, b), across(axis, c));
        (area != 0.0).then_some((axis, area.signum()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_are_those_of_integers() {
        // Points on and next to an oblique plane, for which f64 alone gives wrong signs.
        let (a, b, c) = ([0.1, 0.2, 0.3], [1.7, 0.1, -0.4], [0.6, 0.9, 0.8]);
        let (mut unsure, mut sure, scale) = (0, 0, 2.0_f64.powi(40));
        let grid = |p: [f64; 3]| p.map(|x: f64| (x * scale).round());
        let [a, b, c] = [a, b, c].map(grid);
        for k in 0..1000 {
            let (s, t) = (f64::from(k) * 0.37 % 1.0, f64::from(k) * 0.71 % 1.0);
            let p = grid(core::array::from_fn(|i| (a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i])) / scale));
            let from = |q: [f64; 3]| -> [i128; 3] { core::array::from_fn(|i| q[i] as i128 - a[i] as i128) };
            let ([x, y, z], [u, v, w], [p0, p1, p2]) = (from(b), from(c), from(p));
            let exact = (y * w - z * v) * p0 + (z * u - x * w) * p1 + (x * v - y * u) * p2;
            assert_eq!(side([a, b, c], p).partial_cmp(&0.0), exact.partial_cmp(&0));
            assert_eq!(side([b, a, c], p).partial_cmp(&0.0), 0.partial_cmp(&exact));
            let certain = Plane::of(&[a, b, c]).certain_side(&p);
            assert!(certain == 0.0 || certain.signum() == exact.signum() as f64, "{certain} {exact}");
            let far = core::array::from_fn(|i| p[i] + 1e-9 * (a[i] - 2.0 * b[i]) + 3e-8 * c[(i + 1) % 3]);
            sure += usize::from(Plane::of(&[a, b, c]).certain_side(&far) != 0.0);
            unsure += usize::from(exact.abs() < 1 << 90);
        }
        assert!(unsure > 0 && sure > 900, "{sure}");
    }

    #[test]
    fn a_triangle_faces_where_its_normal_points() {
        let triangle = [[0.0, 0.0, 0.0], [1.0, 0.1, 0.2], [-0.1, 2.0, 0.3]];
        assert_eq!(facing(triangle), Some((2, 1.0)));
        assert!(side(triangle, [0.0, 0.0, 1.0]) > 0.0);
        assert_eq!(facing([[0.0; 3], [1.0, 2.0, 3.0], [2.0, 4.0, 6.0]]), None);
    }
}
