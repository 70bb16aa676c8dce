//! Central inertia of closed meshes compared with integer sums.

use polhode::prelude::*;

use crate::accuracy::exact::{Pair, Whole};
use crate::accuracy::random::Random;

/// Error bound of every mesh, relative to half the trace.
pub(crate) const PROMISED: f64 = 2e-15;

/// Half-size of a mesh: with ±2³¹ units, a position at 10⁶ sizes is still an integer below 2⁵³.
const SIZE: f64 = 2_147_483_648.0;

/// Distances of a mesh from the origin, in units of SIZE.
const OFFSETS: [i64; 3] = [0, 1_000, 1_000_000];

/// Exponents of the unit, a power of two, so that coordinates are exact. The bodies are about 1e-9,
/// 1 and 1e9 m in size.
const SCALES: [i32; 3] = [-61, -31, -1];

/// Meshes with one number of triangles, 2 `around` (`down` − 1).
struct Kind {
    around: usize,
    down: usize,
    meshes: usize,
    /// Offsets and scales, as indices of OFFSETS and SCALES. The large meshes, which are slow to
    /// diagnose, are tested far away only.
    placed: &'static [(usize, usize)],
}

const EVERYWHERE: &[(usize, usize)] =
    &[(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2)];

const KINDS: [Kind; 7] = [
    Kind { around: 3, down: 3, meshes: 500, placed: EVERYWHERE },
    Kind { around: 10, down: 6, meshes: 200, placed: EVERYWHERE },
    Kind { around: 25, down: 21, meshes: 30, placed: EVERYWHERE },
    Kind { around: 100, down: 51, meshes: 3, placed: EVERYWHERE },
    Kind { around: 250, down: 201, meshes: 1, placed: &[(0, 2), (1, 1), (2, 0)] },
    Kind { around: 1000, down: 501, meshes: 1, placed: &[(2, 2)] },
    Kind { around: 2500, down: 1001, meshes: 1, placed: &[(2, 0)] },
];

/// Largest errors of the meshes with one number of triangles.
pub(crate) struct Row {
    pub(crate) triangles: usize,
    pub(crate) meshes: usize,
    /// Largest error at each offset.
    pub(crate) errors: [Option<f64>; OFFSETS.len()],
}

/// Closed surface with integer coordinates.
struct Surface {
    vertices: Vec<[i64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Surface {
    /// Returns a star-shaped surface: waves with every vertex moved at random by up to about the
    /// distance to the next one, then stretched and sheared.
    fn random(kind: &Kind, random: &mut Random) -> Self {
        let Kind { around, down, .. } = *kind;
        let roughness = random.between(0.1, 2.0) / (1.0 + down as f64);
        let stretch: [f64; 3] = std::array::from_fn(|_| random.between(0.2, 0.7));
        let shear = random.between(0.0, 0.3);
        let mut vertex = |theta: f64, phi: f64| {
            let ((sin_theta, cos_theta), (sin_phi, cos_phi)) = (libm::sincos(theta), libm::sincos(phi));
            let wave = 0.2 * libm::sin(3.0 * theta + 1.0) * cos_phi + 0.1 * cos_theta;
            let r = SIZE / 1.3 * (1.0 + wave - roughness * random.next());
            let [x, y, z] =
                [sin_theta * cos_phi * stretch[0], sin_theta * sin_phi * stretch[1], cos_theta * stretch[2]];
            [x + shear * y, y, z - shear * x].map(|c| (r * c).round() as i64)
        };
        let step = |turn: f64, steps: usize, k: usize| turn * k as f64 / steps as f64;
        let mut vertices = vec![vertex(0.0, 0.0)];
        for j in 1..down {
            for i in 0..around {
                let theta = step(std::f64::consts::PI, down, j);
                vertices.push(vertex(theta, step(std::f64::consts::TAU, around, i)));
            }
        }
        vertices.push(vertex(std::f64::consts::PI, 0.0));
        let south = vertices.len() as u32 - 1;
        let at = |j: usize, i: usize| match j {
            0 => 0,
            j if j == down => south,
            j => (1 + (j - 1) * around + i % around) as u32,
        };
        let mut triangles = Vec::new();
        for (j, i) in (0..down).flat_map(|j| (0..around).map(move |i| (j, i))) {
            let [a, b, c, d] = [at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1)];
            triangles
                .extend([[a, b, c], [a, c, d]].into_iter().filter(|[a, b, c]| a != b && b != c && a != c));
        }
        Self { vertices, triangles }
    }

    /// Returns the surface at `offset` SIZE along a generic direction, with a unit of 2^`scale` m.
    fn mesh(&self, offset: i64, scale: i32) -> TriangleMesh {
        let unit = 2.0_f64.powi(scale);
        let place = [2 * offset, -3 * offset, offset].map(|k| k * SIZE as i64);
        let coordinate = |x: i64| {
            assert_eq!(x as f64 as i64, x);
            unit * x as f64
        };
        let moved = |p: &[i64; 3]| [0, 1, 2].map(|k| coordinate(p[k] + place[k]));
        TriangleMesh::new(self.vertices.iter().map(moved).collect(), self.triangles.clone()).unwrap()
    }

    /// Computes the central inertia tensor per unit mass, in squares of the unit; xx, yy, zz, xy,
    /// xz, yz.
    ///
    /// Sums over the tetrahedra from the origin to each triangle, with d = a · (b × c) and s = a +
    /// b + c, are exact: D = Σ d = 6V,  F = Σ d s = 24V c,  S = Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ) =
    /// 120V ⟨x xᵀ⟩. Then, to 32 digits, `⟨x_i x_j⟩ − c_i c_j = (4 S_ij D − 5 F_i F_j) / 80 D²`.
    fn inertia(&self) -> [Pair; 6] {
        let mut whole = 0_i128;
        let mut first = [Whole::default(); 3];
        let mut second = [Whole::default(); 6];
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| self.vertices[v as usize].map(i128::from));
            let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
            let d = a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1);
            let s: [i128; 3] = std::array::from_fn(|k| a[k] + b[k] + c[k]);
            whole += d;
            for (sum, s) in first.iter_mut().zip(s) {
                *sum = *sum + Whole::product(d, s);
            }
            for (sum, (i, j)) in second.iter_mut().zip(ELEMENTS) {
                *sum = *sum + Whole::product(d, a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
            }
        }
        let [four, five, eighty] = [4.0, 5.0, 80.0].map(Pair::of);
        let (whole, first) = (Whole::product(whole, 1).pair(), first.map(Whole::pair));
        let covariance: [Pair; 6] = std::array::from_fn(|k| {
            let (i, j) = ELEMENTS[k];
            (four * second[k].pair() * whole - five * first[i] * first[j]).over(eighty * whole * whole)
        });
        let [xx, yy, zz, xy, xz, yz] = covariance;
        [yy + zz, xx + zz, xx + yy, -xy, -xz, -yz]
    }
}

/// Rows and columns of the elements of a symmetric matrix.
const ELEMENTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Returns the largest error of the central tensor for unit mass, relative to half its trace.
fn error(surface: &Surface, exact: &[Pair; 6], offset: i64, scale: i32) -> f64 {
    let mesh = ClosedMesh::of(&surface.mesh(offset, scale)).unwrap();
    assert!(mesh.findings().is_empty(), "{:?}", mesh.findings());
    let got = mesh.mass_properties(Substance::Mass(1.0)).unwrap().inertia().matrix();
    let square = 2.0_f64.powi(2 * scale);
    let half_trace = 0.5 * (exact[0] + exact[1] + exact[2]).value();
    let errors = ELEMENTS
        .iter()
        .zip(exact)
        .map(|(&(i, j), &want)| (Pair::of(got[i][j] / square) - want).value().abs());
    errors.fold(0.0, f64::max) / half_trace
}

pub(crate) fn measured() -> Vec<Row> {
    let mut random = Random(1);
    let row = |kind: &Kind| {
        let mut row = Row { triangles: 0, meshes: kind.meshes, errors: [None; OFFSETS.len()] };
        for _mesh in 0..kind.meshes {
            let surface = Surface::random(kind, &mut random);
            let exact = surface.inertia();
            row.triangles = surface.triangles.len();
            for &(place, size) in kind.placed {
                let error = error(&surface, &exact, OFFSETS[place], SCALES[size]);
                row.errors[place] = Some(row.errors[place].unwrap_or(0.0).max(error));
            }
        }
        row
    };
    KINDS.iter().map(row).collect()
}
