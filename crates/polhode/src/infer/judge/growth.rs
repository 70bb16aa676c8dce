//! How an error grows.

use core::fmt;

/// The law by which an error grows with the time since the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Growth {
    /// There is no error beyond the exact motion's own, or it is there too short to say.
    Unknown,
    /// ∝ t^p: p = 0 of a wrong start, ½ of rounding by chance, 1 of a wrong rate, 2 of one that drifts.
    Power {
        /// p
        exponent: f64,
    },
    /// ∝ e^(λ t), near an unstable motion.
    Exponential {
        /// λ, 1/s.
        rate: f64,
    },
}

/// An angle beyond which an error grows no more, rad.
const SATURATED: f64 = 1.0;
/// How many times its floor an error has to be.
const ABOVE: f64 = 10.0;
/// Into how many parts the time is divided; the largest error up to the end of each is taken.
const PARTS: usize = 32;
/// How many of them have to show an error.
const FEWEST: usize = 6;

impl Growth {
    /// Of angles (rad) at times since the start (s), where `floor` is what the exact motion may be wrong by.
    ///
    /// The largest error so far is fitted, at times that are evenly spread in log t; an exponential, at times evenly spread in t, is
    /// taken where it fits twice as well, and grows by more than e³.
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
        // Of the last two decades at most: what comes before has few rows.
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

/// The slope of a line through points, and how far they are off it, root of the mean square.
fn fitted_line(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let (xx, xy) = (mean(&|p| (p.0 - x).powi(2)), mean(&|p| (p.0 - x) * (p.1 - y)));
    let slope = if xx > 0.0 { xy / xx } else { 0.0 };
    (slope, mean(&|p| (p.1 - y - slope * (p.0 - x)).powi(2)).sqrt())
}

/// `grows as t^1.00`
impl fmt::Display for Growth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown => f.write_str("too small or too short to say how it grows"),
            Self::Power { exponent } if exponent.abs() < 0.15 => f.write_str("does not grow"),
            Self::Power { exponent } => write!(f, "grows as t^{exponent:.2}"),
            Self::Exponential { rate } => write!(f, "grows as e^({rate:.3} t/s)"),
        }
    }
}
