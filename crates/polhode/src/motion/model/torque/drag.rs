//! Drag torques.

use super::model::Model;
use crate::math::algebra::VectorAlgebra;
use crate::math::symmetric3::Symmetric3;
use crate::motion::error::MotionError;
use crate::motion::model::law::{Law, LawInput};
use crate::motion::model::require;

/// Torque that opposes rotation, proportional to ω or to |ω| ω; it may be anisotropic.
///
/// The drag matrix is along body axes. It is symmetric and positive semi-definite, so that the
/// power N · ω is never positive.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::{AngularVelocity, Attitude, Position};
/// use polhode::motion::{Rotor, State};
/// use polhode::motion::torque::{Drag, DragLaw, Law};
/// let drag = Drag::new(DragLaw::Quadratic, [[0.5, 0.25, 0.0], [0.25, 0.5, 0.0], [0.0, 0.0, 0.5]])?;
/// let omega = AngularVelocity::new(0.0, 3.0, 4.0);
/// # let inertia = InertiaTensor::diagonal([1.0, 2.0, 2.5])?;
/// # let rotor = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
/// let torque = drag.at(&rotor, &State { time: 0.0, attitude: Attitude::identity(), omega });
/// assert_eq!(torque.to_array(), [-3.75, -7.5, -10.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    law: DragLaw,
    matrix: Symmetric3,
}

/// Dependence of the drag on ω.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DragLaw {
    /// N = −C ω, C in N·m·s.
    Linear,
    /// N = −|ω| D ω, D in N·m·s².
    Quadratic,
}

/// Tolerance, relative to the largest element, on symmetry and positivity of the matrix.
const TOLERANCE: f64 = 1e-12;

impl Law for Drag {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let omega = at.omega();
        let resistance = at.symmetric_parameters(0, self.matrix.elements(), omega);
        match self.law {
            DragLaw::Linear => -resistance,
            DragLaw::Quadratic => -(resistance * omega.norm()),
        }
    }

    fn parameters(&self) -> &'static [&'static str] {
        &["xx", "yy", "zz", "xy", "xz", "yz"]
    }
}

impl Drag {
    /// Creates a drag from its matrix C or D along body axes.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) unless the matrix is finite, symmetric
    /// and positive semi-definite, each to 1e-12 of its largest element.
    pub fn new(law: DragLaw, matrix: [[f64; 3]; 3]) -> Result<Self, MotionError> {
        for &value in matrix.as_flattened() {
            require::finite("an element of the drag's matrix", value)?;
        }
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = matrix;
        let largest = matrix.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
        for (value, mirrored) in [(xy, yx), (xz, zx), (yz, zy)] {
            let is_symmetric = 0.5 * (value - mirrored).abs() <= 0.5 * TOLERANCE * largest;
            let rule = "equal to the element across the diagonal";
            require::that("an element of the drag's matrix", value, is_symmetric, rule)?;
        }
        let mean = |a: f64, b: f64| 0.5 * a + 0.5 * b;
        let matrix = Symmetric3 { xx, yy, zz, xy: mean(xy, yx), xz: mean(xz, zx), yz: mean(yz, zy) };
        let [least, ..] = matrix.eigen().values;
        let (holds, rule) = (least >= -TOLERANCE * largest, "not negative: drag never speeds a body up");
        require::that("the least eigenvalue of the drag's matrix", least, holds, rule)?;
        Ok(Self { law, matrix })
    }

    /// Returns the dependence on ω.
    pub const fn law(&self) -> DragLaw {
        self.law
    }

    /// Returns the matrix C (N·m·s) or D (N·m·s²), body axes.
    pub fn matrix(&self) -> [[f64; 3]; 3] {
        self.matrix.rows()
    }
}

impl Model for Drag {
    fn name(&self) -> &'static str {
        "drag"
    }

    fn unsplittable(&self) -> Option<&'static str> {
        Some("it depends on the angular velocity")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_drag_is_refused() {
        let of = |matrix| Drag::new(DragLaw::Linear, matrix);
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!(of(unit).is_ok());
        assert!(of([[0.0; 3]; 3]).is_ok());
        // Singular, except for the rounding of 0.1 · 0.1 / 0.05.
        assert!(of([[0.1, 0.2, 0.0], [0.2, 0.4, 0.0], [0.0, 0.0, 0.0]]).is_ok());
        for (row, column, value) in
            [(0, 0, f64::NAN), (2, 1, f64::INFINITY), (0, 1, 0.5), (1, 2, -1e-9), (2, 2, -1e-9)]
        {
            let mut matrix = unit;
            matrix[row][column] = value;
            assert!(of(matrix).is_err(), "{matrix:?}");
        }
        // A positive diagonal is not sufficient.
        assert!(of([[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).is_err());
    }
}
