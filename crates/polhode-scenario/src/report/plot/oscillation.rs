//! Oscillation of a curve: its turning points, and whether the samples resolve them.

use polhode_document::figure::line::Point;
use polhode_document::figure::range::range;

/// Smallest turn that counts, relative to the range of the curve.
const RIPPLE: f64 = 0.01;

/// Smallest number of samples between turning points that resolve an oscillation.
///
/// Fewer samples miss the extrema by more than a tenth of the amplitude.
const RESOLVED: f64 = 4.0;

/// Number of turning points from which on a curve is an oscillation.
const FEW: usize = 5;

/// Smallest distance between turning points of a legible curve, px.
const STRIPE: f64 = 6.0;

/// Turning points of a curve.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Oscillation {
    /// Times at which it turns, s.
    pub times: Vec<f64>,
    /// Median number of samples between consecutive turning points.
    samples: f64,
    /// Fraction of turning points that are isolated samples, such as a pulse hit by one sample.
    spikes: f64,
}

impl Oscillation {
    /// Returns the turning points of a curve in pieces.
    pub(crate) fn of(pieces: &[Vec<Point>]) -> Self {
        let [least, greatest] = range(pieces.iter().flatten().map(|p| p[1]));
        let spread = greatest - least;
        let (mut times, mut gaps, mut spikes) = (Vec::new(), Vec::new(), 0);
        for piece in pieces {
            let turns = turning_points(piece, RIPPLE * spread);
            gaps.extend(turns.windows(2).filter_map(|pair| Some(pair.last()? - pair.first()?)));
            for k in turns {
                let value = |k: usize| piece.get(k).map(|p| p[1]);
                let far = |other: Option<f64>| {
                    other.zip(value(k)).is_some_and(|(a, b)| (a - b).abs() > 0.5 * spread)
                };
                spikes += usize::from(far(k.checked_sub(1).and_then(value)) && far(value(k + 1)));
                times.extend(piece.get(k).map(|p| p[0]));
            }
        }
        gaps.sort_unstable();
        let samples = gaps.get(gaps.len() / 2).map_or(f64::INFINITY, |&gap| gap as f64);
        let spikes = if times.is_empty() { 0.0 } else { f64::from(spikes as u32) / times.len() as f64 };
        Self { times, samples, spikes }
    }

    /// Returns false if the samples are too few to resolve the oscillation.
    pub(crate) fn is_resolved(&self) -> bool {
        self.times.len() < FEW || (self.samples >= RESOLVED && self.spikes <= 0.25)
    }

    /// Returns true if the curve fills a frame of this width, px, with stripes.
    pub(crate) fn is_striped(&self, width: f64) -> bool {
        self.times.len() > FEW && width < STRIPE * self.times.len() as f64
    }
}

/// Returns the indices of the points at which a curve turns by more than `ripple`.
pub(crate) fn turning_points(piece: &[Point], ripple: f64) -> Vec<usize> {
    let mut turns = Vec::new();
    let mut rising = None;
    // Greatest and least points since the last turn.
    let (mut high, mut low) = ((0, f64::NEG_INFINITY), (0, f64::INFINITY));
    for (k, &[_, value]) in piece.iter().enumerate().filter(|(_, p)| p[1].is_finite()) {
        if value > high.1 {
            high = (k, value);
        }
        if value < low.1 {
            low = (k, value);
        }
        if rising != Some(false) && value < high.1 - ripple {
            // The start of a curve is not a turning point.
            if rising.is_some() {
                turns.push(high.0);
            }
            (rising, low, high) = (Some(false), (k, value), (k, f64::NEG_INFINITY));
        } else if rising != Some(true) && value > low.1 + ripple {
            if rising.is_some() {
                turns.push(low.0);
            }
            (rising, high, low) = (Some(true), (k, value), (k, f64::INFINITY));
        }
    }
    turns
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns 0.7 sin(2π t/1.3 + 0.4) over 20 s.
    fn wave(step: f64) -> Vec<Vec<Point>> {
        let at = |k: i32| {
            let t = step * f64::from(k);
            [t, 0.7 * (std::f64::consts::TAU * t / 1.3 + 0.4).sin()]
        };
        vec![(0..=(20.0 / step) as i32).map(at).collect()]
    }

    #[test]
    fn a_wave_turns_twice_in_a_period() {
        let wave = Oscillation::of(&wave(0.01));
        // First maximum: (¼ − 0.4/2π) of the period.
        let first = 1.3 * (0.25 - 0.4 / std::f64::consts::TAU);
        for (k, time) in wave.times.iter().enumerate() {
            assert!((time - first - 0.65 * k as f64).abs() < 0.006, "{k}: {time}");
        }
        assert_eq!(wave.times.len(), 31);
        assert!(wave.is_resolved() && wave.is_striped(180.0) && !wave.is_striped(190.0));
    }

    #[test]
    fn ripples_and_plain_curves_do_not_turn() {
        let slope = |t: f64| [t, 2.0 * t + 0.005 * (40.0 * t).sin()];
        let slope = vec![(0..400).map(|k| slope(0.01 * f64::from(k))).collect()];
        assert!(Oscillation::of(&slope).times.is_empty());
        assert!(!Oscillation::of(&slope).is_striped(1.0) && Oscillation::of(&[]).is_resolved());
    }

    #[test]
    fn few_samples_do_not_resolve_a_wave() {
        assert!(Oscillation::of(&wave(0.13)).is_resolved());
        assert!(!Oscillation::of(&wave(0.21)).is_resolved());
        // A pulse of one sample in twenty is not resolved, a pulse of five samples is.
        let pulses = |long: i32| {
            let at = |k: i32| [0.25 * f64::from(k), if k % 20 < long { 1.2 } else { 0.0 }];
            Oscillation::of(&[(0..600).map(at).collect::<Vec<_>>()])
        };
        assert!(!pulses(1).is_resolved() && pulses(5).is_resolved());
    }
}
