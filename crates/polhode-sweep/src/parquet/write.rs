//! Encoding of rows to a file.
//!
//! Bytes of equal significance are stored together (`BYTE_STREAM_SPLIT`) before LZ4 compression;
//! text uses a dictionary.

use std::io;
use std::sync::Arc;

use ::parquet::basic::{Encoding, LogicalType, Repetition, Type as Physical};
use ::parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use ::parquet::errors::ParquetError;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use ::parquet::schema::types::{ColumnPath, Type, TypePtr};
use polhode_table::output::{CONVENTIONS as OF_TABLES, io_error, parquet_properties};
use serde_json::{Map, Value};

use super::{CHECKSUM, CONVENTIONS, DESCRIPTIONS, Pairs, UNITS, VERSION, seal};
use crate::batch::{Batch, Column, Values};

/// Returns the bytes of a file of rows. Metadata: `metadata`, and units, descriptions, conventions,
/// version and checksum.
///
/// # Errors
/// If the rows cannot be written as Parquet: a member number of 2⁶³ or more.
pub(crate) fn write(batch: &Batch, metadata: &Pairs) -> io::Result<Vec<u8>> {
    let mut bytes = encode(batch, metadata).map_err(io_error)?;
    if seal::close(&mut bytes) { Ok(bytes) } else { Err(io::Error::other("the file has no checksum")) }
}

fn encode(batch: &Batch, metadata: &Pairs) -> Result<Vec<u8>, ParquetError> {
    let properties = Arc::new(properties(batch, metadata));
    let mut file = SerializedFileWriter::new(Vec::new(), schema(batch)?, properties)?;
    let mut group = file.next_row_group()?;
    for column in batch.columns() {
        let Some(mut writer) = group.next_column()? else { break };
        values(&mut writer, &column.values)?;
        writer.close()?;
    }
    group.close()?;
    file.into_inner()
}

fn values(writer: &mut SerializedColumnWriter<'_>, values: &Values) -> Result<(), ParquetError> {
    match values {
        Values::Whole(values) => {
            let whole = values.iter().map(|&value| i64::try_from(value));
            let whole: Vec<i64> = whole.collect::<Result<_, _>>().map_err(|error| {
                ParquetError::General(format!("an integer does not fit into 63 bits: {error}"))
            })?;
            writer.typed::<Int64Type>().write_batch(&whole, None, None)?;
        }
        Values::Numbers(values) => {
            writer.typed::<DoubleType>().write_batch(values, None, None)?;
        }
        Values::Perhaps(values) => {
            let there: Vec<f64> = values.iter().flatten().copied().collect();
            writer.typed::<DoubleType>().write_batch(&there, Some(&levels(values)), None)?;
        }
        Values::Text(values) => {
            let there: Vec<ByteArray> =
                values.iter().flatten().map(|text| ByteArray::from(text.as_str())).collect();
            writer.typed::<ByteArrayType>().write_batch(&there, Some(&levels(values)), None)?;
        }
    }
    Ok(())
}

/// Returns the definition levels: 1 for an existing value, 0 for a missing one.
fn levels<T>(values: &[Option<T>]) -> Vec<i16> {
    values.iter().map(|value| i16::from(value.is_some())).collect()
}

fn schema(batch: &Batch) -> Result<TypePtr, ParquetError> {
    let field = |column: &Column| {
        let (kind, repetition, logical) = match column.values {
            Values::Whole(_) => (Physical::INT64, Repetition::REQUIRED, None),
            Values::Numbers(_) => (Physical::DOUBLE, Repetition::REQUIRED, None),
            Values::Perhaps(_) => (Physical::DOUBLE, Repetition::OPTIONAL, None),
            Values::Text(_) => (Physical::BYTE_ARRAY, Repetition::OPTIONAL, Some(LogicalType::String)),
        };
        let field = Type::primitive_type_builder(&column.name, kind);
        Ok(Arc::new(field.with_repetition(repetition).with_logical_type(logical).build()?))
    };
    let fields = batch.columns().iter().map(field).collect::<Result<_, ParquetError>>()?;
    Ok(Arc::new(Type::group_type_builder("sweep").with_fields(fields).build()?))
}

fn properties(batch: &Batch, metadata: &Pairs) -> WriterProperties {
    let pair = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
    let object = |text: fn(&Column) -> &str| {
        let entry = |column: &Column| (column.name.clone(), Value::from(text(column)));
        Value::Object(batch.columns().iter().map(entry).collect::<Map<_, _>>()).to_string()
    };
    let mut pairs = vec![
        pair(VERSION, env!("CARGO_PKG_VERSION").to_owned()),
        pair(CONVENTIONS, OF_TABLES.to_owned()),
        pair(UNITS, object(|column| if column.unit.is_empty() { "1" } else { &column.unit })),
        pair(DESCRIPTIONS, object(|column| &column.description)),
    ];
    pairs.extend(metadata.iter().map(|(key, value)| pair(key, value.clone())));
    pairs.push(pair(CHECKSUM, seal::OPEN.to_owned()));
    let mut properties = parquet_properties(pairs);
    for column in batch.columns() {
        let path = ColumnPath::from(column.name.as_str());
        properties = match column.values {
            Values::Whole(_) => properties.set_column_encoding(path, Encoding::DELTA_BINARY_PACKED),
            Values::Numbers(_) | Values::Perhaps(_) => {
                properties.set_column_encoding(path, Encoding::BYTE_STREAM_SPLIT)
            }
            Values::Text(_) => properties.set_column_dictionary_enabled(path, true),
        };
    }
    properties.build()
}
