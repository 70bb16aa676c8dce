//! Tables of members: inputs from member numbers, and outcomes from inputs.
//!
//! A row of outcomes is a function of the plan and of the row's own inputs. It does not depend on
//! other rows, on time or on threads. So a table can be split and computed anywhere.

use std::ops::Range;

use polhode::motion::Scenario;
use polhode_source::FormatError;

use crate::batch::{Batch, BatchError, Column, MEMBER, Values};
use crate::outcome::{self, Outcome};
use crate::plan::{Plan, Variable};

/// Returns the inputs of some members: `member`, and one column per variable of the plan, in SI
/// units.
pub fn inputs(plan: &Plan, members: Range<u64>) -> Batch {
    let numbers: Vec<u64> = members.collect();
    let mut variables: Vec<Vec<f64>> = vec![Vec::with_capacity(numbers.len()); plan.variables().len()];
    for &member in &numbers {
        for (column, value) in variables.iter_mut().zip(plan.values(member)) {
            column.push(value);
        }
    }
    let columns = plan.variables().iter().zip(variables);
    let columns = columns.map(|(variable, values)| of_variable(variable, Values::Numbers(values)));
    // The variables of a plan have different names, so this cannot fail; an empty table would be
    // noticed immediately.
    Batch::new(std::iter::once(Column::of_members(numbers)).chain(columns).collect()).unwrap_or_default()
}

fn of_variable(variable: &Variable, values: Values) -> Column {
    Column::new([&variable.name, &variable.unit, &variable.description], values)
}

/// Adds outcomes to the rows of `inputs`: status, regime, periods, final state, extrema, events,
/// cost.
///
/// A member without a body or a motion, or whose computation fails, is a row with `status` and
/// `cause`.
///
/// # Errors
/// [`BatchError`] if the column `member` or a variable of the plan is missing or has values of the
/// wrong kind, or if a variable has the name of an outcome.
pub fn simulate(plan: &Plan, inputs: &Batch) -> Result<Batch, BatchError> {
    let members = Members::of(plan, inputs)?;
    let outcomes: Vec<Outcome> =
        members.scenarios(plan).map(|scenario| Outcome::of(scenario.as_ref())).collect();
    let outcomes = outcome::columns_of(plan.nominal(), &outcomes);
    Batch::new(members.columns.into_iter().chain(outcomes).collect())
}

/// Returns the motions of the members of `inputs`: a row per sample time, until the motion ends.
///
/// # Errors
/// Same as [`simulate`].
pub fn trajectories(plan: &Plan, inputs: &Batch) -> Result<Batch, BatchError> {
    let members = Members::of(plan, inputs)?;
    let samples = members.scenarios(plan).map(|scenario| scenario.ok().map(|s| outcome::samples(&s)));
    outcome::table(&members.numbers, samples.map(Option::unwrap_or_default))
}

/// Inputs of some members.
struct Members {
    /// Column `member` and the variables of the plan.
    columns: Vec<Column>,
    numbers: Vec<u64>,
    /// Values of the variables, row by row.
    values: Vec<Vec<f64>>,
}

impl Members {
    fn of(plan: &Plan, inputs: &Batch) -> Result<Self, BatchError> {
        let wrong = |column: &Column, expected| BatchError::Kind { column: column.name.clone(), expected };
        let member = inputs.column(MEMBER)?;
        let Values::Whole(numbers) = &member.values else { return Err(wrong(member, "integers")) };
        let mut columns = vec![member.clone()];
        let mut values = vec![Vec::with_capacity(plan.variables().len()); numbers.len()];
        for variable in plan.variables() {
            let column = inputs.column(&variable.name)?;
            let Values::Numbers(numbers) = &column.values else {
                return Err(wrong(column, "one number in each row"));
            };
            for (row, &number) in values.iter_mut().zip(numbers) {
                row.push(number);
            }
            columns.push(of_variable(variable, column.values.clone()));
        }
        Ok(Self { columns, numbers: numbers.clone(), values })
    }

    fn scenarios(&self, plan: &Plan) -> impl Iterator<Item = Result<Scenario, FormatError>> {
        self.values.iter().map(|values| plan.scenario(values))
    }
}
