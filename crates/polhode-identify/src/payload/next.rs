//! Choice of the most useful next motion of the wrist.

use nalgebra::DMatrix;
use polhode::math::{Acceleration, AngularAcceleration, AngularVelocity, Force, Torque};

use super::about::to_center;
use super::answer::Payload;
use super::log::{MotionNoise, PayloadLog, PayloadRow, WrenchNoise, diagonal};
use super::motion::wrench_of;
use super::regression::Regression;
use super::small::{cross, dot};
use crate::error::IdentifyError;
use crate::knowledge::BodyUnits;
use crate::next::{Comparison, NextExperiment};
use crate::residuals::ResidualTest;

/// Possible next motion, with as many rows as the log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NextMotion {
    /// Rest in one orientation.
    Rest {
        /// Direction of gravity, a unit vector along the sensor's axes.
        down: [f64; 3],
    },
    /// Oscillation about an axis through the sensor's origin, which is at rest. The angle is
    /// amplitude × sin(rate × t).
    Turn {
        /// Axis of rotation, a unit vector along the sensor's axes.
        axis: [f64; 3],
        /// Direction of gravity at zero angle.
        down: [f64; 3],
        /// Amplitude, rad.
        amplitude: f64,
        /// Angular frequency, rad/s.
        rate: f64,
    },
}

/// Number of rows that are computed per motion, at equal phases. Their weight represents the number
/// of rows in the log.
const ROWS: usize = 96;
/// Upper bound on the amplitude of a wrist, rad.
const WIDEST: f64 = core::f64::consts::FRAC_PI_2;
/// Amplitude and rate for a log without rotation: ±45°, period 2 s.
const AT_REST: [f64; 2] = [core::f64::consts::FRAC_PI_4, core::f64::consts::PI];
/// Threshold below which rates are zero, rad/s or rad/s².
const STILL: f64 = 1e-6;

/// Ranks possible next motions, best first. They have the root mean square ω and dω/dt, the gravity
/// and the noise of the log. Noise of the motion affects only the weights of rows. `None` for a
/// point mass, which has no moments.
pub fn next_motion(
    log: &PayloadLog,
    found: &Payload,
) -> Result<Option<NextExperiment<NextMotion>>, IdentifyError> {
    let Some(of_center) = BodyUnits::of_payload(&found.about_center) else { return Ok(None) };
    let numbers: Vec<f64> = found.about_origin.numbers.iter().map(|number| number.value).collect();
    let units = of_center.after(&to_center(&numbers).1);
    let information = found.about_origin.information()?;
    let mut next = Comparison::new(&units, &information);
    for motion in candidates(log) {
        let rows = rows(log, found, &numbers, motion);
        next.add(motion, rows);
    }
    Ok(Some(next.finish()?))
}

/// Returns six orientations at rest, and oscillations about nine axes, each with the axis level and
/// upright.
fn candidates(log: &PayloadLog) -> Vec<NextMotion> {
    let [amplitude, rate] = swing(log);
    let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let half = core::f64::consts::FRAC_1_SQRT_2;
    let mut all = Vec::new();
    for axis in units {
        all.extend([axis, axis.map(|x| -x)].map(|down| NextMotion::Rest { down }));
    }
    for k in 0..3 {
        let (next, last) = (units[(k + 1) % 3], units[(k + 2) % 3]);
        let between = |sign: f64| core::array::from_fn(|i| half * (next[i] + sign * last[i]));
        for (axis, level) in [(units[k], next), (between(1.0), units[k]), (between(-1.0), units[k])] {
            let downs = [level, level.map(|x| -x), axis, axis.map(|x| -x)];
            all.extend(downs.map(|down| NextMotion::Turn { axis, down, amplitude, rate }));
        }
    }
    all
}

/// Returns the amplitude a and rate ν of an oscillation with the root mean squares of the log:
/// ω = a ν/√2, dω/dt = a ν²/√2.
fn swing(log: &PayloadLog) -> [f64; 2] {
    let count = log.rows().len() as f64;
    let mean = |square: fn(&PayloadRow) -> f64| (log.rows().iter().map(square).sum::<f64>() / count).sqrt();
    let omega = mean(|row| row.omega.dot(row.omega));
    let alpha = mean(|row| row.alpha.dot(row.alpha));
    if omega < STILL || alpha < STILL {
        return AT_REST;
    }
    let peak = 2.0_f64.sqrt() * omega;
    let amplitude = (peak * omega / alpha).min(WIDEST);
    [amplitude, peak / amplitude]
}

impl NextMotion {
    /// Returns ω, rad/s, α, rad/s², and gravity of magnitude `gravity`, m/s², along the sensor's
    /// axes, at a time in s.
    pub fn at(self, time: f64, gravity: f64) -> [[f64; 3]; 3] {
        match self {
            Self::Rest { down } => [[0.0; 3], [0.0; 3], down.map(|x| gravity * x)],
            Self::Turn { axis, down, amplitude, rate } => {
                let (sin, cos) = libm::sincos(rate * time);
                // Space-fixed vectors rotate backwards in the sensor's axes (Rodrigues' formula).
                let (s, c) = libm::sincos(-amplitude * sin);
                let (along, across) = (dot(&axis, &down), cross(axis, down));
                let seen = |i: usize| c * down[i] + s * across[i] + (1.0 - c) * along * axis[i];
                [
                    axis.map(|x| amplitude * rate * cos * x),
                    axis.map(|x| -amplitude * rate * rate * sin * x),
                    [0, 1, 2].map(|i| gravity * seen(i)),
                ]
            }
        }
    }
}

/// Returns a log of the motion with predicted wrenches, and the weight of each of its rows.
fn simulated(
    log: &PayloadLog,
    numbers: &[f64],
    motion: NextMotion,
) -> Result<(PayloadLog, f64), IdentifyError> {
    let gravity = log.rows().iter().map(|row| row.gravity.norm()).sum::<f64>() / log.rows().len() as f64;
    let sign = log.sense.sign();
    let period = match motion {
        NextMotion::Rest { .. } => 1.0,
        NextMotion::Turn { rate, .. } => core::f64::consts::TAU / rate,
    };
    let row = |k: usize| {
        let time = period * (k as f64 + 0.5) / ROWS as f64;
        let [omega, alpha, gravity] = motion.at(time, gravity);
        let mut row = PayloadRow {
            time,
            omega: AngularVelocity::from_array(omega),
            alpha: AngularAcceleration::from_array(alpha),
            acceleration: Acceleration::ZERO,
            gravity: Acceleration::from_array(gravity),
            force: Force::ZERO,
            torque: Torque::ZERO,
        };
        let own = wrench_of(&row.motion().regressor(), numbers);
        let read = |i: usize| sign * own[i] + numbers.get(10 + i).copied().unwrap_or(0.0);
        row.force = Force::new(read(0), read(1), read(2));
        row.torque = Torque::new(read(3), read(4), read(5));
        row
    };
    let mut simulated = PayloadLog::new((0..ROWS).map(row).collect(), log.sense)?;
    simulated.motion_noise = log.motion_noise;
    simulated.has_bias = log.has_bias;
    Ok((simulated, log.rows().len() as f64 / ROWS as f64))
}

fn rows(
    log: &PayloadLog,
    found: &Payload,
    numbers: &[f64],
    motion: NextMotion,
) -> Result<DMatrix<f64>, IdentifyError> {
    let noise = match log.noise {
        WrenchNoise::Unknown => diagonal(found.tests[0].noise, found.tests[1].noise),
        WrenchNoise::Deviations { force, torque } => diagonal(force, torque),
        WrenchNoise::Covariance(covariance) => covariance,
    };
    let widening = ResidualTest::widening_of(&found.tests);
    let (simulated, each) = simulated(log, numbers, motion)?;
    let mut regression = Regression::new(&simulated);
    if simulated.motion_noise != MotionNoise::default() {
        regression.regard_motion_noise();
    }
    let pass = regression.pass(numbers, &noise, |_, _| {})?;
    Ok(pass.triangle.columns(0, numbers.len()) * (each.sqrt() / widening))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gravity_stays_where_it_is_in_space() {
        let axis = [0.6, 0.0, 0.8];
        let turn = NextMotion::Turn { axis, down: [0.0, 1.0, 0.0], amplitude: 0.7, rate: 3.0 };
        let h = 1e-5;
        for time in [0.13, 0.6, 1.3] {
            let [omega, alpha, g] = turn.at(time, 9.81);
            let [[w0, _, g0], [w1, _, g1]] = [time - h, time + h].map(|time| turn.at(time, 9.81));
            // In rotating axes dg/dt = −ω × g.
            let change = cross(omega, g);
            for i in 0..3 {
                assert!(((g1[i] - g0[i]) / (2.0 * h) + change[i]).abs() < 1e-7);
                assert!(((w1[i] - w0[i]) / (2.0 * h) - alpha[i]).abs() < 1e-7);
            }
            assert!((dot(&g, &g).sqrt() - 9.81).abs() < 1e-12);
        }
    }
}
