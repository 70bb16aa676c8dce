//! Groups of rows with correlated errors.

use crate::error::BudgetError;
use crate::uncertainty::ErrorKind;

/// Rows with correlated errors: from one supplier, scale, drawing or estimate.
///
/// The errors of two rows i and j of a group have the covariance ρ Lᵢ Lⱼᵀ, where Lᵢ and Lⱼ are the
/// Cholesky factors of their own covariances. For numbers with standard deviations only, ρ is the
/// correlation of the same number of both rows, each along its own axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    pub name: String,
    /// Correlation ρ of the masses, 0 to 1.
    pub mass: f64,
    /// ρ of the centres of mass.
    pub center: f64,
    /// ρ of the inertia tensors.
    pub tensor: f64,
    /// ρ of the positions of frames.
    pub position: f64,
    /// ρ of the rotations of frames.
    pub rotation: f64,
    /// ρ of the densities of liquids.
    pub density: f64,
}

impl Group {
    /// Returns a group in which only the masses are correlated.
    pub fn of_masses(name: impl Into<String>, correlation: f64) -> Self {
        Self {
            name: name.into(),
            mass: correlation,
            center: 0.0,
            tensor: 0.0,
            position: 0.0,
            rotation: 0.0,
            density: 0.0,
        }
    }

    /// Returns ρ of each kind, in the order of [`ErrorKind`].
    pub(crate) const fn correlations(&self) -> [f64; 6] {
        [self.mass, self.center, self.tensor, self.position, self.rotation, self.density]
    }

    pub(crate) const fn correlation(&self, kind: ErrorKind) -> f64 {
        self.correlations()[kind as usize]
    }

    pub(crate) fn check(&self) -> Result<(), BudgetError> {
        let names = [
            "the correlation of masses",
            "the correlation of centres",
            "the correlation of tensors",
            "the correlation of positions",
            "the correlation of rotations",
            "the correlation of densities",
        ];
        match names.into_iter().zip(self.correlations()).find(|(_, value)| !(0.0..=1.0).contains(value)) {
            None => Ok(()),
            Some((what, value)) => {
                Err(BudgetError::Table { name: self.name.clone(), what, value, rule: "from 0 to 1" })
            }
        }
    }
}
