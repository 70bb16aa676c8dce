//! One step of DOP853: the explicit Runge–Kutta method of order 8 by Dormand and Prince, with error
//! estimates of order 5 and 3.
//!
//! Source: Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, §II.5 and §II.10.
//! Their dense output, a polynomial of order 7 from three more stages, is not used. Instead a
//! shorter [`step`] from the same start gives order 8 (see `stepper`).

use super::tableau::{A, B, C, E3, E5};

pub(super) use super::tableau::STAGES;

/// Derivatives at the stages of a step.
#[derive(Debug)]
pub(super) struct Stages<const N: usize> {
    h: f64,
    k: [[f64; N]; STAGES],
}

/// Computes a step by h from y at t. `k0`: derivative there.
pub(super) fn step<const N: usize>(
    f: &impl Fn(f64, &[f64; N]) -> [f64; N],
    t: f64,
    y: &[f64; N],
    k0: &[f64; N],
    h: f64,
) -> Stages<N> {
    let mut stages = Stages::begin(k0, h);
    for s in 1..STAGES {
        let (t, y) = stages.place(s, t, y);
        stages.k[s] = f(t, &y);
    }
    stages
}

impl<const N: usize> Stages<N> {
    /// Creates the stages of a step by h, with the first derivative known.
    pub(super) fn begin(k0: &[f64; N], h: f64) -> Self {
        let mut stages = Self { h, k: [[0.0; N]; STAGES] };
        stages.k[0] = *k0;
        stages
    }

    /// Returns time and variables at which the derivative of stage s is needed, for a step from y
    /// at t. The previous stages must be known.
    pub(super) fn place(&self, s: usize, t: f64, y: &[f64; N]) -> (f64, [f64; N]) {
        let dy = self.weighted(A[s]);
        (t + C[s] * self.h, core::array::from_fn(|i| y[i] + dy[i]))
    }

    /// Sets the derivative of stage s.
    pub(super) fn set(&mut self, s: usize, k: [f64; N]) {
        self.k[s] = k;
    }

    /// Returns y(t + h) − y(t).
    pub(super) fn increment(&self) -> [f64; N] {
        self.weighted(&B)
    }

    /// Returns the error estimates of order 5 and 3 of every component.
    pub(super) fn errors(&self) -> ([f64; N], [f64; N]) {
        (self.weighted(&E5), self.weighted(&E3))
    }

    /// Returns h Σ w_j k_j.
    #[inline]
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tableau_satisfies_order_conditions() {
        for s in 0..STAGES {
            let sum: f64 = A[s].iter().sum();
            assert!(
                (sum - C[s]).abs() < 2e-15 * A[s].iter().map(|a| a.abs()).sum::<f64>().max(1.0),
                "row {s}"
            );
        }
        // Σ b_j c_j^(q−1) = 1/q up to order 8; the error estimates vanish at low orders
        for q in 1..=8 {
            let moment = |w: &[f64]| w.iter().zip(&C).map(|(w, c)| w * c.powi(q - 1)).sum::<f64>();
            assert!((moment(&B) - 1.0 / f64::from(q)).abs() < 2e-15, "order {q}");
            let (e5, e3) = (moment(&E5).abs(), moment(&E3).abs());
            assert!(if q <= 5 { e5 < 1e-14 } else { e5 > 1e-6 }, "E5 order {q}: {e5:e}");
            assert!(if q <= 3 { e3 < 1e-14 } else { e3 > 1e-6 }, "E3 order {q}: {e3:e}");
        }
    }

    /// Smooth system with a known solution: y1 = sin t e^{−t/3}, y2 = tanh t.
    fn f(t: f64, y: &[f64; 2]) -> [f64; 2] {
        [-y[0] / 3.0 + t.cos() * (-t / 3.0).exp(), 1.0 - y[1] * y[1]]
    }

    fn exact(t: f64) -> [f64; 2] {
        [t.sin() * (-t / 3.0).exp(), t.tanh()]
    }

    /// Returns the error of one step of length h from t = 0.3.
    fn one_step(h: f64) -> f64 {
        let (t, y) = (0.3, exact(0.3));
        let dy = step(&f, t, &y, &f(t, &y), h).increment();
        (0..2).map(|i| (y[i] + dy[i] - exact(t + h)[i]).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn a_step_has_order_eight() {
        // local errors: h⁹
        let (e1, e2) = (one_step(0.8), one_step(0.4));
        assert!((8.4..9.8).contains(&(e1 / e2).log2()), "{e1:e} {e2:e}");
        assert!(one_step(0.05) < 2e-16);
    }
}
