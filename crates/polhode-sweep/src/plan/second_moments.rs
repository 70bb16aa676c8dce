//! Dispersed mass properties, every one of them possible.
//!
//! A tensor is possible if and only if its second moments Σ = ∫ x xᵀ dm = ½ tr(I) 1 − I have no negative eigenvalue. With a
//! root S of Σ (S Sᵀ = Σ), and a matrix E of independent normal numbers of standard deviation s,
//!
//! Σ' = S (1 + E) (1 + E)ᵀ Sᵀ / y,  y = 1 + n s²  (1)
//!
//! has none either, whatever E is. Since E[(1 + E)(1 + E)ᵀ] = y 1, its mean is Σ. The diagonal elements of (1 + E)(1 + E)ᵀ have the
//! variance 4 s² + 2 n s⁴, so that along every axis that Σ allows a second moment has the relative standard deviation
//!
//! d = √(4 s² + 2 n s⁴) / y,  hence  y = 1 / √(1 − n d²/2)  (2)
//!
//! E has no axes of its own (Q E Qᵀ is distributed as E), so that a body that is turned has the turned distribution. n is 3, or 4
//! where mass and centre of mass are dispersed with the tensor: then (1) is done to the pseudo-inertia about the centre of mass,
//! J = ∫ (x, 1)(x, 1)ᵀ dm, whose last row has the first moments and the mass.

use polhode::{Body, MassProperties, PrincipalFrame};

use super::normal;
use polhode_formats::scenario::Dispersion;

/// A row or a column of E.
type Row<const N: usize> = [f64; N];

/// Mass, centre of mass, and xx, yy, zz, xy, xz, yz of the tensor about it.
pub(crate) struct Drawn {
    pub(crate) mass: f64,
    pub(crate) center: [f64; 3],
    pub(crate) tensor: [f64; 6],
}

/// A root of second moments, and what they belong to.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    /// The symmetric root of Σ.
    root: [[f64; 3]; 3],
    mass: f64,
    center: [f64; 3],
}

impl Root {
    /// Of a body.
    pub(crate) fn of(body: &MassProperties<Body>) -> Self {
        let principal = PrincipalFrame::of(body.inertia());
        let moments = principal.moments();
        let half_trace = 0.5 * (moments[0] + moments[1] + moments[2]);
        // S = Σ_k √σ_k n_k n_kᵀ; what rounding leaves below zero is zero.
        let mut root = [[0.0; 3]; 3];
        for (k, moment) in moments.into_iter().enumerate() {
            let (n, size) = (principal.axis(k).to_array(), (half_trace - moment).max(0.0).sqrt());
            for (row, a) in root.iter_mut().zip(n) {
                for (element, b) in row.iter_mut().zip(n) {
                    *element += size * a * b;
                }
            }
        }
        Self { root, mass: body.mass(), center: body.center_of_mass().to_array() }
    }

    /// The body of uniform numbers, as many as [`Vary::coordinates`](polhode_formats::scenario::Vary::coordinates) says.
    pub(crate) fn draw(&self, dispersion: Dispersion, uniform: &[f64]) -> Drawn {
        match (dispersion, uniform.len()) {
            (Dispersion::Together(d), 16) => self.together(d, uniform),
            (Dispersion::Together(d), _) => {
                Drawn { mass: self.mass, center: self.center, tensor: self.tensor(d, uniform) }
            }
            (Dispersion::Apart { mass, center_of_mass, inertia }, _) => {
                let mut z = uniform.iter().map(|u| normal::quantile(*u));
                let mut next = || z.next().unwrap_or_default();
                // ln m' is normal, and the mean of m' is m: σ² = ln(1 + d²), median m/√(1 + d²)
                let square = mass * mass;
                let factor = libm::exp(libm::log1p(square).sqrt() * next()) / (1.0 + square).sqrt();
                let center = self.center.map(|c| c + center_of_mass * next());
                let tensor = self.tensor(inertia, uniform.get(4..).unwrap_or_default());
                Drawn { mass: self.mass * if mass > 0.0 { factor } else { 1.0 }, center, tensor }
            }
        }
    }

    /// (1) for a tensor.
    fn tensor(&self, d: f64, uniform: &[f64]) -> [f64; 6] {
        let (spread, y) = spread::<3>(d, uniform);
        inertia(&product(&self.root, &spread), y)
    }

    /// (1) for mass, first moments and second moments.
    fn together(&self, d: f64, uniform: &[f64]) -> Drawn {
        let (spread, y) = spread::<4>(d, uniform);
        let [a, b, c, last] = spread;
        // P (1 + E) with P = diag(S, √m): the last row has the mass, the others the second moments.
        let last = last.map(|element| self.mass.sqrt() * element);
        let rows = product(&self.root, &[a, b, c]);
        let square = dot(&last, &last);
        // h = Σ_k P_ik P_4k, m' = |P_4|²; about the new centre of mass what is along P_4 is gone.
        let along = rows.map(|row| dot(&row, &last) / square);
        let mut across = rows;
        for (row, share) in across.iter_mut().zip(along) {
            for (element, other) in row.iter_mut().zip(last) {
                *element -= share * other;
            }
        }
        let mut center = self.center;
        center.iter_mut().zip(along).for_each(|(c, share)| *c += share);
        Drawn { mass: square / y, center, tensor: inertia(&across, y) }
    }
}

/// 1 + E, and y, by (2).
fn spread<const N: usize>(d: f64, uniform: &[f64]) -> ([Row<N>; N], f64) {
    let n = N as f64;
    let y = 1.0 / (1.0 - 0.5 * n * d * d).sqrt();
    let s = ((y - 1.0) / n).sqrt();
    let mut spread = [[0.0; N]; N];
    let mut numbers = uniform.iter();
    for (i, row) in spread.iter_mut().enumerate() {
        for (j, element) in row.iter_mut().enumerate() {
            let z = numbers.next().map_or(0.0, |u| normal::quantile(*u));
            *element = s * z + if i == j { 1.0 } else { 0.0 };
        }
    }
    (spread, y)
}

/// S M of a symmetric S and three rows M.
fn product<const N: usize>(s: &[[f64; 3]; 3], m: &[Row<N>; 3]) -> [Row<N>; 3] {
    s.map(|[a, b, c]| {
        let mut row = [0.0; N];
        for (k, element) in row.iter_mut().enumerate() {
            *element = a * m[0][k] + b * m[1][k] + c * m[2][k];
        }
        row
    })
}

/// I = tr(Σ) 1 − Σ with Σ = B Bᵀ / y: xx, yy, zz, xy, xz, yz.
fn inertia<const N: usize>(b: &[Row<N>; 3], y: f64) -> [f64; 6] {
    let sigma = |i: usize, j: usize| dot(&b[i], &b[j]) / y;
    let [xx, yy, zz] = [sigma(0, 0), sigma(1, 1), sigma(2, 2)];
    [yy + zz, xx + zz, xx + yy, 0.0 - sigma(0, 1), 0.0 - sigma(0, 2), 0.0 - sigma(1, 2)]
}

fn dot<const N: usize>(a: &Row<N>, b: &Row<N>) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}
