//! Thin conical shell.

use super::disk::Disk;
use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, not_negative, positive};
use crate::body::form::Form;
use crate::math::number::PI;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Position;

/// Thin wall of a cone or a frustum, open or closed by disks, with the centre of its base at the
/// origin and its axis along +z.
///
/// About the apex of an open cone, I = M diag(r²/4 + h²/2, r²/4 + h²/2, r²/2)
///
/// ```
/// use polhode::body::shape::{ConeShell, Shape, Substance};
/// use polhode::math::Position;
/// let hat = ConeShell::new(0.5, 0.0, 2.0, false)?.mass_properties(Substance::Mass(5.0))?;
/// assert!((hat.center_of_mass().z - 2.0 / 3.0).abs() < 1e-15);
/// let about_apex = hat.inertia_about(Position::new(0.0, 0.0, 2.0)).matrix();
/// assert!((about_apex[0][0] - 5.0 * (0.0625 + 2.0)).abs() < 1e-14);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeShell {
    base_radius: f64,
    top_radius: f64,
    height: f64,
    ends: bool,
}

impl ConeShell {
    /// Returns a shell with the given radii at z = 0 and at z = `height`, m. With `ends`, disks
    /// close it; otherwise it is the wall only.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the height is not positive and finite, if a radius is negative
    /// or not finite, or if both are zero.
    pub fn new(base_radius: f64, top_radius: f64, height: f64, ends: bool) -> Result<Self, BodyError> {
        not_negative("the conical shell's base radius", base_radius)?;
        not_negative("the conical shell's top radius", top_radius)?;
        positive("the larger radius of the conical shell", base_radius.max(top_radius))?;
        positive("the conical shell's height", height)?;
        representable(Self { base_radius, top_radius, height, ends })
    }

    /// Computes the moments of the wall for the radii a and b, with ζ = z/h and dA ∝ (a + (b − a)
    /// ζ) dζ:
    ///
    /// A = π (a + b) √(h² + (a − b)²),  ⟨x²⟩ = (a² + b²)/4,  z̄ = h (a + 2b)/3(a + b),
    /// ⟨(z − z̄)²⟩ = h² (a² + 4ab + b²)/18(a + b)²
    fn wall(&self) -> Spread {
        // Lengths relative to the larger radius, so that no square of one underflows compared with
        // the other.
        let larger = self.base_radius.max(self.top_radius);
        let (a, b, h) = (self.base_radius / larger, self.top_radius / larger, self.height);
        let sum = a + b;
        let xx = 0.25 * (a * a + b * b) * larger * larger;
        let zz = (a * a + 4.0 * a * b + b * b) / (18.0 * sum * sum) * h * h;
        let slant = libm::hypot(h, self.base_radius - self.top_radius);
        Spread {
            extent: Extent::Area(PI * sum * larger * slant),
            centroid: Position::new(0.0, 0.0, h * (a + 2.0 * b) / (3.0 * sum)),
            covariance: Symmetric3::diagonal([xx, xx, zz]),
        }
    }
}

impl Shape for ConeShell {
    fn spread(&self) -> Spread {
        let wall = self.wall();
        if !self.ends {
            return wall;
        }
        let disks: Vec<Spread> = [(self.base_radius, 0.0), (self.top_radius, self.height)]
            .into_iter()
            .filter(|(radius, _)| *radius > 0.0)
            .map(|(radius, z)| Disk { radius }.spread().moved(Position::new(0.0, 0.0, z)))
            .collect();
        wall.joined(&disks)
    }

    fn surface_area(&self) -> f64 {
        self.spread().extent.measure()
    }

    fn form(&self) -> Option<Form> {
        let Self { base_radius, top_radius, height, ends } = *self;
        Some(Form::ConeShell { base_radius, top_radius, height, ends })
    }
}
