//! Choice of a principal axis, and the check that it is determined.

use polhode::body::{PrincipalFrame, Symmetry};
use polhode::math::{Body, Direction};

use super::undefined::Undefined;

/// Directions along the axes, with their names.
pub(crate) const DIRECTIONS: [(&str, [f64; 3]); 6] = [
    ("x", [1.0, 0.0, 0.0]),
    ("y", [0.0, 1.0, 0.0]),
    ("z", [0.0, 0.0, 1.0]),
    ("-x", [-1.0, 0.0, 0.0]),
    ("-y", [0.0, -1.0, 0.0]),
    ("-z", [0.0, 0.0, -1.0]),
];

/// Principal axis, chosen by its moment or its direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PrincipalAxis {
    /// Index by moment: 0 is the least, 2 the greatest.
    Number(usize),
    /// Axis that is nearest to the direction.
    Nearest,
}

/// Returns the unit vector of a checked direction.
pub(super) fn unit(u: Direction<Body>) -> Direction<Body> {
    u.direction().unwrap_or(u)
}

/// Returns true if a principal axis is not determined: any direction in a plane, or in space.
pub(super) const fn is_free(symmetry: Symmetry, k: usize) -> bool {
    match symmetry {
        Symmetry::Point | Symmetry::Spherical => true,
        Symmetry::Rod | Symmetry::Prolate => k > 0,
        Symmetry::Oblate => k < 2,
        Symmetry::Asymmetric => false,
    }
}

pub(super) fn determined(frame: &PrincipalFrame<Body>, k: usize) -> Result<(), Undefined> {
    if is_free(frame.symmetry(), k) { Err(Undefined::EqualMoments) } else { Ok(()) }
}

/// Returns the index of the axis, and true if another axis is equally near.
pub(super) fn chosen(
    frame: &PrincipalFrame<Body>,
    axis: PrincipalAxis,
    from: Direction<Body>,
) -> (usize, bool) {
    match axis {
        PrincipalAxis::Number(k) => (k % 3, false),
        PrincipalAxis::Nearest => nearest(frame, from),
    }
}

/// Returns the index of the principal axis that is nearest to a direction, and true if another axis
/// is equally near. If axes are free in a plane, the nearest direction in that plane counts.
fn nearest(frame: &PrincipalFrame<Body>, from: Direction<Body>) -> (usize, bool) {
    let n = unit(from);
    let square = |k: usize| frame.axis(k).dot(n) * frame.axis(k).dot(n);
    let alone = [0, 1, 2].map(square);
    let [a, b, c] = match frame.symmetry() {
        Symmetry::Point | Symmetry::Spherical => return (2, false),
        Symmetry::Rod | Symmetry::Prolate => [alone[0], 0.0, alone[1] + alone[2]],
        Symmetry::Oblate => [alone[0] + alone[1], 0.0, alone[2]],
        Symmetry::Asymmetric => alone,
    };
    let most = a.max(b).max(c);
    let near = [a, b, c].map(|square| square >= most);
    let k = if near[2] { 2 } else { usize::from(near[1]) };
    (k, near.iter().filter(|near| **near).count() > 1)
}

/// Returns the moment of the axis nearest to a direction, followed by the next two in cyclic order.
/// Also returns the index of the axis, and true if another is equally near.
pub(super) fn spin_moments(frame: &PrincipalFrame<Body>, axis: Direction<Body>) -> ([f64; 3], usize, bool) {
    let ((k, tie), moments) = (nearest(frame, axis), frame.moments());
    ([0, 1, 2].map(|n| moments[(k + n) % 3]), k, tie)
}

pub(super) fn determined_spin(
    frame: &PrincipalFrame<Body>,
    axis: Direction<Body>,
) -> Result<([f64; 3], usize), Undefined> {
    let (moments, k, tie) = spin_moments(frame, axis);
    determined(frame, k)?;
    if tie { Err(Undefined::Corner) } else { Ok((moments, k)) }
}
