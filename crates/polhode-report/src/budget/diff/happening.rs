//! What is to happen over time, in the words of the file.

use polhode::motion::{Exit, Outflow};

use super::words::{direction, point};
use crate::budget::statements::{StatedChange, StatedSequence};
use crate::number::{number, vector};

/// What is said of a sequence, item by item.
pub(super) fn items(sequence: &StatedSequence, digits: usize) -> Vec<(String, String)> {
    let seconds = |time: f64| format!("{} s", number(time, digits));
    let mut all = vec![("sequence, until".to_owned(), seconds(sequence.until))];
    let configuration = sequence.configuration.iter().cloned();
    all.extend(configuration.map(|name| ("sequence, configuration".to_owned(), name)));
    let spin = sequence.spin.map(|spin| format!("{} rad/s", vector(spin.to_array(), digits)));
    all.extend(spin.map(|spin| ("sequence, spin".to_owned(), spin)));
    for (k, burn) in sequence.burns.iter().enumerate() {
        let before = sequence.burns.iter().take(k).filter(|other| other.tank == burn.tank).count();
        let words = format!(
            "{} kg/s from {} until {}",
            number(burn.flow, digits),
            seconds(burn.from),
            seconds(burn.until)
        );
        all.push((format!("burn {} of the tank {}", before + 1, burn.tank), words));
    }
    for change in &sequence.changes {
        all.push(match change {
            StatedChange::Drop { time, rows } => (format!("drop of {}", rows.join(", ")), seconds(*time)),
            StatedChange::Deploy { time, configuration } => {
                (format!("deployment to {configuration}"), seconds(*time))
            }
        });
    }
    match &sequence.outflow {
        Outflow::None => {}
        Outflow::InPlace => all.push(("sequence, in_place".to_owned(), "true".to_owned())),
        Outflow::Exits(exits) => {
            let exits = exits.iter().enumerate();
            all.extend(exits.map(|(k, exit)| (format!("exit {}", k + 1), of_exit(exit, digits))));
        }
    }
    all
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
