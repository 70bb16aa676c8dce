//! Tables as Apache Parquet: required columns of doubles, with their units in the file's metadata.
//!
//! `BYTE_STREAM_SPLIT` stores bytes of equal weight together before the LZ4 compression.
//! Neighbouring samples share their signs, exponents and first digits, and little else.

use std::io::{self, Write};
use std::sync::Arc;

use ::parquet::basic::{Compression, Encoding, Repetition, Type as Physical};
use ::parquet::data_type::DoubleType;
use ::parquet::errors::ParquetError;
use ::parquet::file::metadata::KeyValue;
use ::parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesBuilder};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::types::{Type, TypePtr};

use super::{CONVENTIONS, Column, Table};

/// Number of rows that are in memory and compressed at a time.
const ROW_GROUP: usize = 1 << 20;

impl Table<'_> {
    /// Writes the table as Apache Parquet.
    ///
    /// The file's metadata has `polhode.version`, `polhode.conventions` ([`CONVENTIONS`]),
    /// `polhode.units` and `polhode.descriptions` (JSON objects, column → text). The pairs of
    /// `metadata` follow.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_parquet(&self, metadata: &[(String, String)], out: impl Write + Send) -> io::Result<()> {
        self.encode(metadata, out).map_err(io_error)
    }

    fn encode(&self, metadata: &[(String, String)], out: impl Write + Send) -> Result<(), ParquetError> {
        let properties = Arc::new(properties(self.columns(), metadata));
        let mut file = SerializedFileWriter::new(out, self.schema()?, properties)?;
        for first in (0..self.rows()).step_by(ROW_GROUP) {
            let mut group = file.next_row_group()?;
            for column in self.columns() {
                let Some(mut writer) = group.next_column()? else { break };
                let rows = first..self.rows().min(first + ROW_GROUP);
                let values: Vec<f64> = rows.map(|row| column.value(row)).collect();
                writer.typed::<DoubleType>().write_batch(&values, None, None)?;
                writer.close()?;
            }
            group.close()?;
        }
        file.close().map(drop)
    }

    fn schema(&self) -> Result<TypePtr, ParquetError> {
        let field = |column: &Column<'_>| {
            let field = Type::primitive_type_builder(&column.name, Physical::DOUBLE);
            Ok(Arc::new(field.with_repetition(Repetition::REQUIRED).build()?))
        };
        let fields = self.columns().iter().map(field).collect::<Result<_, ParquetError>>()?;
        Ok(Arc::new(Type::group_type_builder(self.name()).with_fields(fields).build()?))
    }
}

fn properties(columns: &[Column<'_>], metadata: &[(String, String)]) -> WriterProperties {
    let pair = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
    let mut pairs = vec![
        pair("polhode.version", env!("CARGO_PKG_VERSION").to_owned()),
        pair("polhode.conventions", CONVENTIONS.to_owned()),
        pair("polhode.units", json_object(columns, |column| column.unit)),
        pair("polhode.descriptions", json_object(columns, |column| column.description)),
    ];
    pairs.extend(metadata.iter().map(|(key, value)| pair(key, value.clone())));
    parquet_properties(pairs).set_encoding(Encoding::BYTE_STREAM_SPLIT).build()
}

/// Returns the properties of every Parquet file that polhode writes, with these pairs in its
/// metadata.
#[must_use]
pub fn parquet_properties(pairs: Vec<KeyValue>) -> WriterPropertiesBuilder {
    WriterProperties::builder()
        .set_created_by(concat!("polhode version ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_key_value_metadata(Some(pairs))
        .set_dictionary_enabled(false) // the numbers of a motion hardly repeat
        .set_compression(Compression::LZ4_RAW)
        .set_statistics_enabled(EnabledStatistics::None) // motions are not searched by value
}

/// Returns `{"name": "text", …}`. The texts must not contain quotes, backslashes or control
/// characters. A test checks this.
fn json_object(columns: &[Column<'_>], text: impl Fn(&Column<'_>) -> &'static str) -> String {
    let members: Vec<_> = columns.iter().map(|c| format!("\"{}\": \"{}\"", c.name, text(c))).collect();
    format!("{{{}}}", members.join(", "))
}

/// Returns the error of the underlying reader or writer, if that is the cause.
pub fn io_error(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(inner) => match inner.downcast::<io::Error>() {
            Ok(io) => *io,
            Err(other) => io::Error::other(other),
        },
        other => io::Error::other(other),
    }
}
