//! `[result]`: what is asked of the whole.

use polhode::math::Position;
use polhode_budget::Basis;

use crate::budget::Questions;
use crate::error::FormatError;
use crate::scenario::reader::Table;
use crate::scenario::rotation::rotation;
use crate::unit::Dimension;

/// Reads `[result]`.
pub(super) fn questions(table: &Table<'_>) -> Result<Questions, FormatError> {
    table.allow(&["about", "axes", "draws", "seed", "basis"])?;
    let mut questions = Questions::default();
    if let Some(value) = table.get("about") {
        questions.about = Some(Position::from_array(value.quantities(Dimension::LENGTH)?));
    }
    if let Some(value) = table.get("axes") {
        questions.axes = Some(rotation(&value)?);
    }
    if let Some(value) = table.get("draws") {
        /// What fits into the memory of any machine.
        const MOST: usize = 10_000_000;
        questions.draws = usize::try_from(value.count()?)
            .ok()
            .filter(|draws| (1..=MOST).contains(draws))
            .ok_or_else(|| value.invalid(format!("from 1 to {MOST}")))?;
    }
    if let Some(value) = table.get("seed") {
        questions.seed = value.count()?;
    }
    if let Some(value) = table.get("basis") {
        questions.basis = match value.choice(&["basic", "predicted"])? {
            "basic" => Basis::Basic,
            _ => Basis::Predicted,
        };
    }
    Ok(questions)
}
