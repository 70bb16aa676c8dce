//! Where ballast may be.

use polhode::math::{Body, Direction, Position};

use super::error::BallastError;
use super::interval::Interval;
use super::row::{Functional, weights};

/// A place for ballast.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// What to call it.
    pub name: String,
    /// Where it is.
    pub place: Place,
    /// The most mass that it takes, kg.
    pub most: Option<f64>,
    /// The masses of which a point takes one or none, kg; without, any mass.
    pub sizes: Vec<f64>,
}

/// The form of a place, in the body. Of all but a point, several masses may be in it.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// A point, m.
    Point(Position<Body>),
    /// A line from one point to another, m.
    Line([Position<Body>; 2]),
    /// A disc.
    Disc(Round),
    /// A circle: the rim of a disc.
    Circle(Round),
}

/// A circle in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// Its middle, m.
    pub center: Position<Body>,
    /// A direction across its plane, of any length.
    pub normal: Direction<Body>,
    /// m
    pub radius: f64,
}

impl Site {
    /// Any mass at a place.
    pub fn new(name: impl Into<String>, place: Place) -> Self {
        Self { name: name.into(), place, most: None, sizes: Vec::new() }
    }

    /// The holes of a bolt circle, each a point, evenly from a direction on, right-handed about the normal, named by their numbers from 1. None if a direction is zero or along the normal.
    pub fn bolt_circle(name: &str, round: Round, first: Direction<Body>, holes: u32) -> Vec<Self> {
        let Some(n) = round.normal.direction() else { return Vec::new() };
        let Some(u) = (first - n * n.dot(first)).direction() else { return Vec::new() };
        let v = n.cross(u);
        let hole = |k: u32| {
            let (sin, cos) = libm::sincos(core::f64::consts::TAU * f64::from(k) / f64::from(holes));
            let out = (u * cos + v * sin) * round.radius;
            let at = round.center + Position::from_array(out.to_array());
            Self::new(format!("{name} {}", k + 1), Place::Point(at))
        };
        (0..holes).map(hole).collect()
    }
}

/// A place as r = center + s e₁ + t e₂ with s² + t² ≤ 1, or = 1.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chart {
    center: [f64; 3],
    axes: [[f64; 3]; 2],
    /// Only s² + t² = 1.
    rim: bool,
}

/// A quadratic function on a chart: q + g·u + uᵀ Q u, with Q₁₁, Q₁₂, Q₂₂.
struct Planar {
    constant: Interval,
    slope: [Interval; 2],
    square: [Interval; 3],
}

/// Where a function on a chart is least, and λ: f(u) + λ (u² − 1) has its least value there.
struct Least {
    at: [f64; 2],
    multiplier: f64,
}

impl Chart {
    pub(super) fn new(site: &Site) -> Result<Self, BallastError> {
        let wrong = |what, value, rule| BallastError::Value { site: site.name.clone(), what, value, rule };
        let finite = |at: Position<Body>| match at.to_array().into_iter().find(|x| !x.is_finite()) {
            None => Ok(at.to_array()),
            Some(value) => Err(wrong("the position", value, "finite")),
        };
        let round = |round: &Round, rim| {
            let n = round.normal.direction();
            let n = n.ok_or_else(|| {
                wrong("the length of the normal", round.normal.norm(), "finite and not zero")
            })?;
            if !(round.radius > 0.0 && round.radius.is_finite()) {
                return Err(wrong("the radius", round.radius, "positive and finite"));
            }
            let other =
                if n.x.abs() < 0.6 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
            let u = n.cross(other).direction().unwrap_or(other);
            let axes = [u, n.cross(u)].map(|u| (u * round.radius).to_array());
            Ok(Self { center: finite(round.center)?, axes, rim })
        };
        match &site.place {
            Place::Point(at) => Ok(Self { center: finite(*at)?, axes: [[0.0; 3]; 2], rim: false }),
            Place::Line([a, b]) => {
                let (a, b) = (finite(*a)?, finite(*b)?);
                let center = core::array::from_fn(|k| 0.5 * a[k] + 0.5 * b[k]);
                let half = core::array::from_fn(|k| 0.5 * b[k] - 0.5 * a[k]);
                Ok(Self { center, axes: [half, [0.0; 3]], rim: false })
            }
            Place::Disc(disc) => round(disc, false),
            Place::Circle(circle) => round(circle, true),
        }
    }

    pub(super) fn is_point(&self) -> bool {
        self.axes == [[0.0; 3]; 2]
    }

    fn point(&self, [s, t]: [f64; 2]) -> [f64; 3] {
        let [a, b] = &self.axes;
        core::array::from_fn(|k| self.center[k] + s * a[k] + t * b[k])
    }

    /// Points to begin with.
    pub(super) fn seeds(&self) -> Vec<[f64; 3]> {
        if self.is_point() {
            return vec![self.center];
        }
        let around: &[[f64; 2]] = if self.axes[1] == [0.0; 3] {
            &[[1.0, 0.0], [-1.0, 0.0]]
        } else {
            &[[1.0, 0.0], [-0.5, 0.866_025_403_784_438_6], [-0.5, -0.866_025_403_784_438_6]]
        };
        around.iter().map(|u| self.point(*u)).collect()
    }

    /// Whether two points are nearer than a part of the size of the place.
    pub(super) fn are_near(&self, a: [f64; 3], b: [f64; 3], part: f64) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= part * self.size())
    }

    /// The length of its greatest axis.
    pub(super) fn size(&self) -> f64 {
        self.axes.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()))
    }

    /// s and t of the foot of a point.
    fn foot(&self, r: [f64; 3]) -> [f64; 2] {
        let d: [f64; 3] = core::array::from_fn(|k| r[k] - self.center[k]);
        let inner = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        self.axes.map(|axis| {
            let square = inner(&axis, &axis);
            if square > 0.0 { inner(&axis, &d) / square } else { 0.0 }
        })
    }

    /// The point of the place that is nearest to a point; of its rim, along the radius.
    pub(super) fn nearest(&self, r: [f64; 3]) -> [f64; 3] {
        let u = self.foot(r);
        let norm = u[0].hypot(u[1]);
        let factor = if norm > 1.0 || (self.rim && norm > 0.0) { 1.0 / norm } else { 1.0 };
        self.point(u.map(|u| u * factor))
    }

    /// Along what a point of the place can move without leaving it, either way: on a rim, along that.
    pub(super) fn freedoms(&self, r: [f64; 3]) -> Vec<[f64; 3]> {
        let [s, t] = self.foot(r);
        let [a, b] = self.axes;
        let is_inside = !self.rim && s.hypot(t) < 1.0 - 1e-9;
        match (is_inside, b == [0.0; 3]) {
            _ if self.is_point() => Vec::new(),
            (true, true) => vec![a],
            (true, false) => vec![a, b],
            (false, true) => Vec::new(),
            (false, false) => vec![core::array::from_fn(|k| s * b[k] - t * a[k])],
        }
    }

    /// Where a function of a place is about least, and a number that it is nowhere below.
    pub(super) fn least(&self, of: &Functional, origin: [f64; 3]) -> ([f64; 3], f64) {
        let planar = self.planar(of, origin);
        if self.is_point() {
            return (self.center, planar.constant.low);
        }
        let least = planar.least(self.rim);
        (self.point(least.at), planar.bound(&least, self.rim))
    }

    fn planar(&self, of: &Functional, origin: [f64; 3]) -> Planar {
        let center: [Interval; 3] =
            core::array::from_fn(|k| Interval::from(self.center[k]) - Interval::from(origin[k]));
        let axes = self.axes.map(|axis| axis.map(Interval::from));
        let constant = of.constant + of.at(&weights(center));
        let slope = axes.map(|e| of.slope(&center, &e));
        let [a, b] = &axes;
        // The form of a and b counts both ab and ba.
        let square = [of.form(a, a), of.form(a, b), of.form(b, b)];
        Planar { constant, slope, square }
    }
}

impl Planar {
    /// The least value on the disc or the rim: (Q + λ) u = −½ g (Moré and Sorensen, SIAM J. Sci. Stat. Comput. 4, 1983, 553).
    fn least(&self, rim: bool) -> Least {
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

    /// A lower bound: h(u) = f(u) + λ (u² − 1) is nowhere above f on the disc if λ ≥ 0, and is f on the rim. Where Q + λ has no negative eigenvalue, h is nowhere below its tangent plane.
    fn bound(&self, least: &Least, rim: bool) -> f64 {
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
