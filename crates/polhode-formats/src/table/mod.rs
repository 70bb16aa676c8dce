//! The trajectory table: one row per sample, one column per number.
//!
//! The columns are defined here, once; each format has a file of its own. SI units, named in the column's name
//! where it has one; attitudes are R_space_body as unit quaternions (w, x, y, z).

pub mod csv;
pub mod curve;
pub mod parquet;
pub mod required;

use std::borrow::Cow;

use polhode::motion::{Sample, StateError, Trajectory, Wheel};

/// One column of the trajectory table.
#[derive(Clone, Debug)]
pub struct Column {
    /// The name, with its unit as suffix.
    pub name: Cow<'static, str>,
    /// The unit in SI symbols; `1` for a pure number.
    pub unit: &'static str,
    /// What it is.
    pub description: &'static str,
    source: Source,
}

/// Where the numbers of a column come from.
#[derive(Clone, Copy, Debug)]
enum Source {
    Sample(fn(&Sample) -> f64),
    Error(fn(&StateError) -> f64),
    WheelMomentum(Wheel),
    WheelSpeed(Wheel),
}

impl Column {
    /// The number of this column for a sample of the trajectory, from 0.
    pub fn value(&self, trajectory: &Trajectory, row: usize) -> f64 {
        let Some(sample) = trajectory.samples().get(row) else { return f64::NAN };
        let state = &sample.state;
        match self.source {
            Source::Sample(value) => value(sample),
            Source::Error(value) => {
                trajectory.error().and_then(|error| error.computation().get(row)).map_or(f64::NAN, value)
            }
            Source::WheelMomentum(wheel) => wheel.momentum_at(state.time),
            Source::WheelSpeed(wheel) => wheel.speed_at(state.time, state.omega).unwrap_or(f64::NAN),
        }
    }
}

/// The columns of a trajectory, in order: after those of every motion the potential energy where every torque has a potential, the
/// estimates of the error where there are any, then what each of the body's wheels does, numbered from 1; of one whose speed is held only its momentum, for its inertia is not known.
pub fn columns(trajectory: &Trajectory, wheels: &[Wheel]) -> Vec<Column> {
    let has_potential = trajectory.samples().first().is_some_and(|s| s.potential_energy.is_some());
    let mut columns = Vec::from(COLUMNS);
    if has_potential {
        columns.push(column("potential_energy_j", "J", "potential energy of the torques", |s| {
            s.potential_energy.unwrap_or(f64::NAN)
        }));
    }
    if trajectory.error().is_some() {
        columns.extend(ERRORS);
    }
    let zero = polhode::math::AngularVelocity::ZERO;
    for (k, wheel) in wheels.iter().enumerate() {
        let named = |what: &str| Cow::Owned(format!("wheel_{}_{what}", k + 1));
        let held = wheel.speed_at(0.0, zero).is_none();
        let (name, description) =
            (named("momentum_kg_m2_s"), if held { MOMENTUM_OF_HELD } else { MOMENTUM_OF_TURNED });
        let source = Source::WheelMomentum(*wheel);
        columns.push(Column { name, unit: "kg·m²/s", description, source });
        if !held {
            let (name, description) = (named("speed_rad_s"), "speed of the wheel relative to the body");
            columns.push(Column { name, unit: "rad/s", description, source: Source::WheelSpeed(*wheel) });
        }
    }
    columns
}

/// How signs, orders and frames are to be read: for the metadata of formats that have any.
pub const CONVENTIONS: &str = "SI units; attitude = R_space_body (v_space = R v_body), unit quaternion, Hamilton, \
    scalar first (w, x, y, z), continuous in time; omega is the body's angular velocity relative to space; inertia, \
    momentum, torque and rotational kinetic energy are about the centre of mass of a free body, about the pivot of a \
    held one";

const COLUMNS: [Column; 18] = [
    column("time_s", "s", "time", |s| s.state.time),
    column("attitude_w", "1", ATTITUDE, |s| s.state.attitude.quaternion()[0]),
    column("attitude_x", "1", ATTITUDE, |s| s.state.attitude.quaternion()[1]),
    column("attitude_y", "1", ATTITUDE, |s| s.state.attitude.quaternion()[2]),
    column("attitude_z", "1", ATTITUDE, |s| s.state.attitude.quaternion()[3]),
    column("omega_body_x_rad_s", "rad/s", OMEGA_BODY, |s| s.state.omega.x),
    column("omega_body_y_rad_s", "rad/s", OMEGA_BODY, |s| s.state.omega.y),
    column("omega_body_z_rad_s", "rad/s", OMEGA_BODY, |s| s.state.omega.z),
    column("omega_space_x_rad_s", "rad/s", OMEGA_SPACE, |s| s.state.omega_space().x),
    column("omega_space_y_rad_s", "rad/s", OMEGA_SPACE, |s| s.state.omega_space().y),
    column("omega_space_z_rad_s", "rad/s", OMEGA_SPACE, |s| s.state.omega_space().z),
    column("momentum_space_x_kg_m2_s", "kg·m²/s", MOMENTUM, |s| s.momentum.x),
    column("momentum_space_y_kg_m2_s", "kg·m²/s", MOMENTUM, |s| s.momentum.y),
    column("momentum_space_z_kg_m2_s", "kg·m²/s", MOMENTUM, |s| s.momentum.z),
    column("torque_body_x_n_m", "N·m", TORQUE, |s| s.torque.x),
    column("torque_body_y_n_m", "N·m", TORQUE, |s| s.torque.y),
    column("torque_body_z_n_m", "N·m", TORQUE, |s| s.torque.z),
    column("kinetic_energy_j", "J", "rotational kinetic energy", |s| s.kinetic_energy),
];

const ERRORS: [Column; 2] = [
    error("attitude_error_rad", "rad", "estimated error of the attitude, an angle", |e| e.attitude),
    error("omega_error", "1", "estimated error of omega, relative to |omega|", |e| e.omega),
];

const ATTITUDE: &str = "R_space_body as a unit quaternion, Hamilton, scalar first";
const OMEGA_BODY: &str = "angular velocity relative to space, along body axes";
const OMEGA_SPACE: &str = "angular velocity relative to space, along space axes";
const MOMENTUM: &str = "angular momentum, that of wheels included, along space axes";
const TORQUE: &str = "torque, along body axes";
const MOMENTUM_OF_HELD: &str = "angular momentum of the wheel along its axis, relative to the body";
const MOMENTUM_OF_TURNED: &str = "angular momentum of the wheel along its axis, relative to space";

const fn column(
    name: &'static str,
    unit: &'static str,
    description: &'static str,
    value: fn(&Sample) -> f64,
) -> Column {
    Column { name: Cow::Borrowed(name), unit, description, source: Source::Sample(value) }
}

const fn error(
    name: &'static str,
    unit: &'static str,
    description: &'static str,
    value: fn(&StateError) -> f64,
) -> Column {
    Column { name: Cow::Borrowed(name), unit, description, source: Source::Error(value) }
}
