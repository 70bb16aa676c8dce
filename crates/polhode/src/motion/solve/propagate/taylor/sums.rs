//! Sums of products of Taylor coefficients, optimised for SIMD.
//!
//! The sums of the motion itself are in `one.rs` and `many.rs`. For a single body ([`OneBody`])
//! loops have few, predictable exits: they run by fours, and beyond the known coefficients they
//! read zeros.
//!
//! The loops for several bodies ([`SeveralBodies`]) end at the last term, because there is enough
//! other work. Both use the same order of terms, and adding zeros does not change a sum that
//! begins with +0. Each lane is therefore bit-identical to its body alone.

use core::ops::Mul;

use super::pair::Pair;
use super::row::{Row, Series, TERMS, Vectors};
use crate::math::machine::Machine;
use crate::math::number::Number;

/// Implementation of the sums, for one number type.
pub(super) trait SeriesSums: Copy {
    /// Number type of the sums.
    type N: Number;

    /// Runs long work in a separate function. Inlined in the loop over n, its setup would be
    /// repeated for every n.
    fn apart<R>(self, work: impl FnOnce(Self) -> R) -> R;

    /// Returns Σ aₖ bₙ₋ₖ, k = 0 … n: coefficient n of a product.
    fn product(self, a: &Series<Self::N>, b: &Series<Self::N>, n: usize) -> Row<Self::N>;

    /// Returns coefficient n of the rows x times each component of b.
    fn outer(self, x: &Series<Self::N>, b: &Series<Self::N>, n: usize) -> [Row<Self::N>; 3];

    /// Returns coefficient n of (a2 a3, a3 a1, a1 a2).
    fn others(self, a: &Vectors<Self::N>, n: usize) -> Row<Self::N>;

    /// Returns the changes from the constants of a pair's series after h, up to an order.
    fn pair_increment<T>(
        self,
        c: &[T; TERMS],
        pair: impl Fn(&T) -> &Pair<Self::N>,
        order: usize,
        h: Self::N,
    ) -> Pair<Self::N>;

    /// Returns c₁ h + c₂ h² + … up to an order: the change from the constant of a series.
    fn increment(self, c: &Series<Self::N>, order: usize, h: Self::N) -> Row<Self::N>;

    /// Returns coefficient n of v × b = Σ bᵢ v × eᵢ.
    #[inline(always)]
    fn cross(self, v: &Series<Self::N>, b: &Series<Self::N>, n: usize) -> Row<Self::N> {
        let [p, q, r] = self.outer(v, b, n).map(|sum| sum.0);
        Row([r[1] - q[2], p[2] - r[0], q[0] - p[1], p[0].like(0.0)])
    }
}

/// Sums for a single body; a row is a register.
#[derive(Clone, Copy)]
pub(super) struct OneBody<S>(pub(super) S);

impl<S: Machine> SeriesSums for OneBody<S> {
    type N = f64;

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
    fn outer(self, x: &Series, b: &Series, n: usize) -> [Row; 3] {
        let s = self.0;
        let [mut p, mut q, mut r] = [s.splat(0.0); 3];
        for (x, b) in x.forward().zip(b.backward(n)) {
            for k in 0..4 {
                let (x, [b1, b2, b3, _]) = (s.load(&x[k].0), b[3 - k].0);
                p = x.mul_add(s.splat(b1), p);
                q = x.mul_add(s.splat(b2), q);
                r = x.mul_add(s.splat(b3), r);
            }
        }
        let (x, [b1, b2, b3, _]) = (s.load(&x.at(0).0), b.at(n).0);
        p = x.mul_add(s.splat(b1), p);
        q = x.mul_add(s.splat(b2), q);
        r = x.mul_add(s.splat(b3), r);
        [p, q, r].map(|sum| Row(s.numbers(sum)))
    }

    #[inline(always)]
    fn others(self, a: &Vectors, n: usize) -> Row {
        // a times a cycled is (a1 a2, a2 a3, a3 a1); one more cycle puts each product in its place
        self.product(&a.rows, &a.cycled, n).cycled()
    }

    #[inline(always)]
    fn pair_increment<T>(self, c: &[T; TERMS], pair: impl Fn(&T) -> &Pair, order: usize, h: f64) -> Pair {
        let s = self.0;
        let load = |c: &T| s.load_eight(&pair(c).0);
        Pair(s.eight_numbers(polynomial(&c[1..=order], load, Number::mul_add, s.eight(0.0), s.eight(h))))
    }

    #[inline(always)]
    fn increment(self, c: &Series, order: usize, h: f64) -> Row {
        let s = self.0;
        Row(s.numbers(polynomial(
            &c[1..=order],
            |row| s.load(&row.0),
            Number::mul_add,
            s.splat(0.0),
            s.splat(h),
        )))
    }
}

/// Returns c₁ h + c₂ h² + …
#[inline(always)]
fn polynomial<T, V: Copy + Mul<Output = V>>(
    c: &[T],
    load: impl Fn(&T) -> V,
    mul_add: impl Fn(V, V, V) -> V,
    none: V,
    h: V,
) -> V {
    // Group every fourth power: four short dependency chains instead of a long one.
    let square = h * h;
    let fourth = square * square;
    let mut sums = [none; 4];
    let (fours, last) = c.as_chunks::<4>();
    for (sum, c) in sums.iter_mut().zip(last) {
        *sum = load(c);
    }
    for [first, second, third, last] in fours.iter().rev() {
        sums[0] = mul_add(sums[0], fourth, load(first));
        sums[1] = mul_add(sums[1], fourth, load(second));
        sums[2] = mul_add(sums[2], fourth, load(third));
        sums[3] = mul_add(sums[3], fourth, load(last));
    }
    let [first, second, third, last] = sums;
    mul_add(mul_add(last, h, third), square, mul_add(second, h, first)) * h
}

/// Sums for as many bodies as a register holds numbers; a row is four registers.
#[derive(Clone, Copy)]
pub(super) struct SeveralBodies<S>(pub(super) S);

impl<S: Machine> SeriesSums for SeveralBodies<S> {
    type N = S::Many;

    #[inline(always)]
    fn apart<R>(self, work: impl FnOnce(Self) -> R) -> R {
        self.0.apart(
            #[inline(always)]
            || work(self),
        )
    }

    #[inline(always)]
    fn product(self, a: &Series<S::Many>, b: &Series<S::Many>, n: usize) -> Row<S::Many> {
        let mut sum = self.zero();
        for (&a, &b) in a[1..=n].iter().zip(b[..n].iter().rev()) {
            sum = a.mul_add(b, sum);
        }
        a[0].mul_add(b[n], sum)
    }

    #[inline(always)]
    fn outer(self, x: &Series<S::Many>, b: &Series<S::Many>, n: usize) -> [Row<S::Many>; 3] {
        let mut sums = [self.zero(); 3];
        for (&x, b) in x[1..=n].iter().zip(b[..n].iter().rev()) {
            sums = plus_outer(sums, x, b);
        }
        plus_outer(sums, x[0], &b[n])
    }

    #[inline(always)]
    fn others(self, a: &Vectors<S::Many>, n: usize) -> Row<S::Many> {
        let a = &a.rows;
        let mut sum = self.zero();
        for (&a, &b) in a[1..=n].iter().zip(a[..n].iter().rev()) {
            sum = a.mul_add(b.cycled(), sum);
        }
        a[0].mul_add(a[n].cycled(), sum).cycled().vector()
    }

    #[inline(always)]
    fn pair_increment<T>(
        self,
        c: &[T; TERMS],
        pair: impl Fn(&T) -> &Pair<S::Many>,
        order: usize,
        h: S::Many,
    ) -> Pair<S::Many> {
        let (c, h) = (&c[1..=order], Row::splat(h));
        let first = polynomial(c, |c| pair(c).first(), Row::mul_add, self.zero(), h);
        Pair::new(first, polynomial(c, |c| pair(c).second(), Row::mul_add, self.zero(), h))
    }

    #[inline(always)]
    fn increment(self, c: &Series<S::Many>, order: usize, h: S::Many) -> Row<S::Many> {
        polynomial(&c[1..=order], |row| *row, Row::mul_add, self.zero(), Row::splat(h))
    }
}

impl<S: Machine> SeveralBodies<S> {
    #[inline(always)]
    fn zero(self) -> Row<S::Many> {
        Row::splat(self.0.many(0.0))
    }
}

/// Adds x times each component of b.
#[inline(always)]
fn plus_outer<N: Number>([p, q, r]: [Row<N>; 3], x: Row<N>, b: &Row<N>) -> [Row<N>; 3] {
    let [b1, b2, b3, _] = b.0;
    [x.mul_add(Row::splat(b1), p), x.mul_add(Row::splat(b2), q), x.mul_add(Row::splat(b3), r)]
}
