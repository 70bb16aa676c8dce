//! Body over time, as a scenario and the table that it refers to.

use core::fmt::Write as _;
use std::path::Path;

use polhode::math::Direction;
use polhode::motion::{Exit, Outflow};
use polhode_source::Failure;
use polhode_source::toml::BodyPart;

use super::states::history;
use super::table::to_csv;
use crate::read::{BudgetFile, OverTime, quoted};
use crate::request::MadeFile;
use crate::{Basis, Sequence, SequenceError};

/// Number of cubics of a history between two corners.
const PIECES: usize = 16;
/// Number of samples of a run.
const SAMPLES: f64 = 600.0;

/// Returns the failure of a list without a sequence.
pub(crate) fn nothing() -> Failure {
    Failure::usage(
        "the list has no sequence",
        "add [sequence] with until, and [[burn]], [[drop]] or [[deploy]]; --body prints the body without a sequence",
    )
}

/// Returns the table of a body over time, and the scenario for `simulate` that refers to it.
pub(crate) fn files(file: &BudgetFile, basis: Basis, target: &Path) -> Result<[MadeFile; 2], Failure> {
    let over_time = file.prescribed.as_ref().and_then(|all| Some((all, all.over_time.as_ref()?)));
    let (prescribed, over_time) = over_time.ok_or_else(nothing)?;
    if target.extension().is_none_or(|extension| extension != "toml") {
        let hint = "use a file name that ends in .toml; the table gets the same name with .csv";
        return Err(Failure::usage("a scenario is a TOML file", hint).in_file(target));
    }
    let sequence = prescribed.sequence(over_time.configuration.as_deref(), basis);
    let sequence = sequence.ok_or_else(|| Failure::usage("unknown configuration", ""))?;
    let beside = target.with_extension("csv");
    let table = beside.file_name().unwrap_or_default().to_string_lossy();
    let title = file.title.as_deref().unwrap_or("a parts list");
    let texts = texts(&sequence, over_time, title, &table).map_err(|error| no_history(&error, over_time))?;
    let [scenario, rows] = texts.map(String::into_bytes);
    Ok([(beside, rows), (target.to_owned(), scenario)])
}

/// Returns the failure of a mass history. The most frequent cause is that no exit of mass is
/// stated.
fn no_history(error: &SequenceError, over_time: &OverTime) -> Failure {
    let hint = match (error, &over_time.outflow) {
        (SequenceError::Motion(_), Outflow::None) if !over_time.burns.is_empty() => {
            "define where mass leaves the body: [[exit]] with position, or in_place = true in [sequence]"
        }
        (SequenceError::Motion(_), Outflow::InPlace) => {
            "define where mass leaves the body: [[exit]] with position, without in_place"
        }
        _ => error.hint().unwrap_or_default(),
    };
    Failure::usage(error.to_string(), hint)
}

/// Returns the text of the scenario and of its table.
fn texts(
    sequence: &Sequence<'_>,
    over_time: &OverTime,
    title: &str,
    table: &str,
) -> Result<[String; 2], SequenceError> {
    let span = [0.0, over_time.until];
    sequence.history(span, PIECES, over_time.outflow.clone())?;
    let rows = sequence.rows(span, PIECES)?;
    let first = rows.first().ok_or(SequenceError::Nothing { time: 0.0 })?;
    let comment = format!("{title}: mass properties at t = 0, including tank contents");
    let mut toml = BodyPart::of_body(comment, "whole", &first.properties).to_toml();
    let _ = write!(toml, "\n[mass_history]\ntable = {}\n", quoted(table));
    match &over_time.outflow {
        Outflow::None => {}
        Outflow::InPlace => toml += "in_place = true\n",
        Outflow::Exits(exits) => exits.iter().for_each(|exit| toml += &of_exit(exit)),
    }
    if let Some(spin) = over_time.spin {
        let [x, y, z] = spin.to_array();
        let _ = write!(toml, "\n[start]\nspin = {{ body = [{x:?}, {y:?}, {z:?}] }}\n");
    }
    let (until, every) = (over_time.until, over_time.until / SAMPLES);
    let _ = write!(toml, "\n[run]\nduration = {until:?}\nevery = {every:?}\n");
    Ok([toml, to_csv(&history(&rows))])
}

fn of_exit(exit: &Exit) -> String {
    let [x, y, z] = exit.position.to_array();
    let mut text =
        format!("\n[[mass_history.exit]]\nposition = [{x:?}, {y:?}, {z:?}]\nshare = {:?}\n", exit.share);
    if exit.radius > 0.0 && exit.axis != Direction::ZERO {
        let [x, y, z] = exit.axis.to_array();
        let _ = write!(text, "radius = {:?}\naxis = [{x:?}, {y:?}, {z:?}]\n", exit.radius);
    }
    text
}
