//! Columns of outcomes: names, units, descriptions.

use polhode::motion::{Event, Scenario};

use super::member::{Outcome, Pointed, Status};
use crate::batch::{Column, Values};

/// Column of numbers: name, unit, description, and the function that returns its value.
type Number = (&'static str, &'static str, &'static str, fn(&Outcome) -> Option<f64>);

/// Returns the columns of outcomes for a plan with this scenario.
pub(crate) fn of(nominal: &Scenario, outcomes: &[Outcome]) -> Vec<Column> {
    let events = nominal.events();
    let text = |name: &str, description: &str, value: fn(&Outcome) -> Option<String>| {
        Column::new([name, "", description], Values::Text(outcomes.iter().map(value).collect()))
    };
    let number = |[name, unit, description]: [&str; 3], value: &dyn Fn(&Outcome) -> Option<f64>| {
        Column::new([name, unit, description], Values::Perhaps(outcomes.iter().map(value).collect()))
    };
    let mut columns = vec![
        text("status", "complete, stopped: EVENT, or failed", |o| Some(o.status.to_string())),
        text("cause", "reason of the failure", |o| o.cause.clone()),
        text("regime", REGIME, |o| o.regime.map(|regime| regime.name().to_owned())),
        text("end_regime", END_REGIME, |o| o.end_regime.map(|regime| regime.name().to_owned())),
    ];
    columns.extend(NUMBERS.iter().map(|(name, unit, what, value)| number([name, unit, what], value)));
    for (k, stem) in stems(events).into_iter().enumerate() {
        let of = |outcome: &Outcome| outcome.events.get(k).copied();
        let name = events.get(k).map_or("", Event::name);
        let (count, how_often) =
            (format!("{stem}_count"), format!("number of occurrences of event \"{name}\""));
        columns.push(number([&count, "", &how_often], &|o| Some(of(o)?.count.into())));
        let (first, when) = (format!("{stem}_first_s"), format!("time of the first event \"{name}\""));
        columns.push(number([&first, "s", &when], &|o| of(o)?.first));
    }
    for (k, pointing) in nominal.pointings().iter().enumerate() {
        let stem = pointing.name().to_ascii_lowercase();
        let mut put = |name: &str, description: String, value: fn(&Pointed) -> f64| {
            let name = format!("{stem}_{name}_angle_rad");
            columns.push(number([&name, "rad", &description], &|o| o.pointings.get(k).map(value)));
        };
        let of = format!("angle of pointing \"{}\"", pointing.name());
        put("largest", format!("largest {of} over the samples"), |p| p.largest);
        put("least", format!("smallest {of} over the samples"), |p| p.least);
        put("end", format!("{of} at the end"), |p| p.end);
    }
    columns
}

const REGIME: &str = "kind of free motion of the initial state: at_rest, permanent, symmetric, long_axis, short_axis or \
    separatrix; empty with wheels or for prescribed motion";
const END_REGIME: &str = "kind of free motion of the final state";

const NUMBERS: [Number; 35] = [
    ("mass_kg", "kg", "mass", |o| o.mass),
    ("moment_1_kg_m2", "kg·m²", MOMENT, |o| o.moments.map(|[i1, _, _]| i1)),
    ("moment_2_kg_m2", "kg·m²", MOMENT, |o| o.moments.map(|[_, i2, _]| i2)),
    ("moment_3_kg_m2", "kg·m²", MOMENT, |o| o.moments.map(|[_, _, i3]| i3)),
    ("period_s", "s", "free motion: period of omega in body axes", |o| o.free?.regime.period),
    ("precession_period_s", "s", "free motion: mean period of precession about L", |o| {
        o.free?.periods.precession
    }),
    ("rotation_period_s", "s", "free motion: period of rotation about the body axis that L circles", |o| {
        o.free?.periods.rotation
    }),
    ("flip_interval_s", "s", "free motion: time between flips along the intermediate axis", |o| {
        o.free?.regime.flip_interval
    }),
    ("growth_rate_per_s", "1/s", "free motion near the intermediate axis: growth rate of a deviation", |o| {
        o.free?.regime.growth_rate
    }),
    ("start_kinetic_energy_j", "J", "rotational kinetic energy at the start", |o| {
        Some(o.start?.kinetic_energy)
    }),
    ("start_momentum_kg_m2_s", "kg·m²/s", "|L| at the start", |o| Some(o.start?.momentum)),
    ("end_kinetic_energy_j", "J", "rotational kinetic energy at the end", |o| Some(o.end?.kinetic_energy)),
    ("end_momentum_kg_m2_s", "kg·m²/s", "|L| at the end", |o| Some(o.end?.momentum)),
    ("end_time_s", "s", "time of the final state", |o| Some(o.end?.state.time)),
    ("end_attitude_w", "", ATTITUDE, |o| Some(o.end?.state.attitude.canonical_quaternion()[0])),
    ("end_attitude_x", "", ATTITUDE, |o| Some(o.end?.state.attitude.canonical_quaternion()[1])),
    ("end_attitude_y", "", ATTITUDE, |o| Some(o.end?.state.attitude.canonical_quaternion()[2])),
    ("end_attitude_z", "", ATTITUDE, |o| Some(o.end?.state.attitude.canonical_quaternion()[3])),
    ("end_omega_body_x_rad_s", "rad/s", OMEGA, |o| Some(o.end?.state.omega.x)),
    ("end_omega_body_y_rad_s", "rad/s", OMEGA, |o| Some(o.end?.state.omega.y)),
    ("end_omega_body_z_rad_s", "rad/s", OMEGA, |o| Some(o.end?.state.omega.z)),
    (
        "least_omega_rad_s",
        "rad/s",
        "smallest |omega|, over all time for free motion, else over the samples",
        |o| Some(o.extrema?.omega?[0]),
    ),
    (
        "largest_omega_rad_s",
        "rad/s",
        "largest |omega|, over all time for free motion, else over the samples",
        |o| Some(o.extrema?.omega?[1]),
    ),
    ("least_angle_to_axis_1_rad", "rad", AXIS_1, |o| Some(o.extrema?.from_least?[0])),
    ("largest_angle_to_axis_1_rad", "rad", AXIS_1, |o| Some(o.extrema?.from_least?[1])),
    ("least_angle_to_axis_3_rad", "rad", AXIS_3, |o| Some(o.extrema?.from_greatest?[0])),
    ("largest_angle_to_axis_3_rad", "rad", AXIS_3, |o| Some(o.extrema?.from_greatest?[1])),
    ("largest_torque_n_m", "N·m", "largest torque |N| over the samples", |o| o.extrema?.torque),
    ("energy_drift", "", "error of the work-energy theorem, relative to the largest kinetic energy", |o| {
        o.extrema?.energy_drift
    }),
    (
        "momentum_drift",
        "",
        "error of the angular impulse-momentum theorem, relative to the largest |L|",
        |o| o.extrema?.momentum_drift,
    ),
    ("error_attitude_rad", "rad", "estimated error of the final attitude; pi if unknown", |o| {
        Some(o.error?.attitude)
    }),
    ("error_omega", "", "estimated relative error of the final omega; empty if unknown", |o| {
        Some(o.error?.omega).filter(|omega| omega.is_finite())
    }),
    ("steps_accepted", "", "accepted integration steps", |o| Some(o.steps?.accepted as f64)),
    ("steps_rejected", "", "rejected integration steps, repeated with a smaller step size", |o| {
        Some(o.steps?.rejected as f64)
    }),
    ("evaluations", "", "evaluations of the equations of motion", |o| Some(o.steps?.evaluations as f64)),
];

const MOMENT: &str =
    "principal moment of inertia about the centre of rotation (fixed point or centre of mass), ascending";
const ATTITUDE: &str = "final attitude: R_space_body as a unit quaternion, Hamilton, scalar first, w >= 0";
const OMEGA: &str = "final angular velocity relative to space, along body axes";
const AXIS_1: &str = "angle between L and the principal axis of the smallest moment, over all time for free motion, else over the samples";
const AXIS_3: &str = "angle between L and the principal axis of the largest moment, over all time for free motion, else over the samples";

/// Returns the column prefix of each event: its name in letters, digits and `_`, with its number if
/// names coincide.
fn stems(events: &[Event]) -> Vec<String> {
    let plain = |event: &Event| {
        let letters = event.name().chars().map(|c| if c.is_alphanumeric() { c } else { '_' });
        let name: String = letters.flat_map(char::to_lowercase).collect();
        name.split('_').filter(|word| !word.is_empty()).collect::<Vec<_>>().join("_")
    };
    let names: Vec<String> = events.iter().map(plain).collect();
    let alone = |name: &String| !name.is_empty() && names.iter().filter(|other| *other == name).count() == 1;
    let stem = |(k, name): (usize, &String)| {
        if alone(name) { format!("event_{name}") } else { format!("event_{}_{name}", k + 1) }
    };
    names.iter().enumerate().map(stem).map(|stem| stem.trim_end_matches('_').to_owned()).collect()
}

impl std::fmt::Display for Status {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Complete => f.write_str("complete"),
            Self::Stopped(event) => write!(f, "stopped: {event}"),
            Self::Failed => f.write_str("failed"),
        }
    }
}
