//! Bearing forces, drive torque and balancing of a shaft.

use polhode::math::{Acceleration, Attitude, Body, Force, Space};
use polhode::motion::{CorrectionMass, MotionError, MountedShaft, Reactions, Required, Shaft};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::json::vector;
use polhode_document::number::{number, tidy_beside};
use polhode_document::unit;
use serde_json::{Value, json};

use super::DIGITS;
use crate::report::answer::{self, capitalised};

/// Threshold of the thrust relative to the force on a bearing; a smaller thrust is rounding.
const NOISE: f64 = 1e-13;

/// Bearing forces and balancing of a shaft.
#[derive(Clone, Debug)]
pub(crate) struct ShaftReport {
    mounted: MountedShaft,
    attitude: Attitude,
    /// Reactions at the start due to the unbalance alone.
    turning: Reactions,
    /// Reactions at the start due to the weight alone.
    hanging: Reactions,
    /// Reactions at the start due to both.
    together: Reactions,
    /// Largest force on each bearing along the run, N, and its time, s.
    greatest: [(f64, f64); 2],
    masses: Vec<CorrectionMass>,
    /// Shaft with its correction masses, and the remaining reactions due to unbalance at the start.
    balanced: Option<(Shaft, Reactions)>,
}

impl ShaftReport {
    pub(crate) fn new(mounted: &MountedShaft, samples: &[Required]) -> Result<Self, MotionError> {
        let MountedShaft { shaft, rate, acceleration, .. } = mounted;
        let attitude = samples.first().map_or(Attitude::identity(), |s| s.state.attitude);
        let g = attitude.inverse() * mounted.gravity;
        let mut greatest = [(0.0, 0.0); 2];
        for s in samples {
            let held = mounted.reactions(shaft.axis().dot(s.state.omega), s.state.attitude);
            for (most, force) in greatest.iter_mut().zip(held.bearings) {
                if force.norm() > most.0 {
                    *most = (force.norm(), s.state.time);
                }
            }
        }
        let masses = mounted.correction_masses()?;
        let balanced = (!masses.is_empty()).then(|| shaft.with(&masses).ok()).flatten();
        Ok(Self {
            attitude,
            turning: shaft.reactions(*rate, *acceleration, Acceleration::ZERO),
            hanging: shaft.reactions(0.0, 0.0, g),
            together: shaft.reactions(*rate, *acceleration, g),
            greatest,
            masses,
            balanced: balanced
                .map(|shaft| (shaft, shaft.reactions(*rate, *acceleration, Acceleration::ZERO))),
            mounted: mounted.clone(),
        })
    }

    /// Describes the unbalance, the largest bearing forces, and the number of correction masses.
    pub(crate) fn answer(&self) -> String {
        let [a, b] = self.greatest.map(|(most, _)| number(most, answer::DIGITS));
        let masses = match self.masses.len() {
            0 => String::new(),
            n => format!("; {} it", if n == 1 { "one mass balances" } else { "two masses balance" }),
        };
        let kind = match self.mounted.shaft.unbalance().name() {
            "none" => "no",
            name => name,
        };
        let unbalance = capitalised(kind);
        format!("{unbalance} unbalance: the bearings carry at most {a} N and {b} N{masses}.")
    }

    /// Returns the facts with the keys of `shaft`.
    pub(crate) fn facts(&self) -> Vec<Fact> {
        let MountedShaft { shaft, rate, acceleration, .. } = &self.mounted;
        let fact =
            |name: &str, label: &str, value: Quantity| Fact::new(format!("shaft.{name}"), label, value);
        let center = shaft.axis().dot(shaft.body().center_of_mass() - shaft.point());
        let (force, couple) = (shaft.static_unbalance(), shaft.couple_unbalance(center));
        let unbalance = shaft.unbalance().name();
        let through = format!("in body axes, through {}", unit::place(shaft.point().to_array()));
        let mut facts = vec![
            fact("axis", "axis", Quantity::Vector(shaft.axis().to_array(), "")).note(through),
            fact("point_m", "", Quantity::Vector(shaft.point().to_array(), "m")),
            fact("moment", "moment of inertia", Quantity::Number(shaft.moment(), "kg·m²"))
                .note("about the axis"),
            fact("rate_rad_s", "rate", Quantity::Rate(*rate)).note("at t = 0").detail(),
            fact("acceleration_rad_s2", "acceleration", Quantity::Number(*acceleration, "rad/s²")).detail(),
            fact("unbalance", "unbalance", Quantity::Word(unbalance, unbalance.to_owned())),
            fact("static_unbalance_kg_m", "M e", Quantity::Vector(force.to_array(), "kg·m"))
                .note("static unbalance, in body axes"),
            fact("couple_unbalance_kg_m2", "couple", Quantity::Vector(couple.to_array(), "kg·m²"))
                .note("couple unbalance about the centre of mass"),
            fact("bearings", "", json!([self.bearing(0), self.bearing(1)]).into()),
        ];
        facts.extend([0, 1].into_iter().flat_map(|k| self.forces(k)));
        facts.extend(self.drive());
        facts.extend(self.balance());
        facts
    }

    fn bearing(&self, k: usize) -> Value {
        let space = |f: Force<Body>| -> Force<Space> { self.attitude * f };
        json!({
            "place_m": self.mounted.shaft.bearings()[k],
            "turning_body_n": vector(self.turning.bearings[k]),
            "weight_space_n": vector(space(self.hanging.bearings[k])),
            "force_body_n": vector(self.together.bearings[k]),
            "force_space_n": vector(space(self.together.bearings[k])),
            "largest_n": self.greatest[k].0,
            "largest_time_s": self.greatest[k].1,
        })
    }

    /// Returns the forces of a bearing on the shaft: due to the unbalance, with the weight, and the
    /// largest.
    fn forces(&self, k: usize) -> [Fact; 3] {
        let (turning, (most, when)) = (self.turning.bearings[k], self.greatest[k]);
        let all = self.attitude * self.together.bearings[k];
        let [size, when] = [turning.norm(), when].map(|x| number(x, DIGITS));
        let place = unit::length(self.mounted.shaft.bearings()[k]);
        let has_weight = self.mounted.gravity.norm() > 0.0;
        [
            Fact::shown(format!("bearing {}", k + 1), Quantity::Vector(turning.to_array(), "N"))
                .with_term_size(self.scale())
                .note(format!(
                    "in body axes, turning with the shaft, |F| = {size} N; at {place} along the axis"
                )),
            Fact::shown("  with the weight", Quantity::Vector(all.to_array(), "N"))
                .note("in space axes, at the start")
                .shown_if(has_weight),
            Fact::shown("  largest", Quantity::Number(most, "N"))
                .note(format!("at t = {when} s"))
                .shown_if(has_weight || self.mounted.acceleration != 0.0),
        ]
    }

    /// Returns the torque and force along the axis, at the start.
    fn drive(&self) -> [Fact; 2] {
        let Reactions { torque, thrust, bearings } = &self.together;
        let [turning, weight] = [&self.turning, &self.hanging].map(|held| number(held.torque, DIGITS));
        let parts = format!("about the axis at the start: {turning} for I α, {weight} against the weight");
        let held = bearings[0].norm();
        [
            Fact::new("shaft.thrust_n", "thrust", Quantity::Number(*thrust, "N"))
                .note("along the axis")
                .shown_if(thrust.abs() > NOISE * held),
            Fact::new("shaft.drive_torque_n_m", "drive torque", Quantity::Number(*torque, "N·m")).note(parts),
        ]
    }

    /// Returns the correction masses, and the residual unbalance with them.
    fn balance(&self) -> Vec<Fact> {
        let shaft = &self.mounted.shaft;
        let mass = |m: &CorrectionMass| {
            json!({
                "plane_m": m.plane,
                "radius_m": m.radius,
                "mass_kg": m.mass,
                "angle_rad": m.angle,
                "position_m": vector(m.position),
            })
        };
        let mut facts = vec![
            Fact::new(
                "shaft.zero_mark",
                "zero of angles",
                Quantity::Vector(shaft.zero_mark().to_array(), ""),
            )
            .note("in body axes, about the axis")
            .shown_if(!self.masses.is_empty()),
            Fact::data("shaft.correction_masses", self.masses.iter().map(mass).collect::<Value>()),
        ];
        facts.extend(self.masses.iter().enumerate().map(|(k, m)| {
            let [plane, radius] = [m.plane, m.radius].map(unit::length);
            let (angle, place) = (number(m.angle.to_degrees(), DIGITS), unit::place(m.position.to_array()));
            Fact::shown(format!("correction mass {}", k + 1), Quantity::Number(m.mass, "kg")).note(format!(
                "at {plane} along the axis, radius {radius}, angle {angle}°: {place} in body axes"
            ))
        }));
        let after = self.balanced.as_ref().map(|(balanced, rest)| {
            let unbalance = balanced.unbalance().name();
            let [a, b] =
                rest.bearings.map(|f| number(tidy_beside([f.norm(), 0.0, 0.0], 10.0 * self.scale())[0], 3));
            let forces = rest.bearings.iter().map(|f| vector(*f)).collect::<Value>();
            let text =
                format!("residual unbalance: {unbalance}; its forces on the bearings: {a} N and {b} N");
            Quantity::Data(json!({ "unbalance": unbalance, "bearings_body_n": forces }), text)
        });
        facts.push(Fact::new("shaft.balanced", "with the masses", after));
        facts
    }

    /// Returns the size of the forces due to the unbalance, N.
    fn scale(&self) -> f64 {
        self.turning.bearings.iter().map(|f| f.norm()).fold(0.0, f64::max)
    }
}
