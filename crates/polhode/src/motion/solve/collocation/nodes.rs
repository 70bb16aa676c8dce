//! Gauss nodes, and polynomials from their values at these nodes.
//!
//! Source: E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, II.7;
//! DLMF 3.5(v), 18.9.

/// Largest number of nodes.
const MOST: usize = 16;

/// Gauss nodes in (0, 1), their weights, and the integrals of each Lagrange polynomial from 0 to
/// each node.
#[derive(Clone, Debug)]
pub(in crate::motion) struct Nodes<const N: usize> {
    pub(in crate::motion) at: [f64; N],
    pub(in crate::motion) weights: [f64; N],
    pub(in crate::motion) integrals: [[f64; N]; N],
}

impl<const N: usize> Nodes<N> {
    pub(in crate::motion) fn new() -> Self {
        const { assert!(N <= MOST) };
        let (mut at, mut weights) = ([0.0; N], [0.0; N]);
        for (k, (node, weight)) in at.iter_mut().zip(&mut weights).enumerate() {
            // Newton's method, started from Tricomi's approximation.
            let mut x = -libm::cos(core::f64::consts::PI * (k as f64 + 0.75) / (N as f64 + 0.5));
            let slope = |x: f64| {
                let p = legendre_values(x);
                N as f64 * (p[N - 1] - x * p[N]) / (1.0 - x * x)
            };
            for _ in 0..8 {
                x -= legendre_values(x)[N] / slope(x);
            }
            *node = 0.5 * (1.0 + x);
            *weight = 1.0 / ((1.0 - x * x) * slope(x) * slope(x));
        }
        let mut nodes = Self { at, weights, integrals: [[0.0; N]; N] };
        nodes.integrals = at.map(|c| nodes.integrals_to(c));
        nodes
    }

    /// Returns ∫₀ᶜ of each Lagrange polynomial.
    pub(super) fn integrals_to(&self, c: f64) -> [f64; N] {
        let here = legendre_integrals(c);
        core::array::from_fn(|k| {
            let there = legendre_values(2.0 * self.at[k] - 1.0);
            let sum: f64 = (0..N).map(|n| (2 * n + 1) as f64 * there[n] * here[n]).sum();
            self.weights[k] * sum
        })
    }

    /// Returns the weights of the values at the nodes in the coefficient of Pₙ(2x − 1).
    pub(super) fn analysis(&self, n: usize) -> [f64; N] {
        core::array::from_fn(|k| {
            (2 * n + 1) as f64 * self.weights[k] * legendre_values(2.0 * self.at[k] - 1.0)[n]
        })
    }

    /// Returns the coefficients of Pₙ(2x − 1) in the polynomial with these values at the nodes.
    pub(in crate::motion) fn legendre(&self, values: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|n| self.analysis(n).iter().zip(values).map(|(t, value)| t * value).sum())
    }
}

/// Returns P₀(x), P₁(x), …, up to degree `MOST` + 1.
pub(super) fn legendre_values(x: f64) -> [f64; MOST + 2] {
    let mut p = [1.0; MOST + 2];
    p[1] = x;
    for n in 1..=MOST {
        let m = n as f64;
        p[n + 1] = ((2.0 * m + 1.0) * x * p[n] - m * p[n - 1]) / (m + 1.0);
    }
    p
}

/// Returns ∫₀ᶜ Pₙ(2x − 1) dx = ½ (Pₙ₊₁ − Pₙ₋₁)/(2n + 1).
pub(super) fn legendre_integrals(c: f64) -> [f64; MOST + 1] {
    let p = legendre_values(2.0 * c - 1.0);
    core::array::from_fn(|n| match n {
        0 => c,
        n => 0.5 * (p[n + 1] - p[n - 1]) / (2 * n + 1) as f64,
    })
}

/// Converts Σ cₙ Pₙ(2x − 1) to powers of x.
pub(in crate::motion) fn monomials<const N: usize>(legendre: &[f64; N]) -> [f64; N] {
    let mut sum = [0.0; N];
    let (mut before, mut now) = ([0.0; N], [0.0; N]);
    now[0] = 1.0;
    for (n, c) in legendre.iter().enumerate() {
        sum.iter_mut().zip(now).for_each(|(sum, p)| *sum += c * p);
        let m = n as f64;
        let mut next = [0.0; N];
        for k in 0..N {
            let shifted = if k > 0 { now[k - 1] } else { 0.0 };
            next[k] = ((2.0 * m + 1.0) * (2.0 * shifted - now[k]) - m * before[k]) / (m + 1.0);
        }
        (before, now) = (now, next);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integrates_polynomials<const N: usize>() {
        let nodes = Nodes::<N>::new();
        let power = |n: i32| nodes.at.map(|x| x.powi(n));
        for n in 0..2 * N as i32 {
            let sum: f64 = power(n).iter().zip(nodes.weights).map(|(x, w)| x * w).sum();
            assert!((sum - 1.0 / f64::from(n + 1)).abs() < 1e-15, "{n}: {sum}");
        }
        for n in 0..N as i32 {
            for (c, row) in nodes.at.iter().zip(nodes.integrals) {
                let sum: f64 = power(n).iter().zip(row).map(|(x, a)| x * a).sum();
                assert!((sum - c.powi(n + 1) / f64::from(n + 1)).abs() < 1e-15, "{n} {c}");
            }
        }
    }

    #[test]
    fn the_nodes_integrate_polynomials() {
        integrates_polynomials::<9>();
        integrates_polynomials::<16>();
    }

    #[test]
    fn polynomials_come_back_by_powers() {
        let nodes = Nodes::<9>::new();
        for n in 0..9 {
            let coefficients = monomials(&nodes.legendre(&nodes.at.map(|x| x.powi(n))));
            for (k, c) in coefficients.iter().enumerate() {
                let want = if k as i32 == n { 1.0 } else { 0.0 };
                assert!((c - want).abs() < 1e-8, "{n} {k} {c}");
            }
        }
    }
}
