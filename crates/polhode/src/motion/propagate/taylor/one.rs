//! The recurrence of one body, a pair in a register.
//!
//! Most of the time goes by waiting: for the newest coefficients, and for the sums that those before have a part in. So what is newest comes last,
//! and the processor works on all else meanwhile.

use super::pair::Pair;
use super::recurrence::{
    ALONE, CARRYING, CROSS, Coefficient, EULER, GENERAL, MOVING, Motion, Recurrence, TURN, Terms, mirrored,
    moving_start, over,
};
use super::row::Row;
use super::sums::ByFours;
use crate::math::machine::Machine;
use crate::math::number::MulAdd;

/// What newest coefficients of one body are multiplied by.
#[derive(Clone, Copy)]
pub(super) struct Law<E> {
    /// Tᵢ: of x, and of y; of products where a vector moves.
    maps: [[E; 3]; 2],
    /// Ωᵢ Tᵢ, Ω at the start.
    turned: [[E; 3]; 2],
    /// Tᵢ x and Tᵢ y at the start, with B.
    starts: [[E; 3]; 2],
    /// What goes from u to ω̇; from ω to q where there is no u.
    across: [E; 3],
    /// What goes to x and to y where a vector moves, in the order of [`ByFours::with_moving`].
    moving: [[E; 5]; 2],
}

impl<S: Machine> Recurrence for ByFours<S> {
    type Places = S::Eight;
    type Law = Law<S::Eight>;

    #[inline(always)]
    fn places(self, pair: &Pair) -> S::Eight {
        self.0.load_eight(&pair.0)
    }

    #[inline(always)]
    fn pair(self, places: S::Eight) -> Pair {
        Pair(self.0.eight_numbers(places))
    }

    #[inline(always)]
    fn law<const LAYOUT: u8>(self, motion: &Motion, terms: &Terms<f64>) -> Law<S::Eight> {
        let s = self.0;
        let zero = s.eight(0.0);
        let (x, y) = (self.places(&motion[0].x), self.places(&motion[0].y));
        let [o1, o2, o3] = motion[0].turning::<LAYOUT>();
        let omega = [s.eight(o1), s.eight(o2), s.eight(o3)];
        let (none, ratios) = (Row::ZERO, terms.ratios);
        let mut law = Law {
            maps: [[zero; 3]; 2],
            turned: [[zero; 3]; 2],
            starts: [[zero; 3]; 2],
            across: [zero; 3],
            moving: [[zero; 5]; 2],
        };
        for axis in 0..3 {
            let (euler, damping) = (Row(EULER[axis]) * ratios, terms.damping[axis]);
            let beside = if LAYOUT == ALONE { euler.pure() } else { Row(CROSS[axis]) };
            let map = self.both(Row(TURN[axis]), beside);
            law.maps[0][axis] = map;
            law.turned[0][axis] = map * omega[axis];
            let damped = if LAYOUT == ALONE { self.both(none, damping.pure()) } else { zero };
            law.starts[0][axis] = self.turn::<LAYOUT>(x, axis).mul_add(map, damped);
            if LAYOUT == CARRYING || LAYOUT == GENERAL {
                law.starts[1][axis] = self.euler(y, axis).mul_add(self.twice(euler), self.twice(damping));
            }
        }
        // ∂ω̇/∂ω, diagonal by diagonal: (ω2 ω3)ₙ has ω3 of the start times ω2, and ω2 of the start times ω3.
        let [b1, b2, b3] = terms.damping.map(|column| column.0);
        let (first, second) = (Row([o3, o1, o2, 0.0]), Row([o2, o3, o1, 0.0]));
        let diagonals = [
            Row([b1[0], b2[1], b3[2], 0.0]),
            first.mul_add(ratios, Row([b2[0], b3[1], b1[2], 0.0])),
            second.mul_add(ratios, Row([b3[0], b1[1], b2[2], 0.0])),
        ];
        if LAYOUT == ALONE {
            // (ω2 ω3)ₙ has ω2 of the start times ω3 and ω3 times ω2: row 1 of what Ω2 and Ω3 are multiplied by.
            let [r1, r2, r3, _] = ratios.0;
            let columns = [
                self.both(Row(TURN[0]), Row([0.0, 0.0, r2, r3])),
                self.both(Row(TURN[1]), Row([0.0, r1, 0.0, r3])),
                self.both(Row(TURN[2]), Row([0.0, r1, r2, 0.0])),
            ];
            let damping = [[0.0, 0.0, b3[1], b2[2]], [0.0, b3[0], 0.0, b1[2]], [0.0, b2[0], b1[1], 0.0]];
            for (axis, damping) in damping.into_iter().enumerate() {
                law.turned[0][axis] = columns[axis].mul_add(omega[axis], self.both(none, Row(damping)));
            }
            // The turn starts from 1: q ∘ ω has half of ω.
            law.across[0] = self.both(Row([0.0, 0.5, 0.5, 0.5]), Row([0.0, b1[0], b2[1], b3[2]]));
        }
        if LAYOUT == CARRYING || LAYOUT == GENERAL {
            // (ω2 Ω3 …) at once.
            law.maps[1][0] = self.twice(ratios);
            law.turned[1][0] = self.twice(ratios * Row([o3, o1, o2, 0.0]));
        }
        if LAYOUT == CARRYING {
            for (place, diagonal) in law.across.iter_mut().zip(&terms.seen) {
                *place = self.twice(*diagonal);
            }
        }
        if LAYOUT == MOVING {
            let (ones, pull) = (Row([1.0, 1.0, 1.0, 0.0]), -terms.pull);
            let (u, v, bending) =
                (motion[0].y.second().turned(), motion[0].x.second().turned(), terms.bending);
            law.maps[1][0] = self.both(ratios, ones);
            law.maps[1][1] = self.both(bending, none - ones);
            let turn = |axis: usize, o: f64| Row(TURN[axis]) * Row([o; 4]);
            law.moving[0] = [
                self.both(Row([0.0, 0.5, 0.5, 0.5]), Row([pull, pull, pull, 0.0])),
                self.both(turn(0, o1), first),
                self.both(turn(1, o2), none - second),
                self.both(turn(2, o3), none - v.turned()),
                self.both(none, v),
            ];
            law.moving[1] = [
                self.both(diagonals[0], ones),
                self.both(diagonals[1], first),
                self.both(diagonals[2], none - second),
                self.both(bending * u.turned(), none - u.turned()),
                self.both(bending * u, u),
            ];
        }
        law
    }

    #[inline(always)]
    fn first<const LAYOUT: u8>(
        self,
        law: &Law<S::Eight>,
        motion: &Motion,
        terms: &Terms<f64>,
        [low, more]: [Row; 2],
    ) -> [S::Eight; 2] {
        let s = self.0;
        if LAYOUT == MOVING {
            let [x, y] = moving_start(&motion[0], terms);
            let new = [s.eight(0.0), self.both(low, Row::ZERO)];
            return self.with_moving(law, [self.places(&x), self.places(&y)], new);
        }
        let [l1, l2, l3, _] = low.0;
        let low_omega = [s.eight(l1), s.eight(l2), s.eight(l3)];
        let [o1, o2, o3] = motion[0].turning::<LAYOUT>();
        let omega = [s.eight(o1), s.eight(o2), s.eight(o3)];
        let (none, constant) = (Row::ZERO, if LAYOUT == GENERAL { more } else { terms.constant });
        let x = self.sum(&law.starts[0], omega);
        if LAYOUT == ALONE {
            let x = x + self.both(none, constant.pure());
            return self.with::<LAYOUT>(law, [x, x], [self.both(none, low.pure()), s.eight(0.0)], low_omega);
        }
        let mut y = self.sum(&law.starts[1], omega) + self.twice(constant);
        if LAYOUT == CARRYING {
            let x0 = self.places(&motion[0].x);
            for diagonal in 0..3 {
                y = law.across[diagonal].mul_add(self.across(x0, diagonal), y);
            }
        }
        self.with::<LAYOUT>(law, [x, y], [s.eight(0.0), self.twice(low)], low_omega)
    }

    #[inline(always)]
    fn next<const LAYOUT: u8>(
        self,
        law: &Law<S::Eight>,
        motion: &mut Motion,
        n: usize,
        [previous, newest]: [[S::Eight; 2]; 2],
        more: Row,
    ) -> [S::Eight; 2] {
        let (s, next) = (self.0, n + 1);
        let sums = self.before::<LAYOUT>(motion, n, previous);
        let [new_x, new_y] = newest;
        motion[n].set::<LAYOUT>([self.pair(new_x), self.pair(new_y)]);
        if LAYOUT == MOVING {
            motion[n].turning = self.pair(self.turned(new_y));
        }
        let ([first, second, third], mut y) = (law.maps[0], s.eight(0.0));
        let x = first * self.turn::<LAYOUT>(sums.x[0], 0);
        let x = second.mul_add(self.turn::<LAYOUT>(sums.x[1], 1), x);
        let x = x + third * self.turn::<LAYOUT>(sums.x[2], 2);
        if LAYOUT == MOVING {
            // (ω1 ω2 … | u1 u2 …) and (ω1 u2 … | u1 ω2 …), turned once more.
            let [a, b, c, d, e, f, g, h] = s.eight_numbers(sums.square);
            let [i, j, k, l, o, p, q, r] = s.eight_numbers(sums.crossing);
            y = law.maps[1][0] * s.load_eight(&[b, c, a, d, p, q, o, r]);
            y = law.maps[1][1].mul_add(s.load_eight(&[f, g, e, h, j, k, i, l]), y);
        } else if LAYOUT != ALONE {
            // ω times ω turned: turning once more brings (ω1 ω2, ω2 ω3, ω3 ω1) there.
            let others = Row(s.numbers(sums.others));
            y = law.maps[1][0] * self.twice(others.turned());
        }
        if LAYOUT == GENERAL {
            y = y + self.twice(more);
        }
        let omega = if LAYOUT == CARRYING {
            [self.each::<0>(new_y), self.each::<1>(new_y), self.each::<2>(new_y)]
        } else {
            let [o1, o2, o3] = motion[n].turning::<LAYOUT>();
            [s.eight(o1), s.eight(o2), s.eight(o3)]
        };
        let [x, y] = if LAYOUT == MOVING {
            self.with_moving(law, [x, y], newest)
        } else {
            self.with::<LAYOUT>(law, [x, y], newest, omega)
        };
        [over(x, next), over(y, next)]
    }
}

/// Sums of products that are not complete yet.
#[derive(Clone, Copy)]
struct Outer<F, E> {
    /// x times each component of Ω.
    x: [E; 3],
    /// y times y turned, row by row and crosswise, where v moves.
    square: E,
    crossing: E,
    /// ω times ω turned elsewhere.
    others: F,
}

/// A coefficient as products need it.
struct Factors<F, E> {
    x: E,
    y: E,
    /// The components of Ω.
    omega: [E; 3],
    /// Both rows of y turned.
    turned: E,
    /// ω, and that turned.
    row: F,
    row_turned: F,
}

type OuterOf<S> = Outer<<S as Machine>::Four, <S as Machine>::Eight>;
type FactorsOf<S> = Factors<<S as Machine>::Four, <S as Machine>::Eight>;

impl<S: Machine> ByFours<S> {
    /// Sums with what comes of new numbers by way of those at the start: Σ Ωᵢ Tᵢ x, Σ (Tᵢ x₀) Ωᵢ, and what is linear.
    #[inline(always)]
    fn with<const LAYOUT: u8>(
        self,
        law: &Law<S::Eight>,
        [mut x, mut y]: [S::Eight; 2],
        [new_x, new_y]: [S::Eight; 2],
        omega: [S::Eight; 3],
    ) -> [S::Eight; 2] {
        if LAYOUT == ALONE {
            let [first, second, third] = law.turned[0];
            // What is known before comes in when the rest is nearly there.
            let new = first * self.turn::<LAYOUT>(new_x, 0);
            let more = law.across[0] * self.second_twice(new_x);
            let new = second.mul_add(self.turn::<LAYOUT>(new_x, 1), new);
            let more = third.mul_add(self.turn::<LAYOUT>(new_x, 2), more);
            return [(new + x) + more; 2];
        }
        // Chains of their own: all are as new.
        let mut more_x = law.starts[0][0] * omega[0];
        let mut more_y = law.starts[1][0] * omega[0];
        for (axis, omega) in omega.into_iter().enumerate() {
            x = law.turned[0][axis].mul_add(self.turn::<LAYOUT>(new_x, axis), x);
            if axis > 0 {
                more_x = law.starts[0][axis].mul_add(omega, more_x);
                more_y = law.starts[1][axis].mul_add(omega, more_y);
            }
        }
        if LAYOUT == CARRYING || LAYOUT == GENERAL {
            y = law.turned[1][0].mul_add(self.turned(new_y), y);
        }
        let [x, mut y] = [x + more_x, y + more_y];
        if LAYOUT == CARRYING {
            let across = law.across[0] * self.across(new_x, 0);
            let across = law.across[1].mul_add(self.across(new_x, 1), across);
            y = y + law.across[2].mul_add(self.across(new_x, 2), across);
        }
        [x, y]
    }

    /// The same where a vector moves. The turn starts from 1: q ∘ ω has half of ω.
    #[inline(always)]
    fn with_moving(
        self,
        law: &Law<S::Eight>,
        [x, y]: [S::Eight; 2],
        [new_x, new_y]: [S::Eight; 2],
    ) -> [S::Eight; 2] {
        let s = self.0;
        let ([q0, q1, q2, q3, v1, v2, v3, v4], [w1, w2, w3, w4, u1, u2, u3, u4]) =
            (s.eight_numbers(new_x), s.eight_numbers(new_y));
        let (once, twice) = (self.turned(new_y), s.load_eight(&[w3, w1, w2, w4, u3, u1, u2, u4]));
        let twice_crossed = s.load_eight(&[u3, u1, u2, u4, w3, w1, w2, w4]);
        let [first, second, third, fourth, fifth] = law.moving[1];
        let y = first.mul_add(s.load_eight(&[w1, w2, w3, w4, v1, v2, v3, v4]), y);
        let y = second.mul_add(once, y);
        let more_y = third * twice;
        let more_y = fourth.mul_add(self.exchanged(once), more_y);
        let more_y = fifth.mul_add(twice_crossed, more_y);
        let [first, second, third, fourth, fifth] = law.moving[0];
        let x = first.mul_add(s.load_eight(&[w4, w1, w2, w3, u1, u2, u3, u4]), x);
        let x = second.mul_add(s.load_eight(&[q1, q0, q3, q2, v2, v3, v1, v4]), x);
        let x = third.mul_add(s.load_eight(&[q2, q3, q0, q1, v3, v1, v2, v4]), x);
        let more_x = fourth * s.load_eight(&[q3, q2, q1, q0, w2, w3, w1, w4]);
        let more_x = fifth.mul_add(twice_crossed, more_x);
        [x + more_x, y + more_y]
    }

    /// Products of coefficients 1 … n − 1; those of n − 1 itself are in registers still.
    #[inline(always)]
    fn before<const LAYOUT: u8>(self, motion: &Motion, n: usize, previous: [S::Eight; 2]) -> OuterOf<S> {
        let none = self.0.eight(0.0);
        let none = Outer { x: [none; 3], square: none, crossing: none, others: self.0.splat(0.0) };
        let (mut up, mut down) = (none, none);
        let (middle, [ups, downs]) = mirrored(motion, n);
        if let Some(middle) = middle {
            let middle = self.loaded::<LAYOUT>(middle);
            up = self.products::<LAYOUT>(up, &middle, &middle);
        }
        if let ([ups @ .., _], [first, downs @ ..]) = (ups, downs) {
            for (a, b) in ups.iter().zip(downs.iter().rev()) {
                let (a, b) = (self.loaded::<LAYOUT>(a), self.loaded::<LAYOUT>(b));
                up = self.products::<LAYOUT>(up, &a, &b);
                down = self.products::<LAYOUT>(down, &b, &a);
            }
            let mut a = self.held::<LAYOUT>(previous);
            if LAYOUT == GENERAL || LAYOUT == MOVING {
                a.omega = self.loaded::<LAYOUT>(&motion[n - 1]).omega;
            }
            let b = self.loaded::<LAYOUT>(first);
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

    /// Plus the products of one coefficient with another one.
    #[inline(always)]
    fn products<const LAYOUT: u8>(
        self,
        mut sums: OuterOf<S>,
        a: &FactorsOf<S>,
        b: &FactorsOf<S>,
    ) -> OuterOf<S> {
        for axis in 0..3 {
            sums.x[axis] = a.x.mul_add(b.omega[axis], sums.x[axis]);
        }
        if LAYOUT == MOVING {
            sums.square = a.y.mul_add(b.turned, sums.square);
            sums.crossing = a.y.mul_add(self.exchanged(b.turned), sums.crossing);
        } else if LAYOUT != ALONE {
            sums.others = a.row.mul_add(b.row_turned, sums.others);
        }
        sums
    }

    #[inline(always)]
    fn loaded<const LAYOUT: u8>(self, of: &Coefficient) -> FactorsOf<S> {
        let s = self.0;
        let [o1, o2, o3] = of.turning::<LAYOUT>();
        let x = self.places(&of.x);
        Factors {
            x,
            y: self.places(&of.y),
            omega: [s.eight(o1), s.eight(o2), s.eight(o3)],
            turned: self.places(&of.turning),
            row: s.load(&of.y.first().0),
            row_turned: s.load(&of.y.second().0),
        }
    }

    #[inline(always)]
    fn held<const LAYOUT: u8>(self, [x, y]: [S::Eight; 2]) -> FactorsOf<S> {
        let s = self.0;
        let omega = if LAYOUT == ALONE {
            [self.each::<5>(x), self.each::<6>(x), self.each::<7>(x)]
        } else {
            [self.each::<0>(y), self.each::<1>(y), self.each::<2>(y)]
        };
        let rows = self.pair(y);
        Factors {
            x,
            y,
            omega,
            turned: self.turned(y),
            row: s.load(&rows.first().0),
            row_turned: s.load(&rows.second().0),
        }
    }

    /// The numbers of (q ∘ eᵢ, v × eᵢ), to be multiplied by their signs; of ω in the second row too.
    #[inline(always)]
    fn turn<const LAYOUT: u8>(self, pair: S::Eight, axis: usize) -> S::Eight {
        let [w, x, y, z, a, b, c, d] = self.0.eight_numbers(pair);
        self.0.load_eight(&match (axis, LAYOUT == ALONE) {
            (0, true) => [x, w, z, y, b, a, d, c],
            (0, false) => [x, w, z, y, a, c, b, d],
            (1, true) => [y, z, w, x, c, d, a, b],
            (1, false) => [y, z, w, x, c, b, a, d],
            (_, true) => [z, y, x, w, d, c, b, a],
            (_, false) => [z, y, x, w, b, a, c, d],
        })
    }

    /// The second row in both places.
    #[inline(always)]
    fn second_twice(self, pair: S::Eight) -> S::Eight {
        let [.., a, b, c, d] = self.0.eight_numbers(pair);
        self.0.load_eight(&[a, b, c, d, a, b, c, d])
    }

    /// The same of ω, and that turned.
    #[inline(always)]
    fn euler(self, pair: S::Eight, axis: usize) -> S::Eight {
        let [x, y, z, w, ..] = self.0.eight_numbers(pair);
        self.0.load_eight(&match axis {
            0 => [x, z, y, w, z, y, x, w],
            1 => [z, y, x, w, y, x, z, w],
            _ => [y, x, z, w, x, z, y, w],
        })
    }

    /// Both rows turned.
    #[inline(always)]
    fn turned(self, pair: S::Eight) -> S::Eight {
        let [x, y, z, w, a, b, c, d] = self.0.eight_numbers(pair);
        self.0.load_eight(&[y, z, x, w, b, c, a, d])
    }

    /// The second row first.
    #[inline(always)]
    fn exchanged(self, pair: S::Eight) -> S::Eight {
        let [w, x, y, z, a, b, c, d] = self.0.eight_numbers(pair);
        self.0.load_eight(&[a, b, c, d, w, x, y, z])
    }

    /// u in the first row, (u1, u2, u3), (u2, u3, u1) or (u3, u1, u2), and that turned in the second.
    #[inline(always)]
    fn across(self, pair: S::Eight, diagonal: usize) -> S::Eight {
        let [.., a, b, c, d] = self.0.eight_numbers(pair);
        self.0.load_eight(&match diagonal {
            0 => [a, b, c, d, b, c, a, d],
            1 => [b, c, a, d, c, a, b, d],
            _ => [c, a, b, d, a, b, c, d],
        })
    }

    #[inline(always)]
    fn both(self, first: Row, second: Row) -> S::Eight {
        self.places(&Pair::new(first, second))
    }

    /// A row, and the same turned.
    #[inline(always)]
    fn twice(self, row: Row) -> S::Eight {
        self.both(row, row.turned())
    }

    /// Σ aᵢ bᵢ
    #[inline(always)]
    fn sum(self, a: &[S::Eight; 3], b: [S::Eight; 3]) -> S::Eight {
        a[2].mul_add(b[2], a[1].mul_add(b[1], a[0].mul_add(b[0], self.0.eight(0.0))))
    }

    /// The number of a place in every place.
    #[inline(always)]
    fn each<const PLACE: usize>(self, pair: S::Eight) -> S::Eight {
        let number = self.0.eight_numbers(pair)[PLACE];
        self.0.load_eight(&[number; 8])
    }
}
