//! The columns of a rotor in gimbals.

use polhode::motion::gimbal::GimbalSample;

/// Name, unit, what it is, and its number.
pub(crate) type OfGimbals = (&'static str, &'static str, &'static str, fn(&GimbalSample) -> f64);

const ANGLE: &str = "angle of the axis";
const RATE: &str = "rate of the axis";
const HOLDING: &str = "torque of the lock or the motor that holds the axis; zero of a free one";
const MOMENTUM: &str = "angular momentum of rotor and gimbals about the crossing, along space axes";

pub(crate) const COLUMNS: [OfGimbals; 19] = [
    ("outer_angle_rad", "rad", ANGLE, |s| s.angles[0]),
    ("inner_angle_rad", "rad", ANGLE, |s| s.angles[1]),
    ("rotor_angle_rad", "rad", ANGLE, |s| s.angles[2]),
    ("outer_rate_rad_s", "rad/s", RATE, |s| s.rates[0]),
    ("inner_rate_rad_s", "rad/s", RATE, |s| s.rates[1]),
    ("rotor_rate_rad_s", "rad/s", RATE, |s| s.rates[2]),
    ("outer_holding_n_m", "N·m", HOLDING, |s| s.holding[0]),
    ("inner_holding_n_m", "N·m", HOLDING, |s| s.holding[1]),
    ("rotor_holding_n_m", "N·m", HOLDING, |s| s.holding[2]),
    ("total_momentum_space_x_kg_m2_s", "kg·m²/s", MOMENTUM, |s| s.momentum.x),
    ("total_momentum_space_y_kg_m2_s", "kg·m²/s", MOMENTUM, |s| s.momentum.y),
    ("total_momentum_space_z_kg_m2_s", "kg·m²/s", MOMENTUM, |s| s.momentum.z),
    ("total_kinetic_energy_j", "J", "kinetic energy of rotor and gimbals, relative to space", |s| {
        s.kinetic_energy
    }),
    (
        "potential_energy_j",
        "J",
        "potential energy of the weights, zero with all centres of mass at the crossing",
        |s| s.potential_energy,
    ),
    ("spring_energy_j", "J", "energy of the springs", |s| s.spring_energy),
    ("damping_work_j", "J", "work of damping since the start", |s| s.damping_work),
    ("motor_work_j", "J", "work of motors since the start", |s| s.motor_work),
    ("torque_work_j", "J", "work of the constant torques since the start", |s| s.torque_work),
    ("base_work_j", "J", "work since the start that the base does by its turning", |s| s.base_work),
];
