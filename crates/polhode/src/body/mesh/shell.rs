//! Thin sheets in the shape of a mesh.

use super::TriangleMesh;
use crate::body::error::{BodyError, positive};
use crate::body::shape::{Extent, Shape, Spread};
use crate::math::double::Double;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::vector::Position;

/// Sheet of uniform thickness whose mid-surface is a mesh: for open meshes, or hollow bodies with
/// thin walls.
///
/// Each triangle is a separate plate that extends half the thickness to either side, with edges
/// perpendicular to it. Where plates meet at an angle, they overlap on the inner side and leave a
/// gap on the outer side. This is not corrected; the relative error is about thickness over size.
/// The volume is area times thickness.
///
/// Second moments about the origin of a triangle with corners a, b, c, area A, unit normal n and
/// thickness t:
/// A t (a aᵀ + b bᵀ + c cᵀ + s sᵀ)/12 + A t · t²/12 n nᵀ,  s = a + b + c
///
/// ```
/// use polhode::body::mesh::{MeshShell, TriangleMesh};
/// use polhode::body::shape::{Shape, Substance};
/// let [a, b, c, d] = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
/// let sheet = MeshShell::new(&TriangleMesh::of_triangles(&[[a, b, c], [a, c, d]])?, 0.5)?;
/// let body = sheet.mass_properties(Substance::Density(4.0))?; // as a brick of 3 × 2 × 0.5
/// assert!((body.mass() - 12.0).abs() < 1e-14);
/// assert!((body.inertia().matrix()[0][0] - (2.0 * 2.0 + 0.5 * 0.5)).abs() < 1e-14);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshShell {
    spread: Spread,
    area: f64,
}

impl MeshShell {
    /// Returns the sheet along all triangles of the mesh, with the thickness in m. Duplicate
    /// triangles count twice; triangles without area do not count.
    ///
    /// # Errors
    /// [`BodyError::Empty`] if the triangles have no area; [`BodyError::Parameter`] for a thickness
    /// that is not positive and finite, or if the volume overflows f64.
    pub fn new(mesh: &TriangleMesh, thickness: f64) -> Result<Self, BodyError> {
        positive("the shell's thickness", thickness)?;
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in mesh.corners().flatten() {
            low = core::array::from_fn(|k| low[k].min(p[k]));
            high = core::array::from_fn(|k| high[k].max(p[k]));
        }
        let middle = core::array::from_fn(|k| 0.5 * low[k] + 0.5 * high[k]);
        // Lengths are scaled by a power of two near the size: this is exact, and no product
        // overflows.
        let unit = power_of_two_near((0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max));
        let first = ShellSums::of(mesh, middle, unit);
        if !(first.area() > 0.0) {
            return Err(BodyError::Empty { what: "triangles with an area" });
        }
        // Relative to the centroid, nothing cancels.
        let centroid = first.centroid();
        let reference = core::array::from_fn(|k| middle[k] + unit * centroid[k]);
        let sums = ShellSums::of(mesh, reference, unit);
        let (area, rest) = (sums.area(), sums.centroid());
        let in_plane = (sums.second() * (1.0 / (12.0 * area)) - Symmetric3::outer(rest)) * unit * unit;
        let across = sums.normals() * (thickness / area * (thickness / 12.0));
        let area = area * unit * unit;
        let spread = Spread {
            extent: Extent::Volume(area * thickness),
            centroid: Position::from_array(core::array::from_fn(|k| reference[k] + rest[k] * unit)),
            covariance: in_plane + across,
        };
        Ok(Self { spread: spread.representable()?, area })
    }
}

impl Shape for MeshShell {
    fn spread(&self) -> Spread {
        self.spread
    }

    /// Returns the area of one side of the mesh, m².
    fn surface_area(&self) -> f64 {
        self.area
    }
}

/// Sums over the triangles, in powers of the scaled unit of length: area, area · s (3), area · (a
/// aᵀ + … + s sᵀ) (6), area · n nᵀ (6).
struct ShellSums([Double; 16]);

impl ShellSums {
    fn of(mesh: &TriangleMesh, reference: [f64; 3], unit: f64) -> Self {
        let per_unit = 1.0 / unit;
        let mut sums = [Double::default(); 16];
        for corners in mesh.corners() {
            let [a, b, c] =
                corners.map(|p| core::array::from_fn::<f64, 3, _>(|k| (p[k] - reference[k]) * per_unit));
            let from = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
            let (u, v) = (from(b), from(c));
            let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            let twice = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
            if !(twice > 0.0) {
                continue;
            }
            let area = 0.5 * twice;
            let s: [f64; 3] = core::array::from_fn(|k| a[k] + b[k] + c[k]);
            let second = |i: usize, j: usize| area * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
            let normal = |i: usize, j: usize| 0.5 * n[i] * (n[j] / twice);
            let terms = [area, area * s[0], area * s[1], area * s[2]];
            let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
            let (seconds, normals) = (pairs.map(|(i, j)| second(i, j)), pairs.map(|(i, j)| normal(i, j)));
            for (sum, term) in sums.iter_mut().zip(terms.into_iter().chain(seconds).chain(normals)) {
                *sum = *sum + Double::from(term);
            }
        }
        Self(sums)
    }

    fn area(&self) -> f64 {
        self.0[0].value()
    }

    /// Returns the centroid relative to the reference point: Σ A s / 3 Σ A.
    fn centroid(&self) -> [f64; 3] {
        [1, 2, 3].map(|k| (self.0[k] / (self.0[0] * Double::from(3.0))).value())
    }

    fn second(&self) -> Symmetric3 {
        self.matrix(4)
    }

    fn normals(&self) -> Symmetric3 {
        self.matrix(10)
    }

    fn matrix(&self, first: usize) -> Symmetric3 {
        let [xx, yy, zz, xy, xz, yz] = core::array::from_fn(|k| self.0[first + k].value());
        Symmetric3 { xx, yy, zz, xy, xz, yz }
    }
}
