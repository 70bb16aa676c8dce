//! Stability in words.

use std::f64::consts::TAU;

use polhode_document::fact::{Fact, Quantity};
use polhode_document::unit::time;

/// Significant digits of a number in an answer.
pub(crate) const DIGITS: usize = 4;

/// Maximum number of oscillation periods in an answer; the facts contain all of them.
const MOST_PERIODS: usize = 3;

/// Creates a fact with six significant digits.
pub(crate) fn fact(key: &str, label: &str, value: impl Into<Quantity>) -> Fact {
    Fact::new(key, label, value).digits(6)
}

/// Returns the frequency (rad/s), period (s) and growth rate (1/s) of a mode, under these keys of
/// its object.
pub(crate) fn rates([frequency, growth_rate]: [f64; 2]) -> [Fact; 3] {
    let period = (frequency > 0.0).then(|| Quantity::Duration(TAU / frequency));
    [
        fact("frequency", "frequency", Quantity::Number(frequency, "rad/s"))
            .shown_if(frequency > 0.0)
            .detail(),
        fact("", "oscillation period", period),
        fact("growth_rate", "growth rate", Quantity::Number(growth_rate, "/s")).shown_if(growth_rate != 0.0),
    ]
}

/// Returns `stable (oscillation periods 2 s and 3 s)` or `unstable (e-folding time 1.7 s)`. The
/// arguments are the frequency (rad/s) and growth rate (1/s) of each mode.
pub(crate) fn verdict(modes: &[[f64; 2]]) -> String {
    let fastest = modes.iter().map(|mode| mode[1]).reduce(f64::max);
    match fastest {
        None => "neutral (every rate is zero)".to_owned(),
        Some(rate) if rate > 0.0 => format!("unstable ({})", e_folding(&[rate])),
        Some(rate) if rate < 0.0 => {
            format!("stable (deviations decay with a time constant of at most {})", time(-1.0 / rate, DIGITS))
        }
        Some(_) => {
            let mut periods: Vec<String> = Vec::new();
            for [frequency, _] in modes.iter().filter(|mode| mode[0] > 0.0) {
                let period = time(TAU / frequency, DIGITS);
                if !periods.contains(&period) {
                    periods.push(period);
                }
            }
            let plural = if periods.len() == 1 { "" } else { "s" };
            match periods.len() {
                1..=MOST_PERIODS => format!("stable (oscillation period{plural} {})", listed(&periods)),
                _ => "stable".to_owned(),
            }
        }
    }
}

/// Formats growth rates as `e-folding time 1.7 s` or `e-folding times 1.7 s and 20 s`.
pub(crate) fn e_folding(growth_rates: &[f64]) -> String {
    let times: Vec<String> = growth_rates.iter().map(|rate| time(1.0 / rate, DIGITS)).collect();
    format!("e-folding time{} {}", if times.len() == 1 { "" } else { "s" }, listed(&times))
}

/// Joins names: `1, 2 and 3`.
pub(crate) fn listed(names: &[String]) -> String {
    match names {
        [rest @ .., last] if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        names => names.concat(),
    }
}

/// Joins the names of torques: `the torque "wind" and the torque "drag"`.
pub(crate) fn torques(names: &[String]) -> String {
    listed(&names.iter().map(|name| format!("the torque \"{name}\"")).collect::<Vec<_>>())
}
