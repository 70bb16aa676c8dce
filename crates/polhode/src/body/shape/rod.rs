//! Thin straight rod.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;

/// Thin rod along z with its centre at the origin.
///
/// I = M l²/12 diag(1, 1, 0)
///
/// ```
/// use polhode::body::shape::{Rod, Shape, Substance};
/// let stick = Rod::new(2.0)?.mass_properties(Substance::LineDensity(1.5))?;
/// assert_eq!(stick.mass(), 3.0);
/// assert!((stick.inertia().matrix()[0][0] - 1.0).abs() < 1e-15);
/// assert_eq!(stick.inertia().matrix()[2][2], 0.0);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rod {
    length: f64,
}

impl Rod {
    /// Returns a rod with the given length, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the length is not positive and finite.
    pub fn new(length: f64) -> Result<Self, BodyError> {
        representable(Self { length: positive("the rod's length", length)? })
    }
}

impl Shape for Rod {
    fn spread(&self) -> Spread {
        let l = self.length;
        Spread::centered(Extent::Length(l), [0.0, 0.0, l * l / 12.0])
    }

    fn surface_area(&self) -> f64 {
        0.0
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Rod { length: self.length })
    }
}
