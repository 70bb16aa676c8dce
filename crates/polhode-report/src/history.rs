//! A body whose mass properties change, in text and JSON.

use polhode::motion::{MassHistory, Outflow};
use serde_json::{Value, json};

use crate::json::{matrix, vector};
use crate::number::number;
use crate::unit::DIGITS;

/// `12.5 → 8.3 kg, through 1 exit; I changes with it`
pub(crate) fn in_words(history: &MassHistory, [from, to]: [f64; 2]) -> String {
    let [Ok((first, _)), Ok((last, _))] = [from, at_end(to)].map(|time| history.at(time)) else {
        return String::new();
    };
    let [before, after] = [first, last].map(|body| number(body.mass(), DIGITS));
    let how = match history.outflow() {
        _ if first.mass() == last.mass() => "mass moves in the body".to_owned(),
        Outflow::None => "dropped".to_owned(),
        Outflow::InPlace => "left behind in place".to_owned(),
        Outflow::Exits(exits) if exits.len() == 1 => "through an exit, with jet damping".to_owned(),
        Outflow::Exits(exits) => format!("through {} exits, with jet damping", exits.len()),
    };
    format!("{before} → {after} kg, {how}; d(I ω)/dt + ω × I ω = N − Σ µ ρ × (ω × ρ)")
}

/// What jumps at the end is as it was: so is the motion's last state.
const fn at_end(end: f64) -> f64 {
    end.next_down()
}

/// The body at the end, and when something changes.
pub(crate) fn to_json(history: &MassHistory, end: f64) -> Value {
    let how = match history.outflow() {
        Outflow::None => "none",
        Outflow::InPlace => "in_place",
        Outflow::Exits(_) => "exits",
    };
    let last = history.at(at_end(end)).ok().map(|(body, _)| {
        json!({
            "mass_kg": body.mass(),
            "center_of_mass_m": vector(body.center_of_mass()),
            "inertia_kg_m2": matrix(body.inertia().matrix()),
        })
    });
    json!({ "outflow": how, "changes_at_s": history.times().collect::<Vec<_>>(), "final": last })
}
