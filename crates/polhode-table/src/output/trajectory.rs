//! Table of a trajectory, with a row for each sample.
//!
//! Attitudes are R_space_body as unit quaternions (w, x, y, z).

use polhode::math::AngularVelocity;
use polhode::motion::{Orbit, Pointing, Sample, Scenario, StateError, Trajectory, Wheel};

use super::Table;

/// Wheels inside the body, its orbit, and the reported angles. A trajectory does not contain these.
#[derive(Clone, Debug, Default)]
pub struct Surroundings {
    /// Wheels of the body, in their order.
    pub wheels: Vec<Wheel>,
    /// Orbit of the centre of mass.
    pub orbit: Option<Orbit>,
    /// Directions whose angles are reported.
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

impl<'a> Table<'a> {
    /// Returns the table of a trajectory. Its columns are, in order:
    ///
    /// - time, attitude, angular velocity, momentum, torque and kinetic energy
    /// - the potential energy, if every torque has a potential
    /// - the channels of a body on the ground or in gimbals, with energies and works
    /// - estimates of the error, if there are any
    /// - momentum and speed of each wheel, numbered from 1; only the momentum if its speed is held
    /// - attitude relative to the orbit, and position on it
    /// - angles of the reported directions
    pub fn of(trajectory: &'a Trajectory, surroundings: &Surroundings) -> Self {
        let samples = trajectory.samples();
        let mut table = Self::new("trajectory", samples.len());
        table.of_every_motion(samples);
        if samples.first().is_some_and(|s| s.potential_energy.is_some()) {
            table.sampled(samples, "potential_energy_j", "J", "potential energy of the torques", |s| {
                s.potential_energy.unwrap_or(f64::NAN)
            });
        }
        for channel in trajectory.channels() {
            table.number(channel.name(), channel.unit(), channel.description(), |row| {
                trajectory.channel(*channel).and_then(|series| series.get(row)).unwrap_or(f64::NAN)
            });
        }
        if let Some(error) = trajectory.error() {
            let value = |value: fn(&StateError) -> f64| {
                move |row| error.computation().get(row).map_or(f64::NAN, value)
            };
            let (attitude, omega) = (value(|e| e.attitude), value(|e| e.omega));
            table.number("attitude_error_rad", "rad", "estimated error of the attitude, an angle", attitude);
            table.number("omega_error", "1", "estimated error of omega, relative to |omega|", omega);
        }
        for (k, &wheel) in surroundings.wheels.iter().enumerate() {
            let held = wheel.speed_at(0.0, AngularVelocity::ZERO).is_none();
            let description = if held { MOMENTUM_OF_HELD } else { MOMENTUM_OF_TURNED };
            let momentum = format!("wheel_{}_momentum_kg_m2_s", k + 1);
            table.sampled(samples, momentum, "kg·m²/s", description, move |s| {
                wheel.momentum_at(s.state.time)
            });
            if !held {
                let (speed, description) =
                    (format!("wheel_{}_speed_rad_s", k + 1), "speed of the wheel relative to the body");
                table.sampled(samples, speed, "rad/s", description, move |s| {
                    wheel.speed_at(s.state.time, s.state.omega).unwrap_or(f64::NAN)
                });
            }
        }
        if let Some(orbit) = &surroundings.orbit {
            table.on_orbit(samples, orbit);
        }
        for pointing in &surroundings.pointings {
            let name = format!("{}_angle_rad", pointing.name().to_ascii_lowercase());
            let (pointing, description) =
                (pointing.clone(), "angle between a direction of the body and that of a [[pointing]]");
            table.sampled(samples, name, "rad", description, move |s| pointing.angle(&s.state));
        }
        table
    }

    fn of_every_motion(&mut self, samples: &'a [Sample]) {
        self.sampled(samples, "time_s", "s", "time", |s| s.state.time);
        for (k, component) in ["w", "x", "y", "z"].into_iter().enumerate() {
            let name = format!("attitude_{component}");
            self.sampled(samples, name, "1", ATTITUDE, move |s| s.state.attitude.quaternion()[k]);
        }
        let of = |value: fn(&Sample) -> [f64; 3]| of_sample(samples, value);
        let omega_body = of(|s| s.state.omega.to_array());
        self.vector(["omega_body", "_rad_s"], "rad/s", OMEGA_BODY, omega_body);
        let omega_space = of(|s| s.state.omega_space().to_array());
        self.vector(["omega_space", "_rad_s"], "rad/s", OMEGA_SPACE, omega_space);
        self.vector(["momentum_space", "_kg_m2_s"], "kg·m²/s", MOMENTUM, of(|s| s.momentum.to_array()));
        self.vector(["torque_body", "_n_m"], "N·m", TORQUE, of(|s| s.torque.to_array()));
        self.sampled(samples, "kinetic_energy_j", "J", "rotational kinetic energy", |s| s.kinetic_energy);
    }

    fn on_orbit(&mut self, samples: &'a [Sample], orbit: &Orbit) {
        for (k, angle) in ["roll", "pitch", "yaw"].into_iter().enumerate() {
            let orbit = orbit.clone();
            self.sampled(samples, format!("orbit_{angle}_rad"), "rad", ANGLE_ON_ORBIT, move |s| {
                (orbit.local_axes(s.state.time).inverse() * s.state.attitude).roll_pitch_yaw()[k]
            });
        }
        let own = orbit.clone();
        let position = of_sample(samples, move |s| own.position(s.state.time).to_array());
        self.vector(["position_space", "_m"], "m", POSITION, position);
        let own = orbit.clone();
        let velocity = of_sample(samples, move |s| own.velocity(s.state.time).to_array());
        self.vector(["velocity_space", "_m_s"], "m/s", VELOCITY, velocity);
    }

    fn sampled(
        &mut self,
        samples: &'a [Sample],
        name: impl Into<std::borrow::Cow<'static, str>>,
        unit: &'static str,
        description: &'static str,
        value: impl Fn(&Sample) -> f64 + 'a,
    ) {
        self.number(name, unit, description, move |row| samples.get(row).map_or(f64::NAN, &value));
    }
}

/// Returns a vector of each sample, as a function of the row.
fn of_sample<'a, V: Fn(&Sample) -> [f64; 3] + Clone + 'a>(
    samples: &'a [Sample],
    value: V,
) -> impl Fn(usize) -> [f64; 3] + Clone + use<'a, V> {
    move |row| samples.get(row).map_or([f64::NAN; 3], &value)
}

const ATTITUDE: &str = "R_space_body as a unit quaternion, Hamilton, scalar first";
const OMEGA_BODY: &str = "angular velocity relative to space, along body axes";
const OMEGA_SPACE: &str = "angular velocity relative to space, along space axes";
const MOMENTUM: &str = "angular momentum, that of wheels included, along space axes";
const TORQUE: &str = "torque, along body axes";
const MOMENTUM_OF_HELD: &str = "angular momentum of the wheel along its axis, relative to the body";
const MOMENTUM_OF_TURNED: &str = "angular momentum of the wheel along its axis, relative to space";
const ANGLE_ON_ORBIT: &str = "attitude relative to the orbit's axes (x forward, y opposite to the orbit normal, z to the nadir), 3-2-1: yaw first";
const POSITION: &str = "centre of mass on its orbit, from the centre of attraction, along space axes";
const VELOCITY: &str = "velocity of the centre of mass on its orbit, along space axes";
