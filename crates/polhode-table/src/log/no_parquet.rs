//! Parquet in a build without the feature `parquet`: every file is refused.

use bytes::Bytes;
use polhode_source::ContentError;

use super::Numbers;
use super::choice::Wanted;
use super::columns::Columns;

pub(crate) fn read(_: Bytes, _: Option<&Columns>, _: Wanted) -> Result<Numbers, ContentError> {
    Err(refused())
}

/// Refuses the file.
pub fn names(_: &Bytes) -> Result<Vec<String>, ContentError> {
    Err(refused())
}

/// Refuses the file.
pub fn table(_: &Bytes, _: &[usize]) -> Result<Vec<Vec<f64>>, ContentError> {
    Err(refused())
}

fn refused() -> ContentError {
    ContentError::unsupported("Parquet: this program was built without it")
        .hint("write the log as CSV, or use the polhode command")
}
