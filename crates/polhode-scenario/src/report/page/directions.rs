//! Directions of space at a satellite: nadir, velocity, the magnetic field, the Sun, and targets of
//! pointings.

use polhode::math::{Direction, Space};
use polhode::motion::torque::TorqueModel;
use polhode::motion::{Pointing, Reference, Sample, Scenario};
use polhode_document::json::{finite, numbers};
use polhode_document::layout::printable;
use serde_json::{Value, json};

use super::packed::f32s;

/// Name of a pointing whose fixed target is the Sun. Scenarios have no other key for it.
const SUN: &str = "sun";

/// Distinct directions, in the order of the page.
#[derive(Debug, Default)]
pub(crate) struct Directions {
    all: Vec<(String, Reference)>,
    /// Index of the target of each pointing.
    targets: Vec<usize>,
}

impl Directions {
    /// Returns those of the orbit, of the field of a magnetic torque, and of the pointings.
    pub(crate) fn of(scenario: &Scenario, pointings: &[Pointing]) -> Self {
        let mut found = Self::default();
        if let Some(orbit) = scenario.orbit() {
            for reference in [Reference::Nadir(orbit.clone()), Reference::Velocity(orbit.clone())] {
                found.add(reference.name().to_owned(), &reference);
            }
        }
        for torque in scenario.torques() {
            if let TorqueModel::Magnetic(magnetic) = torque {
                found.add("B".to_owned(), &Reference::Field(magnetic.field.clone()));
            }
        }
        for pointing in pointings {
            let reference = pointing.reference();
            let name = match reference {
                Reference::Space(_) if pointing.name().eq_ignore_ascii_case(SUN) => SUN.to_owned(),
                Reference::Space(_) => format!("target of {}", printable(pointing.name())),
                Reference::OrbitNormal(_) => "orbit normal".to_owned(),
                Reference::Field(_) => "B".to_owned(),
                _ => reference.name().to_owned(),
            };
            let target = found.add(name, reference);
            found.targets.push(target);
        }
        found
    }

    /// Returns the index of a direction, added if it is new. The Sun has its name for all pointings.
    fn add(&mut self, name: String, reference: &Reference) -> usize {
        let known = self.all.iter().position(|(_, other)| other == reference);
        if let Some(target) = known.and_then(|k| self.all.get_mut(k)).filter(|_| name == SUN) {
            target.0.clone_from(&name);
        }
        known.unwrap_or_else(|| {
            self.all.push((name, reference.clone()));
            self.all.len() - 1
        })
    }

    /// Returns the index of the target of the k-th pointing.
    pub(crate) fn target(&self, k: usize) -> Option<usize> {
        self.targets.get(k).copied()
    }

    /// Returns the unit vectors at the samples; one alone for a direction that is fixed in space.
    pub(crate) fn json(&self, samples: &[&Sample]) -> Value {
        let one = |(name, reference): &(String, Reference)| {
            let fixed = match reference {
                Reference::Space(direction) => numbers(&direction.to_array().map(finite)),
                _ => Value::Null,
            };
            let at = |sample: &&Sample| unit(reference.direction(sample.state.time));
            let rows = fixed.is_null().then(|| f32s(samples.iter().flat_map(at)));
            json!({ "name": name, "fixed": fixed, "values": rows })
        };
        self.all.iter().map(one).collect()
    }
}

/// Returns the unit vector along a direction, rounded to f32; zero for none.
fn unit(direction: Direction<Space>) -> [f32; 3] {
    let size = direction.norm();
    let scale = if size > 0.0 && size.is_finite() { 1.0 / size } else { 0.0 };
    direction.to_array().map(|c| (c * scale) as f32)
}
