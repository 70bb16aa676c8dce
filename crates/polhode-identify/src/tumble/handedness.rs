//! What a gyro whose axes are left-handed reads.
//!
//! With one axis reversed, or all of them, which is the same turned, Euler's equations are those of time that runs back: I ω̇ = −I ω × ω. In free motion another body
//! does the same forwards. Along principal axes I₁ ω̇₁ = (I₂ − I₃) ω₂ ω₃, and with second moments G, I₁ = G₂ + G₃, the coefficient is (G₃ − G₂)/(G₃ + G₂): it changes
//! its sign with 1/G in place of G. So free motion alone does not show it.

use super::flight::Flight;
use super::tumble::Tumble;

/// Which axes may be reversed in a gyro that is left-handed, and by what its readings have to be multiplied then: none of flights that show no more than free motion.
/// Something known in the body has a direction along the gyro's axes; attitudes have not.
pub(super) fn left_handed(flights: &[Flight]) -> &'static [(&'static str, [f64; 3])] {
    if flights.iter().any(Flight::has_scale) {
        &[
            ("x", [-1.0, 1.0, 1.0]),
            ("y", [1.0, -1.0, 1.0]),
            ("z", [1.0, 1.0, -1.0]),
            ("all of them", [-1.0, -1.0, -1.0]),
        ]
    } else if flights.iter().any(|flight| !flight.attitudes().is_empty()) {
        &[("one of them", [-1.0, -1.0, -1.0])]
    } else {
        &[]
    }
}

impl Tumble {
    /// i1/i3 and i2/i3 of the body whose free motion would be read if the gyro's axes are left-handed, unless the measurements tell the one from the other: moments
    /// I₁ G₁, I₂ G₂, I₃ G₃ but for their scale.
    pub fn left_handed_ratios(&self) -> Option<[f64; 2]> {
        let is_by_gyro =
            self.flights.iter().all(|f| !f.gyro_residuals.is_empty() && f.attitude_residuals.is_empty());
        let [i1, i2, i3] = self.principal.moments;
        let mut moments = [i1 * (i2 + i3 - i1), i2 * (i1 + i3 - i2), i3 * (i1 + i2 - i3)];
        moments.sort_by(f64::total_cmp);
        (is_by_gyro && !self.scale_is_known).then(|| [moments[0] / moments[2], moments[1] / moments[2]])
    }
}
