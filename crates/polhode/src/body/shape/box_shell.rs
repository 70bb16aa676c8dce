//! Thin box.

use super::{Extent, Shape, Spread, representable};
use crate::body::error::{BodyError, positive};
use crate::body::form::Form;
use crate::math::vector::Position;

/// Hollow box of six thin faces, with its centre at the origin and its edges along the axes.
///
/// I_zz = M [ab (a² + b²) + bc (3a² + b²) + ca (a² + 3b²)] / 12 (ab + bc + ca) for edges a, b, c
///
/// ```
/// use polhode::body::shape::{BoxShell, Shape, Substance};
/// // a hollow cube: I = 5/18 M a²
/// let tank = BoxShell::new([3.0; 3])?.mass_properties(Substance::Mass(2.0))?;
/// assert!((tank.inertia().matrix()[0][0] - 5.0).abs() < 1e-14);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxShell {
    size: [f64; 3],
}

impl BoxShell {
    /// Returns a box with the given edge lengths along x, y and z, m.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if an edge is not positive and finite.
    pub fn new(size: [f64; 3]) -> Result<Self, BodyError> {
        for edge in size {
            positive("the hollow box's size", edge)?;
        }
        representable(Self { size })
    }

    /// Returns the face perpendicular to axis `k`, half an edge from the centre on the given side.
    fn face(&self, k: usize, side: f64) -> Spread {
        let [a, b] = [self.size[(k + 1) % 3], self.size[(k + 2) % 3]];
        let (mut edges, mut center) = (self.size, [0.0; 3]);
        edges[k] = 0.0;
        center[k] = 0.5 * side * self.size[k];
        Spread::centered(Extent::Area(a * b), edges.map(|e| e * e / 12.0)).moved(Position::from_array(center))
    }
}

impl Shape for BoxShell {
    fn spread(&self) -> Spread {
        let face = |k: usize, side: f64| self.face(k, side);
        face(0, 1.0).joined(&[face(0, -1.0), face(1, 1.0), face(1, -1.0), face(2, 1.0), face(2, -1.0)])
    }

    fn surface_area(&self) -> f64 {
        let [a, b, c] = self.size;
        2.0 * (a * b + b * c + c * a)
    }

    fn form(&self) -> Option<Form> {
        Some(Form::Box { size: self.size })
    }
}
