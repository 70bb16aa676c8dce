//! What becomes of members: rows in, rows out.
//!
//! A row of outcomes is a function of the plan and of the row's own inputs. It knows no other row, no clock and no thread, so that
//! a table can be cut and computed anywhere.

mod columns;
mod extrema;
mod free;
mod instant;
mod member;
mod trajectory;

use polhode::motion::{Method, Scenario};
use polhode_source::FormatError;

use crate::batch::{Batch, BatchError, Column, Values};
use crate::plan::Plan;
use crate::rows::MEMBER;
use member::Outcome;

/// The rows of `inputs`, each with what becomes of its member: how it ended, which kind of motion it is, periods, final state,
/// extrema, events, cost.
///
/// A member without a body or a motion, and one whose computation fails, is a row that says so in `status` and `cause`.
///
/// # Errors
/// [`BatchError`] if the column `member` or a variable of the plan is missing or holds something else, or a variable has the
/// name of an outcome.
pub fn simulate(plan: &Plan, inputs: &Batch) -> Result<Batch, BatchError> {
    let members = Members::of(plan, inputs)?;
    let outcomes: Vec<Outcome> =
        members.scenarios(plan).map(|scenario| Outcome::of(scenario.as_ref())).collect();
    let outcomes = columns::of(plan.nominal(), &outcomes);
    Batch::new(members.columns.into_iter().chain(outcomes).collect())
}

/// The columns of outcomes of a plan of this scenario, without rows.
pub(crate) fn columns_of(nominal: &Scenario) -> Vec<Column> {
    columns::of(nominal, &[])
}

/// The motions of the members of `inputs`: a row for each of the sample times, as far as a motion goes.
///
/// # Errors
/// As [`simulate`].
pub fn trajectories(plan: &Plan, inputs: &Batch) -> Result<Batch, BatchError> {
    let members = Members::of(plan, inputs)?;
    let samples = members.scenarios(plan).map(|scenario| scenario.ok().map(|s| trajectory::samples(&s)));
    trajectory::table(&members.numbers, samples.map(Option::unwrap_or_default))
}

/// True if members' motions are computed in steps, as far as can be seen before.
pub(crate) fn is_stepped(scenario: &Scenario) -> bool {
    let method = scenario.run().map_or(Method::Auto, |run| run.method);
    let driven =
        !scenario.torques().is_empty() || !scenario.wheels().is_empty() || !scenario.events().is_empty();
    scenario.prescribed().is_none() && (driven || !matches!(method, Method::Auto | Method::Exact))
}

/// The inputs of some members.
struct Members {
    /// `member` and the variables of the plan.
    columns: Vec<Column>,
    numbers: Vec<u64>,
    /// Row by row.
    values: Vec<Vec<f64>>,
}

impl Members {
    fn of(plan: &Plan, inputs: &Batch) -> Result<Self, BatchError> {
        let wrong = |column: &Column, expected| BatchError::Kind { column: column.name.clone(), expected };
        let member = inputs.column(MEMBER)?;
        let Values::Whole(numbers) = &member.values else { return Err(wrong(member, "whole numbers")) };
        let mut columns = vec![member.clone()];
        let mut values = vec![Vec::with_capacity(plan.variables().len()); numbers.len()];
        for variable in plan.variables() {
            let column = inputs.column(&variable.name)?;
            let Values::Numbers(numbers) = &column.values else {
                return Err(wrong(column, "numbers, one in each row"));
            };
            for (row, &number) in values.iter_mut().zip(numbers) {
                row.push(number);
            }
            columns.push(Column {
                name: variable.name.clone(),
                unit: variable.unit.clone(),
                description: variable.description.clone(),
                values: column.values.clone(),
            });
        }
        Ok(Self { columns, numbers: numbers.clone(), values })
    }

    fn scenarios(&self, plan: &Plan) -> impl Iterator<Item = Result<Scenario, FormatError>> {
        self.values.iter().map(|values| plan.scenario(values))
    }
}
