//! Tables of torques in Parquet.

use ::parquet::errors::ParquetError;
use ::parquet::file::reader::{FileReader as _, SerializedFileReader};
use ::parquet::record::Field;
use bytes::Bytes;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::table_columns::{columns, push};
use crate::read::rows::TorqueRows;

/// Reads the rows of a file.
pub(super) fn of_parquet(bytes: &[u8]) -> Result<TorqueRows, ContentError> {
    let broken = |error: ParquetError| {
        let kind = ContentErrorKind::Unsupported { what: format!("this Parquet file ({error})") };
        ContentError::new(kind, ContentPlace::Whole)
            .hint("write it without compression, or with LZ4 or Snappy")
    };
    let file = SerializedFileReader::new(Bytes::copy_from_slice(bytes)).map_err(broken)?;
    // Each row has one field per top-level column, also for nested columns.
    let schema = file.metadata().file_metadata().schema();
    let names: Vec<&str> = schema.get_fields().iter().map(|field| field.name()).collect();
    let columns = columns(&names, |_| ContentPlace::Whole)?;
    let mut rows = TorqueRows::default();
    for row in file.get_row_iter(None).map_err(broken)? {
        let row = row.map_err(broken)?;
        let fields: Vec<&Field> = row.get_column_iter().map(|(_, field)| field).collect();
        let mut numbers = [0.0; 4];
        for (slot, column) in numbers.iter_mut().zip(&columns) {
            let field = fields.get(column.place).copied().unwrap_or(&Field::Null);
            *slot = number(field).ok_or_else(|| {
                let what = names.get(column.place).copied().unwrap_or_default().to_owned();
                let rule = format!("a finite number; it is that of row {}", rows.times.len() + 1);
                let kind = ContentErrorKind::Value { what, value: field.to_string(), rule };
                ContentError::new(kind, ContentPlace::Whole)
            })?;
        }
        push(&mut rows, &columns, numbers, 0..0)
            .map_err(|error| ContentError { place: ContentPlace::Whole, ..error })?;
    }
    Ok(rows)
}

/// Returns a finite number.
fn number(field: &Field) -> Option<f64> {
    let number = match *field {
        Field::Double(x) => x,
        Field::Float(x) => f64::from(x),
        Field::Int(n) => f64::from(n),
        Field::Long(n) => n as f64,
        _ => return None,
    };
    number.is_finite().then_some(number)
}
