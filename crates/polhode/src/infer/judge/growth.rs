//! Growth of an error with time.

use core::fmt;

/// Law of growth of an error with the time since the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Growth {
    /// Unknown: the error does not exceed that of the exact motion, or lasts too short a time.
    Unknown,
    /// Power law ∝ t^p: p = 0 for a wrong start, ½ for random rounding, 1 for a wrong rate, 2 for a
    /// drifting rate.
    Power {
        /// Exponent p.
        exponent: f64,
    },
    /// Exponential growth ∝ e^(λ t), near an unstable motion.
    Exponential {
        /// Growth rate λ, 1/s.
        rate: f64,
    },
}

/// Angle above which an error does not grow further, rad.
const SATURATED: f64 = 1.0;
/// Smallest significant ratio of an error to its floor.
const ABOVE: f64 = 10.0;
/// Number of parts into which the time is divided; the largest error up to the end of each is used.
const PARTS: usize = 32;
/// Minimum number of parts with a significant error.
const FEWEST: usize = 6;

impl Growth {
    /// Fits the growth of angles (rad) at times since the start (s). `floor` is the uncertainty of
    /// the exact motion, rad.
    ///
    /// The largest error so far is fitted at times evenly spaced in log t. An exponential, fitted
    /// at times evenly spaced in t, is used if it fits twice as well and grows by more than e³.
    ///
    /// ```
    /// use polhode::infer::judge::Growth;
    /// let times: Vec<f64> = (0..1000).map(|k| 0.01 * f64::from(k)).collect();
    /// let errors: Vec<f64> = times.iter().map(|t| 1e-6 * t * t * (1.0 + 0.3 * (9.0 * t).sin())).collect();
    /// let Growth::Power { exponent } = Growth::of(&times, &errors, 1e-15) else { return Err("a power") };
    /// assert!((exponent - 2.0).abs() < 0.1);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn of(times: &[f64], errors: &[f64], floor: f64) -> Self {
        let began = times.first().copied().unwrap_or(0.0);
        let mut largest: f64 = 0.0;
        let envelope: Vec<(f64, f64)> = (times.iter().zip(errors))
            .map(|(time, error)| {
                largest = largest.max(*error);
                (time - began, largest)
            })
            .filter(|&(since, error)| since > 0.0 && error > ABOVE * floor && error < SATURATED)
            .collect();
        let (Some(&(first, _)), Some(&(last, _))) = (envelope.first(), envelope.last()) else {
            return Self::Unknown;
        };
        // At most the last two decades, because earlier times have few rows.
        let first = first.max(last / 100.0);
        let at = |time: f64| {
            envelope[envelope.partition_point(|&(since, _)| since < time).min(envelope.len() - 1)]
        };
        let line = |time: &dyn Fn(f64) -> f64, x: &dyn Fn(f64) -> f64| {
            let mut points: Vec<(f64, f64)> = (0..PARTS)
                .map(|k| at(time(k as f64 / (PARTS - 1) as f64)))
                .map(|(since, error)| (x(since), libm::log(error)))
                .collect();
            points.dedup();
            (points.len() >= FEWEST).then(|| fitted_line(&points))
        };
        let power = line(&|part| first * libm::pow(last / first, part), &libm::log);
        let exponential = line(&|part| first + (last - first) * part, &|since| since);
        match (power, exponential) {
            (Some((_, off)), Some((rate, by_rate))) if 2.0 * by_rate < off && rate * (last - first) > 3.0 => {
                Self::Exponential { rate }
            }
            (Some((exponent, _)), _) => Self::Power { exponent },
            _ => Self::Unknown,
        }
    }
}

/// Returns the slope of a line through points, and the RMS deviation from it.
fn fitted_line(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let (xx, xy) = (mean(&|p| (p.0 - x).powi(2)), mean(&|p| (p.0 - x) * (p.1 - y)));
    let slope = if xx > 0.0 { xy / xx } else { 0.0 };
    (slope, mean(&|p| (p.1 - y - slope * (p.0 - x)).powi(2)).sqrt())
}

/// Text such as `grows as t^1.00`.
impl fmt::Display for Growth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown => f.write_str("too small or too short to determine its growth"),
            Self::Power { exponent } if exponent.abs() < 0.15 => f.write_str("does not grow"),
            Self::Power { exponent } => write!(f, "grows as t^{exponent:.2}"),
            Self::Exponential { rate } => write!(f, "grows as e^({rate:.3} t/s)"),
        }
    }
}
