//! `[sweep.questions]`: conditions on the outcomes of members.

use std::ops::Range;

use polhode_source::FormatError;
use polhode_source::toml::reader::Table;

/// Named condition on the columns of a sweep.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// Name in the file.
    pub name: String,
    /// Condition as written.
    pub condition: String,
    /// Bytes of the condition in the file.
    pub place: Range<usize>,
}

/// Reads questions such as `lost = "largest_angle_to_axis_3_rad > 90 deg"`.
pub(crate) fn questions(sweep: &Table<'_>) -> Result<Vec<Question>, FormatError> {
    let Some(value) = sweep.get("questions") else { return Ok(Vec::new()) };
    let table = value.table()?;
    let question = |(name, value): (&str, super::Value<'_>)| {
        let condition = value.string()?.to_owned();
        Ok(Question { name: name.to_owned(), condition, place: value.span() })
    };
    table.each("the condition").map(question).collect()
}
