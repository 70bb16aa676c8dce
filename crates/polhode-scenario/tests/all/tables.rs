//! Tables of motions, as requested by scenarios.

use polhode::infer::judge::{AttitudeSense, OmegaAxes, QuaternionOrder};
use polhode::prelude::*;
use polhode_scenario::read as scenario;
use polhode_table::log;
use polhode_table::output::Table;

#[test]
fn polhodes_own_table_says_everything() {
    let text = "[[body.part]]\nshape = 'box'\nsize = [0.1, 0.2, 0.3]\nmass = 1.7\n[start]\nspin = { body = [0.1, 2, 0.3] }\n\
                [run]\nduration = 5\nsamples = 41\n";
    let scenario = scenario::parse(text, "t.toml".as_ref()).unwrap();
    let motion = scenario.simulate().unwrap().unwrap();
    let (mut csv, mut parquet) = (Vec::new(), Vec::new());
    let table = Table::of(&motion, &(&scenario).into());
    table.write_csv(&mut csv).unwrap();
    table.write_parquet(&[], &mut parquet).unwrap();
    let read = log::from_bytes(&csv, None).unwrap();
    assert_eq!(read, log::from_bytes(&parquet, None).unwrap());
    for (k, sample) in motion.samples().iter().enumerate() {
        assert_eq!(read.log.times()[k], sample.state.time);
        assert_eq!(read.log.attitude()[k], sample.state.attitude.quaternion());
        assert_eq!(read.log.omega().unwrap()[k], sample.state.omega.to_array());
    }
    assert_eq!(read.says.order, Some(QuaternionOrder::ScalarFirst));
    assert_eq!(read.says.sense, Some(AttitudeSense::BodyToSpace));
    assert_eq!(read.says.omega_axes, Some(OmegaAxes::Body));
    assert_eq!(read.says.time_origin, None);
    assert!(read.says.by_name.order && read.says.by_name.sense && read.says.by_name.omega_axes);
    assert_eq!(read.ignored[..3], ["omega_space_x_rad_s", "omega_space_y_rad_s", "omega_space_z_rad_s"]);
    assert!(read.ignored.contains(&"kinetic_energy_j".to_owned()));
    assert_eq!(read.read[2].what, "angular velocity along body axes, rad/s");
}

/// Checks the columns of an orbit at a generic point against their definitions, with rotations
/// about one axis at a time.
#[test]
fn a_body_on_an_orbit_has_its_attitude_there() {
    let text = "[orbit]\nsemi_major_axis = '8200 km'\neccentricity = 0.13\ninclination = '51 deg'\nnode = '-20 deg'\n\
        periapsis = '75 deg'\ntrue_anomaly = '110 deg'\n\
        [[body.part]]\nshape = 'tensor'\nmass = 3\ninertia = [[1.1, 0.1, -0.2], [0.1, 2.3, 0.3], [-0.2, 0.3, 2.9]]\n\
        [start]\nrelative_to = 'orbit'\nattitude = { roll_pitch_yaw = ['12 deg', '-34 deg', '140 deg'] }\n\
        spin = { body = ['1 deg/s', '-2 deg/s', '0.5 deg/s'] }\n\
        [[torque]]\nmodel = 'gravity_gradient'\n[[torque]]\nmodel = 'magnetic'\nmoment = [0.1, 0.3, -0.2]\ndipole = [1e22, 2e22, -7.7e22]\n\
        [[pointing]]\nname = 'Camera'\nbody = [1, 2, -0.5]\nto = 'nadir'\n\
        [[pointing]]\nname = 'ahead'\nbody = [0.2, 1, 0.5]\nto = 'velocity'\n\
        [[pointing]]\nname = 'side'\nbody = [0.2, 0, 0.5]\nto = 'orbit_normal'\n\
        [[pointing]]\nname = 'magnet'\nbody = [0.1, 0.3, -0.2]\nto = 'field'\n\
        [[pointing]]\nname = 'panel'\nbody = [0, -1, 0.1]\nto = { space = [3, -1, 2] }\n\
        [run]\nduration = '0.5 orbits'\nsamples = 3\n";
    let scenario = scenario::parse(text, "probe.toml".as_ref()).unwrap();
    let motion = scenario.simulate().unwrap().unwrap();
    let table = Table::of(&motion, &(&scenario).into());
    let value = |name: &str, row: usize| {
        table.columns().iter().find(|column| column.name == name).unwrap().value(row)
    };
    let near = |name: &str, row: usize, want: f64| {
        assert!(
            (value(name, row) - want).abs() < 1e-13 * want.abs().max(1.0),
            "{name} {} {want}",
            value(name, row)
        );
    };
    for (name, degrees) in [("roll", 12.0_f64), ("pitch", -34.0), ("yaw", 140.0)] {
        near(&format!("orbit_{name}_rad"), 0, degrees.to_radians());
    }
    let orbit = scenario.orbit().unwrap();
    let vector = |v: [f64; 3]| Direction::<polhode::math::Space>::from_array(v);
    let body = |v: [f64; 3]| Direction::<polhode::math::Body>::from_array(v);
    for row in 0..3 {
        let state = motion.samples()[row].state;
        let (r, v) = (orbit.position(state.time).to_array(), orbit.velocity(state.time).to_array());
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            near(&format!("position_space_{axis}_m"), row, r[k]);
            near(&format!("velocity_space_{axis}_m_s"), row, v[k]);
        }
        let (r, v) = (vector(r), vector(v));
        let nadir = r * (-1.0 / r.norm());
        let side = v.cross(r) * (1.0 / v.cross(r).norm());
        let ahead = side.cross(nadir);
        // R₃(ψ) R₂(θ) R₁(φ), one rotation at a time, each about an axis of the rotated frame.
        let [roll, pitch, yaw] =
            ["roll", "pitch", "yaw"].map(|name| value(&format!("orbit_{name}_rad"), row));
        let turn = |axis: Direction<polhode::math::Space>, angle: f64, v: Direction<polhode::math::Space>| {
            v * angle.cos() + axis.cross(v) * angle.sin() + axis * (axis.dot(v) * (1.0 - angle.cos()))
        };
        let (x1, y1) = (turn(nadir, yaw, ahead), turn(nadir, yaw, side));
        let (x2, z2) = (turn(y1, pitch, x1), turn(y1, pitch, nadir));
        let (y3, z3) = (turn(x2, roll, y1), turn(x2, roll, z2));
        for (mine, axis) in [(x2, [1.0, 0.0, 0.0]), (y3, [0.0, 1.0, 0.0]), (z3, [0.0, 0.0, 1.0])] {
            assert!((mine - state.attitude * body(axis)).norm() < 1e-13, "{row} {axis:?}");
        }
        let r3 = r.norm().powi(3);
        let dipole = vector([1e22, 2e22, -7.7e22]);
        let field = (r * (3.0 * dipole.dot(r) / r.dot(r)) - dipole) * (1e-7 / r3);
        let torque = (state.attitude.inverse() * field).cross(body([0.1, 0.3, -0.2])) * -1.0;
        assert!(torque.norm() > 0.0);
        for (name, axis, to) in [
            ("camera", [1.0, 2.0, -0.5], nadir),
            ("ahead", [0.2, 1.0, 0.5], v),
            ("side", [0.2, 0.0, 0.5], r.cross(v)),
            ("magnet", [0.1, 0.3, -0.2], field),
            ("panel", [0.0, -1.0, 0.1], vector([3.0, -1.0, 2.0])),
        ] {
            let along = state.attitude * body(axis);
            near(&format!("{name}_angle_rad"), row, (along.dot(to) / along.norm() / to.norm()).acos());
        }
    }
    // Relative to axes that rotate at r × v/r².
    let start = motion.start().state;
    let (r, v) = (vector(orbit.position(0.0).to_array()), vector(orbit.velocity(0.0).to_array()));
    let relative = start.omega.to_array();
    let turning = (start.attitude.inverse() * (r.cross(v) * (1.0 / r.dot(r)))).to_array();
    for (k, degrees) in [1.0_f64, -2.0, 0.5].into_iter().enumerate() {
        assert!((relative[k] - turning[k] - degrees.to_radians()).abs() < 1e-16);
    }
    // After half a period of an ellipse the position follows from Kepler's equation, not from half
    // a circle.
    let (half, period) = (motion.samples()[2].state.time, orbit.period().unwrap());
    assert!((2.0 * half / period - 1.0).abs() < 1e-15);
    assert!((period - std::f64::consts::TAU * (8.2e6_f64.powi(3) / 3.986_004_418e14).sqrt()).abs() < 1e-9);
}
