//! Thin cylindrical shell.

use super::disk::Disk;
use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::number::PI;
use crate::math::vector::Position;

/// Thin tube, open or closed by two disks, with its centre at the origin and its axis along z.
///
/// If open: I = M diag(r²/2 + l²/12, r²/2 + l²/12, r²)
///
/// ```
/// use polhode::body::shape::{CylinderShell, Shape, Substance};
/// // Curtis, Orbital Mechanics for Engineering Students, 2nd ed., example 10.2
/// let tube = CylinderShell::new(1.0, 3.0, false)?.mass_properties(Substance::Mass(100.0))?;
/// assert!((tube.inertia().matrix()[0][0] - 125.0).abs() < 1e-13);
/// assert!((tube.inertia().matrix()[2][2] - 100.0).abs() < 1e-13);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderShell {
    radius: f64,
    length: f64,
    ends: bool,
}

impl CylinderShell {
    /// Returns a shell with the given radius and length, m: a closed can with `ends`, otherwise an
    /// open tube.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the radius or the length is not positive and finite.
    pub fn new(radius: f64, length: f64, ends: bool) -> Result<Self, BodyError> {
        representable(Self {
            radius: positive("the cylindrical shell's radius", radius)?,
            length: positive("the cylindrical shell's length", length)?,
            ends,
        })
    }
}

impl Shape for CylinderShell {
    fn spread(&self) -> Spread {
        let Self { radius: r, length: l, ends } = *self;
        let tube = Spread::centered(Extent::Area(2.0 * PI * r * l), [r * r / 2.0, r * r / 2.0, l * l / 12.0]);
        if !ends {
            return tube;
        }
        let end = |z: f64| Disk { radius: r }.spread().moved(Position::new(0.0, 0.0, z));
        tube.joined(&[end(-0.5 * l), end(0.5 * l)])
    }

    fn surface_area(&self) -> f64 {
        self.spread().extent.measure()
    }

    fn form(&self) -> Option<Form> {
        let Self { radius, length, ends } = *self;
        Some(Form::Cylinder { radius, inner_radius: if ends { 0.0 } else { radius }, length })
    }
}
