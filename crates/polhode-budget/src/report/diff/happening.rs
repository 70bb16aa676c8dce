//! Sequences of changes over time, in the words of the file.

use polhode::motion::{Exit, Outflow};
use polhode_document::number::{number, vector};

use super::item::Item;
use super::words::{direction, names, point};
use crate::read::{OverTime, PlannedChange};

/// Returns the statements about a sequence, item by item.
pub(crate) fn items(sequence: &OverTime, digits: usize) -> Vec<Item> {
    let seconds = |time: f64| format!("{} s", number(time, digits));
    let mut all = vec![Item::new("sequence, until", seconds(sequence.until))];
    let configuration = sequence.configuration.iter();
    all.extend(configuration.map(|name| Item::new("sequence, configuration", name)));
    let spin = sequence.spin.map(|spin| format!("{} rad/s", vector(spin.to_array(), digits)));
    all.extend(spin.map(|spin| Item::new("sequence, spin", spin)));
    all.extend(in_time(&sequence.burns, |burn| burn.from).map(|burn| {
        let words = format!(
            "{} kg/s from {} until {}",
            number(burn.flow, digits),
            seconds(burn.from),
            seconds(burn.until)
        );
        Item::of_several("burn", format!(" of the tank {}", burn.tank), words)
    }));
    all.extend(in_time(&sequence.changes, PlannedChange::time).map(|change| match change {
        PlannedChange::Drop { time, rows } => {
            Item::of_several("drop", format!(" of {}", names(rows)), seconds(*time))
        }
        PlannedChange::Deploy { time, configuration } => {
            Item::of_several("deployment", format!(" to {configuration}"), seconds(*time))
        }
    }));
    match &sequence.outflow {
        Outflow::None => {}
        Outflow::InPlace => all.push(Item::new("sequence, in_place", "true")),
        Outflow::Exits(exits) => {
            all.extend(exits.iter().map(|exit| Item::of_several("exit", "", of_exit(exit, digits))));
        }
    }
    all
}

/// Iterates in ascending order of time.
fn in_time<T>(all: &[T], time: impl Fn(&T) -> f64) -> impl Iterator<Item = &T> {
    let mut all: Vec<&T> = all.iter().collect();
    all.sort_by(|a, b| time(a).total_cmp(&time(b)));
    all.into_iter()
}

fn of_exit(exit: &Exit, digits: usize) -> String {
    let disc = || {
        format!(", radius {} mm, axis {}", number(1e3 * exit.radius, digits), direction(exit.axis, digits))
    };
    format!(
        "position {}{}, share {} %",
        point(exit.position.to_array(), digits),
        if exit.radius > 0.0 { disc() } else { String::new() },
        number(100.0 * exit.share, digits)
    )
}
