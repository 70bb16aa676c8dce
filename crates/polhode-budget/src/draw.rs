//! Random parts, drawn from the errors of a row.

use polhode::body::{BodyError, MassProperties};
use polhode::infer::possible::possible;
use polhode::infer::random::log_normal;
use polhode::math::{Direction, Part, Position, Rotation};

use crate::budget::PlacedPart;
use crate::row::Place;
use crate::tank::UncertainLiquid;
use crate::tensor::{mass_properties, plus, steiner};
use crate::uncertainty::{Factor, RowError};

impl PlacedPart {
    /// Returns the part with these errors, and true if it had to be moved to be physically
    /// possible.
    ///
    /// The mass is [`log_normal`] with z = δm/σ. All other numbers are normal. The drawn tensor is
    /// possible if no eigenvalue of the second moments G = ½ tr(I) 1 − I about the centre of mass
    /// is negative. A negative eigenvalue is set to 0. This gives the nearest possible tensor, by
    /// the sum of squares of the elements of G. It is that of a lamina.
    ///
    /// Coordinates in which every tensor is possible, such as log-Cholesky ones, would be worse.
    /// Most parts are thin, and tensor errors are often given relative to the greatest moment. For
    /// a plate 1 mm thick, the error of the logarithm of the thickness is then not small.
    pub(crate) fn drawn(
        &self,
        sd: f64,
        liquid: Option<&UncertainLiquid>,
        follows: bool,
        error: &RowError,
    ) -> Result<(Option<MassProperties<Part>>, bool), BodyError> {
        let nominal = self.properties.mass();
        if let Some(liquid) = liquid {
            return liquid.drawn(nominal, [error.mass, error.density]);
        }
        let mass = if sd > 0.0 { log_normal(nominal, sd, error.mass / sd) } else { nominal };
        let center = self.properties.center_of_mass() + Position::from_array(error.center);
        let mut inertia = plus(self.elements, error.tensor, 1.0);
        if let Some(point) = self.about {
            let d = (center - point).to_array();
            inertia = plus(inertia, steiner(d, d), if follows { -nominal } else { -mass });
        }
        if follows {
            inertia = inertia.map(|element| element * (mass / nominal));
        }
        let (inertia, moved) = possible(inertia);
        Ok((Some(mass_properties(mass, center, inertia, None)?), moved))
    }
}

impl Place {
    /// Returns the frame moved by these errors, or `None` if the rotation is not finite.
    pub(crate) fn drawn(&self, error: &RowError) -> Option<(Position<Part>, Rotation<Part, Part>)> {
        let turn = Rotation::exp(Direction::from_array(error.rotation)).ok()?;
        Some((self.position + Position::from_array(error.position), turn * self.rotation))
    }
}

/// Returns the standard deviation of the mass from all errors of a row, kg.
pub(crate) fn mass_sd(factors: &[Factor]) -> f64 {
    factors.iter().map(|factor| factor.error.mass * factor.error.mass).sum::<f64>().sqrt()
}
