//! A body whose mass properties change, in text and JSON.

use polhode::motion::{MassHistory, Outflow};
use polhode_document::json::{matrix, vector};
use polhode_document::number::{DIGITS, number};
use serde_json::{Value, json};

/// Describes the change of mass, such as `12.5 → 8.3 kg, through an exit, with jet damping`, and
/// the law of motion.
pub(crate) fn in_words(history: &MassHistory, [from, to]: [f64; 2]) -> String {
    /// Equation of motion without loss of mass.
    const KEPT: &str = "d(I ω)/dt + ω × I ω = N";
    let [Ok((first, _)), Ok((last, _))] = [from, at_end(to)].map(|time| history.at(time)) else {
        return String::new();
    };
    let [before, after] = [first, last].map(|body| number(body.mass(), DIGITS));
    if !history.changes_between(from, to) {
        return format!("{before} kg; nothing of its history is in this time");
    }
    let [flows, drops] = losses(history, [from, to]);
    let (mut how, law) = match history.outflow() {
        _ if !flows => (if drops { "dropped" } else { "mass moves in the body" }.to_owned(), KEPT),
        // Only rounding makes the mass smaller here.
        Outflow::None => ("mass moves in the body".to_owned(), KEPT),
        Outflow::InPlace => ("left behind in place".to_owned(), "I dω/dt + ω × I ω = N"),
        Outflow::Exits(exits) => {
            let through = match exits.len() {
                1 => "an exit".to_owned(),
                several => format!("{several} exits"),
            };
            (format!("through {through}, with jet damping"), "d(I ω)/dt + ω × I ω = N − Σ µ ρ × (ω × ρ)")
        }
    };
    if flows && drops {
        how += ", and dropped";
    }
    let mass = if before == after { before } else { format!("{before} → {after}") };
    format!("{mass} kg, {how}; {law}")
}

/// Returns true if mass leaves continuously in this time, and true if it leaves instantaneously.
fn losses(history: &MassHistory, [from, to]: [f64; 2]) -> [bool; 2] {
    let mass = |time: f64| history.at(time).map_or(f64::NAN, |(body, _)| body.mass());
    let is_less = |before: f64, after: f64| mass(after) < mass(before);
    let (mut flows, mut drops) = (false, false);
    for [begin, end] in history.changes().filter(|[begin, end]| *begin < to && from < *end) {
        if begin == end {
            drops |= is_less(at_end(begin), begin);
        } else {
            flows |= is_less(begin.max(from), at_end(end.min(to)));
        }
    }
    [flows, drops]
}

/// Returns the last time before `end`. A jump at the end is excluded, as in the last state of the
/// motion.
const fn at_end(end: f64) -> f64 {
    end.next_down()
}

/// Returns the outflow, the times of all changes, and the body at the end.
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
