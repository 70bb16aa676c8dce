//! Taylor recurrence for a single body. Each SIMD register holds two rows.
//!
//! The recurrence is latency-bound: coefficient n + 1 needs coefficient n. Each step therefore
//! first accumulates all products without coefficient n, and adds the others at the end.

use super::pair::Pair;
use super::recurrence::{
    ATTITUDE, Coefficient, EquationConstants, GENERAL, Layout, Motion, Recurrence, WITH_FIXED_VECTOR,
    WITH_ORBIT, mirrored, over, start_on_orbit,
};
use super::row::Row;
use super::sums::OneBody;
use super::unit_product::{CROSS, EULER, TURN, places};
use crate::math::machine::Machine;
use crate::math::number::Number;

/// Linear part of the recurrence of a step: factors of its newest coefficients, and its initial
/// values.
#[derive(Clone, Copy)]
pub(super) struct StepJacobian<E> {
    /// Linear maps Tᵢ applied to x and to y (with an orbit, to products).
    maps: [[E; 3]; 2],
    /// Jacobian with respect to the newest x and y: Ωᵢ,₀ Tᵢ.
    of_newest: [[E; 3]; 2],
    /// Jacobian with respect to the newest Ωᵢ: Tᵢ x₀ and Tᵢ y₀, plus column i of B.
    of_start: [[E; 3]; 2],
    /// Matrix A by diagonals, from u to ω̇; in the layout [`ATTITUDE`], the map from ω to q̇.
    diagonal: [E; 3],
    /// Factors for the layout [`WITH_ORBIT`], of x and of y, in the order of
    /// [`OneBody::plus_newest_on_orbit`].
    on_orbit: [[E; 5]; 2],
}

/// Indices that repeat row 2.
const SECOND_TWICE: [usize; 8] = [4, 5, 6, 7, 4, 5, 6, 7];

/// Indices of u in row 2 as (u1, u2, u3), (u2, u3, u1) or (u3, u1, u2), then the same cycled once
/// more.
const DIAGONALS: [[usize; 8]; 3] =
    [[4, 5, 6, 7, 5, 6, 4, 7], [5, 6, 4, 7, 6, 4, 5, 7], [6, 4, 5, 7, 4, 5, 6, 7]];

/// Indices in row 1 of the factors that multiply Ωᵢ in ω̇, then the same cycled.
const EULER_WITH_CYCLED: [[usize; 8]; 3] = {
    let [[a, b, c, d], [e, f, g, h], [i, j, k, l]] = [CROSS[0].from, CROSS[1].from, CROSS[2].from];
    [[a, b, c, d, b, c, a, d], [e, f, g, h, f, g, e, h], [i, j, k, l, j, k, i, l]]
};

impl<S: Machine> Recurrence for OneBody<S> {
    type Packed = S::Eight;
    type StepJacobian = StepJacobian<S::Eight>;

    #[inline(always)]
    fn pack(self, pair: &Pair) -> S::Eight {
        self.0.load_eight(&pair.0)
    }

    #[inline(always)]
    fn unpack(self, pack: S::Eight) -> Pair {
        Pair(self.0.eight_numbers(pack))
    }

    #[inline(always)]
    fn jacobian<const LAYOUT: Layout>(
        self,
        motion: &Motion,
        terms: &EquationConstants<f64>,
    ) -> StepJacobian<S::Eight> {
        let s = self.0;
        let zero = s.eight(0.0);
        let half_turn = TURN.map(|product| Row(product.signs) * Row([0.5; 4]));
        let (x, y) = (self.pack(&motion[0].x), self.pack(&motion[0].y));
        let [o1, o2, o3] = motion[0].turning::<LAYOUT>();
        let omega = [s.eight(o1), s.eight(o2), s.eight(o3)];
        let (none, ratios) = (Row::ZERO, terms.ratios);
        let mut jacobian = StepJacobian {
            maps: [[zero; 3]; 2],
            of_newest: [[zero; 3]; 2],
            of_start: [[zero; 3]; 2],
            diagonal: [zero; 3],
            on_orbit: [[zero; 5]; 2],
        };
        for axis in 0..3 {
            let (euler, of_omega) = (Row(EULER[axis]) * ratios, terms.of_omega[axis]);
            let beside = if LAYOUT == ATTITUDE { euler.pure() } else { Row(CROSS[axis].signs) };
            let map = self.pair_of(half_turn[axis], beside);
            jacobian.maps[0][axis] = map;
            jacobian.of_newest[0][axis] = map * omega[axis];
            let with_omega = if LAYOUT == ATTITUDE { self.pair_of(none, of_omega.pure()) } else { zero };
            jacobian.of_start[0][axis] = self.turn::<LAYOUT>(x, axis).mul_add(map, with_omega);
            if LAYOUT == WITH_FIXED_VECTOR || LAYOUT == GENERAL {
                jacobian.of_start[1][axis] = self
                    .permuted(y, EULER_WITH_CYCLED[axis])
                    .mul_add(self.with_cycled(euler), self.with_cycled(of_omega));
            }
        }
        // ∂ω̇/∂ω by diagonals: (ω2 ω3)ₙ contains ω3 at the start times ω2, and ω2 at the start
        // times ω3.
        let [b1, b2, b3] = terms.of_omega.map(|column| column.0);
        let (first, second) = (Row([o3, o1, o2, 0.0]), Row([o2, o3, o1, 0.0]));
        let diagonals = [
            Row([b1[0], b2[1], b3[2], 0.0]),
            first.mul_add(ratios, Row([b2[0], b3[1], b1[2], 0.0])),
            second.mul_add(ratios, Row([b3[0], b1[1], b2[2], 0.0])),
        ];
        if LAYOUT == ATTITUDE {
            // (ω2 ω3)ₙ contains ω2 at the start times ω3, and ω3 at the start times ω2. The second
            // row holds the factors of Ω2 and Ω3.
            let [r1, r2, r3, _] = ratios.0;
            let columns = [
                self.pair_of(half_turn[0], Row([0.0, 0.0, r2, r3])),
                self.pair_of(half_turn[1], Row([0.0, r1, 0.0, r3])),
                self.pair_of(half_turn[2], Row([0.0, r1, r2, 0.0])),
            ];
            let of_omega = [[0.0, 0.0, b3[1], b2[2]], [0.0, b3[0], 0.0, b1[2]], [0.0, b2[0], b1[1], 0.0]];
            for (axis, of_omega) in of_omega.into_iter().enumerate() {
                jacobian.of_newest[0][axis] =
                    columns[axis].mul_add(omega[axis], self.pair_of(none, Row(of_omega)));
            }
            // At the start of a step q = 1, so q ∘ ω contributes ω/2.
            jacobian.diagonal[0] = self.pair_of(Row([0.0, 0.5, 0.5, 0.5]), Row([0.0, b1[0], b2[1], b3[2]]));
        }
        if LAYOUT == WITH_FIXED_VECTOR || LAYOUT == GENERAL {
            // Both products of (ω2 Ω3 …) with the start are combined.
            jacobian.maps[1][0] = self.with_cycled(ratios);
            jacobian.of_newest[1][0] = self.with_cycled(ratios * Row([o3, o1, o2, 0.0]));
        }
        if LAYOUT == WITH_FIXED_VECTOR {
            for (place, diagonal) in jacobian.diagonal.iter_mut().zip(&terms.of_joint) {
                *place = self.with_cycled(*diagonal);
            }
        }
        if LAYOUT == WITH_ORBIT {
            let (ones, strength) = (Row([1.0, 1.0, 1.0, 0.0]), -terms.strength);
            let (u, v, products) =
                (motion[0].y.second().cycled(), motion[0].x.second().cycled(), terms.products);
            jacobian.maps[1][0] = self.pair_of(ratios, ones);
            jacobian.maps[1][1] = self.pair_of(products, none - ones);
            let turn = |axis: usize, o: f64| half_turn[axis] * Row([o; 4]);
            jacobian.on_orbit[0] = [
                self.pair_of(Row([0.0, 0.5, 0.5, 0.5]), Row([strength, strength, strength, 0.0])),
                self.pair_of(turn(0, o1), first),
                self.pair_of(turn(1, o2), none - second),
                self.pair_of(turn(2, o3), none - v.cycled()),
                self.pair_of(none, v),
            ];
            jacobian.on_orbit[1] = [
                self.pair_of(diagonals[0], ones),
                self.pair_of(diagonals[1], first),
                self.pair_of(diagonals[2], none - second),
                self.pair_of(products * u.cycled(), none - u.cycled()),
                self.pair_of(products * u, u),
            ];
        }
        jacobian
    }

    #[inline(always)]
    fn first<const LAYOUT: Layout>(
        self,
        jacobian: &StepJacobian<S::Eight>,
        motion: &Motion,
        terms: &EquationConstants<f64>,
        [low, more]: [Row; 2],
    ) -> [S::Eight; 2] {
        let s = self.0;
        if LAYOUT == WITH_ORBIT {
            let [x, y] = start_on_orbit(&motion[0], terms, more);
            let new = [s.eight(0.0), self.pair_of(low, Row::ZERO)];
            return self.plus_newest_on_orbit(jacobian, [self.pack(&x), self.pack(&y)], new);
        }
        let [l1, l2, l3, _] = low.0;
        let low_omega = [s.eight(l1), s.eight(l2), s.eight(l3)];
        let [o1, o2, o3] = motion[0].turning::<LAYOUT>();
        let omega = [s.eight(o1), s.eight(o2), s.eight(o3)];
        let (none, constant) = (Row::ZERO, terms.constant + more);
        let x = self.sum(&jacobian.of_start[0], omega);
        if LAYOUT == ATTITUDE {
            let x = x + self.pair_of(none, constant.pure());
            return self.plus_newest::<LAYOUT>(
                jacobian,
                [x, x],
                [self.pair_of(none, low.pure()), s.eight(0.0)],
                low_omega,
            );
        }
        let mut y = self.sum(&jacobian.of_start[1], omega) + self.with_cycled(constant);
        if LAYOUT == WITH_FIXED_VECTOR {
            let x0 = self.pack(&motion[0].x);
            for (factors, places) in jacobian.diagonal.into_iter().zip(DIAGONALS) {
                y = factors.mul_add(self.permuted(x0, places), y);
            }
        }
        self.plus_newest::<LAYOUT>(jacobian, [x, y], [s.eight(0.0), self.with_cycled(low)], low_omega)
    }

    #[inline(always)]
    fn next<const LAYOUT: Layout>(
        self,
        jacobian: &StepJacobian<S::Eight>,
        motion: &mut Motion,
        n: usize,
        [previous, newest]: [[S::Eight; 2]; 2],
        more: Option<Row>,
    ) -> [S::Eight; 2] {
        let (s, next) = (self.0, n + 1);
        let sums = self.sums_before::<LAYOUT>(motion, n, previous);
        let [new_x, new_y] = newest;
        motion[n].set::<LAYOUT>([self.unpack(new_x), self.unpack(new_y)]);
        if LAYOUT == WITH_ORBIT {
            motion[n].turning = self.unpack(self.cycled(new_y));
        }
        let ([first, second, third], mut y) = (jacobian.maps[0], s.eight(0.0));
        let x = first * self.turn::<LAYOUT>(sums.x[0], 0);
        let x = second.mul_add(self.turn::<LAYOUT>(sums.x[1], 1), x);
        let mut x = x + third * self.turn::<LAYOUT>(sums.x[2], 2);
        if LAYOUT == WITH_ORBIT {
            // (ω1 ω2 … | u1 u2 …) and (ω1 u2 … | u1 ω2 …), cycled once more.
            let [a, b, c, d, e, f, g, h] = s.eight_numbers(sums.square);
            let [i, j, k, l, o, p, q, r] = s.eight_numbers(sums.crossing);
            y = jacobian.maps[1][0] * s.load_eight(&[b, c, a, d, p, q, o, r]);
            y = jacobian.maps[1][1].mul_add(s.load_eight(&[f, g, e, h, j, k, i, l]), y);
        } else if LAYOUT != ATTITUDE {
            // ω times ω cycled is (ω1 ω2, ω2 ω3, ω3 ω1); one more cycle puts each product in its
            // place.
            let others = Row(s.numbers(sums.others));
            y = jacobian.maps[1][0] * self.with_cycled(others.cycled());
        }
        if let Some(more) = more {
            match LAYOUT {
                ATTITUDE => x = x + self.pair_of(Row::ZERO, more.pure()),
                WITH_ORBIT => y = y + self.pair_of(more, Row::ZERO),
                _ => y = y + self.with_cycled(more),
            }
        }
        let omega = if LAYOUT == WITH_FIXED_VECTOR {
            [self.permuted(new_y, [0; 8]), self.permuted(new_y, [1; 8]), self.permuted(new_y, [2; 8])]
        } else {
            let [o1, o2, o3] = motion[n].turning::<LAYOUT>();
            [s.eight(o1), s.eight(o2), s.eight(o3)]
        };
        let [x, y] = if LAYOUT == WITH_ORBIT {
            self.plus_newest_on_orbit(jacobian, [x, y], newest)
        } else {
            self.plus_newest::<LAYOUT>(jacobian, [x, y], newest, omega)
        };
        [over(x, next), over(y, next)]
    }
}

/// Sums of products without the newest coefficients.
#[derive(Clone, Copy)]
struct ProductSums<F, E> {
    /// Row x times each component of Ω.
    x: [E; 3],
    /// Row y times y cycled, row by row and crosswise (orbit only).
    square: E,
    crossing: E,
    /// ω times ω cycled, in the other layouts.
    others: F,
}

/// Coefficient in the form that products need.
struct Factors<F, E> {
    x: E,
    y: E,
    /// The components of Ω.
    omega: [E; 3],
    /// Both rows of y, cycled.
    cycled: E,
    /// ω, and ω cycled.
    row: F,
    row_cycled: F,
}

type ProductSumsOf<S> = ProductSums<<S as Machine>::Four, <S as Machine>::Eight>;
type FactorsOf<S> = Factors<<S as Machine>::Four, <S as Machine>::Eight>;

impl<S: Machine> OneBody<S> {
    /// Adds the contribution of the newest coefficients through those at the start: Σ Ωᵢ Tᵢ x, Σ
    /// (Tᵢ x₀) Ωᵢ, and the linear part.
    #[inline(always)]
    fn plus_newest<const LAYOUT: Layout>(
        self,
        jacobian: &StepJacobian<S::Eight>,
        [mut x, mut y]: [S::Eight; 2],
        [new_x, new_y]: [S::Eight; 2],
        omega: [S::Eight; 3],
    ) -> [S::Eight; 2] {
        if LAYOUT == ATTITUDE {
            let [first, second, third] = jacobian.of_newest[0];
            // Add what was known before only when the rest is almost complete.
            let new = first * self.turn::<LAYOUT>(new_x, 0);
            let more = jacobian.diagonal[0] * self.permuted(new_x, SECOND_TWICE);
            let new = second.mul_add(self.turn::<LAYOUT>(new_x, 1), new);
            let more = third.mul_add(self.turn::<LAYOUT>(new_x, 2), more);
            return [(new + x) + more; 2];
        }
        // Separate dependency chains, because all inputs are equally new.
        let mut more_x = jacobian.of_start[0][0] * omega[0];
        let mut more_y = jacobian.of_start[1][0] * omega[0];
        for (axis, omega) in omega.into_iter().enumerate() {
            x = jacobian.of_newest[0][axis].mul_add(self.turn::<LAYOUT>(new_x, axis), x);
            if axis > 0 {
                more_x = jacobian.of_start[0][axis].mul_add(omega, more_x);
                more_y = jacobian.of_start[1][axis].mul_add(omega, more_y);
            }
        }
        if LAYOUT == WITH_FIXED_VECTOR || LAYOUT == GENERAL {
            y = jacobian.of_newest[1][0].mul_add(self.cycled(new_y), y);
        }
        let [x, mut y] = [x + more_x, y + more_y];
        if LAYOUT == WITH_FIXED_VECTOR {
            let diagonal = jacobian.diagonal[0] * self.permuted(new_x, DIAGONALS[0]);
            let diagonal = jacobian.diagonal[1].mul_add(self.permuted(new_x, DIAGONALS[1]), diagonal);
            y = y + jacobian.diagonal[2].mul_add(self.permuted(new_x, DIAGONALS[2]), diagonal);
        }
        [x, y]
    }

    /// Like [`OneBody::plus_newest`], for the layout [`WITH_ORBIT`]. At the start of a step q = 1,
    /// so q ∘ ω contributes ω/2.
    #[inline(always)]
    fn plus_newest_on_orbit(
        self,
        jacobian: &StepJacobian<S::Eight>,
        [x, y]: [S::Eight; 2],
        [new_x, new_y]: [S::Eight; 2],
    ) -> [S::Eight; 2] {
        let s = self.0;
        let ([q0, q1, q2, q3, v1, v2, v3, v4], [w1, w2, w3, w4, u1, u2, u3, u4]) =
            (s.eight_numbers(new_x), s.eight_numbers(new_y));
        let (once, with_cycled) = (self.cycled(new_y), s.load_eight(&[w3, w1, w2, w4, u3, u1, u2, u4]));
        let twice_crossed = s.load_eight(&[u3, u1, u2, u4, w3, w1, w2, w4]);
        let [first, second, third, fourth, fifth] = jacobian.on_orbit[1];
        let y = first.mul_add(s.load_eight(&[w1, w2, w3, w4, v1, v2, v3, v4]), y);
        let y = second.mul_add(once, y);
        let more_y = third * with_cycled;
        let more_y = fourth.mul_add(self.swapped(once), more_y);
        let more_y = fifth.mul_add(twice_crossed, more_y);
        let [first, second, third, fourth, fifth] = jacobian.on_orbit[0];
        let x = first.mul_add(s.load_eight(&[w4, w1, w2, w3, u1, u2, u3, u4]), x);
        let x = second.mul_add(s.load_eight(&[q1, q0, q3, q2, v2, v3, v1, v4]), x);
        let x = third.mul_add(s.load_eight(&[q2, q3, q0, q1, v3, v1, v2, v4]), x);
        let more_x = fourth * s.load_eight(&[q3, q2, q1, q0, w2, w3, w1, w4]);
        let more_x = fifth.mul_add(twice_crossed, more_x);
        [x + more_x, y + more_y]
    }

    /// Returns the sums of products of coefficients 1 … n − 1. Those of n − 1 are still in
    /// registers (`previous`).
    #[inline(always)]
    fn sums_before<const LAYOUT: Layout>(
        self,
        motion: &Motion,
        n: usize,
        previous: [S::Eight; 2],
    ) -> ProductSumsOf<S> {
        let none = self.0.eight(0.0);
        let none = ProductSums { x: [none; 3], square: none, crossing: none, others: self.0.splat(0.0) };
        let (mut up, mut down) = (none, none);
        let (middle, [ups, downs]) = mirrored(motion, n);
        if let Some(middle) = middle {
            let middle = self.factors_of::<LAYOUT>(middle);
            up = self.products::<LAYOUT>(up, &middle, &middle);
        }
        if let ([ups @ .., _], [first, downs @ ..]) = (ups, downs) {
            for (a, b) in ups.iter().zip(downs.iter().rev()) {
                let (a, b) = (self.factors_of::<LAYOUT>(a), self.factors_of::<LAYOUT>(b));
                up = self.products::<LAYOUT>(up, &a, &b);
                down = self.products::<LAYOUT>(down, &b, &a);
            }
            let mut a = self.factors_of_packed::<LAYOUT>(previous);
            if LAYOUT == GENERAL || LAYOUT == WITH_ORBIT {
                a.omega = self.factors_of::<LAYOUT>(&motion[n - 1]).omega;
            }
            let b = self.factors_of::<LAYOUT>(first);
            up = self.products::<LAYOUT>(up, &a, &b);
            down = self.products::<LAYOUT>(down, &b, &a);
        }
        let ([a, b, c], [d, e, f]) = (up.x, down.x);
        up.x = [a + d, b + e, c + f];
        up.crossing = up.crossing + down.crossing;
        up.square = up.square + down.square;
        up.others = up.others + down.others;
        up
    }

    /// Adds the products of one coefficient with another.
    #[inline(always)]
    fn products<const LAYOUT: Layout>(
        self,
        mut sums: ProductSumsOf<S>,
        a: &FactorsOf<S>,
        b: &FactorsOf<S>,
    ) -> ProductSumsOf<S> {
        for axis in 0..3 {
            sums.x[axis] = a.x.mul_add(b.omega[axis], sums.x[axis]);
        }
        if LAYOUT == WITH_ORBIT {
            sums.square = a.y.mul_add(b.cycled, sums.square);
            sums.crossing = a.y.mul_add(self.swapped(b.cycled), sums.crossing);
        } else if LAYOUT != ATTITUDE {
            sums.others = a.row.mul_add(b.row_cycled, sums.others);
        }
        sums
    }

    #[inline(always)]
    fn factors_of<const LAYOUT: Layout>(self, of: &Coefficient) -> FactorsOf<S> {
        let s = self.0;
        let [o1, o2, o3] = of.turning::<LAYOUT>();
        let x = self.pack(&of.x);
        Factors {
            x,
            y: self.pack(&of.y),
            omega: [s.eight(o1), s.eight(o2), s.eight(o3)],
            cycled: self.pack(&of.turning),
            row: s.load(&of.y.first().0),
            row_cycled: s.load(&of.y.second().0),
        }
    }

    #[inline(always)]
    fn factors_of_packed<const LAYOUT: Layout>(self, [x, y]: [S::Eight; 2]) -> FactorsOf<S> {
        let s = self.0;
        let omega = if LAYOUT == ATTITUDE {
            [self.permuted(x, [5; 8]), self.permuted(x, [6; 8]), self.permuted(x, [7; 8])]
        } else {
            [self.permuted(y, [0; 8]), self.permuted(y, [1; 8]), self.permuted(y, [2; 8])]
        };
        let rows = self.unpack(y);
        Factors {
            x,
            y,
            omega,
            cycled: self.cycled(y),
            row: s.load(&rows.first().0),
            row_cycled: s.load(&rows.second().0),
        }
    }

    /// Returns the numbers of (q ∘ eᵢ, v × eᵢ) without their signs. In the layout [`ATTITUDE`] the
    /// second row is ω as a quaternion.
    #[inline(always)]
    fn turn<const LAYOUT: Layout>(self, pair: S::Eight, axis: usize) -> S::Eight {
        let second = if LAYOUT == ATTITUDE { TURN[axis] } else { CROSS[axis] };
        self.permuted(pair, places(TURN[axis], second))
    }

    /// Returns both rows cycled.
    #[inline(always)]
    fn cycled(self, pair: S::Eight) -> S::Eight {
        self.permuted(pair, [1, 2, 0, 3, 5, 6, 4, 7])
    }

    /// Returns the rows in reverse order.
    #[inline(always)]
    fn swapped(self, pair: S::Eight) -> S::Eight {
        self.permuted(pair, [4, 5, 6, 7, 0, 1, 2, 3])
    }

    /// Returns the numbers at these indices.
    #[inline(always)]
    fn permuted(self, pair: S::Eight, [a, b, c, d, e, f, g, h]: [usize; 8]) -> S::Eight {
        let x = self.0.eight_numbers(pair);
        self.0.load_eight(&[x[a], x[b], x[c], x[d], x[e], x[f], x[g], x[h]])
    }

    #[inline(always)]
    fn pair_of(self, first: Row, second: Row) -> S::Eight {
        self.pack(&Pair::new(first, second))
    }

    /// Returns a row, and the same row cycled.
    #[inline(always)]
    fn with_cycled(self, row: Row) -> S::Eight {
        self.pair_of(row, row.cycled())
    }

    /// Returns Σ aᵢ bᵢ.
    #[inline(always)]
    fn sum(self, a: &[S::Eight; 3], b: [S::Eight; 3]) -> S::Eight {
        a[2].mul_add(b[2], a[1].mul_add(b[1], a[0].mul_add(b[0], self.0.eight(0.0))))
    }
}
