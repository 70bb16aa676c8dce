//! Poses of frames in frames: x_outer = p + R x_inner.

use crate::model::Pose;

impl Pose {
    /// Identity pose, without a position in a text.
    pub const IDENTITY: Self =
        Self { position: [0.0; 3], rotation: [1.0, 0.0, 0.0, 0.0], unreadable: Vec::new(), span: None };

    /// Returns a pose from its numbers. `rotation` is a unit quaternion (w, x, y, z).
    pub const fn new(position: [f64; 3], rotation: [f64; 4]) -> Self {
        Self { position, rotation, unreadable: Vec::new(), span: None }
    }

    /// Returns the matrix R_outer_inner, whose columns are the inner axes in outer components.
    pub fn matrix(&self) -> [[f64; 3]; 3] {
        rotation_matrix(self.rotation)
    }

    /// Returns a direction of the inner frame in components of the outer frame.
    pub fn turned(&self, v: [f64; 3]) -> [f64; 3] {
        self.matrix().map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    /// Returns a point of the inner frame in the outer frame.
    pub fn placed(&self, point: [f64; 3]) -> [f64; 3] {
        sum(self.position, self.turned(point))
    }

    /// Composes two poses: returns the pose of `inner`, which is stated in this inner frame, in
    /// this outer frame. `unreadable` and `span` are those of `inner`.
    #[must_use]
    pub fn then(&self, inner: &Self) -> Self {
        Self {
            position: self.placed(inner.position),
            rotation: unit(product(self.rotation, inner.rotation)).unwrap_or(self.rotation),
            unreadable: inner.unreadable.clone(),
            span: inner.span.clone(),
        }
    }

    /// Returns the pose of the outer frame in the inner frame.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let [w, x, y, z] = self.rotation;
        let turn = Self::new([0.0; 3], [w, -x, -y, -z]);
        Self::new(turn.turned(self.position.map(|c| -c)), turn.rotation)
    }

    /// Rotates a tensor from the axes of the inner frame to those of the outer frame: R I Rᵀ.
    pub fn turned_tensor(&self, tensor: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
        let rows = tensor.map(|row| self.turned(row)); // I Rᵀ, as I is symmetric: row k is R I_k
        let columns = transposed(&rows).map(|column| self.turned(column));
        transposed(&columns)
    }
}

/// Returns the rotation of roll, pitch and yaw about fixed axes, R = R_z(yaw) R_y(pitch) R_x(roll),
/// as (w, x, y, z).
pub(crate) fn of_roll_pitch_yaw([roll, pitch, yaw]: [f64; 3]) -> [f64; 4] {
    product(about(2, yaw), product(about(1, pitch), about(0, roll)))
}

/// Returns the rotation by an angle (rad) about axis 0, 1 or 2.
pub(crate) fn about(axis: usize, angle: f64) -> [f64; 4] {
    let (sin, cos) = libm::sincos(0.5 * angle);
    match axis {
        0 => [cos, sin, 0.0, 0.0],
        1 => [cos, 0.0, sin, 0.0],
        _ => [cos, 0.0, 0.0, sin],
    }
}

/// Returns the rotation by an angle (rad) about a vector of any length; `None` for the zero vector.
pub(crate) fn about_axis(axis: [f64; 3], angle: f64) -> Option<[f64; 4]> {
    let [x, y, z] = direction(axis)?;
    let (sin, cos) = libm::sincos(0.5 * angle);
    Some([cos, sin * x, sin * y, sin * z])
}

/// Returns the shortest rotation that takes z to a vector of any length; half a turn about x for
/// −z.
pub(crate) fn of_z_axis(axis: [f64; 3]) -> Option<[f64; 4]> {
    let [x, y, z] = direction(axis)?;
    // q = (1 + z·n, z × n), normalized
    Some(unit([1.0 + z, -y, x, 0.0]).filter(|_| 1.0 + z > 1e-14).unwrap_or([0.0, 1.0, 0.0, 0.0]))
}

/// Returns the rotation whose matrix has these first two columns; the second is made perpendicular
/// to the first.
pub(crate) fn of_x_and_y(x: [f64; 3], y: [f64; 3]) -> Option<[f64; 4]> {
    let x = direction(x)?;
    let along = dot(x, y);
    let y = direction([0, 1, 2].map(|k| y[k] - along * x[k]))?;
    let z = cross(x, y);
    // Four formulas give the quaternion of a matrix; this selects the one with the largest divisor.
    let [m00, m11, m22] = [x[0], y[1], z[2]];
    let candidates = [
        [1.0 + m00 + m11 + m22, y[2] - z[1], z[0] - x[2], x[1] - y[0]],
        [y[2] - z[1], 1.0 + m00 - m11 - m22, x[1] + y[0], z[0] + x[2]],
        [z[0] - x[2], x[1] + y[0], 1.0 - m00 + m11 - m22, y[2] + z[1]],
        [x[1] - y[0], z[0] + x[2], y[2] + z[1], 1.0 - m00 - m11 + m22],
    ];
    let size = |q: &[f64; 4]| q.iter().map(|c| c * c).sum::<f64>();
    candidates.into_iter().max_by(|a, b| size(a).total_cmp(&size(b))).and_then(unit)
}

/// Returns the product q p: first the rotation p, then q.
pub(crate) fn product([w, x, y, z]: [f64; 4], [a, b, c, d]: [f64; 4]) -> [f64; 4] {
    [
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c - x * d + y * a + z * b,
        w * d + x * c - y * b + z * a,
    ]
}

/// Returns the normalized quaternion; `None` if its norm is zero or not finite.
pub(crate) fn unit(q: [f64; 4]) -> Option<[f64; 4]> {
    let largest = q.iter().fold(0.0_f64, |max, c| max.max(c.abs()));
    let reduced = q.map(|c| c / largest);
    let norm = reduced.iter().map(|c| c * c).sum::<f64>().sqrt();
    (largest > 0.0 && norm.is_finite()).then(|| reduced.map(|c| c / norm))
}

/// Returns the normalized vector; `None` if its norm is zero or not finite.
pub(crate) fn direction([x, y, z]: [f64; 3]) -> Option<[f64; 3]> {
    unit([0.0, x, y, z]).map(|[_, x, y, z]| [x, y, z])
}

pub(crate) fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Returns the transposed matrix.
pub(crate) fn transposed(r: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| r[j][i]))
}

/// Returns the matrix of a unit quaternion (w, x, y, z).
pub(crate) fn rotation_matrix([w, x, y, z]: [f64; 4]) -> [[f64; 3]; 3] {
    // R = 1 + 2 w [v]× + 2 [v]×²
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}
