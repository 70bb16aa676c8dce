//! A curve against time.

use polhode_document::figure::line::Point;
use polhode_document::figure::range::range;
use polhode_document::figure::sheet::Pen;

/// Curve with its names.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    pub pen: Pen,
    /// Name with its quantity, for a legend.
    pub name: String,
    /// Symbol for an axis: `ω₁`.
    pub symbol: String,
    /// Times in s and values; between the pieces there are none.
    pub pieces: Vec<Vec<Point>>,
}

impl Curve {
    /// Returns its values, in the order of time.
    pub(crate) fn values(&self) -> impl Iterator<Item = f64> {
        self.pieces.iter().flatten().map(|p| p[1])
    }

    /// Returns its least and its greatest value up to a time.
    pub(crate) fn range_until(&self, end: f64) -> [f64; 2] {
        range(self.pieces.iter().flatten().filter(|p| p[0] <= end).map(|p| p[1]))
    }

    /// Returns the part of it in an interval of time.
    ///
    /// The first points outside belong to it, so that its ends are straight lines.
    pub(crate) fn within(&self, [from, to]: [f64; 2]) -> Vec<Vec<Point>> {
        let part = |piece: &Vec<Point>| {
            let first = piece.partition_point(|p| p[0] < from);
            let end = (piece.partition_point(|p| p[0] <= to) + 1).min(piece.len());
            piece.get(first.saturating_sub(1)..end).unwrap_or_default().to_vec()
        };
        self.pieces.iter().map(part).filter(|piece| !piece.is_empty()).collect()
    }
}
