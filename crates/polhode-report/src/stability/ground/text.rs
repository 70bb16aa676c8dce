//! The stability of a body on the ground, on one screen.

use std::f64::consts::TAU;

use polhode::motion::contact::Footing;
use polhode::observe::{EndState, Place, Rattleback, StableSpins, SteadyMode, SteadyPath, TippeTop};
use polhode_document::finding;
use polhode_document::layout::{columns, labelled, plain_spaces};
use polhode_document::number::number;
use polhode_document::unit::rate;

use super::GroundStabilityReport;

pub(super) fn write(report: &GroundStabilityReport) -> String {
    let steady = &report.steady;
    let mut text = report.source.heading() + "\n";
    text.push_str(&labelled("contact", contact(report)));
    text.push_str(&labelled("steady motion", &motion(report)));
    text.push_str(&labelled("small departure", &verdict(report)));
    let rows: Vec<Vec<String>> = steady.modes.iter().map(mode).collect();
    text.extend(columns(&rows).iter().map(|line| format!("  {line}\n")));
    if steady.neutral > 0 {
        let ways = steady.neutral_ways().join(", ");
        let count = match steady.neutral {
            1 => "1 rate is zero".to_owned(),
            count => format!("{count} rates are zero"),
        };
        let line = match steady.neutral > steady.neutral_ways().len() {
            true => format!("{count}: {ways}, and what the linear equations do not decide"),
            false => format!("{count}, on the way to {ways}"),
        };
        text.push_str(&labelled("neutral", &line));
    }
    text.push_str(&threshold(report));
    if let SteadyPath::OnVertex(vertex) = &steady.path
        && let Some(rattle) = vertex.rattleback()
    {
        text.push_str(&rattleback(&rattle));
    }
    if let (Some(top), Some(jellett)) = (&steady.tippe_top, steady.jellett) {
        text.push_str(&tippe_top(top, jellett));
    }
    text.push_str(&finding::to_text(&report.findings));
    plain_spaces(&text)
}

fn contact(report: &GroundStabilityReport) -> &'static str {
    match report.steady.footing {
        Footing::Rolling if report.is_dry => {
            "with friction, on level ground: near a steady motion without slip it holds the point of contact, and the body rolls"
        }
        Footing::Rolling => "rolls without slipping, on level ground",
        Footing::Frictionless => "slides without friction, on level ground",
        Footing::Viscous => "slides with viscous friction, on level ground",
    }
}

/// Which steady motion it is, and how far the start is from it.
fn motion(report: &GroundStabilityReport) -> String {
    let steady = &report.steady;
    let spin = rate(steady.spin);
    let what = match steady.path {
        SteadyPath::RollingUpright(_) => format!("upright, rolling straight at {spin} about its axis"),
        SteadyPath::SpinningUpright(_) => {
            format!("with its axis level, spinning about the vertical at {spin}")
        }
        SteadyPath::OnVertex(_) => match place(report) {
            Some(Place::Bottom) => {
                format!("spinning about the vertical at {spin}, with its centre of mass lowest")
            }
            Some(_) => {
                format!("inverted: spinning about the vertical at {spin}, with its centre of mass highest")
            }
            None => format!("spinning about the vertical at {spin} on a point below its centre of mass"),
        },
        SteadyPath::Tilted => {
            format!(
                "tilted {}°, turning about the vertical at {spin} with its centre of mass at rest",
                tilt(report)
            )
        }
        _ => format!("tilted {}°, in a circle, with {spin} about its axis", tilt(report)),
    };
    let away = number(steady.turned_from_start.to_degrees(), 4);
    let off = rate(steady.omega_from_start);
    if steady.turned_from_start < 1e-9 && steady.omega_from_start <= 1e-9 * steady.omega.norm() {
        format!("{what}: the start itself")
    } else {
        format!("{what}; the start is {away}° and {off} from it")
    }
}

/// Of a tippe top on its axis, at which end.
fn place(report: &GroundStabilityReport) -> Option<Place> {
    let steady = &report.steady;
    steady.tippe_top?;
    let along = steady.axis?.dot(steady.normal);
    Some(if along > 0.0 { Place::Bottom } else { Place::Inverted })
}

/// The angle between the axis and the vertical, in degrees.
fn tilt(report: &GroundStabilityReport) -> String {
    let steady = &report.steady;
    let angle = steady.axis.map_or(0.0, |axis| axis.angle_to(steady.normal));
    number(angle.to_degrees(), 6)
}

fn verdict(report: &GroundStabilityReport) -> String {
    let steady = &report.steady;
    match steady.modes.first() {
        Some(mode) if mode.growth_rate > 0.0 => format!(
            "unstable: it grows at {} /s, e-fold in {} s",
            number(mode.growth_rate, 6),
            number(1.0 / mode.growth_rate, 6)
        ),
        // What dry friction makes of slip is not linear.
        Some(_) if report.is_dry && steady.slip_at_start > 1e-9 * steady.omega.norm() => {
            let slip = number(steady.slip_at_start, 4);
            format!(
                "stable once it rolls; the start slips at {slip} m/s, and until it grips, friction decides where it goes"
            )
        }
        Some(_) if report.is_dry => "stable as long as its point of contact does not slip".to_owned(),
        Some(mode) if mode.growth_rate < 0.0 => "stable: it dies away".to_owned(),
        Some(_) if steady.modes.iter().any(|mode| mode.growth_rate < 0.0) => {
            "stable: nothing grows, and part of it dies away".to_owned()
        }
        Some(_) => "stable: nothing grows, to first order".to_owned(),
        None => "neither held nor left: every rate is zero".to_owned(),
    }
}

fn mode(mode: &SteadyMode) -> Vec<String> {
    let growth = match mode.growth_rate {
        0.0 => "is kept".to_owned(),
        rate if rate > 0.0 => format!("grows at {} /s", number(rate, 6)),
        rate => format!("dies away at {} /s", number(-rate, 6)),
    };
    if mode.frequency == 0.0 {
        return vec!["without swinging".to_owned(), growth];
    }
    vec![
        format!("{} rad/s, once in {} s", number(mode.frequency, 6), number(TAU / mode.frequency, 6)),
        growth,
    ]
}

/// The bounds in closed form, and where the spin is between them.
fn threshold(report: &GroundStabilityReport) -> String {
    let steady = &report.steady;
    let Some(spins) = &steady.stable_spins else {
        return match steady.path {
            SteadyPath::Circling | SteadyPath::Tilted => String::new(),
            _ => labelled(
                "threshold",
                "no closed form is known here with viscous friction: the rates above decide",
            ),
        };
    };
    let line = match spins.nearest(steady.spin) {
        Some(threshold) => {
            let margin = 100.0 * (steady.spin / threshold - 1.0);
            let (size, side) = (number(margin.abs(), 4), if margin < 0.0 { "below" } else { "above" });
            format!(
                "{}; the spin is {size} % {side} the nearest threshold, {}",
                intervals(spins),
                rate(threshold)
            )
        }
        None => intervals(spins),
    };
    labelled("threshold", &format!("{} for stability: {line}", spins.law))
}

fn intervals(spins: &StableSpins) -> String {
    let one = |[from, to]: &[f64; 2]| match (from.is_finite(), to.is_finite()) {
        (true, true) if *from == -to => format!("up to {} in either sense", rate(*to)),
        (true, true) => format!("between {} and {}", number(*from, 7), rate(*to)),
        (true, false) => format!("above {}", rate(*from)),
        (false, true) => format!("below {}", rate(*to)),
        (false, false) => "at every spin".to_owned(),
    };
    match &spins.intervals[..] {
        [] => "at no spin".to_owned(),
        [[_, below], [above, _]] if *below == -above => format!("beyond {} in either sense", rate(*above)),
        all => all.iter().map(one).collect::<Vec<_>>().join(", "),
    }
}

fn rattleback(rattle: &Rattleback) -> String {
    let sense = |sense: f64| if sense > 0.0 { "against the clock" } else { "with the clock" };
    let (stable, other) = (sense(rattle.stable_sense), sense(-rattle.stable_sense));
    let line = match rattle.threshold {
        Some(threshold) => {
            let from = rate(threshold);
            let range = rattle
                .until
                .map_or_else(|| format!("beyond {from}"), |until| format!("from {from} to {}", rate(until)));
            format!("a rattleback: spin {stable}, seen from above, is stable {range}; spin {other} never is")
        }
        None => "a rattleback, seen from above: spin is stable in neither sense".to_owned(),
    };
    let rows: Vec<Vec<String>> = rattle
        .modes
        .iter()
        .map(|mode| {
            let grows = sense(mode.growth_per_spin);
            vec![
                format!("swing of {} rad/s", number(mode.frequency, 6)),
                format!("grows with spin {grows}, at {} of it", number(mode.growth_per_spin.abs(), 4)),
            ]
        })
        .collect();
    labelled("rattling", &line) + &columns(&rows).iter().map(|line| format!("  {line}\n")).collect::<String>()
}

/// Where sliding friction leads.
fn tippe_top(top: &TippeTop, jellett: f64) -> String {
    let group = match top.group() {
        1 => "group I: it never leaves the bottom, as A < C (1 − α)",
        2 => "group II: spun fast enough it turns over, as C (1 − α) < A < C (1 + α)",
        _ => "group III: it rises, and never stands inverted, as A > C (1 + α)",
    };
    let ratio = number(top.across / top.along, 6);
    let mut text =
        labelled("tippe top", &format!("{group}; A/C = {ratio}, α = {}", number(top.eccentricity, 6)));
    let unit = "kg·m³/s";
    let up_to = top.bottom_up_to().map_or("the bottom is a minimum at every J".to_owned(), |limit| {
        format!("the bottom is a minimum of the energy up to |J| = {} {unit}", number(limit, 6))
    });
    let from = top.inverted_from().map_or("the inverted position at none".to_owned(), |limit| {
        format!("the inverted position from |J| = {} {unit} on", number(limit, 6))
    });
    text.push_str(&labelled(
        "Jellett's J",
        &format!("{} {unit} at the start; {up_to}, {from}", number(jellett, 6)),
    ));
    let ends: Vec<String> = top.minima(jellett).iter().map(end).collect();
    text.push_str(&labelled("sliding friction", &format!("leads to {}", ends.join(", or to "))));
    text
}

fn end(state: &EndState) -> String {
    match state.place {
        Place::Bottom => "the bottom".to_owned(),
        Place::Tilted => format!("a tilt of {}°", number(state.cosine.acos().to_degrees(), 6)),
        Place::Inverted => "the inverted position".to_owned(),
    }
}
