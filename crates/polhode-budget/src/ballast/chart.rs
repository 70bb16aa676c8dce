//! Points of a site, and functions of the moments on it.

use polhode::math::{Body, Position};

use super::error::BallastError;
use super::row::{Functional, Vector, weights};
use super::site::{Place, Round, Site};

/// Coordinates on a site.
pub(super) type At = [f64; 2];

/// Points r = center + s e₁ + t e₂ with s² + t² ≤ 1, or = 1 on a circle.
///
/// A line has e₂ = 0, a point also e₁ = 0.
#[derive(Clone, Debug)]
pub(super) struct Chart {
    center: Vector,
    /// Centre of the chart, from the origin of the problem, m.
    offset: Vector,
    axes: [Vector; 2],
    is_rim: bool,
}

/// Quadratic function on a chart, for a unit mass: q + g·u + uᵀ Q u, with Q₁₁, Q₁₂, Q₂₂.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadratic {
    constant: f64,
    slope: [f64; 2],
    square: [f64; 3],
}

impl Chart {
    pub(super) fn new(site: &Site, origin: Vector) -> Result<Self, BallastError> {
        let wrong =
            |what, value, rule| BallastError::Value { site: Some(site.name.clone()), what, value, rule };
        let finite = |at: Position<Body>| match at.to_array().into_iter().find(|x| !x.is_finite()) {
            None => Ok(at.to_array()),
            Some(value) => Err(wrong("the position", value, "finite")),
        };
        let round = |round: &Round| {
            let n = round.normal.direction();
            let n = n.ok_or_else(|| {
                wrong("the length of the normal", round.normal.norm(), "finite and not zero")
            })?;
            if !(round.radius > 0.0 && round.radius.is_finite()) {
                return Err(wrong("the radius", round.radius, "positive and finite"));
            }
            let axes = crate::limit::across_axes(n).map(|u| (u * round.radius).to_array());
            Ok((finite(round.center)?, axes))
        };
        let (center, axes) = match &site.place {
            Place::Point(at) => (finite(*at)?, [[0.0; 3]; 2]),
            Place::Line([a, b]) => {
                let (a, b) = (finite(*a)?, finite(*b)?);
                let half = core::array::from_fn(|k| 0.5 * b[k] - 0.5 * a[k]);
                (core::array::from_fn(|k| 0.5 * a[k] + 0.5 * b[k]), [half, [0.0; 3]])
            }
            Place::Disc(disc) => round(disc)?,
            Place::Circle(circle) => round(circle)?,
        };
        let offset = core::array::from_fn(|k| center[k] - origin[k]);
        Ok(Self { center, offset, axes, is_rim: matches!(site.place, Place::Circle(_)) })
    }

    /// Returns upper bounds on |x|, |y| and |z| on the chart, from the origin of the problem.
    pub(super) fn extent(&self) -> Vector {
        let [a, b] = &self.axes;
        core::array::from_fn(|k| self.offset[k].abs() + a[k].abs() + b[k].abs())
    }

    pub(super) fn is_point(&self) -> bool {
        self.axes == [[0.0; 3]; 2]
    }

    fn is_line(&self) -> bool {
        self.axes[1] == [0.0; 3]
    }

    /// Returns a point in the body.
    pub(super) fn point(&self, [s, t]: At) -> Vector {
        let [a, b] = &self.axes;
        core::array::from_fn(|k| self.center[k] + s * a[k] + t * b[k])
    }

    /// Returns a point from the origin of the problem.
    pub(super) fn local(&self, [s, t]: At) -> Vector {
        let [a, b] = &self.axes;
        core::array::from_fn(|k| self.offset[k] + s * a[k] + t * b[k])
    }

    /// Returns starting points: the ends of a line, or three points on a rim.
    pub(super) fn seeds(&self) -> Vec<At> {
        if self.is_point() {
            vec![[0.0; 2]]
        } else if self.is_line() {
            vec![[1.0, 0.0], [-1.0, 0.0]]
        } else {
            vec![[1.0, 0.0], [-0.5, 0.75_f64.sqrt()], [-0.5, -(0.75_f64.sqrt())]]
        }
    }

    /// Returns the nearest point of the site, in its coordinates.
    pub(super) fn nearest(&self, [s, t]: At) -> At {
        let norm = s.hypot(t);
        if norm > 1.0 || (self.is_rim && norm > 0.0) { [s / norm, t / norm] } else { [s, t] }
    }

    /// Returns the directions in which a point can move, with the least and the greatest distance.
    pub(super) fn directions(&self, [s, t]: At, radius: f64) -> Vec<(At, [f64; 2])> {
        let (norm, radius) = (s.hypot(t), radius.min(0.5));
        let out = if norm > 1e-6 { [s / norm, t / norm] } else { [1.0, 0.0] };
        let outward = (out, [-radius, radius.min(1.0 - norm).max(0.0)]);
        let around = ([-out[1], out[0]], [-radius, radius]);
        match (self.is_rim, self.is_line()) {
            _ if self.is_point() => Vec::new(),
            (true, _) => vec![around],
            (false, true) => vec![outward],
            (false, false) => vec![outward, around],
        }
    }

    /// Returns a function of the moments, without its constant, for a unit mass on this chart.
    pub(super) fn quadratic(&self, of: &Functional) -> Quadratic {
        let [a, b] = &self.axes;
        Quadratic {
            constant: of.at(&weights(self.offset)),
            slope: [of.slope(&self.offset, a), of.slope(&self.offset, b)],
            square: [of.form(a, a), of.form(a, b), of.form(b, b)],
        }
    }

    /// Returns the minimum of a function on the chart: its place and its value.
    pub(super) fn least(&self, of: &Functional) -> (At, f64) {
        let quadratic = self.quadratic(of);
        let [s, t] = if self.is_point() { [0.0; 2] } else { quadratic.least(self.is_rim) };
        let at = if self.is_line() { [s, 0.0] } else { [s, t] };
        (at, quadratic.value(at))
    }
}

impl Quadratic {
    pub(super) fn value(&self, [s, t]: At) -> f64 {
        let [a, b, c] = self.square;
        self.constant + self.slope[0] * s + self.slope[1] * t + a * s * s + 2.0 * b * s * t + c * t * t
    }

    pub(super) fn gradient(&self, [s, t]: At) -> [f64; 2] {
        let [a, b, c] = self.square;
        [self.slope[0] + 2.0 * (a * s + b * t), self.slope[1] + 2.0 * (b * s + c * t)]
    }

    /// Returns the minimizer on the disc or the rim: (Q + λ) u = −½ g (Moré and Sorensen, SIAM J.
    /// Sci. Stat. Comput. 4, 1983, 553).
    fn least(&self, is_rim: bool) -> At {
        let ([a, b, c], g) = (self.square, self.slope);
        let (mean, half) = (0.5 * (a + c), 0.5 * (a - c));
        let radius = half.hypot(b);
        // Eigenvector of the lesser eigenvalue.
        let (sin, cos) = libm::sincos(0.5 * libm::atan2(-b, -half));
        let low = mean - radius;
        let along = [cos * g[0] + sin * g[1], -sin * g[0] + cos * g[1]];
        let back = |[s, t]: At| [cos * s - sin * t, sin * s + cos * t];
        // With λ = σ − low: u = −½ (g₁/σ, g₂/(high − low + σ)).
        let at = |sigma: f64| {
            let by = |g: f64, d: f64| if g == 0.0 { 0.0 } else { -0.5 * g / d };
            [by(along[0], sigma), by(along[1], 2.0 * radius + sigma)]
        };
        let norm = |[s, t]: At| s.hypot(t);
        if !is_rim && low > 0.0 && norm(at(low)) <= 1.0 {
            return back(at(low));
        }
        let mut most = 0.5 * norm(along).max(f64::MIN_POSITIVE);
        let mut least = if is_rim { 0.0 } else { low.max(0.0) };
        loop {
            let sigma = 0.5 * (least + most);
            if sigma <= least || sigma >= most {
                break;
            }
            if norm(at(sigma)) > 1.0 { least = sigma } else { most = sigma }
        }
        let [s, t] = at(most);
        // Hard case: g has no component along the eigenvector, so u follows it up to the rim.
        let s = if s.hypot(t) < 1.0 { (1.0 - t * t).max(0.0).sqrt().copysign(s) } else { s };
        let norm = s.hypot(t);
        back([s / norm, t / norm])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
                let f = Quadratic { constant: 0.7, slope, square };
                let mut grid = f64::INFINITY;
                for k in 0..2000 {
                    let (sin, cos) = (core::f64::consts::TAU * f64::from(k) / 2000.0).sin_cos();
                    for radius in if rim { 100..=100 } else { 0..=100 } {
                        let radius = f64::from(radius) / 100.0;
                        grid = grid.min(f.value([radius * cos, radius * sin]));
                    }
                }
                let [s, t] = f.least(rim);
                assert!(s.hypot(t) <= 1.0 + 1e-15 && (!rim || s.hypot(t) > 1.0 - 1e-15));
                let found = f.value([s, t]);
                assert!(
                    found <= grid + 1e-14 && found > grid - 1e-3,
                    "{slope:?} {square:?} {rim}: {found} {grid}"
                );
            }
        }
    }
}
