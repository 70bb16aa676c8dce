//! Uncertainty of the liquid in a tank.

use polhode::body::{BodyError, MassProperties, MassPropertiesDerivative};
use polhode::infer::random::log_normal;
use polhode::math::{Part, Position};

use super::{Fill, Liquid, Slice};
use crate::tensor::{elements, plus, scaled, steiner};

/// Errors of the liquid in a tank.
///
/// A smaller amount lowers the level; another density scales the whole liquid. The body is r P(n).
/// P(n) has the stated density and the same level, with a mass of n kilograms. r is the density
/// relative to the stated one. To first order, an increase of n adds the slice at the surface, and
/// r scales everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiquidErrors {
    /// Measured quantity of the liquid.
    pub measured: Measured,
    /// Standard deviation of the amount, kg of the stated density.
    pub amount: f64,
    /// Relative standard deviation of the density.
    pub density: f64,
}

/// Measured quantity of a liquid. It does not change with the density.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// Mass of the liquid. A lighter liquid has a higher level.
    Mass,
    /// Level or volume of the liquid. A lighter liquid has less mass.
    Fill,
}

/// Liquid in a tank, with its errors.
#[derive(Clone, Debug, PartialEq)]
pub struct UncertainLiquid {
    /// Model of the liquid in the tank.
    pub liquid: Liquid,
    /// Errors of the amount and the density.
    pub errors: LiquidErrors,
}

impl UncertainLiquid {
    /// Returns true if a part equals its mass of the liquid, within the rounding of printed digits.
    pub(crate) fn is(&self, part: &MassProperties<Part>) -> bool {
        const ROUNDING: f64 = 1e-9;
        let Some(Fill { properties: Some(liquid), .. }) = self.liquid.at(part.mass()) else { return false };
        let [found, want] = [part, &liquid].map(|body| elements(body.inertia().matrix()));
        let size = (want[0] + want[1] + want[2]) / part.mass();
        let place = size + liquid.center_of_mass().dot(liquid.center_of_mass());
        let apart = (part.center_of_mass() - liquid.center_of_mass()).norm();
        let differs = |(a, b): (&f64, &f64)| (a - b).abs() > ROUNDING * part.mass() * place;
        apart <= ROUNDING * place.sqrt() && !found.iter().zip(&want).any(differs)
    }

    /// Returns the change of the liquid for these errors of amount and density, in the tank's
    /// frame. δr scales all of it, and δn adds the slice at its surface.
    pub(crate) fn change(
        &self,
        part: &MassProperties<Part>,
        [amount, r]: [f64; 2],
    ) -> MassPropertiesDerivative<Part> {
        let mass = part.mass();
        let n = match self.errors.measured {
            Measured::Mass => amount - mass * r,
            Measured::Fill => amount,
        };
        let center = part.center_of_mass().to_array();
        // The mass was checked against the capacity.
        let none = Slice { center, tensor: [0.0; 6] };
        let Slice { center: place, tensor } = self.liquid.at(mass).map_or(none, |fill| fill.next);
        let d: [f64; 3] = core::array::from_fn(|k| place[k] - center[k]);
        let own = elements(part.inertia().matrix());
        MassPropertiesDerivative {
            mass: r * mass + n,
            center_of_mass: Position::from_array(d.map(|x| n * x / mass)),
            inertia: plus(own.map(|x| r * x), plus(tensor, steiner(d, d), 1.0), n),
        }
    }

    /// Returns the liquid with these errors, and true if it would exceed the capacity of the tank.
    /// In that case, the tank is full. An amount within rounding of 0 is an empty tank.
    pub(crate) fn drawn(
        &self,
        mass: f64,
        [of_amount, of_density]: [f64; 2],
    ) -> Result<(Option<MassProperties<Part>>, bool), BodyError> {
        let LiquidErrors { measured, amount, density } = self.errors;
        let of = |mean, sd, error: f64| if sd > 0.0 { log_normal(mean, sd, error / sd) } else { mean };
        let (given, r) = (of(mass, amount, of_amount), of(1.0, density, of_density));
        let n = match measured {
            Measured::Mass => given / r,
            Measured::Fill => given,
        };
        let full = self.liquid.capacity();
        let liquid = self.liquid.at(n.min(full)).and_then(|fill| fill.properties);
        Ok((liquid.map(|liquid| scaled(&liquid, r)).transpose()?, n > full * (1.0 + 1e-12)))
    }
}
