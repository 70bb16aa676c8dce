//! Solid torus.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;

/// Solid ring of circular cross-section, with its centre at the origin and its axis along z.
///
/// I_zz = M (R² + 3/4 r²),  I_xx = I_yy = M (R²/2 + 5/8 r²)
///
/// ```
/// use polhode::body::shape::{Shape, Substance, Torus};
/// let tyre = Torus::new(2.0, 1.0)?.mass_properties(Substance::Mass(4.0))?;
/// assert!((tyre.inertia().matrix()[2][2] - 19.0).abs() < 1e-14);
/// assert!((tyre.inertia().matrix()[0][0] - 10.5).abs() < 1e-14);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus {
    pub(in crate::body) ring_radius: f64,
    pub(in crate::body) tube_radius: f64,
}

impl Torus {
    /// Returns a torus with the radius R to the centre line of its tube, and a tube of radius
    /// r ≤ R, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if a radius is not positive and finite, or if r > R.
    pub fn new(ring_radius: f64, tube_radius: f64) -> Result<Self, BodyError> {
        positive("the torus's ring radius", ring_radius)?;
        let what = "the torus's tube radius";
        if positive(what, tube_radius)? > ring_radius {
            return Err(BodyError::Parameter { what, value: tube_radius, rule: "at most its ring radius" });
        }
        representable(Self { ring_radius, tube_radius })
    }
}

impl Shape for Torus {
    fn spread(&self) -> Spread {
        let Self { ring_radius: ring, tube_radius: tube } = *self;
        let (ring2, tube2) = (ring * ring, tube * tube);
        let across = 0.5 * ring2 + 0.375 * tube2;
        Spread::centered(Extent::Volume(2.0 * PI * PI * ring * tube2), [across, across, 0.25 * tube2])
    }

    fn surface_area(&self) -> f64 {
        4.0 * PI * PI * self.ring_radius * self.tube_radius
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Torus { ring_radius: self.ring_radius, tube_radius: self.tube_radius })
    }
}
