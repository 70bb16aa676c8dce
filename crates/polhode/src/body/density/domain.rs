//! A solid as the image of unit cubes, and the bricks that the cubes are divided into.

use super::parametrised::Parametrised;
use super::rule::CubatureRule;
use crate::body::triangle_mesh::TriangleMesh;
use crate::math::symmetric3::power_of_two_near;

/// A solid in scaled coordinates ξ, centred near 0 with size about 1: x = reference + unit ξ.
pub(super) struct Domain<'a> {
    charts: Charts<'a>,
    reference: [f64; 3],
    unit: f64,
}

/// Maps from the unit cube into the solid.
enum Charts<'a> {
    /// Signed tetrahedra from the reference point to each triangle.
    Triangles(&'a TriangleMesh),
    Shape(&'a dyn Parametrised),
}

/// Image of a box in the unit cube under a chart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Brick {
    chart: usize,
    low: [f64; 3],
    high: [f64; 3],
}

/// Samples of one brick; the last coordinate varies fastest.
#[derive(Default)]
pub(super) struct Samples {
    /// Sample points x, m, passed to the density field.
    pub(super) points: Vec<[f64; 3]>,
    /// Sample points in scaled coordinates ξ.
    pub(super) local: Vec<[f64; 3]>,
    /// Volume per unit of weight, in units of `unit`³.
    pub(super) volumes: Vec<f64>,
    pub(super) densities: Vec<f64>,
}

/// Minimum width of a brick in the unit cube; narrower bricks are not divided.
const FINEST: f64 = 1e-13;

impl<'a> Domain<'a> {
    /// Returns the domain of a polyhedron, centred at its centroid; `size` is its radius of
    /// gyration, m.
    pub(super) fn of_surface(surface: &'a TriangleMesh, centroid: [f64; 3], size: f64) -> Self {
        Self { charts: Charts::Triangles(surface), reference: centroid, unit: power_of_two_near(size) }
    }

    /// Returns the domain of a shape, centred at its centroid; `size` is its radius of gyration, m.
    pub(super) fn of_shape(shape: &'a dyn Parametrised, centroid: [f64; 3], size: f64) -> Self {
        Self { charts: Charts::Shape(shape), reference: centroid, unit: power_of_two_near(size) }
    }

    pub(super) const fn unit(&self) -> f64 {
        self.unit
    }

    pub(super) const fn reference(&self) -> [f64; 3] {
        self.reference
    }

    /// Returns the initial bricks: the whole unit cube of each chart.
    pub(super) fn bricks(&self) -> impl ExactSizeIterator<Item = Brick> + use<> {
        let charts = match self.charts {
            Charts::Triangles(surface) => surface.triangles().len(),
            Charts::Shape(shape) => shape.charts(),
        };
        (0..charts).map(|chart| Brick { chart, low: [0.0; 3], high: [1.0; 3] })
    }

    /// Returns the cubature rule: one with fewer samples if the mesh has many triangles (thin
    /// cones).
    pub(super) fn rule(&self) -> CubatureRule {
        const MANY: usize = 1000;
        match self.charts {
            Charts::Triangles(surface) if surface.triangles().len() > MANY => CubatureRule::slender(),
            _ => CubatureRule::fine(),
        }
    }

    /// Fills in all fields of `samples` except the densities.
    pub(super) fn sample(&self, brick: &Brick, rule: &CubatureRule, samples: &mut Samples) {
        let Brick { chart, low, high } = *brick;
        let cube: f64 = (0..3).map(|k| high[k] - low[k]).product();
        let along = |k: usize, at: f64| low[k] + at * (high[k] - low[k]);
        let corners = self.corners(chart);
        samples.points.clear();
        samples.local.clear();
        samples.volumes.clear();
        let [first, second, third] = &rule.0;
        for u in first.nodes.iter().map(|node| along(0, node.at)) {
            for v in second.nodes.iter().map(|node| along(1, node.at)) {
                for w in third.nodes.iter().map(|node| along(2, node.at)) {
                    let (local, point, jacobian) = self.image(&corners, chart, [u, v, w]);
                    samples.local.push(local);
                    samples.points.push(point);
                    samples.volumes.push(jacobian * cube);
                }
            }
        }
        samples.densities.resize(samples.points.len(), 0.0);
    }

    /// Returns ξ, x, and the Jacobian determinant |∂ξ/∂(u, v, w)|.
    fn image(&self, corners: &Corners, chart: usize, uvw: [f64; 3]) -> ([f64; 3], [f64; 3], f64) {
        let Self { reference, unit, .. } = self;
        match &self.charts {
            Charts::Triangles(_) => {
                // ξ = u [a + v (b − a) + v w (c − b)],  |∂ξ/∂uvw| = u² v a · (b × c)
                let [u, v, w] = uvw;
                let Corners { corners: [a, b, c], triple } = corners;
                let [of_a, of_b, of_c] = [u * (1.0 - v), u * v * (1.0 - w), u * v * w];
                let local: [f64; 3] = core::array::from_fn(|k| of_a * a[k] + of_b * b[k] + of_c * c[k]);
                let point = core::array::from_fn(|k| reference[k] + unit * local[k]);
                (local, point, u * u * v * triple)
            }
            Charts::Shape(shape) => {
                let (point, jacobian) = shape.point(chart, uvw);
                let local = core::array::from_fn(|k| (point[k] - reference[k]) / unit);
                (local, point, jacobian / unit / unit / unit)
            }
        }
    }

    /// Returns the corners of the triangle of a chart, in ξ.
    fn corners(&self, chart: usize) -> Corners {
        let Charts::Triangles(surface) = &self.charts else { return Corners::default() };
        let Some(corners) = surface.triangles().get(chart) else { return Corners::default() };
        let triangle = corners.map(|index| surface.coordinates()[index as usize]);
        let [a, b, c] =
            triangle.map(|p| core::array::from_fn::<_, 3, _>(|k| (p[k] - self.reference[k]) / self.unit));
        let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
        let triple = a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1);
        Corners { corners: [a, b, c], triple }
    }

    /// Returns true if a brick counts negative: the reference point lies on the outer side of its
    /// triangle.
    pub(super) fn is_negative(&self, brick: &Brick) -> bool {
        self.corners(brick.chart).triple < 0.0
    }
}

/// Corners ξ of a triangle, and a · (b × c).
#[derive(Default)]
struct Corners {
    corners: [[f64; 3]; 3],
    triple: f64,
}

impl Brick {
    /// Returns the two halves of the brick across direction `k` of the cube, or `None` if it is too
    /// narrow.
    pub(super) fn halves(&self, k: usize) -> Option<[Self; 2]> {
        let Self { low, high, .. } = *self;
        if !(high[k] - low[k] > FINEST) {
            return None;
        }
        let (mut below, mut above) = (*self, *self);
        below.high[k] = 0.5 * low[k] + 0.5 * high[k];
        above.low[k] = below.high[k];
        Some([below, above])
    }
}
