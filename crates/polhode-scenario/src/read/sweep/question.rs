//! The `[sweep.questions]`: conditions on what becomes of members.

use std::ops::Range;

use polhode_source::FormatError;
use polhode_source::toml::reader::Table;

/// A condition on the columns of a sweep, by its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// What the file calls it.
    pub name: String,
    /// The condition, as it is written.
    pub condition: String,
    /// Where it stands in the file.
    pub place: Range<usize>,
}

/// `lost = "largest_angle_to_axis_3_rad > 90 deg"`, and so on.
pub(crate) fn questions(sweep: &Table<'_>) -> Result<Vec<Question>, FormatError> {
    let Some(value) = sweep.get("questions") else { return Ok(Vec::new()) };
    let table = value.table()?;
    let question = |(name, value): (&str, super::Value<'_>)| {
        let condition = value.string()?.to_owned();
        Ok(Question { name: name.to_owned(), condition, place: value.span() })
    };
    table.each("the condition").map(question).collect()
}
