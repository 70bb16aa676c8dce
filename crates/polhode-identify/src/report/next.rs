//! Report of the most useful next experiment.

use polhode_document::Section;
use polhode_document::number::{count, counted, number};
use serde_json::{Value, json};

use crate::{Candidate, Knowledge, NextExperiment};

/// Maximum number of experiments shown.
const SHOWN: usize = 6;
/// Threshold below which components of a direction are not listed.
const PART: f64 = 0.3;

/// Name of an experiment, for people and for programs.
pub(crate) trait Named {
    /// Returns the experiment as a phrase that continues "Most useful:".
    fn name(&self) -> String;

    /// Returns further settings of the experiment, if any.
    fn details(&self) -> Option<String>;

    /// Returns the experiment as JSON.
    fn to_json(&self) -> Value;
}

pub(crate) fn section<E: Named>(next: &NextExperiment<E>) -> Section {
    let mut s = Section::new(0, "Recommended next measurements");
    let now = &next.now;
    s.say(match now.unknown {
        0 => format!("Largest uncertainty: {}, {}.", plus_minus(now.largest_sd), direction(now)),
        1 => "1 direction of the body's parameters is unobservable.".to_owned(),
        n => format!("{n} directions of the body's parameters are unobservable."),
    });
    match next.best() {
        Some(best) => {
            s.say(format!("Most useful: {}. {}.", in_full(&best.experiment), gain(now, &best.then)));
        }
        None if now.unknown > 0 => {
            s.say("None of the experiments below makes an unobservable direction observable: another kind of experiment is needed.");
        }
        None => s.say(
            "None of the experiments below would alone reduce the largest uncertainty by more than 1 %.",
        ),
    }
    if next.together.len() > 1 {
        let all: Vec<String> = next.together.iter().map(|&k| next.candidates[k].experiment.name()).collect();
        s.say(format!("Together, these experiments make all directions observable: {}.", all.join("; ")));
    }
    table(&mut s, next);
    s.say("Uncertainties (1σ) are relative to the greatest moment i3. They are linear predictions for the estimated body, with the same noise.");
    if next.candidates.len() > SHOWN {
        s.say(format!("The JSON output lists all {} experiments.", next.candidates.len()));
    }
    if let Some((first, error)) = next.refused.first() {
        s.say(format!(
            "Not feasible: {}, for example {}: {error}.",
            counted(next.refused.len(), "other experiment"),
            first.name()
        ));
    }
    s
}

/// Adds a table of the best candidates. If directions are unobservable, the principal axes are too,
/// and moments along them have no meaning.
fn table<E: Named>(s: &mut Section, next: &NextExperiment<E>) {
    let is_known = next.now.unknown == 0;
    let row = |name: String, known: &Knowledge| {
        let mut row = vec![name];
        if is_known {
            row.push(percent(known.largest_sd));
            row.extend(known.moment_sd.map(sd));
        } else {
            row.extend([count(known.unknown as u64), percent(known.mean_sd)]);
        }
        row
    };
    // Candidates of equal name differ in their details.
    let names: Vec<String> = next.candidates.iter().map(|c| c.experiment.name()).collect();
    let is_clear = |name: &String| names.iter().filter(|other| *other == name).count() == 1;
    let shown = next.candidates.iter().zip(&names).take(SHOWN).map(|(candidate, name)| {
        let name = if is_clear(name) { name.clone() } else { in_full(&candidate.experiment) };
        row(name, &candidate.then)
    });
    let headers: &[&str] = if is_known {
        &["experiment", "largest uncertainty", "i1", "i2", "i3"]
    } else {
        &["experiment", "unobservable directions", "mean uncertainty of the others"]
    };
    s.table(headers, core::iter::once(row("present state".to_owned(), &next.now)).chain(shown).collect());
}

fn in_full(experiment: &impl Named) -> String {
    let details = experiment.details().map(|details| format!(" ({details})"));
    experiment.name() + &details.unwrap_or_default()
}

fn percent(sd: f64) -> String {
    format!("{} %", number(100.0 * sd, 3))
}

/// Returns text such as `± 0.426 %`, which is not broken over two lines.
fn plus_minus(sd: f64) -> String {
    format!("± {}", percent(sd)).replace(' ', "\u{a0}")
}

fn sd(sd: Option<f64>) -> String {
    sd.map_or_else(|| "unobservable".to_owned(), percent)
}

/// Returns a direction as text: `along 0.71 i3, 0.61 i2`.
fn direction(now: &Knowledge) -> String {
    let parts = now.least_known.iter().filter(|(_, part)| part.abs() >= PART);
    let parts: Vec<String> =
        parts.map(|(name, part)| format!("{} {}", number(*part, 2), meaning(name))).collect();
    format!("along {}", parts.join(", "))
}

/// Returns a parameter's name with its meaning. Off-diagonal elements along principal axes are
/// rotations of these axes.
fn meaning(name: &str) -> &str {
    match name {
        "i12" => "i12 (rotation about axis 3)",
        "i13" => "i13 (rotation about axis 2)",
        "i23" => "i23 (rotation about axis 1)",
        "center 1" => "centre of mass along axis 1",
        "center 2" => "centre of mass along axis 2",
        "center 3" => "centre of mass along axis 3",
        name => name,
    }
}

fn gain(now: &Knowledge, then: &Knowledge) -> String {
    if then.unknown < now.unknown {
        return match then.unknown {
            0 => "It would make all directions observable".to_owned(),
            n => format!("It would reduce the number of unobservable directions from {} to {n}", now.unknown),
        };
    }
    format!(
        "It would reduce the largest uncertainty from {} to {}",
        plus_minus(now.largest_sd),
        plus_minus(then.largest_sd)
    )
}

/// Returns JSON: `{"units": …, "now": {…}, "candidates": […], "refused": […]}`.
pub(crate) fn to_json<E: Named>(next: &NextExperiment<E>) -> Value {
    let candidate = |candidate: &Candidate<E>| {
        let mut json = candidate.experiment.to_json();
        json["name"] = candidate.experiment.name().into();
        json["then"] = known(&candidate.then);
        json
    };
    let refused = |(experiment, error): &(E, crate::IdentifyError)| {
        let mut json = experiment.to_json();
        json["name"] = experiment.name().into();
        json["error"] = error.to_string().into();
        json
    };
    json!({
        "units": "along the principal axes: tensor relative to i3, mass relative to itself, centre of mass relative to √(i3/mass); off-diagonal elements multiplied by √2",
        "now": known(&next.now),
        "together": next.together,
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
