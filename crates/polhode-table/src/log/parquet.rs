//! Parquet: a column of doubles, floats or integers for each number, and keys such as
//! `polhode.scenario` in the metadata of the file.

use std::thread;

use ::parquet::basic::{ConvertedType, LogicalType, TimeUnit, Type as Physical};
use ::parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use ::parquet::data_type::DataType;
use ::parquet::errors::ParquetError;
use ::parquet::file::reader::{FileReader as _, SerializedFileReader};
use ::parquet::schema::types::ColumnDescriptor;
use bytes::Bytes;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::choice::{self, Header, Plan, Wanted};
use super::columns::Columns;
use super::head::Head;
use super::rows::{MOST, Problem, RowError, Rows};

/// Number of rows that are in memory in addition to the result.
const BATCH: usize = 1 << 16;

/// Reads a log from a Parquet file.
pub(crate) fn read(
    bytes: Bytes,
    told: Option<&Columns>,
    wanted: Wanted,
) -> Result<(Head, Plan, Rows), ContentError> {
    let length = bytes.len();
    let file = opened(bytes)?;
    let head = head(&file)?;
    let columns = told.or(head.columns.as_ref()).cloned().unwrap_or_default();
    let plan = choice::choose(&header(&file), &columns, &head.units, wanted)?;
    let mut rows = Rows::default();
    let expected = usize::try_from(file.metadata().file_metadata().num_rows()).unwrap_or(0);
    // The number of rows that a file states may be wrong.
    rows.reserve(&plan, expected.min(length));
    let places: Vec<usize> = plan.slots.iter().map(|slot| slot.column).collect();
    each_batch(&file, &places, |batch, count| {
        append(&mut rows, &plan, batch, count).map_err(|error| error.told(&plan))
    })?;
    Ok((head, plan, rows))
}

/// Returns the names of a file's columns.
pub fn names(bytes: &Bytes) -> Result<Vec<String>, ContentError> {
    Ok(header(&opened(bytes.clone())?).names)
}

/// Returns the numbers of some columns, row by row.
pub fn table(bytes: &Bytes, places: &[usize]) -> Result<Vec<Vec<f64>>, ContentError> {
    let file = opened(bytes.clone())?;
    let names = header(&file).names;
    let mut rows = Vec::new();
    each_batch(&file, places, |columns, count| {
        for row in 0..count {
            let numbers = columns.iter().map(|(column, _)| column.get(row).copied().unwrap_or(f64::NAN));
            let numbers: Vec<f64> = numbers.collect();
            if let Some(wrong) = numbers.iter().position(|number| !number.is_finite()) {
                let what = format!("{} of row {}", names[places[wrong]], rows.len() + 1);
                let kind = ContentErrorKind::NotFinite { what, found: numbers[wrong].to_string() };
                return Err(
                    ContentError::new(kind, ContentPlace::Whole).hint("leave out rows that are not complete")
                );
            }
            rows.push(numbers);
        }
        Ok(())
    })?;
    Ok(rows)
}

fn opened(bytes: Bytes) -> Result<SerializedFileReader<Bytes>, ContentError> {
    SerializedFileReader::new(bytes).map_err(|error| broken(&error))
}

/// Passes on the rows of some columns in batches, with the number of rows in each.
fn each_batch(
    file: &SerializedFileReader<Bytes>,
    places: &[usize],
    mut take: impl FnMut(&[Numbers], usize) -> Result<(), ContentError>,
) -> Result<(), ContentError> {
    let schema = file.metadata().file_metadata().schema_descr();
    for &place in places {
        let column = schema.column(place);
        numeric(&column, &column.path().parts().join("."))?;
    }
    for group in 0..file.num_row_groups() {
        let group = file.get_row_group(group).map_err(|error| broken(&error))?;
        let left = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
        let readers = places.iter().map(|&place| {
            let chunk = group.metadata().column(place);
            let start = chunk.dictionary_page_offset().unwrap_or_else(|| chunk.data_page_offset());
            if start.min(chunk.data_page_offset()).min(chunk.compressed_size()) < 0 {
                return Err(ParquetError::General("a column begins before the file".to_owned()));
            }
            Ok((group.get_column_reader(place)?, schema.column(place).max_def_level()))
        });
        let readers: Result<Vec<_>, ParquetError> = readers.collect();
        let mut readers = readers.map_err(|error| broken(&error))?;
        for first in (0..left).step_by(BATCH) {
            let count = BATCH.min(left - first);
            take(&batch(&mut readers, count).map_err(|error| broken(&error))?, count)?;
        }
    }
    Ok(())
}

fn broken(error: &ParquetError) -> ContentError {
    let kind = ContentErrorKind::Unsupported { what: format!("this Parquet file ({error})") };
    ContentError::new(kind, ContentPlace::Whole).hint("write it without compression, or with LZ4 or Snappy")
}

fn head(file: &SerializedFileReader<Bytes>) -> Result<Head, ContentError> {
    let mut head = Head::default();
    for pair in file.metadata().file_metadata().key_value_metadata().into_iter().flatten() {
        let own = ["scenario", "step", "engine", "units", "columns"];
        if let (Some(key), Some(value)) = (pair.key.strip_prefix("polhode."), pair.value.as_deref())
            && own.contains(&key)
        {
            head.add(&pair.key, value, &ContentPlace::Within("the metadata".to_owned()))?;
        }
    }
    Ok(head)
}

fn header(file: &SerializedFileReader<Bytes>) -> Header {
    let mut header = Header { is_in_order: true, ..Header::default() };
    for (k, column) in file.metadata().file_metadata().schema_descr().columns().iter().enumerate() {
        header.names.push(column.path().parts().join("."));
        header.units.extend(unit(column).map(|unit| (k, unit)));
    }
    header
}

/// Returns the unit of a time, if the type of the column has one.
fn unit(column: &ColumnDescriptor) -> Option<&'static str> {
    match (column.logical_type_ref(), column.converted_type()) {
        (Some(LogicalType::Timestamp(time) | LogicalType::Time(time)), _) => Some(match time.unit {
            TimeUnit::MILLIS => "ms",
            TimeUnit::MICROS => "us",
            TimeUnit::NANOS => "ns",
        }),
        (_, ConvertedType::TIMESTAMP_MILLIS | ConvertedType::TIME_MILLIS) => Some("ms"),
        (_, ConvertedType::TIMESTAMP_MICROS | ConvertedType::TIME_MICROS) => Some("us"),
        _ => None,
    }
}

/// Refuses a column that does not have a number in each row.
fn numeric(column: &ColumnDescriptor, name: &str) -> Result<(), ContentError> {
    let unsupported = |what: String| {
        let kind = ContentErrorKind::Unsupported { what };
        Err(ContentError::new(kind, ContentPlace::Whole).hint("write a column of doubles for each number"))
    };
    let is_decimal = matches!(column.logical_type_ref(), Some(LogicalType::Decimal(_)))
        || column.converted_type() == ConvertedType::DECIMAL;
    match column.physical_type() {
        _ if column.max_rep_level() > 0 => unsupported(format!("the lists of the column {name}")),
        _ if is_decimal => unsupported(format!("the decimals of the column {name}")),
        Physical::DOUBLE | Physical::FLOAT | Physical::INT32 | Physical::INT64 => Ok(()),
        other => unsupported(format!("the column {name} of type {other}")),
    }
}

/// Numbers of a column, NaN if missing, and the index of the first missing number.
type Numbers = (Vec<f64>, Option<usize>);

/// Reads the next rows of each column. Two threads read half of the columns each.
fn batch(readers: &mut [(ColumnReader, i16)], count: usize) -> Result<Vec<Numbers>, ParquetError> {
    let next = |readers: &mut [(ColumnReader, i16)]| -> Result<Vec<Numbers>, ParquetError> {
        readers.iter_mut().map(|(reader, level)| numbers(reader, *level, count)).collect()
    };
    let (one, other) = readers.split_at_mut(readers.len() / 2);
    // The `parquet` crate panics if pages contradict their headers.
    let contradicts = |_| ParquetError::General("its pages contradict their headers".to_owned());
    thread::scope(|scope| {
        let halves = [scope.spawn(|| next(one)), scope.spawn(|| next(other))];
        let mut all = Vec::new();
        for half in halves.map(|half| half.join().map_err(contradicts)) {
            all.append(&mut half??);
        }
        Ok(all)
    })
}

fn numbers(reader: &mut ColumnReader, level: i16, count: usize) -> Result<Numbers, ParquetError> {
    match reader {
        ColumnReader::DoubleColumnReader(reader) => next(reader, level, count, |x| x),
        ColumnReader::FloatColumnReader(reader) => next(reader, level, count, f64::from),
        ColumnReader::Int32ColumnReader(reader) => next(reader, level, count, f64::from),
        ColumnReader::Int64ColumnReader(reader) => next(reader, level, count, |n| n as f64),
        _ => Err(ParquetError::General("a column that holds no numbers".to_owned())),
    }
}

fn next<T: DataType>(
    reader: &mut ColumnReaderImpl<T>,
    level: i16,
    count: usize,
    number: impl Fn(T::T) -> f64,
) -> Result<Numbers, ParquetError> {
    let (mut values, mut levels, mut found) = (Vec::with_capacity(count), Vec::new(), 0);
    while found < count {
        let levels = (level > 0).then_some(&mut levels);
        let (records, ..) = reader.read_records(count - found, levels, None, &mut values)?;
        if records == 0 {
            return Err(ParquetError::General(format!("a column ends after {found} of {count} rows")));
        }
        found += records;
    }
    let missing = levels.iter().position(|own| *own < level);
    let mut values = values.into_iter().map(number);
    let numbers = match missing {
        None => values.collect(),
        Some(_) => levels
            .iter()
            .map(|own| if *own < level { None } else { values.next() }.unwrap_or(f64::NAN))
            .collect(),
    };
    Ok((numbers, missing))
}

/// Adds the rows of a batch.
fn append(rows: &mut Rows, plan: &Plan, batch: &[Numbers], count: usize) -> Result<(), RowError> {
    let mut numbers = [0.0; MOST];
    for row in 0..count {
        let at = rows.times.len();
        let error = |problem| RowError { row: at, place: ContentPlace::Whole, problem };
        for (slot, (column, missing)) in batch.iter().enumerate() {
            numbers[slot] = column.get(row).copied().unwrap_or(f64::NAN);
            if *missing == Some(row) {
                return Err(error(Problem::NotNumber { slot, found: String::new() }));
            }
            if !numbers[slot].is_finite() {
                let found = numbers[slot].to_string();
                return Err(error(Problem::NotFinite { slot, found }));
            }
        }
        rows.push(plan, &numbers[..plan.slots.len()], 0..0).map_err(error)?;
    }
    Ok(())
}
