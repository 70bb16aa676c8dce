//! Facts about a steady motion on the ground.

use polhode::motion::contact::Footing;
use polhode::observe::{EndState, Place, RattleMode, Rattleback, SteadyMode, SteadyPath, TippeTop};
use polhode_document::fact::{Fact, Facts, Quantity, object};
use polhode_document::finding;
use polhode_document::json::numbers;
use polhode_document::number::number;
use serde_json::{Value, json};

use super::GroundStabilityReport;
use super::words::{intervals, path, sense};
use crate::report::VERSION;
use crate::report::stability::words::{fact, rates};

/// Unit of Jellett's constant.
const JELLETT: &str = "kg·m³/s";

/// Returns the facts in sections, in the order of the text.
pub(crate) fn of(report: &GroundStabilityReport) -> Vec<Facts> {
    let steady = &report.steady;
    let rattleback = match &steady.path {
        SteadyPath::OnVertex(vertex) => vertex.rattleback(),
        _ => None,
    };
    let tippe_top = steady.tippe_top.as_ref().zip(steady.jellett);
    vec![
        Facts::new(
            "",
            vec![Fact::data("polhode", Value::from(VERSION)), Fact::data("source", report.source.to_json())],
        ),
        Facts::new("Steady motion", motion(report)),
        Facts::new("Small deviations", deviations(report)),
        Facts::new("Threshold", threshold(report)),
        Facts::new("Rattleback", nested("on_ground.rattleback", rattleback.as_ref().map(rattle))),
        Facts::new(
            "Tippe top",
            nested("on_ground.tippe_top", tippe_top.map(|(top, jellett)| inverts(top, jellett))),
        ),
        Facts::new("", vec![Fact::data("findings", finding::to_json(&report.findings))]),
    ]
}

/// Returns the JSON of the same facts.
pub(crate) fn json(report: &GroundStabilityReport) -> Value {
    Value::Object(object(&[], &of(report)))
}

/// Returns the facts of an object, or `null`.
fn nested(key: &'static str, facts: Option<Vec<Fact>>) -> Vec<Fact> {
    facts.unwrap_or_else(|| vec![Fact::data(key, Quantity::None)])
}

fn motion(report: &GroundStabilityReport) -> Vec<Fact> {
    let steady = &report.steady;
    let is_start = steady.turned_from_start < 1e-9 && steady.omega_from_start <= 1e-9 * steady.omega.norm();
    let about = match steady.path {
        SteadyPath::RollingUpright(_) | SteadyPath::Circling => "spin about the axis",
        _ => "spin about vertical",
    };
    let is_inclined = matches!(steady.path, SteadyPath::Tilted | SteadyPath::Circling);
    let inclination =
        steady.axis.filter(|_| is_inclined).map(|axis| Quantity::Angle(axis.angle_to(steady.normal)));
    let axis = steady.axis.map(|axis| Quantity::Vector(axis.to_array(), ""));
    let footing = steady.footing;
    vec![
        fact("on_ground.path", "kind", Quantity::Word(steady.path.name(), path(report).join(" "))),
        fact("", "inclination", inclination).note("of the axis from the vertical"),
        fact("on_ground.footing", "contact", Quantity::Word(footing.name(), contact(report).to_owned())),
        Fact::data("on_ground.holds_while_friction_does", Value::from(report.is_dry)),
        fact("on_ground.spin", about, Quantity::Rate(steady.spin)),
        fact("on_ground.normal_body", "vertical", Quantity::Vector(steady.normal.to_array(), ""))
            .note("in body axes")
            .detail(),
        fact("on_ground.omega_body", "ω", Quantity::Vector(steady.omega.to_array(), "rad/s"))
            .note("in body axes")
            .detail(),
        fact("on_ground.axis_body", "axis", axis).note("in body axes").detail(),
        fact("on_ground.turned_from_start", "angle to the start", Quantity::Angle(steady.turned_from_start))
            .shown_if(!is_start),
        fact("on_ground.omega_from_start", "Δω to the start", Quantity::Rate(steady.omega_from_start))
            .shown_if(!is_start && steady.omega_from_start > 0.0),
        fact("on_ground.slip_at_start", "slip at the start", Quantity::Number(steady.slip_at_start, "m/s"))
            .shown_if(report.slips_at_start()),
    ]
}

const fn contact(report: &GroundStabilityReport) -> &'static str {
    match report.steady.footing {
        Footing::Rolling if report.is_dry => {
            "dry friction, level ground; rolls while the contact does not slip"
        }
        Footing::Rolling => "rolls without slipping on level ground",
        Footing::Frictionless => "slides without friction on level ground",
        Footing::Viscous => "slides with viscous friction on level ground",
    }
}

fn deviations(report: &GroundStabilityReport) -> Vec<Fact> {
    let steady = &report.steady;
    let row = |(k, mode): (usize, &SteadyMode)| {
        Facts::new((k + 1).to_string(), rates([mode.frequency, mode.growth_rate]).into())
    };
    let ways = steady.neutral_ways();
    let undecided =
        if steady.neutral > ways.len() { ", and the linear equations do not decide the others" } else { "" };
    vec![
        Fact::data("on_ground.stable", Value::from(steady.is_stable())),
        fact("on_ground.modes", "mode", Quantity::Table(steady.modes.iter().enumerate().map(row).collect())),
        fact("on_ground.neutral", "zero rates", Quantity::Count(steady.neutral as u64))
            .note(format!("changes to {}{undecided}", ways.join(", ")))
            .shown_if(steady.neutral > 0)
            .detail(),
        Fact::data("on_ground.neutral_ways", json!(ways)),
    ]
}

/// Returns the bounds in closed form, and the position of the spin between them.
fn threshold(report: &GroundStabilityReport) -> Vec<Fact> {
    let steady = &report.steady;
    let spins = steady.stable_spins.as_ref();
    let (wheel, vertex) = match steady.path {
        SteadyPath::RollingUpright(wheel) | SteadyPath::SpinningUpright(wheel) => (Some(wheel), None),
        SteadyPath::OnVertex(vertex) => (None, Some(vertex)),
        _ => (None, None),
    };
    let nearest = report.threshold();
    let stable = spins.map(|spins| {
        // A missing bound is `null`.
        let ends: Value = spins.intervals.iter().map(|ends| numbers(ends)).collect();
        Quantity::Data(ends, intervals(spins))
    });
    let length = |x: Option<f64>| x.map(|x| Quantity::Number(x, "m"));
    let is_unknown = spins.is_none() && !matches!(steady.path, SteadyPath::Circling | SteadyPath::Tilted);
    let unknown =
        is_unknown.then(|| Quantity::Text("with viscous friction: the growth rates decide".to_owned()));
    vec![
        fact("on_ground.law", "law", spins.map(|spins| Quantity::Text(spins.law.to_owned()))),
        fact("on_ground.stable_spins", "stable spins", stable),
        fact("", "no closed form", unknown),
        fact("on_ground.threshold", "nearest threshold", nearest.map(Quantity::Rate)),
        fact(
            "on_ground.margin",
            "margin",
            report
                .margin()
                .map(|margin| Quantity::Data(margin.into(), format!("{}\u{a0}%", number(100.0 * margin, 4)))),
        )
        .note("spin/threshold − 1"),
        fact("on_ground.height", "height", length(wheel.map(|w| w.height).or(vertex.map(|v| v.height))))
            .note("of the centre of mass")
            .detail(),
        fact("on_ground.profile_radius", "profile radius", length(wheel.map(|wheel| wheel.profile))).detail(),
        Fact::data(
            "on_ground.radii",
            vertex
                .map(|vertex| Quantity::from(vertex.radii.iter().map(|row| numbers(row)).collect::<Value>())),
        ),
    ]
}

fn rattle(rattle: &Rattleback) -> Vec<Fact> {
    let stable = Quantity::Data(rattle.stable_sense.into(), sense(rattle.stable_sense).to_owned());
    let row = |(k, mode): (usize, &RattleMode)| {
        let growth = Quantity::Data(
            mode.growth_per_spin.into(),
            format!("{}, {}", number(mode.growth_per_spin.abs(), 4), sense(mode.growth_per_spin)),
        );
        Facts::new(
            (k + 1).to_string(),
            vec![
                fact("frequency", "frequency", Quantity::Number(mode.frequency, "rad/s")),
                fact("growth_per_spin", "growth rate per spin", growth),
            ],
        )
    };
    let rows = rattle.modes.iter().enumerate().map(row).collect();
    vec![
        fact("on_ground.rattleback.stable_sense", "stable sense", stable)
            .note("seen from above")
            .shown_if(rattle.threshold.is_some()),
        fact("on_ground.rattleback.threshold", "stable from", rattle.threshold.map(Quantity::Rate)),
        fact("on_ground.rattleback.until", "stable up to", rattle.until.map(Quantity::Rate)),
        fact("on_ground.rattleback.modes", "mode at rest", Quantity::Table(rows)),
    ]
}

fn inverts(top: &TippeTop, jellett: f64) -> Vec<Fact> {
    let key = |name: &str| format!("on_ground.tippe_top.{name}");
    let group = match top.group() {
        1 => "I: it never leaves the bottom, A < C (1 − α)",
        2 => "II: it inverts if it spins fast enough, C (1 − α) < A < C (1 + α)",
        _ => "III: it rises, but inverted it is unstable, A > C (1 + α)",
    };
    let limit = |limit: Option<f64>| limit.map(|j| Quantity::Number(j, JELLETT));
    let ratio = top.across / top.along;
    let rows = top.all(jellett).iter().map(end).collect();
    vec![
        fact(&key("group"), "group", Quantity::Data(top.group().into(), group.to_owned())),
        fact(&key("eccentricity"), "α", Quantity::Number(top.eccentricity, "")),
        fact(&key("moment_ratio"), "A/C", Quantity::Number(ratio, "")),
        fact(&key("jellett"), "Jellett's J", Quantity::Number(jellett, JELLETT)).note("at the start"),
        fact(&key("bottom_up_to"), "J₁", limit(top.bottom_up_to()))
            .note("|J| up to which the bottom is a minimum of the energy"),
        fact(&key("inverted_from"), "J₂", limit(top.inverted_from()))
            .note("|J| from which the inverted position is a minimum"),
        fact(&key("end_states"), "end state", Quantity::Table(rows)),
    ]
}

fn end(state: &EndState) -> Facts {
    let tilt = (state.place == Place::Tilted).then(|| Quantity::Angle(state.cosine.acos()));
    let minimum = if state.is_minimum { "minimum" } else { "no minimum" };
    Facts::new(
        state.place.name(),
        vec![
            Fact::data("place", Value::from(state.place.name())),
            Fact::data("cosine", Quantity::Number(state.cosine, "")),
            fact("", "inclination", tilt),
            fact("energy_j", "energy", Quantity::Energy(state.energy)),
            fact("minimum", "at this J", Quantity::Data(state.is_minimum.into(), minimum.to_owned())),
        ],
    )
}
