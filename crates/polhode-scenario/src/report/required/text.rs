//! The report as text.

use polhode::motion::{ParticleForce, Required};
use polhode_document::finding;
use polhode_document::layout::{columns, labelled, plain_spaces};
use polhode_document::number::{count, exact, number, tidy_beside, vector};
use polhode_document::unit;

use super::{RequiredReport, tidy};

/// Digits of a number that stands alone.
const DIGITS: usize = 7;

pub(crate) fn write(report: &RequiredReport) -> String {
    let (samples, scale) = (report.samples(), report.scale());
    let first = report.first();
    let mut text = heading(report);
    let point = unit::place_in(unit::size(report.scenario.body()), report.rotor().point().to_array());
    let what = if report.scenario.pivot().is_some() { "the pivot" } else { "the centre of mass" };
    text.push_str(&labelled("turns about", &format!("{what}, {point} in body axes: N is about it")));
    text.push_str(&labelled("torque at start", &both(first, scale)));
    if samples.len() > 1 {
        let largest = report.largest();
        text.push_str(&labelled(
            "largest torque",
            &format!("{}, at t = {} s", both(largest, scale), t(largest)),
        ));
        let [body, space] = report.rms().map(|n| vector(tidy_beside(n, scale), DIGITS));
        let rms = format!("of each component {body} N·m in body axes, {space} N·m in space axes");
        text.push_str(&labelled("rms torque", &rms));
    }
    text.push_str(&labelled("power", &power(report)));
    if samples.len() > 1 {
        let last = report.last();
        let work = small(last.work_since(first), energy(report));
        text.push_str(&labelled("work", &format!("∫ N · ω dt = {work} J up to t = {} s", t(last))));
        let scale = first.momentum.norm().max(last.momentum.norm());
        let impulse = vector(tidy_beside(last.impulse_since(first).to_array(), scale), DIGITS);
        text.push_str(&labelled("impulse", &format!("∫ N dt = {impulse} N·m·s in space axes")));
    }
    if let Some(shaft) = &report.shaft {
        text.push_str(&shaft.to_text());
    }
    text.push_str(&forces(report));
    text.push_str(&at(report));
    text.push_str(&finding::to_text(report.scenario.findings()));
    plain_spaces(&text)
}

fn heading(report: &RequiredReport) -> String {
    let what = match report.samples() {
        [.., last] if report.samples().len() > 1 => {
            format!("{} … {} s, {} samples", t(report.first()), t(last), count(report.samples().len() as u64))
        }
        _ => "at the start".to_owned(),
    };
    let title = report.scenario.title().unwrap_or("Torque of a prescribed motion");
    format!("{}   {what}, prescribed motion\n", polhode_document::layout::printable(title))
}

fn t(s: &Required) -> String {
    number(s.state.time, DIGITS)
}

/// `N = (…) N·m in body axes, (…) N·m in space axes, |N| = … N·m`
fn both(s: &Required, scale: f64) -> String {
    let [body, space] = [tidy(s.torque, scale), tidy(s.torque_space(), scale)].map(|n| vector(n, DIGITS));
    let size = small(s.torque.norm(), scale);
    format!("N = {body} N·m in body axes, {space} N·m in space axes, |N| = {size} N·m")
}

/// A number, or zero where it is rounding beside `scale`.
fn small(x: f64, scale: f64) -> String {
    number(tidy_beside([x, 0.0, 0.0], 10.0 * scale)[0], DIGITS)
}

fn power(report: &RequiredReport) -> String {
    let rate = report.samples.iter().map(|s| s.state.omega.norm()).fold(0.0, f64::max);
    let (first, most, scale) = (report.first(), report.most_power(), report.scale() * rate);
    let start = format!("N · ω = {} W at the start", small(first.power, scale));
    if report.samples().len() < 2 || most.power.abs() <= 1e-13 * scale {
        return start;
    }
    format!("{start}; the most {} W, at t = {} s", small(most.power, scale), t(most))
}

/// The greatest kinetic energy.
fn energy(report: &RequiredReport) -> f64 {
    report.samples.iter().map(|s| s.kinetic_energy).fold(0.0, f64::max)
}

/// The forces on the points at the start.
fn forces(report: &RequiredReport) -> String {
    let mut text = String::new();
    for (k, particle) in report.points.iter().enumerate() {
        let ParticleForce { force, along, across, .. } = report.first().force_on(particle, report.rotor());
        let scale = force.norm();
        let [f, across] = [force, across].map(|f| vector(tidy_beside(f.to_array(), scale), DIGITS));
        let arm = particle.position() - report.rotor().point();
        let along = small(arm.direction().map_or(0.0, |r| r.dot(along)), scale);
        let line = format!(
            "F{} = {f} N in body axes on {} at {}: {along} N along its arm, {across} N across",
            k + 1,
            unit::mass(particle.mass()),
            unit::place(particle.position().to_array())
        );
        text.push_str(&labelled(if k == 0 { "forces at start" } else { "" }, &line));
    }
    text
}

/// The times that were asked for: every number reads back bit for bit.
fn at(report: &RequiredReport) -> String {
    if report.at.is_empty() {
        return String::new();
    }
    let table = |numbers: &dyn Fn(&Required) -> Vec<f64>| {
        let row = |s: &Required| [s.state.time].into_iter().chain(numbers(s)).map(exact).collect();
        let rows: Vec<Vec<String>> = report.at.iter().map(row).collect();
        columns(&rows).into_iter().map(|line| format!("    {line}\n")).collect::<String>()
    };
    let body = table(&|s| s.torque.to_array().to_vec());
    let space = table(&|s| s.torque_space().to_array().to_vec());
    let power = table(&|s| vec![s.power, s.work_since(&report.start)]);
    format!(
        "\nt in s, N in body axes in N·m: t, x, y, z\n{body}\nt in s, N in space axes in N·m: t, x, y, z\n{space}\n\
         t in s, power in W and work since the start in J: t, N · ω, ∫ N · ω dt\n{power}"
    )
}
