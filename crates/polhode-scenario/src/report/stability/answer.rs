//! Answer to the question which spins and equilibria are stable: one to three lines.

use std::f64::consts::{FRAC_PI_2, PI};

use polhode::motion::TopPath;
use polhode::observe::{DissipativeLimit, PermanentRotation, Stability};
use polhode_document::number::number;
use polhode_document::unit::time;

use super::facts::{axis_of, needs_no_friction, time_of};
use super::oscillations::{ROUNDING, arrangement, pairs};
use super::search::{Found, Place, Prevented};
use super::words::{DIGITS, e_folding, listed, torques, verdict};
use super::{Judged, StabilityReport};
use crate::report::answer::capitalised;

/// Returns the stability of the spins without torques, or else of the equilibrium, for each state
/// of the wheels.
pub(crate) fn lines(report: &StabilityReport) -> Vec<String> {
    let at = |judged: &Judged| match &judged.oscillations {
        Some(Ok(found)) if judged.is_driven => equilibrium(found),
        Some(Err(prevented)) if judged.is_driven => without_equilibrium(prevented),
        _ => spins(report, judged),
    };
    let lines: Vec<String> = match report.judged.as_slice() {
        [only] => at(only),
        all => {
            let first =
                |judged| at(judged).into_iter().next().map(|line| format!("{}: {line}", time_of(judged)));
            all.iter().filter_map(first).collect()
        }
    };
    lines.iter().map(|line| format!("{}.", capitalised(line))).collect()
}

/// Stability of a spin, including internal friction if the scenario has any.
enum SpinStability {
    Stable,
    /// Growth rate, 1/s.
    Unstable(f64),
    Marginal,
}

impl SpinStability {
    fn of(report: &StabilityReport, one: &PermanentRotation) -> Self {
        match (report.sink.map(|sink| one.with_friction(&sink)), one.stability) {
            (Some(DissipativeLimit::Leaves { rate, .. }), _)
            | (None, Stability::Unstable { growth_rate: rate, .. }) => Self::Unstable(rate),
            (Some(DissipativeLimit::Settles { .. }), _) | (None, Stability::Stable { .. }) => Self::Stable,
            _ => Self::Marginal,
        }
    }
}

fn spins(report: &StabilityReport, judged: &Judged) -> Vec<String> {
    let all = match &judged.rotations {
        Ok(all) => all,
        Err(_) if report.is_always_driven => {
            return vec![
                "no spin is steady: a motor changes the momentum of the wheels at all times".to_owned(),
            ];
        }
        Err(error) => return vec![format!("no spin is steady: {error}")],
    };
    let first = if report.rotor.wheels().is_empty() { by_axis(report, all) } else { by_number(report, all) };
    [first].into_iter().chain(ending(report, all)).collect()
}

/// Describes the spins by axis: `spins about axes 1 and 3 are stable; about axis 2 unstable
/// (e-folding time 1.7 s)`.
fn by_axis(report: &StabilityReport, all: &[PermanentRotation]) -> String {
    let (mut stable, mut unstable, mut marginal, mut growth_rates) = (vec![], vec![], vec![], vec![]);
    for axis in 0..3 {
        let one = all.iter().find(|one| axis_of(report, one) == axis);
        let group = match one.map(|one| SpinStability::of(report, one)) {
            Some(SpinStability::Stable) => &mut stable,
            Some(SpinStability::Unstable(rate)) => {
                growth_rates.push(rate);
                &mut unstable
            }
            Some(SpinStability::Marginal) => &mut marginal,
            None => continue,
        };
        group.push((axis + 1).to_string());
    }
    let groups = [
        (stable, "stable", String::new()),
        (unstable, "unstable", format!(" ({})", e_folding(&growth_rates))),
        (marginal, "marginal", " (equal moments)".to_owned()),
    ];
    let phrases = groups.iter().filter(|(axes, ..)| !axes.is_empty()).enumerate();
    let phrases = phrases.map(|(k, (axes, what, note))| {
        let (spins, be, noun) =
            if axes.len() == 1 { ("spin", "is", "axis") } else { ("spins", "are", "axes") };
        let axes = listed(axes);
        match k {
            0 => format!("{spins} about {noun} {axes} {be} {what}{note}"),
            _ => format!("about {noun} {axes} {what}{note}"),
        }
    });
    phrases.collect::<Vec<_>>().join("; ")
}

/// Describes the spins by number:
/// `2 of 6 steady spins are stable; fastest growth: e-folding time 1.7 s`.
fn by_number(report: &StabilityReport, all: &[PermanentRotation]) -> String {
    let each: Vec<SpinStability> = all.iter().map(|one| SpinStability::of(report, one)).collect();
    let stable = each.iter().filter(|one| matches!(one, SpinStability::Stable)).count();
    let rate = |one: &SpinStability| if let SpinStability::Unstable(rate) = one { Some(*rate) } else { None };
    let fastest = each.iter().filter_map(rate).reduce(f64::max);
    let fastest =
        fastest.map_or_else(String::new, |rate| format!("; fastest growth: {}", e_folding(&[rate])));
    let be = if stable == 1 { "is" } else { "are" };
    format!("{stable} of {} steady spins {be} stable{fastest}", all.len())
}

/// Returns the spin in which internal friction ends the other spins, or would end them.
fn ending(report: &StabilityReport, all: &[PermanentRotation]) -> Option<String> {
    let least = all.first()?;
    let is_left = |one: &PermanentRotation| match report.sink {
        Some(_) => matches!(SpinStability::of(report, one), SpinStability::Unstable(_)),
        None => needs_no_friction(one),
    };
    if !all.iter().any(is_left) {
        return None;
    }
    let with = if report.sink.is_some() { "with its friction inside" } else { "with dissipation inside" };
    let time_constant = match report.sink.map(|sink| least.with_friction(&sink)) {
        Some(DissipativeLimit::Settles { rate, .. }) => {
            format!(" (time constant {})", time(1.0 / rate, DIGITS))
        }
        _ => String::new(),
    };
    let rate = number(least.omega.norm(), DIGITS);
    let axis = axis_of(report, least) + 1;
    let end = match (report.rotor.wheels().is_empty(), least.stability) {
        (true, Stability::Marginal) => format!("a flat spin, such as about axis {axis}, at {rate} rad/s"),
        (true, _) => format!("the flat spin about axis {axis}, at {rate} rad/s"),
        (false, _) => format!("spin 1, of least energy, at {rate} rad/s"),
    };
    Some(format!("{with}, every other spin ends in {end}{time_constant}"))
}

fn without_equilibrium(prevented: &Prevented) -> Vec<String> {
    let why = match prevented.by.as_slice() {
        [] => String::new(),
        [one] => format!(": {} prevents it", torques(std::slice::from_ref(one))),
        by => format!(": {} prevent it", torques(by)),
    };
    let rest = prevented.of_the_rest.as_ref().map_or_else(Vec::new, equilibrium);
    let without = if prevented.by.len() == 1 { "without it" } else { "without them" };
    let rest = rest.into_iter().take(2).map(|rest| format!("{without}, {rest}"));
    [format!("no equilibrium near the start{why}")].into_iter().chain(rest).collect()
}

fn equilibrium(found: &Found) -> Vec<String> {
    let is = verdict(&pairs(&found.oscillations));
    let angle = number(if found.turned > ROUNDING { found.turned.to_degrees() } else { 0.0 }, DIGITS);
    let mut lines = match &found.place {
        Place::Top(top, other) => {
            let other = other
                .as_ref()
                .map(|other| top_line(found, other.path, other.angle, &verdict(&pairs(&other.oscillations))));
            [top_line(found, top.path, top.angle, &is)].into_iter().chain(other).collect()
        }
        Place::Start => match found.heavy {
            // In equilibrium the axis of a top is vertical.
            Some(heavy) => {
                let [highest, _] = heavy.nutation_bounds();
                let angle = if highest < FRAC_PI_2 { 0.0 } else { PI };
                vec![top_line(found, heavy.path(), angle, &is)]
            }
            None => vec![format!("the start is an equilibrium: {is}")],
        },
        Place::Orbit(nearest) => {
            vec![format!(
                "the attitude nearest to the start, {angle}° off, is {is}: {}",
                arrangement(nearest)
            )]
        }
        Place::Nearest => vec![format!("the equilibrium nearest to the start, {angle}° off, is {is}")],
        Place::Vertical => {
            vec![format!("the nearest equilibrium that rotates about the vertical, {angle}° off, is {is}")]
        }
        Place::Rest => vec![format!("the nearest equilibrium at rest, {angle}° off, is {is}")],
    };
    if !found.on_orbit.is_empty() {
        let modes = found.on_orbit.iter().flat_map(|(_, oscillations)| &oscillations.modes);
        let fastest = modes.map(|mode| mode.growth_rate).fold(0.0, f64::max);
        let stable = found.on_orbit.iter().filter(|(_, oscillations)| oscillations.is_stable()).count();
        let growth = if fastest > 0.0 {
            format!("; fastest growth: {}", e_folding(&[fastest]))
        } else {
            String::new()
        };
        let all = found.on_orbit.len();
        lines.insert(
            0,
            format!("{stable} of {all} attitudes at rest relative to the orbit are stable{growth}"),
        );
    }
    lines
}

/// Returns the stability of a steady motion of a heavy top; an upright one has the sleeping-top
/// threshold.
fn top_line(found: &Found, path: TopPath, angle: f64, is: &str) -> String {
    if angle == PI {
        return format!("hanging straight down, the body is {is}");
    }
    if angle > 0.0 {
        let what = if path == TopPath::Conical { "the conical pendulum" } else { path.description() };
        return format!("{what}, at {}° is {is}", number(angle.to_degrees(), DIGITS));
    }
    let compared = found.heavy.filter(|heavy| heavy.sleeping_threshold().is_finite()).map(|heavy| {
        let [spin, threshold] = [heavy.spin().abs(), heavy.sleeping_threshold()];
        let side = if spin > threshold { "above" } else { "below" };
        let [spin, threshold] = [spin, threshold].map(|rate| number(rate, DIGITS));
        format!(
            ": its spin about the axis, {spin} rad/s, is {side} the sleeping-top threshold, {threshold} rad/s"
        )
    });
    format!("upright, the top is {is}{}", compared.unwrap_or_default())
}
