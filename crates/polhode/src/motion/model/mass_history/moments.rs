//! Mass, first moments and second moments about a point. These are additive, and linear in convex
//! combinations of bodies.

use crate::body::error::BodyError;
use crate::body::inertia::InertiaAbout;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{Position, Velocity};

use super::MassRates;

/// M, M (c − p), and the elements xx, yy, zz, xy, xz, yz of the tensor about p; or differences or
/// derivatives of these.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moments(pub(super) [f64; 10]);

/// Relative accuracy of printed tables: the difference of two rows must be a physical body to
/// within this part of the whole.
const PRINTED: f64 = 1e-6;

impl Moments {
    pub(super) fn of(body: &MassProperties<Body>, about: Position<Body>) -> Self {
        let (m, d) = (body.mass(), (body.center_of_mass() - about).to_array());
        Self::joined(m, d.map(|x| m * x), body.inertia_about(about).symmetric().elements())
    }

    /// Returns the derivatives of the moments of a body of mass m with centre of mass at d from the
    /// point.
    pub(super) fn of_rates(m: f64, d: [f64; 3], rates: &MassRates) -> Self {
        let (rate, velocity) = (rates.mass, rates.center_of_mass.to_array());
        let first = core::array::from_fn(|k| rate * d[k] + m * velocity[k]);
        let moved = Symmetric3::outer(d) * rate + Symmetric3::twice_outer(d, velocity) * m;
        let tensor = Symmetric3::from_elements(rates.inertia) + moved.inertia_of_second_moments();
        Self::joined(rate, first, tensor.elements())
    }

    fn joined(m: f64, [x, y, z]: [f64; 3], [xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Self {
        Self([m, x, y, z, xx, yy, zz, xy, xz, yz])
    }

    pub(super) const fn mass(&self) -> f64 {
        self.0[0]
    }

    /// Returns M (c − p).
    const fn first(&self) -> [f64; 3] {
        [self.0[1], self.0[2], self.0[3]]
    }

    fn tensor(&self) -> Symmetric3 {
        let [_, _, _, _, elements @ ..] = self.0;
        Symmetric3::from_elements(elements)
    }

    /// Returns c − p.
    fn lever(&self) -> [f64; 3] {
        self.first().map(|x| x / self.mass())
    }

    pub(super) fn properties(&self, about: Position<Body>) -> Result<MassProperties<Body>, BodyError> {
        let tensor = InertiaAbout::from_symmetric(about, self.tensor())?;
        MassProperties::from_inertia_about(self.mass(), about + Position::from_array(self.lever()), &tensor)
    }

    /// Interprets `self` as the derivatives of the moments `of`, and returns the rates of the mass
    /// properties.
    pub(super) fn rates(&self, of: &Self) -> MassRates {
        let (m, d, rate) = (of.mass(), of.lever(), self.mass());
        let first = self.first();
        let velocity: [f64; 3] = core::array::from_fn(|k| (first[k] - rate * d[k]) / m);
        let moved = Symmetric3::outer(d) * rate + Symmetric3::twice_outer(d, velocity) * m;
        MassRates {
            mass: rate,
            center_of_mass: Velocity::from_array(velocity),
            inertia: (self.tensor() - moved.inertia_of_second_moments()).elements(),
        }
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(other, -1.0)
    }

    pub(super) fn plus(&self, other: &Self, times: f64) -> Self {
        Self(core::array::from_fn(|k| self.0[k] + times * other.0[k]))
    }

    fn times(&self, by: f64) -> Self {
        Self(self.0.map(|x| by * x))
    }

    /// Checks if these moments are a physical body, to the accuracy of tables relative to `whole`,
    /// or zero.
    pub(super) fn is_part_of(&self, whole: &Self) -> bool {
        let size = whole.tensor().max_abs();
        if !(self.mass() > 0.0) {
            return self.mass() == 0.0 && self.0.iter().all(|x| *x == 0.0);
        }
        let rest =
            self.tensor() - (Symmetric3::outer(self.lever()) * self.mass()).inertia_of_second_moments();
        let [a, b, c] = rest.eigen().values;
        a.min(a + b - c) >= -PRINTED * size
    }

    /// Returns the moments about the point p + d.
    pub(super) fn about(&self, d: [f64; 3]) -> Self {
        let (m, first) = (self.mass(), self.first());
        // ∫ (x − d)(x − d)ᵀ dm
        let moved = Symmetric3::outer(d) * m - Symmetric3::twice_outer(first, d);
        let tensor = self.tensor() + moved.inertia_of_second_moments();
        Self::joined(m, core::array::from_fn(|k| first[k] - m * d[k]), tensor.elements())
    }

    fn stretched(&self, by: [f64; 3]) -> Self {
        let t = self.tensor();
        let half = 0.5 * (t.xx + t.yy + t.zz);
        let [a, b, c] = by;
        let second = Symmetric3 {
            xx: a * a * (half - t.xx),
            yy: b * b * (half - t.yy),
            zz: c * c * (half - t.zz),
            xy: -a * b * t.xy,
            xz: -a * c * t.xz,
            yz: -b * c * t.yz,
        };
        let first = self.first();
        let tensor = second.inertia_of_second_moments().elements();
        Self::joined(self.mass(), core::array::from_fn(|k| by[k] * first[k]), tensor)
    }
}

/// Polynomial Σ cₖ τᵏ with moments as coefficients.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Polynomial(pub(super) Vec<Moments>);

impl Polynomial {
    pub(super) fn constant(moments: Moments) -> Self {
        Self(vec![moments])
    }

    /// Interpolates between the two ends of a span: linearly, or as a cubic with these slopes.
    pub(super) fn between([from, to]: [Moments; 2], slopes: Option<[Moments; 2]>, span: f64) -> Self {
        let mean = to.minus(&from).times(1.0 / span);
        let Some([begin, end]) = slopes else { return Self(vec![from, mean]) };
        let second = mean.times(3.0).plus(&begin, -2.0).minus(&end).times(1.0 / span);
        let third = begin.plus(&end, 1.0).plus(&mean, -2.0).times(1.0 / (span * span));
        Self(vec![from, begin, second, third])
    }

    pub(super) fn at(&self, tau: f64) -> Moments {
        horner(self.0.iter().copied(), tau)
    }

    pub(super) fn derivative(&self) -> Self {
        let terms = self.0.iter().enumerate().skip(1);
        Self(terms.map(|(k, c)| c.times(k as f64)).collect())
    }

    pub(super) fn rate(&self, tau: f64) -> Moments {
        horner(self.derivative().0.into_iter(), tau)
    }

    /// Returns the Bernstein coefficients bₖ = Σⱼ (k over j)/(n over j) cⱼ spanʲ. On the span the
    /// polynomial is a convex combination of them. If each is physical, so is every body in
    /// between.
    pub(super) fn bernstein(&self, span: f64) -> Vec<Moments> {
        let n = self.0.len() - 1;
        let coefficient = |k: usize| {
            let (mut sum, mut weight) = (Moments([0.0; 10]), 1.0);
            for (j, c) in self.0.iter().enumerate().take(k + 1) {
                sum = sum.plus(c, weight);
                weight *= span * (k - j) as f64 / (n - j).max(1) as f64;
            }
            sum
        };
        (0..=n).map(coefficient).collect()
    }

    pub(super) fn about(&self, d: [f64; 3]) -> Self {
        Self(self.0.iter().map(|c| c.about(d)).collect())
    }

    pub(super) fn stretched(&self, by: [f64; 3]) -> Self {
        Self(self.0.iter().map(|c| c.stretched(by)).collect())
    }
}

fn horner(terms: impl DoubleEndedIterator<Item = Moments>, tau: f64) -> Moments {
    terms.rev().fold(Moments([0.0; 10]), |sum, c| c.plus(&sum, tau))
}

/// Returns the elements of the second moments of a disc with normal n, as a tensor:
/// ¼ a² (1 + n nᵀ).
pub(super) fn disc(radius: f64, axis: [f64; 3]) -> [f64; 6] {
    let quarter = 0.25 * radius * radius;
    ((Symmetric3::diagonal([1.0; 3]) + Symmetric3::outer(axis)) * quarter).elements()
}
