//! Euler angles: sequences, and conversion to quaternions.

use polhode::math::{Body, Direction, Rotation};

/// Sequence of three rotations. Each is about an axis of the frame after the previous rotations
/// (intrinsic), or about a fixed axis (extrinsic).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Sequence {
    /// Axes in the order of the rotations, 0 to 2.
    pub axes: [usize; 3],
    pub extrinsic: bool,
}

impl Sequence {
    /// Yaw, pitch, roll: intrinsic 3-2-1.
    pub(crate) const YAW_PITCH_ROLL: Self = Self { axes: [2, 1, 0], extrinsic: false };
    /// Precession, nutation, spin: intrinsic 3-1-3.
    pub(crate) const PRECESSION_NUTATION_SPIN: Self = Self { axes: [2, 0, 2], extrinsic: false };

    /// Parses `3-2-1`, `321`, `zyx` or `z-y-x` as intrinsic. Two successive rotations about one
    /// axis are not allowed.
    pub(crate) fn parse(word: &str) -> Option<Self> {
        let axis = |c: char| match c.to_ascii_lowercase() {
            '1' | 'x' => Some(0),
            '2' | 'y' => Some(1),
            '3' | 'z' => Some(2),
            _ => None,
        };
        let axes: Option<Vec<usize>> = word.chars().filter(|c| *c != '-').map(axis).collect();
        let axes: [usize; 3] = axes?.try_into().ok()?;
        (axes[0] != axes[1] && axes[1] != axes[2]).then_some(Self { axes, extrinsic: false })
    }

    /// Formats the sequence: `3-2-1`, `extrinsic 1-2-3`.
    pub(crate) fn shown(self) -> String {
        let [a, b, c] = self.axes.map(|axis| axis + 1);
        format!("{}{a}-{b}-{c}", if self.extrinsic { "extrinsic " } else { "" })
    }

    /// Returns the quaternion, scalar first, of finite angles in rad, in the order of the
    /// rotations.
    pub(crate) fn quaternion(self, angles: [f64; 3]) -> [f64; 4] {
        let turn = |k: usize| {
            let mut axis = [0.0; 3];
            axis[self.axes[k]] = 1.0;
            let [x, y, z] = axis;
            // This cannot fail: the axis has length 1, and the angle is finite.
            Rotation::<Body, Body>::from_axis_angle(Direction::new(x, y, z), angles[k])
                .unwrap_or(Rotation::identity())
        };
        let whole = if self.extrinsic { turn(2) * turn(1) * turn(0) } else { turn(0) * turn(1) * turn(2) };
        whole.quaternion()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sequences_are_read_as_they_are_written() {
        for (word, axes) in
            [("3-2-1", [2, 1, 0]), ("313", [2, 0, 2]), ("zyx", [2, 1, 0]), ("X-Y-Z", [0, 1, 2])]
        {
            assert_eq!(Sequence::parse(word).map(|s| s.axes), Some(axes), "{word}");
        }
        for word in ["", "3-2", "3-3-1", "1-2-2", "3-2-1-3", "abc", "deg", "3-2-0"] {
            assert_eq!(Sequence::parse(word), None, "{word}");
        }
    }
}
