//! Recurrence of the Taylor coefficients of a motion.
//!
//! All quantities that rotate with the body are packed in two pairs of rows, x and y. Their rates
//! are products with the components of Ω, with one linear map Tᵢ per component, plus linear and
//! quadratic terms:
//!
//! ẋ = Σ Ωᵢ Tᵢ x + …,  (n + 1) xₙ₊₁ = Σᵢ Tᵢ (Σₖ xₖ Ωᵢ,ₙ₋ₖ) + …
//!
//! Tᵢ applied to a quaternion q is ½ q ∘ eᵢ, and applied to a space vector v it is v × eᵢ. Applied
//! to ω, it selects the products in (ω2 ω3, ω3 ω1, ω1 ω2) that contain Ωᵢ, times (i2 − i3)/i1 and
//! its permutations.
//!
//! The newest coefficients are added last, with factors that are constant in a step: Σ Ωᵢ,₀ Tᵢ xₙ +
//! Σ (Tᵢ x₀) Ωᵢ,ₙ. Only these terms form the dependency chain that limits the speed.

use super::pair::Pair;
use super::row::{INVERSES, Row, TERMS};
use super::sums::SeriesSums;
use crate::math::number::Number;

/// Layout of the pairs: a const parameter, because each layout is compiled separately.
///
/// There are three packings of eight numbers. q is the rotation since the start of the step; a row
/// with a vector ends with 0.
///
/// ```text
/// ATTITUDE            x = q0 q1 q2 q3 | 0  ω1 ω2 ω3
/// WITH_FIXED_VECTOR   x = q0 q1 q2 q3 | u1 u2 u3 0      y = ω1 ω2 ω3 0 | ω2 ω3 ω1 0
/// WITH_ORBIT          x = q0 q1 q2 q3 | v1 v2 v3 0      y = ω1 ω2 ω3 0 | u1 u2 u3 0
/// ```
pub(super) type Layout = u8;
/// Layout without a vector other than ω: ω̇ = Tω + c + B ω.
///
/// ω is stored as a quaternion, so that both rows are permuted in the same way. eᵢ exchanges the
/// elements whose indices differ in the bits of i, which is the fastest permutation.
pub(super) const ATTITUDE: Layout = 0;
/// Layout with a vector u that is fixed in space: u̇ = u × ω, ω̇ = Tω + c + A u + B ω. y contains ω
/// and its cyclic permutation, whose product is needed for Tω.
pub(super) const WITH_FIXED_VECTOR: Layout = 1;
/// Layout with u = ρ on a circular orbit and its rate v: u̇ = u × ω + v, v̇ = v × ω − s u,
/// ω̇ = Tω + c + B ω + (g1 u2 u3, g2 u3 u1, g3 u1 u2).
///
/// Products of y with y permuted, row by row, contain ω with ω, u with u, and ω with u. They are
/// all that ω̇ and u̇ need.
pub(super) const WITH_ORBIT: Layout = 2;
/// General layout, packed as with a fixed vector: u̇ = u × Ω. All of ω̇ except Tω is computed
/// elsewhere, and Ω may differ from ω.
pub(super) const GENERAL: Layout = 3;

/// Constants of the equations of motion of a body.
#[derive(Clone, Copy, Debug)]
pub(super) struct EquationConstants<N> {
    /// Ratios (i2 − i3)/i1, (i3 − i1)/i2, (i1 − i2)/i3 in T.
    pub(super) ratios: Row<N>,
    /// Constant term c of ω̇.
    pub(super) constant: Row<N>,
    /// Matrix A by diagonals: A₁₁ A₂₂ A₃₃, A₁₂ A₂₃ A₃₁, A₁₃ A₂₁ A₃₂.
    pub(super) of_joint: [Row<N>; 3],
    /// Columns of B.
    pub(super) of_omega: [Row<N>; 3],
    /// True if B is not zero.
    pub(super) has_omega: bool,
    /// s = µ/r³.
    pub(super) strength: N,
    /// Coefficients g of the products of components of u.
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

/// Coefficient n of all quantities that rotate with the body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coefficient<N = f64> {
    pub(super) x: Pair<N>,
    pub(super) y: Pair<N>,
    /// (Ω, 0) in the general layout; both rows of y permuted in the layout with an orbit.
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

    /// Returns Ω.
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

/// Returns coefficients 1 for the layout with an orbit, without the contribution of the low word of
/// ω. `more`: part of ω̇ that is computed elsewhere.
#[inline(always)]
pub(super) fn start_on_orbit<N: Number>(
    start: &Coefficient<N>,
    terms: &EquationConstants<N>,
    more: Row<N>,
) -> [Pair<N>; 2] {
    let (v, omega, u) = (start.x.second(), start.y.first(), start.y.second());
    let [o1, o2, o3, zero] = omega.0;
    let (half, none) = (o1.like(0.5), Row::splat(o1.like(0.0)));
    let cross = |v: Row<N>| {
        let ahead = v.cycled();
        ahead.mul_add(omega.cycled().cycled(), none - ahead.cycled() * omega.cycled())
    };
    let mut rate = terms.constant + more;
    for (column, o) in terms.of_omega.into_iter().zip([o1, o2, o3]) {
        rate = column.mul_add(Row::splat(o), rate);
    }
    rate = (terms.ratios * omega.cycled()).mul_add(omega.cycled().cycled(), rate);
    rate = (terms.products * u.cycled()).mul_add(u.cycled().cycled(), rate);
    let pulled = Row::splat(-terms.strength).mul_add(u, cross(v));
    let turn = Row([zero, half * o1, half * o2, half * o3]);
    [Pair::new(turn, pulled), Pair::new(rate, cross(u) + v)]
}

/// Taylor coefficients of the rotating quantities, in ascending order.
pub(super) type Motion<N = f64> = [Coefficient<N>; TERMS];

/// Splits the coefficients 1 … n − 1 for the sums of products, which start with the oldest
/// coefficients.
///
/// The sums contain `middle` times itself, if n is even, and then the products of each of `ups`
/// with its mirror image in `downs`, in both orders. Each product occurs once.
#[inline(always)]
pub(super) fn mirrored<N>(motion: &Motion<N>, n: usize) -> (Option<&Coefficient<N>>, [&[Coefficient<N>]; 2]) {
    let count = (n - 1) / 2;
    let middle = if n.is_multiple_of(2) { Some(&motion[n / 2]) } else { None };
    (middle, [&motion[n - count..n], &motion[1..=count]])
}

/// Implementation of the recurrence.
pub(super) trait Recurrence: SeriesSums {
    /// Eight numbers in registers.
    type Packed: Copy;
    /// Constants of a step: the factors of the newest coefficients.
    type StepJacobian: Copy;

    fn pack(self, pair: &Pair<Self::N>) -> Self::Packed;
    fn unpack(self, pack: Self::Packed) -> Pair<Self::N>;

    /// Computes the constants of a step that starts from coefficients 0.
    fn jacobian<const LAYOUT: Layout>(
        self,
        motion: &Motion<Self::N>,
        terms: &EquationConstants<Self::N>,
    ) -> Self::StepJacobian;

    /// Returns coefficients 1. `low_and_more`: the low word of ω at the start, which matters only
    /// here, and a part of ω̇ that is computed elsewhere.
    fn first<const LAYOUT: Layout>(
        self,
        jacobian: &Self::StepJacobian,
        motion: &Motion<Self::N>,
        terms: &EquationConstants<Self::N>,
        low_and_more: [Row<Self::N>; 2],
    ) -> [Self::Packed; 2];

    /// Returns coefficients n + 1, n ≥ 1. `newest` holds the packed coefficients n − 1 and n. The
    /// function stores the latter in `motion`, except for those of Ω. `more`: coefficient n of a
    /// part of ω̇ that is computed elsewhere, if there is one.
    fn next<const LAYOUT: Layout>(
        self,
        jacobian: &Self::StepJacobian,
        motion: &mut Motion<Self::N>,
        n: usize,
        newest: [[Self::Packed; 2]; 2],
        more: Option<Row<Self::N>>,
    ) -> [Self::Packed; 2];
}

/// Returns x/n, rounded like a quotient for n < 8. For n ≥ 8 the coefficients are too small for the
/// constant rounding error of 1/n to matter.
#[inline(always)]
pub(super) fn over<N: Number>(x: N, n: usize) -> N {
    let [inverse, rest] = INVERSES[n];
    if n < 8 { x.mul_add(x.like(inverse), x * x.like(rest)) } else { x * x.like(inverse) }
}
