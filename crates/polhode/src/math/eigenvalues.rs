//! Eigenvalues of small nonsymmetric matrices.
//!
//! The method is balancing, reduction to Hessenberg form by elimination, and Francis's
//! double-shifted QR steps. All arithmetic is real, so that complex eigenvalues are exact conjugate
//! pairs. Eigenvectors are computed one by one, by inverse iteration.
//!
//! Source: Wilkinson & Reinsch, Handbook for Automatic Computation II (1971), contributions II/11
//! (balance), II/13 (elmhes) and II/14 (hqr).

#![allow(clippy::needless_range_loop, reason = "rows and columns have the numbers of the algorithm")]

use super::complex::Complex;

/// Square matrix, row by row.
pub(crate) type Matrix<const N: usize> = [[f64; N]; N];

/// Maximum number of QR steps for one eigenvalue; more than about five do not occur.
const MOST_STEPS: usize = 60;

/// Returns all eigenvalues, a complex one followed by its conjugate; `None` if an element is not
/// finite or the QR steps do not converge.
///
/// Errors are a few ε times the norm of the balanced matrix and the condition of the eigenvalue;
/// for a defective pair, √ε instead of ε.
pub(crate) fn eigenvalues<const N: usize>(matrix: &Matrix<N>) -> Option<[Complex<f64>; N]> {
    if !matrix.iter().flatten().all(|x| x.is_finite()) {
        return None;
    }
    let mut a = *matrix;
    balance(&mut a);
    to_hessenberg(&mut a);
    by_qr(a)
}

/// Scales rows and columns by powers of two, which is exact, until their norms are similar.
fn balance<const N: usize>(a: &mut Matrix<N>) {
    let mut done = false;
    while !done {
        done = true;
        for i in 0..N {
            let others = || (0..N).filter(|&j| j != i);
            let mut c: f64 = others().map(|j| a[j][i].abs()).sum();
            let r: f64 = others().map(|j| a[i][j].abs()).sum();
            if !(c > 0.0 && r > 0.0) {
                continue;
            }
            let (sum, mut f) = (c + r, 1.0);
            while c < r / 2.0 {
                (f, c) = (f * 2.0, c * 4.0);
            }
            while c >= r * 2.0 {
                (f, c) = (f / 2.0, c / 4.0);
            }
            if (c + r) / f < 0.95 * sum {
                done = false;
                (0..N).for_each(|j| a[i][j] /= f);
                (0..N).for_each(|j| a[j][i] *= f);
            }
        }
    }
}

/// Eliminates the elements below the subdiagonal, with row interchanges.
fn to_hessenberg<const N: usize>(a: &mut Matrix<N>) {
    for m in 1..N.saturating_sub(1) {
        let pivot = (m..N).max_by(|&i, &j| a[i][m - 1].abs().total_cmp(&a[j][m - 1].abs())).unwrap_or(m);
        a.swap(pivot, m);
        a.iter_mut().for_each(|row| row.swap(pivot, m));
        let x = a[m][m - 1];
        if x == 0.0 {
            continue;
        }
        for i in m + 1..N {
            let y = a[i][m - 1] / x;
            a[i][m - 1] = 0.0;
            for j in m..N {
                a[i][j] -= y * a[m][j];
            }
            for row in a.iter_mut() {
                row[m] += y * row[i];
            }
        }
    }
}

/// Returns the eigenvalues of a Hessenberg matrix.
fn by_qr<const N: usize>(mut a: Matrix<N>) -> Option<[Complex<f64>; N]> {
    let mut found = [Complex { re: 0.0, im: 0.0 }; N];
    let norm: f64 = a.iter().flatten().map(|x| x.abs()).sum();
    let (mut size, mut shifted, mut steps) = (N, 0.0, 0);
    while size > 0 {
        let n = size - 1;
        let low = split(&mut a, n, norm);
        if low == n {
            found[n].re = a[n][n] + shifted;
            (size, steps) = (size - 1, 0);
            continue;
        }
        let (x, y, w) = (a[n][n], a[n - 1][n - 1], a[n][n - 1] * a[n - 1][n]);
        if low + 1 == n {
            [found[n - 1], found[n]] = pair(x, y, w, shifted);
            (size, steps) = (size - 2, 0);
            continue;
        }
        if steps == MOST_STEPS {
            return None;
        }
        let (mut sum, mut product) = (x + y, x * y - w);
        if steps % 10 == 9 {
            // Exceptional shift, in case the usual shifts cycle.
            shifted += x;
            (0..size).for_each(|i| a[i][i] -= x);
            let s = a[n][n - 1].abs() + a[n - 1][n - 2].abs();
            (sum, product) = (1.5 * s, s * s);
        }
        steps += 1;
        francis(&mut a, low, n, sum, product);
    }
    Some(found)
}

/// Returns the first row of the last unreduced block.
fn split<const N: usize>(a: &mut Matrix<N>, n: usize, norm: f64) -> usize {
    for l in (1..=n).rev() {
        let beside = a[l - 1][l - 1].abs() + a[l][l].abs();
        let beside = if beside == 0.0 { norm } else { beside };
        if a[l][l - 1].abs() <= f64::EPSILON * beside {
            a[l][l - 1] = 0.0;
            return l;
        }
    }
    0
}

/// Returns the eigenvalues of a 2 × 2 block [[y, ·], [·, x]], where w is the product of the
/// off-diagonal elements.
fn pair(x: f64, y: f64, w: f64, shifted: f64) -> [Complex<f64>; 2] {
    let p = 0.5 * (y - x);
    let q = p * p + w;
    let (z, x) = (q.abs().sqrt(), x + shifted);
    if q < 0.0 {
        return [Complex { re: x + p, im: z }, Complex { re: x + p, im: -z }];
    }
    let z = p + z.copysign(p);
    let other = if z == 0.0 { x } else { x - w / z };
    [Complex { re: x + z, im: 0.0 }, Complex { re: other, im: 0.0 }]
}

/// Performs one implicit double step on rows low … n, with shifts of this sum and product.
fn francis<const N: usize>(a: &mut Matrix<N>, low: usize, n: usize, sum: f64, product: f64) {
    // First column of (A − s₁)(A − s₂).
    let mut v = [
        a[low][low] * (a[low][low] - sum) + product + a[low][low + 1] * a[low + 1][low],
        a[low + 1][low] * (a[low][low] + a[low + 1][low + 1] - sum),
        a[low + 1][low] * a[low + 2][low + 1],
    ];
    for k in low..n {
        let rows = if k + 1 == n { 2 } else { 3 };
        if k > low {
            v = core::array::from_fn(|i| if i < rows { a[k + i][k - 1] } else { 0.0 });
        }
        let Some((u, tau, alpha)) = reflector(v) else { continue };
        if k > low {
            a[k][k - 1] = alpha;
            (1..rows).for_each(|i| a[k + i][k - 1] = 0.0);
        }
        for j in k..N {
            let s: f64 = tau * (0..rows).map(|i| u[i] * a[k + i][j]).sum::<f64>();
            (0..rows).for_each(|i| a[k + i][j] -= s * u[i]);
        }
        for row in a.iter_mut().take((k + 4).min(n + 1)) {
            let s: f64 = tau * (0..rows).map(|i| u[i] * row[k + i]).sum::<f64>();
            (0..rows).for_each(|i| row[k + i] -= s * u[i]);
        }
    }
}

/// Returns Householder's (u, τ, α) with (1 − τ u uᵀ) v = α e₁; `None` for a zero vector.
fn reflector(v: [f64; 3]) -> Option<([f64; 3], f64, f64)> {
    let scale = v.iter().fold(0.0, |max: f64, x| max.max(x.abs()));
    if scale == 0.0 {
        return None;
    }
    let [x, y, z] = v.map(|x| x / scale);
    let alpha = -(x * x + y * y + z * z).sqrt().copysign(x);
    // u = v − α e₁ and uᵀu = 2 α (α − x).
    Some(([x - alpha, y, z], 1.0 / (alpha * (alpha - x)), alpha * scale))
}

/// Returns a unit eigenvector of an eigenvalue; different values of `seed` give different vectors
/// of a multiple eigenvalue.
pub(crate) fn eigenvector<const N: usize>(
    matrix: &Matrix<N>,
    value: Complex<f64>,
    seed: usize,
) -> [Complex<f64>; N] {
    let norm = matrix.iter().flatten().fold(f64::MIN_POSITIVE, |max, x| max.max(x.abs()));
    // Generic start: fractional parts of multiples of the golden ratio.
    let start = |i: usize| Complex {
        re: 0.5 + libm::fmod(0.618_033_988_749_895 * (N * seed + i + 1) as f64, 1.0),
        im: 0.0,
    };
    let mut v: [Complex<f64>; N] = core::array::from_fn(start);
    for _ in 0..3 {
        solve(matrix, value, norm, &mut v);
        let length = v.iter().map(|c| c.re * c.re + c.im * c.im).sum::<f64>().sqrt();
        v = v.map(|c| Complex { re: c.re / length, im: c.im / length });
    }
    v
}

/// Replaces v by (A − λ)⁻¹ v, using elimination with row interchanges; a vanishing pivot is
/// replaced by one of the size of rounding.
fn solve<const N: usize>(matrix: &Matrix<N>, value: Complex<f64>, norm: f64, v: &mut [Complex<f64>; N]) {
    let mut a: [[Complex<f64>; N]; N] = matrix.map(|row| row.map(|re| Complex { re, im: 0.0 }));
    (0..N).for_each(|i| a[i][i] = a[i][i].minus(value));
    for k in 0..N {
        let pivot = (k..N).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap_or(k);
        a.swap(pivot, k);
        v.swap(pivot, k);
        if a[k][k].abs() < f64::EPSILON * norm {
            a[k][k] = Complex { re: f64::EPSILON * norm, im: 0.0 };
        }
        for i in k + 1..N {
            let factor = a[i][k].over(a[k][k]);
            for j in k..N {
                a[i][j] = a[i][j].minus(factor.times(a[k][j]));
            }
            v[i] = v[i].minus(factor.times(v[k]));
        }
    }
    for k in (0..N).rev() {
        let rest = (k + 1..N).fold(v[k], |sum, j| sum.minus(a[k][j].times(v[j])));
        v[k] = rest.over(a[k][k]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(mut found: Vec<Complex<f64>>, expected: &[(f64, f64)], tolerance: f64) {
        for &(re, im) in expected {
            let distance = |c: &Complex<f64>| c.minus(Complex { re, im }).abs();
            let nearest =
                (0..found.len()).min_by(|&i, &j| distance(&found[i]).total_cmp(&distance(&found[j])));
            let nearest = found.swap_remove(nearest.unwrap());
            assert!(distance(&nearest) < tolerance, "{nearest:?} is not {re} + {im} i");
        }
        assert!(found.is_empty());
    }

    /// Generic elements of six scales; eigenvalues by mpmath 1.3 (`mp.eig`) with 40 digits.
    #[test]
    fn eigenvalues_are_those_of_many_digits() {
        let a = GENERIC;
        close(eigenvalues(&a).unwrap().to_vec(), &GENERIC_VALUES, 3e-14);
        // A matrix with a known spectrum: the companion of (s² + 4)(s² + 0.02 s + 9)(s + 1)(s − 3).
        let mut companion = [[0.0; 6]; 6];
        (0..5).for_each(|i| companion[i][i + 1] = 1.0);
        companion[5] = COMPANION;
        let expected =
            [(0.0, 2.0), (0.0, -2.0), (-0.01, (9.0f64 - 1e-4).sqrt()), (-0.01, -(9.0f64 - 1e-4).sqrt())];
        close(
            eigenvalues(&companion).unwrap().to_vec(),
            &[&expected[..], &[(-1.0, 0.0), (3.0, 0.0)]].concat(),
            3e-13,
        );
    }

    #[test]
    fn scales_and_zeros_are_no_trouble() {
        close(eigenvalues(&[[0.0; 3]; 3]).unwrap().to_vec(), &[(0.0, 0.0); 3], 1e-300);
        // ẍ = −ω² x in units that differ by 1e±150.
        let a = [[0.0, 1e-150], [-4e150, 0.0]];
        close(eigenvalues(&a).unwrap().to_vec(), &[(0.0, 2.0), (0.0, -2.0)], 1e-14);
        // A permutation, for which unshifted QR steps do not converge.
        let turn = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let half = 0.75_f64.sqrt();
        close(eigenvalues(&turn).unwrap().to_vec(), &[(1.0, 0.0), (-0.5, half), (-0.5, -half)], 1e-15);
        assert!(eigenvalues(&[[f64::NAN]]).is_none());
    }

    #[test]
    fn vectors_satisfy_their_equation() {
        for (k, value) in eigenvalues(&GENERIC).unwrap().into_iter().enumerate() {
            let v = eigenvector(&GENERIC, value, k);
            for (row, x) in GENERIC.iter().zip(&v) {
                let zero = Complex { re: 0.0, im: 0.0 };
                let av = row
                    .iter()
                    .zip(&v)
                    .fold(zero, |sum, (a, c)| Complex { re: sum.re + a * c.re, im: sum.im + a * c.im });
                assert!(av.minus(value.times(*x)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn an_eigenvalue_with_a_plane_has_two_vectors() {
        let a = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [1.0, 0.0, 5.0]];
        let value = Complex { re: 2.0, im: 0.0 };
        let [u, v] = [0, 1].map(|seed| eigenvector(&a, value, seed));
        let across = u[0].re * v[1].re - u[1].re * v[0].re;
        assert!(across.abs() > 1e-2, "{u:?} {v:?}");
    }

    #[rustfmt::skip]
    const GENERIC: Matrix<6> = [
        [-0.352, -0.021, -0.0855, -0.0269, 0.819, -9.25],
        [-0.164, -8.19, -0.0882, 0.0895, 1.54, -0.901],
        [-0.907, -0.421, 0.0814, 0.121, -0.794, -0.0255],
        [0.129, -0.0717, 5.54, 1.71, -0.277, 0.589],
        [-0.836, 0.0504, 0.459, 0.0218, -7.64, -0.67],
        [-6.96, -0.0157, 0.529, -0.32, 1.89, -0.0862],
    ];
    #[rustfmt::skip]
    const GENERIC_VALUES: [(f64, f64); 6] = [
        (-7.870301887515095, -1.3929643878334503),
        (-8.247273437588193, 0.0),
        (-7.870301887515095, 1.3929643878334503),
        (-0.4272987837645074, 0.0),
        (2.107964803244669, 0.0),
        (7.8304111931382225, 0.0),
    ];
    const COMPANION: [f64; 6] = [108.0, 72.24, 3.16, 25.98, -9.96, 1.98];
}
