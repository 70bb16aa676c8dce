//! Readings of a gyro with left-handed axes.
//!
//! One reversed axis, or three (the same up to a rotation), turn Euler's equations into those of
//! reversed time: I ω̇ = −I ω × ω. Another body has the same free motion forwards in time. Along
//! principal axes I₁ ω̇₁ = (I₂ − I₃) ω₂ ω₃. With second moments G, I₁ = G₂ + G₃, and the
//! coefficient is (G₃ − G₂)/(G₃ + G₂). It changes its sign when 1/G replaces G. So free motion
//! alone cannot reveal left-handed axes.

use super::flight::Flight;
use super::tumble::Tumble;

/// Returns the axes that may be reversed in a left-handed gyro, with the factors of its readings.
/// The list is empty for flights that show free motion only.
///
/// An added body, wheel or torque is known along the gyro's axes, so it identifies the axis.
/// Attitudes do not.
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
    /// Returns i1/i3 and i2/i3 of the body that would give the same readings if the gyro's axes
    /// were left-handed. Its moments are I₁ G₁, I₂ G₂, I₃ G₃ up to scale. `None` if the
    /// measurements exclude it.
    pub fn left_handed_ratios(&self) -> Option<[f64; 2]> {
        let is_by_gyro =
            self.flights.iter().all(|f| !f.gyro_residuals.is_empty() && f.attitude_residuals.is_empty());
        let [i1, i2, i3] = self.principal.moments;
        let mut moments = [i1 * (i2 + i3 - i1), i2 * (i1 + i3 - i2), i3 * (i1 + i2 - i3)];
        moments.sort_by(f64::total_cmp);
        (is_by_gyro && !self.scale_is_known).then(|| [moments[0] / moments[2], moments[1] / moments[2]])
    }
}
