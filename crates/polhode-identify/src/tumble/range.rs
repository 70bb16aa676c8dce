//! Range of a gyro: readings at its limits are not measurements.

use super::flight::{Flight, GyroReading, LEAST_READINGS};
use crate::error::IdentifyError;

/// Saturation limits of each component of a gyro, rad/s: infinite where no limit is evident.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GyroRange {
    /// Lower saturation limits; readings at or below them are discarded.
    pub low: [f64; 3],
    /// Upper saturation limits; readings at or above them are discarded.
    pub high: [f64; 3],
}

/// Minimum number of equal readings at a limit.
const LEAST_EQUAL: usize = 4;
/// Minimum frequency of a limit, relative to the mean frequency of a value.
const OFTEN: f64 = 4.0;
/// Width of the band below a limit, in resolution steps. At a limit the band has at most half as
/// many readings as the limit itself; at a smooth maximum it has about twice as many.
const STEPS: f64 = 8.0;

impl GyroRange {
    /// Returns the range from −limit to +limit.
    pub const fn within(limit: f64) -> Self {
        Self { low: [-limit; 3], high: [limit; 3] }
    }

    /// Estimates the limits from readings. An extreme value of a component is a limit if it occurs
    /// often and the values next to it do not. Equal limits of several components need fewer
    /// readings each. A few faulty readings beyond a limit do not hide it.
    pub fn shown_by(readings: &[GyroReading]) -> Self {
        let mut range = Self::within(f64::INFINITY);
        let mut tops: Vec<(usize, bool, Top)> = Vec::new();
        for axis in 0..3 {
            for is_high in [false, true] {
                let sign = if is_high { 1.0 } else { -1.0 };
                let values = readings.iter().map(|r| sign * r.omega.to_array()[axis]).collect();
                tops.extend(Top::of(values).map(|top| (axis, is_high, top)));
            }
        }
        for (axis, is_high, top) in &tops {
            let alike = tops.iter().filter(|(.., other)| other.value == top.value).map(|(.., other)| other);
            let together = alike.fold((0, 0, 0), |(many, equal, next), other| {
                (many + 1, equal + other.equal, next + other.next)
            });
            let is_limit = match together {
                (1, equal, next) => equal >= LEAST_EQUAL && equal > 2 * next,
                (_, equal, next) => equal >= LEAST_EQUAL && equal > next,
            };
            if is_limit && top.equal as f64 >= 2.0_f64.max(OFTEN * top.mean) {
                match is_high {
                    true => range.high[*axis] = top.value,
                    false => range.low[*axis] = -top.value,
                }
            }
        }
        range
    }

    /// Returns true if a reading is inside the range.
    pub fn holds(&self, reading: &GyroReading) -> bool {
        (0..3).all(|axis| self.side(reading, axis).is_none())
    }

    /// Returns the limit that a component has reached, if any.
    fn side(&self, reading: &GyroReading, axis: usize) -> Option<f64> {
        let value = reading.omega.to_array()[axis];
        [self.low[axis], self.high[axis]]
            .into_iter()
            .find(|limit| if *limit < 0.0 { value <= *limit } else { value >= *limit })
    }

    /// Returns the flights without readings at a limit.
    pub(super) fn inside(&self, flights: &[Flight]) -> Result<Vec<Flight>, IdentifyError> {
        let each = flights.iter().map(|flight| {
            let (given, inside) =
                (flight.gyro().len(), flight.of_gyro_readings(|reading| self.holds(reading)));
            let left = inside.gyro().len();
            if left < LEAST_READINGS && left < given {
                return Err(IdentifyError::Saturated {
                    flight: flight.name().to_owned(),
                    inside: left,
                    given,
                });
            }
            Ok(inside)
        });
        each.collect()
    }

    /// Returns the limits that were reached, in order of components.
    pub(super) fn reached(&self, flights: &[Flight]) -> Vec<Reached> {
        let mut all: Vec<Reached> = Vec::new();
        for flight in flights {
            for reading in flight.gyro() {
                for axis in 0..3 {
                    let Some(limit) = self.side(reading, axis) else { continue };
                    match all.iter_mut().find(|reached| (reached.axis, reached.limit) == (axis, limit)) {
                        Some(reached) => reached.count += 1,
                        None => all.push(Reached {
                            axis,
                            limit,
                            count: 1,
                            flight: flight.name().to_owned(),
                            time: reading.time,
                        }),
                    }
                }
            }
        }
        all.sort_by_key(|reached| (reached.axis, reached.limit < 0.0));
        all
    }
}

/// Readings at one limit of a gyro.
#[derive(Clone, Debug, PartialEq)]
pub struct Reached {
    /// Component: 0, 1 or 2.
    pub axis: usize,
    /// Limit, rad/s.
    pub limit: f64,
    /// Number of readings at the limit, in all flights.
    pub count: usize,
    /// Name of the flight with the first of them.
    pub flight: String,
    /// Time of the first of them, s.
    pub time: f64,
}

/// Largest value that occurs repeatedly.
struct Top {
    value: f64,
    /// Number of readings with this value.
    equal: usize,
    /// Number of readings at most [`STEPS`] steps below it.
    next: usize,
    /// Mean number of readings per distinct value.
    mean: f64,
}

impl Top {
    /// Finds the largest repeated value. At most one reading in two hundred may lie beyond it.
    fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(|a, b| b.total_cmp(a));
        let distinct: Vec<&[f64]> = values.chunk_by(|a, b| a == b).collect();
        let step =
            distinct.windows(2).map(|two| two[0][0] - two[1][0]).reduce(f64::min).unwrap_or(f64::INFINITY);
        let mut beyond = 0;
        for group in &distinct {
            if group.len() >= 2 || beyond * 200 >= values.len() {
                let value = group[0];
                let below = &values[beyond + group.len()..];
                let next = below.iter().take_while(|v| value - **v < (STEPS + 0.5) * step).count();
                let mean = values.len() as f64 / distinct.len() as f64;
                return (group.len() >= 2 && value > 0.0).then_some(Self {
                    value,
                    equal: group.len(),
                    next,
                    mean,
                });
            }
            beyond += group.len();
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use polhode::math::AngularVelocity;

    use super::*;

    /// Returns smooth rates, rounded to steps and clamped to a limit.
    fn readings(step: f64, limit: f64, hold: usize) -> Vec<GyroReading> {
        (0..600)
            .map(|k| {
                let t = 0.01 * (k / hold * hold) as f64;
                let wave = |size: f64, rate: f64, phase: f64| {
                    let value = size * libm::sin(rate * t + phase) + 0.3 * libm::cos(3.1 * rate * t);
                    let value = if step > 0.0 { (value / step).round() * step } else { value };
                    value.clamp(-limit, limit)
                };
                let omega = [wave(6.3, 7.9, 0.3), wave(5.1, 7.9, 1.7), wave(7.7, 2.3, 0.9)];
                GyroReading { time: 0.01 * k as f64, omega: AngularVelocity::from_array(omega) }
            })
            .collect()
    }

    #[test]
    fn a_limit_shows_and_a_top_does_not() {
        for step in [0.0, 1e-3, 0.01, 0.05, 0.1, 0.5] {
            for hold in [1, 2, 5] {
                let free = GyroRange::shown_by(&readings(step, 1e9, hold));
                assert_eq!(free, GyroRange::within(f64::INFINITY), "{step} {hold}");
            }
        }
        for step in [0.0, 1e-3, 0.01, 0.05] {
            let range = GyroRange::shown_by(&readings(step, 5.8, 1));
            assert_eq!((range.high[0], range.low[0]), (5.8, -5.8), "{step}");
            assert_eq!((range.high[2], range.low[2]), (5.8, -5.8), "{step}");
            assert_eq!((range.high[1], range.low[1]), (f64::INFINITY, f64::NEG_INFINITY), "{step}");
        }
    }

    #[test]
    fn what_is_beyond_a_limit_does_not_hide_it() {
        let mut log = readings(0.0, 5.8, 1);
        log[77].omega.x = 31.0;
        log[200].omega.x = 12.0;
        let range = GyroRange::shown_by(&log);
        assert_eq!(range.high[0], 5.8);
        assert!(!range.holds(&log[77]) && log.iter().filter(|r| range.holds(r)).count() > 200);
    }
}
