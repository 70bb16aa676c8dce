//! Principal axes in three words, of a tensor as it is given.

use crate::body::principal::{PrincipalFrame, Symmetry};
use crate::math::fine_eigen::FineEigen;
use crate::math::frame::Body;
use crate::math::symmetric3::{Symmetric3, power_of_two_near};
use crate::math::triple::Triple;
use crate::math::vector::Direction;

/// Principal moments in any order, and right-handed axes, to about 46 digits: after 10⁹ turns the 16 digits of a
/// [`PrincipalFrame`] would be 7, and differences of moments have fewer still.
#[derive(Clone, Copy, Debug)]
pub(super) struct FineAxes {
    /// In units of `unit`.
    pub(super) moments: [Triple; 3],
    pub(super) axes: [[Triple; 3]; 3],
    /// A power of two, kg·m².
    pub(super) unit: f64,
    /// True if these are the tensor's numbers as given, with no rounding of ours.
    pub(super) given: bool,
}

impl FineAxes {
    /// Of a tensor; along the to_body's own axes it is exact.
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
        // Where moments are equal, the to_body's axes are the nearest to the body's own, and not those of the last digits.
        let known =
            (principal.symmetry() == Symmetry::Asymmetric).then(|| principal.axes().map(Direction::to_array));
        let FineEigen { values: [a, b, c], vectors: axes } = FineEigen::of(&scaled, known);
        let moments = if principal.symmetry() == Symmetry::Rod {
            // A rod's own moment is zero, and what is found there is rounding, as is the difference of the others.
            let m = (b + c).scaled(0.5);
            [Triple::default(), m, m]
        } else {
            [a, b, c]
        };
        Self { moments, axes, unit, given: false }
    }

    /// The components of a body vector along the axes.
    pub(super) fn along(&self, v: [f64; 3]) -> [Triple; 3] {
        if self.given {
            return v.map(Triple::from);
        }
        let [x, y, z] = v;
        self.axes.map(|[a, b, c]| a.times(x) + b.times(y) + c.times(z))
    }
}
