//! The range of a gyro: a reading at its limit is no measurement.

use super::flight::{Flight, GyroReading, LEAST_READINGS};
use crate::error::IdentifyError;

/// The least and the greatest reading that a gyro has of each component, rad/s: infinite where there is no limit that shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GyroRange {
    /// Readings at this or below are none.
    pub low: [f64; 3],
    /// Readings at this or above are none.
    pub high: [f64; 3],
}

/// Equal readings that make a limit, at least.
const LEAST_EQUAL: usize = 4;
/// How many times more often a limit is read than a value is on average.
const OFTEN: f64 = 4.0;
/// Steps of the readings next to a limit, in which half as many readings are at most: of the smooth top of a motion twice as many are.
const STEPS: f64 = 8.0;

impl GyroRange {
    /// From −limit to +limit.
    pub const fn within(limit: f64) -> Self {
        Self { low: [-limit; 3], high: [limit; 3] }
    }

    /// The limits that readings show: the greatest or least of a component, if it is read again and again and what is next to it is not. Where limits of
    /// several components are the same, each needs fewer readings. A few readings beyond, which are faults, do not hide it.
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

    /// Whether a reading is inside.
    pub fn holds(&self, reading: &GyroReading) -> bool {
        (0..3).all(|axis| self.side(reading, axis).is_none())
    }

    /// The limit that a component has reached.
    fn side(&self, reading: &GyroReading, axis: usize) -> Option<f64> {
        let value = reading.omega.to_array()[axis];
        [self.low[axis], self.high[axis]]
            .into_iter()
            .find(|limit| if *limit < 0.0 { value <= *limit } else { value >= *limit })
    }

    /// The flights without readings at a limit.
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

    /// What is at which limit, in the order of components.
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

/// Readings that are at a limit of a gyro.
#[derive(Clone, Debug, PartialEq)]
pub struct Reached {
    /// Of which component: 0, 1, 2.
    pub axis: usize,
    /// rad/s
    pub limit: f64,
    /// How many there are in all flights.
    pub count: usize,
    /// The flight of the first.
    pub flight: String,
    /// Its time, s.
    pub time: f64,
}

/// The greatest value that is read again and again.
struct Top {
    value: f64,
    /// How often it is read.
    equal: usize,
    /// How many readings are a few steps below.
    next: usize,
    /// How often a value is read on average.
    mean: f64,
}

impl Top {
    /// Of values, of which a few may be beyond: one in two hundred.
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

    /// Smooth rates, rounded to steps and held within a limit.
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
