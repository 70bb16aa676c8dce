//! Principal moments and axes of an estimated tensor, with their errors.

use polhode::body::ratio_region;
use polhode::math::symmetric_eigen;

use crate::estimate::{ANGLE, Estimate, Undetermined};
use crate::six::between;

/// Principal moments and axes, with errors to first order in the tensor's error δI.
///
/// Moments change by δiⱼ = vⱼ·δI vⱼ. The axes turn about vₖ by εₖ = vᵢ·δI vⱼ/(iⱼ − iᵢ), (i, j, k)
/// cyclic.
#[derive(Clone, Debug, PartialEq)]
pub struct PrincipalEstimate {
    /// Principal moments in ascending order, in the tensor's unit.
    pub moments: [f64; 3],
    /// Standard deviations of the moments; `None` where the size is unobservable.
    pub moment_sd: [Option<f64>; 3],
    /// Covariance of the moments; `None` if the size of one is unobservable.
    pub moment_covariance: Option<[[f64; 3]; 3]>,
    /// Ratios i1/i3 and i2/i3.
    pub ratios: [f64; 2],
    /// Standard deviations of the ratios.
    pub ratio_sd: [Option<f64>; 2],
    /// Correlation of the two ratios.
    pub ratio_correlation: Option<f64>,
    /// Relative thickness (i1 + i2 − i3)/i3: zero for a lamina, never negative.
    pub thickness: f64,
    /// Standard deviation of the thickness.
    pub thickness_sd: Option<f64>,
    /// Principal axes: unit vectors, right-handed.
    pub axes: [[f64; 3]; 3],
    /// Standard deviation of the rotation of all axes about each axis, rad. `None` where
    /// unobservable; infinite where the other two moments are equal.
    pub turn_sd: [Option<f64>; 3],
}

/// Widths of the possible ranges of i1/i3, in [0, 1], and i2/i3, in [½, 1].
const RATIO_RANGES: [f64; 2] = [1.0, 0.5];
/// Width of the possible range of (i1 + i2 − i3)/i3, in [0, 1].
const THICKNESS_RANGE: f64 = 1.0;

impl PrincipalEstimate {
    /// Returns [`ratio_region`] for the estimated ratios; `None` where they are not determined.
    pub fn ratio_region(&self, probability: f64) -> Option<Vec<[f64; 2]>> {
        let [Some(first), Some(second)] = self.ratio_sd else { return None };
        ratio_region(self.ratios, [first, second], self.ratio_correlation.unwrap_or(0.0), probability)
    }

    /// Returns the reason why i1/i3 (`k` = 0) or i2/i3 (`k` = 1) is not determined; `None` if it
    /// is.
    ///
    /// # Panics
    /// If `k` is neither 0 nor 1.
    pub fn undetermined_ratio(&self, k: usize) -> Option<Undetermined> {
        Undetermined::of(self.ratio_sd[k], RATIO_RANGES[k])
    }

    /// Returns the reason why the thickness is not determined; `None` if it is.
    pub fn undetermined_thickness(&self) -> Option<Undetermined> {
        Undetermined::of(self.thickness_sd, THICKNESS_RANGE)
    }

    /// Returns the reason why the rotation about axis `k` is not determined; `None` if it is.
    ///
    /// # Panics
    /// If `k` is above 2.
    pub fn undetermined_turn(&self, k: usize) -> Option<Undetermined> {
        Undetermined::of(self.turn_sd[k], ANGLE)
    }

    /// Computes the principal moments and axes of six parameters Ixx, Iyy, Izz, Ixy, Ixz, Iyz from
    /// index `first`.
    ///
    /// # Panics
    /// If fewer than six parameters follow `first`.
    pub fn of_tensor(estimate: &Estimate, first: usize) -> Self {
        let tensor = core::array::from_fn(|k| estimate.numbers[first + k].value);
        let (moments, mut axes) = symmetric_eigen(tensor);
        let [a, b, c] = axes;
        let handed = a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        if handed < 0.0 {
            axes[2] = axes[2].map(|x| -x);
        }
        let gradient = |six: [f64; 6]| {
            let mut all = vec![0.0; estimate.numbers.len()];
            all[first..first + 6].copy_from_slice(&six);
            all
        };
        let moment_rows = axes.map(|axis| between(axis, axis));
        let greatest = moments[2];
        let ratio = |k: usize| moments[k] / greatest;
        let ratio_row = |k: usize| -> [f64; 6] {
            core::array::from_fn(|e| (moment_rows[k][e] - ratio(k) * moment_rows[2][e]) / greatest)
        };
        let (one, two) = (ratio_row(0), ratio_row(1));
        let sd = |six: [f64; 6]| estimate.deviation(&gradient(six));
        let sum: [f64; 6] = core::array::from_fn(|e| one[e] + two[e]);
        let (sd_one, sd_two, sd_sum) = (sd(one), sd(two), sd(sum));
        let correlation = match (sd_one, sd_two, sd_sum) {
            (Some(a), Some(b), Some(both)) if a > 0.0 && b > 0.0 => {
                Some((both * both - a * a - b * b) / (2.0 * a * b))
            }
            _ => None,
        };
        let moment_sd = moment_rows.map(sd);
        let covariance = |a: [f64; 6], b: [f64; 6]| -> f64 {
            let of = |i: usize, j: usize| a[i] * b[j] * estimate.covariance[first + i][first + j];
            (0..6).map(|i| (0..6).map(|j| of(i, j)).sum::<f64>()).sum()
        };
        Self {
            moments,
            moment_sd,
            moment_covariance: moment_sd
                .iter()
                .all(Option::is_some)
                .then(|| moment_rows.map(|a| moment_rows.map(|b| covariance(a, b)))),
            ratios: [ratio(0), ratio(1)],
            ratio_sd: [sd_one, sd_two],
            ratio_correlation: correlation,
            thickness: ratio(0) + ratio(1) - 1.0,
            thickness_sd: sd_sum,
            axes,
            turn_sd: core::array::from_fn(|k| {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let apart = moments[j] - moments[i];
                if apart == 0.0 {
                    return Some(f64::INFINITY);
                }
                sd(between(axes[i], axes[j])).map(|sd| sd / apart.abs())
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::PrincipalEstimate;

    #[test]
    fn ratios_that_are_not_known_have_no_region() {
        let mut estimate = PrincipalEstimate {
            moments: [0.6, 0.8, 1.0],
            moment_sd: [None; 3],
            moment_covariance: None,
            ratios: [0.6, 0.8],
            ratio_sd: [Some(0.01), Some(0.02)],
            ratio_correlation: Some(0.0),
            thickness: 0.4,
            thickness_sd: None,
            axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            turn_sd: [None; 3],
        };
        assert!(estimate.ratio_region(0.95).is_some());
        estimate.ratio_sd[1] = None;
        assert_eq!(estimate.ratio_region(0.95), None);
    }
}
