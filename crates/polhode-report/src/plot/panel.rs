//! A panel: curves against time over one axis.
//!
//! What is constant but for rounding is drawn as a straight line and has its value beside its name; a panel of nothing but zeros is
//! low, and its axis has no numbers. A motion that runs away is drawn up to where it leaves the plot, which is as high as the rest
//! of it needs.

use polhode::motion::{Crossing, Ending};

use super::axes::{Area, Axes, Axis, Key};
use super::font;
use super::plotted::PlottedMotion;
use super::sheet::{Anchor, Colour, Mark, Pen, Point, SMALL, Sheet, Text};
use crate::layout::printable;
use crate::number::{typeset, ungrouped};

/// What varies by less of its size is constant, and what is less of the size of what it is made of is zero.
const FLAT: f64 = 1e-9;
const ZERO: f64 = 1e-12;

/// The height of a panel of zeros, px.
const LOW: f64 = 96.0;

/// A curve, and what it is called: at length, and where there is no room for that.
#[derive(Clone, Debug)]
pub(super) struct Series {
    pub(super) pen: Pen,
    pub(super) long: String,
    pub(super) short: String,
    /// One for each sample.
    pub(super) values: Vec<f64>,
}

/// Curves of one quantity.
#[derive(Clone, Debug)]
pub(super) struct Panel {
    name: &'static str,
    unit: &'static str,
    series: Vec<Series>,
    /// The size of what the quantity is made of: that of its rounding errors is ε times as large.
    scale: f64,
    /// So many samples decide how high the plot is.
    telling: usize,
    names_events: bool,
}

impl Panel {
    /// Curves of a quantity with its unit; `made_of` is the size of its parts, where these may add up to nothing.
    pub(super) fn new(
        motion: &PlottedMotion<'_>,
        name: &'static str,
        unit: &'static str,
        series: Vec<Series>,
        made_of: f64,
    ) -> Self {
        let runs_away = matches!(motion.trajectory.ending(), Ending::Failed { .. });
        let telling = if runs_away { telling(&series) } else { motion.samples().len() };
        let values = || series.iter().flat_map(|s| s.values.iter().take(telling).copied());
        let scale = values().filter(|x| x.is_finite()).map(f64::abs).fold(made_of, f64::max);
        Self { name, unit, series, scale, telling, names_events: false }
    }

    /// The same with the names of events beside their lines.
    pub(super) fn naming_events(self) -> Self {
        Self { names_events: true, ..self }
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        self.series.iter().flat_map(|series| series.values.iter().take(self.telling).copied())
    }

    /// True if all of it is zero, but for rounding.
    pub(super) fn is_zero(&self) -> bool {
        self.values().all(|x| x.abs() <= ZERO * self.scale)
    }

    /// The part of an area that it needs.
    pub(super) fn fitted(&self, area: Area) -> Area {
        let bottom = if self.is_zero() { area.bottom.min(area.top + LOW) } else { area.bottom };
        Area { bottom, ..area }
    }

    /// The value of a curve that is constant, but for rounding.
    fn constant(&self, series: &Series) -> Option<f64> {
        let [least, most] = range(series.values.iter().copied());
        let size = least.abs().max(most.abs());
        if size <= ZERO * self.scale {
            return Some(0.0);
        }
        (most - least <= FLAT * size).then_some(0.5 * (least + most))
    }

    /// The names of the curves, the long ones if they fit into one line, with the values of those that are constant.
    pub(super) fn keys(&self, width: f64) -> Vec<Key> {
        let value = |series: &Series| match self.constant(series) {
            Some(0.0) => " = 0".to_owned(),
            Some(value) => format!(" = {} {}", typeset(&ungrouped(value, 5)), self.unit),
            None => String::new(),
        };
        let values: Vec<String> = self.series.iter().map(value).collect();
        let named = |name: fn(&Series) -> &String| -> Vec<String> {
            self.series
                .iter()
                .zip(&values)
                .map(|(series, value)| format!("{}{value}", name(series)))
                .collect()
        };
        let long = named(|series| &series.long);
        let needed: f64 = long.iter().map(|name| font::width(name, SMALL) + 50.0).sum();
        let names = if needed < width { long } else { named(|series| &series.short) };
        self.series.iter().zip(names).map(|(series, name)| Key::line(series.pen, name)).collect()
    }

    /// The axis of its values, with a mark every 40 px or so.
    pub(super) fn axis(&self, height: f64) -> Axis {
        if self.is_zero() {
            Axis::zero(self.name, self.unit)
        } else {
            axis(self.values(), height, self.name, self.unit)
        }
    }

    /// Draws it over axes of its own; the unit of time is so many seconds.
    pub(super) fn draw(&self, motion: &PlottedMotion<'_>, sheet: &mut Sheet, axes: &Axes, scale: f64) {
        axes.draw(sheet);
        let times: Vec<f64> = motion.samples().iter().map(|s| s.state.time / scale).collect();
        let events = || motion.trajectory.events().iter().take(MOST_EVENTS);
        for event in events() {
            axes.upright(event.state.time / scale, sheet);
        }
        for series in &self.series {
            // What is rounding is not drawn as more.
            let flat = self.constant(series);
            let value = |&value: &f64| flat.unwrap_or(value);
            let points = times.iter().zip(series.values.iter().map(value));
            let points: Vec<Point> = points.map(|(&time, value)| axes.at([time, value])).collect();
            let seen = points.get(..self.telling).unwrap_or(&points);
            let leaves = seen.last().zip(points.get(self.telling)).and_then(|(a, b)| cut(*a, *b, axes.area));
            sheet.line(seen.iter().copied().chain(leaves).collect(), series.pen);
            if let Some([x, y]) = leaves {
                let up = if y <= axes.area.top { -1.0 } else { 1.0 };
                let corners = vec![[x - 4.0, y - 7.0 * up], [x + 4.0, y - 7.0 * up], [x, y]];
                sheet.marks.push(Mark::Polygon { corners, fill: series.pen.colour });
            }
        }
        if self.names_events {
            let mut free = f64::NEG_INFINITY;
            // Each by its first crossing: the others have the same line.
            let is_first =
                |(k, event): &(usize, &Crossing)| !events().take(*k).any(|other| other.event == event.event);
            for (_, event) in events().enumerate().filter(is_first) {
                free = axes.beside_upright(event.state.time / scale, &printable(&event.name), free, sheet);
            }
        }
        self.tell_of_the_rest(motion, axes, &times, sheet);
    }

    /// How far the samples go that are not seen.
    fn tell_of_the_rest(&self, motion: &PlottedMotion<'_>, axes: &Axes, times: &[f64], sheet: &mut Sheet) {
        let beyond = self.series.iter().flat_map(|series| series.values.iter().skip(self.telling));
        let largest = beyond.map(|x| x.abs()).filter(|x| x.is_finite()).fold(0.0, f64::max);
        let Some(end) = motion.samples().last().filter(|_| self.telling < motion.samples().len()) else {
            return;
        };
        let [largest, time] = [largest, end.state.time].map(|x| typeset(&ungrouped(x, 3)));
        let words = format!("to {largest} {} at {time} s", self.unit);
        let last = times.get(self.telling.saturating_sub(1)).copied().unwrap_or_default();
        let at = [axes.at([last, 0.0])[0] - 12.0, axes.area.top + 15.0];
        let text = Text::small(at, Anchor::End, Colour::TEXT, &words);
        sheet.marks.push(Mark::Text(Text { halo: true, ..text }));
    }
}

/// More events than these would hide the curves.
const MOST_EVENTS: usize = 40;

/// How many samples tell how large a motion is that runs away: without the last ones, each of which is far beyond all before it.
fn telling(series: &[Series]) -> usize {
    const FAR: f64 = 4.0;
    let count = series.first().map_or(0, |series| series.values.len());
    let size = |k: usize| series.iter().filter_map(|s| s.values.get(k)).map(|x| x.abs()).fold(0.0, f64::max);
    let mut largest = 0.0;
    let so_far: Vec<f64> = (0..count)
        .map(|k| {
            largest = f64::max(largest, size(k));
            largest
        })
        .collect();
    let mut last = count;
    while let Some([before, end]) = last.checked_sub(2).and_then(|k| so_far.get(k..last)) {
        if last <= count.div_ceil(2) || *end <= FAR * before {
            break;
        }
        last -= 1;
    }
    last
}

/// Where the line from a point inside an area to one above or below it leaves the area.
fn cut([x0, y0]: Point, [x1, y1]: Point, area: Area) -> Option<Point> {
    let edge = y1.clamp(area.top, area.bottom);
    (edge != y1).then(|| [x0 + (x1 - x0) * (edge - y0) / (y1 - y0), edge])
}

/// An axis for values, with a mark every 40 px or so.
pub(super) fn axis(values: impl Iterator<Item = f64>, height: f64, name: &str, unit: &str) -> Axis {
    Axis::linear(range(values), 0.06, (height / 44.0).clamp(2.0, 8.0), name, unit)
}

/// The least and the greatest of what is finite; zeros if nothing is.
pub(super) fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let finite = values.filter(|x| x.is_finite());
    let [least, greatest] =
        finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| [least.min(x), most.max(x)]);
    if least <= greatest { [least, greatest] } else { [0.0, 0.0] }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn series(values: Vec<f64>) -> Series {
        Series { pen: Pen::axis(0), long: String::new(), short: String::new(), values }
    }

    #[test]
    fn the_end_of_a_run_away_does_not_tell_how_large_the_rest_is() {
        let calm = (0..50).map(|k| (0.3 * f64::from(k)).sin());
        let wild: Vec<f64> = calm.clone().chain([17.0, 4e3, -2e12]).collect();
        assert_eq!(telling(&[series(calm.collect()), series(Vec::new())]), 50);
        assert_eq!(telling(&[series(vec![0.1; 53]), series(wild)]), 50);
        // A steady growth tells all of it, and so do two samples.
        assert_eq!(telling(&[series((0..20).map(|k| f64::from(k).exp2()).collect())]), 20);
        assert_eq!(telling(&[series(vec![1.0, 1e9])]), 1);
        assert_eq!(telling(&[]), 0);
    }

    #[test]
    fn a_line_is_cut_at_the_edge() {
        let area = Area { left: 0.0, top: 10.0, right: 100.0, bottom: 60.0 };
        assert_eq!(cut([40.0, 30.0], [50.0, -170.0], area), Some([41.0, 10.0]));
        assert_eq!(cut([40.0, 30.0], [50.0, 130.0], area), Some([43.0, 60.0]));
        assert_eq!(cut([40.0, 30.0], [50.0, 50.0], area), None);
    }
}
