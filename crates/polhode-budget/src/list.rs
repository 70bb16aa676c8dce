//! Parts lists as they are given.

use crate::group::Group;
use crate::growth::GrowthTable;
use crate::row::Row;

/// Parts list as it is given. Long lists take less memory as [`Rows`](crate::Rows).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartsList {
    /// Rows, in any order.
    pub rows: Vec<Row>,
    /// Groups that the rows refer to.
    pub groups: Vec<Group>,
    /// Growth allowances by maturity code.
    pub growth: GrowthTable,
}
