//! Plans of payloads and their logs: units, columns, mistakes with their places.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use polhode::math::{Acceleration, Attitude, Direction};
use polhode_identify::payload::{PayloadRow, gravity_along};
use polhode_identify::read::{Measurement, PayloadPlan, read};
use polhode_source::FormatError;
use polhode_source::files::Disk;

/// Temporary folder, deleted at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("polhode-identify-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn read(&self, log: impl AsRef<[u8]>, keys: &str) -> Result<PayloadPlan, FormatError> {
        fs::write(self.0.join("log.csv"), log).unwrap();
        let plan = self.0.join("plan.toml");
        fs::write(&plan, format!("[payload]\nlog = 'log.csv'\n{keys}")).unwrap();
        match read(&Disk, &plan)?.measurement {
            Measurement::Payload(plan) => Ok(plan),
            other => panic!("{other:?}"),
        }
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

const HEAD: &str = "time_s,wx_rad_s,wy_rad_s,wz_rad_s,alphax_rad_s2,alphay_rad_s2,alphaz_rad_s2,ax_m_s2,ay_m_s2,az_m_s2,\
                    fx_n,fy_n,fz_n,tx_n_m,ty_n_m,tz_n_m,gx_m_s2,gy_m_s2,gz_m_s2\n";
const SIDE: &str = "wrench = 'on sensor'\n";

/// Returns rows in which all numbers differ.
fn rows() -> String {
    let mut text = String::new();
    for row in 0..3 {
        let numbers = (0..19).map(|k| match k {
            0 => format!("{}", 0.5 * f64::from(row)),
            _ => format!("{}", f64::from(k) + 0.25 * f64::from(row)),
        });
        writeln!(text, "{}", numbers.collect::<Vec<_>>().join(",")).unwrap();
    }
    text
}

fn numbers(row: &PayloadRow) -> Vec<f64> {
    [
        row.omega.to_array(),
        row.alpha.to_array(),
        row.acceleration.to_array(),
        row.force.to_array(),
        row.torque.to_array(),
        row.gravity.to_array(),
    ]
    .concat()
}

#[test]
fn columns_are_found_by_their_names() {
    let folder = Folder::new("names");
    let plan = folder.read(HEAD.to_owned() + &rows(), SIDE).unwrap();
    let last = &plan.log.rows()[2];
    assert_eq!((plan.log.rows().len(), last.time), (3, 1.0));
    assert_eq!(numbers(last), (1..19).map(|k| f64::from(k) + 0.5).collect::<Vec<f64>>());
    assert!(plan.source.ignored.is_empty());
    assert_eq!(plan.source.read[1], "angular velocity: wx_rad_s, wy_rad_s, wz_rad_s");

    // Other order, names and units, and additional columns.
    let other = "Tz [mN m],note,t [ms],T [degC],force_x_N,force_y_N,force_z_N,Tx [N m],Ty [N m],omega_x_deg_s,\
                 omega_y_deg_s,gyro_z (rad/s),fx_raw,angular_acceleration_x_rad_s2,alpha_y_rad_s2,alpha_z_rad_s2,\
                 acc_x [g0],acc_y_m_s2,acc_z_m_s2,gravity_x_m_s2,gravity_y_m_s2,gravity_z_m_s2\n\
                 1500,a,250,21,10,11,12,13,14,180,90,3,7,4,5,6,2,8,9,16,17,18\n";
    let plan = folder.read(other, SIDE).unwrap();
    let row = &plan.log.rows()[0];
    let half = std::f64::consts::FRAC_PI_2;
    assert_eq!(row.time, 0.25);
    let expected: Vec<f64> = [2.0 * half, half].into_iter().chain((3..19).map(f64::from)).collect();
    for (k, (got, want)) in numbers(row).iter().zip(expected).enumerate() {
        let want = match k {
            6 => 2.0 * 9.806_65,
            14 => 1.5,
            _ => want,
        };
        assert!((got - want).abs() < 1e-14, "{k}: {got} is not {want}");
    }
    assert_eq!(plan.source.ignored, ["note", "T [degC]", "fx_raw"]);
}

#[test]
fn columns_and_units_may_be_told() {
    let folder = Folder::new("told");
    let log = "stamp,p,q,r,pd,qd,rd,u,v,w,X,Y,Z,K,M,N,g1,g2,g3\n".to_owned() + &rows();
    let columns = "columns = { time = 'stamp', omega = ['p', 'q', 'r'], alpha = ['pd', 'qd', 'rd'], acceleration = \
                   ['u', 'v', 'w'], force = ['X', 'Y', 'Z'], torque = ['K', 'M', 'N'], gravity = ['g1', 'g2', 'g3'] }\n";
    let units = "units = { time = 'ms', omega = 'deg/s', alpha = 'rad/s^2', acceleration = 'm/s^2', force = 'kN', \
                 torque = 'N m', gravity = 'm/s^2' }\n";
    let plan = folder.read(&log, &format!("{SIDE}{columns}{units}")).unwrap();
    let row = &plan.log.rows()[1];
    assert!((row.time - 0.000_5).abs() < 1e-18);
    assert!((row.omega.y - 2.25_f64.to_radians()).abs() < 1e-15);
    assert_eq!((row.force.z, row.torque.x, row.gravity.z), (12_250.0, 13.25, 18.25));
    // Without units there is an error; they are not guessed.
    let error = folder.read(&log, &format!("{SIDE}{columns}")).unwrap_err();
    assert!(error.to_string().contains("log.csv:1:1: in which unit is stamp?"), "{error}");
}

#[test]
fn gravity_is_turned_to_the_sensor() {
    let folder = Folder::new("gravity");
    let attitude = Attitude::from_axis_angle(Direction::new(0.3, -0.5, 0.8), 0.9).unwrap();
    let [w, x, y, z] = attitude.quaternion();
    let head = HEAD.replace("gx_m_s2,gy_m_s2,gz_m_s2", "qw,qx,qy,qz");
    let told = Acceleration::new(0.1, -0.2, -9.7);
    let numbers = "0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15";
    for (sense, sign) in [("body-to-space", 1.0), ("space-to-body", -1.0)] {
        let log =
            format!("{head}{numbers},{},{},{},{}\n", 2.0 * w, sign * 2.0 * x, sign * 2.0 * y, sign * 2.0 * z);
        let keys = format!("{SIDE}gravity = [0.1, -0.2, -9.7]\nattitude = '{sense}'\n");
        let got = folder.read(log, &keys).unwrap().log.rows()[0].gravity;
        let want = gravity_along(attitude, told);
        assert!(
            (got - want).norm() < 1e-14 && (got.x - told.x).abs() > 1.0,
            "{sense}: {got:?} is not {want:?}"
        );
    }
    // Without gravity no attitude is needed.
    let log = format!("{head}{numbers},1,0,0,0\n");
    let plan = folder.read(log, &format!("{SIDE}gravity = [0, 0, 0]\n")).unwrap();
    assert_eq!(plan.log.rows()[0].gravity, Acceleration::ZERO);
    assert_eq!(plan.source.ignored, ["qw", "qx", "qy", "qz"]);
}

#[test]
fn mistakes_of_plans_have_their_place() {
    let folder = Folder::new("plans");
    let log = HEAD.to_owned() + &rows();
    for (keys, place, message, hint) in [
        ("", [1, 1], "the key wrench is missing", "\"on sensor\" if the force at rest points down"),
        ("wrench = 'on tool'\n", [3, 10], "one of on payload, on sensor", ""),
        ("wrench = 'on sensor'\nbiases = true\n", [4, 1], "unknown key \"biases\"", "did you mean bias?"),
        ("wrench = 'on sensor'\nkind = 'sheet'\n", [4, 8], "one of plate, rod", ""),
        (
            "wrench = 'on sensor'\nnoise = { force = '0.1 N' }\n",
            [4, 9],
            "the key torque is missing",
            "2e-3 N m",
        ),
        (
            "wrench = 'on sensor'\nnoise = { force = '-1 N', torque = '1 N m' }\n",
            [4, 19],
            "must be positive",
            "standard deviation",
        ),
        (
            "wrench = 'on sensor'\nnoise = { force = '1 kg', torque = '1 N m' }\n",
            [4, 19],
            "\"kg\" is a mass where a force belongs",
            "lb, oz and kg are units",
        ),
        ("wrench = 'on sensor'\nmotion_noise = { alpha = '-1 rad/s^2' }\n", [4, 26], "zero or positive", ""),
        (
            "wrench = 'on sensor'\nmotion_noise = { alpha = 0 }\n",
            [4, 16],
            "above zero",
            "remove motion_noise",
        ),
        (
            "wrench = 'on sensor'\nnoise = { force = '1 N', covariance = [] }\n",
            [4, 39],
            "the standard deviations of force and torque, or a covariance",
            "",
        ),
        ("wrench = 'on sensor'\nnoise = { covariance = [1, 2] }\n", [4, 24], "an array of 6", ""),
        (
            "wrench = 'on sensor'\ngravity = [0, 0, 0]\nunits = { gravity = 'm/s^2' }\n",
            [5, 21],
            "omitted if the plan states gravity",
            "",
        ),
        (
            "wrench = 'on sensor'\ncolumns = { force = ['fx_n', 'fy', 'fz_n'] }\n",
            [4, 30],
            "a column of the log",
            "the columns are time_s, wx_rad_s",
        ),
        (
            "wrench = 'on sensor'\ncolumns = { force = ['fx_n', 'fx_n', 'fz_n'] }\n",
            [4, 30],
            "a different column for each axis",
            "",
        ),
        ("wrench = 'on sensor'\ncolumns = { force = ['fx_n', 'fy_n'] }\n", [4, 21], "an array of 3", ""),
        ("wrench = 'on sensor'\ncolumns = { forces = 1 }\n", [4, 13], "unknown key \"forces\"", "force"),
        ("wrench = 'on sensor'\nunits = { force = 'kN' }\n", [4, 19], "in the name of the column fx_n", ""),
        ("wrench = 'on sensor'\nunits = { force = 'kg' }\n", [4, 19], "a unit: ", "such as N"),
        ("wrench = 'on sensor'\ngravity = [0, 0, -9.81]\n", [1, 1], "the key attitude is missing", ""),
        (
            "wrench = 'on sensor'\ngravity = [0, 0, -9.81]\nattitude = 'body-to-space'\n",
            [4, 11],
            "the log has none",
            "qw, qx, qy, qz",
        ),
        (
            "wrench = 'on sensor'\nattitude = 'body-to-space'\n",
            [4, 12],
            "used together with gravity",
            "gravity = ",
        ),
        (
            "wrench = 'on sensor'\ngravity = [0, 0, 0]\nattitude = 'body-to-space'\n",
            [5, 12],
            "omitted if gravity is zero",
            "",
        ),
        ("wrench = 'on sensor'\n[tumble]\nlog = 'log.csv'\n", [4, 1], "a plan has one kind", ""),
    ] {
        let error = folder.read(&log, keys).expect_err(keys);
        let at = error.place().unwrap();
        assert!(error.path().ends_with("plan.toml"), "{error}");
        assert_eq!([at.line, at.column], place, "{keys}: {error}");
        assert!(error.message().contains(message), "{keys}: {error}");
        assert!(error.hint().unwrap_or_default().contains(hint), "{keys}: {:?}", error.hint());
    }
}

#[test]
fn mistakes_of_logs_have_their_place() {
    let folder = Folder::new("logs");
    let rows = rows();
    let last = |text: &str| format!("{HEAD}{rows}{text}\n");
    let tail = ",1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18";
    for (log, place, message, hint) in [
        (String::new(), None, "lines", "write a header"),
        (HEAD.replace("fz_n,", "") + "0\n", None, "column of force along z", "fx_n,fy_n,fz_n"),
        (HEAD.replace("gx_m_s2,", "") + "0\n", None, "column of gravity along x", "gravity ="),
        (HEAD.replace("fz_n,", "fz,") + &rows, Some([1, 111]), "in which unit is fz?", "units = { force"),
        (
            HEAD.replace("fz_n,", "fz_kg,") + &rows,
            Some([1, 111]),
            "the unit of force = kg must be another",
            "N",
        ),
        (
            HEAD.replace("fz_n,", "fz [lb],") + &rows,
            Some([1, 111]),
            "the unit of force = lb must be another",
            "",
        ),
        (
            HEAD.replace("gz_m_s2", "gz_m_s2,force_z [N]") + &rows,
            Some([1, 161]),
            "the only column of force",
            "",
        ),
        (last("7,1,2"), Some([5, 1]), "19 fields long", ""),
        (last(&format!("7{}", tail.replace(",9,", ",nine,"))), Some([5, 19]), "a number", ""),
        (last(&format!("7{}", tail.replace(",9,", ",inf,"))), Some([5, 19]), "not finite", ""),
        (last(&format!("1.0{tail}")), Some([5, 1]), "later than in the previous row", ""),
        ("PAR1 and no more".to_owned(), None, "this Parquet file", "without compression"),
    ] {
        let error = folder.read(&log, SIDE).expect_err(&log);
        assert!(error.path().ends_with("log.csv"), "{error}");
        assert_eq!(error.place().map(|at| [at.line, at.column]), place, "{log}: {error}");
        assert!(error.message().contains(message), "{log}: {error}");
        assert!(error.hint().unwrap_or_default().contains(hint), "{log}: {:?}", error.hint());
        let (plan, at) = error.origin().unwrap();
        assert!(plan.ends_with("plan.toml") && [at.line, at.column] == [2, 7], "{error}");
    }
    // A zero quaternion.
    let head = HEAD.replace("gx_m_s2,gy_m_s2,gz_m_s2", "qw,qx,qy,qz");
    let keys = format!("{SIDE}gravity = [0, 0, -9.81]\nattitude = 'body-to-space'\n");
    let log = format!("{head}0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,0,0,0,0\n");
    let error = folder.read(log, &keys).unwrap_err();
    assert!(error.to_string().contains("log.csv:2:1") && error.to_string().contains("not zero"), "{error}");
}

/// Returns the numbers of a CSV as a Parquet file with one column of doubles each.
fn parquet_of(csv: &str) -> Vec<u8> {
    use parquet::data_type::DoubleType;
    use parquet::file::properties::WriterProperties;
    use parquet::file::writer::SerializedFileWriter;
    use parquet::schema::parser::parse_message_type;
    let mut lines = csv.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    let columns: String = names.iter().map(|name| format!("required double {name};")).collect();
    let schema = std::sync::Arc::new(parse_message_type(&format!("message log {{ {columns} }}")).unwrap());
    let mut bytes = Vec::new();
    let mut file =
        SerializedFileWriter::new(&mut bytes, schema, std::sync::Arc::new(WriterProperties::default()))
            .unwrap();
    let mut group = file.next_row_group().unwrap();
    for k in 0..names.len() {
        let mut column = group.next_column().unwrap().unwrap();
        let values: Vec<f64> = rows.iter().map(|row| row[k]).collect();
        column.typed::<DoubleType>().write_batch(&values, None, None).unwrap();
        column.close().unwrap();
    }
    group.close().unwrap();
    file.close().unwrap();
    bytes
}

#[test]
fn parquet_is_read_as_csv_is() {
    let folder = Folder::new("parquet");
    let log = HEAD.to_owned() + &rows();
    let (by_csv, by_parquet) =
        (folder.read(&log, SIDE).unwrap(), folder.read(parquet_of(&log), SIDE).unwrap());
    assert_eq!(by_csv.log, by_parquet.log);
    assert_eq!(by_csv.source.read, by_parquet.source.read);
    // A value that is NaN is reported with its row and column.
    let broken = log.replace("\n0.5,", "\nNaN,");
    let error = folder.read(parquet_of(&broken), SIDE).unwrap_err();
    assert!(error.to_string().contains("time_s of row 2"), "{error}");
    let late = log.replace("\n0.5,", "\n-1,");
    let error = folder.read(parquet_of(&late), SIDE).unwrap_err();
    assert!(error.to_string().contains("row 2") && error.message().contains("previous row"), "{error}");
    let other = parquet_of(&log.replace("fz_n", "fz"));
    let error = folder.read(other, SIDE).unwrap_err();
    assert!(error.message().contains("in which unit is fz?"), "{error}");
}

#[test]
fn a_covariance_of_the_wrench_may_be_told() {
    let folder = Folder::new("covariance");
    let log = HEAD.to_owned() + &rows();
    let row = |k: usize| {
        let numbers = (0..6).map(|j| {
            if j == k {
                "2.5e-3"
            } else if j + k == 1 {
                "1e-4"
            } else {
                "0"
            }
        });
        format!("[{}]", numbers.collect::<Vec<_>>().join(", "))
    };
    let rows: Vec<String> = (0..6).map(row).collect();
    let told = |rows: &str| folder.read(&log, &format!("{SIDE}noise = {{ covariance = [{rows}] }}\n"));
    let plan = told(&rows.join(", ")).unwrap();
    assert_ne!(plan.log, folder.read(&log, SIDE).unwrap().log);
    let error = told(&rows.join(", ").replacen("1e-4", "2e-4", 1)).unwrap_err();
    assert!(error.message().contains("the other side of the diagonal"), "{error}");
}

/// Reads a plan with a gyro log and attitudes of arbitrary motion.
fn tumble(name: &str, plan: &str) -> Result<polhode_identify::read::TumblePlan, FormatError> {
    let folder = Folder::new(name);
    let mut gyro = String::from("time_s,gyro_x,gyro_y,gyro_z\n");
    let mut tracked = String::from("time_s,qw,qx,qy,qz\n");
    for k in 0..40 {
        let t = 0.01 * f64::from(k);
        writeln!(gyro, "{t},{},{},{}", 5.0 + t, 3.0 - t, 0.1 + 2.0 * t).unwrap();
        writeln!(tracked, "{t},{},{},0,0", t.cos(), t.sin()).unwrap();
    }
    fs::write(folder.0.join("gyro.csv"), &gyro).unwrap();
    fs::write(folder.0.join("broken.csv"), gyro.replacen("5.03", "NaN", 1)).unwrap();
    fs::write(folder.0.join("tracked.csv"), tracked).unwrap();
    let path = folder.0.join("plan.toml");
    fs::write(&path, format!("[tumble]\n{plan}")).unwrap();
    match read(&Disk, &path)?.measurement {
        Measurement::Tumble(plan) => Ok(plan),
        other => panic!("{other:?}"),
    }
}

const TRACKED: &str = "log = 'tracked.csv'\ncolumns = 'quaternion wxyz body-to-space = qw qx qy qz'\n";

#[test]
fn what_has_no_effect_on_tumbles_is_refused() {
    let flight = |keys: &str| format!("\n[[tumble.flight]]\n{keys}\n");
    let gyro = "log = 'gyro.csv'\n";
    for (k, (plan, place, says)) in [
        (
            format!("{TRACKED}attitude = {{ noise = '1 deg' }}\ngyro = {{ bias = true }}\n"),
            [5, 8],
            "only attitudes",
        ),
        (format!("{gyro}attitude = {{ noise = '1 deg' }}\n"), [3, 12], "only rates of a gyro"),
        (format!("{gyro}gyro = {{ clock = true }}\n"), [3, 18], "no flight has both"),
        (format!("{gyro}search = {{ slowest = '1 rad/s' }}\n"), [3, 10], "used with flights"),
        (format!("{gyro}{}", flight("log = 'gyro.csv'")), [2, 7], "omitted if each flight has its own"),
        (
            format!(
                "{gyro}columns = 'omega = gyro_x gyro_y gyro_z'\n{}",
                flight("columns = 'time = time_s'")
            ),
            [3, 11],
            "omitted if each flight has its own",
        ),
        (format!("{gyro}{}", flight("added = { moments = [0, 0, 0] }")), [5, 9], "not zero"),
        (
            format!("{gyro}{}", flight("wheel = { axis = [0, 0, 1], momentum = 0 }")),
            [5, 40],
            "different from zero",
        ),
        (format!("{gyro}{}{}", flight("to = 0.2"), flight("from = 0.1")), [8, 8], "used once"),
        ("log = ['gyro.csv', 'gyro.csv']\n".to_owned(), [2, 20], "used once"),
        (format!("{gyro}gyro = {{ range = '-1 rad/s' }}\n"), [3, 18], "positive"),
    ]
    .into_iter()
    .enumerate()
    {
        let error = tumble(&format!("effect-{k}"), &plan).expect_err(&plan);
        assert_eq!(error.place().map(|at| [at.line, at.column]), Some(place), "{plan}: {error}");
        assert!(error.message().contains(says), "{plan}: {error}");
    }
    // All entries have an effect in the right plan.
    let plan =
        format!("{gyro}gyro = {{ range = '2000 deg/s' }}\n{}{}", flight("to = 0.2"), flight("from = 0.2"));
    let read = tumble("effect", &plan).unwrap();
    assert_eq!(read.flights.len(), 2);
    assert!(read.options.gyro_range.is_some_and(|range| (range.high[1] - 34.906_585).abs() < 1e-6));
    assert!(tumble("tracked", &format!("{TRACKED}attitude = {{ noise = '1 deg' }}\n")).is_ok());
}

#[test]
fn what_is_no_number_in_a_gyro_log_has_its_row_and_column() {
    let error = tumble("nan", "log = 'broken.csv'\n").unwrap_err();
    let text = error.to_string();
    assert!(text.contains("broken.csv:5:6") && text.contains("gyro_x") && text.contains("NaN"), "{text}");
}
