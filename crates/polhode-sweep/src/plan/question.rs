//! Questions of a plan: conditions on the columns of its members.

use polhode::math::formula::Formula;
use polhode_scenario::read::{Question, Template};
use polhode_source::FormatError;
use polhode_source::unit;
use polhode_source::unit::Dimension;

use super::Variable;
use crate::batch::{Batch, Column, Values};

/// Named condition on the columns of a member.
#[derive(Clone, Debug)]
pub(crate) struct Condition {
    /// Name in the plan.
    pub(crate) name: String,
    /// Text of the condition in the plan.
    pub(crate) text: String,
    formula: Formula,
    /// Columns in the condition, with their indices among the formula's variables.
    pub(crate) columns: Vec<(usize, String)>,
}

impl Condition {
    /// Compiles a question on inputs and outcomes.
    ///
    /// # Errors
    /// [`FormatError`] if it is not a condition.
    pub(crate) fn new(
        template: &Template,
        question: &Question,
        inputs: &[Variable],
        outcomes: &[Column],
    ) -> Result<Self, FormatError> {
        let is_number = |column: &&Column| !matches!(column.values, Values::Text(_));
        let outcomes = outcomes.iter().filter(is_number).map(|column| (&column.name, &column.unit));
        let inputs = inputs.iter().map(|variable| (&variable.name, &variable.unit));
        let columns: Vec<(&str, Dimension)> =
            inputs.chain(outcomes).map(|(name, unit)| (name.as_str(), dimension(unit))).collect();
        let formula = template.condition(question, &columns)?;
        let occurring = columns.iter().enumerate().filter(|(k, _)| formula.depends_on(*k));
        let columns = occurring.map(|(k, (name, _))| (k, (*name).to_owned())).collect();
        Ok(Self { name: question.name.clone(), text: question.condition.clone(), formula, columns })
    }

    /// Evaluates the condition for each row of a table; `None` if a column is missing or the result
    /// is NaN.
    pub(crate) fn answers(&self, rows: &Batch) -> Vec<Option<bool>> {
        let columns: Vec<(usize, Option<&Values>)> =
            self.columns.iter().map(|(k, name)| (*k, rows.column(name).ok().map(|c| &c.values))).collect();
        let mut point = vec![f64::NAN; self.columns.iter().map(|(k, _)| k + 1).max().unwrap_or(0)];
        let mut answer = |row: usize| {
            for (k, values) in &columns {
                *point.get_mut(*k)? = values.and_then(|values| values.number(row))?;
            }
            match self.formula.evaluate(&point) {
                value if value.is_nan() => None,
                value => Some(value != 0.0),
            }
        };
        (0..rows.rows()).map(&mut answer).collect()
    }
}

/// Returns the dimension of a unit.
fn dimension(unit: &str) -> Dimension {
    unit::measured(&format!("1 {unit}")).map_or(Dimension::NONE, |(_, dimension)| dimension)
}
