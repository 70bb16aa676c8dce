//! Least squares constrained to physically consistent bodies: a convex problem, solved by an
//! interior-point method.
//!
//! Parameters p = (m, h = m c, I about the origin, …) are physically consistent if and only if the
//! pseudo-inertia
//!
//! P(p) = ((m, hᵀ), (h, Σ)),  Σ = ½ tr(I) 1 − I
//!
//! is positive semidefinite. For μ → 0 the method follows the minimum of
//!
//! ½‖z − R δ‖² − μ ln det P(p + δ),
//!
//! which is within 4 μ of the constrained minimum. With P = L Lᵀ and A_j = L⁻¹ (∂P/∂p_j) L⁻ᵀ, the
//! Newton step minimizes ‖z − R δ‖² + μ ‖A δ − 1‖². This least-squares form does not square the
//! condition number, and it does not depend on units. Unlike in coordinates of a factor of P, there
//! is a single minimum, even if it is a lamina or a rod.
//!
//! Sources: P. M. Wensing, S. Kim, J.-J. E. Slotine, IEEE Robot. Autom. Lett. 3 (2018) 60, for P;
//! S. Boyd, L. Vandenberghe, *Convex Optimization* (2004), § 11.3.

use nalgebra::{DMatrix, DVector};
use polhode::math::symmetric_eigen;

use super::small::cholesky;
use crate::decomposition::qr;
use crate::error::IdentifyError;
use crate::six::{PLACES, of_eigen, tensor_of};

/// Final barrier parameter μ, relative to 1 + ½χ². The minimum of ½χ² is accurate to four times
/// this.
const LEAST_MU: f64 = 1e-10;
/// Reduction factor of μ.
const FALL: f64 = 0.1;
/// Maximum number of Newton steps.
const MOST_STEPS: usize = 1000;

type Matrix4 = [[f64; 4]; 4];

/// Returns true if P is positive definite.
pub(super) fn is_possible(numbers: &[f64]) -> bool {
    cholesky(&pseudo_inertia(numbers)).is_some()
}

/// Returns the second moments G = Σ − h hᵀ/m about the centre of mass: xx, yy, zz, xy, xz, yz.
pub(super) fn moments_about_center(numbers: &[f64]) -> [f64; 6] {
    let p = pseudo_inertia(numbers);
    PLACES.map(|(i, j)| p[1 + i][1 + j] - p[0][1 + i] * p[0][1 + j] / numbers[0])
}

/// Minimizes ‖z − R (p − from)‖² over physically consistent bodies. Along the unobservable
/// directions (columns of `unknown`) it takes the body with the smallest trace of P.
pub(super) fn least_squares(
    r: &DMatrix<f64>,
    z: &DVector<f64>,
    from: &DVector<f64>,
    free: &DVector<f64>,
    unknown: &DMatrix<f64>,
) -> Result<DVector<f64>, IdentifyError> {
    let n = from.len();
    let pull = pull(unknown, n)?;
    let not_finite = IdentifyError::NotFinite { quantity: "the pseudo-inertia of a possible body" };
    let mut place = inside(free);
    let rest = |place: &DVector<f64>| z - r * (place - from);
    let mut mu = (0.5 * rest(&place).norm_squared()).max(1.0);
    for _ in 0..MOST_STEPS {
        let Some(l) = cholesky(&pseudo_inertia(place.as_slice())) else {
            return Err(not_finite);
        };
        let step = newton(r, &rest(&place), &l, mu, &pull)?.ok_or_else(|| not_finite.clone())?;
        let value = |place: &DVector<f64>| {
            let l = cholesky(&pseudo_inertia(place.as_slice()))?;
            let barrier: f64 = (0..4).map(|k| libm::log(l[k][k])).sum();
            Some(0.5 * rest(place).norm_squared() - 2.0 * mu * barrier + pull.dot(place))
        };
        let here = value(&place).ok_or_else(|| not_finite.clone())?;
        // The function is self-concordant, so steps shorter than 1/(1 + ν) are necessary only
        // because of rounding.
        let shortest = 0.25 / (1.0 + (step.decrement / mu).sqrt());
        let lowers = |taken: f64| {
            value(&(&place + &step.delta * taken))
                .is_some_and(|there| there <= here - 0.1 * taken * step.decrement)
        };
        let mut taken = 1.0;
        while taken > shortest && !lowers(taken) {
            taken *= 0.5;
        }
        let stuck = taken <= shortest;
        if !stuck {
            place += &step.delta * taken;
        }
        if stuck || step.decrement < 0.1 * mu {
            if mu <= LEAST_MU * (1.0 + 0.5 * rest(&place).norm_squared()) {
                return Ok(place);
            }
            mu *= FALL;
        }
    }
    Err(IdentifyError::NoConvergence { steps: MOST_STEPS })
}

struct Newton {
    delta: DVector<f64>,
    /// Squared length in the norm of the second derivative: twice the predicted decrease.
    decrement: f64,
}

/// Computes the Newton step; `None` if the equations are singular.
fn newton(
    r: &DMatrix<f64>,
    z: &DVector<f64>,
    l: &Matrix4,
    mu: f64,
    pull: &DVector<f64>,
) -> Result<Option<Newton>, IdentifyError> {
    let (rows, n) = r.shape();
    let mut all = DMatrix::zeros(rows + 10, n + 1);
    all.view_mut((0, 0), (rows, n)).copy_from(r);
    all.view_mut((0, n), (rows, 1)).copy_from(z);
    let root = mu.sqrt();
    for j in 0..10 {
        for (k, a) in scaled_element(l, j).into_iter().enumerate() {
            all[(rows + k, j)] = root * a;
        }
    }
    (0..4).for_each(|k| all[(rows + k, n)] = root);
    let triangle = qr("a derivative of the pseudo-inertia", all)?.r();
    let upper = triangle.view((0, 0), (n, n)).into_owned();
    let Some(pulled) = upper.tr_solve_upper_triangular(pull) else { return Ok(None) };
    let right = triangle.view((0, n), (n, 1)).column(0) - pulled;
    let Some(delta) = upper.solve_upper_triangular(&right) else { return Ok(None) };
    let decrement = right.norm_squared();
    let is_finite = decrement.is_finite() && delta.iter().all(|d| d.is_finite());
    Ok(is_finite.then_some(Newton { delta, decrement }))
}

/// Returns the gradient of a small multiple of tr P, projected on the unobservable directions.
fn pull(unknown: &DMatrix<f64>, n: usize) -> Result<DVector<f64>, IdentifyError> {
    let mut trace = DVector::zeros(n);
    trace[0] = 1.0;
    (4..7).for_each(|k| trace[k] = 0.5);
    let mut pull = DVector::zeros(n);
    if unknown.ncols() > 0 {
        let q = qr("an unobservable direction", unknown.clone())?.q();
        pull = &q * (q.transpose() * trace) * SMALL;
    }
    Ok(pull)
}

/// Weight of the trace, which is the only cost in unobservable directions.
const SMALL: f64 = 1e-3;

/// Returns a strictly consistent body near parameters that may be inconsistent.
fn inside(free: &DVector<f64>) -> DVector<f64> {
    let mut place = free.clone();
    let size = free.rows(0, 10).amax().max(f64::MIN_POSITIVE);
    let m = free[0].abs().max(1e-6 * size);
    place[0] = m;
    let c = [1, 2, 3].map(|k| place[k] / m);
    let (values, vectors) = symmetric_eigen(moments_about_center(place.as_slice()));
    let largest = values.iter().fold(1e-9 * size, |most, v| most.max(v.abs()));
    let values = values.map(|v| v.abs().max(0.1 * largest));
    let mut sigma = of_eigen(values, vectors);
    sigma.iter_mut().zip(PLACES).for_each(|(element, (i, j))| *element += m * c[i] * c[j]);
    place.as_mut_slice()[4..10].copy_from_slice(&tensor_of(sigma));
    place
}

fn pseudo_inertia(numbers: &[f64]) -> Matrix4 {
    let mut p = [[0.0; 4]; 4];
    for (j, &number) in numbers.iter().take(10).enumerate() {
        for (a, b, value) in elements(j) {
            p[a][b] += number * value;
        }
    }
    p
}

/// Returns the nonzero elements of ∂P/∂p_j: row, column, value.
fn elements(j: usize) -> impl Iterator<Item = (usize, usize, f64)> {
    let list: [Option<(usize, usize, f64)>; 3] = match j {
        0 => [Some((0, 0, 1.0)), None, None],
        1..=3 => [Some((0, j, 1.0)), Some((j, 0, 1.0)), None],
        4..=6 => [1, 2, 3].map(|k| Some((k, k, if k == j - 3 { -0.5 } else { 0.5 }))),
        _ => {
            let (i, k) = PLACES[j - 4];
            [Some((1 + i, 1 + k, -1.0)), Some((1 + k, 1 + i, -1.0)), None]
        }
    };
    list.into_iter().flatten()
}

/// Returns A_j = L⁻¹ (∂P/∂p_j) L⁻ᵀ as ten elements with the same norm: the diagonal, then √2 times
/// the upper triangle.
fn scaled_element(l: &Matrix4, j: usize) -> [f64; 10] {
    let mut a = [[0.0; 4]; 4];
    for (row, column, value) in elements(j) {
        a[row][column] = value;
    }
    // Multiply by L⁻¹ from the left, then by symmetry from the right.
    for _ in 0..2 {
        for i in 0..4 {
            let above = a;
            for (column, element) in a[i].iter_mut().enumerate() {
                let rest = *element - (0..i).map(|k| l[i][k] * above[k][column]).sum::<f64>();
                *element = rest / l[i][i];
            }
        }
        a = core::array::from_fn(|i| core::array::from_fn(|k| a[k][i]));
    }
    let off = core::f64::consts::SQRT_2;
    [
        a[0][0],
        a[1][1],
        a[2][2],
        a[3][3],
        off * a[0][1],
        off * a[0][2],
        off * a[0][3],
        off * a[1][2],
        off * a[1][3],
        off * a[2][3],
    ]
}
