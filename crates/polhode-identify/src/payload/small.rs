//! Small matrices on the stack, mostly with six rows.

pub(super) type Vector6 = [f64; 6];
pub(super) type Matrix6 = [[f64; 6]; 6];

/// Returns the Cholesky factor L of L Lᵀ; `None` for a matrix that is not positive definite.
pub(super) fn cholesky<const N: usize>(a: &[[f64; N]; N]) -> Option<[[f64; N]; N]> {
    let mut l = [[0.0; N]; N];
    for i in 0..N {
        for j in 0..=i {
            let rest = a[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            l[i][j] = if i > j {
                rest / l[j][j]
            } else if rest > 0.0 {
                rest.sqrt()
            } else {
                return None;
            };
        }
    }
    Some(l)
}

/// Returns the first pivot that is not positive, or else the last pivot.
pub(super) fn least_pivot(a: &Matrix6) -> f64 {
    let mut a = *a;
    for k in 0..6 {
        if !(a[k][k] > 0.0) {
            return a[k][k];
        }
        for i in k + 1..6 {
            let factor = a[i][k] / a[k][k];
            let pivot = a[k];
            (k..6).for_each(|j| a[i][j] -= factor * pivot[j]);
        }
    }
    a[5][5]
}

/// Returns L⁻¹ b.
pub(super) fn forward(l: &Matrix6, mut b: Vector6) -> Vector6 {
    for i in 0..6 {
        let rest = b[i] - (0..i).map(|k| l[i][k] * b[k]).sum::<f64>();
        b[i] = rest / l[i][i];
    }
    b
}

/// Returns L⁻ᵀ b.
pub(super) fn backward(l: &Matrix6, mut b: Vector6) -> Vector6 {
    for i in (0..6).rev() {
        let rest = b[i] - (i + 1..6).map(|k| l[k][i] * b[k]).sum::<f64>();
        b[i] = rest / l[i][i];
    }
    b
}

/// Returns a × b.
pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
