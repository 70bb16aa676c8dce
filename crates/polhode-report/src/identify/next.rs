//! The next experiment that would help most.

use polhode_identify::{Candidate, Knowledge, NextExperiment};
use serde_json::{Value, json};

use crate::explain::document::Section;
use crate::number::{count, number};

/// Experiments that are shown.
const SHOWN: usize = 6;
/// Parts of a direction below this are not named.
const PART: f64 = 0.3;

/// What an experiment is called: for people, and as data.
pub(super) trait Named {
    /// What it is to do, in words that go on from "that helps most is".
    fn name(&self) -> String;

    /// What it is as data.
    fn to_json(&self) -> Value;
}

pub(super) fn section<E: Named>(next: &NextExperiment<E>) -> Section {
    let mut s = Section::new(0, "What to measure next");
    s.say(least_known(&next.now));
    match next.best() {
        Some(best) => {
            s.say(format!("Most would help {}: {}.", best.experiment.name(), gain(&next.now, &best.then)))
        }
        None if next.now.unknown > 0 => {
            s.say("None of the experiments below makes known what is not: another kind is needed.")
        }
        None => s.say("None of the experiments below would help by more than 1 % alone."),
    }
    let row = |candidate: &Candidate<E>| {
        let mut row = vec![
            candidate.experiment.name(),
            count(candidate.then.unknown as u64),
            percent(candidate.then.largest_sd),
        ];
        row.extend(candidate.then.moment_sd.map(sd));
        row
    };
    let mut now = vec!["as it is".to_owned(), count(next.now.unknown as u64), percent(next.now.largest_sd)];
    now.extend(next.now.moment_sd.map(sd));
    let headers = ["besides", "directions not known", "least known of the rest", "sd i1", "sd i2", "sd i3"];
    let rows = core::iter::once(now).chain(next.candidates.iter().take(SHOWN).map(row));
    s.table(&headers, rows.collect());
    s.say("Errors are over the greatest moment i3, as they would be by the derivatives of what would be measured, with the same noise, of the body that was found.");
    if let Some(more) = next.candidates.len().checked_sub(SHOWN + 1) {
        s.say(format!("{} more are in the JSON.", more + 1));
    }
    if let Some((first, error)) = next.refused.first() {
        s.say(format!("{} cannot be made, as {}: {error}.", count(next.refused.len() as u64), first.name()));
    }
    s
}

fn percent(sd: f64) -> String {
    format!("{} %", number(100.0 * sd, 3))
}

fn sd(sd: Option<f64>) -> String {
    sd.map_or_else(|| "not known".to_owned(), percent)
}

/// What is known least, and how well.
fn least_known(now: &Knowledge) -> String {
    let parts: Vec<String> = now
        .least_known
        .iter()
        .filter(|(_, part)| part.abs() >= PART)
        .map(|(name, part)| format!("{} {}", number(*part, 2), meaning(name)))
        .collect();
    let along = format!("along {}", parts.join(", "));
    let of = percent(now.largest_sd);
    match now.unknown {
        0 => format!("Least is known {along}: ± {of}."),
        1 => format!(
            "One direction of the body's numbers is not known. Of the rest least is known {along}: ± {of}."
        ),
        n => format!(
            "{n} directions of the body's numbers are not known. Of the rest least is known {along}: ± {of}."
        ),
    }
}

/// Elements off the diagonal, along principal axes, are turns of these.
fn meaning(name: &str) -> &str {
    match name {
        "i12" => "i12 (a turn about axis 3)",
        "i13" => "i13 (a turn about axis 2)",
        "i23" => "i23 (a turn about axis 1)",
        "center 1" => "centre along axis 1",
        "center 2" => "centre along axis 2",
        "center 3" => "centre along axis 3",
        name => name,
    }
}

fn gain(now: &Knowledge, then: &Knowledge) -> String {
    if then.unknown < now.unknown {
        return format!("{} directions would not be known, where it is {} now", then.unknown, now.unknown);
    }
    format!(
        "what is known least would be so to ± {}, where it is ± {} now",
        percent(then.largest_sd),
        percent(now.largest_sd)
    )
}

/// `{"units": …, "now": {…}, "candidates": […], "refused": […]}`
pub(super) fn to_json<E: Named>(next: &NextExperiment<E>) -> Value {
    let candidate = |candidate: &Candidate<E>| {
        let mut json = candidate.experiment.to_json();
        json["name"] = candidate.experiment.name().into();
        json["then"] = known(&candidate.then);
        json
    };
    let refused = |(experiment, error): &(E, polhode_identify::IdentifyError)| {
        let mut json = experiment.to_json();
        json["name"] = experiment.name().into();
        json["error"] = error.to_string().into();
        json
    };
    json!({
        "units": "tensor over i3, mass over itself, centre over √(i3/mass), along the principal axes; off-diagonal elements times √2",
        "now": known(&next.now),
        "candidates": next.candidates.iter().map(candidate).collect::<Value>(),
        "refused": next.refused.iter().map(refused).collect::<Value>(),
    })
}

fn known(known: &Knowledge) -> Value {
    let least: serde_json::Map<String, Value> =
        known.least_known.iter().map(|(name, part)| ((*name).to_owned(), json!(part))).collect();
    json!({
        "unknown": known.unknown,
        "largest_sd": known.largest_sd,
        "least_known": least,
        "mean_sd": known.mean_sd,
        "moment_sd": known.moment_sd,
    })
}
