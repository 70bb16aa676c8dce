//! Spheres on a grid, and their moments in whole numbers.

use polhode_stl::Record;

pub(crate) type Triangle = [[f32; 3]; 3];

/// Steps of the grid in a unit of length.
pub(crate) const GRID: f64 = 65_536.0;

/// An icosahedron divided so many times, on an ellipsoid with dents, moved by an offset; its coordinates are on the
/// grid.
pub(crate) fn icosphere(levels: u32, offset: [f64; 3]) -> Vec<Triangle> {
    let t = 0.5 + 0.5 * 5.0_f64.sqrt();
    #[rustfmt::skip]
    let corners = [[-1.0, t, 0.0], [1.0, t, 0.0], [-1.0, -t, 0.0], [1.0, -t, 0.0], [0.0, -1.0, t], [0.0, 1.0, t],
        [0.0, -1.0, -t], [0.0, 1.0, -t], [t, 0.0, -1.0], [t, 0.0, 1.0], [-t, 0.0, -1.0], [-t, 0.0, 1.0]];
    #[rustfmt::skip]
    let faces = [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2],
        [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11],
        [6, 2, 10], [8, 6, 7], [9, 8, 1]];
    let mut mesh = Vec::new();
    for face in faces {
        divide(face.map(|k: usize| unit(corners[k])), levels, &mut |v| place(v, offset), &mut mesh);
    }
    mesh
}

fn place([x, y, z]: [f64; 3], offset: [f64; 3]) -> [f32; 3] {
    let r = 1.0 + 0.2 * (3.0 * x).sin() * (2.0 * y + 0.5).cos() + 0.1 * z * z;
    let p = [1.3 * r * x + offset[0], 0.7 * r * y + offset[1], r * z + 0.3 * r * x + offset[2]];
    p.map(|c| ((c * GRID).round() / GRID) as f32)
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

fn divide(
    [a, b, c]: [[f64; 3]; 3],
    levels: u32,
    place: &mut impl FnMut([f64; 3]) -> [f32; 3],
    mesh: &mut Vec<Triangle>,
) {
    if levels == 0 {
        mesh.push([place(a), place(b), place(c)]);
        return;
    }
    let middle = |p: [f64; 3], q: [f64; 3]| unit([p[0] + q[0], p[1] + q[1], p[2] + q[2]]);
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    for part in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
        divide(part, levels - 1, place, mesh);
    }
}

pub(crate) fn record(triangle: &Triangle) -> Record {
    let mut bytes = [0xA5; 50]; // the normal and the last two bytes are noise
    for (word, c) in bytes[12..48].as_chunks_mut::<4>().0.iter_mut().zip(triangle.as_flattened()) {
        *word = c.to_le_bytes();
    }
    bytes
}

pub(crate) fn records(triangles: &[Triangle]) -> Vec<Record> {
    triangles.iter().map(record).collect()
}

pub(crate) fn area(triangle: &Triangle) -> f64 {
    let [a, b, c] = triangle.map(|v| v.map(f64::from));
    let (e, f) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    let n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    0.5 * (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt()
}

/// Σ d, Σ d s and Σ d (a aᵀ + b bᵀ + c cᵀ + s sᵀ) in grid steps from the first vertex: exact.
pub(crate) struct Integers {
    volume: i128,
    first: [i128; 3],
    second: [i128; 6],
}

impl Integers {
    pub(crate) fn of(triangles: &[Triangle]) -> Self {
        let steps = |v: [f32; 3]| v.map(|c| (f64::from(c) * GRID) as i128);
        let origin = steps(triangles[0][0]);
        let mut sums = Self { volume: 0, first: [0; 3], second: [0; 6] };
        for triangle in triangles {
            let [a, b, c] = triangle.map(|v| {
                let v = steps(v);
                [v[0] - origin[0], v[1] - origin[1], v[2] - origin[2]]
            });
            let d = a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]);
            let s: [i128; 3] = core::array::from_fn(|k| a[k] + b[k] + c[k]);
            sums.volume += d;
            for (sum, s) in sums.first.iter_mut().zip(s) {
                *sum += d * s;
            }
            for (sum, (i, j)) in sums.second.iter_mut().zip([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)])
            {
                *sum += d * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
            }
        }
        sums
    }

    /// Volume and ⟨x xᵀ⟩ − c cᵀ: second / 20 V₆ − first firstᵀ / 16 V₆², over one denominator, 80 V₆², without
    /// cancellation in floating point.
    pub(crate) fn volume_and_covariance(&self) -> (f64, [f64; 6]) {
        let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        let central = core::array::from_fn(|k| {
            let (i, j) = pairs[k];
            // The numerator 4 V₆ S_ij − 5 F_i F_j has more than 128 bits: quotients and remainders by V₆ keep it exact.
            // S / V₆ = q + r / V₆ and F_i F_j / V₆² likewise, in integers where it counts.
            let v = self.volume;
            let (sq, sr) = (self.second[k].div_euclid(v), self.second[k].rem_euclid(v));
            let ((fq, fr), (gq, gr)) = (
                (self.first[i].div_euclid(v), self.first[i].rem_euclid(v)),
                (self.first[j].div_euclid(v), self.first[j].rem_euclid(v)),
            );
            let (r, f, g) = (sr as f64 / v as f64, fr as f64 / v as f64, gr as f64 / v as f64);
            let whole = 4 * sq - 5 * fq * gq;
            let part = 4.0 * r - 5.0 * (fq as f64 * g + gq as f64 * f + f * g);
            (whole as f64 + part) / 80.0 / (GRID * GRID)
        });
        (self.volume as f64 / 6.0 / (GRID * GRID * GRID), central)
    }
}
