//! Torque tables in scenario files: CSV and Parquet, units, errors.

use std::fs;
use std::path::PathBuf;

use polhode::prelude::*;
use polhode_scenario::read as scenario;
use polhode_source::FormatError;

const BODY: &str = "[[body.part]]\nshape = 'box'\nsize = ['0.3 m', '0.2 m', '0.1 m']\nmass = '4 kg'\n\
                    [run]\nduration = '4 s'\nsamples = 5\n";

/// Temporary folder, removed when dropped.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("polhode-torque-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn read(&self, table: impl AsRef<[u8]>, keys: &str) -> Result<Scenario, FormatError> {
        fs::write(self.0.join("torque.csv"), table).unwrap();
        let torque = format!("[[torque]]\nmodel = 'table'\ntable = 'torque.csv'\n{keys}");
        scenario::parse(&format!("{BODY}{torque}"), &self.0.join("scenario.toml"))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn torque(scenario: &Scenario, time: f64) -> [f64; 3] {
    let state = State { time, ..scenario.start() };
    scenario.torques()[0].torque(scenario.rotor(), &state).to_array()
}

const LINEAR: &str = "axes = 'body'\ninterpolation = 'linear'\n";

#[test]
fn columns_stand_in_any_order_and_unit() {
    let folder = Folder::new("units");
    let si = "time_s,torque_x_n_m,torque_y_n_m,torque_z_n_m\n0,0.1,-0.2,0.3\n2,0.3,0.2,-0.1\n5,0,0,0\n";
    let other = "# of a test stand\n\"torque_z [mN m]\",note,time (ms),torque_x_mN_m,torque_y [N m]\n\
                 300,a,0,100,-0.2\n\n-100,b,2000,300,0.2\n0,c,5000,0,0\n";
    for table in [si, other] {
        let scenario = folder.read(table, LINEAR).unwrap();
        let [x, y, z] = torque(&scenario, 1.0);
        assert!((x - 0.2).abs() < 1e-16 && y.abs() < 1e-16 && (z - 0.1).abs() < 1e-16, "{x} {y} {z}");
    }
    let doubled = folder.read(si, &format!("{LINEAR}scale = 2\n")).unwrap();
    assert_eq!(torque(&doubled, 0.0), [0.2, -0.4, 0.6]);
    let steps = folder.read(si, "axes = 'space'\ninterpolation = 'steps'\n").unwrap();
    assert_eq!(torque(&steps, 1.99), [0.1, -0.2, 0.3]);
}

#[test]
fn a_table_lasts_as_long_as_it_acts() {
    let folder = Folder::new("span");
    let short = "time_s,torque_x_n_m,torque_y_n_m,torque_z_n_m\n0.5,1,0,0\n3,1,0,0\n";
    let error = folder.read(short, LINEAR).unwrap_err();
    assert!(
        error.message().contains("defined while the torque acts, from 0 to 4 s; it covers 0.5 to 3 s"),
        "{error}"
    );
    assert!(error.place().is_some());
    // The hint gives a valid file, as the next line shows.
    assert!(error.hint().unwrap().ends_with(r#"from = "0.5 s", until = "3 s""#), "{:?}", error.hint());
    assert!(folder.read(short, &format!("{LINEAR}from = '0.5 s'\nuntil = '3 s'\n")).is_ok());
    let late = short.replace("0.5,", "30,").replace("\n3,", "\n40,");
    assert!(folder.read(&late, LINEAR).unwrap_err().hint().unwrap().ends_with("none is within the run"));
    assert!(folder.read(short, &format!("{LINEAR}from = '0.5 s'\n")).is_err());
    let pulses = "pulses = { first = '1 s', width = '0.1 s', period = '1 s', count = 2 }\n";
    assert!(folder.read(short, &format!("{LINEAR}{pulses}")).is_err());
}

#[test]
fn mistakes_have_their_place() {
    let folder = Folder::new("mistakes");
    let head = "time_s,torque_x_n_m,torque_y_n_m,torque_z_n_m\n";
    for (table, message) in [
        (String::new(), "lines"),
        ("time_s,torque_x_n_m,torque_y_n_m\n0,1,2\n".to_owned(), "column torque_z"),
        ("time,torque_x_n_m,torque_y_n_m,torque_z_n_m\n0,1,2,3\n".to_owned(), "in which unit is time?"),
        ("time_kg,torque_x_n_m,torque_y_n_m,torque_z_n_m\n0,1,2,3\n".to_owned(), "a unit that polhode knows"),
        ("time_s,time_s,torque_x_n_m,torque_y_n_m,torque_z_n_m\n0,0,1,2,3\n".to_owned(), "named once"),
        (format!("{head}0,1,2\n"), "4 fields long"),
        (format!("{head}0,1,2,nan\n"), "nan"),
        (format!("{head}0,1,x,3\n"), "a number"),
        (format!("{head}0,1,2,3\n0,1,2,3\n"), "after the time of the previous row"),
        (format!("{head}0,1,2,3\n"), "at least 2"),
        ("PAR1 and no more".to_owned(), "this Parquet file"),
    ] {
        let error = folder.read(&table, LINEAR).expect_err(&table);
        assert!(error.to_string().contains(message), "{table:?}: {error}");
    }
    assert!(folder.read(head, "axes = 'body'\n").unwrap_err().to_string().contains("interpolation"));
}

#[cfg(feature = "parquet")]
#[test]
fn parquet_is_read_as_text_is() {
    use parquet::basic::Compression;
    use parquet::column::writer::ColumnWriter;
    use parquet::file::properties::WriterProperties;
    use parquet::file::writer::SerializedFileWriter;
    use parquet::schema::parser::parse_message_type;
    use std::sync::Arc;

    let folder = Folder::new("parquet");
    let schema = "message rows { required double time_s; required group nested { required double a; required double b; } \
                  required int64 count; required double torque_x_n_m; \
                  required double torque_y_n_m; required float torque_z_n_m; }";
    for compression in [Compression::UNCOMPRESSED, Compression::SNAPPY, Compression::LZ4_RAW] {
        let properties = WriterProperties::builder().set_compression(compression).build();
        let mut bytes = Vec::new();
        let schema = Arc::new(parse_message_type(schema).unwrap());
        let mut file = SerializedFileWriter::new(&mut bytes, schema, Arc::new(properties)).unwrap();
        let mut group = file.next_row_group().unwrap();
        let columns = [
            [0.0, 2.0, 5.0],
            [7.0, 8.0, 9.0],
            [6.0, 5.0, 4.0],
            [1.0, 2.0, 3.0],
            [0.1, 0.3, 0.0],
            [-0.2, 0.2, 0.0],
            [0.5, -0.25, 0.0],
        ];
        for column in columns {
            let mut writer = group.next_column().unwrap().unwrap();
            match writer.untyped() {
                ColumnWriter::DoubleColumnWriter(w) => w.write_batch(&column, None, None),
                ColumnWriter::FloatColumnWriter(w) => {
                    w.write_batch(&column.map(|x: f64| x as f32), None, None)
                }
                ColumnWriter::Int64ColumnWriter(w) => {
                    w.write_batch(&column.map(|x: f64| x as i64), None, None)
                }
                _ => panic!("a column of another type"),
            }
            .unwrap();
            writer.close().unwrap();
        }
        group.close().unwrap();
        file.close().unwrap();
        let scenario = folder.read(&bytes, LINEAR).unwrap();
        let [x, y, z] = torque(&scenario, 1.0);
        assert!((x - 0.2).abs() < 1e-16 && y.abs() < 1e-16 && (z - 0.125).abs() < 1e-16, "{x} {y} {z}");
    }
}
