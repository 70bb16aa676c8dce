//! Events, and how a motion ended, as reports show them.

use polhode::motion::{Crossing, Ending, Event, EventAction, Measure, Reference, Scenario, Trajectory};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::json::{numbers, vector};
use polhode_document::layout::printable;
use polhode_document::number::{DIGITS, number, vector as triple};
use serde_json::{Value, json};

/// Maximum number of events in the text; JSON contains all of them.
const MOST: usize = 20;

/// Describes the end of the motion in words, with the time and the event or cause; `None` if it
/// ended at the end of the run.
pub(crate) fn ending_in_words(trajectory: &Trajectory, scenario: &Scenario) -> Option<String> {
    match trajectory.ending() {
        Ending::Complete => None,
        Ending::Stopped { event, time } => {
            let name = scenario.events().get(*event).map_or("", Event::name);
            Some(format!("stopped at t = {} s by the event \"{name}\"", number(*time, DIGITS)))
        }
        Ending::Contact { change, time } => {
            Some(format!("ended at t = {} s: {change}", number(*time, DIGITS)))
        }
        Ending::Failed { time, cause } => {
            Some(format!("incomplete, and ends at t = {} s: {cause}", number(*time, DIGITS)))
        }
    }
}

/// Returns facts about the end of the motion, the events that happened, and those that did not.
pub(super) fn facts(trajectory: &Trajectory, scenario: &Scenario) -> Vec<Fact> {
    let crossings = trajectory.events();
    let ending = ending_in_words(trajectory, scenario);
    let mut facts = vec![
        Fact::data("complete", Value::from(trajectory.ending().is_complete())),
        Fact::new(
            "end",
            if ending.is_some() { "end of the run" } else { "" },
            Quantity::Data(ending_json(trajectory, scenario), ending.unwrap_or_default()),
        ),
        Fact::data("events", json(trajectory, scenario)),
    ];
    facts.extend(crossings.iter().take(MOST).map(|crossing| {
        let omega = triple(crossing.state.omega.to_array(), DIGITS);
        let sense = if crossing.rising { "rising" } else { "falling" };
        let note = format!("{}, {sense}; ω = {omega} rad/s", printable(&crossing.name));
        Fact::shown("event", format!("t = {} s", number(crossing.state.time, DIGITS))).note(note)
    }));
    if crossings.len() > MOST {
        let all = Quantity::Count(crossings.len() as u64);
        facts.push(Fact::shown("events", all).note("in all: summary.json has them"));
    }
    let has_happened = |k: usize| crossings.iter().any(|crossing| crossing.event == k);
    let missing = scenario.events().iter().enumerate().filter(|(k, _)| !has_happened(*k));
    facts.extend(missing.map(|(_, event)| Fact::shown("never happened", printable(event.name()))));
    facts
}

/// Returns `time_s`, `reason` (`end_of_run`, `event`, `contact`, `failure`), and `event` or
/// `cause`.
fn ending_json(trajectory: &Trajectory, scenario: &Scenario) -> Value {
    let last = trajectory.samples().last().map(|sample| sample.state.time);
    match trajectory.ending() {
        Ending::Complete => json!({ "time_s": last, "reason": "end_of_run", "event": null, "cause": null }),
        Ending::Stopped { event, time } => {
            let name = scenario.events().get(*event).map(Event::name);
            json!({ "time_s": time, "reason": "event", "event": name, "cause": null })
        }
        Ending::Contact { change, time } => {
            json!({ "time_s": time, "reason": "contact", "event": null, "cause": change.to_string() })
        }
        Ending::Failed { time, cause } => {
            json!({ "time_s": time, "reason": "failure", "event": null, "cause": cause.to_string() })
        }
    }
}

/// Returns every event of the scenario with the times at which it happened.
fn json(trajectory: &Trajectory, scenario: &Scenario) -> Value {
    let happened = |k: usize| -> Value {
        trajectory.events().iter().filter(|crossing| crossing.event == k).map(crossing).collect()
    };
    let one = |(k, event): (usize, &Event)| {
        json!({
            "name": event.name(),
            "measure": measure(event.measure()),
            "value": event.value(),
            "unit": event.measure().unit(),
            "direction": event.sense().name(),
            "then": action(event.action(), scenario),
            "happened": happened(k),
        })
    };
    scenario.events().iter().enumerate().map(one).collect()
}

fn crossing(crossing: &Crossing) -> Value {
    let state = &crossing.state;
    json!({
        "time_s": state.time,
        "direction": if crossing.rising { "rising" } else { "falling" },
        "attitude_wxyz": numbers(&state.attitude.canonical_quaternion()),
        "omega_body": vector(state.omega),
    })
}

fn action(action: EventAction, scenario: &Scenario) -> Value {
    match action {
        EventAction::Switch { torque, on } => {
            let name = scenario.torque_names().get(torque).cloned().flatten();
            json!({ "switch": name, "torque": torque, "on": on })
        }
        EventAction::Stop => "stop".into(),
        _ => "record".into(),
    }
}

/// Returns the measured quantity as named in scenario files, and its directions.
fn measure(measure: &Measure) -> Value {
    let along = |axes: &str, n: [f64; 3]| json!({ "of": "omega", "axes": axes, "along": numbers(&n) });
    match measure {
        Measure::Time => "time".into(),
        Measure::OmegaBody(n) => along("body", n.to_array()),
        Measure::OmegaSpace(n) => along("space", n.to_array()),
        Measure::Rate => "omega".into(),
        Measure::KineticEnergy => "kinetic_energy".into(),
        Measure::TotalEnergy => "total_energy".into(),
        Measure::Momentum => "momentum".into(),
        Measure::Tilt { body, space } => {
            let body = vector(*body);
            match space {
                Reference::Space(space) => json!({ "of": "angle", "body": body, "space": vector(*space) }),
                other => json!({ "of": "angle", "body": body, "to": other.name() }),
            }
        }
        Measure::OmegaAngle(n) => json!({ "of": "angle", "body": vector(*n), "to": "omega" }),
        Measure::MomentumAngle(n) => json!({ "of": "angle", "body": vector(*n), "to": "momentum" }),
        Measure::Nutation => "nutation".into(),
        Measure::Precession => "precession".into(),
        Measure::Spin => "spin".into(),
        Measure::Formula(_) => "formula".into(),
        Measure::Function(_) => "function".into(),
        _ => Value::Null,
    }
}
