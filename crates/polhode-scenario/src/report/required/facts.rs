//! Facts about the torque that a motion needs; facts that `simulate` also states are shared with
//! it.

use polhode::body::Particle;
use polhode::math::Body;
use polhode::motion::Required;
use polhode_document::fact::{Fact, Facts, Quantity, object};
use polhode_document::json::vector;
use polhode_document::number::number;
use polhode_document::{VERSION, finding, unit};
use serde_json::{Map, Value};

use super::{DIGITS, RequiredReport};
use crate::report::facts::{force_json, forces, is_larger, power, torque};

/// Keys of the JSON.
pub(super) const KEYS: [&str; 15] = [
    "polhode",
    "title",
    "source",
    "turns_about",
    "samples",
    "start",
    "largest",
    "largest_power",
    "rms_torque_body_n_m",
    "rms_torque_space_n_m",
    "work_j",
    "impulse_space_n_m_s",
    "at",
    "shaft",
    "findings",
];

/// Threshold of the power relative to its terms; a smaller power is rounding.
const NOISE: f64 = 1e-13;

/// Returns the facts in sections, in the order of the text.
pub(super) fn of(report: &RequiredReport) -> Vec<Facts> {
    let section = |title: &str, facts: Vec<Fact>| {
        Facts::new(title, facts.into_iter().map(|fact| fact.digits(DIGITS)).collect())
    };
    let (first, largest) = (report.first(), report.largest());
    let is_later = is_larger(largest.torque.norm(), first.torque.norm());
    let title = format!("Largest torque, at t = {} s", number(largest.state.time, DIGITS));
    let of_largest = state("largest", largest, report).into_iter().map(|fact| fact.shown_if(is_later));
    let mut at_start = about(report);
    at_start.extend(state("start", first, report));
    vec![
        section("At the start", at_start),
        section(&title, of_largest.collect()),
        section("Over the run", run(report)),
        section("Forces at the start", forces_at_start(report)),
        section("Shaft", report.shaft.as_ref().map_or_else(Vec::new, super::ShaftReport::facts)),
        section("", origin(report)),
    ]
}

/// Returns the reference point of N, L and T.
fn about(report: &RequiredReport) -> Vec<Fact> {
    let point = report.rotor().point().to_array();
    let (word, what) = match report.scenario.pivot() {
        Some(_) => ("pivot", "the pivot"),
        None => ("center_of_mass", "the centre of mass"),
    };
    let place = unit::place_in(unit::size(report.scenario.body()), point);
    vec![
        Fact::new("turns_about.what", "N, L and T about", Quantity::Word(word, what.to_owned()))
            .note(format!("at {place} in body axes")),
        Fact::data("turns_about.point", Quantity::Vector(point, "m")),
    ]
}

/// Returns the state of a sample with its torque and forces.
fn state(key: &str, s: &Required, report: &RequiredReport) -> Vec<Fact> {
    let scale = report.scale();
    let path = |name: &str| format!("{key}.{name}");
    let data = |name: &str, value: Quantity| Fact::data(path(name), value);
    // States at times other than the start are details.
    let fact = |name: &str, label: &str, value| {
        let fact = Fact::new(path(name), label, value);
        if key == "start" { fact } else { fact.detail() }
    };
    let vector = |name: &str, label: &str, v: [f64; 3], unit| fact(name, label, Quantity::Vector(v, unit));
    let in_body = |symbol: &str, size: f64, unit: &str| {
        format!("in body axes, |{symbol}| = {} {unit}", number(size, DIGITS))
    };
    let (omega, momentum) = (s.state.omega, s.state.attitude.inverse() * s.momentum);
    let mut facts = vec![
        data("time_s", Quantity::Duration(s.state.time)),
        data("attitude_wxyz", Quantity::Attitude(s.state.attitude.canonical_quaternion())),
        vector("omega_body", "ω", omega.to_array(), "rad/s").note(in_body("ω", omega.norm(), "rad/s")),
        vector("acceleration_body", "dω/dt", s.acceleration.to_array(), "rad/s²")
            .with_term_size(omega.norm() * omega.norm())
            .note("in body axes"),
    ];
    facts.extend(torque(key, "N", s.torque, s.state.attitude, scale, ""));
    facts.extend([
        power(key, "power", s, scale).note("N · ω"),
        data("work_j", Quantity::Energy(s.work_since(&report.start))),
        data("impulse_space_n_m_s", Quantity::Vector(s.impulse_since(&report.start).to_array(), "N·m·s")),
        data(
            "particle_forces",
            report.points.iter().map(|point| force(point, s, report)).collect::<Value>().into(),
        ),
        vector("momentum_body_kg_m2_s", "L", momentum.to_array(), "kg·m²/s").note(in_body(
            "L",
            momentum.norm(),
            "kg·m²/s",
        )),
        vector("momentum_space_kg_m2_s", "L in space", s.momentum.to_array(), "kg·m²/s"),
        fact("kinetic_energy_j", "T", Quantity::Energy(s.kinetic_energy)),
    ]);
    facts
}

fn force(point: &Particle<Body>, s: &Required, report: &RequiredReport) -> Value {
    let mut json = Map::new();
    json.insert("mass".to_owned(), point.mass().into());
    json.insert("position".to_owned(), vector(point.position()));
    json.extend(force_json(&s.force_on(point, report.rotor())));
    Value::Object(json)
}

/// Returns the largest power, means and integrals.
fn run(report: &RequiredReport) -> Vec<Fact> {
    let ([body, space], most, last) = (report.rms(), report.most_power(), report.last());
    let (scale, to_the_end) = (report.scale(), format!("up to t = {} s", number(last.state.time, DIGITS)));
    let (work, impulse) = (last.work_since(report.first()), last.impulse_since(report.first()));
    let rms =
        |key: &str, v: [f64; 3]| Fact::new(key, "rms of N", Quantity::Vector(v, "N·m")).with_term_size(scale);
    let facts = vec![
        Fact::data("largest_power.time_s", Quantity::Duration(most.state.time)),
        power("largest_power", "largest power", most, scale)
            .note(format!("at t = {} s", number(most.state.time, DIGITS)))
            .shown_if(most.power.abs() > NOISE * report.power_scale()),
        rms("rms_torque_body_n_m", body).note("of each component, in body axes"),
        rms("rms_torque_space_n_m", space).note("of each component, in space axes").detail(),
        Fact::new("work_j", "work", Quantity::Energy(work))
            .with_term_size(report.energy())
            .note(format!("∫ N · ω dt {to_the_end}")),
        Fact::new("impulse_space_n_m_s", "impulse", Quantity::Vector(impulse.to_array(), "N·m·s"))
            .with_term_size(report.momentum())
            .note(format!("∫ N dt {to_the_end}, in space axes")),
    ];
    facts.into_iter().map(|fact| fact.shown_if(report.is_run())).collect()
}

/// Returns the forces on the particles of the body and on the requested points.
fn forces_at_start(report: &RequiredReport) -> Vec<Fact> {
    let force = |point: &Particle<Body>| {
        let (mass, place) = (unit::mass(point.mass()), unit::place(point.position().to_array()));
        (report.first().force_on(point, report.rotor()), format!("; {mass} at {place}"))
    };
    forces(report.points.iter().map(force))
}

/// Returns the version, source, findings, and states at the requested times.
fn origin(report: &RequiredReport) -> Vec<Fact> {
    let at = |s| object(&[], &[Facts::new("", state("at", s, report))]).remove("at");
    vec![
        Fact::data("polhode", VERSION.to_owned()),
        Fact::data("title", Value::from(report.scenario.title())),
        Fact::data("source", report.source.to_json()),
        Fact::data("samples", Quantity::Count(report.samples.len() as u64)),
        Fact::data("at", report.at.iter().map(at).collect::<Option<Value>>().unwrap_or_default()),
        Fact::data("findings", finding::to_json(report.scenario.findings())),
    ]
}
