//! Sums of products of Taylor coefficients, as the machine does them best.
//!
//! Almost all the time of a step is spent in these sums. Of one body ([`ByFours`]) two things count: the terms that need the newest
//! coefficients come last, so that the processor works on all others while those are still being made; and loops have few, foreseeable
//! ends: they go by fours, over coefficients that are not known yet and therefore zero.
//!
//! Of eight bodies ([`SideBySide`]) there is enough to do meanwhile, and loops end where they should. The order of the terms is the same,
//! and a sum that begins with +0 does not change by zeros: so each lane has the bits that its body has alone.

use super::row::{Row, Series, Vectors};
use crate::math::machine::{Machine, Plain};
use crate::math::number::Number;

/// How sums are done, and of what.
pub(super) trait Sums: Copy {
    /// What is added up.
    type N: Number;
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

    /// Both of the last, in one loop.
    fn others_and_outer(
        self,
        a: &Vectors<Self::N>,
        x: &Series<Self::N>,
        b: &Vectors<Self::N>,
        n: usize,
    ) -> (Row<Self::N>, [Row<Self::N>; 3]);

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
    type Apart = ByFours<Plain>;

    #[inline(never)]
    fn apart<R>(self, work: impl FnOnce(Self::Apart) -> R) -> R {
        work(ByFours(Plain))
    }

    #[inline(always)]
    fn product(self, a: &Series, b: &Series, n: usize) -> Row {
        let s = self.0;
        let mut sum = s.splat(0.0);
        for (a, b) in a.forward().zip(b.backward(n)) {
            for k in 0..4 {
                sum = sum + s.load(&a[k].0) * s.load(&b[3 - k].0);
            }
        }
        Row(s.numbers(sum + s.load(&a.at(0).0) * s.load(&b.at(n).0)))
    }

    #[inline(always)]
    fn outer(self, x: &Series, b: &Vectors, n: usize) -> [Row; 3] {
        let s = self.0;
        let [b1, b2, b3] = &b.components;
        let [mut p, mut q, mut r] = [s.splat(0.0); 3];
        for (x, ((b1, b2), b3)) in x.forward().zip(b1.backward(n).zip(b2.backward(n)).zip(b3.backward(n))) {
            for k in 0..4 {
                let x = s.load(&x[k].0);
                p = p + x * s.splat(b1[3 - k]);
                q = q + x * s.splat(b2[3 - k]);
                r = r + x * s.splat(b3[3 - k]);
            }
        }
        let x = s.load(&x.at(0).0);
        p = p + x * s.splat(b1.at(n));
        q = q + x * s.splat(b2.at(n));
        r = r + x * s.splat(b3.at(n));
        [p, q, r].map(|sum| Row(s.numbers(sum)))
    }

    #[inline(always)]
    fn others(self, a: &Vectors, n: usize) -> Row {
        // a and a turned: turning once more brings (a1 a2, a2 a3, a3 a1) there
        self.product(&a.rows, &a.turned, n).turned()
    }

    #[inline(always)]
    fn others_and_outer(self, a: &Vectors, x: &Series, b: &Vectors, n: usize) -> (Row, [Row; 3]) {
        let s = self.0;
        let [b1, b2, b3] = &b.components;
        let [mut others, mut p, mut q, mut r] = [s.splat(0.0); 4];
        let forward = a.rows.forward().zip(x.forward());
        let backward = b1.backward(n).zip(b2.backward(n)).zip(b3.backward(n)).zip(a.turned.backward(n));
        for ((a, x), (((b1, b2), b3), turned)) in forward.zip(backward) {
            for k in 0..4 {
                others = others + s.load(&a[k].0) * s.load(&turned[3 - k].0);
                let x = s.load(&x[k].0);
                p = p + x * s.splat(b1[3 - k]);
                q = q + x * s.splat(b2[3 - k]);
                r = r + x * s.splat(b3[3 - k]);
            }
        }
        let x = s.load(&x.at(0).0);
        others = others + s.load(&a.rows.at(0).0) * s.load(&a.turned.at(n).0);
        let outer = [p + x * s.splat(b1.at(n)), q + x * s.splat(b2.at(n)), r + x * s.splat(b3.at(n))];
        (Row(s.numbers(others)).turned(), outer.map(|sum| Row(s.numbers(sum))))
    }

    #[inline(always)]
    fn increment(self, c: &Series, order: usize, h: f64) -> Row {
        let s = self.0;
        let h = s.splat(h);
        // Odd and even powers by themselves: two short chains instead of a long one.
        let square = h * h;
        let (mut odd, mut even) = (s.splat(0.0), s.splat(0.0));
        let (pairs, last) = c[1..=order].as_chunks();
        if let [last] = last {
            odd = s.load(&last.0);
        }
        for [first, second] in pairs.iter().rev() {
            odd = odd * square + s.load(&first.0);
            even = even * square + s.load(&second.0);
        }
        Row(s.numbers((odd + even * h) * h))
    }
}

/// Eight bodies, a row in four registers.
#[derive(Clone, Copy)]
pub(super) struct SideBySide<S>(pub(super) S);

impl<S: Machine> SideBySide<S> {
    #[inline(always)]
    fn zero(self) -> Row<S::Eight> {
        Row::splat(self.0.eight(0.0))
    }
}

impl<S: Machine> Sums for SideBySide<S> {
    type N = S::Eight;
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
            sum = sum + a * b;
        }
        sum + a[0] * b[n]
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
            sum = sum + a * b.turned();
        }
        (sum + a[0] * a[n].turned()).turned().vector()
    }

    #[inline(always)]
    fn others_and_outer(
        self,
        a: &Vectors<S::Eight>,
        x: &Series<S::Eight>,
        b: &Vectors<S::Eight>,
        n: usize,
    ) -> (Row<S::Eight>, [Row<S::Eight>; 3]) {
        let (a, b) = (&a.rows, &b.rows);
        let (mut others, mut sums) = (self.zero(), [self.zero(); 3]);
        let forward = a[1..=n].iter().zip(&x[1..=n]);
        let backward = a[..n].iter().rev().zip(b[..n].iter().rev());
        for ((&a, &x), (&back, b)) in forward.zip(backward) {
            others = others + a * back.turned();
            sums = plus_outer(sums, x, b);
        }
        ((others + a[0] * a[n].turned()).turned().vector(), plus_outer(sums, x[0], &b[n]))
    }

    #[inline(always)]
    fn increment(self, c: &Series<S::Eight>, order: usize, h: S::Eight) -> Row<S::Eight> {
        let (h, square) = (Row::splat(h), Row::splat(h * h));
        let (mut odd, mut even) = (self.zero(), self.zero());
        let (pairs, last) = c[1..=order].as_chunks();
        if let &[last] = last {
            odd = last;
        }
        for &[first, second] in pairs.iter().rev() {
            odd = odd * square + first;
            even = even * square + second;
        }
        (odd + even * h) * h
    }
}

/// Adds x times each component of b.
#[inline(always)]
fn plus_outer<N: Number>([p, q, r]: [Row<N>; 3], x: Row<N>, b: &Row<N>) -> [Row<N>; 3] {
    let [b1, b2, b3, _] = b.0;
    [p + x * Row::splat(b1), q + x * Row::splat(b2), r + x * Row::splat(b3)]
}
