//! Quadratic functions on a disc and its rim.

use super::interval::Interval;

/// A quadratic function on a chart: q + g·u + uᵀ Q u, with Q₁₁, Q₁₂, Q₂₂.
pub(super) struct Planar {
    pub(super) constant: Interval,
    pub(super) slope: [Interval; 2],
    pub(super) square: [Interval; 3],
}

/// Where a function on a chart is least, and λ: f(u) + λ (u² − 1) has its least value there.
pub(super) struct Least {
    pub(super) at: [f64; 2],
    multiplier: f64,
}

impl Planar {
    /// The least value on the disc or the rim: (Q + λ) u = −½ g (Moré and Sorensen, SIAM J. Sci. Stat. Comput. 4, 1983, 553).
    pub(super) fn least(&self, rim: bool) -> Least {
        let [a, b, c] = self.square.map(Interval::middle);
        let g = self.slope.map(Interval::middle);
        let (mean, half) = (0.5 * (a + c), 0.5 * (a - c));
        let radius = half.hypot(b);
        // The eigenvector of the lesser eigenvalue.
        let angle = 0.5 * libm::atan2(-b, -half);
        let (sin, cos) = libm::sincos(angle);
        let low = mean - radius;
        let along = [cos * g[0] + sin * g[1], -sin * g[0] + cos * g[1]];
        let back = |u: [f64; 2]| [cos * u[0] - sin * u[1], sin * u[0] + cos * u[1]];
        // With λ = σ − low: u = −½ (g₁/σ, g₂/(high − low + σ)).
        let at = |sigma: f64| {
            let by = |g: f64, d: f64| if g == 0.0 { 0.0 } else { -0.5 * g / d };
            [by(along[0], sigma), by(along[1], 2.0 * radius + sigma)]
        };
        let norm = |sigma: f64| {
            let [s, t] = at(sigma);
            s.hypot(t)
        };
        if !rim && low > 0.0 && norm(low) <= 1.0 {
            return Least { at: back(at(low)), multiplier: 0.0 };
        }
        let mut most = 0.5 * along[0].hypot(along[1]).max(f64::MIN_POSITIVE);
        let mut least = if rim { 0.0 } else { low.max(0.0) };
        // Where every λ leaves u inside, g has no part along the eigenvector: u is filled up along it.
        while most > least {
            let sigma = 0.5 * (least + most);
            if sigma <= least || sigma >= most {
                break;
            }
            if norm(sigma) > 1.0 { least = sigma } else { most = sigma }
        }
        let mut u = at(most);
        let short = 1.0 - u[0] * u[0] - u[1] * u[1];
        if short > 0.0 {
            u[0] = (1.0 - u[1] * u[1]).max(0.0).sqrt().copysign(u[0]);
        }
        let norm = u[0].hypot(u[1]);
        let factor = if norm > 1.0 || rim { 1.0 / norm } else { 1.0 };
        Least { at: back(u.map(|u| u * factor)), multiplier: most - low }
    }

    /// A step of Newton's method to a least value on the disc, the rim, or a line of the disc; `None` where there is none near.
    pub(super) fn nearer(&self, u: [f64; 2], rim: bool, is_line: bool) -> Option<[f64; 2]> {
        let [a, b, c] = self.square.map(Interval::middle);
        let [g, h] = self.slope.map(Interval::middle);
        let [s, t] = u;
        let gradient = [g + 2.0 * (a * s + b * t), h + 2.0 * (b * s + c * t)];
        let (out, norm) = (s * gradient[0] + t * gradient[1], s.hypot(t));
        let determinant = a * c - b * b;
        if is_line {
            return (a > 0.0 && !rim).then(|| [(-0.5 * g / a).clamp(-1.0, 1.0), 0.0]);
        }
        if !rim && a > 0.0 && determinant > 0.0 {
            let inside = [0.5 * (b * h - c * g) / determinant, 0.5 * (b * g - a * h) / determinant];
            if inside[0].hypot(inside[1]) <= 1.0 {
                return Some(inside);
            }
        }
        // Along the rim: f″ = 2 eᵀ Q e − u·∇f
        if !(norm > 0.9) || (!rim && out > 0.0) {
            return None;
        }
        let [x, y] = [-t / norm, s / norm];
        let (first, second) =
            (x * gradient[0] + y * gradient[1], 2.0 * (a * x * x + 2.0 * b * x * y + c * y * y) - out / norm);
        let turn = -first / second;
        (second > 0.0 && turn.abs() < 0.5).then(|| {
            let (sin, cos) = libm::sincos(turn);
            [(cos * s - sin * t) / norm, (sin * s + cos * t) / norm]
        })
    }

    /// A lower bound: h(u) = f(u) + λ (u² − 1) is nowhere above f on the disc if λ ≥ 0, and is f on the rim. Where Q + λ has no negative eigenvalue, h is nowhere below its tangent plane.
    pub(super) fn bound(&self, least: &Least, rim: bool) -> f64 {
        let terms = self.square.iter().chain(&self.slope);
        let size = terms.fold(f64::MIN_POSITIVE / f64::EPSILON, |most: f64, q| most.max(q.size()));
        let mut lambda = if rim { least.multiplier } else { least.multiplier.max(0.0) };
        let mut step = size * f64::EPSILON;
        let q = loop {
            let more = Interval::from(lambda);
            let q = [self.square[0] + more, self.square[1], self.square[2] + more];
            let determinant = q[0] * q[2] - q[1].square();
            if (q[0].low >= 0.0 && q[2].low >= 0.0 && determinant.low >= 0.0) || !lambda.is_finite() {
                break q;
            }
            lambda += step;
            step *= 2.0;
        };
        let [s, t] = least.at.map(Interval::from);
        let two = Interval::from(2.0);
        let value = self.constant - Interval::from(lambda)
            + self.slope[0] * s
            + self.slope[1] * t
            + q[0] * s.square()
            + two * q[1] * s * t
            + q[2] * t.square();
        let gradient =
            [self.slope[0] + two * (q[0] * s + q[1] * t), self.slope[1] + two * (q[1] * s + q[2] * t)];
        let steep = (gradient[0].square() + gradient[1].square()).sqrt();
        let far = Interval::ONE + (s.square() + t.square()).sqrt();
        let bound = (value - Interval::from((steep * far).high)).low;
        if bound.is_nan() { f64::NEG_INFINITY } else { bound }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn planar(constant: f64, slope: [f64; 2], square: [f64; 3]) -> Planar {
        Planar {
            constant: constant.into(),
            slope: slope.map(Interval::from),
            square: square.map(Interval::from),
        }
    }

    #[test]
    fn least_values_are_those_of_a_fine_grid() {
        let cases = [
            ([0.3, -0.2], [1.0, 0.4, 2.0]),
            ([3.0, -0.2], [1.0, 0.4, 2.0]),
            ([0.3, -0.2], [-1.0, 0.7, 0.5]),
            ([0.0, 0.0], [-1.0, 0.7, 0.5]),
            ([0.0, 0.3], [-1.0, 0.0, 0.5]),
            ([1e-9, 0.3], [-1.0, 0.0, 0.5]),
            ([0.4, 0.1], [0.0, 0.0, 0.0]),
            ([0.4, 0.0], [0.7, 0.0, 0.0]),
            ([0.4, 0.0], [-0.7, 0.0, 0.0]),
            ([0.0, 0.0], [0.0, 0.0, 0.0]),
            ([0.2, 0.3], [-2.0, 0.0, -2.0]),
            ([0.2, 0.3], [2.0, 0.0, 2.0]),
        ];
        for (slope, square) in cases {
            for rim in [false, true] {
                let f = planar(0.7, slope, square);
                let value = |s: f64, t: f64| {
                    0.7 + slope[0] * s
                        + slope[1] * t
                        + square[0] * s * s
                        + 2.0 * square[1] * s * t
                        + square[2] * t * t
                };
                let mut grid = f64::INFINITY;
                for k in 0..2000 {
                    let (sin, cos) = (core::f64::consts::TAU * f64::from(k) / 2000.0).sin_cos();
                    for radius in if rim { 100..=100 } else { 0..=100 } {
                        let radius = f64::from(radius) / 100.0;
                        grid = grid.min(value(radius * cos, radius * sin));
                    }
                }
                let least = f.least(rim);
                let [s, t] = least.at;
                assert!(s.hypot(t) <= 1.0 + 1e-15 && (!rim || s.hypot(t) > 1.0 - 1e-15));
                let (found, bound) = (value(s, t), f.bound(&least, rim));
                assert!(
                    found <= grid + 1e-14 && found > grid - 1e-3,
                    "{slope:?} {square:?} {rim}: {found} {grid}"
                );
                assert!(
                    bound <= found && bound > found - 1e-12,
                    "{slope:?} {square:?} {rim}: {found} {bound}"
                );
            }
        }
    }
}
