//! Groups of rows whose errors go together.

use crate::error::BudgetError;
use crate::uncertainty::ErrorKind;

/// Rows whose errors are correlated: of one supplier, one scale, one drawing, one estimate.
///
/// The errors of two rows i and j of a group have the covariance ρ Lᵢ Lⱼᵀ, with the Cholesky factors L of their own covariances: of numbers that have standard
/// deviations alone, ρ is the correlation of the same number of both, each along its own axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Its name.
    pub name: String,
    /// ρ of masses.
    pub mass: f64,
    /// ρ of centres of mass.
    pub center: f64,
    /// ρ of tensors.
    pub tensor: f64,
    /// ρ of positions.
    pub position: f64,
    /// ρ of rotations.
    pub rotation: f64,
    /// ρ of the densities of liquids.
    pub density: f64,
}

impl Group {
    /// Rows whose masses are correlated, and nothing else.
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

    /// ρ of each kind, in the order of the kinds.
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
