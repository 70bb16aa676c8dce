//! Panel: curves with a common vertical axis.
//!
//! A diverging curve is drawn up to the edge of the panel. The other part of the motion determines
//! the height.

use polhode_document::figure::axes::{Area, Axes, Axis};
use polhode_document::figure::range::range;
use polhode_document::figure::sheet::{Mark, Pen, Point, Sheet};

use super::curve::Curve;
use super::envelope;
use super::oscillation::Oscillation;

/// Turning points per interval of an envelope: slightly more than a period.
const TURNS: f64 = 2.2;

/// Smallest distance between turning points of an envelope, px.
const WAVE: f64 = 24.0;

/// Smallest interval of an envelope, px.
const NARROW: f64 = 1.5;

/// Curves with a common vertical axis; at least one.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    /// Name of the quantity.
    name: &'static str,
    unit: &'static str,
    /// True if the panel has all varying curves of its quantity.
    has_all: bool,
    pub curves: Vec<(Curve, Oscillation)>,
    /// Time, s, up to which the curves determine the height of the panel.
    until: f64,
}

impl Panel {
    pub(crate) fn new(
        [name, unit]: [&'static str; 2],
        has_all: bool,
        curves: Vec<Curve>,
        until: f64,
    ) -> Self {
        let mut panel = Self { name, unit, has_all, curves: Vec::new(), until };
        // Angles of many revolutions are drawn in revolutions.
        let largest = curves.iter().flat_map(Curve::values).map(f64::abs).fold(0.0, f64::max);
        let turns = unit == "deg" && largest > 20.0 * 360.0;
        for mut curve in curves {
            if turns {
                curve.pieces.iter_mut().flatten().for_each(|p| p[1] /= 360.0);
            }
            let oscillation = Oscillation::of(&curve.pieces);
            panel.curves.push((curve, oscillation));
        }
        if turns {
            panel.unit = "turns";
        }
        panel
    }

    /// Returns an axis for these values, `height` px high.
    ///
    /// If the panel lacks curves of its quantity, the label consists of the symbols of its curves,
    /// if they fit.
    fn axis_for(&self, values: [f64; 2], height: f64) -> Axis {
        let symbols: Vec<&str> = self.curves.iter().map(|(curve, _)| curve.symbol.as_str()).collect();
        let symbols = symbols.join(", ");
        let short = if self.name.is_empty() { "angle" } else { self.name };
        let names = if self.has_all && !self.name.is_empty() { [short, ""] } else { [&symbols, short] };
        // There is about one tick per 36 px.
        let axis = |name| Axis::linear(values, 0.06, (height / 36.0).clamp(3.0, 8.0), name, self.unit);
        let [first, second] = names.map(axis);
        if first.label_width() <= height + 10.0 { first } else { second }
    }

    /// Returns the axis for all values.
    pub(crate) fn axis(&self, height: f64) -> Axis {
        let ranges = self.curves.iter().flat_map(|(curve, _)| curve.range_until(self.until));
        self.axis_for(range(ranges), height)
    }

    /// Returns the axis for the values in a time interval.
    ///
    /// If they fill at least half of the axis of the whole panel, it is the same.
    pub(crate) fn axis_within(&self, window: [f64; 2], whole: &Self, height: f64) -> Axis {
        let values = self.curves.iter().flat_map(|(curve, _)| curve.within(window)).flatten();
        let part = range(values.map(|p| p[1]));
        let all = range(whole.curves.iter().flat_map(|(curve, _)| curve.range_until(self.until)));
        if part[1] - part[0] > 0.5 * (all[1] - all[0]) {
            return whole.axis(height).bare();
        }
        self.axis_for(part, height)
    }

    /// Returns false if the samples are too few to resolve a curve.
    pub(crate) fn is_resolved(&self) -> bool {
        self.curves.iter().all(|(_, oscillation)| oscillation.is_resolved())
    }

    /// Draws all curves over axes whose unit of time is `scale` seconds.
    ///
    /// Curves that would be stripes in a frame of `width` px are drawn as envelopes, unresolved
    /// curves as dots.
    pub(crate) fn draw(&self, sheet: &mut Sheet, axes: &Axes, scale: f64, width: f64, is_sampled: bool) {
        let striped = |curve: &&(Curve, Oscillation)| curve.1.is_striped(width);
        let span =
            range(self.curves.iter().flat_map(|(curve, _)| curve.pieces.iter().flatten()).map(|p| p[0]));
        let narrow = NARROW * (span[1] - span[0]) / axes.area.width();
        let at = |edge: &[Point]| -> Vec<Point> {
            edge.iter().map(|&[time, value]| axes.at([time / scale, value])).collect()
        };
        let most = (axes.area.width() / WAVE) as usize;
        let mut edges = Vec::new();
        for (curve, oscillation) in self.curves.iter().filter(striped) {
            let period = TURNS * (span[1] - span[0]) / oscillation.times.len() as f64;
            for [upper, lower] in envelope::smooth(&curve.pieces, period.max(narrow), most) {
                let [upper, lower] = [at(&upper), at(&lower)];
                let corners = upper.iter().chain(lower.iter().rev()).copied().collect();
                sheet.marks.push(Mark::Polygon { corners, fill: curve.pen.colour, opacity: 0.16 });
                edges.extend([upper, lower].map(|edge| (Pen { width: 1.1, ..curve.pen }, edge)));
            }
        }
        // Dashed lines are drawn last, so that coinciding edges are both visible.
        edges.sort_by_key(|(pen, _)| !pen.dash.is_empty());
        for (pen, edge) in edges {
            sheet.line(edge, pen);
        }
        let mut curves: Vec<_> = self.curves.iter().filter(|curve| !striped(curve)).collect();
        // Dots are drawn first, because they would hide other curves.
        curves.sort_by_key(|(_, oscillation)| oscillation.is_resolved());
        for (curve, oscillation) in curves {
            let is_sampled = is_sampled || !oscillation.is_resolved();
            self.curve(sheet, axes, scale, curve.pen, &curve.pieces, is_sampled);
        }
    }

    /// Returns the panel with the beginning of the curves next to an envelope: the curves with
    /// stripes, else all.
    pub(crate) fn in_full(&self, width: f64) -> Self {
        let striped: Vec<_> = self.curves.iter().filter(|(_, o)| o.is_striped(width)).cloned().collect();
        let curves = if striped.is_empty() { self.curves.clone() } else { striped };
        Self { has_all: self.has_all && curves.len() == self.curves.len(), curves, ..*self }
    }

    /// Draws the curves in a time interval, without envelopes.
    pub(crate) fn draw_within(
        &self,
        sheet: &mut Sheet,
        axes: &Axes,
        scale: f64,
        window: [f64; 2],
        is_sampled: bool,
    ) {
        for (curve, oscillation) in &self.curves {
            let pieces = clipped(&curve.within(window), window);
            self.curve(sheet, axes, scale, curve.pen, &pieces, is_sampled || !oscillation.is_resolved());
        }
    }

    fn curve(
        &self,
        sheet: &mut Sheet,
        axes: &Axes,
        scale: f64,
        pen: Pen,
        pieces: &[Vec<Point>],
        is_sampled: bool,
    ) {
        let pen_of_line = if is_sampled { Pen { width: 0.8, dash: &[], ..pen }.faint(0.3) } else { pen };
        for piece in pieces {
            let points = piece.iter().map(|&[time, value]| axes.at([time / scale, value]));
            let points: Vec<Point> = points.collect();
            let (seen, rest) = points.split_at(piece.partition_point(|p| p[0] <= self.until));
            let leaves = seen.last().zip(rest.first()).and_then(|(a, b)| cut(*a, *b, axes.area));
            sheet.line(seen.iter().copied().chain(leaves).collect(), pen_of_line);
            if is_sampled {
                let dots = seen.iter().copied().filter(|p| p[0].is_finite() && p[1].is_finite());
                sheet.dots(dots.collect(), Pen { width: 2.2, dash: &[], ..pen });
            }
            if let Some([x, y]) = leaves {
                let up = if y <= axes.area.top { -1.0 } else { 1.0 };
                let corners = vec![[x - 4.0, y - 7.0 * up], [x + 4.0, y - 7.0 * up], [x, y]];
                sheet.marks.push(Mark::Polygon { corners, fill: pen.colour, opacity: 1.0 });
            }
        }
    }
}

/// Returns the pieces, clipped to a time interval.
fn clipped(pieces: &[Vec<Point>], [from, to]: [f64; 2]) -> Vec<Vec<Point>> {
    let between = |[t0, a]: Point, [t1, b]: Point, t: f64| [t, a + (b - a) * (t - t0) / (t1 - t0)];
    let one = |piece: &Vec<Point>| {
        let mut inside: Vec<Point> = piece.iter().copied().filter(|p| (from..=to).contains(&p[0])).collect();
        if let [a, b, ..] = piece.as_slice()
            && a[0] < from
            && from < b[0]
        {
            inside.insert(0, between(*a, *b, from));
        }
        if let [.., a, b] = piece.as_slice()
            && a[0] < to
            && to < b[0]
        {
            inside.push(between(*a, *b, to));
        }
        inside
    };
    pieces.iter().map(one).collect()
}

/// Returns the intersection of a line with the upper or lower edge of an area.
///
/// The line starts inside the area; `None` if it ends inside too.
fn cut([x0, y0]: Point, [x1, y1]: Point, area: Area) -> Option<Point> {
    let edge = y1.clamp(area.top, area.bottom);
    (edge != y1).then(|| [x0 + (x1 - x0) * (edge - y0) / (y1 - y0), edge])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_cut_at_the_edge() {
        let area = Area { left: 0.0, top: 10.0, right: 100.0, bottom: 60.0 };
        assert_eq!(cut([40.0, 30.0], [50.0, -170.0], area), Some([41.0, 10.0]));
        assert_eq!(cut([40.0, 30.0], [50.0, 130.0], area), Some([43.0, 60.0]));
        assert_eq!(cut([40.0, 30.0], [50.0, 50.0], area), None);
    }

    #[test]
    fn a_part_ends_where_its_interval_does() {
        // The points include the last one before the interval and the first one after it.
        let piece: Vec<Point> = (3..10).map(|k| 0.3 * f64::from(k)).map(|t| [t, 2.0 * t]).collect();
        let parts = clipped(&[piece], [1.0, 2.5]);
        let [.., [end, value]] = parts[0][..] else { panic!() };
        assert!((parts[0][0][0], end) == (1.0, 2.5) && (value - 5.0).abs() < 1e-12);
        assert_eq!(parts[0].len(), 7);
    }
}
