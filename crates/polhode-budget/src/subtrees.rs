//! Sums over rows and all rows in them.

use polhode::body::{BodyError, MassProperties};
use polhode::math::{Body, Frame};

use crate::budget::Budget;
use crate::error::BudgetError;
use crate::growth::{Basis, MassStatement};
use crate::tensor::scaled;
use crate::tree::row_name;

/// One copy of each row with all in it, in the body.
#[derive(Clone, Debug)]
pub struct Subtrees<'b> {
    budget: &'b Budget,
    basis: Basis,
    /// Rows in which others stand, by their slots.
    inner: Vec<Option<MassProperties<Body>>>,
}

impl Subtrees<'_> {
    /// One copy of a row with all in it; `None` of frames without mass.
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
    /// The mass properties of the whole, along the axes of the body, in which the root's frame stands.
    ///
    /// # Errors
    /// [`BudgetError::Sum`] if it overflows.
    pub fn mass_properties(&self, basis: Basis) -> Result<MassProperties<Body>, BudgetError> {
        self.whole(&self.subtrees(basis)?)
    }

    /// The masses of each row with all in it: of its copies in one of the row in which it stands.
    ///
    /// # Errors
    /// As [`Budget::mass_properties`].
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

    /// Mass properties of one copy of a row's own part, in the body; `None` of a frame without mass.
    ///
    /// # Errors
    /// [`BudgetError::Part`] if it overflows.
    pub fn own(&self, k: usize, basis: Basis) -> Result<Option<MassProperties<Body>>, BudgetError> {
        let Some(part) = self.placed_part(k)? else { return Ok(None) };
        let place = self.frame(k);
        let placed = part.properties.placed(place.position, place.rotation);
        let part = placed.and_then(|placed| scaled(&placed, self.factor(k, basis)));
        part.map(Some).map_err(|error| BudgetError::Part { row: row_name(&self.rows, k), error })
    }

    /// One copy of each row with all in it, in the body.
    ///
    /// # Errors
    /// As [`Budget::mass_properties`].
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

    /// Factor of the mass of a row's part.
    pub(crate) fn factor(&self, row: usize, basis: Basis) -> f64 {
        match basis {
            Basis::Basic => 1.0,
            Basis::Predicted => self.scale(row),
        }
    }
}

/// All of them together, if there are any.
pub(crate) fn combined<F: Frame>(
    parts: &[MassProperties<F>],
) -> Result<Option<MassProperties<F>>, BodyError> {
    match parts {
        [] => Ok(None),
        [one] => Ok(Some(*one)),
        parts => MassProperties::combined(parts).map(Some),
    }
}
