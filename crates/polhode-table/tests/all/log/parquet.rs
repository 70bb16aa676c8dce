//! Parquet files as written by pandas and other programs.

use std::sync::Arc;

use parquet::basic::Compression;
use parquet::column::writer::ColumnWriter;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use polhode::infer::judge::QuaternionOrder;
use polhode_table::log as run_log;

use super::{attitudes, read};

/// Returns a file of these columns in two groups of rows. NaN in an optional column is left out.
fn file(schema: &str, pairs: &[(&str, &str)], columns: &[Vec<f64>], compression: Compression) -> Vec<u8> {
    let pairs =
        pairs.iter().map(|(key, value)| KeyValue::new((*key).to_owned(), (*value).to_owned())).collect();
    let properties =
        WriterProperties::builder().set_compression(compression).set_key_value_metadata(Some(pairs)).build();
    let mut bytes = Vec::new();
    let schema = Arc::new(parse_message_type(schema).unwrap());
    let mut file = SerializedFileWriter::new(&mut bytes, schema, Arc::new(properties)).unwrap();
    let rows = columns[0].len();
    for range in [0..rows / 3, rows / 3..rows] {
        let mut group = file.next_row_group().unwrap();
        for column in columns {
            let mut writer = group.next_column().unwrap().unwrap();
            let values = &column[range.clone()];
            let levels: Vec<i16> = values.iter().map(|value| i16::from(!value.is_nan())).collect();
            let there: Vec<f64> = values.iter().copied().filter(|value| !value.is_nan()).collect();
            match writer.untyped() {
                ColumnWriter::DoubleColumnWriter(writer) => {
                    writer.write_batch(&there, Some(&levels), None).map(drop)
                }
                ColumnWriter::FloatColumnWriter(writer) => {
                    let there: Vec<f32> = there.iter().map(|value| *value as f32).collect();
                    writer.write_batch(&there, Some(&levels), None).map(drop)
                }
                ColumnWriter::Int64ColumnWriter(writer) => {
                    let there: Vec<i64> = there.iter().map(|value| *value as i64).collect();
                    writer.write_batch(&there, Some(&levels), None).map(drop)
                }
                _ => panic!("no such column"),
            }
            .unwrap();
            writer.close().unwrap();
        }
        group.close().unwrap();
    }
    file.close().unwrap();
    bytes
}

const SCHEMA: &str = "message schema { optional int64 time_s (TIMESTAMP(MICROS,false)); optional float qx; optional float qy; \
                      required float qz; required double qw; required int64 frame; }";

fn columns(rows: usize) -> Vec<Vec<f64>> {
    let own = attitudes(rows);
    let component = |k: usize| own.iter().map(|a| a.quaternion()[k]).collect::<Vec<_>>();
    let times = (0..rows).map(|k| 1e9 + 250_000.0 * k as f64).collect();
    vec![times, component(1), component(2), component(3), component(0), vec![7.0; rows]]
}

#[test]
fn columns_of_any_kind_of_number_are_read() {
    let pairs = [
        ("polhode.scenario", "a.toml"),
        ("polhode.step", "0.002"),
        ("polhode.engine", "Bullet"),
        ("pandas", "{}"),
    ];
    for compression in [Compression::UNCOMPRESSED, Compression::SNAPPY, Compression::LZ4_RAW] {
        let log = read(file(SCHEMA, &pairs, &columns(9), compression));
        assert_eq!(log.log.times()[..3], [1000.0, 1000.25, 1000.5]);
        for (attitude, read) in attitudes(9).iter().zip(log.log.attitude()) {
            let [w, x, y, z] = attitude.quaternion();
            assert_eq!(*read, [f64::from(x as f32), f64::from(y as f32), f64::from(z as f32), w]);
        }
        assert_eq!(log.says.order, Some(QuaternionOrder::ScalarLast));
        assert_eq!(
            (log.scenario.unwrap().to_str(), log.step, log.engine.as_deref()),
            (Some("a.toml"), Some(0.002), Some("Bullet"))
        );
        assert_eq!((log.ignored, log.ignored_keys), (vec!["frame".to_owned()], vec![]));
        assert_eq!(log.read[0].what, "time, us");
    }
}

#[test]
fn mistakes_name_row_and_column() {
    let error = |change: &dyn Fn(&mut Vec<Vec<f64>>)| {
        let mut columns = columns(9);
        change(&mut columns);
        run_log::from_bytes(&file(SCHEMA, &[], &columns, Compression::SNAPPY), None).unwrap_err().to_string()
    };
    assert_eq!(error(&|c| c[2][6] = f64::NAN), "expected a number as qy of row 7, found \"nothing\"");
    assert_eq!(error(&|c| c[4][7] = f64::INFINITY), "qw of row 8 = inf must be finite");
    assert_eq!(
        error(&|c| c[0][3] = 1e9),
        "the time of row 4 = 1000 s must be later than 1000.5 s, that of the row before"
    );
    let text = "message schema { required double t; required double qw; required double qx; required double qy; \
                required double qz; }";
    let own = columns(9);
    let seconds = vec![
        own[0].iter().map(|t| t * 1e-6).collect(),
        own[4].clone(),
        own[1].clone(),
        own[2].clone(),
        own[3].clone(),
    ];
    let whole = file(text, &[], &seconds, Compression::LZ4_RAW);
    assert_eq!(read(&whole).log.attitude()[5], attitudes(9)[5].quaternion());
    let list = "message schema { required double t; repeated double qw; required double qx; required double qy; \
                required double qz; }";
    let listed = std::panic::catch_unwind(|| file(list, &[], &seconds, Compression::SNAPPY));
    if let Ok(bytes) = listed {
        assert!(
            run_log::from_bytes(&bytes, None).unwrap_err().to_string().contains("lists of the column qw")
        );
    }
}
