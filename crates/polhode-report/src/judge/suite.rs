//! A case of the suite, as data for the program that is to run it.

use polhode::motion::Scenario;
use serde_json::{Value, json};

use crate::json::{matrix, numbers, vector};
use crate::torque::Description;

/// A case as `suite.json` has it: the body, its start, what turns it, and what to log.
///
/// The tensor is about the centre of mass along body axes; of a body that is held, the centre of mass is given from the pivot.
pub fn suite_case(name: &str, file: &str, what: &str, scenario: &Scenario) -> Value {
    let (body, start) = (scenario.body(), scenario.start());
    let pivot = scenario.pivot().map(|pivot| vector(body.center_of_mass() - pivot));
    let torques = scenario.torques().iter().map(|model| Description::of(model).to_json());
    let wheels = scenario.wheels().iter().map(|wheel| Description::of_wheel(wheel).to_json());
    let times = scenario.run().map(|run| run.times.as_slice()).unwrap_or_default();
    let every = match times {
        [first, .., last] => Some((last - first) / (times.len() - 1) as f64),
        _ => None,
    };
    json!({
        "name": name,
        "title": scenario.title(),
        "what": what,
        "file": file,
        "mass_kg": body.mass(),
        "inertia_kg_m2": matrix(body.inertia().matrix()),
        "center_of_mass_from_pivot_m": pivot,
        "attitude_wxyz": numbers(&start.attitude.quaternion()),
        "omega_body_rad_s": vector(start.omega),
        "torques": torques.collect::<Value>(),
        "wheels": wheels.collect::<Value>(),
        "start_s": start.time,
        "duration_s": times.last().map(|last| last - start.time),
        "rows": times.len(),
        "rows_every_s": every,
    })
}
