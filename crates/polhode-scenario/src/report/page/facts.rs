//! The numbers beside the picture, ready to read.

use polhode::motion::torque::TorqueModel;
use polhode::motion::{
    Crossing, FreeMotion, Mechanism, MethodReason, Regime, Scenario, Solution, Swing, Wheel,
};
use polhode::observe::{Cones, Drift, FreeRegime, GeometricPhase, Herpolhode, LeastEnergySpin, SymmetricTop};
use polhode_document::layout::printable;
use polhode_document::number::{count, error, number, tidy, tidy_matrix, typeset, vector};
use polhode_document::unit;
use polhode_document::unit::DIGITS;
use polhode_shape::report::block::Geometry;
use serde_json::{Value, json};

use super::motion::Shown;
use super::sizes::{self, Sized};
use super::turning::Turning;
use super::{PageInput, PageSubject};
use crate::report::balance::energy_balance;
use crate::report::contact;
use crate::report::event;
use crate::report::free_facts::FreeFacts;
use crate::report::gimbals;
use crate::report::history;
use crate::report::periods::Periods;
use crate::report::sampling::largest_turn;
use crate::report::torque::{Description, off_at_start};

/// Between two samples a body that turns by more, rad, may have turned otherwise than the picture shows.
const LARGEST_TURN: f64 = 1.0;

/// One number, or one word.
struct Row {
    label: &'static str,
    value: String,
    unit: String,
    note: String,
}

impl Row {
    fn new(label: &'static str, value: impl Into<String>, unit: &str) -> Self {
        Self { label, value: value.into(), unit: unit.to_owned(), note: String::new() }
    }

    fn of(label: &'static str, value: f64, unit: &str) -> Self {
        Self::new(label, number(value, DIGITS), unit)
    }

    /// A number with the unit that fits it: `25.6354 cm³`.
    fn sized(label: &'static str, shown: &str) -> Self {
        let (value, unit) = shown.rsplit_once(' ').unwrap_or((shown, ""));
        Self::new(label, value, unit)
    }

    /// A number and its unit.
    fn with(label: &'static str, (value, unit): Sized) -> Self {
        Self { label, value, unit, note: String::new() }
    }

    /// An angle in degrees.
    fn angle(label: &'static str, rad: f64) -> Self {
        Self::of(label, rad.to_degrees(), "°")
    }

    fn note(self, note: impl Into<String>) -> Self {
        Self { note: note.into(), ..self }
    }

    fn json(&self) -> Value {
        json!({ "label": self.label, "value": typeset(&self.value), "unit": self.unit, "note": typeset(&self.note) })
    }
}

pub(crate) fn json(
    input: &PageInput<'_>,
    turning: &Turning<'_>,
    free: Option<&FreeFacts>,
    shown: &Shown<'_>,
    notes: &[String],
) -> Value {
    let scenario = match input.subject {
        PageSubject::Scenario(scenario) => Some(scenario),
        PageSubject::Moments(_) => None,
    };
    let groups = [
        ("Body", scenario.map_or_else(Vec::new, |scenario| body(scenario, turning))),
        ("Inertia", inertia(turning)),
        ("Motion", motion(input, free, shown)),
        (
            "Ground",
            scenario
                .and_then(|scenario| contact::facts(scenario, input.trajectory))
                .map_or_else(Vec::new, given),
        ),
        (
            "Gimbals",
            match scenario.map(Scenario::mechanism) {
                Some(Mechanism::Gimbals(of)) => given(gimbals::facts(of)),
                _ => Vec::new(),
            },
        ),
        ("Events", events(input)),
        ("Cones", free.and_then(|free| free.top.as_ref()).map_or_else(Vec::new, cones)),
        ("Poinsot's picture", free.map_or_else(Vec::new, |free| picture(&free.motion))),
        ("Pendulum", scenario.map_or_else(Vec::new, pendulum)),
        ("Heavy top", scenario.map_or_else(Vec::new, heavy_top)),
        ("Evidence", evidence(input, free.is_some())),
        ("This page", this_page(shown, notes)),
    ];
    let groups = groups.iter().filter(|(_, rows)| !rows.is_empty());
    groups
        .map(|(title, rows)| json!({ "title": title, "rows": rows.iter().map(Row::json).collect::<Value>() }))
        .collect()
}

fn body(scenario: &Scenario, turning: &Turning<'_>) -> Vec<Row> {
    let body = scenario.body();
    let size = unit::size(body);
    let geometry = Geometry::of_parts(scenario.parts(), body.mass());
    let mut rows = vec![Row::sized("mass", &unit::mass(body.mass())).note(at_start(turning))];
    rows.extend(geometry.volume.map(|volume| Row::sized("volume", &unit::volume(volume))));
    rows.extend(geometry.density.map(|density| Row::of("density", density, "kg/m³").note("mean")));
    rows.push(
        Row::sized("centre of mass", &unit::place_in(size, tidy(body.center_of_mass().to_array())))
            .note("body axes"),
    );
    if turning.is_pivoted {
        rows.push(
            Row::sized("pivot", &unit::place_in(size, tidy(turning.point.to_array()))).note("body axes"),
        );
        rows.push(
            Row::sized("lever", &unit::length(turning.lever.norm()))
                .note("from the pivot to the centre of mass"),
        );
    }
    rows
}

/// Of a body that changes.
const fn at_start(turning: &Turning<'_>) -> &'static str {
    if turning.is_changing { "at the start" } else { "" }
}

fn inertia(turning: &Turning<'_>) -> Vec<Row> {
    let principal = &turning.principal;
    let [i1, i2, i3] = principal.moments();
    let [e1, e2, e3] = principal.axes().map(|axis| vector(tidy(axis.to_array()), 5));
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = tidy_matrix(turning.tensor);
    let three = |label, values: [f64; 3]| Row::with(label, sizes::three(values, "kg·m²"));
    vec![
        Row::of("i1, least", i1, "kg·m²").note(format!("axis 1 = {e1} in the body")),
        Row::of("i2", i2, "kg·m²").note(format!("axis 2 = {e2}")),
        Row::of("i3, greatest", i3, "kg·m²").note(format!("axis 3 = {e3}")),
        Row::new("about", format!("the {}", turning.about()), "").note(at_start(turning)),
        Row::new("symmetry", principal.symmetry().name(), "").note(principal.symmetry().freedom()),
        three("Ixx, Iyy, Izz", [xx, yy, zz]).note("body axes"),
        three("Ixy, Ixz, Iyz", [xy, xz, yz]).note("−∫xy dm, …"),
    ]
}

fn given(facts: Vec<(&'static str, String)>) -> Vec<Row> {
    facts.into_iter().map(|(label, text)| Row::new(label, text, "")).collect()
}

fn motion(input: &PageInput<'_>, free: Option<&FreeFacts>, shown: &Shown<'_>) -> Vec<Row> {
    let how = match input.trajectory.solution() {
        Solution::ClosedForm(_) => "in closed form",
        Solution::Prescribed(_) => "prescribed",
        _ if *input.trajectory.reason() == MethodReason::Contact => "integrated phase by phase",
        solution => &format!("integrated by {}", solution.title()),
    };
    let mut rows = Vec::new();
    if let (Some(first), Some(last)) = (shown.samples.first(), shown.samples.last()) {
        let from = first.state.time;
        let (to, unit) = sizes::duration(last.state.time);
        let from = if from == 0.0 { "0".to_owned() } else { unit::duration(from, DIGITS) };
        rows.push(Row::new("time", format!("{from} … {to}"), &unit).note(how));
        let omega = first.state.omega;
        rows.push(Row::with("ω at the start", sizes::rates(tidy(omega.to_array()))).note("body axes"));
        rows.push(Row::with("|ω| at the start", sizes::rate(omega.norm())));
        rows.push(Row::of("|L| at the start", first.momentum.norm(), "kg·m²/s"));
        let of = match input.trajectory.reason() {
            MethodReason::Contact => "of the rotation alone",
            MethodReason::Gimbals => "of the rotor alone",
            _ => "",
        };
        rows.push(Row::with("T at the start", sizes::energy(first.kinetic_energy)).note(of));
    }
    match (free, input.subject) {
        (Some(free), _) => rows.extend(free_motion(free)),
        (None, PageSubject::Scenario(scenario)) => rows.extend(driven(scenario, shown)),
        _ => {}
    }
    rows
}

/// Torques with their names, and wheels with what they do at the start and at the end.
fn driven(scenario: &Scenario, shown: &Shown<'_>) -> Vec<Row> {
    let torque = |(k, model): (usize, &TorqueModel)| {
        let name = scenario.torque_names().get(k).cloned().flatten();
        let named = name.map(|name| format!("{}: ", printable(&name))).unwrap_or_default();
        let description = Description::of(model);
        let note = [Some(description.model.to_owned()), off_at_start(scenario, k)];
        let note: Vec<String> = note.into_iter().flatten().collect();
        Row::new("torque", named + &description.text(), "").note(note.join(", "))
    };
    let ends = [shown.samples.first(), shown.samples.last()].map(|s| s.map(|s| s.state));
    let wheel = |(k, wheel): (usize, &Wheel)| {
        let named = scenario.wheel_name(k).map(|name| format!("{}: ", printable(name))).unwrap_or_default();
        let mut rows = vec![Row::new("wheel", named + &Description::of_wheel(wheel).text(), "")];
        if let [Some(from), Some(to)] = ends
            && let [Some(slow), Some(fast)] = [from, to].map(|s| wheel.speed_at(s.time, s.omega))
        {
            let [least, most] = [from, to].map(|s| number(wheel.momentum_at(s.time), 6));
            rows.push(
                Row::new("h of the wheel", format!("{least} → {most}"), "kg·m²/s").note("along its axis"),
            );
            let [slow, fast] = [slow, fast].map(|speed| number(speed, 6));
            rows.push(Row::new("Ω of the wheel", format!("{slow} → {fast}"), "rad/s").note("in the body"));
        }
        rows
    };
    let torques = scenario.torques().iter().enumerate().map(torque);
    let mass = scenario.history().zip(shown.samples.last()).map(|(history, last)| {
        Row::new("mass", history::in_words(history, [scenario.start().time, last.state.time]), "")
    });
    torques.chain(mass).chain(scenario.wheels().iter().enumerate().flat_map(wheel)).collect()
}

/// The times of the first events by name and sense, and how the motion ended, if not at the end of the run.
fn events(input: &PageInput<'_>) -> Vec<Row> {
    /// More would bury the rest.
    const MOST: usize = 20;
    let crossings = input.trajectory.events();
    let sense = |crossing: &Crossing| if crossing.rising { "rising" } else { "falling" };
    let mut kinds: Vec<(&str, &str, Vec<String>)> = Vec::new();
    for crossing in crossings.iter().take(MOST) {
        let time = number(crossing.state.time, 9);
        let same =
            |kind: &&mut (&str, &str, Vec<String>)| kind.0 == crossing.name && kind.1 == sense(crossing);
        match kinds.iter_mut().find(same) {
            Some(kind) => kind.2.push(time),
            None => kinds.push((&crossing.name, sense(crossing), vec![time])),
        }
    }
    let row = |(name, sense, times): (&str, &str, Vec<String>)| {
        let label = if times.len() > 1 { "events" } else { "event" };
        Row::new(label, times.join(", "), "s").note(format!("{}, {sense}", printable(name)))
    };
    let mut rows: Vec<Row> = kinds.into_iter().map(row).collect();
    if crossings.len() > MOST {
        rows.push(
            Row::new("events", count(crossings.len() as u64), "").note("in all: summary.json has them"),
        );
    }
    if let PageSubject::Scenario(scenario) = input.subject {
        rows.extend(event::ending_in_words(input.trajectory, scenario).map(|end| Row::new("end", end, "")));
    }
    rows
}

/// The kind of a free motion, and how long it takes.
fn free_motion(free: &FreeFacts) -> Vec<Row> {
    let FreeRegime { regime, period, flip_interval, growth_rate } = free.regime;
    let Periods { precession, rotation } = free.periods;
    let mut rows = vec![Row::new("free motion", regime.description(), "")];
    let mut put = |label, value: Option<f64>, note: &str| {
        rows.extend(value.map(|value| Row::with(label, sizes::duration(value)).note(note)));
    };
    put("period of ω", period, "in the body");
    put("flips every", flip_interval, "ω along axis 2 reverses");
    put("precession", precession, "once round L, on average");
    put("rotation", rotation, "once about the axis that L circles");
    let growth =
        growth_rate.map(|rate| Row::of("growth rate", rate, "1/s").note("of a departure from axis 2"));
    rows.extend(growth);
    if !matches!(regime, Regime::Permanent(_)) {
        let [least, most] = free.motion.nutation_range().map(|angle| number(angle.to_degrees(), 6));
        let axis = if free.motion.circles_least() { 1 } else { 3 };
        let value = if least == most { least } else { format!("{least} … {most}") };
        rows.push(Row::new("nutation", value, "°").note(format!("of axis {axis} from L")));
    }
    rows
}

fn cones((top, cones): &(SymmetricTop, Cones)) -> Vec<Row> {
    let [axial, transverse] = top.moments();
    vec![
        Row::new("symmetry axis", vector(tidy(top.axis().to_array()), 6), "").note("in the body"),
        Row::of("axial moment", axial, "kg·m²"),
        Row::of("transverse moment", transverse, "kg·m²"),
        Row::angle("body cone", cones.body_half_angle).note("half-angle: ω round the symmetry axis"),
        Row::angle("space cone", cones.space_half_angle).note("half-angle: ω round L"),
        Row::angle("nutation", cones.nutation).note("of the symmetry axis from L"),
        Row::with("rate in the body", sizes::rate(cones.body_rate)),
        Row::with("rate in space", sizes::rate(cones.space_rate)),
    ]
}

/// Poinsot's ellipsoid on its plane, what a period adds up to, and where friction would end it.
fn picture(free: &FreeMotion) -> Vec<Row> {
    /// A piece too short to have many points.
    const PIECE: f64 = 1e-9;
    let mut rows = Vec::new();
    if let Ok(herpolhode) = Herpolhode::of(free, PIECE, 0.1) {
        rows.push(
            Row::with("ω along L", sizes::rate(herpolhode.height)).note("height of the invariable plane"),
        );
        let across = Row::with("ω across L", sizes::rate_range(herpolhode.annulus));
        rows.push(across.note("radius of the herpolhode"));
    }
    if let Some(phase) = GeometricPhase::of(free) {
        rows.push(Row::of("turn in a period", phase.total, "rad").note("about L"));
        rows.push(Row::of("of it dynamic", phase.dynamic, "rad").note("2 T P / |L|"));
        rows.push(Row::of("of it geometric", phase.geometric, "rad").note("a solid angle"));
    }
    if let Some(end) = LeastEnergySpin::of(free) {
        let ratio = Row::of("T / least T", end.energy_ratio, "");
        rows.push(ratio.note("least at the same |L|, where friction inside would end"));
    }
    rows
}

fn pendulum(scenario: &Scenario) -> Vec<Row> {
    let (Some(hanging), Some(Ok(pendulum))) = (scenario.suspension(), scenario.pendulum()) else {
        return Vec::new();
    };
    let small = Row::with("small swing", sizes::duration(pendulum.period(0.0))).note("period");
    let swing = hanging.amplitude.map(|amplitude| pendulum.swing(amplitude, 0.0));
    let swing = match swing {
        Some(Swing::Oscillation { amplitude, period }) => {
            let note = format!("between ±{}°", number(amplitude.to_degrees(), 6));
            Some(Row::of("this swing", period, "s").note(note))
        }
        Some(Swing::Revolution { period }) => Some(Row::of("one turn", period, "s").note("over the top")),
        _ => None,
    };
    [small].into_iter().chain(swing).collect()
}

fn heavy_top(scenario: &Scenario) -> Vec<Row> {
    let top = crate::report::heavy_top::of(scenario, scenario.start());
    let facts = top.map_or_else(Vec::new, |top| crate::report::heavy_top::facts(&top));
    facts.into_iter().map(|fact| Row::new(fact.label, fact.value, fact.unit).note(fact.note)).collect()
}

/// How far the balances fail at the worst sample.
fn evidence(input: &PageInput<'_>, is_free: bool) -> Vec<Row> {
    let mut rows = balance(input, is_free);
    if let Some(estimate) = input.trajectory.error() {
        let [end, inputs] = [estimate.end(), estimate.inputs_end()];
        rows.push(Row::new("attitude is right to", error(end.attitude), "rad").note("estimate, at the end"));
        rows.push(Row::new("ω is right to", error(end.omega), "").note("of itself, at the end"));
        let or_less = if estimate.is_thorough() { "" } else { ", or by less" };
        rows.push(
            Row::new("last bit of the inputs", error(inputs.attitude), "rad")
                .note(format!("turns the attitude at the end{or_less}")),
        );
    }
    rows.extend(cost(input));
    rows
}

/// What stays the same, and how well.
fn balance(input: &PageInput<'_>, is_free: bool) -> Vec<Row> {
    let row = |label, value: f64| Row::new(label, error(value), "").note("relative, worst sample");
    if let Some(name) = energy_balance(input.trajectory) {
        return vec![row(name, input.trajectory.energy_drift())];
    }
    let Some(drift) = Drift::of(input.trajectory) else { return Vec::new() };
    let mut rows = if is_free {
        vec![
            row("T stays to", drift.kinetic_energy),
            row("|L| stays to", drift.momentum_magnitude),
            row("L in space stays to", drift.momentum),
        ]
    } else {
        vec![row("T − work", drift.work_energy), row("L − impulse", drift.momentum)]
    };
    rows.extend(drift.total_energy.map(|total| row("T + U stays to", total)));
    rows
}

/// The tolerance and the steps of what was integrated.
fn cost(input: &PageInput<'_>) -> Vec<Row> {
    let solution = input.trajectory.solution();
    let Some(statistics) = solution.statistics() else { return Vec::new() };
    let tolerance =
        solution.tolerance().map(|tolerance| Row::new("tolerance", error(tolerance), "").note("of a step"));
    tolerance.into_iter().chain([Row::new("steps", count(statistics.accepted), "")]).collect()
}

/// What the page shows, where that is not all.
fn this_page(shown: &Shown<'_>, notes: &[String]) -> Vec<Row> {
    let mut rows = Vec::new();
    let [here, all] = [shown.samples.len(), shown.of].map(|n| count(n as u64));
    let samples = Row::new("samples", here.clone(), "");
    rows.push(if here == all { samples } else { samples.note(format!("of {all}, evenly chosen")) });
    let turn = largest_turn(shown.samples.iter().copied());
    if turn > LARGEST_TURN {
        let row = Row::angle("turn between samples", turn);
        rows.push(row.note("at most: too far to follow; sample a shorter time to see it"));
    }
    rows.extend(notes.iter().map(|note| Row::new("body", note.clone(), "")));
    rows
}
