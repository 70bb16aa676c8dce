//! Answer to the question of the stability on the ground: one to three lines.

use polhode::observe::{EndState, Place, Rattleback, SteadyPath};
use polhode_document::number::number;

use super::GroundStabilityReport;
use super::words::{path, sense};
use crate::report::answer::capitalised;
use crate::report::stability::words::{DIGITS, verdict};

/// Returns the stability of the steady motion with its threshold, and the effect of friction.
pub(crate) fn lines(report: &GroundStabilityReport) -> Vec<String> {
    let steady = &report.steady;
    let mut lines = vec![stability(report)];
    if let SteadyPath::OnVertex(vertex) = &steady.path {
        lines.extend(vertex.rattleback().as_ref().map(rattleback));
    }
    if let (Some(top), Some(jellett)) = (&steady.tippe_top, steady.jellett) {
        let ends: Vec<String> = top.minima(jellett).iter().map(end).collect();
        lines.push(format!("sliding friction leads to {}", ends.join(" or to ")));
    }
    lines.iter().map(|line| format!("{}.", capitalised(line))).collect()
}

fn stability(report: &GroundStabilityReport) -> String {
    let steady = &report.steady;
    let pairs: Vec<[f64; 2]> = steady.modes.iter().map(|mode| [mode.frequency, mode.growth_rate]).collect();
    let is = match (steady.is_stable() && report.is_dry && !pairs.is_empty(), report.slips_at_start()) {
        // While the contact slips, dry friction is not linear.
        (true, true) => "stable once it rolls; until the contact stops slipping, friction decides".to_owned(),
        (true, false) => format!("{} while the contact does not slip", verdict(&pairs)),
        (false, _) => verdict(&pairs),
    };
    let [spin, threshold] =
        [Some(steady.spin), report.threshold()].map(|x| x.map_or(String::new(), |x| number(x.abs(), DIGITS)));
    let margin = report.margin().map_or_else(String::new, |margin| {
        let side = if margin < 0.0 { "below" } else { "above" };
        let size = number(100.0 * margin.abs(), DIGITS);
        format!("; its spin is {size}\u{a0}% {side} the threshold, {threshold} rad/s")
    });
    let [kind, position] = path(report);
    format!("{kind} at {spin} rad/s {position} is {is}{margin}")
}

fn rattleback(rattle: &Rattleback) -> String {
    let (stable, other) = (sense(rattle.stable_sense), sense(-rattle.stable_sense));
    let Some(threshold) = rattle.threshold else {
        return "a rattleback: spin is unstable in both senses".to_owned();
    };
    let from = number(threshold, DIGITS);
    let range = rattle.until.map_or_else(
        || format!("above {from} rad/s"),
        |until| format!("from {from} to {} rad/s", number(until, DIGITS)),
    );
    format!("a rattleback: {stable} spin, seen from above, is stable {range}; {other} spin is unstable")
}

fn end(state: &EndState) -> String {
    match state.place {
        Place::Bottom => "the bottom position".to_owned(),
        Place::Tilted => format!("a tilt of {}°", number(state.cosine.acos().to_degrees(), DIGITS)),
        Place::Inverted => "the inverted position".to_owned(),
    }
}
