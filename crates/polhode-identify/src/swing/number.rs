//! Numbers that several tests share, and lengths and points composed of them.

use super::dual::Gradient;

/// Measured number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Measured value, or the initial value of an unknown number.
    pub value: f64,
    /// Standard deviation: 0 for an exact number, infinite for an unknown number.
    pub sd: f64,
}

impl Measured {
    /// Creates a number from a value and its standard deviation.
    pub const fn new(value: f64, sd: f64) -> Self {
        Self { value, sd }
    }

    /// Creates an exact number, with standard deviation 0.
    pub const fn exact(value: f64) -> Self {
        Self { value, sd: 0.0 }
    }

    /// Creates an unknown number from an initial value.
    pub const fn unknown(start: f64) -> Self {
        Self { value: start, sd: f64::INFINITY }
    }
}

/// Identifier of a number, returned by [`SwingPlan::number`](super::SwingPlan::number).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NumberId(pub(super) usize);

/// Linear combination of numbers of the plan, with a constant: x + Σ factor × number.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Linear {
    constant: f64,
    terms: Vec<(NumberId, f64)>,
}

impl Linear {
    /// Adds a multiple of a number.
    #[must_use]
    pub fn plus(mut self, factor: f64, number: NumberId) -> Self {
        self.terms.push((number, factor));
        self
    }

    /// Multiplies the constant and all terms by a factor.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.constant *= factor;
        self.terms.iter_mut().for_each(|(_, own)| *own *= factor);
        self
    }
}

impl From<f64> for Linear {
    fn from(constant: f64) -> Self {
        Self { constant, terms: Vec::new() }
    }
}

impl From<NumberId> for Linear {
    fn from(number: NumberId) -> Self {
        Self::from(0.0).plus(1.0, number)
    }
}

/// Point of a rig, m: x, y, z, each a linear combination of numbers of the plan.
///
/// ```
/// use polhode_identify::swing::{Measured, Point, SwingPlan};
/// let mut plan = SwingPlan::new(Measured::exact(2.0), [Measured::exact(0.0); 3]);
/// let r = plan.number("radius", "m", Measured::new(0.2, 0.5e-3));
/// // on a circle of this radius, at 30°, 5 cm above the origin
/// let point = Point::from([0.0, 0.0, 0.05]).shifted(r, [0.75_f64.sqrt(), 0.5, 0.0]);
/// # let _ = point;
/// ```
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Point(pub(super) [Linear; 3]);

impl Point {
    /// Returns the point shifted by a number of the plan times a vector.
    #[must_use]
    pub fn shifted(self, number: NumberId, vector: [f64; 3]) -> Self {
        let mut factors = vector.into_iter();
        Self(self.0.map(|component| match factors.next() {
            Some(factor) if factor != 0.0 => component.plus(factor, number),
            _ => component,
        }))
    }
}

impl From<[f64; 3]> for Point {
    fn from(at: [f64; 3]) -> Self {
        Self(at.map(Linear::from))
    }
}

impl From<[Linear; 3]> for Point {
    fn from(components: [Linear; 3]) -> Self {
        Self(components)
    }
}

/// Indices among all numbers: mass, centre, Ixx Iyy Izz Ixy Ixz Iyz, gravity; then the numbers of
/// the plan.
pub(super) const MASS: usize = 0;
pub(super) const CENTER: usize = 1;
pub(super) const TENSOR: usize = 4;
pub(super) const GRAVITY: usize = 10;
pub(super) const PLAN: usize = 11;

/// Values of all numbers of a plan; estimated ones carry a derivative.
#[derive(Clone, Debug)]
pub(super) struct Numbers {
    all: Vec<Gradient>,
    count: usize,
}

impl Numbers {
    /// Creates them from all values, with the index of each estimated one among the estimated
    /// parameters.
    pub(super) fn new(values: &[f64], places: &[Option<usize>]) -> Self {
        let count = places.iter().flatten().count();
        let all = values.iter().zip(places).map(|(&value, place)| {
            let mut number = Gradient::constant(value, count);
            if let Some(place) = place {
                number.by[*place] = 1.0;
            }
            number
        });
        Self { all: all.collect(), count }
    }

    /// Returns the number of estimated parameters.
    pub(super) const fn count(&self) -> usize {
        self.count
    }

    pub(super) fn at(&self, index: usize) -> &Gradient {
        &self.all[index]
    }

    pub(super) fn constant(&self, value: f64) -> Gradient {
        Gradient::constant(value, self.count)
    }

    pub(super) fn linear(&self, linear: &Linear) -> Gradient {
        let mut sum = Gradient::sum(
            self.count,
            linear.terms.iter().map(|&(NumberId(k), factor)| (factor, &self.all[PLAN + k])),
        );
        sum.value += linear.constant;
        sum
    }

    pub(super) fn point(&self, point: &Point) -> [Gradient; 3] {
        [0, 1, 2].map(|k| self.linear(&point.0[k]))
    }
}

impl Linear {
    /// Returns true if all coefficients are finite and all numbers belong to a plan with `count`
    /// numbers.
    pub(super) fn is_of(&self, count: usize) -> bool {
        self.constant.is_finite()
            && self.terms.iter().all(|&(NumberId(k), factor)| k < count && factor.is_finite())
    }
}
