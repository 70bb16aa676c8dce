//! The motion on one screen.

use polhode::motion::{MethodReason, Pendulum, Sample, Scenario, Solution, State, Swing, Wheel};
use polhode::observe::FreeRegime;
use polhode_document::finding;
use polhode_document::layout::{WIDTH, broken, columns, labelled, plain_spaces, printable};
use polhode_document::number::{
    count, error, has_digits, number, quaternion, tidy, ungrouped, vector, within,
};
use polhode_document::sparkline::Sparkline;
use polhode_document::unit;
use polhode_document::unit::{CLOSED, DIGITS, cone, duration, rate};

use super::MotionReport;
use super::facts::{Facts, Needed, Top};
use crate::report::periods::in_both_conventions;
use crate::report::torque::{Description, off_at_start, wheel_name};
use crate::report::{contact, event, gimbals, global_error, heavy_top, history, intermediate, omega, orbit};

/// Forces on more particles than this fill the screen: JSON has them all.
const MOST_PARTICLES: usize = 8;

/// The motion, with a picture of ω of so many columns.
pub(crate) fn write(report: &MotionReport<'_>, picture: usize) -> String {
    let facts = Facts::of(report.scenario, report.trajectory);
    let samples = report.trajectory.samples();
    let mut text = heading(report, samples);
    if let Some(ending) = event::ending_in_words(report.trajectory, report.scenario) {
        text.push_str(&labelled("end of the run", &ending));
    }
    text.push_str(&labelled("method", &report.trajectory.reason().to_string()));
    text.push_str(&regime(&facts));
    if let Some(top) = &facts.top {
        text.push_str(&symmetric_top(top));
    }
    if let Some(hanging) = &facts.hanging {
        text.push_str(&pendulum(hanging));
    }
    text.extend(heavy_top::of(report.scenario, facts.start).as_ref().map(heavy_top::to_text));
    if let Some(needed) = &facts.needed {
        text.push_str(&torque_needed(needed));
    }
    text.push_str(&what_acts(report.scenario));
    text.push_str(&contact::to_text(report.scenario, report.trajectory));
    text.push_str(&gimbals::to_text(report.scenario, report.trajectory));
    text.push_str(&orbit::to_text(report.scenario, samples, global_error::of_attitude(report.trajectory)));
    text.push_str(&event::table(report.trajectory, report.scenario));
    text.push_str(&evidence(report, &facts));
    text.push_str(&global_error::to_text(report.trajectory));
    text.push_str(&curve(&facts, samples, picture));
    text.push_str(&ends(report, &facts));
    text.extend(report.at.iter().map(|sample| state_at(report, sample)));
    let solution = report.trajectory.solution();
    if let Some(statistics) = solution.statistics() {
        let by = match (solution, solution.tolerance()) {
            (Solution::Splitting { order, step, .. }, _) => {
                format!("order {}, {} s each", order.number(), ungrouped(*step, 3))
            }
            (_, Some(tolerance)) => format!("tolerance {} a step", ungrouped(tolerance, 3)),
            (_, None) => String::new(),
        };
        let line = format!(
            "{} kept, {} rejected, {} evaluations, {by}",
            count(statistics.accepted),
            count(statistics.rejected),
            count(statistics.evaluations),
        );
        text.push_str(&labelled("steps", &line));
    }
    text.push_str(&finding::to_text(&report.findings()));
    plain_spaces(&text)
}

/// `T-handle in free fall   0 … 20 s, 2,001 samples, exact`
fn heading(report: &MotionReport<'_>, samples: &[Sample]) -> String {
    let title = printable(report.scenario.title().unwrap_or(&report.source.path));
    let how = match report.trajectory.solution() {
        Solution::ClosedForm(_) => "closed form",
        Solution::Prescribed(_) => "prescribed motion",
        _ if *report.trajectory.reason() == MethodReason::Contact => "integrated phase by phase",
        solution => &format!("integrated by {}", solution.title()),
    };
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
        return format!("{title}   no samples, {how}\n");
    };
    let (from, to) = (number(first.state.time, 6), duration(last.state.time, 6));
    let noun = if samples.len() == 1 { "sample" } else { "samples" };
    format!("{title}   {from} … {to}, {} {noun}, {how}\n", count(samples.len() as u64))
}

/// What kind of free motion it is, with its periods; for any other motion what turns it.
fn regime(facts: &Facts<'_>) -> String {
    let Some(free) = facts.free() else { return String::new() };
    let FreeRegime { regime, period, flip_interval, growth_rate } = free.regime;
    let closed = facts.top.as_ref().is_some_and(|top| top.cones.body_half_angle < CLOSED);
    let kind = if closed { "a symmetric top turning about its axis" } else { regime.description() };
    let mut text = labelled("free motion", kind);
    let mut periods = Vec::new();
    if let (Some(period), None) = (period, &facts.top) {
        periods.push(format!("ω repeats in the body every {}", duration(period, DIGITS)));
    }
    if let Some(flip) = flip_interval {
        periods.push(format!("along axis 2 it reverses every {}", duration(flip, DIGITS)));
    }
    if !periods.is_empty() {
        text.push_str(&labelled("periods", &periods.join("; ")));
    }
    if facts.top.is_none() {
        text.push_str(&in_both_conventions(&free.motion, DIGITS));
    }
    if let Some(growth) = growth_rate {
        let off = intermediate::degrees_off(facts.rotor.principal(), &facts.start);
        let line = format!("ω starts {off}° from axis 2, growth rate {} /s", number(growth, 6));
        text.push_str(&labelled("instability", &line));
    }
    text
}

fn symmetric_top(top: &Top) -> String {
    let [axial, transverse] = top.motion.moments().map(|i| number(i, DIGITS));
    let axis = vector(tidy(top.motion.axis().to_array()), 6);
    let cones = &top.cones;
    let axes = labelled("symmetry axis", &format!("e = {axis}; I_e = {axial}, I_t = {transverse} kg·m²"));
    if cones.body_half_angle < CLOSED {
        return axes
            + &labelled("", "ω lies along it (but for rounding) and stays, in the body and in space");
    }
    let every = |rate: f64| match rate {
        0.0 => String::new(),
        rate => format!(", once in {}", duration(std::f64::consts::TAU / rate.abs(), DIGITS)),
    };
    let body = format!(
        "ω circles the axis at Ω = {}{}; body cone {}",
        rate(cones.body_rate),
        every(cones.body_rate),
        cone(cones.body_half_angle)
    );
    let space = format!(
        "ω and the axis circle L at φ\u{307} = {}{}; space cone {}, nutation {}",
        rate(cones.space_rate),
        every(cones.space_rate),
        cone(cones.space_half_angle),
        cone(cones.nutation),
    );
    axes + &labelled("in the body", &body)
        + &labelled("in space", &space)
        + &labelled("coplanarity", &format!("e · (ω × L) / |ω||L| stays below {}", bound(top.coplanarity)))
}

fn pendulum((pendulum, swing): &(Pendulum, Swing)) -> String {
    let frequency = pendulum.small_frequency();
    let small = format!(
        "ω0 = √(M g d / I) = {} rad/s, period {} s",
        number(frequency, DIGITS),
        number(pendulum.period(0.0), DIGITS)
    );
    let exact = match *swing {
        Swing::Rest => "at rest".to_owned(),
        Swing::Oscillation { amplitude, period } => {
            format!("period {} s between ±{}", number(period, DIGITS), unit::amplitude(amplitude))
        }
        Swing::Separatrix => "just enough to come to rest upside down, after infinite time".to_owned(),
        Swing::Revolution { period } => format!("over the top, one turn in {} s", number(period, DIGITS)),
    };
    labelled("small swing", &small) + &labelled("this swing", &exact)
}

fn torque_needed(needed: &Needed) -> String {
    let start = &needed.at_start;
    let torque = tidy(start.torque.to_array());
    let line = format!(
        "{} N·m in body axes, |N| = {} N·m, power {} W",
        vector(torque, 6),
        number(start.torque.norm(), DIGITS),
        number(start.power, 6),
    );
    let mut text = labelled("torque needed", &line);
    if let Some(largest) = needed.largest.filter(|s| s.torque.norm() > start.torque.norm() * (1.0 + 1e-9)) {
        let line = format!(
            "|N| = {} N·m at t = {} s",
            number(largest.torque.norm(), DIGITS),
            number(largest.state.time, 6)
        );
        text.push_str(&labelled("  at most", &line));
    }
    let count = needed.forces.len();
    if count > MOST_PARTICLES {
        text.push_str(&labelled("forces", &format!("on {count} particles: summary.json has them")));
    } else if count > 0 {
        text.push_str("forces on the particles at the start, body axes, N\n");
        let rows: Vec<Vec<String>> = needed.forces.iter().enumerate().map(|(k, f)| force_row(k, f)).collect();
        let lines = columns(&rows).into_iter().flat_map(|row| broken(&row, "    ", WIDTH));
        text.extend(lines.map(|line| line + "\n"));
    }
    text
}

fn force_row(k: usize, f: &polhode::motion::ParticleForce) -> Vec<String> {
    let scale = f.force.norm();
    let shown = |v: [f64; 3]| vector(polhode_document::number::tidy_beside(v, scale), 6);
    vec![
        format!("F{} = {}", k + 1, shown(f.force.to_array())),
        format!("along r {}", shown(f.along.to_array())),
        format!("across r {}", shown(f.across.to_array())),
    ]
}

/// Torques and wheels.
fn what_acts(scenario: &Scenario) -> String {
    let mut text = String::new();
    for (k, model) in scenario.torques().iter().enumerate() {
        let name = scenario.torque_names().get(k).cloned().flatten();
        let name = name.map_or_else(String::new, |name| format!("{}: ", printable(&name)));
        let off = off_at_start(scenario, k).map_or_else(String::new, |off| format!(", {off}"));
        text.push_str(&labelled("torque", &format!("{name}{}{off}", Description::of(model).text())));
    }
    if let (Some(history), Some(run)) = (scenario.history(), scenario.run()) {
        let ends = [scenario.start().time, run.times.last().copied().unwrap_or_default()];
        text.push_str(&labelled("mass", &history::in_words(history, ends)));
    }
    for (k, wheel) in scenario.wheels().iter().enumerate() {
        text.push_str(&labelled(&printable(&wheel_name(scenario, k)), &Description::of_wheel(wheel).text()));
    }
    text
}

/// How far the balances fail at the worst sample.
fn evidence(report: &MotionReport<'_>, facts: &Facts<'_>) -> String {
    let Some(drift) = facts.drift else { return String::new() };
    let line = if facts.is_free {
        format!(
            "energy {}   |L| {}   L in space {}",
            error(drift.kinetic_energy),
            error(drift.momentum_magnitude),
            error(drift.momentum)
        )
    } else {
        let total = drift.total_energy.map_or_else(String::new, |e| format!("   T + U {}", error(e)));
        format!("T - work {}   L - impulse {}{total}", error(drift.work_energy), error(drift.momentum))
    };
    let note = match report.trajectory.solution() {
        Solution::ClosedForm(_) => "(relative, worst sample: rounding)",
        _ => "(relative, worst sample)",
    };
    labelled("drift", &format!("{}   {note}", line).replace("   ", "\u{a0}\u{a0} "))
}

/// The component of ω along a principal axis that varies most.
fn curve(facts: &Facts<'_>, samples: &[Sample], columns: usize) -> String {
    let to_principal = facts.rotor.principal().rotation().inverse();
    let omega: Vec<[f64; 3]> = samples.iter().map(|s| (to_principal * s.state.omega).to_array()).collect();
    let Some(spark) = Sparkline::of_omega(&omega, columns) else { return String::new() };
    let until = match samples.get(spark.values) {
        Some(sample) => format!("  to {} s", number(sample.state.time, 3)),
        None => String::new(),
    };
    labelled(&spark.label(facts.rotor.principal()), &format!("{}{until}", spark.line))
}

/// The state at the start and at the end, and what energy did.
fn ends(report: &MotionReport<'_>, facts: &Facts<'_>) -> String {
    let samples = report.trajectory.samples();
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else { return String::new() };
    let mut text = labelled("start", &omega::in_words(first.state.omega));
    let momentum = facts.rotor.angular_momentum_space(&facts.start);
    let about = if facts.rotor.is_pivoted() { "the pivot" } else { "the centre of mass" };
    let line = format!(
        "|L| = {} kg·m²/s, T = {} J, about {about}",
        number(momentum.norm(), DIGITS),
        number(first.kinetic_energy, DIGITS)
    );
    text.push_str(&labelled("", &line));
    if samples.len() > 1 {
        let error = global_error::of_omega(report.trajectory);
        text.push_str(&labelled("end", &omega::in_words_within(last.state.omega, error)));
        let error = global_error::of_attitude(report.trajectory);
        let q = quaternion(last.state.attitude.canonical_quaternion(), error, 6);
        text.push_str(&labelled(
            "",
            &match has_digits(global_error::LARGEST_ATTITUDE, error) {
                true => format!("attitude w, x, y, z = {q}"),
                false => "no digit of the attitude is right (estimate)".to_owned(),
            },
        ));
        let held = contact::ends(report.trajectory).or_else(|| gimbals::ends(report.trajectory));
        if let Some(ends) = held {
            text.push_str(&ends);
        } else if !facts.is_free {
            // T goes with the square of ω.
            let omega_error = report.trajectory.error().map_or(0.0, |estimate| estimate.end().omega);
            let potential = match (first.potential_energy, last.potential_energy) {
                (Some(u0), Some(u)) => format!(", U {} → {} J", number(u0, 6), number(u, 6)),
                _ => String::new(),
            };
            let line = format!(
                "T {} → {} J{potential}, work done {} J",
                number(first.kinetic_energy, 6),
                within(last.kinetic_energy, 2.0 * last.kinetic_energy * omega_error, 6),
                number(last.work, 6)
            );
            if has_digits(1.0, 2.0 * omega_error) {
                text.push_str(&labelled("energy", &line));
            }
        }
        text.push_str(&wheels(
            report.scenario,
            [&first.state, &last.state],
            global_error::of_omega(report.trajectory),
        ));
    }
    text
}

/// A state that was asked for.
fn state_at(report: &MotionReport<'_>, sample: &Sample) -> String {
    let state = &sample.state;
    let error = global_error::at(report.trajectory, state.time);
    let omega = omega::in_words_within(state.omega, error.omega * state.omega.norm());
    let text = labelled(&format!("t = {} s", number(state.time, 9)), &omega);
    if !has_digits(global_error::LARGEST_ATTITUDE, error.attitude) {
        return text + &labelled("", "no digit of the attitude is right (estimate)");
    }
    let q = quaternion(state.attitude.canonical_quaternion(), error.attitude, 9);
    let on_orbit = orbit::angles_in_words(report.scenario, state).map_or_else(String::new, |angles| {
        labelled("", &format!("roll, pitch, yaw in the orbit's axes {angles}°"))
    });
    text + &labelled("", &format!("attitude w, x, y, z = {q}")) + &on_orbit
}

/// What each wheel does at the start and at the end; nothing of one whose speed is held, which `what_acts` has.
fn wheels(scenario: &Scenario, ends: [&State; 2], error: f64) -> String {
    let rpm = |speed: f64| 60.0 * speed / std::f64::consts::TAU;
    let line = |(k, wheel): (usize, &Wheel)| {
        let [from, to] = ends.map(|state| number(wheel.momentum_at(state.time), 6));
        let [Some(slow), Some(fast)] = ends.map(|state| wheel.speed_at(state.time, state.omega)) else {
            return String::new();
        };
        let slow = number(slow, 6);
        // Its speed at the end goes with the body's ω.
        let fast = match has_digits(fast.abs(), error) {
            true => format!("{} rad/s ({} rpm)", within(fast, error, 6), within(rpm(fast), rpm(error), 4)),
            false => "unknown".to_owned(),
        };
        let line = format!("h {from} → {to} kg·m²/s, Ω in the body {slow} → {fast}");
        labelled(&wheel_name(scenario, k), &line)
    };
    scenario.wheels().iter().enumerate().map(line).collect()
}

/// An upper bound of a rounding error, which may be exactly zero.
fn bound(x: f64) -> String {
    error(x.max(f64::EPSILON))
}
