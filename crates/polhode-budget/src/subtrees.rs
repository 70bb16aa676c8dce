//! Sums over rows and their descendants.

use polhode::body::{BodyError, MassProperties};
use polhode::math::{Body, Frame};

use crate::budget::Budget;
use crate::error::BudgetError;
use crate::growth::{Basis, MassStatement};
use crate::tensor::scaled;
use crate::tree::row_name;

/// Mass properties of one copy of each row with its descendants, in the body.
#[derive(Clone, Debug)]
pub struct Subtrees<'b> {
    budget: &'b Budget,
    basis: Basis,
    /// Mass properties of rows with children, by slot.
    inner: Vec<Option<MassProperties<Body>>>,
}

impl Subtrees<'_> {
    /// Returns one copy of a row with its descendants, or `None` for frames without mass.
    ///
    /// # Errors
    /// [`BudgetError::Part`] if the part overflows.
    pub fn of(&self, row: usize) -> Result<Option<MassProperties<Body>>, BudgetError> {
        match self.budget.tree.slot(row) {
            Some(slot) => Ok(self.inner.get(slot).copied().flatten()),
            None => self.budget.own(row, self.basis),
        }
    }
}

impl Budget {
    /// Returns the mass properties of the whole along the axes of the body, in which the frame of
    /// the root is given.
    ///
    /// # Errors
    /// [`BudgetError::Sum`] if the sum overflows.
    pub fn mass_properties(&self, basis: Basis) -> Result<MassProperties<Body>, BudgetError> {
        self.whole(&self.subtrees(basis)?)
    }

    /// Returns the masses of each row with its descendants: all copies in one copy of the parent.
    ///
    /// # Errors
    /// Same as [`Budget::mass_properties`].
    pub fn mass_statements(&self) -> Result<Vec<MassStatement>, BudgetError> {
        let mut all: Vec<MassStatement> = Vec::with_capacity(self.rows.len());
        let basic = self.subtrees(Basis::Basic)?;
        let mass = |one: Option<MassProperties<Body>>, k: usize| {
            one.map_or(0.0, |one| one.mass() * f64::from(self.rows.quantity(k).count))
        };
        for k in 0..self.rows.len() {
            let basic = mass(basic.of(k)?, k);
            all.push(MassStatement { basic, predicted: basic, allowable: self.rows.allowable(k) });
        }
        drop(basic);
        let predicted = self.subtrees(Basis::Predicted)?;
        for (k, statement) in all.iter_mut().enumerate() {
            statement.predicted = mass(predicted.of(k)?, k);
        }
        Ok(all)
    }

    /// Returns the mass properties of one copy of a row's own part, in the body. Returns `None` for
    /// a frame without mass.
    ///
    /// # Errors
    /// [`BudgetError::Part`] if the part overflows.
    pub fn own(&self, k: usize, basis: Basis) -> Result<Option<MassProperties<Body>>, BudgetError> {
        let Some(part) = self.placed_part(k)? else { return Ok(None) };
        let place = self.frame(k);
        let placed = part.properties.placed(place.position, place.rotation);
        let part = placed.and_then(|placed| scaled(&placed, self.factor(k, basis)));
        part.map(Some).map_err(|error| BudgetError::Part { row: row_name(&self.rows, k), error })
    }

    /// Computes one copy of each row with its descendants, in the body.
    ///
    /// # Errors
    /// Same as [`Budget::mass_properties`].
    pub fn subtrees(&self, basis: Basis) -> Result<Subtrees<'_>, BudgetError> {
        let mut inside: Vec<Vec<MassProperties<Body>>> = vec![Vec::new(); self.tree.inner];
        let mut inner = vec![None; self.tree.inner];
        for k in self.tree.order().rev() {
            let slot = self.tree.slot(k);
            let own = self.own(k, basis)?;
            let one = match slot.and_then(|slot| inside.get_mut(slot)) {
                None => own,
                Some(parts) => {
                    parts.extend(own);
                    let parts = core::mem::take(parts);
                    combined(&parts).map_err(BudgetError::Sum)?
                }
            };
            if let Some(slot) = slot {
                inner[slot] = one;
            }
            let above = self.tree.parent(k).and_then(|parent| self.tree.slot(parent));
            if let (Some(one), Some(above)) = (one, above) {
                let count = f64::from(self.rows.quantity(k).count);
                inside[above].push(scaled(&one, count).map_err(BudgetError::Sum)?);
            }
        }
        Ok(Subtrees { budget: self, basis, inner })
    }

    pub(crate) fn whole(&self, subtrees: &Subtrees<'_>) -> Result<MassProperties<Body>, BudgetError> {
        let root = self.root();
        let one = subtrees.of(root)?.ok_or(BudgetError::Empty)?;
        scaled(&one, f64::from(self.rows.quantity(root).count)).map_err(BudgetError::Sum)
    }

    /// Returns the mass factor of a row's part on a basis.
    pub(crate) fn factor(&self, row: usize, basis: Basis) -> f64 {
        match basis {
            Basis::Basic => 1.0,
            Basis::Predicted => self.scale(row),
        }
    }
}

/// Combines bodies; `None` if there are none.
pub(crate) fn combined<F: Frame>(
    parts: &[MassProperties<F>],
) -> Result<Option<MassProperties<F>>, BodyError> {
    match parts {
        [] => Ok(None),
        [one] => Ok(Some(*one)),
        parts => MassProperties::combined(parts).map(Some),
    }
}
