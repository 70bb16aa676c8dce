//! Principal axes of a tensor in triple-double arithmetic.

use crate::body::principal::{PrincipalFrame, Symmetry};
use crate::math::fine_eigen::FineEigen;
use crate::math::frame::Body;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::triple::Triple;
use crate::math::vector::Direction;

/// Principal moments, in any order, and right-handed axes, accurate to about 46 digits.
///
/// The 16 digits of a [`PrincipalFrame`] do not suffice: after 10⁹ turns only 7 would remain, and
/// differences of moments have fewer still.
#[derive(Clone, Copy, Debug)]
pub(super) struct FineAxes {
    /// Principal moments, in units of `unit`.
    pub(super) moments: [Triple; 3],
    pub(super) axes: [[Triple; 3]; 3],
    /// Unit of the moments: a power of two, kg·m².
    pub(super) unit: f64,
    /// True if moments and axes are exactly the tensor's numbers, without additional rounding.
    pub(super) given: bool,
}

impl FineAxes {
    /// Finds the principal axes of a tensor. The result is exact if the tensor is diagonal.
    pub(super) fn of(tensor: &Symmetric3, principal: &PrincipalFrame<Body>) -> Self {
        let unit = power_of_two_near(principal.moments()[2]);
        let scaled = *tensor * (1.0 / unit);
        if [scaled.xy, scaled.xz, scaled.yz] == [0.0; 3] {
            let moments = [scaled.xx, scaled.yy, scaled.zz].map(Triple::from);
            let (one, zero) = (Triple::from(1.0), Triple::default());
            return Self {
                moments,
                axes: [[one, zero, zero], [zero, one, zero], [zero, zero, one]],
                unit,
                given: true,
            };
        }
        // If moments are equal, the axes stay those nearest to the body's own axes. The last digits
        // of the tensor would otherwise choose them.
        let known =
            (principal.symmetry() == Symmetry::Asymmetric).then(|| principal.axes().map(Direction::to_array));
        let FineEigen { values: [a, b, c], vectors: axes } = FineEigen::of(&scaled, known);
        let moments = if principal.symmetry() == Symmetry::Rod {
            // The moment of a rod about itself is zero. A computed value is rounding, and so is the
            // difference of the other two.
            let m = (b + c).scaled(0.5);
            [Triple::default(), m, m]
        } else {
            [a, b, c]
        };
        Self { moments, axes, unit, given: false }
    }

    /// Returns the components of a body vector along the principal axes.
    pub(super) fn along(&self, v: [f64; 3]) -> [Triple; 3] {
        if self.given {
            return v.map(Triple::from);
        }
        let [x, y, z] = v;
        self.axes.map(|[a, b, c]| a.times(x) + b.times(y) + c.times(z))
    }
}
