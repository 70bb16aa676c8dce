//! What holds and drives a shaft.

use polhode::math::{Acceleration, Attitude, Force, Space};
use polhode::motion::{CorrectionMass, MotionError, MountedShaft, Reactions, Required, Shaft};
use polhode_document::json::vector;
use polhode_document::layout::labelled;
use polhode_document::number::{number, tidy_beside, vector as shown};
use polhode_document::unit;
use serde_json::{Value, json};

/// The bearings and the balance of a shaft.
#[derive(Clone, Debug)]
pub(super) struct ShaftReport {
    mounted: MountedShaft,
    attitude: Attitude,
    /// Of the unbalance alone, at the start.
    turning: Reactions,
    /// Of the weight alone, at the start.
    hanging: Reactions,
    /// Both, at the start.
    together: Reactions,
    /// The greatest force on each bearing along the run, N, and when, s.
    greatest: [(f64, f64); 2],
    masses: Vec<CorrectionMass>,
    /// With the masses: the shaft, and what its unbalance leaves at the start.
    balanced: Option<(Shaft, Reactions)>,
}

/// The moment of inertia, the torque and the forces are printed to this many digits.
const DIGITS: usize = 7;

impl ShaftReport {
    pub(super) fn new(mounted: &MountedShaft, samples: &[Required]) -> Result<Self, MotionError> {
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

    pub(super) fn to_text(&self) -> String {
        let shaft = &self.mounted.shaft;
        let [z1, z2] = shaft.bearings().map(unit::length);
        let line = format!(
            "about {} through {} in body axes, I = {} kg·m²; bearings at {} and {} along it",
            shown(shaft.axis().to_array(), DIGITS),
            unit::place(shaft.point().to_array()),
            number(shaft.moment(), DIGITS),
            z1,
            z2
        );
        let mut text = labelled("shaft", &line);
        let center = shaft.axis().dot(shaft.body().center_of_mass() - shaft.point());
        let (force, couple) = (shaft.static_unbalance(), shaft.couple_unbalance(center));
        let unbalance = format!(
            "{}: M e = {} kg·m, and about the centre of mass a couple of {} kg·m²",
            shaft.unbalance().name(),
            shown(force.to_array(), DIGITS),
            shown(couple.to_array(), DIGITS)
        );
        text.push_str(&labelled("unbalance", &unbalance));
        let has_weight = self.mounted.gravity.norm() > 0.0;
        let scale = self.turning.bearings.iter().map(|f| f.norm()).fold(0.0, f64::max);
        for (k, label) in ["bearing 1", "bearing 2"].into_iter().enumerate() {
            let turning = self.turning.bearings[k];
            let mut line = format!(
                "F = {} N in body axes, turning with the shaft, |F| = {} N",
                shown(tidy_beside(turning.to_array(), scale), DIGITS),
                number(turning.norm(), DIGITS)
            );
            if has_weight {
                let all = self.attitude * self.together.bearings[k];
                let (most, when) = self.greatest[k];
                line.push_str(&format!(
                    "; with the weight {} N in space axes at the start, at most {} N (t = {} s)",
                    shown(tidy_beside(all.to_array(), all.norm()), DIGITS),
                    number(most, DIGITS),
                    number(when, DIGITS)
                ));
            } else if self.mounted.acceleration != 0.0 {
                let (most, when) = self.greatest[k];
                line.push_str(&format!(
                    "; at most {} N (t = {} s)",
                    number(most, DIGITS),
                    number(when, DIGITS)
                ));
            }
            text.push_str(&labelled(label, &line));
        }
        let mut drive = format!("N = {} N·m about the shaft", number(self.together.torque, DIGITS));
        if has_weight {
            let [turning, weight] = [self.turning.torque, self.hanging.torque].map(|n| number(n, DIGITS));
            drive = format!("{drive} at the start: {turning} for I α, {weight} against the weight");
        }
        if self.together.thrust.abs() > 1e-13 * self.together.bearings[0].norm() {
            drive.push_str(&format!("; {} N along it", number(self.together.thrust, DIGITS)));
        }
        text.push_str(&labelled("drive", &drive));
        for (k, mass) in self.masses.iter().enumerate() {
            let label = if k == 0 { "balance" } else { "" };
            let line = format!(
                "{} in the plane at {}, at radius {} and angle {}°: at {} in body axes",
                unit::mass(mass.mass),
                unit::length(mass.plane),
                unit::length(mass.radius),
                number(mass.angle.to_degrees(), DIGITS),
                unit::place(mass.position.to_array())
            );
            text.push_str(&labelled(label, &line));
        }
        if let Some((balanced, left)) = &self.balanced {
            let [a, b] = left.bearings.map(|f| number(tidy_beside([f.norm(), 0.0, 0.0], 10.0 * scale)[0], 3));
            let mark = shown(shaft.zero_mark().to_array(), DIGITS);
            let line = format!(
                "angles count about the shaft from {mark}; with {} the bearings hold {a} N and {b} N of unbalance (left: {})",
                if self.masses.len() == 1 { "the mass" } else { "the masses" },
                balanced.unbalance().name()
            );
            text.push_str(&labelled("", &line));
        }
        text
    }

    pub(super) fn to_json(&self) -> Value {
        let shaft = &self.mounted.shaft;
        let center = shaft.axis().dot(shaft.body().center_of_mass() - shaft.point());
        let space = |f: Force<polhode::math::Body>| -> Force<Space> { self.attitude * f };
        let bearing = |k: usize| {
            json!({
                "place_m": shaft.bearings()[k],
                "turning_body_n": vector(self.turning.bearings[k]),
                "weight_space_n": vector(space(self.hanging.bearings[k])),
                "force_body_n": vector(self.together.bearings[k]),
                "force_space_n": vector(space(self.together.bearings[k])),
                "largest_n": self.greatest[k].0,
                "largest_time_s": self.greatest[k].1,
            })
        };
        let mass = |m: &CorrectionMass| {
            json!({
                "plane_m": m.plane,
                "radius_m": m.radius,
                "mass_kg": m.mass,
                "angle_rad": m.angle,
                "position_m": vector(m.position),
            })
        };
        let after = self.balanced.as_ref().map(|(balanced, left)| {
            json!({
                "unbalance": balanced.unbalance().name(),
                "bearings_body_n": left.bearings.iter().map(|f| vector(*f)).collect::<Value>(),
            })
        });
        json!({
            "axis": vector(shaft.axis()),
            "point_m": vector(shaft.point()),
            "moment": shaft.moment(),
            "rate_rad_s": self.mounted.rate,
            "acceleration_rad_s2": self.mounted.acceleration,
            "unbalance": shaft.unbalance().name(),
            "static_unbalance_kg_m": vector(shaft.static_unbalance()),
            "couple_unbalance_kg_m2": vector(shaft.couple_unbalance(center)),
            "bearings": [bearing(0), bearing(1)],
            "thrust_n": self.together.thrust,
            "drive_torque_n_m": self.together.torque,
            "zero_mark": vector(shaft.zero_mark()),
            "correction_masses": self.masses.iter().map(mass).collect::<Value>(),
            "balanced": after,
        })
    }
}
