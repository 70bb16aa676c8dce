//! Taylor recurrence for several bodies. Each SIMD register holds one number of each body.
//!
//! While the newest coefficients are computed there is enough other work, so loops end at the last
//! term. Products with numbers that the layout fixes to zero are omitted. All other operations have
//! the order of `one.rs`. A sum that begins with +0 is not changed by adding zeros. Each lane is
//! therefore bit-identical to its body alone.

use super::pair::Pair;
use super::recurrence::{
    ATTITUDE, Coefficient, EquationConstants, GENERAL, Layout, Motion, Recurrence, WITH_FIXED_VECTOR,
    WITH_ORBIT, mirrored, over, start_on_orbit,
};
use super::row::Row;
use super::sums::SeveralBodies;
use super::unit_product::{CROSS, TURN, plus_product};
use crate::math::machine::Machine;
use crate::math::number::Number;

/// Linear part of the recurrence of a step: its initial values, and the constants of the equations.
#[derive(Clone, Copy)]
pub(super) struct StepJacobian<N> {
    terms: EquationConstants<N>,
    turn: Row<N>,
    omega: Row<N>,
    /// Vectors u and v.
    joint: [Row<N>; 2],
    /// Angular velocity Ω of the axes.
    turning: Row<N>,
}

impl<S: Machine> Recurrence for SeveralBodies<S> {
    type Packed = Pair<S::Many>;
    type StepJacobian = StepJacobian<S::Many>;

    #[inline(always)]
    fn pack(self, pair: &Pair<S::Many>) -> Pair<S::Many> {
        *pair
    }

    #[inline(always)]
    fn unpack(self, pack: Pair<S::Many>) -> Pair<S::Many> {
        pack
    }

    #[inline(always)]
    fn jacobian<const LAYOUT: Layout>(
        self,
        motion: &Motion<S::Many>,
        terms: &EquationConstants<S::Many>,
    ) -> StepJacobian<S::Many> {
        let Parts { turn, omega, joint } = Parts::of::<LAYOUT>([motion[0].x, motion[0].y]);
        StepJacobian { terms: *terms, turn, omega, joint, turning: turning::<LAYOUT, _>(&motion[0]) }
    }

    #[inline(always)]
    fn first<const LAYOUT: Layout>(
        self,
        jacobian: &StepJacobian<S::Many>,
        motion: &Motion<S::Many>,
        terms: &EquationConstants<S::Many>,
        [low, more]: [Row<S::Many>; 2],
    ) -> [Pair<S::Many>; 2] {
        let none = self.none();
        if LAYOUT == WITH_ORBIT {
            let sum = Parts::of::<LAYOUT>(start_on_orbit(&motion[0], terms, more));
            return self
                .plus_newest::<LAYOUT>(jacobian, sum, &Parts { omega: low, ..none }, low)
                .pairs::<LAYOUT>();
        }
        let mut next = jacobian.plus_start::<LAYOUT>(none, jacobian.turning);
        next.omega = next.omega + (terms.constant + more);
        if LAYOUT == WITH_FIXED_VECTOR {
            for (diagonal, factors) in terms.of_joint.iter().enumerate() {
                next.omega = factors.mul_add(diagonal_of(jacobian.joint[0], diagonal), next.omega);
            }
        }
        self.plus_newest::<LAYOUT>(jacobian, next, &Parts { omega: low, ..none }, low).pairs::<LAYOUT>()
    }

    #[inline(always)]
    fn next<const LAYOUT: Layout>(
        self,
        jacobian: &StepJacobian<S::Many>,
        motion: &mut Motion<S::Many>,
        n: usize,
        [_, newest]: [[Pair<S::Many>; 2]; 2],
        more: Option<Row<S::Many>>,
    ) -> [Pair<S::Many>; 2] {
        let (terms, next) = (&jacobian.terms, n + 1);
        let sums = self.sums_before::<LAYOUT>(motion, n);
        motion[n].set::<LAYOUT>(newest);
        let mut sum = sums.rates(&terms.ratios);
        if LAYOUT == WITH_ORBIT {
            sum.omega = terms.products.mul_add(sums.square.cycled(), sum.omega);
            sum.joint[0] = (sums.crossing[1] - sums.crossing[0]).cycled();
        }
        if let Some(more) = more {
            sum.omega = sum.omega + more;
        }
        let new = Parts::of::<LAYOUT>(newest);
        let turning = if LAYOUT == GENERAL { turning::<LAYOUT, _>(&motion[n]) } else { new.omega };
        self.plus_newest::<LAYOUT>(jacobian, sum, &new, turning).over::<LAYOUT>(next).pairs::<LAYOUT>()
    }
}

#[inline(always)]
fn turning<const LAYOUT: Layout, N: Number>(coefficient: &Coefficient<N>) -> Row<N> {
    let [a, b, c] = coefficient.turning::<LAYOUT>();
    Row([a, b, c, a.like(0.0)])
}

/// Returns (u1, u2, u3), (u2, u3, u1) or (u3, u1, u2).
#[inline(always)]
fn diagonal_of<N: Number>(u: Row<N>, diagonal: usize) -> Row<N> {
    match diagonal {
        0 => u,
        1 => u.cycled(),
        _ => u.cycled().cycled(),
    }
}

/// Expanded quantities, one vector each.
#[derive(Clone, Copy)]
struct Parts<N> {
    turn: Row<N>,
    omega: Row<N>,
    /// Vectors u and v.
    joint: [Row<N>; 2],
}

impl<N: Number> Parts<N> {
    #[inline(always)]
    fn of<const LAYOUT: Layout>([x, y]: [Pair<N>; 2]) -> Self {
        let none = Row::splat(x.0[0].like(0.0));
        let (turn, second) = (x.first(), x.second());
        match LAYOUT {
            ATTITUDE => Self { turn, omega: second.imaginary(), joint: [none; 2] },
            WITH_ORBIT => Self { turn, omega: y.first(), joint: [y.second(), second] },
            _ => Self { turn, omega: y.first(), joint: [second, none] },
        }
    }

    #[inline(always)]
    fn pairs<const LAYOUT: Layout>(self) -> [Pair<N>; 2] {
        let Self { turn, omega, joint: [u, v] } = self;
        let none = Row::splat(turn.0[0].like(0.0));
        let omega = omega.vector();
        match LAYOUT {
            ATTITUDE => [Pair::new(turn, omega.pure()); 2],
            WITH_ORBIT => [Pair::new(turn, v.vector()), Pair::new(omega, u.vector())],
            _ => [Pair::new(turn, u.vector()), Pair::new(omega, none)],
        }
    }

    #[inline(always)]
    fn over<const LAYOUT: Layout>(self, n: usize) -> Self {
        let Self { turn, omega, joint: [u, v] } = self;
        let [u, v] = match LAYOUT {
            ATTITUDE => [u, v],
            WITH_ORBIT => [row_over(u, n), row_over(v, n)],
            _ => [row_over(u, n), v],
        };
        Self { turn: row_over(turn, n), omega: row_over(omega, n), joint: [u, v] }
    }

    #[inline(always)]
    fn plus<const LAYOUT: Layout>(self, b: &Self) -> Self {
        let [u, v] = self.joint;
        let joint = match LAYOUT {
            ATTITUDE => [u, v],
            _ => [u + b.joint[0], v],
        };
        Self { turn: self.turn + b.turn, omega: self.omega + b.omega, joint }
    }
}

#[inline(always)]
fn row_over<N: Number>(row: Row<N>, n: usize) -> Row<N> {
    let [x, y, z, w] = row.0;
    Row([over(x, n), over(y, n), over(z, n), over(w, n)])
}

impl<N: Number> StepJacobian<N> {
    /// Like [`SeveralBodies::plus_newest`], for the layout [`ATTITUDE`]. At the start of a step q =
    /// 1, so q ∘ ω contributes ω/2.
    #[inline(always)]
    fn plus_newest_of_attitude(&self, sum: Parts<N>, new: &Parts<N>) -> Parts<N> {
        let EquationConstants { ratios: Row([r1, r2, r3, _]), of_omega: [b1, b2, b3], has_omega, .. } =
            self.terms;
        let ([b1, b2, b3], Row([o1, o2, o3, _]), Row([w1, w2, w3, _])) =
            ([b1.0, b2.0, b3.0], self.turning, new.omega);
        let Row([x, y, z, zero]) = sum.omega;
        // ∂ω̇ᵢ/∂ωⱼ
        let (mut d12, mut d13, mut d21) = (o3 * r1, o2 * r1, o3 * r2);
        let (mut d23, mut d31, mut d32) = (o1 * r2, o2 * r3, o1 * r3);
        let mut own = [zero; 3];
        if has_omega {
            (d12, d13, d21) = (o3.mul_add(r1, b2[0]), o2.mul_add(r1, b3[0]), o3.mul_add(r2, b1[1]));
            (d23, d31, d32) = (o1.mul_add(r2, b3[1]), o2.mul_add(r3, b1[2]), o1.mul_add(r3, b2[2]));
            own = [b1[0] * w1, b2[1] * w2, b3[2] * w3];
        }
        let omega = Row([
            (d13 * w3 + x) + d12.mul_add(w2, own[0]),
            (d23 * w3 + y) + d21.mul_add(w1, own[1]),
            (d31.mul_add(w1, d32 * w2) + z) + own[2],
            zero,
        ]);
        let Row([a, b, c, d]) = sum.turn;
        let (half_turning, Row([_, k1, k2, k3])) = (half(self.turning), half(new.omega).pure());
        // ω/2 and q ∘ e3 Ω3 are added last.
        let [last0, last1, last2, last3] = [
            third_of_turn(new.turn, half_turning, 0, None),
            third_of_turn(new.turn, half_turning, 1, Some(k1)),
            third_of_turn(new.turn, half_turning, 2, Some(k2)),
            third_of_turn(new.turn, half_turning, 3, Some(k3)),
        ];
        let turn = Row([
            (two_of_turn(new.turn, half_turning, 0, None) + a) + last0,
            (two_of_turn(new.turn, half_turning, 1, None) + b) + last1,
            (two_of_turn(new.turn, half_turning, 2, None) + c) + last2,
            (two_of_turn(new.turn, half_turning, 3, None) + d) + last3,
        ]);
        Parts { turn, omega, joint: sum.joint }
    }

    /// Like [`SeveralBodies::plus_newest`], for the layout [`WITH_ORBIT`].
    #[inline(always)]
    fn plus_newest_on_orbit(&self, sum: Parts<N>, new: &Parts<N>) -> Parts<N> {
        let EquationConstants {
            ratios,
            of_omega: [Row(b1), Row(b2), Row(b3)],
            products,
            strength,
            has_omega,
            ..
        } = self.terms;
        let Row([a, b, c, d]) = sum.turn;
        let (half_turning, Row([zero, k1, k2, k3])) = (half(self.turning), half(new.omega).pure());
        let turn = Row([
            two_of_turn(new.turn, half_turning, 0, Some(a)) + third_of_turn(new.turn, half_turning, 0, None),
            two_of_turn(new.turn, half_turning, 1, Some(b + k1))
                + third_of_turn(new.turn, half_turning, 1, None),
            two_of_turn(new.turn, half_turning, 2, Some(c + k2))
                + third_of_turn(new.turn, half_turning, 2, None),
            two_of_turn(new.turn, half_turning, 3, Some(d + k3))
                + third_of_turn(new.turn, half_turning, 3, None),
        ]);
        let none = Row::splat(zero.like(0.0));
        let ([u, v], [start_u, start_v], omega) = (new.joint, self.joint, new.omega);
        let [ahead, behind] = [self.turning.cycled(), self.turning.cycled().cycled()];
        let (mut own, mut first, mut second) = (sum.omega, behind * ratios, ahead * ratios);
        if has_omega {
            own = Row([b1[0], b2[1], b3[2], zero]).mul_add(omega, own);
            first = behind.mul_add(ratios, Row([b2[0], b3[1], b1[2], zero]));
            second = ahead.mul_add(ratios, Row([b3[0], b1[1], b2[2], zero]));
        }
        let own = first.mul_add(diagonal_of(omega, 1), own);
        let more = second * diagonal_of(omega, 2);
        let more = (products * diagonal_of(start_u, 2)).mul_add(diagonal_of(u, 1), more);
        let more = (products * diagonal_of(start_u, 1)).mul_add(diagonal_of(u, 2), more);
        let next_u = behind.mul_add(diagonal_of(u, 1), sum.joint[0] + v);
        let more_u = (none - ahead) * diagonal_of(u, 2);
        let more_u = (none - diagonal_of(start_u, 2)).mul_add(diagonal_of(omega, 1), more_u);
        let more_u = diagonal_of(start_u, 1).mul_add(diagonal_of(omega, 2), more_u);
        let next_v = Row::splat(-strength).mul_add(u, sum.joint[1]);
        let next_v = behind.mul_add(diagonal_of(v, 1), next_v);
        let next_v = (none - ahead).mul_add(diagonal_of(v, 2), next_v);
        let more_v = (none - diagonal_of(start_v, 2)) * diagonal_of(omega, 1);
        let more_v = diagonal_of(start_v, 1).mul_add(diagonal_of(omega, 2), more_v);
        Parts { turn, omega: own + more, joint: [next_u + more_u, next_v + more_v] }
    }

    /// Adds Tᵢ applied to the initial values, times the components of Ω.
    #[inline(always)]
    fn plus_start<const LAYOUT: Layout>(&self, sum: Parts<N>, turning: Row<N>) -> Parts<N> {
        let Row([o1, o2, o3, _]) = turning;
        let Row([w1, w2, w3, _]) = self.omega;
        let Row([r1, r2, r3, _]) = self.terms.ratios;
        let Row([x, y, z, rest]) = sum.omega;
        let omega = if self.terms.has_omega {
            let [Row([a1, a2, a3, _]), Row([b1, b2, b3, _]), Row([c1, c2, c3, _])] = self.terms.of_omega;
            [
                w2.mul_add(r1, c1).mul_add(o3, b1.mul_add(o2, a1.mul_add(o1, x))),
                c2.mul_add(o3, b2.mul_add(o2, w3.mul_add(r2, a2).mul_add(o1, y))),
                c3.mul_add(o3, w1.mul_add(r3, b3).mul_add(o2, a3.mul_add(o1, z))),
            ]
        } else {
            [(w2 * r1).mul_add(o3, x), (w3 * r2).mul_add(o1, y), (w1 * r3).mul_add(o2, z)]
        };
        let [u, v] = sum.joint;
        let joint = match LAYOUT {
            ATTITUDE => [u, v],
            _ => [plus_product(&CROSS, u, self.joint[0], turning), v],
        };
        let [x, y, z] = omega;
        Parts {
            turn: plus_product(&TURN, sum.turn, half(self.turn), turning),
            omega: Row([x, y, z, rest]),
            joint,
        }
    }

    /// Adds Tᵢ applied to the newest coefficients, times the components of Ω at the start.
    #[inline(always)]
    fn plus_turned<const LAYOUT: Layout>(&self, sum: Parts<N>, new: &Parts<N>) -> Parts<N> {
        let Row([o1, o2, o3, _]) = self.turning;
        let Row([r1, r2, r3, _]) = self.terms.ratios;
        let (Row([x, y, z, rest]), Row([w1, w2, w3, _])) = (sum.omega, new.omega);
        let omega = [(r1 * o3).mul_add(w2, x), (r2 * o1).mul_add(w3, y), (r3 * o2).mul_add(w1, z)];
        let [u, v] = sum.joint;
        let joint = match LAYOUT {
            ATTITUDE => [u, v],
            _ => [plus_product(&CROSS, u, new.joint[0], self.turning), v],
        };
        let [x, y, z] = omega;
        Parts {
            turn: plus_product(&TURN, sum.turn, new.turn, half(self.turning)),
            omega: Row([x, y, z, rest]),
            joint,
        }
    }
}

/// Returns number i of q ∘ e for the unit vector of an axis; none of these is always zero.
#[inline(always)]
fn turned<N: Number>(q: Row<N>, axis: usize, i: usize) -> N {
    match TURN[axis].number(q, i) {
        Some(number) => number,
        None => q.0[i],
    }
}

/// Returns number i of q ∘ e1 Ω1 + q ∘ e2 Ω2, plus `sum` if given.
#[inline(always)]
fn two_of_turn<N: Number>(q: Row<N>, turning: Row<N>, i: usize, sum: Option<N>) -> N {
    let [o1, o2, ..] = turning.0;
    let first = match sum {
        Some(sum) => turned(q, 0, i).mul_add(o1, sum),
        None => turned(q, 0, i) * o1,
    };
    turned(q, 1, i).mul_add(o2, first)
}

/// Returns number i of q ∘ e3 Ω3, plus `sum` if given.
#[inline(always)]
fn third_of_turn<N: Number>(q: Row<N>, turning: Row<N>, i: usize, sum: Option<N>) -> N {
    let [.., o3, _] = turning.0;
    match sum {
        Some(sum) => turned(q, 2, i).mul_add(o3, sum),
        None => turned(q, 2, i) * o3,
    }
}

#[inline(always)]
fn half<N: Number>(row: Row<N>) -> Row<N> {
    let [x, y, z, w] = row.0;
    let half = x.like(0.5);
    Row([x * half, y * half, z * half, w * half])
}

/// Sums of products of coefficients.
///
/// - `turn`: the quaternion times each component of Ω.
/// - `omega`: (ω3 Ω1, ω1 Ω2, ω2 Ω3).
/// - `joint`: for u and v, the two other components times each component of Ω.
/// - `square`, `crossing`: u times u cycled; ω times u cycled and u times ω cycled (orbit only).
#[derive(Clone, Copy)]
struct ProductSums<N> {
    turn: [Row<N>; 3],
    omega: Row<N>,
    joint: [[[N; 2]; 3]; 2],
    square: Row<N>,
    crossing: [Row<N>; 2],
}

impl<S: Machine> SeveralBodies<S> {
    /// Adds the contribution of the newest coefficients through those at the start: Σ Ωᵢ Tᵢ x, Σ
    /// (Tᵢ x₀) Ωᵢ, and the linear part.
    #[inline(always)]
    fn plus_newest<const LAYOUT: Layout>(
        self,
        jacobian: &StepJacobian<S::Many>,
        sum: Parts<S::Many>,
        new: &Parts<S::Many>,
        turning: Row<S::Many>,
    ) -> Parts<S::Many> {
        if LAYOUT == ATTITUDE {
            return jacobian.plus_newest_of_attitude(sum, new);
        }
        if LAYOUT == WITH_ORBIT {
            return jacobian.plus_newest_on_orbit(sum, new);
        }
        let terms = &jacobian.terms;
        let starts = jacobian.plus_start::<LAYOUT>(self.none(), turning);
        let mut sum = jacobian.plus_turned::<LAYOUT>(sum, new).plus::<LAYOUT>(&starts);
        if LAYOUT == WITH_FIXED_VECTOR {
            let (u, [a, b, c]) = (new.joint[0], terms.of_joint);
            let diagonal_of =
                c.mul_add(diagonal_of(u, 2), b.mul_add(diagonal_of(u, 1), a * diagonal_of(u, 0)));
            sum.omega = sum.omega + diagonal_of;
        }
        sum
    }

    #[inline(always)]
    fn none(self) -> Parts<S::Many> {
        let none = Row::splat(self.0.many(0.0));
        Parts { turn: none, omega: none, joint: [none; 2] }
    }

    /// Returns the sums of products of coefficients 1 … n − 1.
    #[inline(always)]
    fn sums_before<const LAYOUT: Layout>(self, motion: &Motion<S::Many>, n: usize) -> ProductSums<S::Many> {
        let zero = self.0.many(0.0);
        let none = Row::splat(zero);
        let joint = [[[zero; 2]; 3]; 2];
        let none = ProductSums { turn: [none; 3], omega: none, joint, square: none, crossing: [none; 2] };
        let (mut up, mut down) = (none, none);
        let (middle, [ups, downs]) = mirrored(motion, n);
        if let Some(middle) = middle {
            up = up.plus::<LAYOUT>(middle, middle);
        }
        for (a, b) in ups.iter().zip(downs.iter().rev()) {
            up = up.plus::<LAYOUT>(a, b);
        }
        for (a, b) in ups.iter().zip(downs.iter().rev()) {
            down = down.plus::<LAYOUT>(b, a);
        }
        up.and::<LAYOUT>(&down)
    }
}

impl<N: Number> ProductSums<N> {
    #[inline(always)]
    fn plus<const LAYOUT: Layout>(mut self, a: &Coefficient<N>, b: &Coefficient<N>) -> Self {
        let ([o1, o2, o3], [other_omega, other_u]) = (b.turning::<LAYOUT>(), [b.y.first(), b.y.second()]);
        let Coefficient { x, y, .. } = a;
        let q = x.first();
        let omega = if LAYOUT == ATTITUDE { x.second().imaginary() } else { y.first() };
        let [q1, q2, q3] = self.turn;
        self.turn =
            [q.mul_add(Row::splat(o1), q1), q.mul_add(Row::splat(o2), q2), q.mul_add(Row::splat(o3), q3)];
        let ([w1, w2, w3, _], [a, b, c, zero]) = (omega.0, self.omega.0);
        self.omega = Row([w3.mul_add(o1, a), w1.mul_add(o2, b), w2.mul_add(o3, c), zero]);
        if LAYOUT != ATTITUDE {
            let part = if LAYOUT == WITH_ORBIT { 1 } else { 0 };
            self.joint[part] = plus_others(self.joint[part], x.second(), [o1, o2, o3]);
        }
        if LAYOUT == WITH_ORBIT {
            let u = y.second();
            self.square = u.mul_add(other_u.cycled(), self.square);
            let [first, second] = self.crossing;
            self.crossing = [omega.mul_add(other_u.cycled(), first), u.mul_add(other_omega.cycled(), second)];
        }
        self
    }

    /// Adds the two sums.
    #[inline(always)]
    fn and<const LAYOUT: Layout>(mut self, b: &Self) -> Self {
        for axis in 0..3 {
            self.turn[axis] = self.turn[axis] + b.turn[axis];
            for part in 0..2 {
                if LAYOUT == WITH_ORBIT && part == 1
                    || (LAYOUT == WITH_FIXED_VECTOR || LAYOUT == GENERAL) && part == 0
                {
                    for k in 0..2 {
                        self.joint[part][axis][k] = self.joint[part][axis][k] + b.joint[part][axis][k];
                    }
                }
            }
        }
        self.omega = self.omega + b.omega;
        if LAYOUT == WITH_ORBIT {
            self.square = self.square + b.square;
            self.crossing = [self.crossing[0] + b.crossing[0], self.crossing[1] + b.crossing[1]];
        }
        self
    }

    /// Returns Σ Tᵢ applied to the sums.
    #[inline(always)]
    fn rates(&self, ratios: &Row<N>) -> Parts<N> {
        let [first, second, third] = [half(self.turn[0]), half(self.turn[1]), half(self.turn[2])];
        let turn = Row([
            (turned(first, 0, 0) + turned(second, 1, 0)) + turned(third, 2, 0),
            (turned(first, 0, 1) + turned(second, 1, 1)) + turned(third, 2, 1),
            (turned(first, 0, 2) + turned(second, 1, 2)) + turned(third, 2, 2),
            (turned(first, 0, 3) + turned(second, 1, 3)) + turned(third, 2, 3),
        ]);
        // The sums (ω3 Ω1, ω1 Ω2, ω2 Ω3) belong to ω̇2, ω̇3, ω̇1.
        let omega = *ratios * self.omega.cycled().cycled();
        let [u, v] = self.joint;
        Parts { turn, omega, joint: [cross(u), cross(v)] }
    }
}

/// Adds the two other components of v, times Ωᵢ, for each i.
#[inline(always)]
fn plus_others<N: Number>(sums: [[N; 2]; 3], v: Row<N>, [o1, o2, o3]: [N; 3]) -> [[N; 2]; 3] {
    let ([a, b, c, _], [p, q, r]) = (v.0, sums);
    [
        [b.mul_add(o1, p[0]), c.mul_add(o1, p[1])],
        [a.mul_add(o2, q[0]), c.mul_add(o2, q[1])],
        [a.mul_add(o3, r[0]), b.mul_add(o3, r[1])],
    ]
}

/// Returns v × Ω from these sums.
#[inline(always)]
fn cross<N: Number>([[b1, c1], [a2, c2], [a3, b3]]: [[N; 2]; 3]) -> Row<N> {
    Row([b3 - c2, c1 - a3, a2 - b1, b1.like(0.0)])
}
