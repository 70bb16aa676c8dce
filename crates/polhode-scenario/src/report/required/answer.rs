//! Answer to the question of the required torque.

use polhode_document::number::{number, tidy_beside};

use super::RequiredReport;
use crate::report::answer::{DIGITS, torque_needed};

/// Returns the torque, the power and work, and the bearing forces of a shaft.
pub(super) fn lines(report: &RequiredReport) -> Vec<String> {
    let (first, largest, scale) = (report.first(), report.largest(), report.scale());
    let run = report.is_run().then(|| [largest.torque.norm(), largest.state.time]);
    let mut lines = vec![torque_needed(first.torque.norm(), run, scale), power(report)];
    lines.extend(report.shaft.as_ref().map(super::ShaftReport::answer));
    lines
}

fn power(report: &RequiredReport) -> String {
    let (first, most, last) = (report.first(), report.most_power(), report.last());
    let shown = |x: f64, scale: f64| number(tidy_beside([x, 0.0, 0.0], 10.0 * scale)[0], DIGITS);
    let [start, largest] = [first, most].map(|s| shown(s.power, report.power_scale()));
    let work = shown(last.work_since(first), report.energy());
    match (report.is_run(), largest.as_str()) {
        (false, _) => format!("The power is {start} W at the start."),
        (true, "0") => "The power is 0 W throughout.".to_owned(),
        (true, largest) => {
            let when = number(most.state.time, DIGITS);
            format!(
                "Largest power: {largest} W (t = {when} s), {start} W at the start; work over the run: {work} J."
            )
        }
    }
}
