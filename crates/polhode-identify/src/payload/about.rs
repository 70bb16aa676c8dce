//! Parameters of a payload about the sensor's origin, and about its own centre of mass.

use nalgebra::DMatrix;
use polhode::math::symmetric_eigen;

use super::possible::moments_about_center;
use crate::estimate::Estimate;
use crate::least_squares::Information;
use crate::six::{ELEMENTS, PLACES, of_eigen, tensor_of};

const AXES: [&str; 3] = ["x", "y", "z"];
const CHANNELS: [(&str, &str); 6] =
    [("fx", "N"), ("fy", "N"), ("fz", "N"), ("tx", "N·m"), ("ty", "N·m"), ("tz", "N·m")];

type Name = (String, &'static str);

fn names(first: &str, unit: &'static str, suffix: &str, count: usize) -> Vec<Name> {
    let mut all = vec![("mass".to_owned(), "kg")];
    all.extend(AXES.map(|axis| (format!("{first} {axis}"), unit)));
    all.extend(ELEMENTS.map(|element| (format!("I{element}{suffix}"), "kg·m²")));
    all.extend(CHANNELS.map(|(channel, unit)| (format!("bias {channel}"), unit)));
    all.truncate(count);
    all
}

pub(super) fn about_origin(numbers: &[f64], information: &Information) -> Estimate {
    Estimate::new(names("moment", "kg·m", " about the origin", numbers.len()), numbers, information)
}

/// Returns the estimate as m, c and the tensor about the centre of mass.
pub(super) fn about_center(numbers: &[f64], information: &Information) -> Estimate {
    let (values, jacobian) = to_center(numbers);
    Estimate::new(names("center", "m", "", numbers.len()), &values, &information.of_other(&jacobian))
}

/// Returns second moments without negative eigenvalues, which rounding causes if c is large.
fn not_negative(g: [f64; 6]) -> [f64; 6] {
    let (values, vectors) = symmetric_eigen(g);
    if values[0] >= 0.0 {
        return g;
    }
    of_eigen(values.map(|value| value.max(0.0)), vectors)
}

/// Converts m, m c and I about the origin to m, c and I about the centre of mass; further
/// parameters stay the same. Returns the values and their Jacobian.
pub(super) fn to_center(numbers: &[f64]) -> (Vec<f64>, DMatrix<f64>) {
    let n = numbers.len();
    let m = numbers[0];
    let c = [1, 2, 3].map(|k| numbers[k] / m);
    let mut values = numbers.to_vec();
    let mut jacobian = DMatrix::identity(n, n);
    let own = tensor_of(not_negative(moments_about_center(numbers)));
    for k in 0..3 {
        values[1 + k] = c[k];
        jacobian[(1 + k, 0)] = -c[k] / m;
        jacobian[(1 + k, 1 + k)] = 1.0 / m;
    }
    let square: f64 = c.iter().map(|c| c * c).sum();
    for (k, (i, j)) in PLACES.into_iter().enumerate() {
        values[4 + k] = own[k];
        // Parallel-axis theorem: I_c = I − (h² δ_ij − h_i h_j)/m
        let same = if i == j { 1.0 } else { 0.0 };
        jacobian[(4 + k, 0)] = square * same - c[i] * c[j];
        for l in 0..3 {
            let by_i = if l == i { c[j] } else { 0.0 };
            let by_j = if l == j { c[i] } else { 0.0 };
            jacobian[(4 + k, 1 + l)] = by_i + by_j - 2.0 * c[l] * same;
        }
    }
    (values, jacobian)
}
