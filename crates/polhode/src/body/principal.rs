//! Principal moments and axes of an inertia tensor.

use core::fmt;

use super::inertia::{InertiaAbout, InertiaTensor};
use crate::math::display;
use crate::math::frame::{Frame, Principal};
use crate::math::rotation::Rotation;
use crate::math::symmetric3::{Symmetric3, nearest_orthonormal};
use crate::math::vector::Direction;

/// Principal moments i1 ≤ i2 ≤ i3 of a tensor, and a right-handed set of axes to which they belong.
///
/// The choice of axes is deterministic: the largest component of axes 1 and 2 is positive (the
/// first one, if two are equal), and axis 3 = axis 1 × axis 2. Where moments are equal, the axes
/// nearest to those of the frame are used, and [`Symmetry`] states the freedom.
///
/// R diag(i1, i2, i3) Rᵀ reproduces the tensor to 1e-15 of its largest element, and R is orthogonal
/// to 1e-15, for any moments; if the moments differ, R is orthogonal to 3e-16.
///
/// ```
/// use polhode::body::{InertiaTensor, PrincipalFrame, Symmetry};
/// use polhode::math::Body;
/// // A cube about its corner, in units of M b²: Thornton & Marion, example 11.5
/// let corner = InertiaTensor::<Body>::with_negative_products([2.0 / 3.0; 3], [-0.25; 3])?;
/// let principal = PrincipalFrame::of(&corner);
/// let [i1, i2, i3] = principal.moments();
/// assert!((i1 - 1.0 / 6.0).abs() < 1e-15 && (i2 - 11.0 / 12.0).abs() < 1e-15 && (i3 - i2).abs() < 1e-15);
/// assert_eq!(principal.symmetry(), Symmetry::Prolate); // axes 2 and 3 are free in a plane
/// assert!((principal.axis(0).x - 1.0 / 3.0_f64.sqrt()).abs() < 1e-15); // the diagonal
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalFrame<F: Frame> {
    moments: [f64; 3],
    axes: [Direction<F>; 3],
    rotation: Rotation<F, Principal>,
    symmetry: Symmetry,
}

impl<F: Frame> fmt::Display for PrincipalFrame<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("moments ")?;
        display::row(f, &self.moments)?;
        f.write_str(" kg·m², axes ")?;
        for (k, axis) in self.axes.iter().enumerate() {
            f.write_str(if k == 0 { "" } else { ", " })?;
            axis.fmt(f)?;
        }
        Ok(())
    }
}

/// Symmetry of a body: which principal moments are equal, and therefore which axes are free.
///
/// Moments count as equal, and are returned as equal, if they differ by at most 4 ε of the largest:
/// the rounding of a rotation or of a short sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetry {
    /// All mass in one point: i1 = i2 = i3 = 0.
    Point,
    /// All mass on one line: i1 = 0 < i2 = i3.
    Rod,
    /// Every axis is principal: i1 = i2 = i3 > 0.
    Spherical,
    /// Axes 1 and 2 are free in their plane: i1 = i2 < i3.
    Oblate,
    /// Axes 2 and 3 are free in their plane: i1 < i2 = i3.
    Prolate,
    /// The axes are determined: i1 < i2 < i3.
    Asymmetric,
}

impl Symmetry {
    /// Returns the name in lower case, as in JSON.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Rod => "rod",
            Self::Spherical => "spherical",
            Self::Oblate => "oblate",
            Self::Prolate => "prolate",
            Self::Asymmetric => "asymmetric",
        }
    }

    /// Returns a description of the free axes.
    pub const fn freedom(self) -> &'static str {
        match self {
            Self::Point => "a point: every axis is principal, and none has a moment",
            Self::Rod => {
                "a rod: axis 1 is its line; axes 2 and 3 are arbitrary in the plane perpendicular to it"
            }
            Self::Spherical => "i1 = i2 = i3: every axis is principal",
            Self::Oblate => "i1 = i2: axes 1 and 2 are arbitrary in their plane",
            Self::Prolate => "i2 = i3: axes 2 and 3 are arbitrary in their plane",
            Self::Asymmetric => "three different moments: the principal axes are unique",
        }
    }
}

/// Relative tolerance within which moments count as equal. Rounding of rotated tensors is smaller,
/// and the tensor rebuilt from the chosen axes differs by at most 1e-15 of its largest element.
const EQUAL_TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// Relative tolerance below which a moment counts as zero, unless it is along one of the frame's
/// own axes.
const ROD_TOLERANCE: f64 = 3.0 * f64::EPSILON;

impl<F: Frame> PrincipalFrame<F> {
    /// Returns the principal moments and axes of a tensor about the centre of mass.
    pub fn of(tensor: &InertiaTensor<F>) -> Self {
        Self::of_symmetric(tensor.symmetric())
    }

    /// Returns the principal moments and axes of a tensor about another point, for motion about a
    /// fixed pivot.
    pub fn about_pivot(tensor: &InertiaAbout<F>) -> Self {
        Self::of_symmetric(tensor.symmetric())
    }

    pub(crate) fn of_symmetric(tensor: &Symmetric3) -> Self {
        let coarse = tensor.eigen();
        let eigen = coarse.polished(tensor);
        // Rounding may give −1e-17 instead of the 0 of a rod.
        let [i1, i2, i3] = eigen.values.map(|i| i.max(0.0));
        let equal = |a: f64, b: f64| (a - b).abs() <= EQUAL_TOLERANCE * i3;
        // A moment along one of the frame's own axes is exactly the given value; for any other axis
        // a small residue is rounding.
        let given = coarse.vectors[0].iter().filter(|c| **c != 0.0).count() == 1;
        let massless = i1 == 0.0 || (!given && i1 <= ROD_TOLERANCE * i3);
        let symmetry = if i3 == 0.0 {
            Symmetry::Point
        } else if massless {
            // Because i2 ≤ i3 ≤ i1 + i2, any remaining difference is rounding.
            Symmetry::Rod
        } else if equal(i1, i3) {
            Symmetry::Spherical
        } else if equal(i1, i2) {
            Symmetry::Oblate
        } else if equal(i2, i3) {
            Symmetry::Prolate
        } else {
            Symmetry::Asymmetric
        };
        // Moments that count as equal are made equal.
        let mean = |a: f64, b: f64| 0.5 * a + 0.5 * b;
        let moments = match symmetry {
            Symmetry::Point => [0.0; 3],
            Symmetry::Rod => [0.0, mean(i2, i3), mean(i2, i3)],
            Symmetry::Spherical => [mean(i1, i3); 3],
            Symmetry::Oblate => [mean(i1, i2), mean(i1, i2), i3],
            Symmetry::Prolate => [i1, mean(i2, i3), mean(i2, i3)],
            Symmetry::Asymmetric => [i1, i2, i3],
        };
        let axes = choose_axes(symmetry, eigen.vectors.map(Direction::from_array));
        Self { moments, axes, rotation: Rotation::from_axes(axes), symmetry }
    }

    /// Returns i1 ≤ i2 ≤ i3, kg·m².
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// Returns principal axis `k` = 0, 1 or 2 as a unit vector; it belongs to `moments()[k]`.
    ///
    /// Any other `k` is taken modulo 3.
    pub const fn axis(&self, k: usize) -> Direction<F> {
        self.axes[k % 3]
    }

    /// Returns the three axes as unit vectors.
    pub const fn axes(&self) -> [Direction<F>; 3] {
        self.axes
    }

    /// Returns R_F_principal, whose columns are the axes.
    pub const fn rotation(&self) -> Rotation<F, Principal> {
        self.rotation
    }

    /// Returns which moments are equal.
    pub const fn symmetry(&self) -> Symmetry {
        self.symmetry
    }
}

/// Returns the axes defined in CONVENTIONS.md, from eigenvectors of either sign and handedness.
fn choose_axes<F: Frame>(symmetry: Symmetry, v: [Direction<F>; 3]) -> [Direction<F>; 3] {
    let (axis1, axis2) = match symmetry {
        Symmetry::Point | Symmetry::Spherical => return unit_axes(),
        Symmetry::Asymmetric => {
            let (axis1, axis2) = (positive(v[0]), positive(v[1]));
            // Axis 1 × axis 2, without the rounding of the product.
            let axis3 = if axis1.cross(axis2).dot(v[2]) < 0.0 { reversed(v[2]) } else { v[2] };
            return [axis1, axis2, axis3];
        }
        Symmetry::Oblate => nearest_pair(v[2]),
        Symmetry::Rod | Symmetry::Prolate => (positive(v[0]), nearest_pair(v[0]).0),
    };
    // Each axis has the rounding of those before it.
    let axes = [axis1, axis2, axis1.cross(axis2)].map(Direction::to_array);
    nearest_orthonormal(axes).map(Direction::from_array)
}

fn unit_axes<F: Frame>() -> [Direction<F>; 3] {
    [Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0), Direction::new(0.0, 0.0, 1.0)]
}

/// Relative difference below which components are tied and the first one is used, so that the
/// choice does not depend on rounding.
const TIE: f64 = 1e-9;

/// Returns ±v, with its largest component positive.
fn positive<F: Frame>(v: Direction<F>) -> Direction<F> {
    let largest = v.max_abs();
    let first = v.to_array().into_iter().find(|c| c.abs() >= (1.0 - TIE) * largest);
    if first.is_some_and(|c| c < 0.0) { reversed(v) } else { v }
}

/// Returns −v, where 0 stays 0 and does not become −0.
fn reversed<F: Frame>(v: Direction<F>) -> Direction<F> {
    Direction::ZERO - v
}

/// Returns two orthonormal vectors u and v perpendicular to `n` that are together nearest to two of
/// the frame's own axes a and b (those nearest to the plane): they maximise u·a + v·b.
fn nearest_pair<F: Frame>(n: Direction<F>) -> (Direction<F>, Direction<F>) {
    let along = n.to_array().map(f64::abs);
    // Omits the axis most nearly along n; of equal ones the last.
    let out = (0..3).fold(0, |best, k| if along[k] >= along[best] - TIE { k } else { best });
    let [a, b] = match out {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    };
    let in_plane = |k: usize| unit_axes::<F>()[k] - n * n.dot(unit_axes::<F>()[k]);
    let (p, q) = (in_plane(a), in_plane(b));
    // v = s n × u, so u·p + v·q = u·(p + s q × n), which is largest for u along that vector; s
    // makes v point along q.
    let s = if n.dot(p.cross(q)) < 0.0 { -1.0 } else { 1.0 };
    let u = p + q.cross(n) * s;
    let u = u.direction().unwrap_or(p);
    // Removes the component along n that rounding left.
    let u = (u - n * n.dot(u)).direction().unwrap_or(u);
    (positive(u), positive(n.cross(u)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::frame::Body;

    fn turned(moments: [f64; 3], q: [f64; 4]) -> InertiaTensor<Body> {
        let r = Rotation::<Body, Principal>::from_quaternion(q).unwrap();
        InertiaTensor::diagonal(moments).unwrap().in_frame(r)
    }

    fn rebuild_error(t: &InertiaTensor<Body>) -> f64 {
        let p = PrincipalFrame::of(t);
        let again = Symmetric3::diagonal(p.moments()).rotated(&p.rotation().matrix());
        (*t.symmetric() - again).max_abs() / p.moments()[2]
    }

    #[test]
    fn a_generic_tensor_is_rebuilt_from_its_principal_frame() {
        let t = turned([1.3, 2.1, 2.9], [0.4, -0.7, 1.1, 0.3]);
        let p = PrincipalFrame::of(&t);
        assert_eq!(p.symmetry(), Symmetry::Asymmetric);
        for (got, want) in p.moments().iter().zip([1.3, 2.1, 2.9]) {
            assert!((got - want).abs() < 2e-15);
        }
        assert!(rebuild_error(&t) < 2e-15);
    }

    #[test]
    fn a_turned_symmetric_body_is_recognised() {
        let mut missed = [0; 4];
        for k in 0..20_000 {
            let a = f64::from(k);
            let q = [libm::sin(a), libm::sin(1.7 * a + 1.0), libm::cos(2.3 * a), libm::sin(3.1 * a + 2.0)];
            for (count, (moments, want)) in missed.iter_mut().zip([
                ([1.3, 1.3, 1.9], Symmetry::Oblate),
                ([1.3, 1.9, 1.9], Symmetry::Prolate),
                ([1.3, 1.3, 1.3], Symmetry::Spherical),
                ([0.0, 1.3, 1.3], Symmetry::Rod),
            ]) {
                *count += i32::from(PrincipalFrame::of(&turned(moments, q)).symmetry() != want);
            }
        }
        assert_eq!(missed, [0; 4]);
    }

    #[test]
    fn axes_are_right_handed_and_signed_for_any_turn() {
        for k in 0..200 {
            let a = f64::from(k);
            let q = [libm::sin(a), libm::sin(1.7 * a + 1.0), libm::cos(2.3 * a), libm::sin(3.1 * a + 2.0)];
            let t = turned([0.5, 1.25, 1.5], q);
            let p = PrincipalFrame::of(&t);
            assert!(p.axis(0).dot(p.axis(1).cross(p.axis(2))) > 0.999_999);
            for axis in [p.axis(0), p.axis(1)] {
                let largest =
                    axis.to_array().into_iter().fold(0.0_f64, |m, c| if c.abs() > m.abs() { c } else { m });
                assert!(largest > 0.0);
            }
            assert!(rebuild_error(&t) < 4e-15);
        }
    }

    #[test]
    fn equal_moments_choose_the_axes_nearest_the_body() {
        let sphere = turned([2.0; 3], [0.4, -0.7, 1.1, 0.3]);
        assert_eq!(PrincipalFrame::of(&sphere).axes(), unit_axes());

        // n tilted slightly from z: the pair nearest to x and y follows from the symmetry of the
        // tilt about x.
        let tilt = 0.3_f64;
        let q = [libm::cos(tilt / 2.0), libm::sin(tilt / 2.0), 0.0, 0.0];
        let p = PrincipalFrame::of(&turned([1.0, 1.0, 1.7], q));
        assert_eq!(p.symmetry(), Symmetry::Oblate);
        assert!((p.axis(0) - Direction::new(1.0, 0.0, 0.0)).norm() < 1e-15);
        assert!((p.axis(1) - Direction::new(0.0, libm::cos(tilt), libm::sin(tilt))).norm() < 1e-15);

        // The pair is optimal for a generic direction: no rotation in the plane is nearer.
        let p = PrincipalFrame::of(&turned([1.0, 1.0, 1.7], [0.9, 0.3, -0.2, 0.5]));
        let [e1, e2, n] = p.axes();
        let nearness = |u: Direction<Body>| u.x + n.cross(u).y;
        for turn in [-0.01, 0.01] {
            assert!(nearness(e1 + e2 * turn) / (1.0_f64 + turn * turn).sqrt() < nearness(e1));
        }
    }

    #[test]
    fn rods_and_points_are_named() {
        let rod = turned([0.0, 1.2, 1.2], [0.4, -0.7, 1.1, 0.3]);
        let p = PrincipalFrame::of(&rod);
        assert_eq!(p.symmetry(), Symmetry::Rod);
        assert_eq!(p.moments()[0], 0.0);
        let point = InertiaTensor::<Body>::diagonal([0.0; 3]).unwrap();
        assert_eq!(PrincipalFrame::of(&point).symmetry(), Symmetry::Point);
        // A very thin needle, given along its axes, is not a rod.
        let needle = InertiaTensor::<Body>::diagonal([1e-20, 1.0, 1.0]).unwrap();
        assert_eq!(PrincipalFrame::of(&needle).symmetry(), Symmetry::Prolate);
        assert_eq!(PrincipalFrame::of(&needle).moments()[0], 1e-20);
    }

    #[test]
    fn nearly_equal_and_graded_moments_keep_their_digits() {
        for gap in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
            let t = turned([1.0, 1.0 + gap, 1.5], [0.4, -0.7, 1.1, 0.3]);
            assert!(rebuild_error(&t) < 2e-15, "gap {gap}: {:e}", rebuild_error(&t));
        }
        let graded = Symmetric3 { xx: 1e-16, yy: 1.0, zz: 1.0, xy: 3e-9, xz: -4e-9, yz: 0.5 };
        // Smallest eigenvalue to *relative* accuracy: exact determinant / (product of the others),
        // determinant by hand.
        let [e1, e2, e3] = graded.eigen().values;
        let det = 1e-16 * 0.75 - (9e-18 + 16e-18 + 2.0 * 0.5 * 12e-18);
        assert!((e1 * e2 * e3 / det - 1.0).abs() < 1e-14, "{:e}", e1 * e2 * e3 / det - 1.0);
    }
}
