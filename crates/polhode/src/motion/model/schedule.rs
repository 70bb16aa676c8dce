//! Schedules: the times at which a torque acts.

use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Times at which a torque acts. Each interval includes its start and excludes its end.
///
/// ```
/// use polhode::motion::torque::Schedule;
/// let train = Schedule::pulses(2.0, 0.5, 3.0, Some(4))?; // 2 … 2.5, 5 … 5.5, 8 … 8.5, 11 … 11.5
/// assert!(train.is_on(5.0) && !train.is_on(5.5));
/// assert_eq!(train.next_change(5.2), 5.5);
/// assert_eq!(train.time_on(100.0), 2.0);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule(ScheduleKind);

#[derive(Clone, Copy, Debug, PartialEq)]
enum ScheduleKind {
    /// One interval; either end may be infinite.
    Window { from: f64, until: f64 },
    /// Pulses with gaps between them: 0 < width < period.
    Pulses { first: f64, width: f64, period: f64, count: Option<u64> },
}

impl Schedule {
    /// Creates a single interval, s. Either end may be infinite.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) unless `from` < `until`.
    pub fn window(from: f64, until: f64) -> Result<Self, MotionError> {
        let rule = "after the time from which it acts";
        require::that("the time until which a torque acts", until, from < until, rule)?;
        Ok(Self(ScheduleKind::Window { from, until }))
    }

    /// Creates a train of pulses: the first begins at `first` (s), each lasts `width` (s) and the
    /// next begins after `period` (s). There are `count` pulses, or infinitely many.
    ///
    /// Pulse k = 0, 1, … begins at first + k period, rounded once, and ends `width` later. Pulses
    /// as wide as the period are contiguous and become one window.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if a number is not finite, if the width
    /// is not positive or exceeds the period, or if the count is zero. Also if the times are so
    /// large that their rounding is as wide as a pulse.
    pub fn pulses(first: f64, width: f64, period: f64, count: Option<u64>) -> Result<Self, MotionError> {
        let width_of = "the width of the pulses";
        require::finite("the time of the first pulse", first)?;
        require::that(width_of, width, width > 0.0, "positive")?;
        require::that(width_of, width, width <= period, "no more than their period")?;
        require::finite("the period of the pulses", period)?;
        require::that("the number of pulses", 0.0, count != Some(0), "at least 1")?;
        let train = Train { first, width, period, count };
        let last = train.begin(count.map_or(0.0, |_| train.last()));
        let is_seen = first + width > first && last + width > last && last.is_finite();
        require::that(width_of, width, is_seen, "more than the rounding of their times")?;
        if width == period {
            let until = count.map_or(f64::INFINITY, |count| train.begin(count as f64));
            return Self::window(first, until);
        }
        Ok(Self(ScheduleKind::Pulses { first, width, period, count }))
    }

    /// Returns the interval [from, until], s; `None` for a train of pulses.
    pub const fn as_window(&self) -> Option<[f64; 2]> {
        match self.0 {
            ScheduleKind::Window { from, until } => Some([from, until]),
            ScheduleKind::Pulses { .. } => None,
        }
    }

    /// Returns the first time, the width and the period of the pulses, s, and their number if it is
    /// finite; `None` for a window.
    pub const fn as_pulses(&self) -> Option<([f64; 3], Option<u64>)> {
        match self.0 {
            ScheduleKind::Pulses { first, width, period, count } => Some(([first, width, period], count)),
            ScheduleKind::Window { .. } => None,
        }
    }

    /// Returns true if the torque acts at this time.
    pub fn is_on(&self, time: f64) -> bool {
        match self.0 {
            ScheduleKind::Window { from, until } => from <= time && time < until,
            ScheduleKind::Pulses { first, width, period, count } => {
                let train = Train { first, width, period, count };
                train.pulse(time).is_some_and(|k| time < train.begin(k) + width)
            }
        }
    }

    /// Returns the first time after `time` at which the torque begins or ends to act; infinite if
    /// there is none.
    pub fn next_change(&self, time: f64) -> f64 {
        let later = |change: f64| if change > time { change } else { f64::INFINITY };
        match self.0 {
            ScheduleKind::Window { from, until } => later(from).min(later(until)),
            ScheduleKind::Pulses { first, width, period, count } => {
                let train = Train { first, width, period, count };
                let Some(k) = train.pulse(time) else { return later(first) };
                let end = later(train.begin(k) + width);
                if k >= train.last() {
                    return end;
                }
                let next = later(train.begin(k + 1.0)).min(end);
                // Where pulses are closer together than adjacent doubles, each double is a change.
                if next < f64::INFINITY { next } else { later(time.next_up()) }
            }
        }
    }

    /// Returns the number of pulses that begin in the interval (from, to]; 0 for a window.
    pub(crate) fn pulses_between(&self, from: f64, to: f64) -> f64 {
        match self.0 {
            ScheduleKind::Window { .. } => 0.0,
            ScheduleKind::Pulses { first, width, period, count } => {
                let train = Train { first, width, period, count };
                let begun = |time: f64| train.pulse(time).map_or(0.0, |k| k + 1.0);
                begun(to) - begun(from)
            }
        }
    }

    /// Returns the duration of action between 0 and `time`, s. For a negative time it is negative:
    /// minus the duration between `time` and 0.
    pub fn time_on(&self, time: f64) -> f64 {
        match self.0 {
            ScheduleKind::Window { from, until } if time >= 0.0 => (time.min(until) - from.max(0.0)).max(0.0),
            ScheduleKind::Window { from, until } => -(until.min(0.0) - from.max(time)).max(0.0),
            ScheduleKind::Pulses { first, width, period, count } => {
                let train = Train { first, width, period, count };
                let ([k, part], [k0, part0]) = (train.progress(time), train.progress(0.0));
                // Counting whole pulses avoids cancellation, even with many pulses before t = 0.
                (k - k0) * width + (part - part0)
            }
        }
    }
}

/// Train of pulses, which may be contiguous.
#[derive(Clone, Copy)]
struct Train {
    first: f64,
    width: f64,
    period: f64,
    count: Option<u64>,
}

impl Train {
    /// Returns first + k period, rounded once: a nondecreasing function of k.
    fn begin(&self, k: f64) -> f64 {
        libm::fma(k, self.period, self.first)
    }

    /// Returns the index of the last pulse.
    fn last(&self) -> f64 {
        self.count.map_or(f64::MAX, |count| count.saturating_sub(1) as f64)
    }

    /// Returns the index of the last pulse that begins at or before a time; `None` before the
    /// first.
    fn pulse(&self, time: f64) -> Option<f64> {
        if !(time >= self.first) {
            return None;
        }
        // Halved operands, so that the difference does not overflow.
        let guess = ((0.5 * time - 0.5 * self.first) / (0.5 * self.period)).floor().min(self.last());
        // The division is rounded, so the pulse may be one of the neighbours.
        let beside = [guess + 1.0, guess, guess - 1.0];
        let k = beside.into_iter().find(|&k| k <= self.last() && self.begin(k) <= time).unwrap_or(0.0);
        Some(k.max(0.0))
    }

    /// Returns the number of pulses before the pulse of a time, and the duration for which that
    /// pulse has acted, s.
    fn progress(&self, time: f64) -> [f64; 2] {
        self.pulse(time).map_or([0.0; 2], |k| [k, (time - self.begin(k)).min(self.width)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps through the changes. Checks that on and off alternate, that times increase, and that
    /// `is_on` agrees between them.
    fn walk(schedule: &Schedule, mut time: f64, changes: usize) -> Vec<f64> {
        let mut seen = Vec::new();
        for _ in 0..changes {
            let next = schedule.next_change(time);
            assert!(next > time, "{schedule:?} at {time}");
            if next == f64::INFINITY {
                break;
            }
            let on = schedule.is_on(time);
            assert_eq!(schedule.is_on(next.next_down()), on, "{schedule:?}: {time} to {next}");
            let middle = 0.5 * time + 0.5 * next;
            assert!(middle >= next || schedule.is_on(middle) == on, "{schedule:?} at {middle}");
            // The increase of the time on is the length of the interval, to the rounding of the
            // times.
            let grown = schedule.time_on(next) - schedule.time_on(time);
            let want = if on { next - time } else { 0.0 };
            let rounding = 8.0 * f64::EPSILON * (next.abs() + time.abs() + schedule.time_on(next).abs());
            assert!((grown - want).abs() <= rounding, "{schedule:?} at {time}: {grown} {want}");
            seen.push(next);
            time = next;
        }
        seen
    }

    #[test]
    fn a_window_holds_its_start_and_not_its_end() {
        let window = Schedule::window(-1.5, 2.25).unwrap();
        assert!(window.is_on(-1.5) && window.is_on(2.25_f64.next_down()));
        assert!(!window.is_on((-1.5_f64).next_down()) && !window.is_on(2.25));
        assert_eq!(walk(&window, -7.0, 9), [-1.5, 2.25]);
        assert_eq!([-9.0, -1.0, 0.0, 1.0, 9.0].map(|t| window.time_on(t)), [-1.5, -1.0, 0.0, 1.0, 2.25]);
        let early = Schedule::window(-5.0, -2.0).unwrap();
        assert_eq!([-6.0, -3.0, -1.0, 7.0].map(|t| early.time_on(t)), [-3.0, -1.0, 0.0, 0.0]);
        let always = Schedule::window(f64::NEG_INFINITY, f64::INFINITY).unwrap();
        assert!(always.is_on(0.0) && always.next_change(3.0) == f64::INFINITY);
        assert_eq!([-3.0, 3.0].map(|t| always.time_on(t)), [-3.0, 3.0]);
    }

    #[test]
    fn pulses_begin_and_end_where_they_should() {
        for (first, width, period, count) in [
            (0.0, 0.1, 0.3, None),
            (-0.7, 0.1, 0.3, Some(1000)),
            (-1e6, 1e-3, 0.1, None),
            (1e9, 0.1, 0.7, None),
            (1e15, 0.25, 0.75, Some(7)),
            (0.1, 0.3_f64.next_down(), 0.3, Some(500)),
            (3.3, 1e-14, 0.1, Some(500)),
        ] {
            let train = Schedule::pulses(first, width, period, count).unwrap();
            let changes = walk(&train, first.next_down(), 700);
            assert!(changes.len() == 700 || Some(changes.len() as u64) <= count.map(|n| 2 * n));
            assert_eq!(changes[0], first);
            // Every begin is first + k period to within its rounding, without accumulated rounding.
            for (k, pair) in changes.chunks(2).enumerate().filter(|_| period - width > 1e-9 && first < 1e14) {
                assert_eq!(pair[0], libm::fma(k as f64, period, first));
                assert_eq!(pair[1], pair[0] + width);
            }
        }
    }

    #[test]
    fn the_billionth_pulse_is_as_exact_as_the_first() {
        let (first, width, period) = (0.3, 0.01, 0.1);
        let train = Schedule::pulses(first, width, period, None).unwrap();
        for k in [1.0, 999_999_999.0, 1e9, 1e9 + 1.0, 3e12] {
            let begin = libm::fma(k, period, first);
            assert!(train.is_on(begin) && !train.is_on(begin.next_down()), "{k}");
            assert_eq!(train.next_change(begin.next_down()), begin);
            assert_eq!(train.next_change(begin), begin + width);
            assert!(!train.is_on(begin + width));
            let on = train.time_on(begin);
            assert!((on / (k * width) - 1.0).abs() < 1e-15, "{k} {on}");
        }
        // counted from 0, independent of earlier pulses
        let old = Schedule::pulses(-1e9, width, period, None).unwrap();
        assert!((old.time_on(0.15) - 0.02).abs() < 1e-7 * width, "{}", old.time_on(0.15));
    }

    #[test]
    fn pulses_are_counted_without_being_gone_through() {
        let train = Schedule::pulses(2.0, 0.5, 3.0, Some(4)).unwrap(); // pulses begin at 2, 5, 8 and 11
        for (from, to, count) in
            [(0.0, 1.9, 0.0), (0.0, 2.0, 1.0), (2.0, 8.1, 2.0), (-1e9, 1e9, 4.0), (11.0, 99.0, 0.0)]
        {
            assert_eq!(train.pulses_between(from, to), count, "{from} {to}");
        }
        let dense = Schedule::pulses(0.0, 1e-20, 2e-20, None).unwrap();
        assert!((dense.pulses_between(0.0, 3.0) / 1.5e20 - 1.0).abs() < 1e-12);
        assert_eq!(Schedule::window(0.0, 1.0).unwrap().pulses_between(-1.0, 9.0), 0.0);
    }

    #[test]
    fn pulses_as_wide_as_their_period_are_one_window() {
        let touching = Schedule::pulses(0.3, 0.1, 0.1, Some(10)).unwrap();
        assert_eq!(touching, Schedule::window(0.3, libm::fma(10.0, 0.1, 0.3)).unwrap());
        let for_ever = Schedule::pulses(0.3, 0.1, 0.1, None).unwrap();
        assert_eq!(for_ever.next_change(0.3), f64::INFINITY);
    }

    #[test]
    fn every_double_is_answered() {
        let dense = Schedule::pulses(0.0, 0.1, 0.3, None).unwrap();
        let far = Schedule::pulses(-1e308, 1e300, 1e301, Some(15)).unwrap();
        let many = Schedule::pulses(1.0, 1e-3, 1e-2, Some(1 << 40)).unwrap();
        for schedule in [dense, far, many] {
            for t in [0.0, -0.0, 5e-324, 1e-300, 4.5e15, 1e17, 1e300, 1e308, f64::MAX] {
                for t in [t, -t] {
                    assert!(schedule.next_change(t) > t, "{schedule:?} {t}");
                    assert!(!schedule.time_on(t).is_nan(), "{schedule:?} {t}");
                    let _ = schedule.is_on(t);
                }
            }
            assert!(!schedule.is_on(f64::NAN));
            assert_eq!(schedule.next_change(f64::NAN), f64::INFINITY);
            assert_eq!(schedule.next_change(f64::INFINITY), f64::INFINITY);
        }
    }

    #[test]
    fn what_is_no_schedule_is_refused() {
        let infinity = f64::INFINITY;
        for (from, until) in [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (0.0, f64::NAN), (infinity, infinity)]
        {
            assert!(Schedule::window(from, until).is_err(), "{from} {until}");
        }
        for (first, width, period, count) in [
            (f64::NAN, 1.0, 2.0, None),
            (infinity, 1.0, 2.0, None),
            (0.0, 0.0, 2.0, None),
            (0.0, -1.0, 2.0, None),
            (0.0, f64::NAN, 2.0, None),
            (0.0, 3.0, 2.0, None),
            (0.0, 1.0, f64::NAN, None),
            (0.0, 1.0, infinity, None),
            (0.0, 1.0, 2.0, Some(0)),
            // times so large that a pulse begins and ends at the same double
            (1e17, 1.0, 2.0, None),
            (0.0, 1.0, 2.0, Some(u64::MAX)),
        ] {
            let refused = Schedule::pulses(first, width, period, count);
            assert!(refused.is_err(), "{first} {width} {period} {count:?}");
        }
    }
}
