//! When a torque acts.

/// The times at which a torque acts. Each interval holds its start and not its end.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Schedule {
    /// From one time to another, s; either may be infinite.
    Window {
        /// The first time.
        from: f64,
        /// The first time at which it no longer acts.
        until: f64,
    },
    /// A train of pulses: `width` of every `period`.
    Pulses {
        /// When the first begins, s.
        first: f64,
        /// How long each is, s.
        width: f64,
        /// From the start of one to the start of the next, s.
        period: f64,
        /// How many there are; `None`: they never end.
        count: Option<u64>,
    },
}

impl Schedule {
    /// Does it act at this time?
    pub fn is_on(&self, time: f64) -> bool {
        match *self {
            Self::Window { from, until } => from <= time && time < until,
            Self::Pulses { width, .. } => self.pulse(time).is_some_and(|start| time < start + width),
        }
    }

    /// The first time after this one at which it begins or ends; infinite if there is none.
    pub fn next_change(&self, time: f64) -> f64 {
        let later = |change: f64| if change > time { change } else { f64::INFINITY };
        match *self {
            Self::Window { from, until } => later(from).min(later(until)),
            Self::Pulses { first, width, period, count } => {
                let Some(start) = self.pulse(time) else { return later(first) };
                let index = ((start - first) / period).round();
                let more = count.is_none_or(|count| index + 1.0 < count as f64);
                let next = if more { first + (index + 1.0) * period } else { f64::INFINITY };
                later(start + width).min(next)
            }
        }
    }

    /// For how long it has acted from t = 0 to a time, s; negative for times before 0.
    pub fn time_on(&self, time: f64) -> f64 {
        self.since_ever(time) - self.since_ever(0.0)
    }

    /// For how long it has acted before a time, counted from where that is zero.
    fn since_ever(&self, time: f64) -> f64 {
        match *self {
            // A window that was always open is counted from 0.
            Self::Window { from, until } => {
                time.min(until) - if from.is_finite() { from.min(time) } else { 0.0 }
            }
            Self::Pulses { first, width, period, .. } => self
                .pulse(time)
                .map_or(0.0, |start| ((start - first) / period).round() * width + (time - start).min(width)),
        }
    }

    /// The start of the pulse whose period a time is in; the last one's for later times; `None` before the first.
    fn pulse(&self, time: f64) -> Option<f64> {
        let Self::Pulses { first, period, count, .. } = *self else { return None };
        if !(time >= first) {
            return None;
        }
        let mut index = ((time - first) / period).floor();
        // Rounding of the division must not miss a start that is a double.
        if first + (index + 1.0) * period <= time {
            index += 1.0;
        } else if first + index * period > time {
            index -= 1.0;
        }
        let last = count.map_or(f64::INFINITY, |count| count.saturating_sub(1) as f64);
        Some(first + index.min(last) * period)
    }
}
