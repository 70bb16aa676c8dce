//! The trajectory table as Apache Parquet: columns of required doubles, each with its unit in the file's metadata.
//!
//! Bytes of equal weight stand together (`BYTE_STREAM_SPLIT`) before LZ4 packs them, because neighbouring samples
//! share their signs, exponents and first digits and little else.

use std::io::{self, Write};
use std::ops::Range;
use std::sync::Arc;

use ::parquet::basic::{Compression, Encoding, Repetition, Type as Physical};
use ::parquet::data_type::DoubleType;
use ::parquet::errors::ParquetError;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::{EnabledStatistics, WriterProperties};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::types::{Type, TypePtr};

use super::required::RequiredTable;
use super::{CONVENTIONS, Surroundings, columns};
use polhode::motion::Trajectory;

/// Writes a trajectory of a body in these surroundings: one row per sample.
///
/// The file's metadata holds `polhode.version`, `polhode.conventions` ([`CONVENTIONS`]), `polhode.units` and
/// `polhode.descriptions` (JSON objects, column → text), and the pairs of `metadata` after them.
///
/// # Errors
/// Those of `out`.
pub fn write(
    trajectory: &Trajectory,
    surroundings: &Surroundings,
    metadata: &[(String, String)],
    out: impl Write + Send,
) -> io::Result<()> {
    encode(trajectory, surroundings, metadata, out).map_err(io_error)
}

/// Rows that are held in memory, and packed, at a time.
const ROW_GROUP: usize = 1 << 20;

/// Writes what a prescribed motion needs: one row per sample, with metadata as [`write()`] has it.
///
/// # Errors
/// Those of `out`.
pub fn write_required(
    table: &RequiredTable,
    metadata: &[(String, String)],
    out: impl Write + Send,
) -> io::Result<()> {
    let heads: Vec<Head<'_>> =
        table.columns().iter().map(|c| [c.name.as_str(), c.unit, c.description]).collect();
    let values = |column: usize, rows: Range<usize>| {
        let all = table.columns().get(column).map_or(&[][..], |column| &column.values);
        all.get(rows).unwrap_or_default().to_vec()
    };
    encode_columns("required", &heads, table.rows(), values, metadata, out).map_err(io_error)
}

/// Name, unit and description of a column.
type Head<'a> = [&'a str; 3];

fn encode(
    trajectory: &Trajectory,
    surroundings: &Surroundings,
    metadata: &[(String, String)],
    out: impl Write + Send,
) -> Result<(), ParquetError> {
    let (columns, rows) = (columns(trajectory, surroundings), trajectory.samples().len());
    let heads: Vec<Head<'_>> = columns.iter().map(|c| [&*c.name, c.unit, c.description]).collect();
    let values =
        |column: usize, rows: Range<usize>| rows.map(|row| columns[column].value(trajectory, row)).collect();
    encode_columns("trajectory", &heads, rows, values, metadata, out)
}

fn encode_columns(
    name: &str,
    heads: &[Head<'_>],
    rows: usize,
    values: impl Fn(usize, Range<usize>) -> Vec<f64>,
    metadata: &[(String, String)],
    out: impl Write + Send,
) -> Result<(), ParquetError> {
    let mut file =
        SerializedFileWriter::new(out, schema(name, heads)?, Arc::new(properties(heads, metadata)))?;
    for first in (0..rows).step_by(ROW_GROUP) {
        let mut group = file.next_row_group()?;
        for column in 0..heads.len() {
            let Some(mut writer) = group.next_column()? else { break };
            let values = values(column, first..rows.min(first + ROW_GROUP));
            writer.typed::<DoubleType>().write_batch(&values, None, None)?;
            writer.close()?;
        }
        group.close()?;
    }
    file.close().map(drop)
}

fn schema(name: &str, heads: &[Head<'_>]) -> Result<TypePtr, ParquetError> {
    let field = |[name, ..]: &Head<'_>| {
        let field = Type::primitive_type_builder(name, Physical::DOUBLE);
        Ok(Arc::new(field.with_repetition(Repetition::REQUIRED).build()?))
    };
    let fields = heads.iter().map(field).collect::<Result<_, ParquetError>>()?;
    Ok(Arc::new(Type::group_type_builder(name).with_fields(fields).build()?))
}

fn properties(heads: &[Head<'_>], metadata: &[(String, String)]) -> WriterProperties {
    let pair = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
    let mut pairs = vec![
        pair("polhode.version", env!("CARGO_PKG_VERSION").to_owned()),
        pair("polhode.conventions", CONVENTIONS.to_owned()),
        pair("polhode.units", json_object(heads, |[_, unit, _]| unit)),
        pair("polhode.descriptions", json_object(heads, |[.., description]| description)),
    ];
    pairs.extend(metadata.iter().map(|(key, value)| pair(key, value.clone())));
    WriterProperties::builder()
        .set_created_by(concat!("polhode version ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_key_value_metadata(Some(pairs))
        .set_dictionary_enabled(false) // hardly a number of a motion comes twice
        .set_encoding(Encoding::BYTE_STREAM_SPLIT)
        .set_compression(Compression::LZ4_RAW)
        .set_statistics_enabled(EnabledStatistics::None) // nobody searches a motion by value
        .build()
}

/// `{"name": "text", …}` of texts without quotes, backslashes or control characters: ours are (a test says so).
fn json_object(heads: &[Head<'_>], text: impl for<'a> Fn(&Head<'a>) -> &'a str) -> String {
    let members: Vec<_> = heads.iter().map(|head| format!("\"{}\": \"{}\"", head[0], text(head))).collect();
    format!("{{{}}}", members.join(", "))
}

/// The error of the writer below, where that is what it was.
fn io_error(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(inner) => match inner.downcast::<io::Error>() {
            Ok(io) => *io,
            Err(other) => io::Error::other(other),
        },
        other => io::Error::other(other),
    }
}
