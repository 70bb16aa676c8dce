//! Facts about the motion: its time, its kind, its state and energy at both ends.

use polhode::motion::channel::ENERGY;
use polhode::motion::{Mechanism, MethodReason, Sample, Scenario, Solution, State, StateError};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::json::{matrix, vector};
use polhode_document::number::{count, has_digits, number};
use polhode_document::unit::{duration, rate_within};
use polhode_shape::report::block;
use serde_json::json;

use super::{Known, free, orbit};
use crate::report::global_error::{self, known_to};

pub(super) fn facts(known: &Known<'_>) -> Vec<Fact> {
    let mut facts = turns_about(known);
    if let Some([first, last]) = known.ends() {
        let samples = known.trajectory.samples().len() as u64;
        let noun = if samples == 1 { "sample" } else { "samples" };
        let time = format!("{} … {}", number(first.state.time, 6), duration(last.state.time, 6));
        facts.push(
            Fact::shown("time", time).note(format!("{} {noun}, {}", count(samples), how(known))).detail(),
        );
    }
    facts.extend(free::facts(known));
    facts.extend(ends(known));
    facts.extend(energy(known));
    facts
}

/// Describes the method, such as `closed form` or `integrated by the Taylor series`.
pub(crate) fn how(known: &Known<'_>) -> String {
    match known.trajectory.solution() {
        Solution::ClosedForm(_) => "closed form".to_owned(),
        Solution::Prescribed(_) => "prescribed motion".to_owned(),
        _ if *known.trajectory.reason() == MethodReason::Contact => "integrated phase by phase".to_owned(),
        solution => format!("integrated by {}", solution.title()),
    }
}

/// Returns the reference point of L, T, N and the tensor of the motion.
fn turns_about(known: &Known<'_>) -> Vec<Fact> {
    let (Some(rotor), Some(scenario)) = (&known.rotor, known.scenario) else { return Vec::new() };
    let about = json!({
        "what": if scenario.pivot().is_some() { "pivot" } else { "center_of_mass" },
        "point": vector(rotor.point()),
        "tensor": matrix(rotor.inertia().matrix()),
        "principal": block::principal(rotor.principal()),
    });
    vec![Fact::data("turns_about", about)]
}

/// Returns the state at the start and at the end.
fn ends(known: &Known<'_>) -> Vec<Fact> {
    let none = StateError { attitude: 0.0, omega: 0.0 };
    let mut facts = state("start", " at the start", known.scenario, &known.start, none);
    facts.push(Fact::data("start.momentum_space", Quantity::Vector(known.momentum.to_array(), "kg·m²/s")));
    let velocity = known.scenario.map(|scenario| Quantity::Vector(scenario.velocity().to_array(), "m/s"));
    facts.push(Fact::data("start.velocity_space", velocity));
    let last = known.trajectory.samples().last();
    facts.extend(last.map_or_else(Vec::new, |last| {
        let error = known.trajectory.error().map_or(none, polhode::motion::GlobalError::end);
        let facts = sample("final", " at the end", known.scenario, last, error);
        let is_alone = known.trajectory.samples().len() < 2;
        facts.into_iter().map(|fact| fact.shown_if(!is_alone)).collect()
    }));
    facts
}

/// Returns the state, momentum and torque of a sample.
fn sample(
    key: &str,
    when: &str,
    scenario: Option<&Scenario>,
    sample: &Sample,
    error: StateError,
) -> Vec<Fact> {
    let mut facts = state(key, when, scenario, &sample.state, error);
    let mut put = |name: &str, v: [f64; 3], unit| {
        facts.push(Fact::data(format!("{key}.{name}"), Quantity::Vector(v, unit)));
    };
    put("momentum_space", sample.momentum.to_array(), "kg·m²/s");
    put("torque_body", sample.torque.to_array(), "N·m");
    facts
}

fn state(key: &str, when: &str, scenario: Option<&Scenario>, state: &State, error: StateError) -> Vec<Fact> {
    let path = |name: &str| format!("{key}.{name}");
    let size = state.omega.norm();
    let omega_error = error.omega * size;
    let note = match has_digits(size, omega_error) {
        true => format!("in body axes, |ω| = {}", rate_within(size, omega_error)),
        false => "in body axes".to_owned(),
    };
    let attitude = Quantity::Attitude(state.attitude.canonical_quaternion());
    let in_all_conventions = scenario.map(|scenario| Quantity::from(orbit::attitude(scenario, state)));
    let omega = Quantity::Vector(state.omega.to_array(), "rad/s");
    vec![
        Fact::data(path("time_s"), Quantity::Duration(state.time)),
        Fact::new(path("attitude_wxyz"), format!("attitude{when}"), attitude)
            .within(error.attitude)
            .note("as w, x, y, z")
            .shown_if(key != "start"),
        Fact::data(path("attitude"), in_all_conventions),
        Fact::new(path("omega_body"), format!("ω{when}"), omega).within(omega_error).note(note),
        Fact::data(path("omega_space"), Quantity::Vector(state.omega_space().to_array(), "rad/s")),
    ]
}

/// Returns a requested state: a section of the text, and an element of the JSON list `at`.
pub(crate) fn state_at(known: &Known<'_>, at: &Sample) -> Vec<Fact> {
    let error = global_error::at(known.trajectory, at.state.time);
    let mut facts = sample("at", "", known.scenario, at, error);
    let on_orbit = known.scenario.and_then(|scenario| orbit::angles(scenario, &at.state));
    facts.extend(on_orbit.map(|angles| {
        let fact = Fact::shown("roll, pitch, yaw", angles).within(error.attitude.to_degrees());
        known_to(error.attitude, fact).note("in the orbit's axes")
    }));
    facts
}

/// Returns the energies at both ends. On the ground they include the centre of mass, in gimbals the
/// springs.
fn energy(known: &Known<'_>) -> Vec<Fact> {
    let energy = known.trajectory.channel(ENERGY);
    let (first, last) = (energy.and_then(|energy| energy.first()), energy.and_then(|energy| energy.last()));
    let mechanism = known.scenario.map_or(Mechanism::Rotor, Scenario::mechanism);
    let is_rotor = mechanism == Mechanism::Rotor;
    // T is proportional to ω²; T + U changes by the work, so U has the error of T.
    let error = known.trajectory.error().map_or(0.0, |estimate| 2.0 * estimate.end().omega);
    let acts = !known.is_free && known.trajectory.samples().len() > 1;
    let fact = |key: &str, label: &str, joule: Option<f64>| {
        Fact::new(format!("energy.{key}"), label, joule.map(Quantity::Energy)).shown_if(acts)
    };
    let kinetic_end = last.map(|e| e.kinetic);
    let error = error * kinetic_end.unwrap_or_default();
    vec![
        fact("kinetic_start_j", "T at the start", first.map(|e| e.kinetic)).shown_if(acts && !is_rotor),
        fact("kinetic_end_j", "T at the end", kinetic_end).within(error),
        fact("potential_start_j", "U at the start", first.and_then(|e| e.potential)),
        known_to(
            global_error::of_attitude(known.trajectory),
            fact("potential_end_j", "U at the end", last.and_then(|e| e.potential)).within(error),
        ),
        fact("work_j", "work done", last.map(|e| e.work)).within(error).shown_if(acts && is_rotor),
    ]
}
