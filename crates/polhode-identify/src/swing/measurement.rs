//! Measurements of a swing.

use core::f64::consts::TAU;

use crate::decomposition::lu;
use crate::error::IdentifyError;

/// Measurement of a swing.
#[derive(Clone, Debug, PartialEq)]
pub enum Measurement {
    /// Counted periods.
    Counted(Counted),
    /// Time series of the motion.
    Logged(Logged),
}

/// Law of damping. dA/dt is proportional to A for viscous and to A² for quadratic damping.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Damping {
    /// Negligible damping.
    None,
    /// Torque −2 a I θ̇: the amplitude decays as exp(−a t).
    Viscous,
    /// Torque −β I |θ̇| θ̇: the amplitude decays as 1/(1 + (4/3π) β A₀ φ), φ the phase.
    Quadratic,
    /// Viscous and quadratic damping.
    Both,
}

/// Times of counted periods, and amplitude readings.
///
/// Counts start at 0 with the first timed swing. Time the passages through the middle position:
/// with quadratic damping turning points are slightly shifted, each by another amount. Counts of
/// intervals are whole numbers; those of amplitude readings need not be.
#[derive(Clone, Debug, PartialEq)]
pub struct Counted {
    /// Measured times.
    pub intervals: Vec<Interval>,
    /// Amplitude readings: half of the angle between turning points. At least one, plus one per
    /// damping coefficient.
    pub amplitudes: Vec<AmplitudeReading>,
    /// Law of damping.
    pub damping: Damping,
}

/// Time from one count to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Count at the beginning: number of periods since the first timed swing.
    pub from: f64,
    /// Count at the end.
    pub to: f64,
    /// Duration, s.
    pub time: f64,
    /// Standard deviation of the duration, s.
    pub sd: f64,
}

/// Amplitude reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AmplitudeReading {
    /// Number of periods before the reading.
    pub at: f64,
    /// Amplitude, rad.
    pub amplitude: f64,
    /// Standard deviation of the amplitude, rad.
    pub sd: f64,
}

/// Quantity in a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    /// Angle, rad, from a zero that is estimated.
    Angle,
    /// Angular rate, rad/s, with a bias that is estimated: a gyro along the axis.
    Rate,
}

/// Log of the angle or of its rate.
#[derive(Clone, Debug, PartialEq)]
pub struct Logged {
    /// Times, s, ascending.
    pub times: Vec<f64>,
    /// Values, rad or rad/s.
    pub values: Vec<f64>,
    /// Standard deviation of a value, rad or rad/s.
    pub sd: f64,
    /// Quantity of the values.
    pub signal: Signal,
    /// Law of damping.
    pub damping: Damping,
}

/// Estimates from a measurement before the fit.
#[derive(Clone, Debug)]
pub(super) struct Look {
    /// Angular frequency, rad/s.
    pub(super) rate: f64,
    /// Approximate relative standard deviation of the angular frequency.
    pub(super) relative: f64,
    /// Amplitudes at the beginning and at the end, rad.
    pub(super) amplitudes: [f64; 2],
    /// Time between these two amplitudes, s.
    pub(super) duration: f64,
    /// Phase at the beginning, rad.
    pub(super) phase: f64,
    /// Middle of the signal, rad or rad/s.
    pub(super) middle: f64,
}

impl Damping {
    pub(super) const fn is_viscous(self) -> bool {
        matches!(self, Self::Viscous | Self::Both)
    }

    pub(super) const fn is_quadratic(self) -> bool {
        matches!(self, Self::Quadratic | Self::Both)
    }

    /// Returns the number of damping coefficients.
    pub(super) fn count(self) -> usize {
        usize::from(self.is_viscous()) + usize::from(self.is_quadratic())
    }
}

impl Counted {
    /// Creates a count of periods that took a time (s) while the amplitude (rad) fell from the
    /// first to the last reading, with viscous damping.
    pub fn new(count: f64, (time, time_sd): (f64, f64), [first, last]: [f64; 2], amplitude_sd: f64) -> Self {
        let reading = |at, amplitude| AmplitudeReading { at, amplitude, sd: amplitude_sd };
        Self {
            intervals: vec![Interval { from: 0.0, to: count, time, sd: time_sd }],
            amplitudes: vec![reading(0.0, first), reading(count, last)],
            damping: Damping::Viscous,
        }
    }
}

impl Measurement {
    pub(super) const fn damping(&self) -> Damping {
        match self {
            Self::Counted(counted) => counted.damping,
            Self::Logged(logged) => logged.damping,
        }
    }

    /// Returns the estimates before the fit.
    ///
    /// # Errors
    /// If a value is out of range, or there are too few readings.
    pub(super) fn look(&self) -> Result<Look, IdentifyError> {
        match self {
            Self::Counted(counted) => counted.look(),
            Self::Logged(logged) => logged.look(),
        }
    }
}

fn at_least(what: &'static str, given: usize, needed: usize) -> Result<(), IdentifyError> {
    if given < needed { Err(IdentifyError::TooFew { what, given, needed }) } else { Ok(()) }
}

fn deviation(what: &'static str, sd: f64) -> Result<(), IdentifyError> {
    IdentifyError::require(what, sd, sd > 0.0, "above zero, and finite")
}

impl Counted {
    fn look(&self) -> Result<Look, IdentifyError> {
        at_least("intervals of counted periods", self.intervals.len(), 1)?;
        at_least("readings of the amplitude", self.amplitudes.len(), 1 + self.damping.count())?;
        for interval in &self.intervals {
            let Interval { from, to, time, sd } = *interval;
            IdentifyError::require(
                "the swing count at the beginning of an interval",
                from,
                from >= 0.0 && from.fract() == 0.0,
                "a whole number of swings, zero or more",
            )?;
            IdentifyError::require(
                "the swing count at the end of an interval",
                to,
                to > from && to.fract() == 0.0,
                "a whole number of swings, after its beginning",
            )?;
            IdentifyError::above_zero("the time of counted periods", time)?;
            deviation("the standard deviation of a time", sd)?;
        }
        for reading in &self.amplitudes {
            let AmplitudeReading { at, amplitude, sd } = *reading;
            IdentifyError::require("the swing count of an amplitude reading", at, at >= 0.0, "zero or more")?;
            IdentifyError::above_zero("an amplitude", amplitude)?;
            deviation("the standard deviation of an amplitude", sd)?;
        }
        let (count, time) = self.intervals.iter().fold((0.0, 0.0), |(count, time), interval| {
            (count + interval.to - interval.from, time + interval.time)
        });
        let relative = self.intervals.iter().fold(1.0, |least: f64, i| least.min(i.sd / i.time));
        let by_count = |a: &&AmplitudeReading, b: &&AmplitudeReading| a.at.total_cmp(&b.at);
        let first = self.amplitudes.iter().min_by(by_count);
        let last = self.amplitudes.iter().max_by(by_count);
        let [first, last] = [first, last].map(|r| r.map_or((0.0, 0.0), |r| (r.at, r.amplitude)));
        Ok(Look {
            rate: TAU * count / time,
            relative: relative.max(1e-6),
            amplitudes: [first.1, last.1],
            duration: (last.0 - first.0) * time / count,
            phase: 0.0,
            middle: 0.0,
        })
    }
}

/// Minimum number of samples in a log.
const FEWEST: usize = 16;

impl Logged {
    fn look(&self) -> Result<Look, IdentifyError> {
        at_least("samples of a log", self.times.len(), FEWEST)?;
        at_least("values of a log", self.values.len(), self.times.len())?;
        at_least("times of a log", self.times.len(), self.values.len())?;
        deviation("the standard deviation of a log's values", self.sd)?;
        for pair in self.times.windows(2) {
            IdentifyError::require(
                "a time of a log",
                pair[1],
                pair[1] > pair[0],
                "later than the previous one",
            )?;
        }
        for &value in &self.values {
            IdentifyError::require("a value of a log", value, value.is_finite(), "finite")?;
        }
        let (low, high) = self
            .values
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
        let middle = 0.5 * (low + high);
        let crossings = self.crossings(middle, 0.25 * (high - low));
        at_least("passages through the middle position in a log", crossings.len(), 4)?;
        let n = crossings.len() as f64;
        let mean = crossings.iter().sum::<f64>() / n;
        let (mut squares, mut products) = (0.0, 0.0);
        for (k, time) in crossings.iter().enumerate() {
            let k = k as f64 - 0.5 * (n - 1.0);
            squares += k * k;
            products += k * (time - mean);
        }
        let rate = 0.5 * TAU * squares / products;
        let (start, end) = (self.times[0], self.times[self.times.len() - 1]);
        let swing = (TAU / rate).min(0.5 * (end - start));
        let fit = |from: f64| self.sinusoid(rate, from, from + swing);
        let ([first, phase], [last, _]) = (fit(start)?, fit(end - swing)?);
        let scale = if self.signal == Signal::Rate { 1.0 / rate } else { 1.0 };
        // θ = A cos φ, dθ/dt = −A ω sin φ = A ω cos(φ + ¼ turn)
        let phase = if self.signal == Signal::Rate { phase - 0.25 * TAU } else { phase };
        Ok(Look {
            rate,
            relative: (0.02 / n).max(1e-5),
            amplitudes: [first * scale, last * scale],
            duration: end - start - swing,
            phase,
            middle,
        })
    }

    /// Returns the times when the signal passes the middle from outside the margin on one side to
    /// outside it on the other.
    fn crossings(&self, middle: f64, margin: f64) -> Vec<f64> {
        let mut all = Vec::new();
        let mut side = 0.0;
        let mut last = 0;
        for (k, value) in self.values.iter().map(|v| v - middle).enumerate() {
            if value.abs() < margin {
                continue;
            }
            if side * value < 0.0 {
                // Fit a line through all samples between the two sides.
                let (a, b) = (last, k);
                let n = (b - a + 1) as f64;
                let t: f64 = self.times[a..=b].iter().sum::<f64>() / n;
                let v: f64 = self.values[a..=b].iter().map(|v| v - middle).sum::<f64>() / n;
                let (mut tv, mut vv) = (0.0, 0.0);
                for j in a..=b {
                    let dv = self.values[j] - middle - v;
                    tv += (self.times[j] - t) * dv;
                    vv += dv * dv;
                }
                all.push(t - v * tv / vv);
            }
            side = value;
            last = k;
        }
        all
    }

    /// Returns amplitude and phase, at the log's beginning, of the sinusoid of this rate with an
    /// offset that fits the samples between two times.
    fn sinusoid(&self, rate: f64, from: f64, to: f64) -> Result<[f64; 2], IdentifyError> {
        let mut matrix = nalgebra::Matrix3::zeros();
        let mut right = nalgebra::Vector3::zeros();
        for (&time, &value) in self.times.iter().zip(&self.values) {
            if time >= from && time <= to {
                let (s, c) = libm::sincos(rate * (time - self.times[0]));
                let row = nalgebra::Vector3::new(c, s, 1.0);
                matrix += row * row.transpose();
                right += row * value;
            }
        }
        let matrix = lu("a sum over the log's samples", matrix)?;
        let found = matrix.solve(&right).unwrap_or_else(nalgebra::Vector3::zeros);
        Ok([libm::hypot(found[0], found[1]), libm::atan2(-found[1], found[0])])
    }
}
