//! Bodies that spin about the vertical on a point below their centre of mass.

use super::stable_spins::{SpinInterval, StableSpins, both_senses};
use crate::motion::contact::Footing;

/// Body that spins about a vertical principal axis through its point of contact: an egg on its end,
/// a top on its peg, a rattleback, an ellipsoid on its side.
///
/// The 2 × 2 matrices refer to two body axes perpendicular to n:
///
/// - S: moments of inertia;
/// - R: radii of curvature of the surface;
/// - G = R − h: lever of gravity, with the height h of the centre of mass;
/// - J: rotation by 90° about n.
///
/// C is the moment about n, and µ is the mass that friction accelerates along the ground: m for
/// rolling, 0 without friction. From ṅ = n × ω, v = r × ω and I ω̇ + ω × I ω = r × F, a small
/// deviation q of n at the spin Ω obeys
///
/// M q̈ + Ω (γ J − µ h J G′) q̇ + K q = 0,  M = tr S − S + µ h²,
/// γ = tr S − C + µ h² − ½ µ h tr G,  K = m g G + Ω² (µ h G + C − S),
///
/// where G′ is G without its trace. The characteristic equation
///
/// a₄ λ⁴ + a₃ λ³ + a₂ λ² + a₁ λ + a₀ = 0
///
/// has, with x = Ω²,
///
/// a₄ = det M,  a₃ = −µ h Ω χ,  a₂ = tr (adj M K) + x (γ² + µ² h² det G′),  a₁ = x a₃,  a₀ = det K,
///
/// with χ = tr (S J G′), which is zero if the principal axes are parallel to those of the surface.
/// If χ = 0, the spin is stable for a₀ > 0, a₂ > 0, a₂² > 4 a₀ a₄. Otherwise the Hurwitz criterion
/// requires a₃ > 0, a₀ > 0, x a₂ > x² a₄ + a₀, which holds in one sense only. Without gravity
/// λ = i Ω is a root, because a vector fixed in space rotates in the body; the last condition is
/// therefore linear in x:
///
/// Ω² ((tr S − C + m h²) tr G − 2 m h det G) > m g det G.
///
/// The other bounds are roots of quadratic equations in x.
///
/// Let the body be symmetric, with A perpendicular to the axis, C along it and b = R. With
/// η = q₁ + i q₂ in space, the equation becomes
///
/// (A + µ h²) η̈ − i (C + µ h b) Ω η̇ − m g (h − b) η = 0.
///
/// The spin is stable if (C + µ h b)² Ω² > 4 (A + µ h²) m g (h − b), like a sleeping top. With viscous
/// friction, the stability limit is a motion without slip and friction force: h η̇ = i b Ω η and
/// A η̈ − i C Ω η̇ = m g (h − b) η. The spin is stable if b (C h − A b) Ω² > m g h² (h − b), for any
/// coefficient.
///
/// Source: A. V. Karapetyan, J. Appl. Math. Mech. 45 (1981) 808; A. Garcia, M. Hubbard, Proc. R.
/// Soc. A 418 (1988) 165; A. V. Borisov, I. S. Mamaev, Phys.-Usp. 46 (2003) 393; for the sleeping
/// top Routh, Advanced Part (1905), art. 207; the forms with R and S as matrices are derived here
/// as above.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct VertexSpin {
    /// Mass m, kg.
    pub mass: f64,
    /// Gravitational acceleration g, m/s².
    pub gravity: f64,
    /// Height h of the centre of mass, m.
    pub height: f64,
    /// Moment of inertia C about the vertical axis, kg·m².
    pub along: f64,
    /// Moments of inertia S perpendicular to the axis, kg·m².
    pub across: [[f64; 2]; 2],
    /// Radii of curvature R of the surface, m.
    pub radii: [[f64; 2]; 2],
    /// True if all directions perpendicular to the axis are equivalent.
    pub is_symmetric: bool,
    /// Kind of force along the ground.
    pub footing: Footing,
}

/// Threshold of χ, relative to the size of its factors, below which it counts as rounding.
const ALIGNED: f64 = 1e-12;

impl VertexSpin {
    /// Returns the stable spins; `None` with viscous friction if the body is not symmetric.
    pub fn stable_spins(&self) -> Option<StableSpins> {
        if self.is_symmetric {
            return Some(self.of_symmetric());
        }
        if self.footing == Footing::Viscous {
            return None;
        }
        let [a0, a2] = self.coefficients();
        let a4 = determinant(self.inertia());
        let damping = self.damping();
        let discriminant = [
            a2[0] * a2[0] - 4.0 * a4 * a0[0],
            2.0 * a2[0] * a2[1] - 4.0 * a4 * a0[1],
            a2[1] * a2[1] - 4.0 * a4 * a0[2],
        ];
        let of = |[a, b, c]: [f64; 3], x: f64| a + x * (b + x * c);
        let chirality = self.chirality();
        let linear = [a2[0], a2[1], 0.0];
        if chirality == 0.0 {
            let stable = |x: f64| of(a0, x) > 0.0 && of(linear, x) > 0.0 && of(discriminant, x) > 0.0;
            let intervals = intervals(&[a0, linear, discriminant], stable);
            return Some(StableSpins::new(both_senses(&intervals), "a₀ > 0, a₂ > 0, a₂² > 4 a₀ a₄"));
        }
        let stable = |x: f64| of(a0, x) > 0.0 && of(damping, x) > 0.0;
        let mut intervals = intervals(&[a0, damping], stable);
        // Condition a₃ > 0.
        if chirality > 0.0 {
            intervals = intervals.into_iter().rev().map(|[from, to]| [-to, -from]).collect();
        }
        Some(StableSpins::new(
            intervals,
            "−χ Ω > 0, a₀ > 0, Ω² ((tr S − C + m h²) tr G − 2 m h det G) > m g det G",
        ))
    }

    fn of_symmetric(&self) -> StableSpins {
        let (a, c, h, b) = (self.across[0][0], self.along, self.height, self.radii[0][0]);
        let falling = self.mass * self.gravity * (h - b);
        let (about, gyroscopic) = (a + self.moved() * h * h, c + self.moved() * h * b);
        match self.footing {
            Footing::Rolling => StableSpins::where_exceeds(
                gyroscopic * gyroscopic,
                4.0 * about * falling,
                "Ω² > 4 (A + m h²) m g (h − b)/(C + m h b)²",
            ),
            Footing::Frictionless => {
                StableSpins::where_exceeds(c * c, 4.0 * a * falling, "Ω² > 4 A m g (h − b)/C²")
            }
            Footing::Viscous => StableSpins::where_exceeds(
                b * (c * h - a * b),
                falling * h * h,
                "b (C h − A b) Ω² > m g h² (h − b)",
            ),
        }
    }

    /// Returns µ, kg.
    fn moved(&self) -> f64 {
        if self.footing == Footing::Rolling { self.mass } else { 0.0 }
    }

    /// Returns the angle from the longer radius of the surface to the axis of the smaller
    /// perpendicular moment, rad, between −π/2 and π/2; zero for a body that is not a rattleback.
    pub fn skew(&self) -> f64 {
        let direction = |[[a, b], [_, d]]: [[f64; 2]; 2]| 0.5 * libm::atan2(2.0 * b, a - d);
        let [[a, b], [_, d]] = self.across;
        let angle = direction([[-a, -b], [-b, -d]]) - direction(self.radii);
        angle - core::f64::consts::PI * (angle / core::f64::consts::PI).round()
    }

    /// Returns M, kg·m².
    pub fn inertia(&self) -> [[f64; 2]; 2] {
        let [[p, q], [_, s]] = self.across;
        let more = self.moved() * self.height * self.height;
        [[s + more, -q], [-q, p + more]]
    }

    /// Returns G, m.
    pub fn lever(&self) -> [[f64; 2]; 2] {
        let [[p, q], [_, s]] = self.radii;
        [[p - self.height, q], [q, s - self.height]]
    }

    /// Returns the elements p and q of G′ = [[p, q], [q, −p]], m.
    pub(super) fn uneven(&self) -> [f64; 2] {
        let [[p, q], [_, s]] = self.radii;
        [0.5 * (p - s), q]
    }

    /// Returns χ; zero if it is only rounding, and without friction.
    pub(super) fn chirality(&self) -> f64 {
        if self.footing != Footing::Rolling {
            return 0.0;
        }
        let ([[a, b], [_, d]], [p, q]) = (self.across, self.uneven());
        // J G′ = [[−q, p], [p, q]].
        let chirality = (d - a) * q + 2.0 * b * p;
        let size = (a.abs() + b.abs() + d.abs()) * (p.abs() + q.abs());
        if chirality.abs() <= ALIGNED * size { 0.0 } else { chirality }
    }

    /// Returns (x a₂ − x² a₄ − a₀)/(m g) as a polynomial in x.
    fn damping(&self) -> [f64; 3] {
        let ([[a, _], [_, d]], lever) = (self.across, self.lever());
        let [[g0, _], [_, g2]] = lever;
        let carried = self.moved() * self.height;
        let linear =
            (a + d - self.along + carried * self.height) * (g0 + g2) - 2.0 * carried * determinant(lever);
        [-self.mass * self.gravity * determinant(lever), linear, 0.0]
    }

    /// Returns a₀ and a₂ as polynomials in x.
    fn coefficients(&self) -> [[f64; 3]; 2] {
        let ([[a, b], [_, d]], lever) = (self.across, self.lever());
        let (weight, carried) = (self.mass * self.gravity, self.moved() * self.height);
        let still = lever.map(|row| row.map(|x| x * weight));
        let [[g0, g1], [_, g2]] = lever;
        let turning = [
            [carried * g0 + self.along - a, carried * g1 - b],
            [carried * g1 - b, carried * g2 + self.along - d],
        ];
        // tr (adj X Y), the part of det (X + Y) that is linear in both.
        let mixed =
            |[[a, b], [_, d]]: [[f64; 2]; 2], [[p, q], [_, s]]: [[f64; 2]; 2]| a * s + d * p - 2.0 * b * q;
        let m = self.inertia();
        let [p, q] = self.uneven();
        let gyroscopic = a + d - self.along + carried * self.height - 0.5 * carried * (g0 + g2);
        let square = gyroscopic * gyroscopic - carried * carried * (p * p + q * q);
        [
            [determinant(still), mixed(still, turning), determinant(turning)],
            [mixed(m, still), mixed(m, turning) + square, 0.0],
        ]
    }
}

fn determinant([[a, b], [c, d]]: [[f64; 2]; 2]) -> f64 {
    a * d - b * c
}

/// Returns the intervals of |Ω| in which `stable` holds for Ω²; it changes only at zeros of the
/// polynomials.
fn intervals(polynomials: &[[f64; 3]], stable: impl Fn(f64) -> bool) -> Vec<SpinInterval> {
    let mut bounds: Vec<f64> =
        polynomials.iter().flat_map(|polynomial| positive_roots(*polynomial)).collect();
    bounds.sort_by(f64::total_cmp);
    let mut found: Vec<SpinInterval> = Vec::new();
    let mut from = 0.0;
    for to in bounds.into_iter().chain([f64::INFINITY]) {
        let inside = match (from == 0.0, to.is_finite()) {
            (_, true) => 0.5 * (from + to),
            (true, false) => 1.0,
            (false, false) => 2.0 * from,
        };
        if to > from && stable(inside) {
            match found.last_mut() {
                Some(last) if last[1] == from => last[1] = to,
                _ => found.push([from, to]),
            }
        }
        from = to;
    }
    found.into_iter().map(|interval| interval.map(f64::sqrt)).collect()
}

/// Returns the positive roots of a + b x + c x².
fn positive_roots([a, b, c]: [f64; 3]) -> Vec<f64> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return Vec::new();
    }
    let sum = -0.5 * (b + discriminant.sqrt().copysign(b));
    [sum / c, a / sum].into_iter().filter(|x| *x > 0.0 && x.is_finite()).collect()
}
