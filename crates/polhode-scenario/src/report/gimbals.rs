//! A rotor in gimbals, in text and JSON.

use polhode::motion::channel::GIMBALS;
use polhode::motion::gimbal::{Axis, Gimbal, GimbalState, Gimbals, Hold};
use polhode::motion::{Mechanism, Scenario, Trajectory};
use polhode_document::json::{matrix, numbers, vector};
use polhode_document::layout::labelled;
use polhode_document::number::{error, number, vector as triple};
use polhode_document::unit::{DIGITS, angle, rate};
use serde_json::{Value, json};

/// What the axes are of.
const NAMES: [&str; 3] = ["outer", "inner", "rotor"];

/// `it hangs in two gimbals on a base that turns`
pub(crate) fn how(gimbals: &Gimbals) -> String {
    let base = if turning(gimbals) == 0.0 { "at rest" } else { "that turns" };
    format!("it hangs in two gimbals on a base {base}")
}

fn turning(gimbals: &Gimbals) -> f64 {
    gimbals.base().angular_velocity().norm()
}

/// The base, the axes and how they are held, the gimbals.
pub(crate) fn facts(gimbals: &Gimbals) -> Vec<(&'static str, String)> {
    let gravity = triple(gimbals.gravity().to_array(), 6);
    let base = match turning(gimbals) {
        0.0 => "at rest".to_owned(),
        _ => format!("turns at {} rad/s", triple(gimbals.base().angular_velocity().to_array(), DIGITS)),
    };
    let [outer, inner] = [gimbals.outer_axis(), gimbals.inner_axis()].map(|axis| triple(axis.to_array(), 6));
    let [outer_mass, inner_mass] = gimbals.masses().map(|gimbal| mass(&gimbal));
    let [of_outer, of_inner, of_rotor] = gimbals.axes().map(|axis| held(&axis));
    vec![
        ("base", format!("{base}; g = {gravity} m/s²")),
        ("outer gimbal", format!("axis {outer} in the base, {of_outer}; {outer_mass}")),
        ("inner gimbal", format!("axis {inner} with all angles zero, {of_inner}; {inner_mass}")),
        ("rotor", format!("axis {} in the body, {of_rotor}", triple(gimbals.rotor_axis().to_array(), 6))),
    ]
}

/// `at 30° and 2 rad/s, damped with 0.1 N·m·s/rad`
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

/// The same on the screen, with the balance of energy.
pub(crate) fn to_text(scenario: &Scenario, trajectory: &Trajectory) -> String {
    let Mechanism::Gimbals(gimbals) = scenario.mechanism() else { return String::new() };
    let mut text: String = facts(gimbals).iter().map(|(label, fact)| labelled(label, fact)).collect();
    let drift = error(trajectory.energy_drift());
    let line = format!("T + U less the work of axes and base {drift} (relative, worst sample)");
    text.push_str(&labelled("drift", &line));
    text
}

/// Axes and energy at both ends; `None` of any other motion.
pub(crate) fn ends(trajectory: &Trajectory) -> Option<String> {
    let states = trajectory.channel(GIMBALS)?;
    let (first, last) = (states.first()?, states.last()?);
    let axis = |k: usize| {
        let holding = match last.holding[k] {
            0.0 => String::new(),
            torque => format!("; held with {} N·m at the end", number(torque, 6)),
        };
        let [from, to] = [first, last].map(|s| angle(s.angles[k]));
        let line = format!("{from} → {to} at {}{holding}", rate(last.rates[k]));
        labelled(&format!("{} axis", NAMES[k]), &line)
    };
    let pair = |of: fn(&GimbalState) -> f64| format!("{} → {}", number(of(&first), 6), number(of(&last), 6));
    let mut energy =
        format!("T {} J, U {} J", pair(|s| s.kinetic_energy), pair(|s| s.potential_energy + s.spring_energy));
    let works = [
        (last.damping_work, "damping"),
        (last.motor_work, "motors"),
        (last.torque_work, "constant torques"),
        (last.base_work, "the base"),
    ];
    for (work, of) in works {
        if work != 0.0 {
            energy.push_str(&format!(", work of {of} {} J", number(work, 6)));
        }
    }
    let axes: String = (0..3).map(axis).collect();
    Some(axes + &labelled("energy", &energy))
}

/// The suspension, and the state of it at both ends.
pub(crate) fn to_json(scenario: &Scenario, trajectory: &Trajectory) -> Value {
    let (Mechanism::Gimbals(gimbals), Some(states)) = (scenario.mechanism(), trajectory.channel(GIMBALS))
    else {
        return Value::Null;
    };
    let [outer, inner] = gimbals.masses().map(|gimbal| {
        json!({ "inertia_about_crossing": matrix(gimbal.inertia()), "moment_kg_m": numbers(&gimbal.moment()) })
    });
    let axes = gimbals.axes().map(|axis| axis_json(&axis));
    json!({
        "base_rate_rad_s": vector(gimbals.base().angular_velocity()),
        "gravity_m_s2": vector(gimbals.gravity()),
        "outer_axis": vector(gimbals.outer_axis()),
        "inner_axis": vector(gimbals.inner_axis()),
        "rotor_axis_body": vector(gimbals.rotor_axis()),
        "crossing_body_m": vector(gimbals.crossing()),
        "outer_gimbal": outer,
        "inner_gimbal": inner,
        "axes": axes,
        "energy_drift": trajectory.energy_drift(),
        "start": state(&states.start()),
        "final": states.last().as_ref().map_or(Value::Null, state),
    })
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
