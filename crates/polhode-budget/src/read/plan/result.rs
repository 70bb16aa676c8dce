//! `[result]`: requested results for the whole.

use polhode::math::Position;
use polhode_source::FormatError;
use polhode_source::toml::reader::Table;
use polhode_source::toml::rotation;
use polhode_source::unit::Dimension;

use crate::Basis;
use crate::read::{LEAST_DRAWS, MOST_DRAWS, Questions};

/// Reads the table `[result]`.
pub(crate) fn questions(table: &Table<'_>) -> Result<Questions, FormatError> {
    table.allow(&["about", "axes", "draws", "seed", "basis"])?;
    let mut questions = Questions::default();
    if let Some(value) = table.get("about") {
        questions.about = Some(Position::from_array(value.quantities(Dimension::LENGTH)?));
    }
    if let Some(value) = table.get("axes") {
        questions.axes = Some(rotation(&value)?);
    }
    if let Some(value) = table.get("draws") {
        let draws = usize::try_from(value.count()?).ok();
        let draws = draws.filter(|draws| (LEAST_DRAWS..=MOST_DRAWS).contains(draws));
        let rule = || format!("from {LEAST_DRAWS} to {MOST_DRAWS}");
        questions.draws = Some(draws.ok_or_else(|| value.invalid(rule()))?);
    }
    if let Some(value) = table.get("seed") {
        questions.seed = value.count()?;
    }
    if let Some(value) = table.get("basis") {
        questions.basis = value.named(&Basis::NAMED)?;
    }
    Ok(questions)
}
