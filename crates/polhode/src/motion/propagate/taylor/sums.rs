//! Sums of products of Taylor coefficients, as the machine does them best.
//!
//! Almost all the time of a step is spent in these sums. Of one body ([`ByFours`]) three things count: what needs the newest coefficients
//! comes last, so that the processor works on all else while those are still being made; loops have few, foreseeable ends: they go by
//! fours, beyond the coefficients that are known too, where they meet zeros; and what is multiplied by the same numbers is in one register.
//!
//! Of eight bodies ([`SideBySide`]) there is enough to do meanwhile, and loops end where they should. The order of the terms is the same,
//! and a sum that begins with +0 does not change by zeros: so each lane has the bits that its body has alone.

use super::row::{INVERSES, Row, Series, Vectors};
use super::turned::{Newest, Pair, SIGNS, Turned};
use crate::math::machine::Machine;
use crate::math::number::{MulAdd, Number};

/// How sums are done, and of what.
pub(super) trait Sums: Copy {
    /// What is added up.
    type N: Number;
    /// Sums that are not complete yet.
    type Before;

    /// Runs what is long as a function of its own: inside the loop over n all of it would be prepared for each n.
    fn apart<R>(self, work: impl FnOnce(Self) -> R) -> R;

    /// Σ aₖ bₙ₋ₖ, k = 0 … n: coefficient n of a product.
    fn product(self, a: &Series<Self::N>, b: &Series<Self::N>, n: usize) -> Row<Self::N>;

    /// Coefficients n of the rows x times each component of b.
    fn outer(self, x: &Series<Self::N>, b: &Vectors<Self::N>, n: usize) -> [Row<Self::N>; 3];

    /// Coefficient n of (a2 a3, a3 a1, a1 a2).
    fn others(self, a: &Vectors<Self::N>, n: usize) -> Row<Self::N>;

    /// Coefficients n of (ω2 ω3 …) and of what turns times each component of Ω, without the products that coefficients n have a part in:
    /// sums that the processor works on while those are still being made. What coefficients n − 1 have a part in comes last.
    fn before(
        self,
        omega: &Vectors<Self::N>,
        turned: &Turned<Self::N>,
        turning: &Vectors<Self::N>,
        n: usize,
    ) -> Self::Before;

    /// (ω2 ω3 …) and (q ∘ Ω, v × Ω) with those products too; by now coefficients n are in their places, and those 0 and n of Ω are given.
    fn with(
        self,
        before: Self::Before,
        omega: &Vectors<Self::N>,
        turned: &Turned<Self::N>,
        turning: [Row<Self::N>; 2],
        newest: (usize, &Newest<Self::N>),
    ) -> (Row<Self::N>, Pair<Self::N>);

    /// Half of what turns, and the vector, over n.
    fn shared(self, pair: Pair<Self::N>, n: usize) -> Pair<Self::N>;

    /// What the turn's series adds to its constant.
    fn turn_increment(self, turned: &Turned<Self::N>, order: usize, h: Self::N) -> Row<Self::N>;

    /// c₁ h + c₂ h² + … up to an order: what a series adds to its constant.
    fn increment(self, c: &Series<Self::N>, order: usize, h: Self::N) -> Row<Self::N>;

    /// Coefficient n of v × b = Σ bᵢ v × eᵢ.
    #[inline(always)]
    fn cross(self, v: &Series<Self::N>, b: &Vectors<Self::N>, n: usize) -> Row<Self::N> {
        let [p, q, r] = self.outer(v, b, n).map(|sum| sum.0);
        Row([r[1] - q[2], p[2] - r[0], q[0] - p[1], p[0].like(0.0)])
    }
}

/// One body, a row in a register.
#[derive(Clone, Copy)]
pub(super) struct ByFours<S>(pub(super) S);

impl<S: Machine> Sums for ByFours<S> {
    type N = f64;
    type Before = (S::Four, [S::Eight; 3]);

    #[inline(always)]
    fn apart<R>(self, work: impl FnOnce(Self) -> R) -> R {
        self.0.apart(
            #[inline(always)]
            || work(self),
        )
    }

    #[inline(always)]
    fn product(self, a: &Series, b: &Series, n: usize) -> Row {
        let s = self.0;
        let mut sum = s.splat(0.0);
        for (a, b) in a.forward().zip(b.backward(n)) {
            for k in 0..4 {
                sum = s.load(&a[k].0).mul_add(s.load(&b[3 - k].0), sum);
            }
        }
        Row(s.numbers(s.load(&a.at(0).0).mul_add(s.load(&b.at(n).0), sum)))
    }

    #[inline(always)]
    fn outer(self, x: &Series, b: &Vectors, n: usize) -> [Row; 3] {
        let s = self.0;
        let [mut p, mut q, mut r] = [s.splat(0.0); 3];
        for (x, b) in x.forward().zip(b.rows.backward(n)) {
            for k in 0..4 {
                let (x, [b1, b2, b3, _]) = (s.load(&x[k].0), b[3 - k].0);
                p = x.mul_add(s.splat(b1), p);
                q = x.mul_add(s.splat(b2), q);
                r = x.mul_add(s.splat(b3), r);
            }
        }
        let (x, [b1, b2, b3, _]) = (s.load(&x.at(0).0), b.rows.at(n).0);
        p = x.mul_add(s.splat(b1), p);
        q = x.mul_add(s.splat(b2), q);
        r = x.mul_add(s.splat(b3), r);
        [p, q, r].map(|sum| Row(s.numbers(sum)))
    }

    #[inline(always)]
    fn others(self, a: &Vectors, n: usize) -> Row {
        // a and a turned: turning once more brings (a1 a2, a2 a3, a3 a1) there
        self.product(&a.rows, &a.turned, n).turned()
    }

    #[inline(always)]
    fn before(self, omega: &Vectors, turned: &Turned, turning: &Vectors, n: usize) -> Self::Before {
        let s = self.0;
        let load = |w: &Row, pair: &Pair| (s.load(&w.0), s.load_eight(&pair.0));
        let spread = |w: &Row, b: &Row| (s.load(&w.0), [s.eight(b.0[0]), s.eight(b.0[1]), s.eight(b.0[2])]);
        let mut sums = (s.splat(0.0), [s.eight(0.0); 3]);
        let forward = omega.rows.forward_from_second().zip(turned.forward_from_second());
        let [rows, turns] = [&turning.later[0], &omega.later[1]];
        let backward = turns.backward_to_second(n).zip(rows.backward_to_second(n));
        for ((w, pairs), (turns, rows)) in forward.zip(backward) {
            for k in 0..4 {
                sums = plus_products(sums, load(&w[k], &pairs[k]), spread(&turns[3 - k], &rows[3 - k]));
            }
        }
        if n > 1 {
            let last = n - 1;
            let forward = |k: usize| load(&omega.rows.at(k), &turned.at(k));
            let backward = |k: usize| spread(&omega.turned.at(k), &turning.rows.at(k));
            sums = plus_products(sums, forward(1), backward(last));
            if last > 1 {
                sums = plus_products(sums, forward(last), backward(1));
            }
        }
        sums
    }

    #[inline(always)]
    fn with(
        self,
        (mut others, [p, q, r]): Self::Before,
        omega: &Vectors,
        turned: &Turned,
        [first, last]: [Row; 2],
        (n, newest): (usize, &Newest),
    ) -> (Row, Pair) {
        let s = self.0;
        let mut sum = self.turned([p, q, r]);
        let [pair, start] = [newest.pair, turned.at(0)].map(|pair| s.load_eight(&pair.0));
        if n > 0 {
            others = s.load(&newest.omega.0).mul_add(s.load(&omega.turned.at(0).0), others);
            for (axis, signs) in SIGNS.iter().enumerate() {
                let turning = s.load_eight(signs) * s.eight(first.0[axis]);
                sum = self.about(pair, axis).mul_add(turning, sum);
            }
        }
        others = s.load(&omega.rows.at(0).0).mul_add(s.load(&newest.omega.turned().0), others);
        // A chain of its own: both are as new.
        let mut more = s.eight(0.0);
        for (axis, signs) in SIGNS.iter().enumerate() {
            let turned = s.load_eight(signs) * self.about(start, axis);
            more = turned.mul_add(s.eight(last.0[axis]), more);
        }
        let sum = sum + more;
        // ω and ω turned: turning once more brings (ω1 ω2, ω2 ω3, ω3 ω1) there.
        (Row(s.numbers(others)).turned(), Pair(s.eight_numbers(sum)))
    }

    #[inline(always)]
    fn shared(self, pair: Pair, n: usize) -> Pair {
        let s = self.0;
        let ([h, k], [i, l]) = (INVERSES[2 * n], INVERSES[n]);
        let (inverse, rest) = ([h, h, h, h, i, i, i, i], [k, k, k, k, l, l, l, l]);
        let pair = s.load_eight(&pair.0);
        Pair(s.eight_numbers(pair.mul_add(s.load_eight(&inverse), pair * s.load_eight(&rest))))
    }

    #[inline(always)]
    fn turn_increment(self, turned: &Turned, order: usize, h: f64) -> Row {
        self.polynomial(&turned.pairs()[1..=order], |pair| pair.turn().0, h)
    }

    #[inline(always)]
    fn increment(self, c: &Series, order: usize, h: f64) -> Row {
        self.polynomial(&c[1..=order], |row| row.0, h)
    }
}

/// Adds the products of two coefficients: ω and ω turned; what turns, and each component of Ω.
#[inline(always)]
fn plus_products<W: MulAdd, P: MulAdd>(
    (others, [p, q, r]): (W, [P; 3]),
    (w, pair): (W, P),
    (turned, [x, y, z]): (W, [P; 3]),
) -> (W, [P; 3]) {
    let outer = [pair.mul_add(x, p), pair.mul_add(y, q), pair.mul_add(z, r)];
    (w.mul_add(turned, others), outer)
}

impl<S: Machine> ByFours<S> {
    /// The numbers of (q ∘ eᵢ, v × eᵢ), to be multiplied by [`SIGNS`].
    #[inline(always)]
    fn about(self, pair: S::Eight, axis: usize) -> S::Eight {
        self.0.load_eight(&Pair(self.0.eight_numbers(pair)).about(axis).0)
    }

    /// (q ∘ e1, v × e1) of the first, and so on, together: zeros add nothing.
    #[inline(always)]
    fn turned(self, [p, q, r]: [S::Eight; 3]) -> S::Eight {
        let s = self.0;
        let sum = self.about(p, 0).mul_add(s.load_eight(&SIGNS[0]), s.eight(0.0));
        let sum = self.about(q, 1).mul_add(s.load_eight(&SIGNS[1]), sum);
        self.about(r, 2).mul_add(s.load_eight(&SIGNS[2]), sum)
    }

    /// c₁ h + c₂ h² + …
    #[inline(always)]
    fn polynomial<T>(self, c: &[T], row: impl Fn(&T) -> [f64; 4], h: f64) -> Row {
        let s = self.0;
        let h = s.splat(h);
        // Odd and even powers by themselves: two short chains instead of a long one.
        let square = h * h;
        let (mut odd, mut even) = (s.splat(0.0), s.splat(0.0));
        let (pairs, last) = c.as_chunks();
        if let [last] = last {
            odd = s.load(&row(last));
        }
        for [first, second] in pairs.iter().rev() {
            odd = odd.mul_add(square, s.load(&row(first)));
            even = even.mul_add(square, s.load(&row(second)));
        }
        Row(s.numbers(even.mul_add(h, odd) * h))
    }
}

/// Eight bodies, a row in four registers.
#[derive(Clone, Copy)]
pub(super) struct SideBySide<S>(pub(super) S);

impl<S: Machine> Sums for SideBySide<S> {
    type N = S::Eight;
    type Before = (Row<S::Eight>, Pair<S::Eight>);

    #[inline(always)]
    fn apart<R>(self, work: impl FnOnce(Self) -> R) -> R {
        self.0.apart(
            #[inline(always)]
            || work(self),
        )
    }

    #[inline(always)]
    fn product(self, a: &Series<S::Eight>, b: &Series<S::Eight>, n: usize) -> Row<S::Eight> {
        let mut sum = self.zero();
        for (&a, &b) in a[1..=n].iter().zip(b[..n].iter().rev()) {
            sum = a.mul_add(b, sum);
        }
        a[0].mul_add(b[n], sum)
    }

    #[inline(always)]
    fn outer(self, x: &Series<S::Eight>, b: &Vectors<S::Eight>, n: usize) -> [Row<S::Eight>; 3] {
        let b = &b.rows;
        let mut sums = [self.zero(); 3];
        for (&x, b) in x[1..=n].iter().zip(b[..n].iter().rev()) {
            sums = plus_outer(sums, x, b);
        }
        plus_outer(sums, x[0], &b[n])
    }

    #[inline(always)]
    fn others(self, a: &Vectors<S::Eight>, n: usize) -> Row<S::Eight> {
        let a = &a.rows;
        let mut sum = self.zero();
        for (&a, &b) in a[1..=n].iter().zip(a[..n].iter().rev()) {
            sum = a.mul_add(b.turned(), sum);
        }
        a[0].mul_add(a[n].turned(), sum).turned().vector()
    }

    #[inline(always)]
    fn before(
        self,
        omega: &Vectors<S::Eight>,
        turned: &Turned<S::Eight>,
        turning: &Vectors<S::Eight>,
        n: usize,
    ) -> Self::Before {
        let (others, turns, seen) = if turned.carries {
            self.outer_without_ends::<true>(omega, turned, turning, n)
        } else {
            self.outer_without_ends::<false>(omega, turned, turning, n)
        };
        let ([p, q, r], [a, b, c]) = (turns.map(|row| row.0), seen.map(|row| row.0));
        // [`SIGNS`] says how they come together.
        let turn = [-p[1] - q[2] - r[3], p[0] - q[3] + r[2], p[3] + q[0] - r[1], q[1] - p[2] + r[0]];
        let seen = [c[1] - b[2], a[2] - c[0], b[0] - a[1], self.0.eight(0.0)];
        (others, Pair::new(Row(turn), Row(seen)))
    }

    #[inline(always)]
    fn with(
        self,
        (mut others, mut sum): Self::Before,
        omega: &Vectors<S::Eight>,
        turned: &Turned<S::Eight>,
        [first, last]: [Row<S::Eight>; 2],
        (n, newest): (usize, &Newest<S::Eight>),
    ) -> (Row<S::Eight>, Pair<S::Eight>) {
        let (zero, start) = (self.0.eight(0.0), omega.rows.at(0));
        if n > 0 {
            others = newest.omega.mul_add(start.turned(), others);
            sum = sum.plus_turned(newest.pair, first);
        }
        others = start.mul_add(newest.omega.turned(), others);
        let new = Pair([zero; 8]).plus_turned(turned.at(0), last);
        let [turn, seen] = [sum.turn() + new.turn(), sum.seen() + new.seen()];
        (others.turned().vector(), Pair::new(turn, seen.vector()))
    }

    #[inline(always)]
    fn shared(self, pair: Pair<S::Eight>, n: usize) -> Pair<S::Eight> {
        Pair::new(pair.turn().over(2 * n), pair.seen().over(n).vector())
    }

    #[inline(always)]
    fn turn_increment(self, turned: &Turned<S::Eight>, order: usize, h: S::Eight) -> Row<S::Eight> {
        self.polynomial(&turned.pairs()[1..=order], |pair| pair.turn(), h)
    }

    #[inline(always)]
    fn increment(self, c: &Series<S::Eight>, order: usize, h: S::Eight) -> Row<S::Eight> {
        self.polynomial(&c[1..=order], |row| *row, h)
    }
}

/// (ω2 ω3 …), and what turns and the vector, each times the components of Ω.
type Outer<N> = (Row<N>, [Row<N>; 3], [Row<N>; 3]);

impl<S: Machine> SideBySide<S> {
    /// Products of coefficients 1 … n − 1, the first and the last at the end.
    #[inline(always)]
    fn outer_without_ends<const CARRIES: bool>(
        self,
        omega: &Vectors<S::Eight>,
        turned: &Turned<S::Eight>,
        turning: &Vectors<S::Eight>,
        n: usize,
    ) -> Outer<S::Eight> {
        let none = self.zero();
        let mut sums = (none, [none; 3], [none; 3]);
        let (omega, turning, pairs) = (&omega.rows, &turning.rows, turned.pairs());
        let middle = 2..n.max(3) - 1;
        let forward = omega[middle.clone()].iter().zip(&pairs[middle.clone()]);
        let backward = omega[middle.clone()].iter().rev().zip(turning[middle].iter().rev());
        for (forward, backward) in forward.zip(backward) {
            sums = plus_outers::<_, CARRIES>(sums, forward, backward);
        }
        if n > 1 {
            let last = n - 1;
            let [one, end] = [1, last].map(|k| ((&omega[k], &pairs[k]), (&omega[k], &turning[k])));
            sums = plus_outers::<_, CARRIES>(sums, one.0, end.1);
            if last > 1 {
                sums = plus_outers::<_, CARRIES>(sums, end.0, one.1);
            }
        }
        sums
    }

    #[inline(always)]
    fn zero(self) -> Row<S::Eight> {
        Row::splat(self.0.eight(0.0))
    }

    /// c₁ h + c₂ h² + …
    #[inline(always)]
    fn polynomial<T>(self, c: &[T], row: impl Fn(&T) -> Row<S::Eight>, h: S::Eight) -> Row<S::Eight> {
        let (h, square) = (Row::splat(h), Row::splat(h * h));
        let (mut odd, mut even) = (self.zero(), self.zero());
        let (pairs, last) = c.as_chunks();
        if let [last] = last {
            odd = row(last);
        }
        for [first, second] in pairs.iter().rev() {
            odd = odd.mul_add(square, row(first));
            even = even.mul_add(square, row(second));
        }
        even.mul_add(h, odd) * h
    }
}

/// Adds the products of two coefficients.
#[inline(always)]
fn plus_outers<N: Number, const CARRIES: bool>(
    (others, turns, seen): Outer<N>,
    (w, pair): (&Row<N>, &Pair<N>),
    (back, turning): (&Row<N>, &Row<N>),
) -> Outer<N> {
    let others = w.mul_add(back.turned(), others);
    let turns = plus_outer(turns, pair.turn(), turning);
    (others, turns, if CARRIES { plus_outer(seen, pair.seen(), turning) } else { seen })
}

/// Adds x times each component of b.
#[inline(always)]
fn plus_outer<N: Number>([p, q, r]: [Row<N>; 3], x: Row<N>, b: &Row<N>) -> [Row<N>; 3] {
    let [b1, b2, b3, _] = b.0;
    [x.mul_add(Row::splat(b1), p), x.mul_add(Row::splat(b2), q), x.mul_add(Row::splat(b3), r)]
}
