//! Liquid in a tank as a row of a parts list.

use crate::row::{GivenPart, Row};
use crate::tank::{LiquidErrors, Tank, UncertainLiquid};
use crate::uncertainty::{PartUncertainty, Uncertainty};

impl Tank {
    /// Returns a mass of the liquid, kg, as a row with the name of the tank. Returns `None` for an
    /// empty tank, and for more than the tank holds.
    pub fn row(&self, mass: f64, errors: LiquidErrors) -> Option<Row> {
        let liquid = self.liquid.at(mass)?.properties?;
        let mut row =
            Row { parent: Some(self.frame.clone()), ..Row::part(&self.name, GivenPart::of(&liquid)) };
        if errors.amount != 0.0 || errors.density != 0.0 {
            let liquid = UncertainLiquid { liquid: self.liquid.clone(), errors };
            row.uncertainty =
                Uncertainty { part: PartUncertainty::Liquid(Box::new(liquid)), ..Uncertainty::default() };
        }
        Some(row)
    }
}
