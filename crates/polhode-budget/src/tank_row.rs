//! What is in a tank, as a row of a parts list.

use crate::row::{GivenPart, Row};
use crate::tank::{LiquidErrors, Tank, UncertainLiquid};
use crate::tensor::{GivenTensor, ProductSign, TensorPoint};
use crate::uncertainty::{PartUncertainty, Uncertainty};

impl Tank {
    /// So much of the liquid as a row of a parts list, which is called as the tank; `None` of an empty tank, and of more than it holds.
    pub fn row(&self, mass: f64, errors: LiquidErrors) -> Option<Row> {
        let liquid = self.liquid.at(mass)?.properties?;
        let [[xx, xy, xz], [_, yy, yz], [.., zz]] = liquid.inertia().matrix();
        let tensor = GivenTensor {
            moments: [xx, yy, zz],
            products: [xy, xz, yz],
            sign: ProductSign::NegativeIntegral,
            about: TensorPoint::CenterOfMass,
        };
        let part = GivenPart { mass: liquid.mass(), center_of_mass: liquid.center_of_mass(), tensor };
        let mut row = Row { parent: Some(self.frame.clone()), ..Row::part(&self.name, part) };
        if errors.amount != 0.0 || errors.density != 0.0 {
            let liquid = UncertainLiquid { liquid: self.liquid.clone(), errors };
            row.uncertainty =
                Uncertainty { part: PartUncertainty::Liquid(Box::new(liquid)), ..Uncertainty::default() };
        }
        Some(row)
    }
}
