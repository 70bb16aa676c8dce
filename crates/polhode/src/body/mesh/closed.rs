//! Solids bounded by triangles.

use super::Triangle;
use crate::body::error::BodyError;
use crate::body::shape::{Extent, Shape, Spread};
use crate::math::frame::Part;
use crate::math::sum::Sum;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::vector::{Direction, Position};

/// A solid bounded by triangles: closed, consistently wound, its normals outward.
///
/// Made by [`ClosedMesh::from_triangles`], which refuses anything else. Corners are the same vertex when
/// their coordinates are equal, exactly. Where parts overlap they count as often as they overlap, and a part
/// wound inward counts as a cavity, wherever it is.
///
/// ```
/// use polhode::{ClosedMesh, Shape, Substance};
/// let [o, x, y, z] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
/// let corner = ClosedMesh::from_triangles(vec![[o, y, x], [o, x, z], [o, z, y], [x, y, z]])?;
/// assert_eq!(corner.volume(), 1.0);
/// let body = corner.mass_properties(Substance::Density(4.0))?;
/// assert!((body.center_of_mass() - polhode::Position::new(0.5, 0.75, 0.25)).norm() < 1e-15);
/// # Ok::<(), polhode::BodyError>(())
/// ```
#[derive(Clone, Debug)]
pub struct ClosedMesh {
    triangles: Vec<Triangle>,
    vertices: usize,
    degenerate: usize,
    inverted: bool,
    spread: Spread,
    area: f64,
}

impl ClosedMesh {
    /// The solid that the triangles bound.
    ///
    /// A mesh whose normals point inward is turned, and says so ([`ClosedMesh::inverted`]). Triangles with
    /// two equal corners bound nothing and are left out ([`ClosedMesh::degenerate`]).
    ///
    /// # Errors
    /// [`BodyError::Empty`], [`BodyError::Vertex`], [`BodyError::DuplicateTriangle`],
    /// [`BodyError::OpenMesh`], [`BodyError::InconsistentWinding`] or [`BodyError::FlatMesh`];
    /// [`BodyError::Parameter`] if f64 does not hold its volume.
    pub fn from_triangles(triangles: Vec<Triangle>) -> Result<Self, BodyError> {
        let given = triangles.len();
        for (k, triangle) in triangles.iter().enumerate() {
            if let Some(&vertex) = triangle.iter().find(|v| v.iter().any(|c| !c.is_finite())) {
                return Err(BodyError::Vertex { triangle: k + 1, vertex });
            }
        }
        let (corners, vertices) = weld(&triangles);
        require_different(&corners)?;
        require_closed(&triangles, &corners)?;
        let mut triangles: Vec<Triangle> = triangles
            .into_iter()
            .zip(&corners)
            .filter_map(|(triangle, corners)| is_proper(corners).then_some(triangle))
            .collect();
        if triangles.is_empty() {
            return Err(BodyError::Empty { what: "triangles" });
        }
        let (mut spread, area, inverted) = integrate(&triangles)?;
        if inverted {
            for [_, b, c] in &mut triangles {
                core::mem::swap(b, c);
            }
            spread.extent = Extent::Volume(spread.extent.measure().abs());
        }
        let spread = spread.representable()?;
        Ok(Self { degenerate: given - triangles.len(), triangles, vertices, inverted, spread, area })
    }

    /// The solid that a mesh bounds.
    ///
    /// # Errors
    /// As [`ClosedMesh::from_triangles`].
    pub fn of(mesh: &super::TriangleMesh) -> Result<Self, BodyError> {
        Self::from_triangles(mesh.corners().collect())
    }

    /// What was turned or left out.
    pub fn findings(&self) -> Vec<crate::Finding> {
        Vec::new()
    }

    /// The triangles, normals outward, without degenerate ones.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// Different corners.
    pub const fn vertices(&self) -> usize {
        self.vertices
    }

    /// Triangles that had two equal corners and were left out.
    pub const fn degenerate(&self) -> usize {
        self.degenerate
    }

    /// True if the normals pointed inward and were turned.
    pub const fn inverted(&self) -> bool {
        self.inverted
    }

    /// Enclosed volume, m³.
    pub const fn volume(&self) -> f64 {
        self.spread.extent.measure()
    }
}

impl Shape for ClosedMesh {
    fn spread(&self) -> Spread {
        self.spread
    }

    /// Area of all triangles, m².
    fn surface_area(&self) -> f64 {
        self.area
    }
}

/// Each triangle's corners as vertex numbers, equal where the coordinates are; and how many vertices there
/// are.
fn weld(triangles: &[Triangle]) -> (Vec<[u32; 3]>, usize) {
    let points: Vec<[f64; 3]> = triangles.iter().flatten().map(|p| p.map(|c| c + 0.0)).collect(); // −0 is 0
    let mut order: Vec<u32> = (0..).take(points.len()).collect();
    let key = |i: u32| points[i as usize].map(f64::to_bits);
    order.sort_unstable_by_key(|&i| key(i));
    let mut number = vec![0_u32; points.len()];
    let mut vertices = 0;
    for (k, &i) in order.iter().enumerate() {
        if k > 0 && key(order[k - 1]) != key(i) {
            vertices += 1;
        }
        number[i as usize] = vertices;
    }
    let corners = number.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    (corners, if points.is_empty() { 0 } else { vertices as usize + 1 })
}

/// Three different corners.
fn is_proper(&[a, b, c]: &[u32; 3]) -> bool {
    a != b && b != c && c != a
}

/// No triangle may be there twice, the same way round. Back to back it may: where two bodies touch.
fn require_different(corners: &[[u32; 3]]) -> Result<(), BodyError> {
    // From the lowest corner on, equal triangles are equal arrays.
    let from_lowest = |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min();
    let proper = corners.iter().enumerate().filter(|(_, c)| is_proper(c));
    let mut order: Vec<_> = proper.map(|(t, c)| (from_lowest(c), t)).collect();
    order.sort_unstable();
    let twice = order.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| (pair[0].1, pair[1].1));
    // The first in the file's order.
    match twice.min() {
        None => Ok(()),
        Some((first, second)) => Err(BodyError::DuplicateTriangle { first: first + 1, second: second + 1 }),
    }
}

/// Every edge must be run along as often one way as the other.
fn require_closed(triangles: &[Triangle], corners: &[[u32; 3]]) -> Result<(), BodyError> {
    // (lower vertex, higher vertex, forward, triangle, edge of the triangle)
    let mut edges = Vec::with_capacity(3 * corners.len());
    for (t, c) in corners.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (c[k], c[(k + 1) % 3]);
            if a != b {
                edges.push((a.min(b), a.max(b), a < b, t, k));
            }
        }
    }
    edges.sort_unstable();
    let (mut open, mut wound) = (Vec::new(), Vec::new());
    for edge in edges.chunk_by(|e, f| (e.0, e.1) == (f.0, f.1)) {
        let forward = edge.iter().filter(|e| e.2).count();
        if 2 * forward != edge.len() {
            let list = if edge.len() % 2 == 1 { &mut open } else { &mut wound };
            list.push((edge[0].3, edge[0].4));
        }
    }
    let example = |&(t, k): &(usize, usize)| [triangles[t][k], triangles[t][(k + 1) % 3]];
    // The first in the file's order.
    if let Some(first) = open.iter().min() {
        return Err(BodyError::OpenMesh {
            edges: open.len(),
            example: example(first),
            triangle: first.0 + 1,
        });
    }
    if let Some(first) = wound.iter().min() {
        let (edges, example, triangle) = (wound.len(), example(first), first.0 + 1);
        return Err(BodyError::InconsistentWinding { edges, example, triangle });
    }
    Ok(())
}

/// Volume (negative if inverted, and then true), centroid and covariance of the polyhedron, and its area.
///
/// A sum over the signed tetrahedra from a local reference point to each triangle (a, b, c), d = a · (b × c):
///
/// 6 V = Σ d,  24 V c = Σ d s,  120 V ⟨x xᵀ⟩ = Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ),  s = a + b + c
///
/// Exact for the polyhedron but for rounding, 4e-16 of half the tensor's trace; for a thin-walled body, ε
/// times its size over the thickness. The reference is first the middle of the bounding box, then the
/// centroid: a body far from the origin, or far from the middle of its box, loses nothing.
///
/// Source: Tonon, J. Math. Stat. 1 (2005) 8, summed over the boundary.
fn integrate(triangles: &[Triangle]) -> Result<(Spread, f64, bool), BodyError> {
    let (low, high) = bounds(triangles);
    let middle: [f64; 3] = core::array::from_fn(|k| 0.5 * low[k] + 0.5 * high[k]);
    let size = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    // In units of a power of two near the size: exact, and no fifth power leaves the range of f64.
    let unit = power_of_two_near(size);
    let first = sum_tetrahedra(triangles, middle, unit);
    let volume = unit * unit * unit;
    // No noise of flat triangles is larger: each one's area times its distance, rounded.
    let flat = first.six_volume.abs() <= 16.0 * f64::EPSILON * first.area;
    if flat {
        return Err(BodyError::FlatMesh { volume: first.six_volume / 6.0 * volume });
    }
    let centroid = first.centroid();
    let reference: [f64; 3] = core::array::from_fn(|k| middle[k] + centroid[k] * unit);
    let sums = sum_tetrahedra(triangles, reference, unit);
    let rest = sums.centroid();
    let covariance = sums.second * (1.0 / (20.0 * sums.six_volume)) - Symmetric3::outer(rest);
    let spread = Spread {
        extent: Extent::Volume(sums.six_volume / 6.0 * volume),
        centroid: Position::from_array(core::array::from_fn(|k| reference[k] + rest[k] * unit)),
        covariance: covariance * unit * unit,
    };
    Ok((spread, sums.area * unit * unit, sums.six_volume < 0.0))
}

/// In powers of the unit of length that they were summed in.
struct TetrahedronSums {
    six_volume: f64,
    area: f64,
    first: [f64; 3],
    second: Symmetric3,
}

impl TetrahedronSums {
    /// From the reference point.
    fn centroid(&self) -> [f64; 3] {
        self.first.map(|f| f / (4.0 * self.six_volume))
    }
}

fn sum_tetrahedra(triangles: &[Triangle], reference: [f64; 3], unit: f64) -> TetrahedronSums {
    let per_unit = 1.0 / unit;
    let mut area = Sum::default();
    let mut volume = Sum::default();
    let mut first = [Sum::default(); 3];
    let mut second = [Sum::default(); 6];
    for triangle in triangles {
        let [a, b, c] =
            triangle.map(|p| core::array::from_fn::<_, 3, _>(|k| (p[k] - reference[k]) * per_unit));
        let n = cross(b, c);
        let d = a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
        let s: [f64; 3] = core::array::from_fn(|k| a[k] + b[k] + c[k]);
        volume.add(d);
        let edge = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        area.add(0.5 * Direction::<Part>::from_array(cross(edge(b), edge(c))).norm());
        for (sum, s) in first.iter_mut().zip(s) {
            sum.add(d * s);
        }
        let product = |i: usize, j: usize| d * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
        for (sum, (i, j)) in second.iter_mut().zip([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]) {
            sum.add(product(i, j));
        }
    }
    let [xx, yy, zz, xy, xz, yz] = second.map(Sum::value);
    TetrahedronSums {
        six_volume: volume.value(),
        area: area.value(),
        first: first.map(Sum::value),
        second: Symmetric3 { xx, yy, zz, xy, xz, yz },
    }
}

fn bounds(triangles: &[Triangle]) -> ([f64; 3], [f64; 3]) {
    let mut low = [f64::INFINITY; 3];
    let mut high = [f64::NEG_INFINITY; 3];
    for p in triangles.iter().flatten() {
        for k in 0..3 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    (low, high)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    Direction::<Part>::from_array(a).cross(Direction::from_array(b)).to_array()
}
