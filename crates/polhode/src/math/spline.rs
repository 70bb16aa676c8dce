//! Interpolating splines: smooth curves with exact derivatives.
//!
//! A spline of odd degree p is a polynomial of degree p between the times and has p − 1 continuous
//! derivatives. It is a sum of B-splines. The knots are the times without the (p + 1)/2 at either
//! end, so that the first and the last few pieces form one polynomial ("not a knot"). No derivative
//! at the ends has to be assumed, and the order of accuracy p + 1 holds up to the ends.
//!
//! # Source
//! C. de Boor, A Practical Guide to Splines, chapters IX (B-splines), X (derivatives) and XIII
//! (interpolation).

/// Curve of N components through points at given times.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Spline<const N: usize> {
    degree: usize,
    knots: Vec<f64>,
    coefficients: Vec<[f64; N]>,
}

/// Highest supported degree.
const MOST: usize = 7;

impl<const N: usize> Spline<N> {
    /// Returns the spline of the largest odd degree up to `degree` (≤ 7) for which there are enough
    /// points; `None` for fewer than two points, or times that are not ascending.
    pub(crate) fn through(times: &[f64], values: &[[f64; N]], degree: usize) -> Option<Self> {
        let count = times.len();
        let ascending = times.windows(2).all(|pair| pair[0] < pair[1]) && times.iter().all(|t| t.is_finite());
        if count < 2 || values.len() != count || !ascending {
            return None;
        }
        let most = degree.min(MOST).min(count - 1);
        let degree = if most.is_multiple_of(2) { most - 1 } else { most };
        let half = degree.div_ceil(2);
        let (first, last) = (times[0], times[count - 1]);
        let mut knots = vec![first; degree + 1];
        knots.extend(&times[half..count - half]);
        knots.extend(vec![last; degree + 1]);
        let mut spline = Self { degree, knots, coefficients: vec![[0.0; N]; count] };
        spline.coefficients = spline.solve(times, values);
        Some(spline)
    }

    /// Returns the value and its first and second derivative at a time; beyond the ends, the
    /// outermost polynomials are continued.
    pub(crate) fn at(&self, time: f64) -> [[f64; N]; 3] {
        let mut result = [[0.0; N]; 3];
        let (p, span) = (self.degree, self.span(time));
        // Local coefficients, then those of the derivatives: c′ᵢ = p (cᵢ₊₁ − cᵢ)/(uᵢ₊ₚ₊₁ − uᵢ₊₁).
        let mut local = [[0.0; N]; MOST + 1];
        local[..=p].copy_from_slice(&self.coefficients[span - p..=span]);
        for (order, slot) in result.iter_mut().enumerate().take(p + 1) {
            let degree = p - order;
            *slot = self.blended(local, degree, span, time);
            for j in 0..degree {
                let width = self.knots[span + 1 + j] - self.knots[span + 1 + j - degree];
                let factor = degree as f64 / width;
                local[j] = core::array::from_fn(|k| factor * (local[j + 1][k] - local[j][k]));
            }
        }
        result
    }

    /// Returns the value of the spline of `degree` with the coefficients `local`, by de Boor's
    /// recurrence.
    fn blended(&self, mut local: [[f64; N]; MOST + 1], degree: usize, span: usize, time: f64) -> [f64; N] {
        for r in 1..=degree {
            for j in (r..=degree).rev() {
                let (low, high) = (self.knots[span + j - degree], self.knots[span + 1 + j - r]);
                let right = (time - low) / (high - low);
                local[j] =
                    core::array::from_fn(|k| local[j - 1][k] + right * (local[j][k] - local[j - 1][k]));
            }
        }
        local[degree]
    }

    /// Returns the index of the last knot that is not after a time, excluding the repeated knots at
    /// the end.
    fn span(&self, time: f64) -> usize {
        let last = self.coefficients.len() - 1;
        self.knots.partition_point(|knot| *knot <= time).saturating_sub(1).clamp(self.degree, last)
    }

    /// Returns the p + 1 B-splines that are nonzero in a span, at a time in it.
    fn basis(&self, span: usize, time: f64) -> [f64; MOST + 1] {
        let mut basis = [0.0; MOST + 1];
        basis[0] = 1.0;
        for r in 1..=self.degree {
            let mut saved = 0.0;
            for (j, value) in basis.iter_mut().enumerate().take(r) {
                let (left, right) = (self.knots[span + 1 + j - r], self.knots[span + 1 + j]);
                let share = *value / (right - left);
                *value = saved + (right - time) * share;
                saved = (time - left) * share;
            }
            basis[r] = saved;
        }
        basis
    }

    /// Returns the coefficients with which the spline passes through the points.
    ///
    /// The matrix of B-splines at the times is banded and totally positive, so elimination without
    /// pivoting is stable (de Boor, chapter XIII).
    fn solve(&self, times: &[f64], values: &[[f64; N]]) -> Vec<[f64; N]> {
        let (p, count) = (self.degree, times.len());
        let width = 2 * p + 1;
        // Row i holds columns i − p … i + p.
        let mut band = vec![0.0; count * width];
        for (i, &time) in times.iter().enumerate() {
            let span = self.span(time);
            for (k, b) in self.basis(span, time).into_iter().enumerate().take(p + 1) {
                if let Some(column) = (span + k).checked_sub(i).filter(|column| *column < width) {
                    band[i * width + column] = b;
                }
            }
        }
        let mut rows = values.to_vec();
        for i in 0..count {
            for below in i + 1..(i + p + 1).min(count) {
                let factor = band[below * width + i + p - below] / band[i * width + p];
                if factor == 0.0 {
                    continue;
                }
                for column in i..(i + p + 1).min(count) {
                    band[below * width + column + p - below] -= factor * band[i * width + column + p - i];
                }
                rows[below] = core::array::from_fn(|k| rows[below][k] - factor * rows[i][k]);
            }
        }
        for i in (0..count).rev() {
            for right in i + 1..(i + p + 1).min(count) {
                let factor = band[i * width + right + p - i];
                rows[i] = core::array::from_fn(|k| rows[i][k] - factor * rows[right][k]);
            }
            let pivot = band[i * width + p];
            rows[i] = rows[i].map(|x| x / pivot);
        }
        rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns times that are not evenly spaced.
    fn times(count: usize) -> Vec<f64> {
        let even = |k: usize| 2.0 * k as f64 / (count - 1) as f64;
        (0..count).map(|k| even(k) + 0.05 * libm::sin(3.0 * even(k))).collect()
    }

    #[test]
    fn polynomials_of_its_degree_are_kept() {
        for degree in [3, 5, 7] {
            let p = |t: f64| (0..=degree).rev().fold(0.0, |sum, k| sum * t + 0.3 + 0.7 * (k as f64 - 2.2));
            let times = times(23);
            let values: Vec<_> = times.iter().map(|t| [p(*t), 1.0 - p(*t)]).collect();
            let spline = Spline::through(&times, &values, degree).unwrap();
            let (h, t) = (1e-4, 1.234_5);
            let [[value, other], [first, _], [second, _]] = spline.at(t);
            assert!(
                (value - p(t)).abs() < 1e-12 * p(t).abs() && (other - 1.0 + p(t)).abs() < 1e-12 * p(t).abs()
            );
            assert!((first - (p(t + h) - p(t - h)) / (2.0 * h)).abs() < 1e-5 * first.abs());
            assert!((second - (p(t + h) - 2.0 * p(t) + p(t - h)) / (h * h)).abs() < 1e-5 * second.abs());
            // The outermost polynomials are continued.
            assert!((spline.at(-0.1)[0][0] - p(-0.1)).abs() < 1e-10);
        }
    }

    #[test]
    fn it_goes_through_its_points_and_converges_with_its_order() {
        let f = |t: f64| libm::sin(2.0 * t + 0.4) * libm::exp(-0.3 * t);
        let second = |t: f64| {
            let (s, c) = libm::sincos(2.0 * t + 0.4);
            libm::exp(-0.3 * t) * ((0.09 - 4.0) * s - 1.2 * c)
        };
        for degree in [3, 5, 7] {
            let error = |count: usize| {
                let times = times(count);
                let values: Vec<_> = times.iter().map(|t| [f(*t)]).collect();
                let spline = Spline::through(&times, &values, degree).unwrap();
                for t in &times {
                    assert!((spline.at(*t)[0][0] - f(*t)).abs() < 1e-14);
                }
                let at = |k: i32| (f64::from(k) + 0.5) / 200.0;
                let [mut value, mut rate] = [0.0_f64; 2];
                for t in (0..400).map(at) {
                    let [[x], _, [xx]] = spline.at(t);
                    (value, rate) = (value.max((x - f(t)).abs()), rate.max((xx - second(t)).abs()));
                }
                [value, rate]
            };
            let ([coarse, coarse_rate], [fine, fine_rate]) = (error(21), error(41));
            // Order p + 1 of the value and p − 1 of the second derivative, except for larger
            // constants at the ends.
            let order = |a: f64, b: f64| libm::log2(a / b);
            assert!(order(coarse, fine) > degree as f64, "{degree}: {coarse:e} {fine:e}");
            assert!(
                order(coarse_rate, fine_rate) > degree as f64 - 1.5,
                "{degree}: {coarse_rate:e} {fine_rate:e}"
            );
        }
    }

    #[test]
    fn few_points_have_a_low_degree_and_wrong_ones_none() {
        let line = Spline::through(&[1.0, 3.0], &[[2.0], [6.0]], 7).unwrap();
        assert_eq!(line.at(2.0), [[4.0], [2.0], [0.0]]);
        assert_eq!(Spline::through(&[0.0, 1.0, 2.0, 4.0, 5.0], &[[0.0]; 5], 7).unwrap().degree, 3);
        assert!(Spline::through(&[1.0], &[[2.0]], 7).is_none());
        assert!(Spline::through(&[1.0, 1.0], &[[2.0], [3.0]], 7).is_none());
        assert!(Spline::through(&[1.0, f64::NAN], &[[2.0], [3.0]], 7).is_none());
    }
}
