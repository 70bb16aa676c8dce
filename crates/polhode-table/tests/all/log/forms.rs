//! Quaternions, matrices and Euler angles.

use polhode::infer::judge::{AttitudeSense, OmegaAxes, QuaternionOrder};
use polhode::prelude::*;

use super::{angle, attitudes, omega, read, refused, table, time, told};

const ROWS: usize = 12;

fn with_time(k: usize, numbers: impl IntoIterator<Item = f64>) -> Vec<f64> {
    [time(k)].into_iter().chain(numbers).collect()
}

#[test]
fn quaternions_keep_their_bits_and_their_length() {
    let scaled = |k, a: Attitude| with_time(k, a.quaternion().map(|c| 1.7 * c).into_iter().chain(omega(k)));
    let log = read(table("t,qw,qx,qy,qz,wx,wy,wz", ROWS, scaled));
    assert_eq!(log.says.order, Some(QuaternionOrder::ScalarFirst));
    assert_eq!((log.says.sense, log.says.omega_axes, log.says.time_origin), (None, None, None));
    for (k, attitude) in attitudes(ROWS).iter().enumerate() {
        assert_eq!(log.log.attitude()[k], attitude.quaternion().map(|c| 1.7 * c));
        assert_eq!(log.log.omega().unwrap()[k], omega(k));
        assert_eq!(log.log.times()[k], time(k));
    }
    // Letters show that the scalar is last. Numbers do not show the order.
    let last = |k, a: Attitude| {
        let [w, x, y, z] = a.quaternion();
        with_time(k, [x, y, z, w])
    };
    let named = read(table("time,orientation.x,orientation.y,orientation.z,orientation.w", ROWS, last));
    let [w, x, y, z] = attitudes(ROWS)[3].quaternion();
    assert_eq!((named.log.attitude()[3], named.log.omega()), ([x, y, z, w], None));
    assert_eq!(named.says.order, Some(QuaternionOrder::ScalarLast));
    let mixed = read(table("time,q.y,q.x,q.z,q.w", ROWS, |k, a| {
        let [w, x, y, z] = a.quaternion();
        with_time(k, [y, x, z, w])
    }));
    assert_eq!(
        (mixed.log.attitude()[3], mixed.says.order),
        ([w, x, y, z], Some(QuaternionOrder::ScalarFirst))
    );
    let numbered = read(table("time,q0,q1,q2,q3", ROWS, last));
    assert_eq!((numbered.log.attitude()[3], numbered.says.order), ([x, y, z, w], None));
    let text = table("time,q0,q1,q2,q3", ROWS, last);
    let said = told(text, "q xyzw space-to-body = q0..q3").unwrap();
    assert_eq!(said.log.attitude()[3], [x, y, z, w]);
    assert_eq!(said.says.order, Some(QuaternionOrder::ScalarLast));
    assert_eq!(said.says.sense, Some(AttitudeSense::SpaceToBody));
}

#[test]
fn matrices_become_quaternions() {
    let rows = |k, a: Attitude| with_time(k, a.matrix().into_iter().flatten());
    let nine = |first: usize, name: &dyn Fn(usize, usize) -> String| {
        let names = (0..9).map(|k| name(k / 3 + first, k % 3 + first));
        format!("t,{}", names.collect::<Vec<_>>().join(","))
    };
    for header in [
        nine(1, &|i, j| format!("r{i}{j}")),
        nine(0, &|i, j| format!("R_{i}_{j}")),
        nine(0, &|i, j| format!("dcm[{i}][{j}]")),
        nine(0, &|i, j| format!("robot.xmat_{}", 3 * i + j)),
        nine(0, &|i, j| format!("rot_{}{}", ["x", "y", "z"][i], ["x", "y", "z"][j])),
    ] {
        let log = read(table(&header, ROWS, rows));
        assert!(angle(&log) < 4e-16, "{header}: {}", angle(&log));
        assert_eq!((log.says.order, log.says.sense), (Some(QuaternionOrder::ScalarFirst), None));
    }
    // Columns in another order than that of their names: the transposed matrix is the inverse.
    let header = nine(1, &|i, j| format!("C{j}{i}"));
    let inverse = read(table(&header, ROWS, |k, a| with_time(k, a.matrix().into_iter().flatten())));
    for (attitude, read) in attitudes(ROWS).iter().zip(inverse.log.attitude()) {
        let read: Attitude = Rotation::from_quaternion(*read).unwrap();
        let own: Attitude = Rotation::from_quaternion(attitude.inverse().quaternion()).unwrap();
        assert!(own.angle_to(read) < 4e-16);
    }
}

#[test]
fn matrices_of_few_digits_are_taken_to_the_nearest_rotation() {
    let header = "t,r11,r12,r13,r21,r22,r23,r31,r32,r33";
    let single = |x: f64| f64::from(x as f32);
    let six = |x: f64| (x * 1e6).round() / 1e6;
    for (round, most) in [(single as fn(f64) -> f64, 1e-7), (six, 1e-6)] {
        let log = read(table(header, ROWS, |k, a| with_time(k, a.matrix().into_iter().flatten().map(round))));
        let angle = angle(&log);
        assert!(angle > 1e-9 && angle < most, "{angle}");
    }
    let three =
        |k, a: Attitude| with_time(k, a.matrix().into_iter().flatten().map(|x| (x * 1e3).round() / 1e3));
    let error = refused(table(header, ROWS, three));
    assert!(error.message().starts_with("|RᵀR − 1| of row 1 = "), "{error}");
    assert_eq!(error.place().unwrap().line, 2);
    let mirrored =
        |k, a: Attitude| with_time(k, a.matrix().into_iter().flatten().map(|x| if k > 4 { -x } else { x }));
    let error = refused(table(header, ROWS, mirrored));
    assert_eq!(error.message(), "det R of row 6 = −1 must be +1: the matrix mirrors");
    assert_eq!(error.place().unwrap().line, 7);
    assert!(error.hint().unwrap().contains("left-handed"));
}

/// Returns the product of three rotations, each about an axis of the frame after the previous
/// rotations.
fn turned(axes: [usize; 3], angles: [f64; 3]) -> Attitude {
    let one = |k: usize| {
        let [x, y, z] = std::array::from_fn(|axis| f64::from(u8::from(axis == axes[k])));
        Rotation::<Body, Body>::from_axis_angle(Direction::new(x, y, z), angles[k]).unwrap()
    };
    Attitude::identity() * one(0) * one(1) * one(2)
}

#[test]
fn every_sequence_of_euler_angles_is_the_product_of_its_turns() {
    let angles = |k: usize| [0.4 + 0.3 * k as f64, -0.9 + 0.1 * k as f64, 2.1 - 0.4 * k as f64];
    let text = table("t,a,b,c", 5, |k, _| with_time(k, angles(k)));
    let mut sequences = 0;
    for (a, b, c) in (0..27).map(|k| (k / 9, k / 3 % 3, k % 3)).filter(|(a, b, c)| a != b && b != c) {
        sequences += 1;
        let name = format!("{}-{}-{}", a + 1, b + 1, c + 1);
        let log = told(&text, &format!("euler {name} rad = a b c")).unwrap();
        let letters: String = [a, b, c].iter().map(|axis| ["x", "y", "z"][*axis]).collect();
        assert_eq!(log, told(&text, &format!("e {letters} rad = a..c")).unwrap());
        let fixed = told(&text, &format!("euler {name} extrinsic rad = a b c")).unwrap();
        for k in 0..5 {
            let read =
                |log: &polhode_table::log::RunLog| Attitude::from_quaternion(log.log.attitude()[k]).unwrap();
            assert!(turned([a, b, c], angles(k)).angle_to(read(&log)) < 1e-15, "{name}");
            // If the axes are fixed, the last rotation comes first.
            let [p, q, r] = angles(k);
            assert!(turned([c, b, a], [r, q, p]).angle_to(read(&fixed)) < 1e-15, "{name}");
        }
        assert!(fixed.read[1].what.starts_with("extrinsic"), "{:?}", fixed.read);
    }
    assert_eq!(sequences, 12);
}

#[test]
fn roll_pitch_yaw_and_precession_are_known_by_name() {
    let degrees = |angles: [f64; 3]| angles.map(f64::to_degrees);
    let text =
        table("t,roll [deg],pitch [deg],yaw [deg]", ROWS, |k, a| with_time(k, degrees(a.roll_pitch_yaw())));
    let log = read(&text);
    assert!(angle(&log) < 2e-15, "{}", angle(&log));
    assert_eq!(log.read[1].what, "3-2-1 Euler angles, deg");
    assert_eq!(log.read[1].columns, ["yaw [deg]", "pitch [deg]", "roll [deg]"]);
    let said = told(&text, "euler 3-2-1 = \"yaw [deg]\" 'pitch [deg]' \"roll [deg]\"").unwrap();
    assert_eq!(said, log);
    let wrong = told(&text, "euler 3-2-1 = \"roll [deg]\" \"pitch [deg]\" \"yaw [deg]\"").unwrap_err();
    assert!(wrong.to_string().contains("in the order of the turns 3-2-1"), "{wrong}");
    let text = table("t,spin_rad,nutation_rad,precession_rad", ROWS, |k, a| {
        let [phi, theta, psi] = a.euler313();
        with_time(k, [psi, theta, phi])
    });
    assert!(angle(&read(&text)) < 2e-15);
    let text = table("t,phi,theta,psi", ROWS, |k, a| with_time(k, a.euler313()));
    assert!(refused(&text).message().starts_with("in which sequence are the Euler angles phi, theta, psi?"));
    assert!(angle(&told(&text, "euler 3-1-3 rad = phi theta psi").unwrap()) < 2e-15);
    let text = table("t,roll,pitch,yaw", ROWS, |k, a| with_time(k, a.roll_pitch_yaw()));
    assert!(refused(&text).message().starts_with("in which unit is yaw, pitch, roll?"));
    assert!(angle(&read(format!("# units = rad\n{text}"))) < 2e-15);
    assert!(angle(&told(&text, "e rad = roll pitch yaw").unwrap()) < 2e-15);
}

#[test]
fn angular_velocities_have_units_and_axes() {
    let numbers = |k, a: Attitude| with_time(k, a.quaternion().into_iter().chain(omega(k)));
    let quaternion = "t,qw,qx,qy,qz";
    for (names, scale, axes) in [
        ("wx,wy,wz", 1.0, None),
        (
            "omega_body_x_deg_s,omega_body_y_deg_s,omega_body_z_deg_s",
            1_f64.to_radians(),
            Some(OmegaAxes::Body),
        ),
        ("gyro.x [mrad/s],gyro.y [mrad/s],gyro.z [mrad/s]", 1e-3, Some(OmegaAxes::Body)),
        ("w_world_1,w_world_2,w_world_3", 1.0, Some(OmegaAxes::Space)),
        ("angularVelocityX_dps,angularVelocityY_dps,angularVelocityZ_dps", 1_f64.to_radians(), None),
    ] {
        let log = read(table(&format!("{quaternion},{names}"), 3, numbers));
        assert_eq!(log.says.omega_axes, axes, "{names}");
        for (own, read) in omega(2).iter().zip(log.log.omega().unwrap()[2]) {
            assert!((own * scale - read).abs() <= 2e-16 * read.abs(), "{names}: {read}");
        }
    }
    let text = table(&format!("{quaternion},wx,wy,wz"), 3, numbers);
    let said = told(&text, "w space rpm = wx wy wz").unwrap();
    assert_eq!(said.says.omega_axes, Some(OmegaAxes::Space));
    let rpm = omega(1)[0] * std::f64::consts::PI / 30.0;
    assert!((said.log.omega().unwrap()[1][0] - rpm).abs() < 1e-16);
    let none = told(&text, "omega = none").unwrap();
    assert_eq!((none.log.omega(), none.ignored), (None, ["wx", "wy", "wz"].map(str::to_owned).to_vec()));
    let mixed = refused(table(&format!("{quaternion},wx [deg/s],wy,wz"), 3, numbers));
    assert!(mixed.message().contains("all in one unit"), "{mixed}");
    let length = refused(table(&format!("{quaternion},wx [m],wy [m],wz [m]"), 3, numbers));
    assert!(length.message().contains("a unit that polhode knows"), "{length}");
}
