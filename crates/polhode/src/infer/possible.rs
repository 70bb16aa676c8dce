//! Projection of a tensor to the nearest physical inertia tensor.

use crate::math::symmetric_eigen;

/// Relative rounding of second moments; a smaller negative value counts as zero.
const ROUNDING: f64 = 1e-12;

/// Returns the nearest physical inertia tensor, and true if the given one was not physical.
pub fn possible(i: [f64; 6]) -> ([f64; 6], bool) {
    let half = 0.5 * (i[0] + i[1] + i[2]);
    let (values, vectors) = symmetric_eigen([half - i[0], half - i[1], half - i[2], -i[3], -i[4], -i[5]]);
    let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    if values[0] >= 0.0 {
        return (i, false);
    }
    // A second moment g along each eigenvector v adds g (1 − v vᵀ).
    let mut inertia = [0.0; 6];
    for (value, v) in values.into_iter().zip(vectors) {
        let [x, y, z] = v;
        let added = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
        inertia = core::array::from_fn(|k| inertia[k] + value.max(0.0) * added[k]);
    }
    (inertia, values[0] < -ROUNDING * largest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_possible_stays() {
        let i = [3.1, 4.2, 5.3, 0.4, -0.3, 0.2];
        assert_eq!(possible(i), (i, false));
    }

    #[test]
    fn what_is_not_becomes_the_nearest_lamina() {
        let i = [1.0, 2.0, 4.0, 0.1, 0.05, -0.2];
        let (j, moved) = possible(i);
        assert!(moved);
        let g = |i: [f64; 6]| {
            let half = 0.5 * (i[0] + i[1] + i[2]);
            [half - i[0], half - i[1], half - i[2], -i[3], -i[4], -i[5]]
        };
        let (before, after) = (symmetric_eigen(g(i)), symmetric_eigen(g(j)));
        assert!(before.0[0] < -0.4 && after.0[0].abs() < 2e-15);
        for k in 1..3 {
            assert!((before.0[k] - after.0[k]).abs() < 2e-15, "{before:?} {after:?}");
        }
        // G⁺ − G is along the eigenvector with the negative value, so no other change to a possible
        // tensor is smaller.
        let change: f64 = g(i)
            .iter()
            .zip(g(j))
            .enumerate()
            .map(|(k, (a, b))| (a - b) * (a - b) * if k < 3 { 1.0 } else { 2.0 })
            .sum();
        assert!((change.sqrt() + before.0[0]).abs() < 2e-15);
    }
}
