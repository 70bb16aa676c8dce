//! Facts about the torque and the forces that a prescribed motion needs.

use polhode::math::{Attitude, Body, Torque};
use polhode::motion::{ParticleForce, Required};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::json::vector;
use polhode_document::number::{number, tidy_beside, vector as triple};
use serde_json::{Map, Value};

use super::known::Needed;

/// Significant digits of a number in the text.
const DIGITS: usize = 6;

/// Maximum number of particles whose forces are in the text; JSON contains all of them.
const MOST_PARTICLES: usize = 8;

pub(super) fn facts(needed: &Needed) -> Vec<Fact> {
    let start = &needed.at_start;
    let (scale, attitude) = (needed.scale(), start.state.attitude);
    let [body, space] = torque("required", "N at the start", start.torque, attitude, scale, "");
    let mut facts = vec![body, space.shown_if(false)];
    facts.push(power("required", "power at the start", start, scale));
    facts.push(Fact::data("required.largest_torque", None));
    if let Some(largest) = needed.largest {
        let key = "required.largest_torque";
        let when = format!(", at t = {} s", number(largest.state.time, DIGITS));
        let [body, _] = torque(key, "largest N", largest.torque, largest.state.attitude, scale, &when);
        let time = Quantity::Duration(largest.state.time);
        facts.extend([Fact::data(format!("{key}.time_s"), time), body.shown_if(needed.is_larger_later())]);
    }
    let json = needed.forces.iter().map(|f| Value::Object(force_json(f)));
    facts.push(Fact::data("required.particle_forces", json.collect::<Value>()));
    facts.extend(forces(needed.forces.iter().map(|f| (*f, String::new()))));
    facts
}

/// Returns N in body axes with its magnitude, and in space axes; rounding of `scale`, N·m, is shown
/// as 0.
pub(crate) fn torque(
    key: &str,
    label: &str,
    n: Torque<Body>,
    attitude: Attitude,
    scale: f64,
    when: &str,
) -> [Fact; 2] {
    let value = |v: [f64; 3]| Quantity::Vector(v, "N·m");
    let size = number(tidy_beside([n.norm(), 0.0, 0.0], 10.0 * scale)[0], DIGITS);
    [
        Fact::new(format!("{key}.torque_body_n_m"), label, value(n.to_array()))
            .note(format!("in body axes, |N| = {size} N·m{when}")),
        Fact::new(format!("{key}.torque_space_n_m"), "N in space", value((attitude * n).to_array())),
    ]
    .map(|fact| fact.with_term_size(scale).digits(DIGITS))
}

/// Returns N · ω; `scale` as for the torque.
pub(crate) fn power(key: &str, label: &str, needed: &Required, scale: f64) -> Fact {
    Fact::new(format!("{key}.power_w"), label, Quantity::Number(needed.power, "W"))
        .with_term_size(scale * needed.state.omega.norm())
        .digits(DIGITS)
}

/// Returns the forces on the first particles, each with the name of the particle.
pub(crate) fn forces(forces: impl ExactSizeIterator<Item = (ParticleForce, String)>) -> Vec<Fact> {
    let count = forces.len();
    let mut facts: Vec<Fact> = forces.take(MOST_PARTICLES).enumerate().map(force).collect();
    if count > MOST_PARTICLES {
        facts.push(Fact::shown("forces", format!("on {count} particles: the JSON has them")));
    }
    facts
}

fn force((k, (f, on)): (usize, (ParticleForce, String))) -> Fact {
    let scale = f.force.norm();
    let shown = [f.force, f.along, f.across].map(|v| triple(tidy_beside(v.to_array(), scale), DIGITS));
    let [force, along, across] = shown;
    Fact::shown(format!("force on particle {}", k + 1), Quantity::Text(format!("{force} N")))
        .note(format!("{along} along its arm, {across} across; body axes, at the start{on}"))
}

/// Returns the force on a particle, its components and its torque.
pub(crate) fn force_json(f: &ParticleForce) -> Map<String, Value> {
    let parts: [(&str, Value); 4] = [
        ("force_body_n", vector(f.force)),
        ("along_body_n", vector(f.along)),
        ("across_body_n", vector(f.across)),
        ("torque_body_n_m", vector(f.torque)),
    ];
    parts.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}
