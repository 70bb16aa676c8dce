//! Facts about an equilibrium and the small oscillations about it.

use polhode::motion::{MotionError, TopPath};
use polhode::observe::{OrbitalEquilibrium, OscillationMode, SmallOscillations, SteadyTop};
use polhode_document::fact::{Fact, Facts, Quantity, object};
use polhode_document::number::{number, vector};
use serde_json::{Value, json};

use super::search::{Found, Place, Prevented};
use super::words::{fact, rates, torques, verdict};

/// Rounding threshold of an angle, rad, and of the relative difference of two ω.
pub(crate) const ROUNDING: f64 = 1e-12;

/// Angle between the principal axes and the orbital axes, rad, above which the body is reported as
/// tilted.
const SKEW: f64 = 1e-6;

/// Threshold of the minor semi-axis of a mode, below which it oscillates about one axis.
const STRAIGHT: f64 = 1e-6;

/// Keys of the JSON of an equilibrium.
const KEYS: [&str; 11] = [
    "equilibrium",
    "turned_from_start",
    "omega_from_start",
    "attitude_wxyz",
    "omega_body",
    "stable",
    "neutral",
    "modes",
    "top",
    "other_top",
    "on_orbit",
];

/// Returns the sections about an equilibrium, under a key of the JSON.
pub(crate) fn facts(key: &str, title: &str, when: &str, found: &Found) -> Vec<Facts> {
    let path = |name: &str| format!("{key}.{name}");
    let (top, other) = match &found.place {
        Place::Top(top, other) => (Some(top.as_ref()), other.as_deref()),
        _ => (None, None),
    };
    let mut facts = vec![Fact::data(key, Value::Object(object(&KEYS, &[])))];
    facts.extend(equilibrium(key, found));
    facts.extend(steady_top(&path("top"), "", top));
    facts.extend(steady_top(&path("other_top"), "other steady motion", other));
    let heavy = found.heavy.filter(|heavy| heavy.spin() != 0.0 && heavy.sleeping_threshold().is_finite());
    facts.push(spin(heavy.map(|heavy| heavy.spin()), "").shown_if(top.is_none()));
    let threshold = heavy.map(|heavy| Quantity::Rate(heavy.sleeping_threshold()));
    facts.push(fact("", "sleeping from", threshold).note("sleeping-top threshold 2 √(M g l A)/C"));
    facts.push(fact(&path("modes"), "mode", modes(&found.oscillations)));
    let section = |title: &str, facts| Facts::new(format!("{title}{when}"), facts);
    let on_orbit = Quantity::Table(on_orbit(found));
    let on_orbit = fact(&path("on_orbit"), "principal axes vertical, along flight, along normal", on_orbit);
    vec![section(title, facts), section("Attitudes at rest relative to the orbit", vec![on_orbit])]
}

/// Returns the equilibrium and its distance from the start.
fn equilibrium(key: &str, found: &Found) -> Vec<Fact> {
    let oscillations = &found.oscillations;
    let state = &oscillations.equilibrium;
    let is_start = matches!(found.place, Place::Start);
    let turns = found.omega_off > ROUNDING * state.omega.norm();
    let path = |name: &str| format!("{key}.{name}");
    let (name, words) = place(&found.place);
    let in_body_axes = match &found.place {
        Place::Orbit(orbital) => Some(in_body_axes(orbital)),
        _ => None,
    };
    let attitude = Quantity::Attitude(state.attitude.canonical_quaternion());
    vec![
        fact(&path("equilibrium"), "equilibrium", Quantity::Word(name, words)),
        fact(&path("turned_from_start"), "angle to the start", Quantity::Angle(found.turned))
            .shown_if(!is_start && found.turned > ROUNDING),
        fact(&path("omega_from_start"), "Δω to the start", Quantity::Rate(found.omega_off))
            .shown_if(!is_start && turns),
        fact("", "orbit's axes", in_body_axes.map(Quantity::Text)).note("in body axes").detail(),
        Fact::new(path("attitude_wxyz"), "attitude", attitude).note("as w, x, y, z").detail(),
        fact(&path("omega_body"), "ω", Quantity::Vector(state.omega.to_array(), "rad/s"))
            .note("in body axes")
            .detail(),
        Fact::data(path("stable"), Value::from(oscillations.is_stable())),
        fact(&path("neutral"), "zero rates", Quantity::Count(oscillations.neutral as u64))
            .note("of 6: changes of orientation or of rotation without a torque")
            .shown_if(oscillations.neutral > 0)
            .detail(),
    ]
}

/// Returns the name of the kind of equilibrium in the JSON, and the kind in words.
fn place(place: &Place) -> (&'static str, String) {
    let (name, words) = match place {
        Place::Start => ("start", "the start"),
        Place::Orbit(nearest) => {
            let words = format!("nearest attitude at rest relative to the orbit: {}", arrangement(nearest));
            return ("on_orbit", words);
        }
        Place::Top(top, _) => ("top", kind(top)),
        Place::Nearest => ("nearest", "nearest with the start's ω in space"),
        Place::Vertical => ("nearest_about_the_vertical", "nearest that rotates about the vertical"),
        Place::Rest => ("nearest_at_rest", "nearest at rest"),
    };
    (name, words.to_owned())
}

/// Returns the torques that prevent an equilibrium.
pub(crate) fn prevented(prevented: &Prevented) -> Vec<Fact> {
    let rest = match &prevented.error {
        MotionError::NotSteady { torque, scale } => {
            let [torque, scale] = [torque, scale].map(|x| number(*x, 4));
            format!("{torque} N·m, of torques of {scale} N·m in all")
        }
        error => error.to_string(),
    };
    let by = Quantity::Data(json!(prevented.by), torques(&prevented.by));
    vec![
        fact("prevented_by", "prevented by", by).shown_if(!prevented.by.is_empty()),
        fact("", "unbalanced", rest),
    ]
}

/// Returns the facts about a steady motion of a heavy top, or `null`; `label` is empty for the main
/// motion of the section.
fn steady_top(key: &str, label: &str, top: Option<&SteadyTop>) -> Vec<Fact> {
    let Some(top) = top else { return vec![Fact::data(key, Quantity::None)] };
    let path = |name: &str| format!("{key}.{name}");
    let word = Quantity::Word(top.path.name(), kind(top).to_owned());
    let is_inclined = top.precession != 0.0;
    let of_other = if label.is_empty() { "" } else { "of that motion" };
    let stable = Quantity::Data(top.oscillations.is_stable().into(), verdict(&pairs(&top.oscillations)));
    vec![
        fact(&path("path"), label, word),
        fact(&path("nutation_rad"), "inclination", Quantity::Angle(top.angle))
            .note(of_other)
            .shown_if(is_inclined),
        fact(&path("precession_rad_s"), "precession", Quantity::Rate(top.precession))
            .note(of_other)
            .shown_if(is_inclined),
        spin(Some(top.spin), &path("spin_rad_s")).shown_if(label.is_empty()),
        fact(&path("stable"), "stability", stable).note(of_other).shown_if(!label.is_empty()),
        Fact::data(path("modes"), modes(&top.oscillations)),
    ]
}

fn spin(rate: Option<f64>, key: &str) -> Fact {
    fact(key, "spin about the axis", rate.map(Quantity::Rate)).note("ω along the axis")
}

const fn kind(top: &SteadyTop) -> &'static str {
    match top.path {
        TopPath::Sleeping { stable: true } => "sleeping top",
        TopPath::Sleeping { stable: false } => "upright, below the sleeping-top threshold",
        path => path.description(),
    }
}

/// Returns frequency (rad/s) and growth rate (1/s) of each mode.
pub(crate) fn pairs(oscillations: &SmallOscillations) -> Vec<[f64; 2]> {
    oscillations.modes.iter().map(|mode| [mode.frequency, mode.growth_rate]).collect()
}

/// Describes the attitude, such as `axis 1 down, axis 2 ahead, axis 3 along the normal`.
pub(crate) fn arrangement(equilibrium: &OrbitalEquilibrium) -> String {
    let names = [["up", "down"], ["ahead", "astern"], ["along the normal", "against the normal"]];
    let one = |((k, is_along), [along, against]): ((usize, bool), [&str; 2])| {
        format!("axis {} {}", k + 1, if is_along { along } else { against })
    };
    let about = if equilibrium.tilt > SKEW {
        format!(" (to {}°)", number(equilibrium.tilt.to_degrees(), 3))
    } else {
        String::new()
    };
    equilibrium.axes.into_iter().zip(names).map(one).collect::<Vec<_>>().join(", ") + &about
}

fn in_body_axes(equilibrium: &OrbitalEquilibrium) -> String {
    let shown = |v: [f64; 3]| vector(tidy(v), 6);
    format!(
        "up {}, ahead {}, normal {}",
        shown(equilibrium.up.to_array()),
        shown(equilibrium.ahead.to_array()),
        shown(equilibrium.normal.to_array())
    )
}

/// Returns a row for each attitude at rest relative to the orbit. The text has one row for
/// attitudes with the same principal axes and stability.
fn on_orbit(found: &Found) -> Vec<Facts> {
    let kind = |(equilibrium, oscillations): &(OrbitalEquilibrium, SmallOscillations)| {
        let growth_rate = oscillations.modes.iter().map(|mode| mode.growth_rate).fold(0.0, f64::max);
        (equilibrium.axes.map(|(k, _)| k + 1), growth_rate, number(growth_rate, 4))
    };
    let kinds: Vec<([usize; 3], f64, String)> = found.on_orbit.iter().map(kind).collect();
    let row = |(k, (equilibrium, oscillations)): (usize, &(OrbitalEquilibrium, SmallOscillations))| {
        let axes =
            equilibrium.axes.map(|(k, is_along)| if is_along { k as i64 + 1 } else { -(k as i64) - 1 });
        let (lies, growth_rate, rounded) = kinds.get(k).cloned().unwrap_or_default();
        let is_same = |(axes, _, rate): &([usize; 3], f64, String)| (axes, rate) == (&lies, &rounded);
        let same = kinds.iter().filter(|kind| is_same(kind)).count();
        let is_first = kinds.iter().position(is_same) == Some(k);
        let is_stable = oscillations.is_stable();
        let word = if is_stable { "stable" } else { "unstable" };
        let growth_rate = (growth_rate > 0.0).then_some(Quantity::Number(growth_rate, "/s"));
        let title = if is_first { lies.map(|axis| axis.to_string()).join(", ") } else { String::new() };
        let nearest = equilibrium.state.attitude.angle_to(found.start.attitude);
        let v = |v: [f64; 3]| Quantity::Vector(v, "");
        let facts = vec![
            Fact::data("principal_axes_up_ahead_normal", json!(axes)),
            Fact::data("tilt", Quantity::Angle(equilibrium.tilt)),
            Fact::data("up_body", v(equilibrium.up.to_array())),
            Fact::data("ahead_body", v(equilibrium.ahead.to_array())),
            Fact::data("normal_body", v(equilibrium.normal.to_array())),
            Fact::data(
                "attitude_wxyz",
                Quantity::Attitude(equilibrium.state.attitude.canonical_quaternion()),
            ),
            Fact::data("omega_body", v(equilibrium.state.omega.to_array())),
            fact("", "attitudes", Quantity::Count(same as u64)),
            fact("", "nearest", Quantity::Angle(nearest)),
            fact("stable", "stability", Quantity::Data(is_stable.into(), word.to_owned())),
            fact("", "growth rate", growth_rate),
            Fact::data("modes", modes(oscillations)),
        ];
        Facts::new(title, facts)
    };
    found.on_orbit.iter().enumerate().map(row).collect()
}

/// Returns a row for each mode. The text has one row for modes of one frequency that oscillate
/// about any axis in a plane.
fn modes(oscillations: &SmallOscillations) -> Quantity {
    let mut rows = Vec::new();
    let mut rest = oscillations.modes.as_slice();
    while let Some(first) = rest.first() {
        let (these, others) = rest.split_at(first.multiplicity.clamp(1, rest.len()));
        rest = others;
        let is_plane = these.len() > 1 && these.iter().all(|mode| mode.minor_axis.norm() < STRAIGHT);
        for (k, mode) in these.iter().enumerate() {
            let is_hidden = is_plane && k > 0;
            let title = if is_hidden { String::new() } else { (rows.len() + 1).to_string() };
            rows.push(Facts::new(title, facts_of(mode, if is_plane { plane(these) } else { shape(mode) })));
        }
    }
    Quantity::Table(rows)
}

fn facts_of(mode: &OscillationMode, shape: String) -> Vec<Fact> {
    let [frequency, period, growth] = rates([mode.frequency, mode.growth_rate]);
    vec![
        frequency,
        period,
        growth,
        fact("damping_ratio", "damping ratio", Quantity::Number(mode.damping_ratio(), ""))
            .shown_if(mode.growth_rate < 0.0 && mode.frequency > 0.0),
        Fact::data("axis_body", Quantity::Vector(mode.axis.to_array(), "")),
        Fact::data("minor_axis_body", Quantity::Vector(mode.minor_axis.to_array(), "")),
        fact("", "axis", shape),
        Fact::data("multiplicity", Quantity::Count(mode.multiplicity as u64)),
    ]
}

fn plane(modes: &[OscillationMode]) -> String {
    let axes: Vec<String> = modes.iter().map(|mode| about(mode.axis.to_array())).collect();
    match axes.as_slice() {
        [a, b] => format!("any in the plane of {a} and {b}"),
        _ => "any".to_owned(),
    }
}

fn shape(mode: &OscillationMode) -> String {
    let axis = about(mode.axis.to_array());
    if mode.minor_axis.norm() < STRAIGHT {
        return axis;
    }
    format!("cone {axis}, {}", about(mode.minor_axis.to_array()))
}

fn about(v: [f64; 3]) -> String {
    vector(tidy(v), 4)
}

/// Sets components of a unit vector to zero that are below its printed digits.
fn tidy(v: [f64; 3]) -> [f64; 3] {
    v.map(|x| if x.abs() < 5e-7 { 0.0 } else { x })
}
