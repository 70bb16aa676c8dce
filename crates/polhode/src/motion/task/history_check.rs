//! Checks of a body with changing mass properties, before it runs.

use super::scenario::Scenario;
use crate::body::finding::{Finding, Severity};
use crate::motion::error::plain;

impl Scenario {
    /// Returns a finding that the mass properties are those at the start, for a computation that
    /// assumes constant ones. `None` if they are constant.
    pub fn taken_at_start(&self) -> Option<Finding> {
        self.history()?;
        let time = plain(self.start().time);
        let message = format!("the mass properties change with time: these are those at t = {time} s");
        Some(Finding { code: "mass_history.start", severity: Severity::Info, message, place: None })
    }

    /// Returns the end of the run, s; infinite without a run.
    fn end(&self) -> f64 {
        self.run().and_then(|run| run.times.last().copied()).unwrap_or(f64::INFINITY)
    }

    /// Returns a finding if nothing changes during the run.
    pub(super) fn idle_history(&self) -> Option<Finding> {
        let history = self.history()?;
        let [start, end] = [self.start().time, self.end()];
        if history.changes_between(start, end) {
            return None;
        }
        let before = history.changes().map(|[_, until]| until).filter(|until| *until <= start).last();
        let after = history.changes().map(|[from, _]| from).find(|from| *from >= end);
        let before =
            before.map(|until| format!("until t = {} s, and the run starts at {start} s", plain(until)));
        let after = after.map(|from| format!("from t = {} s on, and the run ends at {end} s", plain(from)));
        let message = match [before, after] {
            [None, None] => {
                "the mass properties never change: all rows of their history are alike".to_owned()
            }
            [Some(before), Some(after)] => {
                format!("the mass properties change only {before}, and {after}: the body stays as it is")
            }
            [only, None] | [None, only] => {
                format!(
                    "the mass properties change only {}: the body stays as it is",
                    only.unwrap_or_default()
                )
            }
        };
        Some(Finding { code: "mass_history.idle", severity: Severity::Warning, message, place: None })
    }

    /// Returns a finding if the neglected angular momentum of the internal flow may be significant.
    pub(super) fn flow_left_out(&self) -> Option<Finding> {
        /// Threshold relative to I ω at the start.
        const SMALL: f64 = 1e-2;
        let history = self.history()?;
        let [start, end] = [self.start().time, self.end()];
        let own = self.rotor().angular_momentum(self.start().omega).norm();
        let flow = |time: f64| history.flow_momentum(time, self.pivot()).unwrap_or_default();
        // On a straight line the distance is largest at an end: just after a row, or just before
        // the next.
        let rows = || history.times().filter(|time| start < *time && *time < end);
        let last = Some(end).filter(|end| end.is_finite() && *end > start);
        let begins = rows().chain([start]).map(|time| (flow(time), time));
        let ends = rows().chain(last).map(|time| (flow(time.next_down()), time));
        let (most, time) = begins.chain(ends).max_by(|(a, _), (b, _)| a.total_cmp(b))?;
        (most > SMALL * own).then(|| Finding {
            code: "mass_history.flow",
            severity: Severity::Warning,
            message: format!(
                "at t = {} s what runs to the exits has {} kg·m²/s of angular momentum in the body if it runs straight, beside {} kg·m²/s of the body at \
                 the start: the motion leaves that out, as the centre of mass is taken to move along the way to the exit",
                plain(time),
                two_digits(most),
                two_digits(own)
            ),
            place: None,
        })
    }
}

fn two_digits(x: f64) -> String {
    plain(format!("{x:.1e}").parse().unwrap_or(x))
}
