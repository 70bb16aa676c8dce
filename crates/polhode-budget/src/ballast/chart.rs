//! The points of a place, and functions of the moments on it.

use polhode::math::{Body, Direction, Position};

use super::error::BallastError;
use super::interval::Interval;
use super::planar::Planar;
use super::row::{Functional, weights};
use super::site::{Place, Round, Site};

/// A place as r = center + s e₁ + t e₂ with s² + t² ≤ 1, or = 1.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chart {
    center: [f64; 3],
    axes: [[f64; 3]; 2],
    /// Only s² + t² = 1.
    rim: bool,
}

/// Part of a place: from where to where s and t are; of a rim, the angle.
pub(super) type Part = [[f64; 2]; 2];

/// More than parts are rounded by, in the coordinates of a place that is not far from the origin.
const ROUNDING: f64 = 1e-14;

/// Steps of Newton's method.
const STEPS: usize = 8;

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

    /// All of it.
    pub(super) fn whole(&self) -> Part {
        use core::f64::consts::PI;
        match (self.rim, self.axes.map(|axis| axis != [0.0; 3])) {
            (true, _) => [[-PI, PI], [0.0; 2]],
            (false, has) => has.map(|has| if has { [-1.0, 1.0] } else { [0.0; 2] }),
        }
    }

    /// s and t, or the angle, of the foot of a point.
    pub(super) fn coordinates(&self, r: [f64; 3]) -> [f64; 2] {
        let [s, t] = self.foot(r);
        if self.rim { [libm::atan2(t, s), 0.0] } else { [s, t] }
    }

    /// Parts of it about a point, this far: a disc or a line, and points of the rim.
    pub(super) fn about(&self, r: [f64; 3], far: f64) -> Vec<Self> {
        let u = self.coordinates(r);
        let within = |center: [f64; 2]| {
            let axes = self.axes.map(|axis| axis.map(|x| far * x));
            Self { center: self.point(center), axes, rim: false }
        };
        let arc = |angle: f64| {
            (-4_i32..=4).map(move |k| {
                let (sin, cos) = libm::sincos(angle + far * f64::from(k) / 4.0);
                Self { center: self.point([cos, sin]), axes: [[0.0; 3]; 2], rim: false }
            })
        };
        if self.rim {
            return arc(u[0]).collect();
        }
        let (norm, inside) = (u[0].hypot(u[1]), 1.0 - far);
        let pulled = within(if norm > inside { u.map(|u| u * inside / norm) } else { u });
        let is_near_rim = norm > inside && self.axes[1] != [0.0; 3];
        let rim = is_near_rim.then(|| arc(libm::atan2(u[1], u[0])));
        core::iter::once(pulled).chain(rim.into_iter().flatten()).collect()
    }

    /// An ellipse, or of a line a line, that a part is within.
    pub(super) fn covering(&self, part: &Part) -> Self {
        let [[low, high], t] = part;
        let (middle, half) = (0.5 * low + 0.5 * high, 0.5 * (high - low));
        let (out, along) = (self.axes[0], self.axes[1]);
        let scaled = |by: f64, axis: [f64; 3]| axis.map(|x| by * x);
        let far = self.center.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let rounding = ROUNDING + 8.0 * f64::EPSILON * far / self.size().max(f64::MIN_POSITIVE);
        if self.rim {
            // Through the ends and the middle of the arc, of the least area: an arc less than a half is in it as (x − x₀)²/a² + (1 − x²)/b² is convex in x.
            if half > core::f64::consts::FRAC_PI_2 {
                return self.clone();
            }
            let ((sin, cos), (high, low)) = (libm::sincos(middle), libm::sincos(half));
            let turned = |s: f64, t: f64| core::array::from_fn(|k| s * out[k] + t * along[k]);
            let a = 2.0 / 3.0 * (1.0 - low) + rounding;
            let b = high * 2.0 / 3.0_f64.sqrt() + rounding;
            let (x, y) = (turned(cos, sin), turned(-sin, cos));
            let center = core::array::from_fn(|k| self.center[k] + (1.0 - a) * x[k]);
            return Self { center, axes: [scaled(a + rounding, x), scaled(b + rounding, y)], rim: false };
        }
        let center = self.point([middle, 0.5 * t[0] + 0.5 * t[1]]);
        if along == [0.0; 3] {
            return Self { center, axes: [scaled(half + rounding, out), along], rim: false };
        }
        let root = core::f64::consts::SQRT_2;
        let (a, b) = (root * half + rounding, root * 0.5 * (t[1] - t[0]) + rounding);
        if a * b >= 1.0 {
            return self.clone();
        }
        Self { center, axes: [scaled(a, out), scaled(b, along)], rim: false }
    }

    /// Whether a point is in it, but for rounding.
    pub(super) fn holds(&self, r: [f64; 3]) -> bool {
        let near = self.nearest(r);
        self.are_near(near, r, 1e-9)
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

    /// Where a function of a place is about least near a point, by Newton's method.
    pub(super) fn least_about(&self, of: &Functional, origin: [f64; 3], r: [f64; 3]) -> [f64; 3] {
        let planar = self.planar(of, origin);
        let mut u = self.foot(r);
        for _ in 0..STEPS {
            let Some(next) = planar.nearer(u, self.rim, self.axes[1] == [0.0; 3]) else { break };
            u = next;
        }
        self.nearest(self.point(u))
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
