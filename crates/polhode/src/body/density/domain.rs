//! A solid as the image of unit cubes, and the bricks that they are divided into.

use super::parametrised::Parametrised;
use super::rule::CubatureRule;
use crate::body::triangle_mesh::TriangleMesh;
use crate::math::symmetric3::power_of_two_near;

/// Where a solid is, in coordinates ξ in which it lies about 0 and is about 1 large: x = reference + unit ξ.
pub(super) struct Domain<'a> {
    charts: Charts<'a>,
    reference: [f64; 3],
    unit: f64,
}

/// What maps the unit cube into the solid.
enum Charts<'a> {
    /// To each triangle, the signed tetrahedron from the reference.
    Triangles(&'a TriangleMesh),
    Shape(&'a dyn Parametrised),
}

/// The image of a part of the unit cube under a chart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Brick {
    chart: usize,
    low: [f64; 3],
    high: [f64; 3],
}

/// The samples of one brick; the last coordinate varies fastest.
#[derive(Default)]
pub(super) struct Samples {
    /// x, m: what the field is asked for.
    pub(super) points: Vec<[f64; 3]>,
    /// ξ
    pub(super) local: Vec<[f64; 3]>,
    /// What a weight of 1 stands for, in units of volume.
    pub(super) volumes: Vec<f64>,
    pub(super) densities: Vec<f64>,
}

/// Parts of the cube narrower than this are not divided.
const FINEST: f64 = 1e-13;

impl<'a> Domain<'a> {
    /// Of a polyhedron: about its centroid, where `size` is its radius of gyration.
    pub(super) fn of_surface(surface: &'a TriangleMesh, centroid: [f64; 3], size: f64) -> Self {
        Self { charts: Charts::Triangles(surface), reference: centroid, unit: power_of_two_near(size) }
    }

    /// Of a shape.
    pub(super) fn of_shape(shape: &'a dyn Parametrised, centroid: [f64; 3], size: f64) -> Self {
        Self { charts: Charts::Shape(shape), reference: centroid, unit: power_of_two_near(size) }
    }

    pub(super) const fn unit(&self) -> f64 {
        self.unit
    }

    pub(super) const fn reference(&self) -> [f64; 3] {
        self.reference
    }

    /// The bricks to begin with.
    pub(super) fn bricks(&self) -> impl ExactSizeIterator<Item = Brick> + use<> {
        let charts = match self.charts {
            Charts::Triangles(surface) => surface.triangles().len(),
            Charts::Shape(shape) => shape.charts(),
        };
        (0..charts).map(|chart| Brick { chart, low: [0.0; 3], high: [1.0; 3] })
    }

    /// Few samples for each of many thin cones.
    pub(super) fn rule(&self) -> CubatureRule {
        const MANY: usize = 1000;
        match self.charts {
            Charts::Triangles(surface) if surface.triangles().len() > MANY => CubatureRule::slender(),
            _ => CubatureRule::fine(),
        }
    }

    /// Fills in everything but the densities.
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

    /// ξ, x, and the volume in units that a unit of the cube stands for.
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

    /// Of the triangle of a chart.
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

    /// Whether a brick counts negative: a triangle that is seen from behind.
    pub(super) fn is_negative(&self, brick: &Brick) -> bool {
        self.corners(brick.chart).triple < 0.0
    }
}

/// The corners ξ of a triangle, and a · (b × c).
#[derive(Default)]
struct Corners {
    corners: [[f64; 3]; 3],
    triple: f64,
}

impl Brick {
    /// Two halves across direction `k` of the cube; `None` if it is too narrow.
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
