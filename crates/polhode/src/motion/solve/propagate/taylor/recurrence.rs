//! The recurrence that a motion's Taylor coefficients follow.
//!
//! All that turns with the body goes into two pairs, x and y, whose rates are their products with the components of Ω, each component by its
//! own map Tᵢ of the pack, and what is linear or square:
//!
//! ẋ = Σ Ωᵢ Tᵢ x + …,  (n + 1) xₙ₊₁ = Σᵢ Tᵢ (Σₖ xₖ Ωᵢ,ₙ₋ₖ) + …
//!
//! T of a quaternion is half of q ∘ eᵢ; of a vector of space v × eᵢ; of ω the place of (ω2 ω3, ω3 ω1, ω1 ω2) that Ωᵢ has a part in, times
//! (i2 − i3)/i1 and so on. The newest coefficients come in last, by what they are multiplied with: Σ Ωᵢ,₀ Tᵢ xₙ + Σ (Tᵢ x₀) Ωᵢ,ₙ, where the
//! constants are ready. They alone are the chain that the processor waits for.

use super::pair::Pair;
use super::row::{INVERSES, Row, TERMS};
use super::sums::SeriesSums;
use crate::math::number::Number;

/// What is packed where: a const parameter, as each layout is compiled by itself.
///
/// Three packings, of eight numbers each (q is the turn since the start of the step, a row of vectors ends with 0):
///
/// ```text
/// ATTITUDE            x = q0 q1 q2 q3 | 0  ω1 ω2 ω3
/// WITH_FIXED_VECTOR   x = q0 q1 q2 q3 | u1 u2 u3 0      y = ω1 ω2 ω3 0 | ω2 ω3 ω1 0
/// WITH_ORBIT          x = q0 q1 q2 q3 | v1 v2 v3 0      y = ω1 ω2 ω3 0 | u1 u2 u3 0
/// ```
pub(super) type Layout = u8;
/// No vector but ω: ω̇ = Tω + c + B ω. ω is a quaternion here, so that the places of both halves change alike: eᵢ exchanges each with the one
/// whose number differs in the bits of i, which takes the processor the least time.
pub(super) const ATTITUDE: Layout = 0;
/// u is fixed in space: u̇ = u × ω, ω̇ = Tω + c + A u + B ω. y has ω beside its cyclic permutation, whose product is what Tω needs.
pub(super) const WITH_FIXED_VECTOR: Layout = 1;
/// u = ρ on a circular orbit, v its rate: u̇ = u × ω + v, v̇ = v × ω − s u, ω̇ = Tω + c + B ω + (g1 u2 u3, g2 u3 u1, g3 u1 u2). With y and y
/// permuted there are ω with ω, u with u and ω with u, row by row, all that ω̇ and u̇ need.
pub(super) const WITH_ORBIT: Layout = 2;
/// Packed as with a fixed vector, u̇ = u × Ω; all of ω̇ but Tω is found elsewhere, and Ω may be another one than ω.
pub(super) const GENERAL: Layout = 3;

/// The constants of the equations of motion of a body.
#[derive(Clone, Copy, Debug)]
pub(super) struct EquationConstants<N> {
    /// (i2 − i3)/i1 … of T.
    pub(super) ratios: Row<N>,
    /// c
    pub(super) constant: Row<N>,
    /// A, diagonal by diagonal: A₁₁ A₂₂ A₃₃, A₁₂ A₂₃ A₃₁, A₁₃ A₂₁ A₃₂.
    pub(super) of_joint: [Row<N>; 3],
    /// Columns of B, and whether there is one.
    pub(super) of_omega: [Row<N>; 3],
    pub(super) has_omega: bool,
    /// s = µ/r³
    pub(super) strength: N,
    /// g
    pub(super) products: Row<N>,
}

impl<N: Number> EquationConstants<N> {
    pub(super) fn none(zero: N) -> Self {
        let none = Row::splat(zero);
        Self {
            ratios: none,
            constant: none,
            of_joint: [none; 3],
            of_omega: [none; 3],
            has_omega: false,
            strength: zero,
            products: none,
        }
    }
}

/// Coefficient n of all that turns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coefficient<N = f64> {
    pub(super) x: Pair<N>,
    pub(super) y: Pair<N>,
    /// (Ω, 0) of the general layout; both rows of y permuted with an orbit.
    pub(super) turning: Pair<N>,
}

impl<N: Number> Coefficient<N> {
    pub(super) fn all(zero: N) -> Self {
        let none = Pair::splat(zero);
        Self { x: none, y: none, turning: none }
    }

    #[inline(always)]
    pub(super) fn set<const LAYOUT: Layout>(&mut self, [x, y]: [Pair<N>; 2]) {
        self.x = x;
        if LAYOUT != ATTITUDE {
            self.y = y;
        }
    }

    /// Ω
    #[inline(always)]
    pub(super) fn turning<const LAYOUT: Layout>(&self) -> [N; 3] {
        let [a, b, c, .., d, e, f] = match LAYOUT {
            ATTITUDE => self.x.0,
            GENERAL => self.turning.0,
            _ => self.y.0,
        };
        if LAYOUT == ATTITUDE { [d, e, f] } else { [a, b, c] }
    }
}

/// Coefficients 1 with an orbit, but for what ω at the start is beyond its rounding.
#[inline(always)]
pub(super) fn start_on_orbit<N: Number>(
    start: &Coefficient<N>,
    terms: &EquationConstants<N>,
) -> [Pair<N>; 2] {
    let (v, omega, u) = (start.x.second(), start.y.first(), start.y.second());
    let [o1, o2, o3, zero] = omega.0;
    let (half, none) = (o1.like(0.5), Row::splat(o1.like(0.0)));
    let cross = |v: Row<N>| {
        let ahead = v.cycled();
        ahead.mul_add(omega.cycled().cycled(), none - ahead.cycled() * omega.cycled())
    };
    let mut rate = terms.constant;
    for (column, o) in terms.of_omega.into_iter().zip([o1, o2, o3]) {
        rate = column.mul_add(Row::splat(o), rate);
    }
    rate = (terms.ratios * omega.cycled()).mul_add(omega.cycled().cycled(), rate);
    rate = (terms.products * u.cycled()).mul_add(u.cycled().cycled(), rate);
    let pulled = Row::splat(-terms.strength).mul_add(u, cross(v));
    let turn = Row([zero, half * o1, half * o2, half * o3]);
    [Pair::new(turn, pulled), Pair::new(rate, cross(u) + v)]
}

/// The Taylor coefficients of what turns, from the constants on.
pub(super) type Motion<N = f64> = [Coefficient<N>; TERMS];

/// The sums of products begin with the oldest coefficients, in the middle, and go outward to the newest: products of `middle` with itself, if n is
/// even, then of each of `ups` with the one of `downs` in the mirror, both ways. All of 1 … n − 1 is in them once.
#[inline(always)]
pub(super) fn mirrored<N>(motion: &Motion<N>, n: usize) -> (Option<&Coefficient<N>>, [&[Coefficient<N>]; 2]) {
    let count = (n - 1) / 2;
    let middle = if n.is_multiple_of(2) { Some(&motion[n / 2]) } else { None };
    (middle, [&motion[n - count..n], &motion[1..=count]])
}

/// How the recurrence is worked out.
pub(super) trait Recurrence: SeriesSums {
    /// Eight numbers, in registers.
    type Packed: Copy;
    /// The constants of a step: what newest coefficients are multiplied by.
    type StepJacobian: Copy;

    fn pack(self, pair: &Pair<Self::N>) -> Self::Packed;
    fn unpack(self, pack: Self::Packed) -> Pair<Self::N>;

    /// The constants of a step that starts from coefficients 0.
    fn jacobian<const LAYOUT: Layout>(
        self,
        motion: &Motion<Self::N>,
        terms: &EquationConstants<Self::N>,
    ) -> Self::StepJacobian;

    /// Coefficients 1. `low` is what ω at the start is beyond its rounding: it is of no account but here. `more` is a part of ω̇ that is
    /// found elsewhere.
    fn first<const LAYOUT: Layout>(
        self,
        jacobian: &Self::StepJacobian,
        motion: &Motion<Self::N>,
        terms: &EquationConstants<Self::N>,
        low_and_more: [Row<Self::N>; 2],
    ) -> [Self::Packed; 2];

    /// Coefficients n + 1, n ≥ 1, from those before, of which the last two, n − 1 and n, are given; it puts the newest in their pack, but for those
    /// of Ω.
    fn next<const LAYOUT: Layout>(
        self,
        jacobian: &Self::StepJacobian,
        motion: &mut Motion<Self::N>,
        n: usize,
        newest: [[Self::Packed; 2]; 2],
        more: Row<Self::N>,
    ) -> [Self::Packed; 2];
}

/// x/n, as exact as a quotient where it matters: coefficients n ≥ 8 are too small to show that 1/n is rounded, always to the same side.
#[inline(always)]
pub(super) fn over<N: Number>(x: N, n: usize) -> N {
    let [inverse, rest] = INVERSES[n];
    if n < 8 { x.mul_add(x.like(inverse), x * x.like(rest)) } else { x * x.like(inverse) }
}
