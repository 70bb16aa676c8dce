//! Mesh simplification for display: all vertices in one cell of a grid become one.
//!
//! The shape is accurate to the size of a cell. Areas and volumes are not accurate; nothing is
//! computed from the simplified mesh.
//!
//! Source: Rossignac & Borrel, Multi-resolution 3D approximations for rendering complex scenes
//! (1993).

use std::collections::{HashMap, HashSet};

use polhode::body::mesh::TriangleMesh;

/// Returns a simplified mesh of at most `most` triangles, possibly empty; the result is
/// deterministic.
pub fn decimated(mesh: &TriangleMesh, most: usize) -> TriangleMesh {
    let Some(grid) = Bounds::of(mesh) else { return TriangleMesh::default() };
    // A surface has two triangles in each cell that it crosses, and crosses about 6 n² of n³ cells.
    let mut cells = (most as f64 / 2.0).sqrt().max(1.0);
    loop {
        let coarse = clustered(mesh, &grid, cells);
        let found = coarse.triangles().len();
        if found <= most || cells <= 1.0 {
            return if found <= most { coarse } else { TriangleMesh::default() };
        }
        // The number of triangles is proportional to the square of the number of cells along an
        // edge.
        cells = (cells * 0.97 * (most as f64 / found as f64).sqrt()).max(1.0);
    }
}

/// Bounding cube of a mesh.
struct Bounds {
    low: [f64; 3],
    /// Longest edge of the bounding box, m.
    size: f64,
}

impl Bounds {
    /// Returns the bounds; `None` for a mesh without triangles or of size zero.
    fn of(mesh: &TriangleMesh) -> Option<Self> {
        let start = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        let [low, high] = mesh.corners().flatten().fold(start, |[low, high], p| {
            [std::array::from_fn(|k| low[k].min(p[k])), std::array::from_fn(|k| high[k].max(p[k]))]
        });
        let size = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
        (size > 0.0 && size.is_finite()).then_some(Self { low, size })
    }

    /// Returns the cell of a point, for `cells` cells along an edge.
    fn cell(&self, point: [f64; 3], cells: f64) -> [u32; 3] {
        std::array::from_fn(|k| ((point[k] - self.low[k]) / self.size * cells) as u32)
    }
}

/// Returns the mesh with the vertices of each cell replaced by their mean.
///
/// Triangles that become degenerate or duplicate are removed.
fn clustered(mesh: &TriangleMesh, bounds: &Bounds, cells: f64) -> TriangleMesh {
    let mut places: HashMap<[u32; 3], u32> = HashMap::new();
    let mut sums: Vec<([f64; 3], f64)> = Vec::new();
    // Cells are numbered in the order of the vertices, so that the result is deterministic.
    let new_index: Vec<u32> = mesh
        .coordinates()
        .iter()
        .map(|&vertex| {
            let index = *places.entry(bounds.cell(vertex, cells)).or_insert_with(|| {
                sums.push(([0.0; 3], 0.0));
                (sums.len() - 1) as u32
            });
            if let Some((sum, count)) = sums.get_mut(index as usize) {
                *sum = std::array::from_fn(|k| sum[k] + vertex[k]);
                *count += 1.0;
            }
            index
        })
        .collect();
    let vertices = sums.into_iter().map(|(sum, count)| sum.map(|x| x / count)).collect();
    let mut seen = HashSet::new();
    let triangles = mesh
        .triangles()
        .iter()
        .filter_map(|corners| {
            let [a, b, c] = corners.map(|k| new_index.get(k as usize).copied().unwrap_or_default());
            let mut key = [a, b, c];
            key.sort_unstable();
            (a != b && b != c && c != a && seen.insert(key)).then_some([a, b, c])
        })
        .collect();
    // All indices are valid, and means of finite numbers are finite.
    TriangleMesh::new(vertices, triangles).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns a sphere of n × 2n quadrilaterals, each of two triangles.
    fn ball(n: u32, center: [f64; 3]) -> TriangleMesh {
        let (pi, m) = (std::f64::consts::PI, 2 * n);
        let mut vertices = Vec::new();
        for i in 0..=n {
            for j in 0..m {
                let (theta, phi) = (pi * f64::from(i) / f64::from(n), 2.0 * pi * f64::from(j) / f64::from(m));
                let p = [theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()];
                vertices.push(std::array::from_fn(|k| center[k] + 0.7 * p[k]));
            }
        }
        let at = |i: u32, j: u32| i * m + j % m;
        let quads = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
        let triangles = quads
            .flat_map(|(i, j)| {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect();
        TriangleMesh::new(vertices, triangles).unwrap()
    }

    #[test]
    fn a_ball_stays_a_ball() {
        let center = [1000.0, -3.0, 0.25];
        let fine = ball(200, center);
        for most in [20_000, 3_000, 200] {
            let coarse = decimated(&fine, most);
            let found = coarse.triangles().len();
            assert!(found <= most && found > most / 4, "{found} of {most}");
            let cell = 1.4 / (most as f64 / 8.0).sqrt();
            for corner in coarse.corners().flatten() {
                let r = (0..3).map(|k| (corner[k] - center[k]).powi(2)).sum::<f64>().sqrt();
                assert!((r - 0.7).abs() < 2.0 * cell, "{r} compared with {cell}");
            }
            // Triangles still face outward: the volume is positive and close to that of the sphere.
            let volume: f64 = coarse
                .corners()
                .map(|[a, b, c]| {
                    let [a, b, c] = [a, b, c].map(|p| [p[0] - center[0], p[1] - center[1], p[2] - center[2]]);
                    (a[0] * (b[1] * c[2] - b[2] * c[1])
                        + a[1] * (b[2] * c[0] - b[0] * c[2])
                        + a[2] * (b[0] * c[1] - b[1] * c[0]))
                        / 6.0
                })
                .sum();
            let exact = 4.0 / 3.0 * std::f64::consts::PI * 0.343;
            assert!((volume / exact - 1.0).abs() < 0.35, "{volume} compared with {exact}");
            assert_eq!(decimated(&fine, most), coarse);
        }
    }

    #[test]
    fn nothing_is_made_of_nothing() {
        assert_eq!(decimated(&TriangleMesh::default(), 10), TriangleMesh::default());
        assert!(decimated(&ball(10, [0.0; 3]), 0).triangles().is_empty());
    }
}
