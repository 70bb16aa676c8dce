//! The recurrence of one body, a pair in a register.
//!
//! Most of the time goes by waiting: for the newest coefficients, and for the sums that those before have a part in. So what is newest comes last,
//! and the processor works on all else meanwhile.

use super::pair::Pair;
use super::recurrence::{
    ALONE, CARRYING, CROSS, Coefficient, EULER, GENERAL, MOVING, Motion, Recurrence, TURN, Terms, mirrored,
    over,
};
use super::row::Row;
use super::sums::ByFours;
use crate::math::machine::Machine;
use crate::math::number::MulAdd;

/// What newest coefficients of one body are multiplied by.
#[derive(Clone, Copy)]
pub(super) struct Law<E> {
    /// Tᵢ: of x, and of y.
    maps: [[E; 3]; 2],
    /// Ωᵢ Tᵢ, Ω at the start.
    turned: [[E; 3]; 2],
    /// Tᵢ x and Tᵢ y at the start, with B.
    starts: [[E; 3]; 2],
    /// What goes from u to ω̇: A, or G times what it meets; from ω to q where there is no u.
    across: [E; 3],
    /// G
    bending: E,
    /// −s
    pull: E,
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
            bending: zero,
            pull: zero,
        };
        for axis in 0..3 {
            let (euler, damping) = (Row(EULER[axis]) * ratios, terms.damping[axis]);
            let beside = if LAYOUT == ALONE { euler } else { Row(CROSS[axis]) };
            let map = self.both(Row(TURN[axis]), beside);
            law.maps[0][axis] = map;
            law.turned[0][axis] = map * omega[axis];
            let damped = if LAYOUT == ALONE { self.both(none, damping) } else { zero };
            law.starts[0][axis] = self.turn(x, axis).mul_add(map, damped);
            if LAYOUT == MOVING {
                let map = self.both(euler, Row(CROSS[axis]));
                law.maps[1][axis] = map;
                law.turned[1][axis] = map * omega[axis];
                law.starts[1][axis] = self.vector(y, axis).mul_add(map, self.both(damping, none));
            } else if LAYOUT != ALONE {
                law.starts[1][axis] = self.euler(y, axis).mul_add(self.twice(euler), self.twice(damping));
            }
        }
        if LAYOUT == ALONE {
            // ∂ω̇/∂ω, diagonal by diagonal: (ω2 ω3)ₙ has ω3 of the start times ω2, and ω2 of the start times ω3.
            let [b1, b2, b3] = terms.damping.map(|column| column.0);
            let (first, second) = (Row([o3, o1, o2, 0.0]), Row([o2, o3, o1, 0.0]));
            let diagonals = [
                Row([b1[0], b2[1], b3[2], 0.0]),
                first.mul_add(ratios, Row([b2[0], b3[1], b1[2], 0.0])),
                second.mul_add(ratios, Row([b3[0], b1[1], b2[2], 0.0])),
            ];
            for (axis, diagonal) in diagonals.into_iter().enumerate() {
                law.turned[0][axis] =
                    self.both(Row(TURN[axis]), none).mul_add(omega[axis], self.both(none, diagonal));
            }
            // The turn starts from 1: q ∘ ω has half of ω.
            law.across[0] = self.both(Row([0.0, 0.5, 0.5, 0.5]), none);
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
            // (u2 u3)ₙ has u3 of the start times u2, and u2 of the start times u3.
            law.bending = self.both(terms.bending, none);
            law.across[1] = law.bending * self.across::<LAYOUT>(x, 2);
            law.across[2] = law.bending * self.across::<LAYOUT>(x, 1);
            let pull = -terms.pull;
            law.pull = self.both(none, Row([pull, pull, pull, 0.0]));
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
        let [l1, l2, l3, _] = low.0;
        let low_omega = [s.eight(l1), s.eight(l2), s.eight(l3)];
        let [o1, o2, o3] = motion[0].turning::<LAYOUT>();
        let omega = [s.eight(o1), s.eight(o2), s.eight(o3)];
        let (none, constant) = (Row::ZERO, if LAYOUT == GENERAL { more } else { terms.constant });
        let mut x = self.sum(&law.starts[0], omega);
        if LAYOUT == ALONE {
            x = x + self.both(none, constant);
            return self.with::<LAYOUT>(law, [x, x], [self.both(none, low), s.eight(0.0)], low_omega);
        }
        let constant = if LAYOUT == MOVING { self.both(constant, none) } else { self.twice(constant) };
        let mut y = self.sum(&law.starts[1], omega) + constant;
        let (x0, y0) = (self.places(&motion[0].x), self.places(&motion[0].y));
        if LAYOUT == CARRYING {
            for diagonal in 0..3 {
                y = law.across[diagonal].mul_add(self.across::<LAYOUT>(x0, diagonal), y);
            }
        }
        if LAYOUT == MOVING {
            y = law.across[1].mul_add(self.across::<LAYOUT>(x0, 1), y);
            y = law.pull.mul_add(x0, y);
            x = self.second().mul_add(y0, x);
        }
        let low = if LAYOUT == MOVING { self.both(low, none) } else { self.twice(low) };
        self.with::<LAYOUT>(law, [x, y], [s.eight(0.0), low], low_omega)
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
        let [mut x, mut y] = [s.eight(0.0); 2];
        for axis in 0..3 {
            x = self.turn(sums.x[axis], axis).mul_add(law.maps[0][axis], x);
            if LAYOUT == MOVING {
                y = self.vector(sums.y[axis], axis).mul_add(law.maps[1][axis], y);
            }
        }
        if LAYOUT == MOVING {
            y = law.bending.mul_add(self.across::<LAYOUT>(sums.square, 1), y);
        } else if LAYOUT != ALONE {
            // ω times ω turned: turning once more brings (ω1 ω2, ω2 ω3, ω3 ω1) there.
            let others = Row(s.numbers(sums.others));
            y = law.maps[1][0] * self.twice(others.turned());
        }
        if LAYOUT == GENERAL {
            y = y + self.twice(more);
        }
        let [x, y] = [over(x, next), over(y, next)];
        let [new_x, new_y] = [over(new_x, next), over(new_y, next)];
        let omega = if LAYOUT == ALONE {
            [s.eight(0.0); 3]
        } else if LAYOUT == GENERAL {
            let [o1, o2, o3] = motion[n].turning::<LAYOUT>();
            [over(s.eight(o1), next), over(s.eight(o2), next), over(s.eight(o3), next)]
        } else {
            [self.each::<0>(new_y), self.each::<1>(new_y), self.each::<2>(new_y)]
        };
        self.with::<LAYOUT>(law, [x, y], [new_x, new_y], omega)
    }
}

/// Sums of products that are not complete yet.
#[derive(Clone, Copy)]
struct Outer<F, E> {
    /// x times each component of Ω.
    x: [E; 3],
    /// The same of y, and u times u turned, where v moves.
    y: [E; 3],
    square: E,
    /// ω times ω turned elsewhere.
    others: F,
}

/// A coefficient as products need it.
struct Factors<F, E> {
    x: E,
    y: E,
    /// The components of Ω.
    omega: [E; 3],
    /// u turned, in the second row.
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
            let x = first.mul_add(self.alone(new_x, 0), x);
            let more = law.across[0] * self.alone(new_x, 3);
            let [x, more] =
                [second.mul_add(self.alone(new_x, 1), x), third.mul_add(self.alone(new_x, 2), more)];
            return [x + more; 2];
        }
        // Chains of their own: all are as new.
        let mut more_x = law.starts[0][0] * omega[0];
        let mut more_y = law.starts[1][0] * omega[0];
        for (axis, omega) in omega.into_iter().enumerate() {
            x = law.turned[0][axis].mul_add(self.turn(new_x, axis), x);
            if LAYOUT == MOVING {
                y = law.turned[1][axis].mul_add(self.vector(new_y, axis), y);
            }
            if axis > 0 {
                more_x = law.starts[0][axis].mul_add(omega, more_x);
                more_y = law.starts[1][axis].mul_add(omega, more_y);
            }
        }
        if LAYOUT == CARRYING || LAYOUT == GENERAL {
            y = law.turned[1][0].mul_add(self.turned(new_y), y);
        }
        let [mut x, mut y] = [x + more_x, y + more_y];
        if LAYOUT == CARRYING {
            let across = law.across[0] * self.across::<LAYOUT>(new_x, 0);
            let across = law.across[1].mul_add(self.across::<LAYOUT>(new_x, 1), across);
            y = y + law.across[2].mul_add(self.across::<LAYOUT>(new_x, 2), across);
        }
        if LAYOUT == MOVING {
            let across = law.across[1] * self.across::<LAYOUT>(new_x, 1);
            let across = law.across[2].mul_add(self.across::<LAYOUT>(new_x, 2), across);
            y = y + law.pull.mul_add(new_x, across);
            x = self.second().mul_add(new_y, x);
        }
        [x, y]
    }

    /// Products of coefficients 1 … n − 1; those of n − 1 itself are in registers still.
    #[inline(always)]
    fn before<const LAYOUT: u8>(self, motion: &Motion, n: usize, previous: [S::Eight; 2]) -> OuterOf<S> {
        let none = self.0.eight(0.0);
        let none = Outer { x: [none; 3], y: [none; 3], square: none, others: self.0.splat(0.0) };
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
            if LAYOUT == GENERAL {
                a.omega = self.loaded::<LAYOUT>(&motion[n - 1]).omega;
            }
            let b = self.loaded::<LAYOUT>(first);
            up = self.products::<LAYOUT>(up, &a, &b);
            down = self.products::<LAYOUT>(down, &b, &a);
        }
        for axis in 0..3 {
            up.x[axis] = up.x[axis] + down.x[axis];
            up.y[axis] = up.y[axis] + down.y[axis];
        }
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
            if LAYOUT == MOVING {
                sums.y[axis] = a.y.mul_add(b.omega[axis], sums.y[axis]);
            }
        }
        if LAYOUT == MOVING {
            sums.square = a.x.mul_add(b.turned, sums.square);
        } else if LAYOUT != ALONE {
            sums.others = a.row.mul_add(b.row_turned, sums.others);
        }
        sums
    }

    #[inline(always)]
    fn loaded<const LAYOUT: u8>(self, of: &Coefficient) -> FactorsOf<S> {
        let s = self.0;
        let [o1, o2, o3] = of.turning::<LAYOUT>();
        let [w, i, j, k, a, b, c, d] = of.x.0;
        Factors {
            x: self.places(&of.x),
            y: self.places(&of.y),
            omega: [s.eight(o1), s.eight(o2), s.eight(o3)],
            turned: self.places(&Pair([w, i, j, k, b, c, a, d])),
            row: s.load(&of.y.first().0),
            row_turned: s.load(&of.y.second().0),
        }
    }

    #[inline(always)]
    fn held<const LAYOUT: u8>(self, [x, y]: [S::Eight; 2]) -> FactorsOf<S> {
        let s = self.0;
        let omega = if LAYOUT == ALONE {
            [self.each::<4>(x), self.each::<5>(x), self.each::<6>(x)]
        } else {
            [self.each::<0>(y), self.each::<1>(y), self.each::<2>(y)]
        };
        let [w, i, j, k, a, b, c, d] = s.eight_numbers(x);
        let turned = self.places(&Pair([w, i, j, k, b, c, a, d]));
        let rows = self.pair(y);
        Factors { x, y, omega, turned, row: s.load(&rows.first().0), row_turned: s.load(&rows.second().0) }
    }

    /// The numbers of (q ∘ eᵢ, v × eᵢ), to be multiplied by their signs; of ω in the second row too.
    #[inline(always)]
    fn turn(self, pair: S::Eight, axis: usize) -> S::Eight {
        let [w, x, y, z, a, b, c, d] = self.0.eight_numbers(pair);
        self.0.load_eight(&match axis {
            0 => [x, w, z, y, a, c, b, d],
            1 => [y, z, w, x, c, b, a, d],
            _ => [z, y, x, w, b, a, c, d],
        })
    }

    /// Of (q, ω), the numbers of q ∘ eᵢ, and ω turned so many times; then ω in the places of q.
    #[inline(always)]
    fn alone(self, pair: S::Eight, part: usize) -> S::Eight {
        let [w, x, y, z, a, b, c, d] = self.0.eight_numbers(pair);
        self.0.load_eight(&match part {
            0 => [x, w, z, y, a, b, c, d],
            1 => [y, z, w, x, b, c, a, d],
            2 => [z, y, x, w, c, a, b, d],
            _ => [d, a, b, c, w, x, y, z],
        })
    }

    /// The same of (ω, v).
    #[inline(always)]
    fn vector(self, pair: S::Eight, axis: usize) -> S::Eight {
        let [x, y, z, w, a, b, c, d] = self.0.eight_numbers(pair);
        self.0.load_eight(&match axis {
            0 => [x, z, y, w, a, c, b, d],
            1 => [z, y, x, w, c, b, a, d],
            _ => [y, x, z, w, b, a, c, d],
        })
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

    /// u in the first row, (u1, u2, u3), (u2, u3, u1) or (u3, u1, u2), and that turned in the second, if it is ω's too.
    #[inline(always)]
    fn across<const LAYOUT: u8>(self, pair: S::Eight, diagonal: usize) -> S::Eight {
        let [w, x, y, z, a, b, c, d] = self.0.eight_numbers(pair);
        self.0.load_eight(&match (LAYOUT, diagonal) {
            (CARRYING, 0) => [a, b, c, d, b, c, a, d],
            (CARRYING, 1) => [b, c, a, d, c, a, b, d],
            (CARRYING, _) => [c, a, b, d, a, b, c, d],
            (_, 0) => [a, b, c, d, w, x, y, z],
            (_, 1) => [b, c, a, d, w, x, y, z],
            _ => [c, a, b, d, w, x, y, z],
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

    /// 1 in the places of the second row's vector.
    #[inline(always)]
    fn second(self) -> S::Eight {
        self.0.load_eight(&[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0])
    }

    /// The number of a place in every place.
    #[inline(always)]
    fn each<const PLACE: usize>(self, pair: S::Eight) -> S::Eight {
        let number = self.0.eight_numbers(pair)[PLACE];
        self.0.load_eight(&[number; 8])
    }
}
