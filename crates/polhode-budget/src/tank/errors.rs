//! How well it is known what is in a tank.

use polhode::body::{BodyError, MassProperties, MassPropertiesDerivative};
use polhode::infer::random::log_normal;
use polhode::math::{Part, Position};

use super::{Fill, Liquid, Slice};
use crate::tensor::{elements, plus, scaled, steiner};

/// Errors of what is in a tank.
///
/// Of less of it the level is lower, of a liquid of another density all of it is lighter or heavier: the body is r P(n), with the liquid P of the density as it is stated, n kilograms of
/// which would stand as high, and the density r relative to that. To first order more of n is the slice at the surface, and r is in proportion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiquidErrors {
    /// What was measured.
    pub measured: Measured,
    /// Standard deviation of that, kg of the density as it is stated.
    pub amount: f64,
    /// Standard deviation of the density, as a part of it.
    pub density: f64,
}

/// What was measured of a liquid: it stays where the density is another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// Its mass: of a lighter liquid the level is higher.
    Mass,
    /// Its level, or its volume: a lighter liquid has less mass.
    Fill,
}

/// A liquid and its errors.
#[derive(Clone, Debug, PartialEq)]
pub struct UncertainLiquid {
    /// What is in the tank.
    pub liquid: Liquid,
    /// How well that is known.
    pub errors: LiquidErrors,
}

impl UncertainLiquid {
    /// Whether a part is so much of the liquid, to the rounding of printed digits.
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

    /// What the liquid changes by with these errors of amount and density, in the tank's frame: δr of all of it, and δn of the slice at its surface.
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
        // What has been checked holds so much.
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

    /// The liquid with these errors, and whether there would be more than the tank holds: then it is full. Nothing is left where what is left is rounding.
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
