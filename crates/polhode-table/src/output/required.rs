//! Table of the torques and forces that a prescribed motion requires, with a row for each sample.
//!
//! The first columns always exist. They are followed by the forces on given points, numbered from
//! 1, and the forces of a shaft's bearings.

use polhode::body::Particle;
use polhode::math::{Body, Force};
use polhode::motion::{MountedShaft, Required, Rotor};

use super::Table;

/// Returns the table of some samples, with the forces on points of the body and on the bearings of
/// its shaft.
pub fn required<'a>(
    samples: &'a [Required],
    rotor: &'a Rotor,
    points: &'a [Particle<Body>],
    shaft: Option<&'a MountedShaft>,
) -> Table<'a> {
    let mut table = Table::new("required", samples.len());
    let number = |value: fn(&Required) -> f64| move |row| samples.get(row).map_or(f64::NAN, value);
    let vector = |value: fn(&Required) -> [f64; 3]| move |row| samples.get(row).map_or([f64::NAN; 3], value);
    table.number("time_s", "s", "time", number(|s| s.state.time));
    table.vector(["omega_body", "_rad_s"], "rad/s", OMEGA, vector(|s| s.state.omega.to_array()));
    table.vector(["acceleration_body", "_rad_s2"], "rad/s²", RATE, vector(|s| s.acceleration.to_array()));
    table.vector(["torque_body", "_n_m"], "N·m", TORQUE_BODY, vector(|s| s.torque.to_array()));
    table.vector(["torque_space", "_n_m"], "N·m", TORQUE_SPACE, vector(|s| s.torque_space().to_array()));
    table.number("power_w", "W", "power of the torque", number(|s| s.power));
    table.number("work_j", "J", "work of the torque since the first row", move |row| {
        let first = samples.first().zip(samples.get(row));
        first.map_or(f64::NAN, |(first, sample)| sample.work_since(first))
    });
    for (k, point) in points.iter().enumerate() {
        table.vector([&format!("force_{}_body", k + 1), "_n"], "N", FORCE, move |row| {
            samples.get(row).map_or([f64::NAN; 3], |s| s.force_on(point, rotor).force.to_array())
        });
    }
    for (k, mounted) in shaft.into_iter().flat_map(|mounted| [(0, mounted), (1, mounted)]) {
        table.vector([&format!("bearing_{}_body", k + 1), "_n"], "N", BEARING, move |row| {
            let held = samples.get(row).map(|s| {
                mounted.reactions(mounted.shaft.axis().dot(s.state.omega), s.state.attitude).bearings
            });
            held.and_then(|held| held.get(k).copied()).map_or([0.0; 3], Force::to_array)
        });
    }
    table
}

const OMEGA: &str = "angular velocity relative to space, along body axes";
const RATE: &str = "rate of the angular velocity, along body axes";
const TORQUE_BODY: &str = "torque that the motion needs, along body axes";
const TORQUE_SPACE: &str = "torque that the motion needs, along space axes";
const FORCE: &str = "force on a point that the motion needs, along body axes";
const BEARING: &str = "force of a bearing on the shaft, along body axes";
