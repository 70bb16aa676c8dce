//! Quaternions (w, x, y, z), Hamilton, of double-double or triple-double numbers, for rotations
//! before rounding.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::double::Double;
use super::triple::Triple;

/// Arithmetic of double-double and triple-double numbers.
pub(crate) trait Words:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn root(self) -> Self;
}

impl Words for Double {
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl Words for Triple {
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// Quaternion w + x i + y j + z k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quaternion<T>(pub(crate) [T; 4]);

impl<T: Words> Quaternion<T> {
    pub(crate) fn times(self, other: Self) -> Self {
        let ([a, b, c, d], [w, x, y, z]) = (self.0, other.0);
        Self([
            a * w - b * x - c * y - d * z,
            a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x,
            a * z + b * y - c * x + d * w,
        ])
    }

    pub(crate) fn conjugate(self) -> Self {
        let [w, x, y, z] = self.0;
        Self([w, -x, -y, -z])
    }

    /// Returns the quaternion divided by its length.
    pub(crate) fn unit(self) -> Self {
        let [w, x, y, z] = self.0;
        let length = (w * w + x * x + y * y + z * z).root();
        Self(self.0.map(|c| c / length))
    }

    /// Returns q v q*.
    pub(crate) fn turned(self, [x, y, z]: [T; 3]) -> [T; 3] {
        let Self([_, x, y, z]) = self.times(Self([T::from(0.0), x, y, z])).times(self.conjugate());
        [x, y, z]
    }

    /// Returns the rotation by the shortest path from z to the unit vector n; with `downward`, from
    /// −z, after a half turn about x.
    pub(crate) fn from_z_to([x, y, z]: [T; 3], downward: bool) -> Self {
        let (zero, one) = (T::from(0.0), T::from(1.0));
        // 1 + z·n and z × n.
        if downward {
            let half_turn = Self([zero, one, zero, zero]);
            return Self([one - z, y, -x, zero]).unit().times(half_turn);
        }
        Self([one + z, -y, x, zero]).unit()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn z_goes_where_it_is_sent() {
        for n in [[0.36, 0.48, 0.8], [-0.36, 0.8, -0.48], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]] {
            let n = n.map(Double::from);
            let q = Quaternion::from_z_to(n, n[2].high < 0.0);
            let z = q.turned([0.0, 0.0, 1.0].map(Double::from));
            for k in 0..3 {
                assert!((z[k] - n[k]).value().abs() < 1e-15, "{z:?} {n:?}");
            }
        }
    }
}
