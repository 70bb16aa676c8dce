//! Kepler's equation for ellipses, parabolas and hyperbolas in one form.
//!
//! Lengths are in units of the periapsis distance q, times in units of √(q³/µ), counted from
//! periapsis. With β = 1 − e and the universal anomaly S (dS = dt/r),
//!
//! t = S + e S³ c₃(β S²),  r = 1 + e S² c₂(β S²),  x = 1 − S² c₂(β S²),  y = √(1 + e) S c₁(β S²)
//!
//! β S² is E² on an ellipse, −F² on a hyperbola and zero on a parabola. Nothing cancels: all terms
//! of t and of r have the same sign.
//!
//! Source: J. M. A. Danby, Fundamentals of Celestial Mechanics, 2nd ed. (1988), ch. 6.9: universal
//! variables, with the start at periapsis.

use super::number::{PI, sin_cos};

/// Shape of an orbit: the eccentricity e, and β = 1 − e with full relative precision near e = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Conic {
    pub(crate) e: f64,
    pub(crate) beta: f64,
}

/// Position (x, y) on an orbit, and velocity dx/dt, dy/dt.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OrbitalPoint {
    pub(crate) position: [f64; 2],
    pub(crate) velocity: [f64; 2],
}

impl Conic {
    /// Returns the position and velocity at a time; on an ellipse |t| must be within half a period.
    pub(crate) fn at(self, t: f64) -> OrbitalPoint {
        let s = self.anomaly(t);
        if self.e == 0.0 {
            let (sin, cos) = sin_cos(s);
            return OrbitalPoint { position: [cos, sin], velocity: [-sin, cos] };
        }
        let [c0, c1, c2, _] = stumpff(self.beta * s * s);
        let (along, across) = (s * s * c2, (1.0 + self.e).sqrt());
        let r = 1.0 + self.e * along;
        OrbitalPoint { position: [1.0 - along, across * s * c1], velocity: [-s * c1 / r, across * c0 / r] }
    }

    /// Returns t = S + e S³ c₃.
    pub(crate) fn time(self, s: f64) -> f64 {
        let [_, _, _, c3] = stumpff(self.beta * s * s);
        s + self.e * s * s * s * c3
    }

    /// Returns S at a time.
    ///
    /// t is convex in S > 0, so Newton steps from above the root decrease to it monotonically. The
    /// iteration ends when rounding prevents a further decrease.
    pub(crate) fn anomaly(self, time: f64) -> f64 {
        let Self { e, beta } = self;
        let t = time.abs();
        if e == 0.0 {
            // On a circle S = t.
            return t.min(PI / beta.sqrt()).copysign(time);
        }
        // S ≤ t because r ≥ 1, and c₃ ≥ 1/π² up to half a period.
        let mut s = t.min(libm::cbrt(PI * PI * t / e));
        if beta > 0.0 {
            s = s.min(PI / beta.sqrt());
        } else if beta < 0.0 {
            // e sinh F = M + F.
            let k = (-beta).sqrt();
            s = s.min(libm::asinh((k * k * k * t + k * s) / e) / k);
        }
        for _ in 0..MOST_STEPS {
            let [_, _, c2, c3] = stumpff(beta * s * s);
            let next = s - (s + e * s * s * s * c3 - t) / (1.0 + e * s * s * c2);
            if !(next < s) {
                break;
            }
            s = next;
        }
        s.copysign(time)
    }

    /// Returns S for the true anomaly ν, given tan ½ν; not finite beyond the asymptotes of a
    /// hyperbola.
    pub(crate) fn anomaly_towards(self, half_tangent: f64) -> f64 {
        let k = self.beta.abs().sqrt();
        let x = half_tangent / (1.0 + self.e).sqrt();
        match self.beta {
            // tan ½E = √((1 − e)/(1 + e)) tan ½ν.
            beta if beta > 0.0 => 2.0 * libm::atan(k * x) / k,
            beta if beta < 0.0 => 2.0 * libm::atanh(k * x) / k,
            _ => 2.0 * x,
        }
    }
}

/// Iteration limit; from the starts above, about ten steps are sufficient.
const MOST_STEPS: usize = 100;

/// Returns the Stumpff functions c₀ … c₃, cₖ(x) = Σ (−x)ⁿ / (2n + k)!: cos √x, sin √x / √x,
/// (1 − cos √x)/x, (√x − sin √x)/√x³.
fn stumpff(x: f64) -> [f64; 4] {
    let root = x.abs().sqrt();
    if x.abs() < 3.0 {
        let sum = |terms: &[f64; 13]| terms.iter().rev().fold(0.0, |sum, term| term - x * sum);
        let (c2, c3) = (sum(&SECOND), sum(&THIRD));
        [1.0 - x * c2, 1.0 - x * c3, c2, c3]
    } else if x > 0.0 {
        let (sin, cos) = sin_cos(root);
        [cos, sin / root, (1.0 - cos) / x, (root - sin) / (root * x)]
    } else {
        let (sinh, cosh) = (libm::sinh(root), libm::cosh(root));
        [cosh, sinh / root, (1.0 - cosh) / x, (root - sinh) / (root * x)]
    }
}

/// Terms 1/(2n + 2)!; for |x| < 3 the next term is below 1e-20 of the first.
const SECOND: [f64; 13] = inverse_factorials(2);
/// Terms 1/(2n + 3)!.
const THIRD: [f64; 13] = inverse_factorials(3);

const fn inverse_factorials(first: usize) -> [f64; 13] {
    let mut terms = [0.0; 13];
    let (mut n, mut factorial) = (0, if first == 2 { 2.0 } else { 6.0 });
    while n < 13 {
        terms[n] = 1.0 / factorial;
        let k = (2 * n + first) as f64;
        factorial *= (k + 1.0) * (k + 2.0);
        n += 1;
    }
    terms
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_is_found_to_rounding_for_every_eccentricity() {
        for e in [0.0, 1e-17, 1e-9, 0.3, 0.9, 0.999_999, 1.0, 1.000_001, 1.7, 40.0, 1e9] {
            let conic = Conic { e, beta: 1.0 - e };
            let half = if e < 1.0 { PI / conic.beta.powf(1.5) } else { 1e12 };
            for part in [1e-300, 1e-12, 1e-5, 0.003, 0.2, 0.49, 0.9, 0.999, 1.0] {
                let t = -half * part;
                let s = conic.anomaly(t);
                assert!(s < 0.0);
                // Precision of t from S: a relative error of S causes r S / t times this error of
                // t.
                let [.., c2, _] = stumpff(conic.beta * s * s);
                let sensitivity = (1.0 + e * s * s * c2) * s / t;
                let error = (conic.time(s) / t - 1.0).abs();
                assert!(error < 4e-16 * (2.0 + sensitivity.abs()), "e = {e}, t = {t}: {error:e}");
            }
        }
    }

    #[test]
    fn the_place_is_on_its_conic_and_moves_as_gravity_says() {
        for e in [0.0, 0.02, 0.6, 0.97, 1.0, 1.4, 7.0] {
            let conic = Conic { e, beta: 1.0 - e };
            for t in [-3.0, -0.4, 0.0, 0.01, 0.9, 2.2, 3.1] {
                let OrbitalPoint { position: [x, y], velocity: [u, v] } = conic.at(t);
                let r = x.hypot(y);
                // r + e x = p = 1 + e, x v − y u = √p, ½v² − 1/r = −½ (1 − e).
                assert!((r + e * x - 1.0 - e).abs() < 4e-15 * (1.0 + e) * r);
                assert!((x * v - y * u - (1.0 + e).sqrt()).abs() < 4e-15 * (1.0 + e) * r);
                assert!((u * u + v * v - 2.0 / r + conic.beta).abs() < 8e-15 * (1.0 + e));
                // The velocity is the derivative of the position.
                let h = 1e-5;
                let (before, after) = (conic.at(t - h).position, conic.at(t + h).position);
                assert!(((after[0] - before[0]) / (2.0 * h) - u).abs() < 1e-8 * (1.0 + e).powi(2));
                assert!(((after[1] - before[1]) / (2.0 * h) - v).abs() < 1e-8 * (1.0 + e).powi(2));
            }
        }
    }

    #[test]
    fn the_two_forms_of_every_function_meet() {
        for x in [3.0_f64, -3.0] {
            let (inside, outside) = (stumpff(3.0_f64.next_down().copysign(x)), stumpff(x));
            for (a, b) in inside.iter().zip(outside) {
                assert!((a - b).abs() < 4e-16 * b.abs().max(1.0), "{a} {b}");
            }
        }
    }

    #[test]
    fn a_direction_gives_the_same_anomaly_as_the_place() {
        for e in [0.0, 0.3, 0.99, 1.0, 2.5] {
            let conic = Conic { e, beta: 1.0 - e };
            let s = conic.anomaly(1.3);
            let OrbitalPoint { position: [x, y], .. } = conic.at(1.3);
            let half_tangent = y / (x.hypot(y) + x);
            assert!((conic.anomaly_towards(half_tangent) / s - 1.0).abs() < 4e-15, "e = {e}");
        }
        assert!(!Conic { e: 2.0, beta: -1.0 }.anomaly_towards(1.8).is_finite());
    }
}
