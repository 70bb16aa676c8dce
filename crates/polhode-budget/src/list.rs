//! Parts lists, row by row.

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
