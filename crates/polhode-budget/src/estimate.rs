//! Mass properties with their covariance.

use polhode::body::{InertiaAbout, MassProperties, MassPropertiesDerivative, MassPropertiesGradient};
use polhode::infer::covariance::{add_square, form, mirrored};
use polhode::math::{Body, Frame, Position, Rotation};

use crate::budget::Budget;
use crate::error::BudgetError;
use crate::growth::Basis;
use crate::tensor::{plus, steiner};
use crate::uncertainty;

/// Names and units of the ten numbers of a body, in their order.
pub const NUMBERS: [(&str, &str); 10] = [
    ("mass", "kg"),
    ("x", "m"),
    ("y", "m"),
    ("z", "m"),
    ("Ixx", "kg·m²"),
    ("Iyy", "kg·m²"),
    ("Izz", "kg·m²"),
    ("Ixy", "kg·m²"),
    ("Ixz", "kg·m²"),
    ("Iyz", "kg·m²"),
];

/// Mass properties along the axes of `F`, with their covariance to first order.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate<F: Frame> {
    /// Mass properties. The tensor is about the centre of mass, and its off-diagonal elements are
    /// −∫ x y dm.
    pub properties: MassProperties<F>,
    /// Covariance of the ten numbers in the order of [`NUMBERS`].
    pub covariance: [[f64; 10]; 10],
}

/// Inertia tensor about a point that is fixed in the body, with its covariance.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateAbout<F: Frame> {
    /// Inertia tensor about the point, kg·m².
    pub inertia: InertiaAbout<F>,
    /// Covariance of the mass, the centre of mass and the six tensor elements about that point.
    pub covariance: [[f64; 10]; 10],
}

impl Budget {
    /// Computes the mass properties of the whole, and their covariance to first order in the errors
    /// of all rows.
    ///
    /// # Errors
    /// Same as [`Budget::mass_properties`]; [`BudgetError::Variance`] if a variance overflows.
    pub fn estimate(&self, basis: Basis) -> Result<Estimate<Body>, BudgetError> {
        let subtrees = self.subtrees(basis)?;
        let properties = self.whole(&subtrees)?;
        let mut covariance = [[0.0; 10]; 10];
        let mut shared = vec![[[0.0; 10]; uncertainty::NUMBERS]; self.groups.len()];
        self.changes(basis, &subtrees, &properties, |change| {
            add_square(&mut covariance, &ten(&change.alone));
            if let Some((group, by)) = &change.shared {
                let sum = &mut shared[*group][change.number];
                sum.iter_mut().zip(ten(by)).for_each(|(sum, x)| *sum += x);
            }
        })?;
        shared.iter().flatten().for_each(|sum| add_square(&mut covariance, sum));
        let covariance = mirrored(&covariance);
        match covariance.iter().position(|row| !row.iter().all(|x| x.is_finite())) {
            Some(k) => Err(BudgetError::Variance { of: NUMBERS[k].0 }),
            None => Ok(Estimate { properties, covariance }),
        }
    }
}

impl<F: Frame> Estimate<F> {
    /// Returns the standard deviation of a number, by its index in [`NUMBERS`].
    ///
    /// # Panics
    /// If `number` is greater than 9.
    pub fn sd(&self, number: usize) -> f64 {
        self.covariance[number][number].sqrt()
    }

    /// Returns the standard deviation of a quantity with this gradient. It is 0 if the variance is
    /// only rounding error of its terms, and infinite if the terms overflow.
    pub fn sd_of(&self, gradient: &MassPropertiesGradient<F>) -> f64 {
        const ROUNDING: f64 = 1e-14;
        let by = ten_of_gradient(gradient);
        let sizes = self.covariance.map(|row| row.map(f64::abs));
        let variance = form(&by, &self.covariance, &by);
        let size = by.map(f64::abs);
        let of_terms = form(&size, &sizes, &size);
        if !of_terms.is_finite() {
            return f64::INFINITY;
        }
        if variance > ROUNDING * of_terms { variance.sqrt() } else { 0.0 }
    }

    /// Returns the covariance of two quantities with these gradients.
    pub fn covariance_of(&self, a: &MassPropertiesGradient<F>, b: &MassPropertiesGradient<F>) -> f64 {
        form(&ten_of_gradient(a), &self.covariance, &ten_of_gradient(b))
    }

    /// Returns the estimate along the axes of `A`, about the same origin.
    #[must_use]
    pub fn along<A: Frame>(&self, r: Rotation<A, F>) -> Estimate<A> {
        Estimate {
            properties: self.properties.in_frame(r),
            covariance: self.mapped(|change| ten(&change.in_frame(r))),
        }
    }

    /// Returns the tensor about a point: J = I + M (d² 1 − d dᵀ), with d from the point to the
    /// centre of mass.
    pub fn about_point(&self, point: Position<F>) -> EstimateAbout<F> {
        let (mass, d) = (self.properties.mass(), (self.properties.center_of_mass() - point).to_array());
        EstimateAbout {
            inertia: self.properties.inertia_about(point),
            covariance: self.mapped(|change| {
                let [m, x, y, z, inertia @ ..] = ten(change);
                let by_mass = plus(inertia, steiner(d, d), m);
                let [xx, yy, zz, xy, xz, yz] = plus(by_mass, steiner(d, [x, y, z]), 2.0 * mass);
                [m, x, y, z, xx, yy, zz, xy, xz, yz]
            }),
        }
    }

    /// Returns A C Aᵀ, where A is a linear map of changes of the ten numbers.
    fn mapped(&self, map: impl Fn(&MassPropertiesDerivative<F>) -> [f64; 10]) -> [[f64; 10]; 10] {
        // A is applied to the columns of C, and then to the rows of A C.
        let half = self.covariance.map(|column| map(&of_ten(column)));
        let turned: [[f64; 10]; 10] = core::array::from_fn(|i| half.map(|column| column[i]));
        let whole = turned.map(|row| map(&of_ten(row)));
        mirrored(&whole)
    }
}

/// Returns a change as an array, in the order of [`NUMBERS`].
pub(crate) fn ten<F>(change: &MassPropertiesDerivative<F>) -> [f64; 10] {
    let [xx, yy, zz, xy, xz, yz] = change.inertia;
    let c = &change.center_of_mass;
    [change.mass, c.x, c.y, c.z, xx, yy, zz, xy, xz, yz]
}

fn of_ten<F>([mass, x, y, z, inertia @ ..]: [f64; 10]) -> MassPropertiesDerivative<F> {
    MassPropertiesDerivative { mass, center_of_mass: Position::new(x, y, z), inertia }
}

fn ten_of_gradient<F>(gradient: &MassPropertiesGradient<F>) -> [f64; 10] {
    let [xx, yy, zz, xy, xz, yz] = gradient.by_inertia;
    let c = &gradient.by_center_of_mass;
    [gradient.by_mass, c.x, c.y, c.z, xx, yy, zz, xy, xz, yz]
}
