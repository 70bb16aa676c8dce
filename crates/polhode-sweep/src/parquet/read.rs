//! Decoding of a file to rows.

use ::parquet::basic::{Repetition, Type as Physical};
use ::parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use ::parquet::data_type::{ByteArray, DataType};
use ::parquet::errors::ParquetError;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::reader::{FileReader as _, SerializedFileReader};
use bytes::Bytes;
use serde_json::{Map, Value};

use super::{DESCRIPTIONS, OURS, PREFIX, Pairs, UNITS};
use crate::batch::{Batch, Column, Values};

/// Returns the pairs of metadata with which a file was written.
///
/// # Errors
/// Same as [`read()`].
pub(super) fn metadata(bytes: Vec<u8>) -> Result<Pairs, ParquetError> {
    let file = SerializedFileReader::new(Bytes::from(bytes))?;
    let own = |pair: &KeyValue| pair.key.starts_with(PREFIX) && !OURS.contains(&pair.key.as_str());
    let pairs = pairs(&file).into_iter().filter(own);
    Ok(pairs.filter_map(|pair| Some((pair.key, pair.value?))).collect())
}

fn pairs(file: &SerializedFileReader<Bytes>) -> Vec<KeyValue> {
    file.metadata().file_metadata().key_value_metadata().cloned().unwrap_or_default()
}

/// Returns the rows of a file.
///
/// # Errors
/// [`ParquetError`] for bytes of another format.
pub(super) fn read(bytes: Vec<u8>) -> Result<Batch, ParquetError> {
    let file = SerializedFileReader::new(Bytes::from(bytes))?;
    let pairs = pairs(&file);
    let (units, descriptions) = (texts(&pairs, UNITS), texts(&pairs, DESCRIPTIONS));
    let text = |texts: &Map<String, Value>, name: &str| {
        texts.get(name).and_then(Value::as_str).unwrap_or_default().to_owned()
    };
    let mut columns = Vec::new();
    for (k, descriptor) in file.metadata().file_metadata().schema_descr().columns().iter().enumerate() {
        let name = descriptor.name().to_owned();
        let optional = descriptor.self_type().get_basic_info().repetition() == Repetition::OPTIONAL;
        let mut values = empty(descriptor.physical_type(), optional)?;
        for group in 0..file.num_row_groups() {
            let group = file.get_row_group(group)?;
            let rows = usize::try_from(group.metadata().num_rows())
                .map_err(|_| ParquetError::General("a negative number of rows".to_owned()))?;
            append(&mut values, group.get_column_reader(k)?, rows)?;
        }
        let unit = text(&units, &name);
        let unit = if unit == "1" { String::new() } else { unit };
        columns.push(Column { description: text(&descriptions, &name), unit, name, values });
    }
    Batch::new(columns).map_err(|error| ParquetError::General(error.to_string()))
}

/// Returns the JSON object of texts under a key.
fn texts(pairs: &[KeyValue], key: &str) -> Map<String, Value> {
    let text = pairs.iter().find(|pair| pair.key == key).and_then(|pair| pair.value.as_deref());
    match text.map(serde_json::from_str) {
        Some(Ok(Value::Object(object))) => object,
        _ => Map::new(),
    }
}

fn empty(kind: Physical, optional: bool) -> Result<Values, ParquetError> {
    match (kind, optional) {
        (Physical::INT64, false) => Ok(Values::Whole(Vec::new())),
        (Physical::DOUBLE, false) => Ok(Values::Numbers(Vec::new())),
        (Physical::DOUBLE, true) => Ok(Values::Perhaps(Vec::new())),
        (Physical::BYTE_ARRAY, true) => Ok(Values::Text(Vec::new())),
        _ => Err(ParquetError::General(format!("a sweep has no columns of type {kind}"))),
    }
}

/// Reads all rows of a column in a row group.
fn append(values: &mut Values, reader: ColumnReader, rows: usize) -> Result<(), ParquetError> {
    let wrong = || Err(ParquetError::General("the content of a column does not match its schema".to_owned()));
    match (values, reader) {
        (Values::Whole(values), ColumnReader::Int64ColumnReader(reader)) => {
            for value in all(reader, rows)?.0 {
                let Ok(value) = u64::try_from(value) else { return wrong() };
                values.push(value);
            }
        }
        (Values::Numbers(values), ColumnReader::DoubleColumnReader(reader)) => {
            values.extend(all(reader, rows)?.0);
        }
        (Values::Perhaps(values), ColumnReader::DoubleColumnReader(reader)) => {
            let (there, levels) = all(reader, rows)?;
            values.extend(spread(there, &levels));
        }
        (Values::Text(values), ColumnReader::ByteArrayColumnReader(reader)) => {
            let (there, levels) = all(reader, rows)?;
            for text in spread(there, &levels) {
                let text = text.map(|text: ByteArray| text.as_utf8().map(str::to_owned)).transpose()?;
                values.push(text);
            }
        }
        _ => return wrong(),
    }
    Ok(())
}

/// Reads the existing values, and the definition level of each row of an optional column.
fn all<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    rows: usize,
) -> Result<(Vec<T::T>, Vec<i16>), ParquetError> {
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    let mut found = 0;
    while found < rows {
        let (records, ..) = reader.read_records(rows - found, Some(&mut levels), None, &mut values)?;
        if records == 0 {
            return Err(ParquetError::General(format!("a column ends after {found} of {rows} rows")));
        }
        found += records;
    }
    Ok((values, levels))
}

/// Returns a value for each nonzero level, `None` for the others.
fn spread<T>(values: Vec<T>, levels: &[i16]) -> Vec<Option<T>> {
    let mut values = values.into_iter();
    levels.iter().map(|level| if *level > 0 { values.next() } else { None }).collect()
}
