//! Logs of numbers in CSV or Parquet. Their columns are identified by name, or by the plan.

use bytes::Bytes;
use polhode_source::FormatError;
use polhode_source::csv;
use polhode_source::csv::{fields, missing};
use polhode_source::toml::reader::Value;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};
use polhode_table::log::{PARQUET, parquet};

use super::read_log::ReadLog;
use super::wrench_columns::{Columns, Header, Wrong};

/// Maximum number of columns: the time, and six vectors or five and a quaternion.
pub(crate) const MOST: usize = 20;

/// Row in SI units: its columns in the order in which they were identified, the time first.
pub(crate) type Row = [f64; MOST];

/// Reads the log that a value names: identifies the columns by the header, then passes each row
/// with its place to `row`.
pub(crate) fn read(
    log: &Value<'_>,
    find: impl Fn(&Header<'_>) -> Result<Columns, Wrong>,
    mut row: impl FnMut(&Row, ContentPlace) -> Result<(), ContentError>,
) -> Result<ReadLog, FormatError> {
    let path = log.path()?;
    let bytes = Bytes::from(csv::bytes(log, &path)?);
    let refused = |error: ContentError| {
        FormatError::of_content(&path, &bytes, error).named_in(log.source().path, log.place())
    };
    let mut last = f64::NEG_INFINITY;
    let mut add = |columns: &Columns, mut numbers: Row, place: ContentPlace| {
        numbers.iter_mut().zip(&columns.units).for_each(|(number, unit)| *number *= unit);
        if numbers[0] <= last {
            let (what, value) = ("time".to_owned(), numbers[0].to_string());
            let rule = "later than in the previous row".to_owned();
            return Err(ContentError::new(ContentErrorKind::Value { what, value, rule }, place));
        }
        last = numbers[0];
        row(&numbers, place)
    };
    let columns = if bytes.starts_with(PARQUET) {
        let names = parquet::names(&bytes).map_err(refused)?;
        let header = Header { names: names.iter().map(String::as_str).collect(), places: &[] };
        let columns = find(&header).map_err(|wrong| wrong.into_error(refused))?;
        let rows = parquet::table(&bytes, &columns.places).map_err(refused)?;
        for (k, given) in rows.iter().enumerate() {
            let mut numbers = [0.0; MOST];
            numbers.iter_mut().zip(given).for_each(|(slot, number)| *slot = *number);
            add(&columns, numbers, ContentPlace::Within(format!("row {}", k + 1))).map_err(refused)?;
        }
        columns
    } else {
        let text = csv::text(&bytes).map_err(refused)?;
        let mut lines = fields(text);
        let Some((_, places)) = lines.next() else {
            return Err(refused(missing("lines").hint("write a header, and one row for each time")));
        };
        let names = places.iter().map(|field| text[field.clone()].trim_matches('"').trim()).collect();
        let columns = find(&Header { names, places: &places }).map_err(|wrong| wrong.into_error(refused))?;
        for (line, fields) in lines {
            let numbers = csv::numbers::<MOST>(text, &line, &fields, places.len(), &columns.places);
            add(&columns, numbers.map_err(refused)?, ContentPlace::Text(line)).map_err(refused)?;
        }
        columns
    };
    Ok(ReadLog { path: path.clone(), read: columns.read, ignored: columns.ignored })
}
