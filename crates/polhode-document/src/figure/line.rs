//! Curve simplification without visible change.
//!
//! There are two steps. First, the points in one narrow column are reduced to the first, least,
//! greatest and last point. This draws the same pixels for any number of samples. Then the
//! Douglas–Peucker algorithm drops the points that deviate from a straight line by at most
//! [`SEEN`].

/// Position on the sheet, px.
pub type Point = [f64; 2];

/// Largest invisible distance, px.
pub const SEEN: f64 = 0.1;

/// Width of a column, px.
const COLUMN: f64 = 0.2;

/// Number of points simplified together. It bounds the run time, which may be quadratic.
const PIECE: usize = 512;

/// Returns the visible points of a curve; points that are not finite are dropped.
pub fn thinned(points: &[Point]) -> Vec<Point> {
    let finite: Vec<Point> = points.iter().copied().filter(|[x, y]| x.is_finite() && y.is_finite()).collect();
    let rises = finite.windows(2).all(|w| matches!(w, [a, b] if a[0] <= b[0]));
    let candidates = if rises { columns(&finite) } else { finite };
    let mut kept: Vec<Point> = Vec::new();
    // Consecutive pieces share a point.
    let mut rest = candidates.as_slice();
    while rest.len() > 1 {
        let (piece, _) = rest.split_at(rest.len().min(PIECE));
        let seen = corners(piece);
        kept.extend(seen.into_iter().skip(usize::from(!kept.is_empty())));
        rest = rest.get(piece.len() - 1..).unwrap_or_default();
    }
    if kept.is_empty() { candidates } else { kept }
}

/// Returns the first, least, greatest and last point of every column, in their order.
fn columns(points: &[Point]) -> Vec<Point> {
    let column = |p: &Point| (p[0] / COLUMN).floor();
    let mut kept = Vec::new();
    for part in points.chunk_by(|a, b| column(a) == column(b)) {
        if part.len() <= 4 {
            kept.extend_from_slice(part);
            continue;
        }
        let by_height = |a: &(usize, &Point), b: &(usize, &Point)| a.1[1].total_cmp(&b.1[1]);
        let least = part.iter().enumerate().min_by(by_height).map(|(k, _)| k);
        let greatest = part.iter().enumerate().max_by(by_height).map(|(k, _)| k);
        let mut wanted: Vec<usize> =
            [Some(0), least, greatest, Some(part.len() - 1)].into_iter().flatten().collect();
        wanted.sort_unstable();
        wanted.dedup();
        kept.extend(wanted.into_iter().filter_map(|k| part.get(k)));
    }
    kept
}

/// Returns both ends and every point that deviates from the straight lines between the kept points.
fn corners(points: &[Point]) -> Vec<Point> {
    let mut keep = vec![false; points.len()];
    let mut spans = vec![(0, points.len().saturating_sub(1))];
    while let Some((from, to)) = spans.pop() {
        let (Some(a), Some(b)) = (points.get(from), points.get(to)) else { continue };
        for end in [from, to] {
            if let Some(kept) = keep.get_mut(end) {
                *kept = true;
            }
        }
        let between = points.iter().enumerate().take(to).skip(from + 1);
        let farthest = between.map(|(k, p)| (k, distance(*p, *a, *b))).max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((k, _)) = farthest.filter(|(_, away)| *away > SEEN) {
            spans.push((from, k));
            spans.push((k, to));
        }
    }
    points.iter().zip(keep).filter_map(|(p, keep)| keep.then_some(*p)).collect()
}

/// Returns the distance of a point from a line segment.
pub fn distance([x, y]: Point, [x0, y0]: Point, [x1, y1]: Point) -> f64 {
    let (dx, dy) = (x1 - x0, y1 - y0);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 { (((x - x0) * dx + (y - y0) * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
    (x - x0 - along * dx).hypot(y - y0 - along * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn farthest(points: &[Point], thin: &[Point]) -> f64 {
        let off = |p: &Point| thin.windows(2).map(|w| distance(*p, w[0], w[1])).fold(f64::INFINITY, f64::min);
        points.iter().map(off).fold(0.0, f64::max)
    }

    #[test]
    fn what_is_left_out_is_not_seen() {
        let spiral: Vec<Point> = (0..5000)
            .map(|k| f64::from(k) * 0.01)
            .map(|a| [300.0 + 4.0 * a * a.cos(), 200.0 + 3.0 * a * a.sin()])
            .collect();
        let thin = thinned(&spiral);
        assert!(thin.len() < spiral.len() / 5, "{}", thin.len());
        assert!(farthest(&spiral, &thin) <= SEEN);
        assert_eq!((thin.first(), thin.last()), (spiral.first(), spiral.last()));
    }

    #[test]
    fn a_million_samples_are_as_many_as_a_picture_shows() {
        let dense: Vec<Point> = (0..1_000_000)
            .map(|k| f64::from(k) * 1e-6)
            .map(|t| [600.0 * t, 100.0 + 80.0 * (20_000.0 * t).sin()])
            .collect();
        let thin = thinned(&dense);
        assert!(thin.len() < 4 * 3001, "{}", thin.len());
        let top = thin.iter().map(|p| p[1]).fold(0.0, f64::max);
        assert!(top > 179.99);
        let line: Vec<Point> = (0..1000).map(|k| [f64::from(k), 2.0 * f64::from(k)]).collect();
        assert_eq!(thinned(&line).len(), 3, "two pieces");
        assert_eq!(thinned(&[[1.0, f64::NAN], [2.0, 3.0]]), [[2.0, 3.0]]);
    }
}
