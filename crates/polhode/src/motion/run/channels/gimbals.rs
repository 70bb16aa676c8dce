//! Channels of a rotor in gimbals. An array of three numbers has the order outer axis, inner axis,
//! rotor axis.

use super::super::channel::Channel;
use crate::motion::gimbal::GimbalState;

const ANGLE: &str = "angle of the axis";
const RATE: &str = "rate of the axis";
const HOLDING: &str = "torque of the lock or the motor that holds the axis; zero of a free one";
const MOMENTUM: &str = "angular momentum of rotor and gimbals about the crossing, along space axes";

/// Complete state of the gimbals.
pub const GIMBALS: Channel<GimbalState> =
    Channel::new("gimbals", "", "the rotor and its gimbals", |row| row.gimbals().copied());
/// Angles of the axes, rad.
pub const AXIS_ANGLES: Channel<[f64; 3]> =
    Channel::new("axis_angles", "rad", "angles of the axes", |row| Some(row.gimbals()?.angles));
/// Rates of the axes, rad/s.
pub const AXIS_RATES: Channel<[f64; 3]> =
    Channel::new("axis_rates", "rad/s", "rates of the axes", |row| Some(row.gimbals()?.rates));

/// Scalar channels, in the order of the columns of tables.
pub(in crate::motion) const SCALARS: [Channel<f64>; 19] = [
    Channel::new("outer_angle_rad", "rad", ANGLE, |row| Some(row.gimbals()?.angles[0])),
    Channel::new("inner_angle_rad", "rad", ANGLE, |row| Some(row.gimbals()?.angles[1])),
    Channel::new("rotor_angle_rad", "rad", ANGLE, |row| Some(row.gimbals()?.angles[2])),
    Channel::new("outer_rate_rad_s", "rad/s", RATE, |row| Some(row.gimbals()?.rates[0])),
    Channel::new("inner_rate_rad_s", "rad/s", RATE, |row| Some(row.gimbals()?.rates[1])),
    Channel::new("rotor_rate_rad_s", "rad/s", RATE, |row| Some(row.gimbals()?.rates[2])),
    Channel::new("outer_holding_n_m", "N·m", HOLDING, |row| Some(row.gimbals()?.holding[0])),
    Channel::new("inner_holding_n_m", "N·m", HOLDING, |row| Some(row.gimbals()?.holding[1])),
    Channel::new("rotor_holding_n_m", "N·m", HOLDING, |row| Some(row.gimbals()?.holding[2])),
    Channel::new("total_momentum_space_x_kg_m2_s", "kg·m²/s", MOMENTUM, |row| {
        Some(row.gimbals()?.momentum.x)
    }),
    Channel::new("total_momentum_space_y_kg_m2_s", "kg·m²/s", MOMENTUM, |row| {
        Some(row.gimbals()?.momentum.y)
    }),
    Channel::new("total_momentum_space_z_kg_m2_s", "kg·m²/s", MOMENTUM, |row| {
        Some(row.gimbals()?.momentum.z)
    }),
    Channel::new(
        "total_kinetic_energy_j",
        "J",
        "kinetic energy of rotor and gimbals, relative to space",
        |row| Some(row.gimbals()?.kinetic_energy),
    ),
    Channel::new(
        "potential_energy_j",
        "J",
        "potential energy of the weights, zero with all centres of mass at the crossing",
        |row| Some(row.gimbals()?.potential_energy),
    ),
    Channel::new("spring_energy_j", "J", "energy of the springs", |row| Some(row.gimbals()?.spring_energy)),
    Channel::new("damping_work_j", "J", "work of damping since the start", |row| {
        Some(row.gimbals()?.damping_work)
    }),
    Channel::new("motor_work_j", "J", "work of motors since the start", |row| {
        Some(row.gimbals()?.motor_work)
    }),
    Channel::new("torque_work_j", "J", "work of the constant torques since the start", |row| {
        Some(row.gimbals()?.torque_work)
    }),
    Channel::new("base_work_j", "J", "work since the start that the base does by its turning", |row| {
        Some(row.gimbals()?.base_work)
    }),
];
