//! Parts lists, row by row.

use crate::budget::Budget;
use crate::error::BudgetError;
use crate::group::Group;
use crate::growth::GrowthTable;
use crate::row::Row;

/// A parts list, as it is given. Long lists are better built from [`Rows`](crate::Rows), which take less memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartsList {
    /// Rows in any order.
    pub rows: Vec<Row>,
    /// Groups that rows name.
    pub groups: Vec<Group>,
    /// Growth allowances by maturity code.
    pub growth: GrowthTable,
}

impl PartsList {
    /// Checks that the list makes a body.
    ///
    /// # Errors
    /// As [`Budget::new`].
    pub fn budget(self) -> Result<Budget, BudgetError> {
        Budget::new(self.rows.into_iter().collect(), self.groups, self.growth)
    }
}
