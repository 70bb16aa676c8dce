//! Envelope of an oscillation that is too fast to be drawn.
//!
//! It is the band between the local least and greatest values.

use polhode_document::figure::line::Point;
use polhode_document::figure::range::range;

use super::oscillation::turning_points;

/// Upper and lower edge of a band.
pub(crate) type Band = [Vec<Point>; 2];

/// Least and greatest value in a time interval; `None` without samples.
type Bounds = Option<[f64; 2]>;

/// Smallest turn of an edge that counts as a ripple, relative to the range of the curve.
const RIPPLE: f64 = 0.03;

/// Returns the envelope of a curve in pieces, with the gaps of the curve.
///
/// The intervals have at least the length `interval`, s, and are extended until each edge has at
/// most `most` turning points. A fast beat therefore gets the envelope of its envelope.
pub(crate) fn smooth(pieces: &[Vec<Point>], interval: f64, most: usize) -> Vec<Band> {
    let [least, greatest] = range(pieces.iter().flatten().map(|p| p[1]));
    let turns = |band: &Band| {
        band.iter().map(|edge| turning_points(edge, RIPPLE * (greatest - least)).len()).max().unwrap_or(0)
    };
    let mut interval = interval;
    loop {
        let bands = envelope(pieces, interval);
        if bands.iter().map(turns).sum::<usize>() <= most {
            return bands;
        }
        interval *= 1.5;
    }
}

/// Returns the envelope over intervals of about `interval`, s; it has gaps at intervals without
/// samples.
///
/// Each edge takes the outer of both bounds at a boundary between intervals. All samples are
/// therefore inside the straight lines between these points.
fn envelope(pieces: &[Vec<Point>], interval: f64) -> Vec<Band> {
    let points = || pieces.iter().flatten().filter(|p| p[0].is_finite() && p[1].is_finite());
    let times = points().map(|p| p[0]);
    let [start, end] = times.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], t| [a.min(t), b.max(t)]);
    if !(end > start) {
        return Vec::new();
    }
    // All intervals have the same length: a shorter one at the end might contain less than a
    // period.
    let count = ((end - start) / interval).floor().clamp(1.0, 1e6);
    let interval = (end - start) / count;
    let mut bounds: Vec<Bounds> = vec![None; count as usize];
    let last = bounds.len() - 1;
    let place = |time: f64| (((time - start) / interval) as usize).min(last);
    for piece in pieces {
        let mut before = None;
        for &[time, value] in piece.iter().filter(|p| p[0].is_finite() && p[1].is_finite()) {
            let k = place(time);
            // The line from the previous sample crosses the intervals in between.
            let (from, other) = before.unwrap_or((k, value));
            for slot in bounds.iter_mut().take(k).skip(from + 1) {
                *slot = joined(*slot, Some([value.min(other), value.max(other)]));
            }
            if let Some(slot) = bounds.get_mut(k) {
                *slot = joined(*slot, Some([value; 2]));
            }
            before = Some((k, value));
        }
    }
    let mut bands: Vec<Band> = Vec::new();
    let mut before: Bounds = None;
    for k in 0..=bounds.len() {
        let here = bounds.get(k).copied().flatten();
        let time = (start + interval * k as f64).min(end);
        if before.is_none() && here.is_some() {
            bands.push([Vec::new(), Vec::new()]);
        }
        if let (Some([low, high]), Some([upper, lower])) = (joined(before, here), bands.last_mut()) {
            upper.push([time, high]);
            lower.push([time, low]);
        }
        before = here;
    }
    bands.iter_mut().flatten().for_each(level_ends);
    bands
}

/// Makes the ends of an edge level, because they have bounds on one side only.
fn level_ends(edge: &mut Vec<Point>) {
    if let [first, second, .., before, last] = edge.as_mut_slice() {
        (first[1], last[1]) = (second[1], before[1]);
    }
}

fn joined(one: Bounds, other: Bounds) -> Bounds {
    one.into_iter().chain(other).reduce(|[a, b], [c, d]| [a.min(c), b.max(d)])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(edge: &[Point], time: f64) -> Option<f64> {
        let pair = edge.windows(2).find(|w| w[0][0] <= time && time <= w[1][0])?;
        let ([t0, a], [t1, b]) = (pair[0], pair[1]);
        Some(if t1 > t0 { a + (b - a) * (time - t0) / (t1 - t0) } else { a.max(b) })
    }

    /// Returns a sample outside all bands, if there is one.
    fn outside(bands: &[Band], curve: &[Point]) -> Option<Point> {
        let inside = |&[t, value]: &Point| {
            bands.iter().any(|[upper, lower]| {
                let edges = at(upper, t).zip(at(lower, t));
                edges.is_some_and(|(high, low)| (low - 1e-12..=high + 1e-12).contains(&value))
            })
        };
        curve.iter().copied().find(|point| !inside(point))
    }

    #[test]
    fn an_envelope_contains_every_sample() {
        // Decaying beat at unequally spaced times.
        let sample = |k: i32| {
            let t = 1.7 + 0.013 * f64::from(k) + 0.004 * (0.9 * f64::from(k)).sin();
            [t, 0.3 + (-0.05 * t).exp() * (31.0 * t).sin() * (1.3 * t).cos()]
        };
        let curve: Vec<Point> = (0..3000).map(sample).collect();
        for interval in [0.006, 0.02, 0.22, 1.9, 100.0] {
            assert_eq!(
                outside(&envelope(std::slice::from_ref(&curve), interval), &curve),
                None,
                "{interval}"
            );
        }
    }

    #[test]
    fn a_beat_too_fast_to_be_drawn_is_within_its_band() {
        let beat = |t: f64| (61.0 * t).sin() * (5.3 * t).cos();
        let curve: Vec<Point> = (0..20_000).map(|k| 0.001 * f64::from(k)).map(|t| [t, beat(t)]).collect();
        let turns =
            |bands: &[Band]| bands.iter().map(|[upper, _]| turning_points(upper, 0.1).len()).sum::<usize>();
        let short = envelope(std::slice::from_ref(&curve), 0.11);
        assert!(turns(&short) > 25, "{}", turns(&short));
        let bands = smooth(std::slice::from_ref(&curve), 0.11, 12);
        assert!(turns(&bands) <= 12);
        assert_eq!(outside(&bands, &curve), None);
    }

    #[test]
    fn it_is_no_wider_than_two_neighbouring_intervals() {
        let curve: Vec<Point> = (0..2000).map(|k| 0.01 * f64::from(k)).map(|t| [t, t]).collect();
        let [[upper, lower]] = &envelope(&[curve], 0.5)[..] else { panic!("it is broken") };
        assert!(upper.iter().zip(lower).all(|(a, b)| a[1] - b[1] <= 1.03 && a[0] == b[0]));
    }

    #[test]
    fn it_is_broken_where_there_is_no_curve() {
        let piece = |from: f64| (0..40).map(|k| [from + 0.1 * f64::from(k), f64::from(k % 3)]).collect();
        let bands = envelope(&[piece(0.0), piece(9.3)], 0.5);
        assert_eq!(bands.len(), 2);
        assert!(bands[0][0].iter().all(|p| p[0] <= 4.5) && bands[1][0].iter().all(|p| p[0] >= 8.8));
        assert!(envelope(&[], 0.5).is_empty() && envelope(&[vec![[1.0, 2.0]]], 0.5).is_empty());
    }
}
