//! Meshes that MuJoCo generates: `<mesh builtin="…" params="…">`.
//!
//! Source: MuJoCo 3.12, `mjs_makeMesh` and `mjCMesh::Make…`.

use std::collections::HashMap;
use std::f64::consts::PI;

use crate::pose::sum;
use crate::read::xml::Element;

use super::surface::Surface;

/// Maximum number of vertices of one mesh. Without a limit, a file of a hundred bytes could exhaust
/// the memory.
const MOST_VERTICES: usize = 200_000;

/// Generated mesh with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Builtin {
    /// Icosahedron whose triangles are repeatedly split in four.
    Sphere { splits: usize },
    /// Hemisphere with its base; `rows` is the number of rows from pole to equator, minus one.
    Hemisphere { rows: usize },
    /// Frustum between two polygons, or cone with an apex.
    Cone { edges: usize, radius: f64 },
    /// Superellipsoid with the exponents `east` and `north`.
    Supersphere { resolution: usize, east: f64, north: f64 },
    /// Supertoroid with the exponents `tube` (around the tube) and `hole` (around the hole).
    Supertorus { resolution: usize, radius: f64, tube: f64, hole: f64 },
    /// Points of a sphere within two angles, degrees.
    Wedge { resolution: [usize; 2], view: [f64; 2], gamma: f64 },
    /// Grid of points at z = −1.
    Plate { resolution: [usize; 2] },
}

impl Builtin {
    /// Reads the asset; `None` if it is not a generated mesh.
    pub(super) fn of(element: Element<'_>) -> Option<Result<Self, String>> {
        let kind = element.word("builtin").filter(|kind| *kind != "none")?;
        let params: Vec<f64> =
            element.attribute("params").map_or_else(Vec::new, |all| all.values().collect());
        let refused = || format!("its mesh is builtin={kind:?} with params that MuJoCo refuses");
        let made = Self::by(kind, &params).filter(|_| params.iter().all(|number| number.is_finite()));
        Some(made.ok_or_else(refused).and_then(|made| match made.vertices() {
            0..=MOST_VERTICES => Ok(made),
            _ => Err(format!("its mesh is builtin={kind:?} with more than {MOST_VERTICES} vertices")),
        }))
    }

    fn by(kind: &str, params: &[f64]) -> Option<Self> {
        // Conversion truncates towards zero, as in C.
        let count = |number: f64| (number > -1.0 && number < 1e6).then_some(number as usize);
        let made = match (kind, params) {
            ("sphere", &[splits]) => Self::Sphere { splits: count(splits).filter(|splits| *splits <= 4)? },
            ("hemisphere", &[rows]) => Self::Hemisphere { rows: count(rows).filter(|rows| *rows <= 10)? },
            ("cone", &[edges, radius]) => Self::Cone { edges: count(edges)?, radius },
            ("supersphere", &[resolution, east, north]) if east >= 0.0 && north >= 0.0 => {
                Self::Supersphere { resolution: count(resolution).filter(|count| *count >= 3)?, east, north }
            }
            ("supertorus", &[resolution, radius, tube, hole])
                if radius > 0.0 && radius <= 1.0 && tube > 0.0 && hole > 0.0 =>
            {
                let resolution = count(resolution).filter(|count| *count >= 3)?;
                Self::Supertorus { resolution, radius, tube, hole }
            }
            ("wedge", &[across, up, wide, high, gamma])
                if wide > 0.0
                    && wide <= 180.0
                    && high > 0.0
                    && high <= 90.0
                    && (0.0..=1.0).contains(&gamma) =>
            {
                Self::Wedge { resolution: [count(across)?, count(up)?], view: [wide, high], gamma }
            }
            ("plate", &[across, up]) => Self::Plate { resolution: [count(across)?, count(up)?] },
            _ => return None,
        };
        match made {
            Self::Wedge { resolution, .. } | Self::Plate { resolution } if resolution.contains(&0) => None,
            _ => Some(made),
        }
    }

    /// Returns the approximate number of vertices.
    pub(super) fn vertices(self) -> usize {
        match self {
            Self::Sphere { splits } => 12 << (2 * splits),
            Self::Hemisphere { rows } => 2 * (rows + 1) * (rows + 2) + 2,
            Self::Cone { edges, .. } => 2 * edges,
            Self::Supersphere { resolution, .. } | Self::Supertorus { resolution, .. } => {
                resolution.saturating_mul(resolution)
            }
            Self::Wedge { resolution: [across, up], .. } | Self::Plate { resolution: [across, up] } => {
                across.saturating_mul(up)
            }
        }
    }

    /// Returns true if the mesh always counts as a shell, whatever the asset states.
    pub(super) const fn is_shell(self) -> bool {
        matches!(self, Self::Plate { .. })
    }

    /// Returns vertices and triangles. Without triangles, the mesh is the convex hull of the
    /// points.
    pub(super) fn surface(self) -> Surface {
        match self {
            Self::Sphere { splits } => sphere(splits),
            Self::Hemisphere { rows } => hemisphere(rows),
            Self::Cone { edges, radius } => cone(edges, radius),
            Self::Supersphere { resolution, east, north } => supersphere(resolution, east, north),
            Self::Supertorus { resolution, radius, tube, hole } => supertorus(resolution, radius, tube, hole),
            Self::Wedge { resolution, view, gamma } => wedge(resolution, view, gamma),
            Self::Plate { resolution } => plate(resolution),
        }
    }
}

fn sphere(splits: usize) -> Surface {
    let phi = 0.5 * (1.0 + 5.0_f64.sqrt());
    let corners = [
        [-1.0, phi, 0.0],
        [1.0, phi, 0.0],
        [-1.0, -phi, 0.0],
        [1.0, -phi, 0.0],
        [0.0, -1.0, phi],
        [0.0, 1.0, phi],
        [0.0, -1.0, -phi],
        [0.0, 1.0, -phi],
        [phi, 0.0, -1.0],
        [phi, 0.0, 1.0],
        [-phi, 0.0, -1.0],
        [-phi, 0.0, 1.0],
    ];
    let mut vertices = corners.map(unit).to_vec();
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    for _ in 0..splits {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                let [a, b] = [a, b].map(|k| vertices.get(k as usize).copied().unwrap_or_default());
                vertices.push(unit(sum(a, b)));
                vertices.len() as u32 - 1
            })
        };
        let split = |[a, b, c]: [u32; 3]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        triangles = triangles.into_iter().flat_map(split).collect();
    }
    Surface { vertices, triangles }
}

fn hemisphere(rows: usize) -> Surface {
    let mut vertices = vec![[0.0, 0.0, 1.0]];
    let equator = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
    for row in 1..=rows + 1 {
        let down = row as f64 / (rows + 1) as f64;
        let arc = |corner: [f64; 3]| [down * corner[0], down * corner[1], 1.0 - down];
        for side in 0..4 {
            let (start, end) = (arc(equator[side]), arc(equator[(side + 1) % 4]));
            let place = |k: usize| [0, 1, 2].map(|c| start[c] + k as f64 * (end[c] - start[c]) / row as f64);
            vertices.extend((0..row).map(|k| unit(place(k))));
        }
    }
    vertices.push([0.0; 3]);
    let base = vertices.len() - 1;
    let mut triangles = vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];
    // Index of the first vertex of a row with four sides.
    let first = |row: usize| 2 * row * (row + 1) + 1;
    for row in 0..rows {
        let upper = |k: usize| first(row) + k % (4 * (row + 1));
        let lower = |k: usize| first(row + 1) + k % (4 * (row + 2));
        for side in 0..4 {
            for k in 0..row + 2 {
                let (u, l) = (k + (row + 1) * side, k + (row + 2) * side);
                triangles.push([upper(u), lower(l), lower(l + 1)]);
                if k < row + 1 {
                    triangles.push([upper(u), lower(l + 1), upper(u + 1)]);
                }
            }
        }
    }
    let edges = 4 * (rows + 1);
    triangles.extend((0..edges).map(|k| [first(rows) + k, base, first(rows) + (k + 1) % edges]));
    Surface { vertices, triangles: numbered(triangles) }
}

fn cone(edges: usize, radius: f64) -> Surface {
    let ring = |radius: f64, z: f64| {
        (0..edges).map(move |k| {
            let (sin, cos) = libm::sincos(2.0 * PI * k as f64 / edges as f64);
            [radius * cos, radius * sin, z]
        })
    };
    let mut vertices: Vec<_> = ring(1.0, -1.0).collect();
    if radius > 0.0 {
        vertices.extend(ring(radius, 1.0));
    } else {
        vertices.push([0.0, 0.0, 1.0]);
    }
    Surface { vertices, triangles: Vec::new() }
}

fn supersphere(n: usize, east: f64, north: f64) -> Surface {
    let mut vertices = vec![[0.0, 0.0, -1.0]];
    for i in 1..n {
        let [ring, z] = power_circle(-0.5 * PI + i as f64 * PI / n as f64, north);
        vertices.extend((0..n).map(|j| {
            let [x, y] = power_circle(-PI + j as f64 * 2.0 * PI / n as f64, east);
            [ring * x, ring * y, z]
        }));
    }
    vertices.push([0.0, 0.0, 1.0]);
    let north_pole = vertices.len() - 1;
    let at = |ring: usize, j: usize| 1 + ring * n + j % n;
    let mut triangles: Vec<_> = (0..n).map(|j| [0, at(0, j + 1), at(0, j)]).collect();
    for ring in 0..n - 2 {
        for j in 0..n {
            triangles.push([at(ring, j), at(ring, j + 1), at(ring + 1, j)]);
            triangles.push([at(ring, j + 1), at(ring + 1, j + 1), at(ring + 1, j)]);
        }
    }
    triangles.extend((0..n).map(|j| [at(n - 2, j), at(n - 2, j + 1), north_pole]));
    Surface { vertices, triangles: numbered(triangles) }
}

fn supertorus(n: usize, radius: f64, tube: f64, hole: f64) -> Surface {
    let angle = |k: usize| 2.0 * PI * k as f64 / n as f64;
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    let at = |i: usize, j: usize| i % n * n + j % n;
    for i in 0..n {
        for j in 0..n {
            let ([x, y], [out, up]) = (power_circle(angle(i), hole), power_circle(angle(j), tube));
            let ring = 1.0 + radius * out;
            vertices.push([ring * x, ring * y, radius * up]);
            triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
            triangles.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    Surface { vertices, triangles: numbered(triangles) }
}

fn wedge(resolution: [usize; 2], view: [f64; 2], gamma: f64) -> Surface {
    let [across, up] = [0, 1].map(|axis| {
        let count = resolution[axis];
        let edge = |k: usize| {
            let x = 2.0 * k as f64 / count as f64 - 1.0;
            view[axis].to_radians() * (gamma * x.powi(5) + (1.0 - gamma) * x)
        };
        (0..count).map(|k| 0.5 * (edge(k) + edge(k + 1))).collect::<Vec<_>>()
    });
    let mut vertices = Vec::new();
    for azimuth in &across {
        for elevation in &up {
            let ((sin_a, cos_a), (sin_e, cos_e)) = (libm::sincos(*azimuth), libm::sincos(*elevation));
            vertices.push([cos_e * sin_a, sin_e, -cos_e * cos_a]);
        }
    }
    Surface { vertices, triangles: Vec::new() }
}

fn plate([across, up]: [usize; 2]) -> Surface {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for i in 0..across {
        for j in 0..up {
            vertices.push([
                -1.0 + (i as f64 + 0.5) * 2.0 / across as f64,
                -1.0 + (j as f64 + 0.5) * 2.0 / up as f64,
                -1.0,
            ]);
            if i > 0 && j > 0 {
                let at = |i: usize, j: usize| i * up + j;
                triangles.push([at(i - 1, j - 1), at(i, j - 1), at(i - 1, j)]);
                triangles.push([at(i, j), at(i - 1, j), at(i, j - 1)]);
            }
        }
    }
    Surface { vertices, triangles: numbered(triangles) }
}

/// Returns signed powers of cosine and sine: sign(c) |c|^power.
fn power_circle(angle: f64, power: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [cos, sin].map(|c| libm::pow(c.abs(), power).copysign(c))
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

fn numbered(triangles: Vec<[usize; 3]>) -> Vec<[u32; 3]> {
    triangles.into_iter().map(|corners| corners.map(|k| k as u32)).collect()
}
