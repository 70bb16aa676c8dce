//! The trajectory table: one row per sample, one column per number.
//!
//! The columns are defined here, once; each format has a file of its own. SI units, named in the column's name
//! where it has one; attitudes are R_space_body as unit quaternions (w, x, y, z).

pub mod csv;
pub mod curve;
pub mod parquet;
pub mod required;

use std::borrow::Cow;

use polhode::motion::{Channel, Orbit, Pointing, Sample, Scenario, State, StateError, Trajectory, Wheel};

/// What a table has to know beside the trajectory: wheels inside the body, its orbit, and the angles that are of interest.
#[derive(Clone, Debug, Default)]
pub struct Surroundings {
    /// The wheels of the body, in its order.
    pub wheels: Vec<Wheel>,
    /// The orbit of its centre of mass.
    pub orbit: Option<Orbit>,
    /// The angles that are of interest.
    pub pointings: Vec<Pointing>,
}

impl From<&Scenario> for Surroundings {
    fn from(scenario: &Scenario) -> Self {
        Self {
            wheels: scenario.wheels().to_vec(),
            orbit: scenario.orbit().cloned(),
            pointings: scenario.pointings().to_vec(),
        }
    }
}

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
#[derive(Clone, Debug)]
enum Source {
    Sample(fn(&Sample) -> f64),
    Channel(Channel<f64>),
    Error(fn(&StateError) -> f64),
    WheelMomentum(Wheel),
    WheelSpeed(Wheel),
    Pointing(Pointing),
    Orbit(Orbit, fn(&Orbit, &State) -> f64),
}

impl Column {
    /// The number of this column for a sample of the trajectory, from 0.
    pub fn value(&self, trajectory: &Trajectory, row: usize) -> f64 {
        let Some(sample) = trajectory.samples().get(row) else { return f64::NAN };
        let state = &sample.state;
        match &self.source {
            Source::Sample(value) => value(sample),
            Source::Channel(channel) => {
                trajectory.channel(*channel).and_then(|series| series.get(row)).unwrap_or(f64::NAN)
            }
            Source::Error(value) => {
                trajectory.error().and_then(|error| error.computation().get(row)).map_or(f64::NAN, value)
            }
            Source::WheelMomentum(wheel) => wheel.momentum_at(state.time),
            Source::WheelSpeed(wheel) => wheel.speed_at(state.time, state.omega).unwrap_or(f64::NAN),
            Source::Pointing(pointing) => pointing.angle(state),
            Source::Orbit(orbit, value) => value(orbit, state),
        }
    }
}

/// The columns of a trajectory, in order: after those of every motion the potential energy where every torque has a potential; of a body on
/// the ground or in gimbals what it does there, with energies and works; the estimates of the error where there are any; what each of the body's wheels does, numbered from 1, of one whose speed is held only its
/// momentum, for its inertia is not known; on an orbit the attitude relative to it, and where the body is; and the angles that are of
/// interest.
pub fn columns(trajectory: &Trajectory, surroundings: &Surroundings) -> Vec<Column> {
    let has_potential = trajectory.samples().first().is_some_and(|s| s.potential_energy.is_some());
    let mut columns = Vec::from(COLUMNS);
    if has_potential {
        columns.push(column("potential_energy_j", "J", "potential energy of the torques", |s| {
            s.potential_energy.unwrap_or(f64::NAN)
        }));
    }
    columns.extend(trajectory.channels().iter().map(|channel| Column {
        name: Cow::Borrowed(channel.name()),
        unit: channel.unit(),
        description: channel.description(),
        source: Source::Channel(*channel),
    }));
    if trajectory.error().is_some() {
        columns.extend(ERRORS);
    }
    let zero = polhode::math::AngularVelocity::ZERO;
    for (k, wheel) in surroundings.wheels.iter().enumerate() {
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
    if let Some(orbit) = &surroundings.orbit {
        columns.extend(ON_ORBIT.map(|(name, unit, description, value)| Column {
            name: Cow::Borrowed(name),
            unit,
            description,
            source: Source::Orbit(orbit.clone(), value),
        }));
    }
    columns.extend(surroundings.pointings.iter().map(|pointing| Column {
        name: Cow::Owned(format!("{}_angle_rad", pointing.name().to_ascii_lowercase())),
        unit: "rad",
        description: "angle between a direction of the body and that of a [[pointing]]",
        source: Source::Pointing(pointing.clone()),
    }));
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

/// A column of a body on an orbit.
type OnOrbit = (&'static str, &'static str, &'static str, fn(&Orbit, &State) -> f64);

const ON_ORBIT: [OnOrbit; 9] = [
    ("orbit_roll_rad", "rad", ANGLE_ON_ORBIT, |o, s| roll_pitch_yaw(o, s)[0]),
    ("orbit_pitch_rad", "rad", ANGLE_ON_ORBIT, |o, s| roll_pitch_yaw(o, s)[1]),
    ("orbit_yaw_rad", "rad", ANGLE_ON_ORBIT, |o, s| roll_pitch_yaw(o, s)[2]),
    ("position_space_x_m", "m", POSITION, |o, s| o.position(s.time).x),
    ("position_space_y_m", "m", POSITION, |o, s| o.position(s.time).y),
    ("position_space_z_m", "m", POSITION, |o, s| o.position(s.time).z),
    ("velocity_space_x_m_s", "m/s", VELOCITY, |o, s| o.velocity(s.time).x),
    ("velocity_space_y_m_s", "m/s", VELOCITY, |o, s| o.velocity(s.time).y),
    ("velocity_space_z_m_s", "m/s", VELOCITY, |o, s| o.velocity(s.time).z),
];

const ANGLE_ON_ORBIT: &str =
    "attitude relative to the orbit's axes (x ahead, y against the normal, z to the nadir), 3-2-1: yaw first";
const POSITION: &str = "centre of mass on its orbit, from the centre of attraction, along space axes";
const VELOCITY: &str = "velocity of the centre of mass on its orbit, along space axes";

fn roll_pitch_yaw(orbit: &Orbit, state: &State) -> [f64; 3] {
    (orbit.local_axes(state.time).inverse() * state.attitude).roll_pitch_yaw()
}

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
