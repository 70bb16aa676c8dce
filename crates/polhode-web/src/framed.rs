//! Answers as bytes: JSON, or JSON followed by rows of numbers.

use serde::Serialize;

use crate::refusal::{Refusal, RefusalKind};

/// Returns a value as JSON.
///
/// # Errors
/// [`RefusalKind::Internal`] if the value cannot be written.
pub fn json(value: &impl Serialize) -> Result<Vec<u8>, Refusal> {
    serde_json::to_vec(value).map_err(|error| Refusal::new(RefusalKind::Internal, error.to_string()))
}

/// Returns a value as the beginning of an answer with rows: the length of the JSON as a u64, and
/// the JSON padded with spaces to a multiple of eight bytes. The rows follow.
///
/// Everything is little-endian and aligned, so that the page reads the numbers in place. The first
/// byte is a multiple of eight, unlike that of an object in JSON.
///
/// ```
/// let head = polhode_web::json_before_rows(&serde_json::json!({ "took": 1.5 }))?;
/// assert_eq!(head, b"\x10\0\0\0\0\0\0\0{\"took\":1.5}    ");
/// # Ok::<(), polhode_web::Refusal>(())
/// ```
///
/// # Errors
/// Same as [`json`].
pub fn json_before_rows(value: &impl Serialize) -> Result<Vec<u8>, Refusal> {
    const WORD: usize = size_of::<u64>();
    let mut json = json(value)?;
    json.resize(json.len().next_multiple_of(WORD), b' ');
    Ok([&(json.len() as u64).to_le_bytes(), json.as_slice()].concat())
}

/// Returns a complete answer with rows.
pub(crate) fn with_rows(value: &impl Serialize, rows: &[u8]) -> Result<Vec<u8>, Refusal> {
    let mut answer = json_before_rows(value)?;
    answer.extend_from_slice(rows);
    Ok(answer)
}
