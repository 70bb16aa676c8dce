//! Torques, wheels and changing mass.

use polhode::motion::{Scenario, Wheel};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::layout::printable;
use polhode_document::number::{has_digits, number, within};
use serde_json::Value;

use super::Known;
use crate::report::torque::{Description, off_at_start, wheel_name};
use crate::report::{global_error, history};

pub(super) fn facts(known: &Known<'_>, scenario: &Scenario) -> Vec<Fact> {
    let torques: Value = (0..scenario.torques().len()).map(|k| torque_json(scenario, k)).collect();
    let wheels: Value =
        scenario.wheels().iter().enumerate().map(|(k, w)| wheel_json(known, scenario, k, w)).collect();
    let mut facts = vec![Fact::data("torques", torques), Fact::data("wheels", wheels)];
    facts.extend(scenario.torques().iter().enumerate().map(|(k, model)| {
        let name = scenario.torque_names().get(k).cloned().flatten();
        let name = name.map_or_else(String::new, |name| format!("{}: ", printable(&name)));
        let description = Description::of(model);
        let notes = [Some(format!("model {}", description.model)), off_at_start(scenario, k)];
        let notes: Vec<String> = notes.into_iter().flatten().collect();
        Fact::shown("torque", name + &description.text_beside(scenario.orbit())).note(notes.join(", "))
    }));
    let mass = scenario.history().map(|history| {
        let ends = [scenario.start().time, known.end_time()];
        Quantity::Data(history::to_json(history, known.end_time()), history::in_words(history, ends))
    });
    facts.push(Fact::new("mass_history", "mass", mass));
    for (k, wheel) in scenario.wheels().iter().enumerate() {
        let name = printable(&wheel_name(scenario, k));
        facts.push(Fact::shown(name.clone(), Description::of_wheel(wheel).text()));
        facts.extend(at_both_ends(known, wheel, &name).into_iter().flatten());
    }
    facts
}

/// Returns the momentum and speed of a wheel at both ends; `None` for a wheel with a held speed.
fn at_both_ends(known: &Known<'_>, wheel: &Wheel, name: &str) -> Option<[Fact; 2]> {
    let ends = known.ends()?.map(|sample| sample.state);
    let [Some(slow), Some(fast)] = ends.map(|s| wheel.speed_at(s.time, s.omega)) else { return None };
    let [least, most] = ends.map(|s| number(wheel.momentum_at(s.time), 6));
    // The speed at the end depends on ω of the body, so it has the error of ω.
    let error = global_error::of_omega(known.trajectory);
    let rpm = |speed: f64| 60.0 * speed / std::f64::consts::TAU;
    let end = match has_digits(fast.abs(), error) {
        true => format!("{} rad/s ({} rpm)", within(fast, error, 6), within(rpm(fast), rpm(error), 4)),
        false => "unknown".to_owned(),
    };
    Some([
        Fact::shown(format!("h of {name}"), format!("{least} → {most} kg·m²/s")).note("along its axis"),
        Fact::shown(format!("Ω of {name}"), format!("{} → {end}", number(slow, 6))).note("in the body"),
    ])
}

/// Returns a torque with its name, and true if it is on at the start.
fn torque_json(scenario: &Scenario, k: usize) -> Value {
    let mut object = scenario.torques().get(k).map(|model| Description::of(model).json()).unwrap_or_default();
    object.insert("name".to_owned(), scenario.torque_names().get(k).cloned().flatten().into());
    object.insert("on".to_owned(), (!scenario.switched_off().contains(&k)).into());
    Value::Object(object)
}

/// Returns a wheel with its momentum and speed at the start and at the end.
fn wheel_json(known: &Known<'_>, scenario: &Scenario, k: usize, wheel: &Wheel) -> Value {
    let start = known.trajectory.start().state;
    let end = known.ends().map(|[_, last]| last.state);
    let mut object = Description::of_wheel(wheel).json();
    object.insert("name".to_owned(), scenario.wheel_name(k).into());
    let mut put = |key: &str, value: Option<f64>| object.insert(key.to_owned(), value.into());
    put("speed_rad_s", wheel.speed_at(start.time, start.omega));
    put("final_momentum_kg_m2_s", end.map(|end| wheel.momentum_at(end.time)));
    put("final_speed_rad_s", end.and_then(|end| wheel.speed_at(end.time, end.omega)));
    Value::Object(object)
}
