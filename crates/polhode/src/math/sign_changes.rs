//! Zeros of a smooth function on an interval that is divided into pieces.
//!
//! The cubic Hermite interpolant of values and slopes approximates the function in each piece. Its
//! error is estimated from values between the ends. A piece whose interpolant differs from zero by
//! more than its error has no zero. A piece with a sign change whose interpolant is monotone has
//! one. All others are halved.

use super::root::{dip, root};

/// Maximum number of times that a piece is halved.
const DEPTH: u32 = 8;

/// Part of a piece over which a slope is computed.
pub(crate) const SLOPE: f64 = 1.0 / 256.0;

/// Safety factor of the estimated error of an interpolant.
const SAFETY: f64 = 4.0;

/// Place, value and slope of a function.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    pub(crate) at: f64,
    pub(crate) value: f64,
    pub(crate) slope: f64,
}

/// Function whose zeros are sought. Values up to `noise` may be rounding.
pub(crate) struct Sought<'a> {
    pub(crate) function: &'a dyn Fn(f64) -> f64,
    pub(crate) noise: f64,
}

impl Sought<'_> {
    /// Returns the places between nodes at which the function changes its sign, in ascending order.
    /// At every node |f| must exceed the noise.
    pub(crate) fn zeros(&self, nodes: &[Node]) -> Vec<f64> {
        let error = |k: usize, left: usize| {
            let (Some(left), Some(middle), Some(right)) =
                (nodes.get(left), nodes.get(left + 1), nodes.get(left + 2))
            else {
                return None;
            };
            let part = (nodes.get(k + 1)?.at - nodes.get(k)?.at) / (right.at - left.at);
            Some(Cubic::between(left, right).error(middle) * (part * part))
        };
        let mut found = Vec::new();
        for (k, pair) in nodes.windows(2).enumerate() {
            let [left, right] = pair else { continue };
            let estimates = [k.checked_sub(1).and_then(|left| error(k, left)), error(k, k)];
            let error = estimates.into_iter().flatten().reduce(f64::max).unwrap_or(f64::INFINITY);
            self.search(left, right, error, DEPTH, &mut found);
        }
        found
    }

    /// Finds the zeros between two nodes; `error` is the error of the interpolant there.
    fn search(&self, left: &Node, right: &Node, error: f64, depth: u32, found: &mut Vec<f64>) {
        let Node { at: a, value, .. } = *left;
        let (sign, width) = (value.signum(), right.at - a);
        let is_crossed = sign * right.value < 0.0;
        let cubic = Cubic::between(left, right);
        // Slopes are differences over a short part of a piece; their error is proportional to the
        // curvature.
        let margin = SAFETY * error + 2.0 * SLOPE * (cubic.slopes[1] - cubic.slopes[0]).abs();
        let is_plain =
            if is_crossed { cubic.is_monotone(margin) } else { cubic.least(sign) > margin + self.noise };
        if is_plain || depth == 0 {
            self.resolve(left, right, found);
            return;
        }
        let inside =
            [0.5, 0.4].map(|part| a + part * width).into_iter().filter(|at| *at > a && *at < right.at);
        let mut nodes = inside.map(|at| self.node(at, SLOPE * width));
        let Some(middle) = nodes.find(|node| node.value.abs() > self.noise) else {
            self.resolve(left, right, found);
            return;
        };
        // For sufficiently short pieces the error would be a sixteenth; a quarter is used, because
        // the pieces may be long.
        let error = cubic.error(&middle) / 4.0;
        self.search(left, &middle, error, depth - 1, found);
        self.search(&middle, right, error, depth - 1, found);
    }

    /// Finds the zero between nodes of opposite signs, or the two zeros of a function with an
    /// extremum between nodes of one sign.
    fn resolve(&self, left: &Node, right: &Node, found: &mut Vec<f64>) {
        let Node { at: a, value, slope } = *left;
        let sign = value.signum();
        if sign * right.value < 0.0 {
            found.push(root(self.function, [a, right.at], [value, right.value]));
        } else if sign * slope < 0.0
            && sign * right.slope > 0.0
            && let Some(there) = dip(|x| sign * (self.function)(x) + self.noise, [a, right.at])
        {
            let lowest = (self.function)(there);
            found.push(root(self.function, [a, there], [value, lowest]));
            found.push(root(self.function, [there, right.at], [lowest, right.value]));
        }
    }

    /// Returns the value of the function at a place, with its slope from the difference over
    /// `step`.
    pub(crate) fn node(&self, at: f64, step: f64) -> Node {
        let value = (self.function)(at);
        let beside = at + step;
        Node { at, value, slope: ((self.function)(beside) - value) / (beside - at) }
    }
}

/// Cubic polynomial on [0, 1], given by its values and slopes at the ends.
struct Cubic {
    begin: f64,
    width: f64,
    values: [f64; 2],
    slopes: [f64; 2],
}

impl Cubic {
    fn between(left: &Node, right: &Node) -> Self {
        let width = right.at - left.at;
        let [values, slopes] = [[left.value, right.value], [left.slope * width, right.slope * width]];
        Self { begin: left.at, width, values, slopes }
    }

    /// Returns c of p = v₀ + s (d₀ + s (c₀ + s c₁)).
    fn curvature(&self) -> [f64; 2] {
        let ([v, w], [d, e]) = (self.values, self.slopes);
        [3.0 * (w - v) - 2.0 * d - e, d + e - 2.0 * (w - v)]
    }

    fn at(&self, s: f64) -> f64 {
        let [c, d] = self.curvature();
        self.values[0] + s * (self.slopes[0] + s * (c + s * d))
    }

    /// Returns the largest difference from a function of which a node between the ends is known,
    /// assuming f − p ∝ s² (1 − s)².
    fn error(&self, node: &Node) -> f64 {
        let s = (node.at - self.begin) / self.width;
        let shape = 4.0 * s * (1.0 - s);
        (node.value - self.at(s)).abs() / (shape * shape)
    }

    /// Returns min sign · p.
    fn least(&self, sign: f64) -> f64 {
        let ends = (sign * self.values[0]).min(sign * self.values[1]);
        self.turns().into_iter().fold(ends, |least, s| least.min(sign * self.at(s)))
    }

    /// Returns the zeros of p′ between 0 and 1, at most two; 0 stands for none.
    fn turns(&self) -> [f64; 2] {
        let ([c, d], b) = (self.curvature(), self.slopes[0]);
        // b + 2 c s + 3 d s² = 0.
        let root = (c * c - 3.0 * b * d).sqrt();
        let q = -(c + root.copysign(c));
        [q / (3.0 * d), b / q].map(|s| if s > 0.0 && s < 1.0 { s } else { 0.0 })
    }

    /// Returns true if p′ has a constant sign and exceeds the slope of an error of p of this size.
    fn is_monotone(&self, error: f64) -> bool {
        let [c, d] = self.curvature();
        let direction = (self.values[1] - self.values[0]).signum();
        let slope = |s: f64| direction * (self.slopes[0] + s * (2.0 * c + 3.0 * s * d));
        let vertex = -c / (3.0 * d);
        let inside = if vertex > 0.0 && vertex < 1.0 { slope(vertex) } else { f64::INFINITY };
        // The maximum of (16 s² (1 − s)²)′ is 3.1.
        slope(0.0).min(slope(1.0)).min(inside) > 3.1 * error
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn zeros(f: &dyn Fn(f64) -> f64, [from, to]: [f64; 2], pieces: u32) -> Vec<f64> {
        let sought = Sought { function: f, noise: 1e-14 };
        let width = (to - from) / f64::from(pieces);
        let nodes: Vec<Node> = (0..=pieces)
            .map(|k| {
                sought.node(from + f64::from(k) * width, if k < pieces { 1.0 } else { -1.0 } * SLOPE * width)
            })
            .collect();
        sought.zeros(&nodes)
    }

    #[test]
    fn all_zeros_of_a_fast_function_are_found() {
        // sin(40 x) on [0.01, 1.7]: 4 pieces of 2.7 periods each.
        let found = zeros(&|x| (40.0 * x).sin(), [0.01, 1.7], 4);
        let wanted: Vec<f64> = (1..=21).map(|k| f64::from(k) * core::f64::consts::PI / 40.0).collect();
        assert_eq!(found.len(), wanted.len(), "{found:?}");
        assert!(found.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-15 * 10.0));
    }

    #[test]
    fn zeros_close_together_are_two_and_a_near_miss_is_none() {
        for (depth, count) in [(1e-2, 2), (1e-6, 2), (1e-11, 2), (-1e-11, 0), (-1e-3, 0)] {
            for place in [0.3, 0.431, 0.999] {
                // A minimum on a slope, at a generic place.
                let f = |x: f64| ((x - place).powi(2) - depth) * (1.0 + 0.7 * x + 0.4 * x * x);
                let found = zeros(&f, [-1.13, 2.0], 5);
                assert_eq!(found.len(), count, "{depth} {place} {found:?}");
                let half = depth.abs().sqrt();
                for (zero, sign) in found.iter().zip([-1.0, 1.0]) {
                    assert!((zero - (place + sign * half)).abs() < 1e-15 / half + 1e-15, "{zero}");
                }
            }
        }
    }

    #[test]
    fn three_zeros_between_two_nodes_are_three() {
        let f = |x: f64| (x - 0.2) * (x - 0.5) * (x - 0.55) * (1.0 + 0.3 * x * x);
        let found = zeros(&f, [0.0, 1.0], 1);
        assert_eq!(found.len(), 3);
        for (zero, wanted) in found.iter().zip([0.2, 0.5, 0.55]) {
            assert!((zero - wanted).abs() < 1e-14);
        }
    }
}
