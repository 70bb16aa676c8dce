//! Rotations between frames, as unit quaternions.

use core::fmt;
use core::marker::PhantomData;
use core::ops::Mul;

use super::frame::{Body, Frame, Space};
use super::number::{PI, sin_cos};
use super::vector::{Direction, Vector, quantity};

/// Rotation R_AB, which converts B-components to A-components: `v_A = R_AB v_B`.
///
/// Products are written like those of matrices, and the inner frames cancel: `Rotation<A, B> *
/// Rotation<B, C>` is a `Rotation<A, C>`, and `Rotation<A, B> * Vector<_, B>` is a `Vector<_, A>`.
/// The representation is a unit quaternion (Hamilton, scalar first); q and −q are the same
/// rotation.
///
/// ```
/// use polhode::math::{Attitude, Body, Direction, Rotation, Space};
/// let attitude: Attitude = Rotation::from_axis_angle(Direction::new(0.0, 0.0, 2.0), 0.5)?;
/// let x_body = Direction::<Body>::new(1.0, 0.0, 0.0);
/// let x_space: Direction<Space> = attitude * x_body;
/// assert!((x_space.x - 0.5_f64.cos()).abs() < 1e-15);
/// # Ok::<(), polhode::math::RotationError>(())
/// ```
///
/// ```compile_fail
/// use polhode::math::{Attitude, Direction, Space};
/// let wrong = Attitude::identity() * Direction::<Space>::new(1.0, 0.0, 0.0); // wants a body vector
/// ```
pub struct Rotation<A, B> {
    w: f64,
    x: f64,
    y: f64,
    z: f64,
    frames: PhantomData<(A, B)>,
}

/// Attitude of the body in space: `R_space_body`.
pub type Attitude = Rotation<Space, Body>;

/// Error: the numbers do not define a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RotationError {
    /// The quaternion is zero or not finite.
    Quaternion {
        /// Given w, x, y, z.
        wxyz: [f64; 4],
    },
    /// The axis has no direction.
    Axis {
        /// Components of the given axis.
        axis: [f64; 3],
    },
    /// The angle is not finite.
    Angle {
        /// Given angle, rad.
        angle: f64,
    },
    /// The matrix is not orthogonal with determinant +1.
    Matrix {
        /// Larger of the largest element of |RᵀR − 1| and |det R − 1|.
        departure: f64,
        /// Largest accepted departure.
        tolerance: f64,
    },
}

/// Quaternion as (w, x, y, z).
impl<A, B> fmt::Display for Rotation<A, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        super::display::row(f, &self.quaternion())
    }
}

impl fmt::Display for RotationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quaternion { wxyz: [w, x, y, z] } => {
                write!(
                    f,
                    "the quaternion ({w}, {x}, {y}, {z}) has no direction: it must be finite and not zero"
                )
            }
            Self::Axis { axis: [x, y, z] } => {
                write!(f, "the axis ({x}, {y}, {z}) has no direction: it must be finite and not zero")
            }
            Self::Angle { angle } => write!(f, "the angle {angle} is not finite"),
            Self::Matrix { departure, tolerance } => write!(
                f,
                "the matrix is not a rotation: it departs from orthogonality and determinant +1 by {departure:e}, \
                 more than {tolerance:e}"
            ),
        }
    }
}

impl core::error::Error for RotationError {}

/// Largest accepted departure of a direction-cosine matrix from orthogonality: eight printed
/// digits.
const MATRIX_TOLERANCE: f64 = 1e-7;

/// Tolerance of |q|². After normalisation and summation in f64, |q|² is within 3 ε of 1 (20 000
/// random quaternions).
const UNIT: f64 = 4.0 * f64::EPSILON;

impl<A, B> Rotation<A, B> {
    /// Returns the identity rotation: both frames coincide.
    pub const fn identity() -> Self {
        Self::unit(1.0, 0.0, 0.0, 0.0)
    }

    /// Returns the rotation of a quaternion (w, x, y, z), Hamilton, scalar first. The quaternion is
    /// normalised, unless it is unit to rounding; then its bits are kept.
    ///
    /// # Errors
    /// [`RotationError::Quaternion`] if it is zero or not finite.
    pub fn from_quaternion([w, x, y, z]: [f64; 4]) -> Result<Self, RotationError> {
        let scale = w.abs().max(x.abs()).max(y.abs()).max(z.abs());
        let finite = [w, x, y, z].iter().all(|c| c.is_finite());
        if !finite || scale == 0.0 {
            return Err(RotationError::Quaternion { wxyz: [w, x, y, z] });
        }
        if (w * w + x * x + y * y + z * z - 1.0).abs() <= UNIT {
            return Ok(Self::unit(w, x, y, z));
        }
        Ok(Self::normalised([w / scale, x / scale, y / scale, z / scale]))
    }

    /// Returns the rotation by which frame B is rotated relative to A, by `angle` (rad) about
    /// `axis`, right-handed. The axis has the same components in both frames.
    ///
    /// # Errors
    /// [`RotationError::Axis`] for an axis without direction, [`RotationError::Angle`] for an angle
    /// that is not finite.
    pub fn from_axis_angle(axis: Direction<A>, angle: f64) -> Result<Self, RotationError> {
        if !angle.is_finite() {
            return Err(RotationError::Angle { angle });
        }
        let Some(n) = axis.direction() else {
            return Err(RotationError::Axis { axis: axis.to_array() });
        };
        Ok(Self::turn(n, angle))
    }

    /// Returns the rotation of a direction-cosine matrix: rows are A's axes, columns B's.
    ///
    /// # Errors
    /// [`RotationError::Matrix`] if RᵀR differs from 1, or det R from +1, by more than 1e-7.
    pub fn from_matrix(r: [[f64; 3]; 3]) -> Result<Self, RotationError> {
        let departure = departure_from_rotation(&r);
        // Negated so that NaN is also an error.
        if !(departure <= MATRIX_TOLERANCE) {
            return Err(RotationError::Matrix { departure, tolerance: MATRIX_TOLERANCE });
        }
        Ok(Self::from_orthogonal(&r))
    }

    /// Returns the rotation with B's axes along three perpendicular unit vectors of A.
    pub(crate) fn from_axes(axes: [Direction<A>; 3]) -> Self {
        let [a, b, c] = axes;
        Self::from_orthogonal(&[[a.x, b.x, c.x], [a.y, b.y, c.y], [a.z, b.z, c.z]])
    }

    /// Returns the rotation of an orthogonal matrix by Shepperd's method: division by the largest
    /// of the four candidates.
    fn from_orthogonal(r: &[[f64; 3]; 3]) -> Self {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = *r;
        let candidates = [xx + yy + zz, xx - yy - zz, yy - xx - zz, zz - xx - yy];
        let best = (1..4).fold(0, |best, k| if candidates[k] > candidates[best] { k } else { best });
        Self::normalised(match best {
            0 => [1.0 + candidates[0], zy - yz, xz - zx, yx - xy],
            1 => [zy - yz, 1.0 + candidates[1], xy + yx, xz + zx],
            2 => [xz - zx, xy + yx, 1.0 + candidates[2], yz + zy],
            _ => [yx - xy, xz + zx, yz + zy, 1.0 + candidates[3]],
        })
    }

    /// Returns the rotation of 3-1-3 Euler angles in rad: precession φ about axis 3, nutation θ
    /// about the new axis 1, spin ψ about the new axis 3; R_AB = R₃(φ) R₁(θ) R₃(ψ).
    ///
    /// # Errors
    /// [`RotationError::Angle`] for an angle that is not finite.
    ///
    /// Source: Goldstein, Classical Mechanics, §4.4 (there with the inverse matrix).
    pub fn from_euler313([phi, theta, psi]: [f64; 3]) -> Result<Self, RotationError> {
        if let Some(&angle) = [phi, theta, psi].iter().find(|a| !a.is_finite()) {
            return Err(RotationError::Angle { angle });
        }
        let (st, ct) = sin_cos(0.5 * theta);
        let (sp, cp) = sin_cos(0.5 * phi + 0.5 * psi);
        let (sm, cm) = sin_cos(0.5 * phi - 0.5 * psi);
        Ok(Self::normalised([ct * cp, st * cm, st * sm, ct * sp]))
    }

    /// Returns the 3-1-3 Euler angles (φ, θ, ψ) in rad: φ and ψ in (−π, π], θ in [0, π].
    ///
    /// Only φ ± ψ is determined at θ = 0 and θ = π; then ψ = 0 is returned.
    pub fn euler313(self) -> [f64; 3] {
        let [w, x, y, z] = self.quaternion();
        let theta = 2.0 * libm::atan2(libm::hypot(x, y), libm::hypot(w, z));
        let half_sum = libm::atan2(z, w); // (φ + ψ)/2
        let half_difference = libm::atan2(y, x); // (φ − ψ)/2
        if x == 0.0 && y == 0.0 {
            return [wrap(2.0 * half_sum), theta, 0.0];
        }
        if w == 0.0 && z == 0.0 {
            return [wrap(2.0 * half_difference), theta, 0.0];
        }
        [wrap(half_sum + half_difference), theta, wrap(half_sum - half_difference)]
    }

    /// Returns the rotation of roll, pitch and yaw in rad, 3-2-1: yaw ψ about axis 3, pitch θ about
    /// the new axis 2, roll φ about the new axis 1; R_AB = R₃(ψ) R₂(θ) R₁(φ).
    ///
    /// # Errors
    /// [`RotationError::Angle`] for an angle that is not finite.
    ///
    /// Source: Markley & Crassidis, Fundamentals of Spacecraft Attitude Determination and Control,
    /// §2.9.5 (there with the inverse matrix).
    pub fn from_roll_pitch_yaw([roll, pitch, yaw]: [f64; 3]) -> Result<Self, RotationError> {
        if let Some(&angle) = [roll, pitch, yaw].iter().find(|a| !a.is_finite()) {
            return Err(RotationError::Angle { angle });
        }
        let ((sp, cp), sum, difference) =
            (sin_cos(0.5 * pitch), sin_cos(0.5 * yaw + 0.5 * roll), sin_cos(0.5 * yaw - 0.5 * roll));
        // w ∓ y = (c ∓ s) cos ½(ψ ± φ), z ± x = (c ∓ s) sin ½(ψ ± φ), with c and s of ½θ.
        let (less, more) = (0.5 * (cp - sp), 0.5 * (cp + sp));
        Ok(Self::normalised([
            less * sum.1 + more * difference.1,
            less * sum.0 - more * difference.0,
            more * difference.1 - less * sum.1,
            less * sum.0 + more * difference.0,
        ]))
    }

    /// Returns roll, pitch and yaw (φ, θ, ψ), 3-2-1, in rad: φ and ψ in (−π, π], θ in [−π/2, π/2].
    ///
    /// Only ψ ∓ φ is determined at θ = ±π/2; then φ = 0 is returned.
    pub fn roll_pitch_yaw(self) -> [f64; 3] {
        let [w, x, y, z] = self.quaternion();
        let (less, more) = ([w - y, x + z], [w + y, z - x]);
        let pitch =
            2.0 * libm::atan2(libm::hypot(more[0], more[1]), libm::hypot(less[0], less[1])) - 0.5 * PI;
        let half_sum = libm::atan2(less[1], less[0]); // (ψ + φ)/2
        let half_difference = libm::atan2(more[1], more[0]); // (ψ − φ)/2
        if less == [0.0; 2] {
            return [0.0, pitch, wrap(2.0 * half_difference)];
        }
        if more == [0.0; 2] {
            return [0.0, pitch, wrap(2.0 * half_sum)];
        }
        [wrap(half_sum - half_difference), pitch, wrap(half_sum + half_difference)]
    }

    /// Returns the rotation of modified Rodrigues parameters σ = n tan(Φ/4), a rotation by Φ about
    /// n.
    ///
    /// # Errors
    /// [`RotationError::Quaternion`] if a parameter is not finite, or if their length is 1e150 or
    /// more.
    ///
    /// Source: Schaub & Junkins, Analytical Mechanics of Space Systems, §3.6.
    pub fn from_mrp([x, y, z]: [f64; 3]) -> Result<Self, RotationError> {
        let squared = x * x + y * y + z * z;
        Self::from_quaternion([1.0 - squared, 2.0 * x, 2.0 * y, 2.0 * z])
    }

    /// Returns the modified Rodrigues parameters of the shorter rotation: σ = (x, y, z)/(1 + w),
    /// |σ| ≤ 1.
    pub fn mrp(self) -> [f64; 3] {
        let [w, x, y, z] = self.canonical_quaternion();
        [x, y, z].map(|c| c / (1.0 + w))
    }

    /// Returns the unit quaternion (w, x, y, z) as stored: continuous along a trajectory, either
    /// sign.
    pub const fn quaternion(self) -> [f64; 4] {
        [self.w, self.x, self.y, self.z]
    }

    /// Returns the unit quaternion (w, x, y, z) with w ≥ 0, as printed for a single attitude.
    pub fn canonical_quaternion(self) -> [f64; 4] {
        let q = self.quaternion();
        // The first nonzero component determines the sign.
        match q.iter().find(|c| **c != 0.0) {
            Some(first) if *first < 0.0 => q.map(|c| 0.0 - c),
            _ => q,
        }
    }

    /// Returns the direction-cosine matrix R with `v_A = R v_B`; rows are A's axes.
    pub fn matrix(self) -> [[f64; 3]; 3] {
        let Self { w, x, y, z, .. } = self;
        [
            [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    }

    /// Returns the inverse rotation R_BA.
    pub const fn inverse(self) -> Rotation<B, A> {
        Rotation::unit(self.w, -self.x, -self.y, -self.z)
    }

    /// Returns the angle of this rotation, 0 … π rad, accurate for very small angles.
    pub fn angle(self) -> f64 {
        let sine = libm::sqrt(self.x * self.x + self.y * self.y + self.z * self.z);
        2.0 * libm::atan2(sine, self.w.abs())
    }

    /// Returns the rotation vector v with R = exp(\[v\]×): |v| rad about v, at most π. For R_AB it
    /// has the same components along A and along B.
    ///
    /// ```
    /// use polhode::math::{Attitude, Direction};
    /// let r = Attitude::exp(Direction::new(0.3, -0.2, 0.7))?;
    /// assert!((r.log() - Direction::new(0.3, -0.2, 0.7)).norm() < 1e-15);
    /// # Ok::<(), polhode::math::RotationError>(())
    /// ```
    pub fn log(self) -> Direction<B> {
        let sine = libm::sqrt(self.x * self.x + self.y * self.y + self.z * self.z);
        let angle = self.angle();
        let factor = if sine == 0.0 { 0.0 } else { angle.copysign(angle * self.w) / sine };
        Direction::new(self.x, self.y, self.z) * factor
    }

    /// Returns exp(\[v\]×), the rotation by |v| rad about the rotation vector v.
    ///
    /// # Errors
    /// [`RotationError`] for a vector that is not finite.
    pub fn exp(v: Direction<A>) -> Result<Self, RotationError> {
        Self::from_quaternion(Self::from_rotation_vector(v).quaternion())
    }

    /// Returns the angle between two attitudes, 0 … π rad.
    pub fn angle_to(self, other: Self) -> f64 {
        (self.inverse() * other).angle()
    }

    /// Returns the same rotation, with the sign of its quaternion nearest to that of `previous`.
    #[must_use]
    pub fn continuous_with(self, previous: Self) -> Self {
        let cosine = self.w * previous.w + self.x * previous.x + self.y * previous.y + self.z * previous.z;
        if cosine < 0.0 { Self::unit(-self.w, -self.x, -self.y, -self.z) } else { self }
    }

    /// Returns the rotation by `angle` (rad) about the unit vector `n`.
    pub(crate) fn turn(n: Direction<A>, angle: f64) -> Self {
        let (s, c) = sin_cos(0.5 * angle);
        Self::normalised([c, s * n.x, s * n.y, s * n.z])
    }

    /// Returns the rotation by the rotation vector v: |v| rad about v.
    pub(crate) fn from_rotation_vector(v: Direction<A>) -> Self {
        let angle = v.dot(v).sqrt();
        let (s, c) = sin_cos(0.5 * angle);
        let ratio = if angle == 0.0 { 0.5 } else { s / angle };
        Self::near_unit([c, ratio * v.x, ratio * v.y, ratio * v.z])
    }

    fn normalised([w, x, y, z]: [f64; 4]) -> Self {
        let norm = libm::sqrt(w * w + x * x + y * y + z * z);
        Self::unit(w / norm, x / norm, y / norm, z / norm)
    }

    /// Returns the rotation of a quaternion that is unit except for rounding: 1/√n = (3 − n)/2 to
    /// second order in n − 1.
    pub(crate) fn near_unit([w, x, y, z]: [f64; 4]) -> Self {
        let s = 1.5 - 0.5 * (w * w + x * x + y * y + z * z);
        Self::unit(s * w, s * x, s * y, s * z)
    }

    /// Returns the rotation of a quaternion that is unit to rounding.
    pub(crate) const fn from_unit([w, x, y, z]: [f64; 4]) -> Self {
        Self::unit(w, x, y, z)
    }

    const fn unit(w: f64, x: f64, y: f64, z: f64) -> Self {
        Self { w, x, y, z, frames: PhantomData }
    }
}

impl<A, B, C> Mul<Rotation<B, C>> for Rotation<A, B> {
    type Output = Rotation<A, C>;
    fn mul(self, b: Rotation<B, C>) -> Rotation<A, C> {
        let a = self;
        Rotation::near_unit([
            a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
        ])
    }
}

impl<A, B, Q> Mul<Vector<Q, B>> for Rotation<A, B> {
    type Output = Vector<Q, A>;
    fn mul(self, v: Vector<Q, B>) -> Vector<Q, A> {
        // v + 2w (u × v) + 2 u × (u × v), with the vector part u.
        let u = Vector::<quantity::Number, B>::new(self.x, self.y, self.z);
        let v: Vector<quantity::Number, B> = v.as_quantity();
        let t = u.cross(v) * 2.0;
        (v + t * self.w + u.cross(t)).as_quantity().as_frame()
    }
}

impl<A, B> Clone for Rotation<A, B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A, B> Copy for Rotation<A, B> {}

impl<A, B> PartialEq for Rotation<A, B> {
    /// Compares the quaternions, component by component.
    fn eq(&self, other: &Self) -> bool {
        self.quaternion() == other.quaternion()
    }
}

impl<A: Frame, B: Frame> fmt::Debug for Rotation<A, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { w, x, y, z, .. } = self;
        write!(f, "R_{}_{}({w:?}, {x:?}, {y:?}, {z:?})", A::NAME, B::NAME)
    }
}

/// Reduces an angle to (−π, π], rad.
pub(crate) fn wrap(angle: f64) -> f64 {
    if angle > PI {
        angle - 2.0 * PI
    } else if angle <= -PI {
        angle + 2.0 * PI
    } else {
        angle
    }
}

fn departure_from_rotation(r: &[[f64; 3]; 3]) -> f64 {
    let column = |k: usize| Direction::<Body>::new(r[0][k], r[1][k], r[2][k]);
    let mut departure = (column(0).dot(column(1).cross(column(2))) - 1.0).abs();
    for i in 0..3 {
        for j in 0..=i {
            let delta = if i == j { 1.0 } else { 0.0 };
            let d = (column(i).dot(column(j)) - delta).abs();
            // Keeps NaN.
            departure = if d > departure || d.is_nan() { d } else { departure };
        }
    }
    departure
}

#[cfg(test)]
mod tests {
    use super::*;

    fn generic() -> Attitude {
        Rotation::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap()
    }

    #[test]
    fn the_matrix_and_the_quaternion_turn_alike() {
        let r = generic();
        let v = Direction::<Body>::new(0.3, -2.0, 0.9);
        let m = r.matrix();
        let by_matrix = m.map(|row| row[0] * v.x + row[1] * v.y + row[2] * v.z);
        assert!((r * v - Direction::from_array(by_matrix)).norm() < 1e-15);
        assert!(Attitude::from_matrix(m).unwrap().angle_to(r) < 1e-15);
    }

    #[test]
    fn a_quarter_turn_about_z_takes_body_x_to_space_y() {
        let r: Attitude = Rotation::from_axis_angle(Direction::new(0.0, 0.0, 3.0), PI / 2.0).unwrap();
        assert!((r * Direction::new(1.0, 0.0, 0.0) - Direction::new(0.0, 1.0, 0.0)).norm() < 1e-15);
    }

    #[test]
    fn matrices_of_every_branch_come_back() {
        for q in [[0.9, 0.1, -0.2, 0.3], [0.1, 0.9, -0.2, 0.3], [0.1, 0.2, -0.9, 0.3], [0.1, 0.2, 0.3, -0.9]]
        {
            let r = Attitude::from_quaternion(q).unwrap();
            assert!(Attitude::from_matrix(r.matrix()).unwrap().angle_to(r) < 1e-15);
        }
    }

    #[test]
    fn roll_pitch_and_yaw_are_three_turns() {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Direction::from_array);
        for [roll, pitch, yaw] in
            [[2.1, 0.7, -1.4], [-0.3, -1.5, 3.1], [3.0, 1e-9, 1e-9], [0.0, 1.569_7, 2.0]]
        {
            let turns: Rotation<Body, Body> = Rotation::turn(z, yaw);
            let turns: Rotation<Body, Body> =
                turns * Rotation::<Body, Body>::turn(y, pitch) * Rotation::turn(x, roll);
            let r = Rotation::from_roll_pitch_yaw([roll, pitch, yaw]).unwrap();
            assert!(r.angle_to(turns) < 1e-15);
            let back = r.roll_pitch_yaw();
            assert!((back[1] - pitch).abs() < 1e-15, "{back:?}");
            // Near the vertical, only the sum is well determined.
            let known = 4e-16 / pitch.cos();
            assert!((back[0] - roll).abs() < known && (back[2] - yaw).abs() < known, "{back:?}");
        }
        // Exactly at the vertical, one angle describes the rotation.
        for (q, want) in
            [([1.0, 0.0, 1.0, 0.0], [0.0, 0.5 * PI, 0.0]), ([0.0, 1.0, 0.0, 1.0], [0.0, -0.5 * PI, PI])]
        {
            let r = Attitude::from_quaternion(q).unwrap();
            let angles = r.roll_pitch_yaw();
            let same = Attitude::from_roll_pitch_yaw(angles).unwrap();
            assert!(
                same.angle_to(r) < 1e-15 && (angles[1] - want[1]).abs() < 1e-15 && angles[0] == 0.0,
                "{angles:?}"
            );
        }
        assert!(Attitude::from_roll_pitch_yaw([0.0, f64::NAN, 0.0]).is_err());
    }

    #[test]
    fn modified_rodrigues_parameters_are_tangents_of_a_quarter() {
        let axis = Direction::new(0.36, -0.48, 0.8);
        for angle in [1e-8, 0.3, 2.9, -3.1] {
            let r: Attitude = Rotation::from_axis_angle(axis, angle).unwrap();
            let want = (axis * (0.25 * angle).tan()).to_array();
            let mrp = r.mrp();
            assert!((0..3).all(|k| (mrp[k] - want[k]).abs() < 1e-15), "{mrp:?} {want:?}");
            assert!(Attitude::from_mrp(mrp).unwrap().angle_to(r) < 1e-15);
            // The longer rotation, given by the shadow parameters, is the same.
            let squared = mrp.iter().map(|c| c * c).sum::<f64>();
            assert!(Attitude::from_mrp(mrp.map(|c| -c / squared)).unwrap().angle_to(r) < 1e-15);
        }
        assert!(Attitude::from_mrp([f64::INFINITY, 0.0, 0.0]).is_err());
    }

    #[test]
    fn euler_angles_are_three_turns() {
        let (phi, theta, psi) = (2.1, 0.7, -1.4);
        let z = Direction::new(0.0, 0.0, 1.0);
        let x = Direction::new(1.0, 0.0, 0.0);
        let turns: Rotation<Body, Body> = Rotation::turn(z, phi);
        let turns = turns * Rotation::turn(x, theta) * Rotation::turn(z, psi);
        let r = Rotation::<Body, Body>::from_euler313([phi, theta, psi]).unwrap();
        assert!(r.angle_to(turns) < 1e-15);
        for (got, want) in r.euler313().iter().zip([phi, theta, psi]) {
            assert!((got - want).abs() < 1e-15, "{got} {want}");
        }
        // If only φ ± ψ is determined, the rotation is still reproduced.
        for theta in [0.0, PI] {
            let r = Rotation::<Body, Body>::from_euler313([0.8, theta, 0.5]).unwrap();
            assert!(Rotation::from_euler313(r.euler313()).unwrap().angle_to(r) < 1e-15);
        }
    }

    #[test]
    fn what_is_not_a_rotation_is_refused() {
        assert!(matches!(Attitude::from_quaternion([0.0; 4]), Err(RotationError::Quaternion { .. })));
        assert!(Attitude::from_quaternion([f64::NAN, 1.0, 0.0, 0.0]).is_err());
        assert!(Attitude::from_quaternion([f64::INFINITY, 1.0, 0.0, 0.0]).is_err());
        assert!(Attitude::from_axis_angle(Direction::ZERO, 1.0).is_err());
        assert!(Attitude::from_axis_angle(Direction::new(1.0, 0.0, 0.0), f64::NAN).is_err());
        let mirror = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
        assert!(matches!(Attitude::from_matrix(mirror), Err(RotationError::Matrix { .. })));
        assert!(Attitude::from_matrix([[f64::NAN; 3]; 3]).is_err());
        assert!(Attitude::from_quaternion([1e-200, 0.0, 2e-200, 0.0]).is_ok());
    }

    #[test]
    fn tiny_angles_keep_their_digits() {
        let r: Attitude = Rotation::from_rotation_vector(Direction::new(1e-12, -2e-12, 2e-12));
        assert!((r.angle() / 3e-12 - 1.0).abs() < 1e-15);
    }
}
