//! The orbit of a body, and where its directions point.

use std::f64::consts::TAU;

use polhode::motion::{Orbit, Pointing, Reference, Sample, Scenario, State};
use polhode_document::json::{numbers, vector};
use polhode_document::layout::labelled;
use polhode_document::number::vector as shown;
use polhode_document::number::{has_digits, number};
use serde_json::{Map, Value, json};

use crate::global_error::LARGEST_ATTITUDE;

/// The orbit, and each of the angles that are of interest; of the attitude at the end, which has an error (rad), the digits that are right.
pub(crate) fn to_text(scenario: &Scenario, samples: &[Sample], error: f64) -> String {
    let is_known = has_digits(LARGEST_ATTITUDE, error);
    let mut text = scenario.orbit().map_or_else(String::new, |orbit| labelled("orbit", &in_words(orbit)));
    if let (Some(orbit), [first, .., last]) = (scenario.orbit(), samples) {
        let [from, to] = [first, last].map(|sample| degrees(on_orbit(orbit, &sample.state)));
        let to = if is_known { to } else { "(unknown)".to_owned() };
        text.push_str(&labelled("", &format!("roll, pitch, yaw {from} → {to}°, in its axes (3-2-1)")));
    }
    for pointing in scenario.pointings() {
        let Some(angles) = Angles::of(pointing, samples) else { continue };
        let [start, end, largest] =
            [angles.start, angles.end, angles.largest].map(|angle| number(angle.to_degrees(), 4));
        let end = if is_known { format!("{end}°") } else { "unknown".to_owned() };
        let line = format!(
            "{} of the body to {}: {start}° → {end}, at most {largest}° at t = {} s (of the samples)",
            shown(pointing.body().to_array(), 4),
            to(pointing),
            number(angles.time, 6),
        );
        text.push_str(&labelled(pointing.name(), &line));
    }
    text
}

/// The orbit as an object; `null` without one.
pub(crate) fn to_json(scenario: &Scenario) -> Value {
    scenario.orbit().map_or(Value::Null, |orbit| {
        json!({
            "mu_m3_s2": orbit.mu(),
            "eccentricity": orbit.eccentricity(),
            "periapsis_m": orbit.periapsis(),
            "period_s": orbit.period(),
            "mean_motion_rad_s": orbit.mean_motion(),
            "start_position_m": vector(orbit.position(0.0)),
            "start_velocity_m_s": vector(orbit.velocity(0.0)),
        })
    })
}

/// Each of the angles that are of interest, at the start, at the end and where it is largest.
pub(crate) fn pointings(scenario: &Scenario, samples: &[Sample]) -> Value {
    let one = |pointing: &Pointing| {
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
        })
    };
    scenario.pointings().iter().map(one).collect()
}

/// An attitude in every convention; on an orbit that relative to its axes too.
pub(crate) fn attitude(scenario: &Scenario, state: &State) -> Value {
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

/// Roll, pitch and yaw in the orbit's axes, in degrees; `None` without an orbit.
pub(crate) fn angles_in_words(scenario: &Scenario, state: &State) -> Option<String> {
    scenario.orbit().map(|orbit| degrees(on_orbit(orbit, state)))
}

/// `circle of radius 6878.1 km, once in 5677 s (94.62 min)`
fn in_words(orbit: &Orbit) -> String {
    let km = |length: f64| number(length / 1e3, 6);
    let shape = match orbit.eccentricity() {
        0.0 => format!("circle of radius {} km", km(orbit.periapsis())),
        e => format!("eccentricity {}, least distance {} km", number(e, 6), km(orbit.periapsis())),
    };
    match (orbit.period(), orbit.mean_motion()) {
        (Some(period), Some(rate)) => {
            let rate = number(rate, 6);
            format!(
                "{shape}, once in {} s ({} min), n = {rate} rad/s",
                number(period, 6),
                number(period / 60.0, 4)
            )
        }
        _ => format!("{shape}, not closed"),
    }
}

fn on_orbit(orbit: &Orbit, state: &State) -> [f64; 3] {
    (orbit.local_axes(state.time).inverse() * state.attitude).roll_pitch_yaw()
}

/// `(0.5, −1.2, 30)`
fn degrees(angles: [f64; 3]) -> String {
    shown(angles.map(|angle| round(angle * 360.0 / TAU)), 4)
}

/// What is below a millionth of a degree is rounding of what turns with the orbit.
fn round(degrees: f64) -> f64 {
    (degrees * 1e6).round() / 1e6
}

fn to(pointing: &Pointing) -> String {
    match pointing.reference() {
        Reference::Space(direction) => format!("{} of space", shown(direction.to_array(), 4)),
        Reference::Nadir(_) => "the nadir".to_owned(),
        Reference::Velocity(_) => "the velocity".to_owned(),
        Reference::OrbitNormal(_) => "the orbit's normal".to_owned(),
        Reference::Field(_) => "the field".to_owned(),
        other => other.name().to_owned(),
    }
}

/// An angle along a motion, rad.
#[derive(Clone, Copy, Debug)]
struct Angles {
    start: f64,
    end: f64,
    largest: f64,
    /// When it is largest, s.
    time: f64,
}

impl Angles {
    /// `None` without samples.
    fn of(pointing: &Pointing, samples: &[Sample]) -> Option<Self> {
        let angle = |sample: &Sample| pointing.angle(&sample.state);
        let (first, last) = (samples.first()?, samples.last()?);
        let of = |sample: &Sample| (angle(sample), sample.state.time);
        let larger = |most: (f64, f64), next: (f64, f64)| if next.0 > most.0 { next } else { most };
        let (largest, time) = samples.iter().map(of).fold(of(first), larger);
        Some(Self { start: angle(first), end: angle(last), largest, time })
    }
}
