//! Sums of products of Taylor coefficients, as the machine does them best.
//!
//! Almost all the time of a step is spent in these sums. Of one body ([`ByFours`]) three things count: what needs the newest coefficients
//! comes last, so that the processor works on all else while those are still being made; loops have few, foreseeable ends: they go by
//! fours, over coefficients that are not known yet and therefore zero; and what is multiplied by the same numbers is in one register.
//!
//! Of eight bodies ([`SideBySide`]) there is enough to do meanwhile, and loops end where they should. The order of the terms is the same,
//! and a sum that begins with +0 does not change by zeros: so each lane has the bits that its body has alone.

use super::row::{Row, Series, Vectors};
use super::turned::{Newest, Pair, Turned};
use crate::math::machine::Machine;
use crate::math::number::{MulAdd as _, Number};

/// How sums are done, and of what.
pub(super) trait Sums: Copy {
    /// What is added up.
    type N: Number;
    /// Sums that are not complete yet.
    type Before;
    /// How they are done in a function of its own.
    type Apart: Sums<N = Self::N>;

    /// Runs what is long as a function of its own: inside the loop over n all of it would be prepared for each n.
    fn apart<R>(self, work: impl FnOnce(Self::Apart) -> R) -> R;

    /// Σ aₖ bₙ₋ₖ, k = 0 … n: coefficient n of a product.
    fn product(self, a: &Series<Self::N>, b: &Series<Self::N>, n: usize) -> Row<Self::N>;

    /// Coefficients n of the rows x times each component of b.
    fn outer(self, x: &Series<Self::N>, b: &Vectors<Self::N>, n: usize) -> [Row<Self::N>; 3];

    /// Coefficient n of (a2 a3, a3 a1, a1 a2).
    fn others(self, a: &Vectors<Self::N>, n: usize) -> Row<Self::N>;

    /// Coefficients n of (ω2 ω3 …) and of what turns times each component of Ω, without the products that coefficients n have a part in:
    /// sums that the processor works on while those are still being made.
    fn before(
        self,
        omega: &Vectors<Self::N>,
        turned: &Turned<Self::N>,
        turning: &Vectors<Self::N>,
        n: usize,
    ) -> Self::Before;

    /// With those products too; by now coefficients n are in their places, and those 0 and n of Ω are given.
    fn with(
        self,
        before: Self::Before,
        omega: &Vectors<Self::N>,
        turned: &Turned<Self::N>,
        turning: (&Vectors<Self::N>, [Row<Self::N>; 2]),
        newest: (usize, &Newest<Self::N>),
    ) -> (Row<Self::N>, [Pair<Self::N>; 3]);

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
    type Apart = Self;

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
        let mut others = s.splat(0.0);
        let [mut p, mut q, mut r] = [s.eight(0.0); 3];
        let forward = omega.rows.forward().zip(turned.forward());
        let backward = turning.rows.backward(n).zip(omega.turned.backward(n));
        for ((w, pairs), (turning, back)) in forward.zip(backward) {
            for k in 0..4 {
                others = s.load(&w[k].0).mul_add(s.load(&back[3 - k].0), others);
                let (pair, [x, y, z, _]) = (s.load_eight(&pairs[k].0), turning[3 - k].0);
                p = pair.mul_add(s.eight(x), p);
                q = pair.mul_add(s.eight(y), q);
                r = pair.mul_add(s.eight(z), r);
            }
        }
        (others, [p, q, r])
    }

    #[inline(always)]
    fn with(
        self,
        (mut others, [mut p, mut q, mut r]): Self::Before,
        omega: &Vectors,
        turned: &Turned,
        (_, [first, last]): (&Vectors, [Row; 2]),
        (n, newest): (usize, &Newest),
    ) -> (Row, [Pair; 3]) {
        let s = self.0;
        if n > 0 {
            others = s.load(&newest.omega.0).mul_add(s.load(&omega.turned.at(0).0), others);
            let (pair, [x, y, z, _]) = (s.load_eight(&newest.pair.0), first.0);
            p = pair.mul_add(s.eight(x), p);
            q = pair.mul_add(s.eight(y), q);
            r = pair.mul_add(s.eight(z), r);
        }
        others = s.load(&omega.rows.at(0).0).mul_add(s.load(&newest.omega.turned().0), others);
        let (pair, [x, y, z, _]) = (s.load_eight(&turned.at(0).0), last.0);
        p = pair.mul_add(s.eight(x), p);
        q = pair.mul_add(s.eight(y), q);
        r = pair.mul_add(s.eight(z), r);
        // ω and ω turned: turning once more brings (ω1 ω2, ω2 ω3, ω3 ω1) there.
        (Row(s.numbers(others)).turned(), [p, q, r].map(|sum| Pair(s.eight_numbers(sum))))
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

impl<S: Machine> ByFours<S> {
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
    type Before = ();
    type Apart = Self;

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
        _: &Vectors<S::Eight>,
        _: &Turned<S::Eight>,
        _: &Vectors<S::Eight>,
        _: usize,
    ) -> Self::Before {
    }

    #[inline(always)]
    fn with(
        self,
        (): Self::Before,
        omega: &Vectors<S::Eight>,
        turned: &Turned<S::Eight>,
        (turning, _): (&Vectors<S::Eight>, [Row<S::Eight>; 2]),
        (n, _): (usize, &Newest<S::Eight>),
    ) -> (Row<S::Eight>, [Pair<S::Eight>; 3]) {
        let (omega, turning, pairs) = (&omega.rows, &turning.rows, turned.pairs());
        let (mut others, mut turns) = (self.zero(), [self.zero(); 3]);
        let forward = omega[1..=n].iter().zip(&pairs[1..=n]);
        let backward = omega[..n].iter().rev().zip(turning[..n].iter().rev());
        for ((&w, x), (&back, b)) in forward.zip(backward) {
            others = w.mul_add(back.turned(), others);
            turns = plus_outer(turns, x.turn(), b);
        }
        others = omega[0].mul_add(omega[n].turned(), others).turned().vector();
        let [p, q, r] = plus_outer(turns, pairs[0].turn(), &turning[n]);
        let mut seen = [self.zero(); 3];
        if turned.carries {
            // A loop of its own: there are no more registers.
            for (x, b) in pairs[1..=n].iter().zip(turning[..n].iter().rev()) {
                seen = plus_outer(seen, x.seen(), b);
            }
            seen = plus_outer(seen, pairs[0].seen(), &turning[n]);
        }
        let [a, b, c] = seen;
        (others, [Pair::new(p, a), Pair::new(q, b), Pair::new(r, c)])
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

impl<S: Machine> SideBySide<S> {
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

/// Adds x times each component of b.
#[inline(always)]
fn plus_outer<N: Number>([p, q, r]: [Row<N>; 3], x: Row<N>, b: &Row<N>) -> [Row<N>; 3] {
    let [b1, b2, b3, _] = b.0;
    [x.mul_add(Row::splat(b1), p), x.mul_add(Row::splat(b2), q), x.mul_add(Row::splat(b3), r)]
}
