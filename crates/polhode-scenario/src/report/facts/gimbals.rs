//! A rotor in gimbals.

use polhode::motion::gimbal::{Axis, Gimbal, GimbalState, Gimbals, Hold};
use polhode::motion::{Mechanism, Series, Trajectory};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::json::{matrix, numbers, vector};
use polhode_document::number::{DIGITS, number, vector as triple, within};
use polhode_document::unit::{angle, rate};
use serde_json::{Value, json};

use crate::report::global_error::{self, known_to};

/// Names of the axes.
const NAMES: [&str; 3] = ["outer", "inner", "rotor"];

/// Describes the mechanism, such as `it hangs in two gimbals on a base that turns`.
pub(crate) fn how(gimbals: &Gimbals) -> String {
    let base = if turning(gimbals) == 0.0 { "at rest" } else { "that turns" };
    format!("it hangs in two gimbals on a base {base}")
}

fn turning(gimbals: &Gimbals) -> f64 {
    gimbals.base().angular_velocity().norm()
}

/// Returns facts about the base, the axes and their mounting, the gimbals, and the state at both
/// ends.
pub(super) fn facts(
    mechanism: Mechanism<'_>,
    states: Series<'_, GimbalState>,
    trajectory: &Trajectory,
) -> Vec<Fact> {
    let Mechanism::Gimbals(gimbals) = mechanism else { return Vec::new() };
    let [of_outer, of_inner, of_rotor] = gimbals.axes().map(|axis| held(&axis));
    let [outer, inner] = gimbals.masses();
    let gimbal = |gimbal: &Gimbal| Quantity::Data(gimbal_json(gimbal), mass(gimbal));
    let fact = |key: &str, label: &str, value: Quantity| Fact::new(format!("gimbals.{key}"), label, value);
    let base = Quantity::Vector(gimbals.base().angular_velocity().to_array(), "rad/s");
    let mut facts = vec![
        fact("base_rate_rad_s", "ω of the base", base).shown_if(turning(gimbals) != 0.0),
        fact("gravity_m_s2", "g", Quantity::Vector(gimbals.gravity().to_array(), "m/s²")),
        fact("outer_axis", "outer axis", Quantity::Vector(gimbals.outer_axis().to_array(), ""))
            .note(format!("in the base, {of_outer}")),
        fact("inner_axis", "inner axis", Quantity::Vector(gimbals.inner_axis().to_array(), ""))
            .note(format!("with all angles zero, {of_inner}")),
        fact("rotor_axis_body", "rotor axis", Quantity::Vector(gimbals.rotor_axis().to_array(), ""))
            .note(format!("in the body, {of_rotor}")),
        fact("crossing_body_m", "", Quantity::Vector(gimbals.crossing().to_array(), "m")),
        fact("outer_gimbal", "outer gimbal", gimbal(outer)),
        fact("inner_gimbal", "inner gimbal", gimbal(inner)),
        fact("axes", "", gimbals.axes().iter().map(axis_json).collect::<Value>().into()),
        fact("energy_drift", "", Quantity::Error(trajectory.energy_drift(), "")),
        fact("start", "", state(&states.start()).into()),
        fact("final", "", states.last().as_ref().map_or(Quantity::None, |last| state(last).into())),
    ];
    if let (Some(first), Some(last)) = (states.first(), states.last()) {
        facts.extend(ends(&first, &last, global_error::of_attitude(trajectory)));
    }
    facts
}

/// Returns the axes at both ends, and the works; `error` is the error of the attitude at the end,
/// rad.
fn ends(first: &GimbalState, last: &GimbalState, error: f64) -> Vec<Fact> {
    let axis = |(k, name): (usize, &str)| {
        let holding = match last.holding[k] {
            0.0 => String::new(),
            torque => format!("; held with {} N·m", number(torque, 6)),
        };
        let [from, to] = [first, last].map(|s| s.angles[k].to_degrees());
        let (from, to) = (number(from, 6), within(to, error.to_degrees(), 6));
        known_to(error, Fact::shown(format!("{name} angle"), format!("{from}° → {to}°")))
            .note(format!("at the end {}{holding}", rate(last.rates[k])))
    };
    let works = [
        (last.damping_work, "damping"),
        (last.motor_work, "motors"),
        (last.torque_work, "constant torques"),
        (last.base_work, "the base"),
    ];
    let work = |(work, of): (f64, &str)| {
        Fact::shown("work", Quantity::Energy(work)).note(format!("of {of}")).shown_if(work != 0.0)
    };
    NAMES.into_iter().enumerate().map(axis).chain(works.map(work)).collect()
}

fn gimbal_json(gimbal: &Gimbal) -> Value {
    json!({ "inertia_about_crossing": matrix(gimbal.inertia()), "moment_kg_m": numbers(&gimbal.moment()) })
}

/// Describes an axis, such as `at 30° and 2 rad/s, damped with 0.1 N·m·s/rad`.
fn held(axis: &Axis) -> String {
    let start = angle(axis.angle());
    let mut text = match axis.hold() {
        Hold::Free => format!("free, at {start} and {}", rate(axis.rate())),
        Hold::Locked => format!("locked at {start}"),
        Hold::Driven => format!("driven at {} from {start}", rate(axis.rate())),
    };
    if axis.damping() > 0.0 {
        text.push_str(&format!(", damped with {} N·m·s/rad", number(axis.damping(), DIGITS)));
    }
    if let Some(spring) = axis.spring() {
        let stiffness = number(spring.stiffness, DIGITS);
        text.push_str(&format!(", a spring of {stiffness} N·m/rad about {}", angle(spring.rest)));
    }
    if axis.torque() != 0.0 {
        text.push_str(&format!(", turned by {} N·m", number(axis.torque(), DIGITS)));
    }
    text
}

fn mass(gimbal: &Gimbal) -> String {
    if *gimbal == Gimbal::MASSLESS {
        return "without mass".to_owned();
    }
    let [[x, ..], [_, y, _], [.., z]] = gimbal.inertia();
    let hanging = match gimbal.moment() {
        [0.0, 0.0, 0.0] => String::new(),
        moment => format!(", m c = {} kg·m", triple(moment, 6)),
    };
    format!("Ixx, Iyy, Izz = {} kg·m² about the crossing{hanging}", triple([x, y, z], 6))
}

fn axis_json(axis: &Axis) -> Value {
    let hold = match axis.hold() {
        Hold::Free => "free",
        Hold::Locked => "locked",
        Hold::Driven => "driven",
    };
    json!({
        "hold": hold,
        "angle_rad": axis.angle(),
        "rate_rad_s": axis.rate(),
        "damping_n_m_s": axis.damping(),
        "spring_n_m": axis.spring().map(|spring| spring.stiffness),
        "spring_rest_rad": axis.spring().map(|spring| spring.rest),
        "torque_n_m": axis.torque(),
    })
}

fn state(s: &GimbalState) -> Value {
    json!({
        "time_s": s.state.time,
        "angles_rad": numbers(&s.angles),
        "rates_rad_s": numbers(&s.rates),
        "holding_n_m": numbers(&s.holding),
        "momentum_space_kg_m2_s": vector(s.momentum),
        "kinetic_energy_j": s.kinetic_energy,
        "potential_energy_j": s.potential_energy,
        "spring_energy_j": s.spring_energy,
        "damping_work_j": s.damping_work,
        "motor_work_j": s.motor_work,
        "torque_work_j": s.torque_work,
        "base_work_j": s.base_work,
    })
}
