//! Trajectory table: its columns, and the bit-for-bit output of every format.

use std::fs::File;
use std::io;
use std::path::Path;

use parquet::basic::{Compression, Encoding, Repetition};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;
use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{AngularMomentum, AngularVelocity, Attitude, Direction, Position, Rotation};
use polhode::motion::torque::{TorqueModel, UniformGravity};
use polhode::motion::{ErrorEffort, Method, Motor, Rotor, Simulation, State, Trajectory, Wheel};
use polhode_table::output::{Surroundings, Table};

/// Returns a wheel whose speed is held, and a wheel that a motor turns.
fn wheels() -> [Wheel; 2] {
    let motor = Motor::Torque { inertia: 0.31, torque: -0.42, schedule: None };
    let held = Wheel::new(Direction::new(0.3, 0.5, -0.8), 1.7, Motor::HeldSpeed).unwrap();
    [held, Wheel::new(Direction::new(-0.6, 0.2, 0.7), 0.9, motor).unwrap()]
}

/// Returns motions of a generic body: in free fall, swinging from a pivot, and with wheels.
fn trajectories() -> [(Trajectory, Surroundings); 3] {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let body = MassProperties::new(2.0, Position::new(0.1, -0.2, 0.5), inertia).unwrap();
    let attitude: Attitude = Rotation::from_axis_angle(Direction::new(0.2, -0.3, 0.9), 2.1).unwrap();
    let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.3, -2.5, 0.9) };
    let times: Vec<f64> = (0..200).map(|k| f64::from(k) * 0.05).collect();
    let gravity = TorqueModel::Gravity(UniformGravity::STANDARD);
    let compute = |rotor: Rotor, torques: &[TorqueModel], wheels: &[Wheel]| {
        let rotor = rotor.with_wheels(wheels).unwrap();
        let motion = Trajectory::compute(&rotor, torques, start, &times, Method::Auto, 1e-12).unwrap();
        (motion, Surroundings { wheels: wheels.to_vec(), ..Surroundings::default() })
    };
    [
        compute(Rotor::free(&body), &[], &[]),
        compute(Rotor::pivoted(&body, Position::ZERO), &[gravity], &[]),
        compute(Rotor::free(&body), &[], &wheels()),
    ]
}

/// Returns the bits of every number, row by row.
fn bits(trajectory: &Trajectory, surroundings: &Surroundings) -> Vec<Vec<u64>> {
    let table = Table::of(trajectory, surroundings);
    (0..table.rows()).map(|row| table.columns().iter().map(|c| c.value(row).to_bits()).collect()).collect()
}

#[test]
fn the_columns_have_the_agreed_names_in_the_agreed_order() {
    let [free, swinging, wheeled] = trajectories();
    let names = |(motion, surroundings): &(Trajectory, Surroundings)| {
        let table = Table::of(motion, surroundings);
        table.columns().iter().map(|c| c.name.to_string()).collect::<Vec<_>>().join(",")
    };
    let agreed = "time_s,attitude_w,attitude_x,attitude_y,attitude_z,\
        omega_body_x_rad_s,omega_body_y_rad_s,omega_body_z_rad_s,\
        omega_space_x_rad_s,omega_space_y_rad_s,omega_space_z_rad_s,\
        momentum_space_x_kg_m2_s,momentum_space_y_kg_m2_s,momentum_space_z_kg_m2_s,\
        torque_body_x_n_m,torque_body_y_n_m,torque_body_z_n_m,kinetic_energy_j";
    assert_eq!(names(&free), agreed);
    assert_eq!(names(&swinging), format!("{agreed},potential_energy_j"));
    let spinning = "wheel_1_momentum_kg_m2_s,wheel_2_momentum_kg_m2_s,wheel_2_speed_rad_s";
    assert_eq!(names(&wheeled), format!("{agreed},{spinning}"));
}

#[test]
fn estimated_errors_are_columns_of_their_own() {
    let inertia = InertiaTensor::diagonal([1.3, 2.1, 2.9]).unwrap();
    let rotor = Rotor::free(&MassProperties::new(1.7, Position::ZERO, inertia).unwrap());
    let omega = AngularVelocity::new(0.4, 1.1, -0.7);
    let start = State { time: 0.0, attitude: Attitude::identity(), omega };
    let simulation =
        Simulation::new(&rotor, &[], start, &[0.0, 5.0, 9.0]).method(Method::Taylor).tolerance(1e-9);
    let motion = simulation.run_with_error(ErrorEffort::Cheap, &mut |_| true).unwrap();
    let table = Table::of(&motion, &Surroundings::default());
    let [.., attitude, omega] = table.columns() else { unreachable!() };
    assert_eq!([&*attitude.name, &*omega.name], ["attitude_error_rad", "omega_error"]);
    for (row, error) in motion.error().unwrap().computation().iter().enumerate() {
        assert_eq!([attitude.value(row), omega.value(row)], [error.attitude, error.omega]);
    }
    assert!(attitude.value(2) > attitude.value(0));
}

/// L = R (I ω + Σ h a) is constant in space, and the momentum of a wheel is J (a·ω + Ω).
#[test]
fn the_columns_of_wheels_balance_those_of_the_body() {
    let [_, _, (motion, surroundings)] = trajectories();
    let wheels = &surroundings.wheels;
    let [held, turned] = wheels[..] else { unreachable!() };
    let table = Table::of(&motion, &surroundings);
    let [of_held, of_turned, speed] = &table.columns()[18..] else { unreachable!() };
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let body = MassProperties::new(2.0, Position::new(0.1, -0.2, 0.5), inertia).unwrap();
    let carrier = Rotor::free(&body).with_wheels(wheels).unwrap();
    for (row, sample) in motion.samples().iter().enumerate() {
        let along = |wheel: &Wheel, h: f64| AngularMomentum::from_array(wheel.axis().to_array()) * h;
        let h = along(&held, of_held.value(row)) + along(&turned, of_turned.value(row));
        let total = sample.state.attitude * (carrier.angular_momentum(sample.state.omega) + h);
        assert!((total - motion.start().momentum).norm() < 1e-12);
        let relative = 0.31 * (turned.axis().dot(sample.state.omega) + speed.value(row));
        assert!((relative - of_turned.value(row)).abs() < 1e-14);
    }
    assert!((of_turned.value(100) - (0.9 - 0.42 * 5.0)).abs() < 1e-14);
}

#[test]
fn every_column_tells_its_own_number() {
    let [_, (swinging, _), _] = trajectories();
    let s = &swinging.samples()[7];
    let (q, b, o) = (s.state.attitude.quaternion(), s.state.omega, s.state.attitude * s.state.omega);
    let (l, n) = (s.momentum, s.torque);
    let vectors = [b.to_array(), o.to_array(), l.to_array(), n.to_array()].concat();
    let wanted =
        [&[s.state.time], &q[..], &vectors, &[s.kinetic_energy, s.potential_energy.unwrap()]].concat();
    let table = Table::of(&swinging, &Surroundings::default());
    let found: Vec<f64> = table.columns().iter().map(|column| column.value(7)).collect();
    assert_eq!(found, wanted);
    for (k, value) in found.iter().enumerate() {
        assert!(!found[..k].contains(value), "two columns of a generic sample are equal: {k}");
    }
}

#[test]
fn csv_reads_back_bit_for_bit() {
    for (trajectory, wheels) in trajectories() {
        let mut bytes = Vec::new();
        let table = Table::of(&trajectory, &wheels);
        table.write_csv(&mut bytes).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        assert!(text.ends_with('\n') && !text.contains('\r'));
        let (header, rows) = text.split_once('\n').unwrap();
        assert_eq!(
            header.split(',').map(str::to_owned).collect::<Vec<_>>(),
            table.columns().iter().map(|c| c.name.to_string()).collect::<Vec<_>>()
        );
        let read =
            |row: &str| row.split(',').map(|n| n.parse::<f64>().unwrap().to_bits()).collect::<Vec<_>>();
        assert_eq!(rows.lines().map(read).collect::<Vec<_>>(), bits(&trajectory, &wheels));
    }
}

#[test]
fn parquet_reads_back_bit_for_bit() {
    for (k, (trajectory, wheels)) in trajectories().iter().enumerate() {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("table-{k}.parquet"));
        let table = Table::of(trajectory, wheels);
        table.write_parquet(&[], File::create(&path).unwrap()).unwrap();
        let reader = SerializedFileReader::new(File::open(&path).unwrap()).unwrap();
        let width = table.columns().len();
        let read =
            |row: parquet::record::Row| (0..width).map(|k| row.get_double(k).unwrap().to_bits()).collect();
        let rows: Vec<Vec<u64>> = reader.get_row_iter(None).unwrap().map(|row| read(row.unwrap())).collect();
        assert_eq!(rows, bits(trajectory, wheels));
    }
}

#[test]
fn parquet_says_what_its_columns_are() {
    let [(free, _), ..] = trajectories();
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("table-metadata.parquet");
    let given = [("title".to_owned(), "a \"tumbling\" brick".to_owned())];
    let table = Table::of(&free, &Surroundings::default());
    table.write_parquet(&given, File::create(&path).unwrap()).unwrap();
    let reader = SerializedFileReader::new(File::open(&path).unwrap()).unwrap();
    let metadata = reader.metadata();

    let pairs = metadata.file_metadata().key_value_metadata().unwrap();
    let value = |key: &str| pairs.iter().find(|p| p.key == key).unwrap().value.clone().unwrap();
    assert_eq!(value("polhode.version"), env!("CARGO_PKG_VERSION"));
    assert!(value("polhode.conventions").contains("R_space_body"));
    assert!(value("polhode.units").starts_with(r#"{"time_s": "s", "attitude_w": "1", "#));
    assert!(value("polhode.units").ends_with(r#""torque_body_z_n_m": "N·m", "kinetic_energy_j": "J"}"#));
    assert_eq!(value("title"), given[0].1);

    for (chunk, column) in metadata.row_group(0).columns().iter().zip(table.columns()) {
        assert_eq!(chunk.column_path().string(), column.name);
        assert_eq!(chunk.column_descr().self_type().get_basic_info().repetition(), Repetition::REQUIRED);
        assert_eq!(chunk.compression(), Compression::LZ4_RAW);
        assert!(chunk.encodings().any(|e| e == Encoding::BYTE_STREAM_SPLIT));
    }
}

#[test]
fn texts_of_columns_need_no_escapes() {
    for (trajectory, wheels) in trajectories() {
        for column in Table::of(&trajectory, &wheels).columns() {
            let text = [&column.name, column.unit, column.description].concat();
            assert!(!text.contains(['"', '\\']) && !column.name.contains(','));
            assert!(!text.chars().any(char::is_control));
        }
    }
}

#[test]
fn no_samples_make_an_empty_table() {
    let body =
        MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 3.0 - 1e-9]).unwrap());
    let start =
        State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.1, 0.2, 0.3) };
    let none =
        Trajectory::compute(&Rotor::free(&body.unwrap()), &[], start, &[], Method::Auto, 1e-12).unwrap();
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("table-empty.parquet");
    let table = Table::of(&none, &Surroundings::default());
    table.write_parquet(&[], File::create(&path).unwrap()).unwrap();
    let reader = SerializedFileReader::new(File::open(&path).unwrap()).unwrap();
    assert_eq!(reader.metadata().file_metadata().num_rows(), 0);
    let mut bytes = Vec::new();
    table.write_csv(&mut bytes).unwrap();
    assert_eq!(bytes.iter().filter(|&&b| b == b'\n').count(), 1);
}

#[test]
fn an_error_of_the_disk_is_passed_on_as_it_was() {
    let [(trajectory, _), ..] = trajectories();
    let mut full = [0_u8; 1000];
    let table = Table::of(&trajectory, &Surroundings::default());
    let csv = table.write_csv(full.as_mut_slice()).unwrap_err();
    assert_eq!(csv.kind(), io::ErrorKind::WriteZero);
    let parquet = table.write_parquet(&[], full.as_mut_slice()).unwrap_err();
    assert_eq!(parquet.kind(), io::ErrorKind::WriteZero);
}
