//! Meshes for forms that the page does not draw by name.

use std::f64::consts::TAU;

use polhode::body::mesh::TriangleMesh;

use super::placed::THIN;

/// Number of segments of a circle, as in the page's own round solids.
const ROUND: u32 = 64;

/// Returns the wall of a frustum without ends, with a visible thickness; one radius may be zero.
pub(crate) fn cone_wall(base: f64, top: f64, height: f64) -> TriangleMesh {
    let wall = THIN * base.max(top);
    // The inner side is the outer side shifted by the thickness; it ends where it reaches the axis.
    let inner = |z: f64, own: f64, other: f64| {
        let meets = z + (height - 2.0 * z) * (wall - own) / (other - own);
        if own < wall { [0.0, meets] } else { [own - wall, z] }
    };
    revolved(&[[base, 0.0], [top, height], inner(height, top, base), inner(0.0, base, top), [base, 0.0]])
}

/// Returns the surface of revolution of a profile in (r, z), with its outer side on the right.
fn revolved(profile: &[[f64; 2]]) -> TriangleMesh {
    let point = |[r, z]: [f64; 2], k: u32| {
        let (sin, cos) = (f64::from(k % ROUND) * TAU / f64::from(ROUND)).sin_cos();
        // Points on the axis must be bit-identical for all angles; −0 would differ from 0.
        if r == 0.0 { [0.0, 0.0, z] } else { [r * cos, r * sin, z] }
    };
    let mut triangles: Vec<[[f64; 3]; 3]> = Vec::new();
    for pair in profile.windows(2) {
        for k in 0..ROUND {
            let [a, b, c, d] =
                [point(pair[0], k), point(pair[0], k + 1), point(pair[1], k + 1), point(pair[1], k)];
            triangles
                .extend([[a, b, c], [a, c, d]].into_iter().filter(|[p, q, r]| p != q && q != r && r != p));
        }
    }
    TriangleMesh::of_triangles(&triangles).unwrap_or_default()
}

/// Returns a prism centred at z = 0; for a length of 0, a thin plate.
pub(crate) fn prism(vertices: [[f64; 2]; 3], length: f64) -> TriangleMesh {
    let [o, p, q] = vertices;
    let edges = [[o, p], [p, q], [q, o]].map(|[a, b]| (b[0] - a[0]).hypot(b[1] - a[1]));
    let length = if length > 0.0 { length } else { THIN * edges.into_iter().fold(f64::INFINITY, f64::min) };
    let is_left = (p[0] - o[0]) * (q[1] - o[1]) > (p[1] - o[1]) * (q[0] - o[0]);
    let base = if is_left { [o, p, q] } else { [o, q, p] };
    let corners = [-0.5, 0.5].into_iter().flat_map(|side| base.map(|[x, y]| [x, y, side * length]));
    let sides = (0..3_u32).flat_map(|k| {
        let next = (k + 1) % 3;
        [[k, next, next + 3], [k, next + 3, k + 3]]
    });
    let triangles = [[0, 2, 1], [3, 4, 5]].into_iter().chain(sides).collect();
    TriangleMesh::new(corners.collect::<Vec<_>>(), triangles).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use polhode::body::mesh::ClosedMesh;
    use polhode::body::shape::Shape;

    use super::*;

    #[test]
    fn outlines_are_closed_and_wound_outward() {
        for (base, top) in [(0.9, 0.35), (0.35, 0.9), (0.9, 0.0), (0.0, 0.9), (0.9, 0.01), (0.6, 0.6)] {
            let wall = ClosedMesh::of(&cone_wall(base, top, 1.3)).unwrap();
            assert!(!wall.inverted(), "{base} {top}");
            // Each side of the wall has an area of nearly π (a + b) √(h² + (a − b)²).
            let side = 0.5 * TAU * (base + top) * 1.3_f64.hypot(base - top);
            assert!((wall.surface_area() / side - 2.0).abs() < 0.1, "{} {side}", wall.surface_area());
        }
        for vertices in [[[0.2, -0.3], [1.1, 0.1], [0.4, 0.9]], [[0.2, -0.3], [0.4, 0.9], [1.1, 0.1]]] {
            let solid = ClosedMesh::of(&prism(vertices, 0.7)).unwrap();
            assert!(!solid.inverted());
            assert!((solid.volume() - 0.7 * 0.5 * (0.9 * 1.2 - 0.4 * 0.2)).abs() < 1e-15);
            assert!(ClosedMesh::of(&prism(vertices, 0.0)).unwrap().volume() > 0.0);
        }
    }
}
