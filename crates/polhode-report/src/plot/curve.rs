//! A curve against time.

use polhode_document::figure::line::Point;
use polhode_document::figure::range::range;
use polhode_document::figure::sheet::Pen;

/// A curve, and what it is called.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub(super) pen: Pen,
    /// With what it is, for a legend.
    pub(super) name: String,
    /// For an axis: `ω₁`.
    pub(super) symbol: String,
    /// Times in s and values; between the pieces there are none.
    pub(super) pieces: Vec<Vec<Point>>,
}

impl Curve {
    /// Its values, in the order of time.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> {
        self.pieces.iter().flatten().map(|p| p[1])
    }

    /// Its least and its greatest value up to a time.
    pub(super) fn range_until(&self, end: f64) -> [f64; 2] {
        range(self.pieces.iter().flatten().filter(|p| p[0] <= end).map(|p| p[1]))
    }

    /// The part of it in an interval of time; the first points outside belong to it, so that its ends are straight lines.
    pub(super) fn within(&self, [from, to]: [f64; 2]) -> Vec<Vec<Point>> {
        let part = |piece: &Vec<Point>| {
            let first = piece.partition_point(|p| p[0] < from);
            let end = (piece.partition_point(|p| p[0] <= to) + 1).min(piece.len());
            piece.get(first.saturating_sub(1)..end).unwrap_or_default().to_vec()
        };
        self.pieces.iter().map(part).filter(|piece| !piece.is_empty()).collect()
    }
}
