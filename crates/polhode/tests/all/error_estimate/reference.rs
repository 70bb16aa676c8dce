//! True motions: equations of motion with quadratic right-hand sides, by Taylor's method of order
//! 30 in double-double arithmetic.
//!
//! Nothing is shared with the library: the equations are stated along body axes, with the full
//! tensor about the centre of mass or the pivot.

use std::collections::BTreeMap;

use super::double::Double;

const ORDER: usize = 30;

/// Error of a step, relative to the largest variable of its kind.
const REMAINDER: f64 = 1e-27;

/// Polynomial of degree two: coefficients of products of two variables; variable 0 is the number 1.
#[derive(Clone, Debug, Default)]
pub(super) struct Polynomial(BTreeMap<[usize; 2], Double>);

impl Polynomial {
    pub(super) fn constant(x: Double) -> Self {
        Self([([0, 0], x)].into())
    }

    /// Returns a variable.
    pub(super) fn variable(k: usize) -> Self {
        Self([([0, k], Double::of(1.0))].into())
    }

    pub(super) fn plus(mut self, other: &Self) -> Self {
        for (&product, &factor) in &other.0 {
            let sum = self.0.entry(product).or_insert(Double::ZERO);
            *sum = *sum + factor;
        }
        self
    }

    pub(super) fn times(&self, by: Double) -> Self {
        Self(self.0.iter().map(|(&product, &factor)| (product, factor * by)).collect())
    }

    /// Returns the product of two linear polynomials.
    pub(super) fn product(&self, other: &Self) -> Self {
        let mut all = Self::default();
        for ([_, j], a) in &self.0 {
            for ([_, k], b) in &other.0 {
                all = all.plus(&Self([([*j.min(k), *j.max(k)], *a * *b)].into()));
            }
        }
        all
    }
}

pub(super) type Polynomials = [Polynomial; 3];

pub(super) fn variables(first: usize) -> Polynomials {
    std::array::from_fn(|k| Polynomial::variable(first + k))
}

pub(super) fn sum(a: &Polynomials, b: &Polynomials) -> Polynomials {
    std::array::from_fn(|k| a[k].clone().plus(&b[k]))
}

pub(super) fn scaled(a: &Polynomials, by: Double) -> Polynomials {
    std::array::from_fn(|k| a[k].times(by))
}

pub(super) fn cross(a: &Polynomials, b: &Polynomials) -> Polynomials {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i].product(&b[j]).plus(&a[j].product(&b[i]).times(Double::of(-1.0)))
    })
}

pub(super) fn image(matrix: &[[Double; 3]; 3], a: &Polynomials) -> Polynomials {
    std::array::from_fn(|i| (0..3).fold(Polynomial::default(), |sum, k| sum.plus(&a[k].times(matrix[i][k]))))
}

/// ẏ as polynomials of y, with y₀ = 1.
pub(super) struct System {
    products: Vec<[usize; 2]>,
    /// Products in the rate of each variable from 1 on, and their coefficients.
    rates: Vec<Vec<(usize, Double)>>,
}

impl System {
    pub(super) fn new(rates: &[Polynomial]) -> Self {
        let mut products: Vec<[usize; 2]> = rates.iter().flat_map(|rate| rate.0.keys().copied()).collect();
        products.sort_unstable();
        products.dedup();
        let place = |product: &[usize; 2]| products.binary_search(product).unwrap();
        let rates = rates
            .iter()
            .map(|rate| rate.0.iter().map(|(product, factor)| (place(product), *factor)).collect())
            .collect();
        Self { products, rates }
    }

    /// Advances y from one time to another.
    pub(super) fn advance(&self, y: &mut [Double], from: f64, to: f64) {
        let end = Double::of(to) - Double::of(from);
        let mut done = Double::ZERO;
        while done != end {
            let series = self.series(y);
            let rest = end - done;
            let allowed = Double::of(step(&series));
            let h = if allowed.0 < rest.0 { allowed } else { rest };
            for (y, series) in y.iter_mut().skip(1).zip(&series) {
                *y = series.iter().rev().fold(Double::ZERO, |sum, c| sum * h + *c);
            }
            done = if allowed.0 < rest.0 { done + h } else { end };
        }
    }

    /// Returns the series of each variable from 1 on.
    fn series(&self, y: &[Double]) -> Vec<[Double; ORDER + 1]> {
        let mut series = vec![[Double::ZERO; ORDER + 1]; y.len() - 1];
        for (series, y) in series.iter_mut().zip(&y[1..]) {
            series[0] = *y;
        }
        for n in 0..ORDER {
            let value = |[j, k]: [usize; 2]| match (j, k) {
                (0, 0) => {
                    if n == 0 {
                        Double::of(1.0)
                    } else {
                        Double::ZERO
                    }
                }
                (0, k) => series[k - 1][n],
                (j, k) => (0..=n).fold(Double::ZERO, |sum, m| sum + series[j - 1][m] * series[k - 1][n - m]),
            };
            let products: Vec<Double> = self.products.iter().map(|product| value(*product)).collect();
            let over = Double::of(1.0) / Double::of((n + 1) as f64);
            for (series, rate) in series.iter_mut().zip(&self.rates) {
                let sum = rate.iter().fold(Double::ZERO, |sum, (k, factor)| sum + products[*k] * *factor);
                series[n + 1] = sum * over;
            }
        }
        series
    }
}

/// Returns the step at which the last two terms meet the tolerance. They are relative to the
/// largest variable of each group: ω, the quaternion, and vectors.
fn step(series: &[[Double; ORDER + 1]]) -> f64 {
    let mut step = f64::INFINITY;
    let [omega, others] = [&series[..3], &series[3..]];
    for group in [omega].into_iter().chain([&others[..4]]).chain(others[4..].chunks(3)) {
        let size = |n: usize| group.iter().fold(0.0, |size: f64, series| size.max(series[n].0.abs()));
        for n in [ORDER - 1, ORDER] {
            if size(n) > 0.0 && size(0) > 0.0 {
                step = step.min((REMAINDER * size(0) / size(n)).powf(1.0 / n as f64));
            }
        }
    }
    0.8 * step
}
