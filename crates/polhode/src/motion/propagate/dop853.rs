//! One step of DOP853: the explicit Runge–Kutta method of order 8 by Dormand and Prince, with error estimates of
//! order 5 and 3 and dense output of order 7.
//!
//! Source: Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, §II.5, §II.6 and §II.10.

use super::tableau::{A, ALL_STAGES, C, D, E3, E5, STAGES};

/// A step of a system of N equations, not yet accepted.
pub(super) struct Trial<const N: usize> {
    t: f64,
    h: f64,
    y: [f64; N],
    k: [[f64; N]; ALL_STAGES],
    increment: [f64; N],
}

/// The solution within one step: a polynomial of order 7.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dense<const N: usize> {
    h: f64,
    y: [f64; N],
    coefficients: [[f64; N]; 7],
}

impl<const N: usize> Trial<N> {
    /// Steps from y at t, where the derivative is `k0`, by h.
    pub(super) fn new(
        f: &impl Fn(f64, &[f64; N]) -> [f64; N],
        t: f64,
        y: [f64; N],
        k0: [f64; N],
        h: f64,
    ) -> Self {
        let mut trial = Self { t, h, y, k: [[0.0; N]; ALL_STAGES], increment: [0.0; N] };
        trial.k[0] = k0;
        for s in 1..STAGES {
            trial.stage(f, s);
        }
        trial.increment = trial.weighted(A[STAGES]);
        trial
    }

    /// The derivative at the end of the step; the next step starts with it.
    pub(super) fn finish(&mut self, f: &impl Fn(f64, &[f64; N]) -> [f64; N]) -> [f64; N] {
        self.k[STAGES] = f(self.t + self.h, &self.end());
        self.k[STAGES]
    }

    /// y(t + h).
    pub(super) fn end(&self) -> [f64; N] {
        core::array::from_fn(|i| self.y[i] + self.increment[i])
    }

    /// y(t + h) − y(t), for sums that keep their rounding.
    pub(super) fn increment(&self) -> [f64; N] {
        self.increment
    }

    /// The error estimates of order 5 and 3 of every component.
    pub(super) fn errors(&self) -> ([f64; N], [f64; N]) {
        (self.weighted(&E5), self.weighted(&E3))
    }

    /// The polynomial through the step; call after [`Trial::finish`].
    pub(super) fn dense(&mut self, f: &impl Fn(f64, &[f64; N]) -> [f64; N]) -> Dense<N> {
        for s in STAGES + 1..ALL_STAGES {
            self.stage(f, s);
        }
        let mut coefficients = [[0.0; N]; 7];
        let dy = self.increment;
        for i in 0..N {
            let (f0, f1) = (self.h * self.k[0][i], self.h * self.k[STAGES][i]);
            coefficients[0][i] = dy[i];
            coefficients[1][i] = f0 - dy[i];
            coefficients[2][i] = 2.0 * dy[i] - (f0 + f1);
        }
        for (coefficient, d) in coefficients[3..].iter_mut().zip(&D) {
            *coefficient = self.weighted(d);
        }
        Dense { h: self.h, y: self.y, coefficients }
    }

    fn stage(&mut self, f: &impl Fn(f64, &[f64; N]) -> [f64; N], s: usize) {
        let dy = self.weighted(A[s]);
        let y = core::array::from_fn(|i| self.y[i] + dy[i]);
        self.k[s] = f(self.t + C[s] * self.h, &y);
    }

    /// h Σ w_j k_j
    fn weighted(&self, weights: &[f64]) -> [f64; N] {
        let mut sum = [0.0; N];
        for (w, k) in weights.iter().zip(&self.k) {
            if *w != 0.0 {
                for i in 0..N {
                    sum[i] += w * k[i];
                }
            }
        }
        sum.map(|s| self.h * s)
    }
}

impl<const N: usize> Dense<N> {
    /// y at t + θ h, 0 ≤ θ ≤ 1.
    pub(super) fn at(&self, theta: f64) -> [f64; N] {
        let mut y = [0.0; N];
        for (k, coefficient) in self.coefficients.iter().enumerate().rev() {
            let factor = if k % 2 == 0 { theta } else { 1.0 - theta };
            for i in 0..N {
                y[i] = (y[i] + coefficient[i]) * factor;
            }
        }
        core::array::from_fn(|i| self.y[i] + y[i])
    }

    /// The length of the step.
    pub(super) fn h(&self) -> f64 {
        self.h
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rows_of_the_tableau_are_consistent() {
        for s in 0..ALL_STAGES {
            let sum: f64 = A[s].iter().sum();
            assert!(
                (sum - C[s]).abs() < 2e-15 * A[s].iter().map(|a| a.abs()).sum::<f64>().max(1.0),
                "row {s}"
            );
        }
        // Σ b_j c_j^(q−1) = 1/q up to order 8; the error estimates vanish on low orders
        for q in 1..=8 {
            let moment = |w: &[f64]| w.iter().zip(&C).map(|(w, c)| w * c.powi(q - 1)).sum::<f64>();
            assert!((moment(A[STAGES]) - 1.0 / f64::from(q)).abs() < 2e-15, "order {q}");
            let (e5, e3) = (moment(&E5).abs(), moment(&E3).abs());
            assert!(if q <= 5 { e5 < 1e-14 } else { e5 > 1e-6 }, "E5 order {q}: {e5:e}");
            assert!(if q <= 3 { e3 < 1e-14 } else { e3 > 1e-6 }, "E3 order {q}: {e3:e}");
        }
    }

    /// A smooth system with a known solution: y1 = sin t e^{−t/3}, y2 = tanh t.
    fn f(t: f64, y: &[f64; 2]) -> [f64; 2] {
        [-y[0] / 3.0 + t.cos() * (-t / 3.0).exp(), 1.0 - y[1] * y[1]]
    }

    fn exact(t: f64) -> [f64; 2] {
        [t.sin() * (-t / 3.0).exp(), t.tanh()]
    }

    /// Largest error at the end of, and within, one step of length h from t = 0.3.
    fn one_step(h: f64) -> (f64, f64) {
        let (t, y) = (0.3, exact(0.3));
        let mut trial = Trial::new(&f, t, y, f(t, &y), h);
        trial.finish(&f);
        let error = |y: [f64; 2], t: f64| (y[0] - exact(t)[0]).abs().max((y[1] - exact(t)[1]).abs());
        let end = error(trial.end(), t + h);
        let dense = trial.dense(&f);
        let within = (0..=20).map(|k| error(dense.at(f64::from(k) / 20.0), t + h * f64::from(k) / 20.0));
        (end, within.fold(0.0, f64::max))
    }

    #[test]
    fn a_step_has_order_eight_and_its_dense_output_order_seven() {
        let ((end1, dense1), (end2, dense2)) = (one_step(0.8), one_step(0.4));
        // local errors: h⁹ and h⁸
        let (order_end, order_dense) = ((end1 / end2).log2(), (dense1 / dense2).log2());
        assert!((8.4..9.8).contains(&order_end), "{order_end} {end1:e} {end2:e}");
        assert!((7.4..8.8).contains(&order_dense), "{order_dense} {dense1:e} {dense2:e}");
        assert!(one_step(0.05).1 < 1e-14);
    }
}
