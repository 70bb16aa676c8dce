//! Part of a mesh with its shape.

use polhode::body::shape::{Shape, Substance};
use polhode::body::{BodyError, MassProperties};
use polhode::math::Part;

use super::print::Printed;

/// Part with its shape.
pub(super) struct Piece {
    pub(super) name: String,
    pub(super) shape: Box<dyn Shape>,
    /// Infill, if the part is printed.
    pub(super) printed: Option<Printed>,
}

impl Piece {
    pub(super) fn new(name: String, shape: impl Shape + 'static) -> Self {
        Self { name, shape: Box::new(shape), printed: None }
    }

    pub(super) fn volume(&self) -> f64 {
        self.shape.spread().extent().measure()
    }

    /// Returns the volume that has the mass of the part at the density of its substance, m³.
    pub(super) fn material(&self) -> f64 {
        self.printed.as_ref().map_or_else(|| self.volume(), Printed::material)
    }

    /// Returns the mass properties of the part, with its infill if it is printed.
    pub(super) fn mass_properties(&self, substance: Substance) -> Result<MassProperties<Part>, BodyError> {
        match &self.printed {
            Some(printed) => printed.mass_properties(substance),
            None => self.shape.mass_properties(substance),
        }
    }
}
