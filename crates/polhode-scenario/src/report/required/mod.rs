//! Report of `polhode torque`: inverse dynamics of a prescribed motion.

mod answer;
mod facts;
mod shaft;
mod text;

use polhode::body::Particle;
use polhode::math::Body;
use polhode::motion::{MotionError, Required, Rotor, Scenario};
use polhode_document::{SourceInfo, fact};
use serde_json::Value;

use crate::report::facts::torque_scale;
use shaft::ShaftReport;

/// Significant digits of a number in the text.
const DIGITS: usize = 6;

/// Torque, power, work and forces that a prescribed motion needs.
///
/// ```
/// # use polhode::prelude::*;
/// # use polhode::motion::Prescribed;
/// # use polhode::body::BodyPart;
/// # let inertia = InertiaTensor::diagonal([1.0, 2.0, 2.5])?;
/// # let body = MassProperties::new(1.0, Position::ZERO, inertia)?;
/// # let part = BodyPart {
/// #     name: "body".to_owned(), kind: "tensor", properties: body, extent: None, surface_area: None,
/// #     particles: Vec::new(), form: None,
/// # };
/// # let attitude = Attitude::identity();
/// # let led = Prescribed::fixed_axis(attitude, Direction::new(0.0, 3.0, 4.0), 2.0, 0.0)?;
/// # let scenario = Scenario::new(body).made_of(vec![part]).prescribed_as(led)?;
/// use polhode_document::SourceInfo;
/// use polhode_scenario::report::RequiredReport;
/// let report = RequiredReport::new(SourceInfo::new("body.toml", "scenario"), &scenario, &[], &[])?;
/// // N = ω × I ω = 4 (3/5) (4/5) (2.5 − 2)
/// assert!(report.to_text().contains("needs a torque of 0.96 N·m at the start"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct RequiredReport {
    source: SourceInfo,
    scenario: Scenario,
    start: Required,
    /// Results at the times of the run, or without a run at the start only.
    samples: Vec<Required>,
    /// Results at the requested times.
    at: Vec<Required>,
    /// Particles whose forces are requested.
    points: Vec<Particle<Body>>,
    shaft: Option<ShaftReport>,
    is_verbose: bool,
}

impl RequiredReport {
    /// Returns the report of a scenario. `at` contains additional times, s. `points` contains
    /// additional particles whose forces are reported, after those of a body that consists of
    /// particles only.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the scenario prescribes no motion, or
    /// none at one of the times; [`MotionError::NotFinite`] if a formula is not finite.
    pub fn new(
        source: SourceInfo,
        scenario: &Scenario,
        at: &[f64],
        points: &[Particle<Body>],
    ) -> Result<Self, MotionError> {
        let rotor = scenario.rotor();
        let Some(motion) = scenario.prescribed() else {
            let (parameter, rule) =
                ("the number of prescribed motions", "at least 1: [prescribed] or [shaft]");
            return Err(MotionError::ParameterOutOfRange { parameter, value: 0.0, rule });
        };
        let needed = |time: &f64| Required::of_motion(rotor, motion, *time);
        let times = scenario.run().map_or(&[][..], |run| &run.times);
        let start = needed(&scenario.start().time)?;
        let mut samples = times.iter().map(needed).collect::<Result<Vec<_>, _>>()?;
        for k in 1..samples.len() {
            // The quaternion is continuous along a table.
            let before = samples[k - 1].state.attitude;
            samples[k].state.attitude = samples[k].state.attitude.continuous_with(before);
        }
        if samples.is_empty() {
            samples.push(start);
        }
        let at = at.iter().map(needed).collect::<Result<_, _>>()?;
        let own = if scenario.is_all_particles() { scenario.particles() } else { Vec::new() };
        let points = [own.as_slice(), points].concat();
        let shaft = scenario.shaft().map(|mounted| ShaftReport::new(mounted, &samples)).transpose()?;
        let scenario = scenario.clone();
        Ok(Self { source, scenario, start, samples, at, points, shaft, is_verbose: false })
    }

    /// Adds to the text the means in space axes and the details of a shaft.
    #[must_use]
    pub fn verbose(self, is_verbose: bool) -> Self {
        Self { is_verbose, ..self }
    }

    /// Returns the results at the times of the run, or without a run at the start only.
    pub fn samples(&self) -> &[Required] {
        &self.samples
    }

    /// Returns the particles whose forces are requested.
    pub fn points(&self) -> &[Particle<Body>] {
        &self.points
    }

    /// Returns the scenario that prescribes the motion.
    pub const fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// Returns the body and the point that it turns about.
    pub const fn rotor(&self) -> &Rotor {
        self.scenario.rotor()
    }

    /// Returns the text of the report, at most one screen, and a line for each requested time.
    pub fn to_text(&self) -> String {
        text::write(self)
    }

    /// Returns the JSON object, with the same keys for every motion.
    pub fn to_json(&self) -> Value {
        Value::Object(fact::object(&facts::KEYS, &facts::of(self)))
    }

    /// Returns the sample with the largest torque; the first of several.
    fn largest(&self) -> &Required {
        self.samples
            .iter()
            .fold(&self.start, |most, s| if s.torque.norm() > most.torque.norm() { s } else { most })
    }

    /// Returns the sample with the largest |power|.
    fn most_power(&self) -> &Required {
        self.samples
            .iter()
            .fold(&self.start, |most, s| if s.power.abs() > most.power.abs() { s } else { most })
    }

    /// Returns √⟨Nₖ²⟩ of each component over the run (trapezoidal rule), N·m, in body axes and in
    /// space axes.
    fn rms(&self) -> [[f64; 3]; 2] {
        let squares =
            |s: &Required| [s.torque.to_array(), s.torque_space().to_array()].map(|n| n.map(|x| x * x));
        let (mut sums, mut duration) = ([[0.0; 3]; 2], 0.0);
        for pair in self.samples.windows(2) {
            let step = pair[1].state.time - pair[0].state.time;
            let (a, b) = (squares(&pair[0]), squares(&pair[1]));
            duration += step;
            for (sum, (a, b)) in
                sums.as_flattened_mut().iter_mut().zip(a.as_flattened().iter().zip(b.as_flattened()))
            {
                *sum += 0.5 * step * (a + b);
            }
        }
        if duration > 0.0 {
            sums.map(|sum| sum.map(|x| (x / duration).sqrt()))
        } else {
            squares(&self.start).map(|n| n.map(f64::sqrt))
        }
    }

    /// Returns the size of the terms of N along the run, N·m.
    fn scale(&self) -> f64 {
        self.samples.iter().map(torque_scale).fold(0.0, f64::max)
    }

    /// Returns the size of the terms of N · ω along the run, W.
    fn power_scale(&self) -> f64 {
        self.scale() * self.samples.iter().map(|s| s.state.omega.norm()).fold(0.0, f64::max)
    }

    /// Returns the largest kinetic energy along the run, J.
    fn energy(&self) -> f64 {
        self.samples.iter().map(|s| s.kinetic_energy).fold(0.0, f64::max)
    }

    /// Returns the largest |L| along the run, kg·m²/s.
    fn momentum(&self) -> f64 {
        self.samples.iter().map(|s| s.momentum.norm()).fold(0.0, f64::max)
    }

    /// Returns true if there are samples after the start.
    fn is_run(&self) -> bool {
        self.samples.len() > 1
    }

    fn last(&self) -> &Required {
        self.samples.last().unwrap_or(&self.start)
    }

    fn first(&self) -> &Required {
        self.samples.first().unwrap_or(&self.start)
    }
}
