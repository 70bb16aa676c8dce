//! Tanks: the mass properties of what is in them, by how much that is.
//!
//! The liquid is taken to be at rest in the tank and to turn with it like a solid: it does not slosh, and its free surface is a plane across the direction towards which
//! it has settled. A body that spins so fast that its liquid lies at the wall has another surface: give a table then.

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

/// A tank in the frame of a row of a parts list, which has the tank's own mass or none.
#[derive(Clone, Debug, PartialEq)]
pub struct Tank {
    /// What it is called.
    pub name: String,
    /// The row in whose frame it is.
    pub frame: String,
    /// What is in it.
    pub liquid: Liquid,
}

/// What the mass properties of a liquid follow from.
#[derive(Clone, Debug, PartialEq)]
pub enum Liquid {
    /// The vessel's shape.
    Vessel(Box<Vessel>),
    /// A table.
    Table(LiquidTable),
}

/// So much liquid in a tank.
#[derive(Clone, Debug, PartialEq)]
pub struct Fill {
    /// Nothing of an empty tank.
    pub properties: Option<MassProperties<Part>>,
    /// How high it stands, m; `None` where the shape is not known.
    pub level: Option<f64>,
    /// What more of it adds, or less of it takes away.
    pub next: Slice,
}

/// What a kilogram more is like: dM = 1, d(M c) = `center`, dI = `tensor` about its own centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slice {
    /// Its centre, tank axes, m.
    pub center: [f64; 3],
    /// xx, yy, zz, xy, xz, yz about that, m². Of a table it need not be that of a body.
    pub tensor: [f64; 6],
}

impl Liquid {
    /// What a full tank holds, kg.
    pub fn capacity(&self) -> f64 {
        match self {
            Self::Vessel(vessel) => vessel.capacity(),
            Self::Table(table) => table.capacity(),
        }
    }

    /// So many kilograms of it; `None` of less than nothing, and of more than a full tank.
    pub fn at(&self, mass: f64) -> Option<Fill> {
        let capacity = self.capacity();
        // Burns that are to empty a tank leave it with some rounding.
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

/// Of masses that are differences, relative to the capacity.
const ROUNDING: f64 = 1e-13;
