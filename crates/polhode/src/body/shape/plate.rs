//! Thin rectangular plate.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;

/// Thin rectangle in the plane z = 0 with its centre at the origin and its edges along x and y.
///
/// I = M/12 diag(b², a², a² + b²) for edges a, b
///
/// ```
/// use polhode::body::shape::{Plate, Shape, Substance};
/// let panel = Plate::new([2.0, 1.0])?.mass_properties(Substance::AreaDensity(6.0))?;
/// assert_eq!(panel.mass(), 12.0);
/// assert!((panel.inertia().matrix()[2][2] - 5.0).abs() < 1e-15);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plate {
    size: [f64; 2],
}

impl Plate {
    /// Returns a plate with the given edge lengths along x and y, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if an edge is not positive and finite.
    pub fn new(size: [f64; 2]) -> Result<Self, BodyError> {
        for edge in size {
            positive("the plate's size", edge)?;
        }
        representable(Self { size })
    }
}

impl Shape for Plate {
    fn spread(&self) -> Spread {
        let [a, b] = self.size;
        Spread::centered(Extent::Area(a * b), [a * a / 12.0, b * b / 12.0, 0.0])
    }

    fn surface_area(&self) -> f64 {
        let [a, b] = self.size;
        a * b
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Plate { size: self.size })
    }
}
