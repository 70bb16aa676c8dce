//! Facts about a motion in one list, which is the source of the text, `summary.json` and the rows
//! of the page.
//!
//! Each file states the facts of one section: JSON keys, labels and values. JSON lists are raw JSON
//! facts, because paths would not be shorter. So are parts whose keys depend on a kind (torques,
//! wheels, events, surfaces).

mod contact;
mod driven;
mod event;
mod evidence;
mod free;
mod gimbals;
mod heavy_top;
mod known;
mod motion;
mod orbit;
mod pendulum;
mod required;

pub(crate) use contact::{form, how as on_ground, surface};
pub(crate) use event::ending_in_words;
pub(crate) use free::{constants, dissipation, nutation, periods, picture as picture_of, symmetric_top};
pub(crate) use gimbals::how as in_gimbals;
pub(crate) use heavy_top::{of as heavy_top_of, time_round};
pub(crate) use known::{Known, is_larger, torque_scale};
pub(crate) use motion::{how as solved_by, state_at};
pub(crate) use orbit::{Angles, to as target};
pub(crate) use required::{force_json, forces, power, torque};

use polhode::motion::channel::{CONTACT, GIMBALS};
use polhode_document::fact::{Fact, Facts};

use crate::report::free_facts::FreeFacts;

/// Returns the facts about a motion in sections, in the order of the text.
pub(crate) fn of(known: &Known<'_>) -> Vec<Facts> {
    let section = |title: &str, facts: Vec<Fact>| Facts::new(title, facts);
    let mut sections = vec![
        section("Motion", motion::facts(known)),
        section("Cones", free::cones(known)),
        section("Poinsot's picture", known.free().map_or_else(Vec::new, picture)),
        section("Pendulum", known.hanging.as_ref().map_or_else(Vec::new, pendulum::facts)),
        section("Heavy top", known.heavy_top.as_ref().map_or_else(Vec::new, heavy_top::facts)),
        section("Torque needed", known.needed.as_ref().map_or_else(Vec::new, required::facts)),
    ];
    if let Some(scenario) = known.scenario {
        sections.push(section("Torques and wheels", driven::facts(known, scenario)));
        if let (Some(ground), Some(states)) = (scenario.ground(), known.trajectory.channel(CONTACT)) {
            sections.push(section("Ground", contact::facts(ground, states, known.trajectory)));
        }
        if let Some(states) = known.trajectory.channel(GIMBALS) {
            sections.push(section("Gimbals", gimbals::facts(scenario.mechanism(), states, known.trajectory)));
        }
        sections.push(section("Orbit", orbit::facts(known, scenario)));
        sections.push(section("Events", event::facts(known.trajectory, scenario)));
    }
    sections.push(section("Evidence", evidence::facts(known)));
    sections.push(section("Solver", evidence::solver(known)));
    sections
}

/// Returns details for the text only; they are not in the JSON of a scenario's motion.
fn picture(free: &FreeFacts) -> Vec<Fact> {
    let facts = free::picture(&free.motion).into_iter().chain(free::dissipation(&free.motion));
    facts.map(|fact| fact.without_key().detail()).collect()
}
