//! The inputs of members, as rows.

use std::ops::Range;

use crate::batch::{Batch, Column, Values};
use crate::plan::Plan;

/// The column of members' numbers.
pub(crate) const MEMBER: &str = "member";

/// The inputs of some members: `member`, and a column for each variable of the plan, in SI.
pub fn inputs(plan: &Plan, members: Range<u64>) -> Batch {
    let numbers: Vec<u64> = members.collect();
    let mut variables: Vec<Vec<f64>> = vec![Vec::with_capacity(numbers.len()); plan.variables().len()];
    for &member in &numbers {
        for (column, value) in variables.iter_mut().zip(plan.values(member)) {
            column.push(value);
        }
    }
    let member = Column {
        name: MEMBER.to_owned(),
        unit: String::new(),
        description: "the member's number, from 0".to_owned(),
        values: Values::Whole(numbers),
    };
    let columns = plan.variables().iter().zip(variables).map(|(variable, values)| Column {
        name: variable.name.clone(),
        unit: variable.unit.clone(),
        description: variable.description.clone(),
        values: Values::Numbers(values),
    });
    // A plan's variables have different names: this cannot fail, and an empty table would be seen at once.
    Batch::new(std::iter::once(member).chain(columns).collect()).unwrap_or_default()
}
