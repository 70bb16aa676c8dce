//! Curve against time.

use polhode_document::figure::line::Point;
use polhode_document::figure::range::range;
use polhode_document::figure::sheet::Pen;

/// Curve with its pen and its names.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    pub pen: Pen,
    /// Name for the legend, with a description.
    pub name: String,
    /// Symbol for the axis label, such as `ω₁`.
    pub symbol: String,
    /// Points of each piece: time, s, and value. The curve has gaps between the pieces.
    pub pieces: Vec<Vec<Point>>,
}

impl Curve {
    /// Returns all values in the order of time.
    pub(crate) fn values(&self) -> impl Iterator<Item = f64> {
        self.pieces.iter().flatten().map(|p| p[1])
    }

    /// Returns the least and the greatest value up to a time, s.
    pub(crate) fn range_until(&self, end: f64) -> [f64; 2] {
        range(self.pieces.iter().flatten().filter(|p| p[0] <= end).map(|p| p[1]))
    }

    /// Returns the pieces within a time interval, s, with one more point at each end.
    pub(crate) fn within(&self, [from, to]: [f64; 2]) -> Vec<Vec<Point>> {
        let part = |piece: &Vec<Point>| {
            let first = piece.partition_point(|p| p[0] < from);
            let end = (piece.partition_point(|p| p[0] <= to) + 1).min(piece.len());
            piece.get(first.saturating_sub(1)..end).unwrap_or_default().to_vec()
        };
        self.pieces.iter().map(part).filter(|piece| !piece.is_empty()).collect()
    }
}
