//! Questions of a plan: conditions on the columns of its members.

use polhode::math::formula::Formula;
use polhode_scenario::read::{Question, Template};
use polhode_source::FormatError;
use polhode_source::unit;
use polhode_source::unit::Dimension;

use super::Variable;
use crate::batch::{Batch, Column, Values};

/// A condition on the columns of a member, by its name.
#[derive(Clone, Debug)]
pub(crate) struct Condition {
    /// What the plan calls it.
    pub(crate) name: String,
    /// As it is written.
    pub(crate) text: String,
    formula: Formula,
    /// The columns that occur in it, by their place among the formula's variables.
    pub(crate) columns: Vec<(usize, String)>,
}

impl Condition {
    /// The condition of a question on inputs and outcomes.
    ///
    /// # Errors
    /// [`FormatError`] if it is none.
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

    /// Whether each row of a table fulfils it; `None` of a row that lacks one of its columns, or of which a part of it is no number.
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

/// What a column of this unit measures.
fn dimension(unit: &str) -> Dimension {
    unit::measured(&format!("1 {unit}")).map_or(Dimension::NONE, |(_, dimension)| dimension)
}
