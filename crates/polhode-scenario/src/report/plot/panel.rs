//! Panel: curves that share a vertical axis.
//!
//! A motion that runs away is drawn up to where it leaves the panel, which is as high as the rest
//! of it needs.

use polhode_document::figure::axes::{Area, Axes, Axis};
use polhode_document::figure::range::range;
use polhode_document::figure::sheet::{Mark, Pen, Point, Sheet};

use super::curve::Curve;
use super::envelope;
use super::oscillation::Oscillation;

/// Number of turning points in an interval of an envelope: a little more than a period.
const TURNS: f64 = 2.2;

/// Least distance from a turning point of an envelope's edge to the next, px.
const WAVE: f64 = 24.0;

/// Least width of an interval of an envelope, px.
const NARROW: f64 = 1.5;

/// Curves that share a vertical axis, at least one.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    /// Name of the quantity.
    name: &'static str,
    unit: &'static str,
    /// True if these are all its curves that vary.
    has_all: bool,
    pub curves: Vec<(Curve, Oscillation)>,
    /// Time up to which the curves decide how high the panel is, s.
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
        // An angle of many turns is counted in turns.
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

    /// Returns an axis of this height for values.
    ///
    /// It is called by the symbols of the curves if they are not all of the quantity, and fit.
    fn axis_for(&self, values: [f64; 2], height: f64) -> Axis {
        let symbols: Vec<&str> = self.curves.iter().map(|(curve, _)| curve.symbol.as_str()).collect();
        let symbols = symbols.join(", ");
        let short = if self.name.is_empty() { "angle" } else { self.name };
        let names = if self.has_all && !self.name.is_empty() { [short, ""] } else { [&symbols, short] };
        // A mark stands every 36 px or so.
        let axis = |name| Axis::linear(values, 0.06, (height / 36.0).clamp(3.0, 8.0), name, self.unit);
        let [first, second] = names.map(axis);
        if first.label_width() <= height + 10.0 { first } else { second }
    }

    /// Returns the axis of its values.
    pub(crate) fn axis(&self, height: f64) -> Axis {
        let ranges = self.curves.iter().flat_map(|(curve, _)| curve.range_until(self.until));
        self.axis_for(range(ranges), height)
    }

    /// Returns the axis of the values in an interval of time.
    ///
    /// It is that of the whole panel if they fill at least half of that.
    pub(crate) fn axis_within(&self, window: [f64; 2], whole: &Self, height: f64) -> Axis {
        let values = self.curves.iter().flat_map(|(curve, _)| curve.within(window)).flatten();
        let part = range(values.map(|p| p[1]));
        let all = range(whole.curves.iter().flat_map(|(curve, _)| curve.range_until(self.until)));
        if part[1] - part[0] > 0.5 * (all[1] - all[0]) {
            return whole.axis(height).bare();
        }
        self.axis_for(part, height)
    }

    /// False if the samples are too few for what they show.
    pub(crate) fn is_resolved(&self) -> bool {
        self.curves.iter().all(|(_, oscillation)| oscillation.is_resolved())
    }

    /// Draws the whole of its curves over axes whose unit of time is `scale` seconds.
    ///
    /// Curves that oscillate too fast for a frame of `width` px are drawn as envelopes, those whose
    /// samples are too few as dots.
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
        // Dashes are drawn over whole lines: edges that coincide are both seen.
        edges.sort_by_key(|(pen, _)| !pen.dash.is_empty());
        for (pen, edge) in edges {
            sheet.line(edge, pen);
        }
        let mut curves: Vec<_> = self.curves.iter().filter(|curve| !striped(curve)).collect();
        // Dots would hide what is drawn before them.
        curves.sort_by_key(|(_, oscillation)| oscillation.is_resolved());
        for (curve, oscillation) in curves {
            let is_sampled = is_sampled || !oscillation.is_resolved();
            self.curve(sheet, axes, scale, curve.pen, &curve.pieces, is_sampled);
        }
    }

    /// Returns what is shown in full next to an envelope: the curves with stripes, or all if there
    /// are none.
    pub(crate) fn in_full(&self, width: f64) -> Self {
        let striped: Vec<_> = self.curves.iter().filter(|(_, o)| o.is_striped(width)).cloned().collect();
        let curves = if striped.is_empty() { self.curves.clone() } else { striped };
        Self { has_all: self.has_all && curves.len() == self.curves.len(), curves, ..*self }
    }

    /// Draws the part of its curves in an interval of time, in full.
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

/// Returns pieces without what lies outside an interval of time.
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

/// Returns where the line from a point inside an area to one above or below it leaves the area.
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
        // The part goes from the last point before to the first behind.
        let piece: Vec<Point> = (3..10).map(|k| 0.3 * f64::from(k)).map(|t| [t, 2.0 * t]).collect();
        let parts = clipped(&[piece], [1.0, 2.5]);
        let [.., [end, value]] = parts[0][..] else { panic!() };
        assert!((parts[0][0][0], end) == (1.0, 2.5) && (value - 5.0).abs() < 1e-12);
        assert_eq!(parts[0].len(), 7);
    }
}
