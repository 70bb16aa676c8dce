//! Tanks: mass properties of their contents as functions of the amount.
//!
//! The liquid is assumed to be at rest in the tank and to turn with it like a solid. It does not
//! slosh. Its free surface is a plane perpendicular to the direction in which it has settled. In a
//! fast spin the liquid is at the wall and has another surface. For this case, give a table.

mod errors;
mod section;
mod shape;
mod table;
mod vessel;

use polhode::body::MassProperties;
use polhode::math::Part;

pub use errors::{LiquidErrors, Measured, UncertainLiquid};
pub use shape::{Down, TankShape};
pub use table::LiquidTable;
pub use vessel::Vessel;

/// Tank in the frame of a row of a parts list. The row has the tank's own mass, or none.
#[derive(Clone, Debug, PartialEq)]
pub struct Tank {
    pub name: String,
    /// Name of the row in whose frame the tank is.
    pub frame: String,
    /// Model of the liquid in the tank.
    pub liquid: Liquid,
}

/// Model of the mass properties of a liquid.
#[derive(Clone, Debug, PartialEq)]
pub enum Liquid {
    /// Vessel of a known shape.
    Vessel(Box<Vessel>),
    /// Table of mass properties.
    Table(LiquidTable),
}

/// Liquid of a given mass in a tank.
#[derive(Clone, Debug, PartialEq)]
pub struct Fill {
    /// Mass properties of the liquid; `None` for an empty tank.
    pub properties: Option<MassProperties<Part>>,
    /// Level of the liquid, m; `None` if it is not known.
    pub level: Option<f64>,
    /// Change per kilogram that is added or removed.
    pub next: Slice,
}

/// Change per kilogram of liquid: dM = 1, d(M c) = `center`, dI = `tensor` about its own centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slice {
    /// Centre of the slice, tank axes, m.
    pub center: [f64; 3],
    /// Elements xx, yy, zz, xy, xz, yz about the centre, m². If they are from a table, they may not
    /// be those of a possible body.
    pub tensor: [f64; 6],
}

impl Liquid {
    /// Returns the mass of a full tank, kg.
    pub fn capacity(&self) -> f64 {
        match self {
            Self::Vessel(vessel) => vessel.capacity(),
            Self::Table(table) => table.capacity(),
        }
    }

    /// Returns the liquid with a mass, kg. Returns `None` for less than nothing, and for more than
    /// a full tank.
    pub fn at(&self, mass: f64) -> Option<Fill> {
        let capacity = self.capacity();
        // Burns that empty a tank leave a rounding error.
        let rounding = ROUNDING * capacity;
        if !(mass >= -rounding && mass <= capacity + rounding) {
            return None;
        }
        let mass = if mass <= rounding { 0.0 } else { mass.min(capacity) };
        match self {
            Self::Vessel(vessel) => vessel.at(mass),
            Self::Table(table) => table.at(mass),
        }
    }
}

/// Rounding error of masses that are differences, relative to the capacity.
const ROUNDING: f64 = 1e-13;
