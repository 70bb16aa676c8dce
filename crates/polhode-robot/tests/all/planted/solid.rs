//! Solids with known tensors, and the numbers that describe them.

use std::fmt::Write as _;

use crate::check_common::{Matrix, conjugated, transposed};
use crate::common::times;

/// Box; uniform except for additions to its tensor.
#[derive(Clone)]
pub(super) struct Solid {
    pub(super) mass: f64,
    pub(super) edges: [f64; 3],
    /// Position and attitude in the link.
    pub(super) place: [f64; 3],
    pub(super) attitude: Matrix,
    /// Centre of mass in the link, and the tensor about it, link axes.
    pub(super) center: [f64; 3],
    pub(super) tensor: Matrix,
}

impl Solid {
    pub(super) fn uniform(mass: f64, edges: [f64; 3], place: [f64; 3], attitude: Matrix) -> Self {
        let [a, b, c] = edges.map(|x| mass * x * x / 12.0);
        let own = [[b + c, 0.0, 0.0], [0.0, a + c, 0.0], [0.0, 0.0, a + b]];
        Self { mass, edges, place, attitude, center: place, tensor: conjugated(&own, &attitude) }
    }

    /// Returns its numbers in link axes.
    pub(super) fn full(&self, name: &str) -> Spec {
        self.framed(name, &crate::check_common::turn([0.0; 3]))
    }

    /// Returns its numbers in the axes of a frame.
    pub(super) fn framed(&self, name: &str, frame: &Matrix) -> Spec {
        let own = conjugated(&self.tensor, &transposed(frame));
        Spec {
            name: name.to_owned(),
            mass: format!("{:.6}", self.mass),
            center: self.center,
            frame: *frame,
            six: crate::check_common::six(&own).map(|x| format!("{x:.7e}")),
            solid: self.clone(),
        }
    }

    /// Returns the moments in its own axes.
    pub(super) fn principal(&self, name: &str) -> Spec {
        let mut spec = self.framed(name, &self.attitude);
        spec.six[3..].fill("0".to_owned());
        spec
    }

    /// Returns m (c² 1 − c cᵀ).
    pub(super) fn about_origin(&self) -> Matrix {
        let c = self.center;
        let square: f64 = c.iter().map(|x| x * x).sum();
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let one = if i == j { square } else { 0.0 };
                self.tensor[i][j] + self.mass * (one - c[i] * c[j])
            })
        })
    }
}

/// Numbers of a link, as written.
#[derive(Clone)]
pub(super) struct Spec {
    pub(super) name: String,
    pub(super) mass: String,
    pub(super) center: [f64; 3],
    pub(super) frame: Matrix,
    /// Elements xx yy zz xy xz yz in the axes of the frame.
    pub(super) six: [String; 6],
    /// Shape of the link.
    pub(super) solid: Solid,
}

impl Spec {
    pub(super) fn is_diagonal(&self) -> bool {
        self.six[3..].iter().all(|product| product == "0")
    }
}

/// Returns the quaternion (w, x, y, z) with positive w.
pub(super) fn quaternion(r: &Matrix) -> [f64; 4] {
    // Longest column of 4 q qᵀ.
    let trace = r[0][0] + r[1][1] + r[2][2];
    let (s, t) = ([[0, 0], [1, 1], [2, 2]].map(|[i, j]| r[i][j]), 1.0 + trace);
    let columns = [
        [t, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]],
        [r[2][1] - r[1][2], 1.0 + s[0] - s[1] - s[2], r[0][1] + r[1][0], r[0][2] + r[2][0]],
        [r[0][2] - r[2][0], r[0][1] + r[1][0], 1.0 - s[0] + s[1] - s[2], r[1][2] + r[2][1]],
        [r[1][0] - r[0][1], r[0][2] + r[2][0], r[1][2] + r[2][1], 1.0 - s[0] - s[1] + s[2]],
    ];
    let length = |q: &[f64; 4]| q.iter().map(|c| c * c).sum::<f64>().sqrt();
    let longest = columns.into_iter().max_by(|a, b| length(a).total_cmp(&length(b))).unwrap();
    longest.map(|c| c / length(&longest))
}

/// Returns the angles of Rz Ry Rx.
pub(super) fn roll_pitch_yaw(r: &Matrix) -> [f64; 3] {
    [r[2][1].atan2(r[2][2]), (-r[2][0]).clamp(-1.0, 1.0).asin(), r[1][0].atan2(r[0][0])]
}

pub(super) fn inverse(r: &Matrix) -> Matrix {
    transposed(r)
}

pub(super) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    times(*a, *b)
}

/// Returns a cube of 1 m around the origin, as ASCII STL.
pub(super) fn cube() -> String {
    let corner = |k: usize| [0, 1, 2].map(|axis| if k >> axis & 1 == 0 { -0.5 } else { 0.5 });
    // Each face by four corners, counter-clockwise from outside.
    let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let mut text = "solid cube\n".to_owned();
    for [a, b, c, d] in faces {
        for triangle in [[a, b, c], [a, c, d]] {
            text.push_str("facet normal 0 0 0\nouter loop\n");
            for [x, y, z] in triangle.map(corner) {
                let _ = writeln!(text, "vertex {x} {y} {z}");
            }
            text.push_str("endloop\nendfacet\n");
        }
    }
    text + "endsolid cube\n"
}
