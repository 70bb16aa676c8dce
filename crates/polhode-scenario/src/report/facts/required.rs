//! The torque and the forces that a prescribed motion needs.

use polhode::motion::ParticleForce;
use polhode_document::fact::{Fact, Quantity};
use polhode_document::json::vector;
use polhode_document::number::{number, tidy_beside, vector as triple};
use polhode_document::unit::DIGITS;
use serde_json::{Value, json};

use super::known::Needed;

/// Forces on more particles than this fill the screen: JSON has them all.
const MOST_PARTICLES: usize = 8;

pub(super) fn facts(needed: &Needed) -> Vec<Fact> {
    let start = &needed.at_start;
    let torque = |v: [f64; 3]| Quantity::Vector(v, "N·m");
    let size = start.torque.norm();
    let mut facts = vec![
        Fact::new("required.torque_body_n_m", "N at the start", torque(start.torque.to_array()))
            .note(format!("in body axes, |N| = {} N·m", number(size, DIGITS))),
        Fact::data("required.torque_space_n_m", torque((start.state.attitude * start.torque).to_array())),
        Fact::new("required.power_w", "power at the start", Quantity::Number(start.power, "W")),
        Fact::data("required.largest_torque", None),
    ];
    if let Some(largest) = needed.largest {
        let [time, norm] = [largest.state.time, largest.torque.norm()].map(|x| number(x, DIGITS));
        let body = torque(largest.torque.to_array());
        facts.extend([
            Fact::data("required.largest_torque.time_s", Quantity::Duration(largest.state.time)),
            Fact::new("required.largest_torque.torque_body_n_m", "largest N", body)
                .note(format!("in body axes, |N| = {norm} N·m, at t = {time} s"))
                .shown_if(needed.is_larger_later()),
        ]);
    }
    facts.push(Fact::data("required.particle_forces", needed.forces.iter().map(json_of).collect::<Value>()));
    let shown = needed.forces.iter().take(MOST_PARTICLES).enumerate();
    facts.extend(shown.map(|(k, force)| {
        let scale = force.force.norm();
        let [f, along, across] =
            [force.force, force.along, force.across].map(|v| triple(tidy_beside(v.to_array(), scale), 6));
        Fact::shown(format!("force on particle {}", k + 1), Quantity::Text(format!("{f} N")))
            .note(format!("{along} along its arm, {across} across; body axes, at the start"))
    }));
    let count = needed.forces.len();
    if count > MOST_PARTICLES {
        facts.push(Fact::shown("forces", format!("on {count} particles: summary.json has them")));
    }
    facts
}

fn json_of(f: &ParticleForce) -> Value {
    json!({
        "force_body_n": vector(f.force),
        "along_body_n": vector(f.along),
        "across_body_n": vector(f.across),
        "torque_body_n_m": vector(f.torque),
    })
}
