//! A body over time, as a scenario and the table that it names.

use core::fmt::Write as _;

use polhode::math::{AngularVelocity, Body, Direction};
use polhode::motion::{Exit, Outflow};
use polhode_source::toml::BodyPart;

use super::states::history;
use super::table::to_csv;
use crate::{Sequence, SequenceError};

/// Between corners a history has so many cubics.
const PIECES: usize = 16;
/// Samples of a run.
const SAMPLES: f64 = 600.0;

/// What a scenario of a body over time has besides the body.
#[derive(Clone, Debug)]
pub struct HistoryOptions<'a> {
    /// What it is of.
    pub title: &'a str,
    /// To when, from 0 on, s.
    pub until: f64,
    /// What the body has at first; it is at rest without.
    pub spin: Option<AngularVelocity<Body>>,
    /// Where mass leaves.
    pub outflow: &'a Outflow,
    /// The file of the table, as the scenario names it.
    pub table: &'a str,
}

/// A scenario that `simulate` runs, and the table that it names, CSV.
///
/// # Errors
/// As [`Sequence::history`].
pub fn history_files(
    sequence: &Sequence<'_>,
    options: &HistoryOptions<'_>,
) -> Result<[String; 2], SequenceError> {
    let span = [0.0, options.until];
    sequence.history(span, PIECES, options.outflow.clone())?;
    let rows = sequence.rows(span, PIECES)?;
    let first = rows.first().ok_or(SequenceError::Nothing { time: 0.0 })?;
    let comment = format!("{}: the whole at t = 0, with what is in its tanks", options.title);
    let mut toml = BodyPart::of_body(comment, "whole", &first.properties).to_toml();
    let _ = write!(toml, "\n[mass_history]\ntable = {}\n", quoted(options.table));
    match options.outflow {
        Outflow::None => {}
        Outflow::InPlace => toml += "in_place = true\n",
        Outflow::Exits(exits) => exits.iter().for_each(|exit| toml += &of_exit(exit)),
    }
    if let Some(spin) = options.spin {
        let [x, y, z] = spin.to_array();
        let _ = write!(toml, "\n[start]\nspin = {{ body = [{x:?}, {y:?}, {z:?}] }}\n");
    }
    let (until, every) = (options.until, options.until / SAMPLES);
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

/// A string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = "\"".to_owned();
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted += &format!("\\u{:04X}", u32::from(c)),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
