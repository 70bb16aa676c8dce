//! Forward-mode differentiation: numbers with their derivatives.

use core::ops::{Add, Mul, Neg, Sub};

/// Number with its derivatives by N variables.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dual<const N: usize> {
    pub(super) value: f64,
    pub(super) by: [f64; N],
}

impl<const N: usize> Dual<N> {
    pub(super) const fn constant(value: f64) -> Self {
        Self { value, by: [0.0; N] }
    }

    /// Returns variable k with a value.
    pub(super) fn variable(value: f64, k: usize) -> Self {
        let mut this = Self::constant(value);
        if let Some(by) = this.by.get_mut(k) {
            *by = 1.0;
        }
        this
    }

    pub(super) fn scaled(self, factor: f64) -> Self {
        Self { value: factor * self.value, by: self.by.map(|by| factor * by) }
    }

    /// Returns f(self), given f and its derivative f′.
    fn chain(self, f: f64, slope: f64) -> Self {
        Self { value: f, by: self.by.map(|by| slope * by) }
    }

    pub(super) fn reciprocal(self) -> Self {
        let f = 1.0 / self.value;
        self.chain(f, -f * f)
    }

    /// Returns the polar angle of the point (x, self).
    pub(super) fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let by = core::array::from_fn(|k| (x.value * self.by[k] - self.value * x.by[k]) / square);
        Self { value: libm::atan2(self.value, x.value), by }
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    fn add(mut self, other: Self) -> Self {
        self.value += other.value;
        self.by.iter_mut().zip(other.by).for_each(|(a, b)| *a += b);
        self
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    fn sub(mut self, other: Self) -> Self {
        self.value -= other.value;
        self.by.iter_mut().zip(other.by).for_each(|(a, b)| *a -= b);
        self
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    fn mul(mut self, other: Self) -> Self {
        let (x, y) = (self.value, other.value);
        self.value = x * y;
        self.by = core::array::from_fn(|k| [y * self.by[k], x * other.by[k]].iter().sum());
        self
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.scaled(-1.0)
    }
}

/// Number with its derivatives by all estimated parameters, whose count is known at run time only.
#[derive(Clone, Debug)]
pub(super) struct Gradient {
    pub(super) value: f64,
    pub(super) by: Vec<f64>,
}

impl Gradient {
    pub(super) fn constant(value: f64, count: usize) -> Self {
        Self { value, by: vec![0.0; count] }
    }

    /// Returns a number with this value and the derivatives a ∂self + b ∂other.
    fn mixed(&self, other: &Self, value: f64, a: f64, b: f64) -> Self {
        Self { value, by: self.by.iter().zip(&other.by).map(|(x, y)| a * x + b * y).collect() }
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        self.mixed(other, self.value + other.value, 1.0, 1.0)
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        self.mixed(other, self.value - other.value, 1.0, -1.0)
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        self.mixed(other, self.value * other.value, other.value, self.value)
    }

    pub(super) fn over(&self, other: &Self) -> Self {
        let ratio = self.value / other.value;
        self.mixed(other, ratio, 1.0 / other.value, -ratio / other.value)
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self { value: factor * self.value, by: self.by.iter().map(|by| factor * by).collect() }
    }

    /// Returns the square root of a positive number.
    pub(super) fn root(&self) -> Self {
        let root = self.value.sqrt();
        Self { value: root, by: self.by.iter().map(|by| by / (2.0 * root)).collect() }
    }

    /// Returns Σ factor × term.
    pub(super) fn sum<'a>(count: usize, terms: impl IntoIterator<Item = (f64, &'a Self)>) -> Self {
        let mut all = Self::constant(0.0, count);
        for (factor, term) in terms {
            all.value += factor * term.value;
            all.by.iter_mut().zip(&term.by).for_each(|(a, b)| *a += factor * b);
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_differences() {
        let f = |x: f64, y: f64| {
            let (x, y) = (Dual::<2>::variable(x, 0), Dual::<2>::variable(y, 1));
            (x * x * y - x).atan2(y * y + x.scaled(3.0)) * (x + y).reciprocal() - -x
        };
        let (x, y, h) = (0.7, 1.9, 1e-5);
        let exact = f(x, y);
        let by_x = (f(x + h, y).value - f(x - h, y).value) / (2.0 * h);
        let by_y = (f(x, y + h).value - f(x, y - h).value) / (2.0 * h);
        assert!((exact.by[0] - by_x).abs() < 1e-9 && (exact.by[1] - by_y).abs() < 1e-9);
    }

    #[test]
    fn gradients_are_those_of_differences() {
        let f = |x: f64, y: f64| {
            let (x, y) =
                (Gradient { value: x, by: vec![1.0, 0.0] }, Gradient { value: y, by: vec![0.0, 1.0] });
            let sum = Gradient::sum(2, [(2.0, &x), (-0.5, &y)]);
            sum.times(&x).plus(&y.root()).over(&x.minus(&y.scaled(0.3)))
        };
        let (x, y, h) = (0.7, 1.9, 1e-5);
        let exact = f(x, y);
        let by_x = (f(x + h, y).value - f(x - h, y).value) / (2.0 * h);
        let by_y = (f(x, y + h).value - f(x, y - h).value) / (2.0 * h);
        assert!((exact.by[0] - by_x).abs() < 1e-7 * by_x.abs(), "{} {by_x}", exact.by[0]);
        assert!((exact.by[1] - by_y).abs() < 1e-7 * by_y.abs(), "{} {by_y}", exact.by[1]);
    }
}
