//! Facts about the orbit of a body, and the pointing of its directions.

use std::f64::consts::TAU;

use polhode::motion::{Orbit, Pointing, Reference, Sample, Scenario, State};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::json::{numbers, vector};
use polhode_document::layout::printable;
use polhode_document::number::vector as shown;
use polhode_document::number::{DIGITS, number};
use serde_json::{Map, Value, json};

use super::Known;
use crate::report::global_error::{self, known_to};

/// Returns the orbit and each requested angle; at the end with the correct digits of the attitude
/// only.
pub(super) fn facts(known: &Known<'_>, scenario: &Scenario) -> Vec<Fact> {
    let samples = known.trajectory.samples();
    let error = global_error::of_attitude(known.trajectory);
    let mut facts = scenario.orbit().map_or_else(Vec::new, orbit_facts);
    for (sample, when, error) in
        known.ends().into_iter().flat_map(|[first, last]| [(first, "start", 0.0), (last, "end", error)])
    {
        let at = angles(scenario, &sample.state)
            .map(|angles| Fact::shown(format!("angles at the {when}"), angles));
        let note = "roll, pitch, yaw in the orbit's axes (3-2-1)";
        facts.extend(at.map(|fact| known_to(error, fact.within(error.to_degrees())).note(note)));
    }
    for (pointing, angles) in scenario.pointings().iter().filter_map(|p| Some((p, Angles::of(p, samples)?))) {
        let of = format!("{} of the body to {}", shown(pointing.body().to_array(), 4), to(pointing));
        let name = printable(pointing.name());
        let angle = |when: &str, angle: f64, error: f64| {
            known_to(error, Fact::shown(format!("{name} {when}"), Quantity::Angle(angle)).within(error))
        };
        let most = global_error::at(known.trajectory, angles.time).attitude;
        facts.extend([
            angle("at the start", angles.start, 0.0).note(of),
            angle("at the end", angles.end, error),
            angle("at most", angles.largest, most)
                .note(format!("at t = {} s (of the samples)", number(angles.time, DIGITS))),
        ]);
        facts.extend(angles.within.map(|share| {
            let limit = pointing
                .limit()
                .map_or_else(String::new, |limit| format!("{}°", number(limit.to_degrees(), DIGITS)));
            let share = Quantity::Number(100.0 * share, "% of the time");
            let fact = Fact::shown(format!("{name} within {limit}"), share).digits(4);
            known_to(error, fact.note("linear between samples"))
        }));
    }
    facts.push(Fact::data(
        "pointings",
        scenario.pointings().iter().map(|p| pointing_json(p, samples)).collect::<Value>(),
    ));
    facts
}

fn orbit_facts(orbit: &Orbit) -> Vec<Fact> {
    let fact = |key: &str, label: &str, value: Quantity| Fact::new(format!("orbit.{key}"), label, value);
    let km = format!("{} km", number(orbit.periapsis() / 1e3, DIGITS));
    let shape = if orbit.eccentricity() == 0.0 { "circle of radius" } else { "least distance" };
    vec![
        fact("mu_m3_s2", "µ", Quantity::Number(orbit.mu(), "m³/s²")),
        fact("eccentricity", "eccentricity", Quantity::Number(orbit.eccentricity(), "")),
        fact("periapsis_m", shape, Quantity::Data(orbit.periapsis().into(), km)),
        fact("period_s", "period", orbit.period().map(Quantity::Duration).into()),
        fact("mean_motion_rad_s", "mean motion", orbit.mean_motion().map(Quantity::Rate).into()),
        fact("start_position_m", "", Quantity::Vector(orbit.position(0.0).to_array(), "m")),
        fact("start_velocity_m_s", "", Quantity::Vector(orbit.velocity(0.0).to_array(), "m/s")),
    ]
}

/// Returns an angle at the start, at the end and at its maximum.
fn pointing_json(pointing: &Pointing, samples: &[Sample]) -> Value {
    let angles = Angles::of(pointing, samples);
    let space = match pointing.reference() {
        Reference::Space(direction) => Some(vector(*direction)),
        _ => None,
    };
    json!({
        "name": pointing.name(),
        "body": vector(pointing.body()),
        "to": space.unwrap_or_else(|| pointing.reference().name().into()),
        "start_rad": angles.map(|angles| angles.start),
        "end_rad": angles.map(|angles| angles.end),
        "largest_rad": angles.map(|angles| angles.largest),
        "largest_time_s": angles.map(|angles| angles.time),
        "limit_rad": pointing.limit(),
        "share_within": angles.and_then(|angles| angles.within),
    })
}

/// Returns an attitude in every convention; on an orbit also relative to the orbital axes.
pub(super) fn attitude(scenario: &Scenario, state: &State) -> Value {
    let of = |attitude: polhode::math::Attitude| {
        let [w, x, y, z] = attitude.canonical_quaternion();
        let mut object = Map::new();
        let mut put = |key: &str, value: Value| object.insert(key.to_owned(), value);
        put("quaternion_wxyz", numbers(&[w, x, y, z]));
        put("quaternion_xyzw", numbers(&[x, y, z, w]));
        put("euler313_rad", numbers(&attitude.euler313()));
        put("roll_pitch_yaw_rad", numbers(&attitude.roll_pitch_yaw()));
        put("mrp", numbers(&attitude.mrp()));
        put("matrix", polhode_document::json::matrix(attitude.matrix()));
        object
    };
    let mut object = of(state.attitude);
    if let Some(orbit) = scenario.orbit() {
        let angles = on_orbit(orbit, state);
        object.insert("orbit_roll_pitch_yaw_rad".to_owned(), numbers(&angles));
    }
    Value::Object(object)
}

/// Returns roll, pitch and yaw relative to the orbital axes, in degrees; `None` without an orbit.
pub(super) fn angles(scenario: &Scenario, state: &State) -> Option<Quantity> {
    let rounded = |angles: [f64; 3]| angles.map(|angle| round(angle * 360.0 / TAU));
    scenario.orbit().map(|orbit| Quantity::Vector(rounded(on_orbit(orbit, state)), "°"))
}

fn on_orbit(orbit: &Orbit, state: &State) -> [f64; 3] {
    (orbit.local_axes(state.time).inverse() * state.attitude).roll_pitch_yaw()
}

/// Rounds to a millionth of a degree. Smaller differences are rounding of the rotation with the
/// orbit.
fn round(degrees: f64) -> f64 {
    (degrees * 1e6).round() / 1e6
}

pub(crate) fn to(pointing: &Pointing) -> String {
    match pointing.reference() {
        Reference::Space(direction) => format!("{} of space", shown(direction.to_array(), 4)),
        Reference::Nadir(_) => "the nadir".to_owned(),
        Reference::Velocity(_) => "the velocity".to_owned(),
        Reference::OrbitNormal(_) => "the orbit's normal".to_owned(),
        Reference::Field(_) => "the field".to_owned(),
        other => other.name().to_owned(),
    }
}

/// Angle along a motion, rad.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Angles {
    start: f64,
    end: f64,
    pub largest: f64,
    /// Time of the maximum, s.
    pub time: f64,
    /// Share of the time within the limit, 0 … 1; `None` without a limit.
    pub within: Option<f64>,
}

impl Angles {
    /// Evaluates the angle at the samples; `None` without samples.
    pub(crate) fn of(pointing: &Pointing, samples: &[Sample]) -> Option<Self> {
        let angle = |sample: &Sample| pointing.angle(&sample.state);
        let (first, last) = (samples.first()?, samples.last()?);
        let of = |sample: &Sample| (angle(sample), sample.state.time);
        let larger = |most: (f64, f64), next: (f64, f64)| if next.0 > most.0 { next } else { most };
        let (largest, time) = samples.iter().map(of).fold(of(first), larger);
        let within = pointing.limit().map(|limit| {
            let of = |sample: &Sample| [sample.state.time, angle(sample) - limit];
            share_below(&samples.iter().map(of).collect::<Vec<_>>())
        });
        Some(Self { start: angle(first), end: angle(last), largest, time, within })
    }
}

/// Returns the share of the time in which a function, linear between (time, value), is not
/// positive.
fn share_below(points: &[[f64; 2]]) -> f64 {
    let [mut below, mut all] = [0.0; 2];
    for pair in points.windows(2) {
        let ([from, a], [to, b]) = (pair[0], pair[1]);
        let share = match (a <= 0.0, b <= 0.0) {
            (true, true) => 1.0,
            (false, false) => 0.0,
            (true, false) => a / (a - b),
            (false, true) => b / (b - a),
        };
        below += share * (to - from);
        all += to - from;
    }
    if all > 0.0 { below / all } else { f64::from(u8::from(points.iter().all(|[_, x]| *x <= 0.0))) }
}

#[cfg(test)]
mod tests {
    use super::share_below;

    #[test]
    fn the_share_counts_parts_of_intervals_by_their_length() {
        // Below: all of [0, 2], three quarters of [2, 3], none of [3, 7], a third of [7, 10].
        let points = [[0.0, -1.0], [2.0, -3.0], [3.0, 1.0], [7.0, 2.0], [10.0, -1.0]];
        assert!((share_below(&points) - 3.75 / 10.0).abs() < 1e-15);
        assert_eq!(share_below(&[[0.5, -0.1]]), 1.0);
        assert_eq!(share_below(&[[0.5, 0.1]]), 0.0);
    }
}
