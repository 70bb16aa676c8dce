//! The recurrence that a motion's Taylor coefficients follow.
//!
//! All that turns with the body goes into two pairs, x and y, whose rates are their products with the components of Ω, each component by its
//! own map Tᵢ of the places, and what is linear or square:
//!
//! ẋ = Σ Ωᵢ Tᵢ x + …,  (n + 1) xₙ₊₁ = Σᵢ Tᵢ (Σₖ xₖ Ωᵢ,ₙ₋ₖ) + …
//!
//! T of a quaternion is half of q ∘ eᵢ; of a vector of space v × eᵢ; of ω the place of (ω2 ω3, ω3 ω1, ω1 ω2) that Ωᵢ has a part in, times
//! (i2 − i3)/i1 and so on. The newest coefficients come in last, by what they are multiplied with: Σ Ωᵢ,₀ Tᵢ xₙ + Σ (Tᵢ x₀) Ωᵢ,ₙ, where the
//! constants are ready. They alone are the chain that the processor waits for.

use super::pair::Pair;
use super::row::{INVERSES, Row, TERMS};
use super::sums::Sums;
use crate::math::number::{MulAdd, Number};

/// x = (q, ω), and no y: there is no vector of space. ω̇ = Tω + c + B ω. ω is a quaternion, (0, ω1, ω2, ω3), so that the places of both change alike:
/// eᵢ exchanges each with the one whose number differs in the bits of i, which takes the processor the least time.
pub(super) const ALONE: u8 = 0;
/// x = (q, u), y = (ω, ω turned), u constant in space: u̇ = u × ω, ω̇ = Tω + c + A u + B ω.
pub(super) const CARRYING: u8 = 1;
/// x = (q, v), y = (ω, u), and y turned: so ω with ω, u with u and ω with u, row by row, are all that ω̇ and u̇ need. u = ρ on a circular orbit:
/// u̇ = u × ω + v, v̇ = v × ω − s u, ω̇ = Tω + c + B ω + G (u2 u3, u3 u1, u1 u2).
pub(super) const MOVING: u8 = 2;
/// x = (q, u), y = (ω, ω turned), u̇ = u × Ω; all of ω̇ but Tω is found elsewhere, and Ω may be another one.
pub(super) const GENERAL: u8 = 3;

/// What a body is multiplied by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms<N> {
    /// (i2 − i3)/i1 … of T.
    pub(super) ratios: Row<N>,
    /// c
    pub(super) constant: Row<N>,
    /// A, diagonal by diagonal: A₁₁ A₂₂ A₃₃, A₁₂ A₂₃ A₃₁, A₁₃ A₂₁ A₃₂.
    pub(super) seen: [Row<N>; 3],
    /// Columns of B, and whether it is zero.
    pub(super) damping: [Row<N>; 3],
    pub(super) is_damped: bool,
    /// s
    pub(super) pull: N,
    /// G
    pub(super) bending: Row<N>,
}

impl<N: Number> Terms<N> {
    pub(super) fn none(zero: N) -> Self {
        let none = Row::splat(zero);
        Self {
            ratios: none,
            constant: none,
            seen: [none; 3],
            damping: [none; 3],
            is_damped: false,
            pull: zero,
            bending: none,
        }
    }
}

/// Coefficient n of all that turns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coefficient<N = f64> {
    pub(super) x: Pair<N>,
    pub(super) y: Pair<N>,
    /// (Ω, 0) of the general layout; both rows of y turned where a vector moves.
    pub(super) turning: Pair<N>,
}

impl<N: Number> Coefficient<N> {
    pub(super) fn all(zero: N) -> Self {
        let none = Pair::splat(zero);
        Self { x: none, y: none, turning: none }
    }

    #[inline(always)]
    pub(super) fn set<const LAYOUT: u8>(&mut self, [x, y]: [Pair<N>; 2]) {
        self.x = x;
        if LAYOUT != ALONE {
            self.y = y;
        }
    }

    /// Ω
    #[inline(always)]
    pub(super) fn turning<const LAYOUT: u8>(&self) -> [N; 3] {
        let [a, b, c, .., d, e, f] = match LAYOUT {
            ALONE => self.x.0,
            GENERAL => self.turning.0,
            _ => self.y.0,
        };
        if LAYOUT == ALONE { [d, e, f] } else { [a, b, c] }
    }
}

/// Coefficients 1 where a vector moves, but for what ω at the start is beyond its rounding.
#[inline(always)]
pub(super) fn moving_start<N: Number>(start: &Coefficient<N>, terms: &Terms<N>) -> [Pair<N>; 2] {
    let (v, omega, u) = (start.x.second(), start.y.first(), start.y.second());
    let [o1, o2, o3, zero] = omega.0;
    let (half, none) = (o1.like(0.5), Row::splat(o1.like(0.0)));
    let cross = |v: Row<N>| {
        let ahead = v.turned();
        ahead.mul_add(omega.turned().turned(), none - ahead.turned() * omega.turned())
    };
    let mut rate = terms.constant;
    for (column, o) in terms.damping.into_iter().zip([o1, o2, o3]) {
        rate = column.mul_add(Row::splat(o), rate);
    }
    rate = (terms.ratios * omega.turned()).mul_add(omega.turned().turned(), rate);
    rate = (terms.bending * u.turned()).mul_add(u.turned().turned(), rate);
    let pulled = Row::splat(-terms.pull).mul_add(u, cross(v));
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
pub(super) trait Recurrence: Sums {
    /// Eight places, in registers.
    type Places: Copy;
    /// The constants of a step: what newest coefficients are multiplied by.
    type Law: Copy;

    fn places(self, pair: &Pair<Self::N>) -> Self::Places;
    fn pair(self, places: Self::Places) -> Pair<Self::N>;

    /// The constants of a step that starts from coefficients 0.
    fn law<const LAYOUT: u8>(self, motion: &Motion<Self::N>, terms: &Terms<Self::N>) -> Self::Law;

    /// Coefficients 1. `low` is what ω at the start is beyond its rounding: it is of no account but here. `more` is a part of ω̇ that is
    /// found elsewhere.
    fn first<const LAYOUT: u8>(
        self,
        law: &Self::Law,
        motion: &Motion<Self::N>,
        terms: &Terms<Self::N>,
        low_and_more: [Row<Self::N>; 2],
    ) -> [Self::Places; 2];

    /// Coefficients n + 1, n ≥ 1, from those before, of which the last two, n − 1 and n, are given; it puts the newest in their places, but for those
    /// of Ω.
    fn next<const LAYOUT: u8>(
        self,
        law: &Self::Law,
        motion: &mut Motion<Self::N>,
        n: usize,
        newest: [[Self::Places; 2]; 2],
        more: Row<Self::N>,
    ) -> [Self::Places; 2];
}

/// Half of q ∘ e1 = (−x, w, z, −y), q ∘ e2 = (−y, −z, w, x), q ∘ e3 = (−z, y, −x, w).
pub(super) const TURN: [[f64; 4]; 3] =
    [[-0.5, 0.5, 0.5, -0.5], [-0.5, -0.5, 0.5, 0.5], [-0.5, 0.5, -0.5, 0.5]];

/// v × e1 = (0, v3, −v2), v × e2 = (−v3, 0, v1), v × e3 = (v2, −v1, 0).
pub(super) const CROSS: [[f64; 4]; 3] = [[0.0, 1.0, -1.0, 0.0], [-1.0, 0.0, 1.0, 0.0], [1.0, -1.0, 0.0, 0.0]];

/// ω3 Ω1 belongs to ω̇2, ω1 Ω2 to ω̇3, ω2 Ω3 to ω̇1.
pub(super) const EULER: [[f64; 4]; 3] = [[0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 0.0]];

/// x/n, as exact as a quotient where it matters: coefficients n ≥ 8 are too small to show that 1/n is rounded, always to the same side.
#[inline(always)]
pub(super) fn over<N: Number>(x: N, n: usize) -> N {
    let [inverse, rest] = INVERSES[n];
    if n < 8 { x.mul_add(x.like(inverse), x * x.like(rest)) } else { x * x.like(inverse) }
}
