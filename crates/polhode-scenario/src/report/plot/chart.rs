//! Chart: the curves of a figure against time, in panels one below the other.
//!
//! Constant curves are stated in words ([`super::constant`]). Curves of similar size share a panel
//! ([`polhode_document::figure::scale`]).
//!
//! A curve with too many oscillations would fill its panel with stripes. The panel then shows its
//! envelope, and a second panel its beginning. Curves that the samples do not resolve are drawn as
//! dots.

use polhode::motion::Ending;
use polhode_document::figure::axes::{Area, Axes, Axis};
use polhode_document::figure::legend::Key;
use polhode_document::figure::range::range;
use polhode_document::figure::scale;
use polhode_document::figure::sheet::{Anchor, Colour, Sheet};
use polhode_document::figure::{font, prefix};
use polhode_document::number::number;

use super::constant::Constant;
use super::curve::Curve;
use super::event_marks::EventMarks;
use super::oscillation::Oscillation;
use super::panel::Panel;
use super::plotted::PlottedMotion;
use super::time::{time_axis, unit_of_time};
use crate::report::sampling::turn_that_hides;

/// Function that writes the heading of a figure with its keys, and returns the area below.
pub(crate) type Heading<'a> = &'a dyn Fn(&mut Sheet, &[Key]) -> Area;

/// Largest number of panels of one quantity.
const MOST: usize = 3;
/// Largest number of panels of one of several quantities.
const MOST_OF_SEVERAL: usize = 2;

/// Number of turning points in the beginning that is drawn separately.
const TURNS: usize = 8;

/// Height of a line of text above a frame, px.
const LINE: f64 = 15.0;
/// Height of the tick labels and the axis label below the lowest frame, px.
const FOOT: f64 = 37.0;

/// Curves of one quantity.
#[derive(Clone, Debug)]
pub(crate) struct Quantity {
    name: &'static str,
    unit: &'static str,
    curves: Vec<Curve>,
    made_of: f64,
}

impl Quantity {
    /// Creates a quantity; without a name it is labelled with the names of its curves.
    pub(crate) fn new(name: &'static str, unit: &'static str, curves: Vec<Curve>) -> Self {
        Self { name, unit, curves, made_of: 0.0 }
    }

    /// Sets the size of its terms, which may cancel; rounding errors are proportional to it.
    pub(crate) fn made_of(self, size: f64) -> Self {
        Self { made_of: size, ..self }
    }
}

/// Chart: panels with curves, and statements in words.
#[derive(Clone, Debug)]
pub(crate) struct Chart<'a> {
    motion: &'a PlottedMotion<'a>,
    panels: Vec<Panel>,
    words: Vec<String>,
    is_zero: bool,
    events: EventMarks,
    /// True if the legend lists the events.
    names_events: bool,
    /// True if the samples may miss an oscillation.
    is_sampled: bool,
}

impl<'a> Chart<'a> {
    pub(crate) fn new(motion: &'a PlottedMotion<'a>, quantities: Vec<Quantity>) -> Self {
        let events = EventMarks::of(motion.trajectory);
        let (mut panels, mut words, mut is_zero) = (Vec::new(), Vec::new(), true);
        let most = if quantities.len() > 1 { MOST_OF_SEVERAL } else { MOST };
        let mut notes = Vec::new();
        let turn = turn_that_hides(motion.samples());
        let is_sampled = turn.is_some();
        for Quantity { name, unit, curves, made_of } in quantities {
            let runs_away = matches!(motion.trajectory.ending(), Ending::Failed { .. });
            let end = range(curves.iter().flat_map(|c| c.pieces.iter().flatten()).map(|p| p[0]))[1];
            let until = if runs_away { telling(&curves) } else { end };
            let finite = curves.iter().flat_map(|curve| curve.range_until(until));
            let scale = finite.map(f64::abs).fold(made_of, f64::max);
            let mut varying = Vec::new();
            for curve in curves {
                match Constant::of(curve.values(), scale) {
                    Some(constant) => {
                        is_zero &= matches!(constant, Constant::Zero(_));
                        words.push(constant.said(&curve.symbol, unit, is_sampled));
                    }
                    None => varying.push(curve),
                }
            }
            if until < end {
                notes.extend(beyond(&varying, unit, until));
            }
            is_zero &= varying.is_empty();
            let ranges: Vec<[f64; 2]> = varying.iter().map(|curve| curve.range_until(until)).collect();
            let groups = scale::groups(&ranges, most);
            let has_all = groups.len() == 1;
            for group in groups {
                let curves = group.into_iter().filter_map(|k| varying.get(k).cloned()).collect();
                panels.push(Panel::new([name, unit], has_all, curves, until));
            }
        }
        match turn {
            Some(turn) => {
                let [dots, one] =
                    if panels.is_empty() { ["", "one sample"] } else { ["dots: samples; ", "one"] };
                notes.push(format!(
                    "{dots}the body turns by up to {} rad from {one} to the next, so oscillations at this rate may be missed",
                    number(turn, 3)
                ));
            }
            _ if !panels.iter().all(Panel::is_resolved) => {
                notes.push("dots: samples, too far apart to resolve the curve".to_owned());
            }
            _ => {}
        }
        words.extend(notes);
        Self { motion, panels, words, is_zero, events, names_events: false, is_sampled }
    }

    /// Returns the chart with one more statement.
    pub(crate) fn saying(mut self, words: &str) -> Self {
        self.words.insert(0, words.to_owned());
        self
    }

    /// Returns the chart with the events listed in its legend, or not.
    pub(crate) fn naming_events(self, names_events: bool) -> Self {
        Self { names_events, ..self }
    }

    /// Returns true if all its curves are zero up to rounding.
    pub(crate) const fn is_zero(&self) -> bool {
        self.is_zero
    }

    fn is_resolved(&self) -> bool {
        !self.is_sampled && self.panels.iter().all(Panel::is_resolved)
    }

    /// Returns true if all its curves are constant.
    pub(crate) fn is_words(&self) -> bool {
        self.panels.is_empty()
    }

    /// Returns the height of the panels with their labels; `two` is that of two panels.
    ///
    /// More panels are higher; a chart of words alone has height 0.
    pub(crate) fn height(&self, two: f64) -> f64 {
        match self.panels.len() {
            0 => 0.0,
            count => two * (1.0 + 0.33 * count.saturating_sub(2) as f64),
        }
    }

    /// Returns the legend: curves, events, and statements.
    pub(crate) fn keys(&self) -> Vec<Key> {
        let curves = self.panels.iter().flat_map(|panel| &panel.curves);
        let mut keys: Vec<Key> = curves.map(|(curve, _)| Key::line(curve.pen, curve.name.as_str())).collect();
        if self.names_events && !self.panels.is_empty() {
            keys.extend(self.events.keys());
        }
        keys.extend(self.words.iter().map(Key::words));
        keys
    }

    pub(crate) fn draw(&self, sheet: &mut Sheet, heading: Heading<'_>) {
        let area = heading(sheet, &self.keys());
        if self.panels.is_empty() {
            return;
        }
        let width = area.width() - 60.0;
        let Some(window) = self.window(width) else {
            let letters = if self.events.has_letters() { LINE - 4.0 } else { 0.0 };
            self.column(sheet, area.below(letters), width, None);
            return;
        };
        let middle = area.left + 0.58 * area.width();
        let (left, right) = (Area { right: middle, ..area }, Area { left: middle + 6.0, ..area });
        let letters = if self.events.has_letters() { LINE - 2.0 } else { 0.0 };
        let frame = self.column(sheet, left.below(LINE + letters), width, None);
        let title = |sheet: &mut Sheet, frame: Area, above: f64, words: &str| {
            let words = font::fitted(words, polhode_document::figure::sheet::SMALL, frame.width() + 12.0);
            let at = [0.5 * (frame.left + frame.right), frame.top - 6.0 - above];
            sheet.text(at, Anchor::Middle, Colour::TEXT, &words);
        };
        let of = if self.is_resolved() { "whole run: envelope" } else { "envelope of samples" };
        title(sheet, frame, letters, of);
        let frame = self.column(sheet, right.below(LINE + letters), width, Some(window));
        let (unit, scale) = unit_of_time(window[1].abs().max(window[0].abs()));
        let [from, to] =
            window.map(|t| if t == 0.0 { "0".to_owned() } else { prefix::value(t / scale, 3, unit) });
        title(sheet, frame, 0.0, &format!("{from} to {to}"));
    }

    /// Returns the time span to be drawn separately, if a curve would fill a frame of this width,
    /// px, with stripes.
    fn window(&self, width: f64) -> Option<[f64; 2]> {
        let start = self.motion.samples().first()?.state.time;
        let turn = |oscillation: &Oscillation| {
            oscillation.times.get(TURNS).or(oscillation.times.last()).copied().unwrap_or(f64::INFINITY)
        };
        let end_of = |(curve, oscillation): &(Curve, Oscillation)| {
            let end = turn(oscillation);
            // A growing oscillation starts below the resolution of the whole curve.
            end.min(turn(&Oscillation::of(&curve.within([start, end]))))
        };
        let curves = self.panels.iter().flat_map(|panel| &panel.curves);
        let striped = curves.filter(|(_, oscillation)| oscillation.is_striped(width));
        let end = striped.map(end_of).fold(f64::INFINITY, f64::min);
        (end.is_finite() && end > start).then_some([start, end])
    }

    /// Draws all panels, for the whole run or a time span; returns the frame of the first.
    fn column(&self, sheet: &mut Sheet, area: Area, width: f64, window: Option<[f64; 2]>) -> Area {
        let count = self.panels.len() as f64;
        let height = (area.height() - FOOT) / count;
        let times = match window {
            Some(window) => window,
            None => range(self.motion.samples().iter().map(|s| s.state.time)),
        };
        let shown: Vec<Panel> = match window {
            Some(_) => self.panels.iter().map(|panel| panel.in_full(width)).collect(),
            None => self.panels.clone(),
        };
        let axes_of = |(panel, whole): (&Panel, &Panel)| match window {
            Some(window) => panel.axis_within(window, whole, height - 12.0),
            None => panel.axis(height - 12.0),
        };
        let axes: Vec<Axis> = shown.iter().zip(&self.panels).map(axes_of).collect();
        let left = axes.iter().map(Axes::beside).fold(0.0, f64::max);
        let (x, scale) = time_axis(times, area.width() - left);
        let mut first = area;
        for (k, (panel, y)) in shown.iter().zip(axes).enumerate() {
            let top = area.top + height * k as f64;
            let is_last = k + 1 == self.panels.len();
            let outer = Area { top, bottom: top + height + if is_last { FOOT } else { -3.0 }, ..area };
            let x = if is_last { x.clone() } else { x.clone().bare() };
            let axes = Axes::within(outer, x, y, Some(left));
            axes.draw(sheet);
            self.events.draw(&axes, scale, k == 0 && window.is_none(), sheet);
            match window {
                Some(window) => panel.draw_within(sheet, &axes, scale, window, self.is_sampled),
                None => panel.draw(sheet, &axes, scale, width, self.is_sampled),
            }
            if k == 0 {
                first = axes.area;
            }
        }
        first
    }
}

/// Describes the largest value, with its time, of curves that leave their panel after `until`.
///
/// `None` without a finite value.
fn beyond(curves: &[Curve], unit: &str, until: f64) -> Option<String> {
    let points = curves.iter().flat_map(|curve| curve.pieces.iter().flatten()).filter(|p| p[0] > until);
    let finite = points.map(|[time, x]| [*time, x.abs()]).filter(|[_, x]| x.is_finite());
    let [time, largest] = finite.reduce(|most, point| if point[1] > most[1] { point } else { most })?;
    Some(format!(
        "beyond the frame: to {} at {}",
        prefix::value(largest, 3, unit),
        prefix::value(time, 3, "s")
    ))
}

/// Returns the time up to which the curves of a diverging motion determine the scale of their
/// panel.
///
/// It excludes the last samples while each of them is much larger than all samples before it.
fn telling(curves: &[Curve]) -> f64 {
    const FAR: f64 = 4.0;
    let points =
        |k: usize| curves.iter().filter_map(move |c| c.pieces.first().and_then(|piece| piece.get(k)));
    let count = curves.first().and_then(|curve| curve.pieces.first()).map_or(0, Vec::len);
    let mut largest = 0.0;
    let so_far: Vec<f64> = (0..count)
        .map(|k| {
            largest = points(k).map(|p| p[1].abs()).fold(largest, f64::max);
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
    last.checked_sub(1).and_then(|k| points(k).next()).map_or(0.0, |p| p[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use polhode_document::figure::sheet::Pen;
    use polhode_document::layout::plain_spaces;

    fn curve(values: Vec<f64>) -> Curve {
        let piece = values.into_iter().enumerate().map(|(k, x)| [k as f64, x]).collect();
        Curve { pen: Pen::axis(0), name: String::new(), symbol: String::new(), pieces: vec![piece] }
    }

    #[test]
    fn how_far_a_curve_goes_has_the_time_of_its_largest_value() {
        let shown = |curves: &[Curve], until| beyond(curves, "rad/s", until).map(|text| plain_spaces(&text));
        let curves = [curve(vec![0.3, -5e3, 41.0, 7.0]), curve(vec![2.7, 0.1, f64::INFINITY, 43.0])];
        assert_eq!(shown(&curves, 0.0).unwrap(), "beyond the frame: to 5000 rad/s at 1 s");
        assert_eq!(shown(&curves, 1.0).unwrap(), "beyond the frame: to 43 rad/s at 3 s");
        assert_eq!(shown(&[], 0.0), None);
        assert_eq!(shown(&[curve(vec![0.3, f64::NAN])], 0.0), None);
    }

    #[test]
    fn the_end_of_a_run_away_does_not_tell_how_large_the_rest_is() {
        let calm = (0..50).map(|k| (0.3 * f64::from(k)).sin());
        let wild: Vec<f64> = calm.clone().chain([17.0, 4e3, -2e12]).collect();
        assert_eq!(telling(&[curve(calm.collect()), curve(Vec::new())]), 49.0);
        assert_eq!(telling(&[curve(vec![0.1; 53]), curve(wild)]), 49.0);
        // Steady growth excludes no samples, and neither do only two samples.
        assert_eq!(telling(&[curve((0..20).map(|k| f64::from(k).exp2()).collect())]), 19.0);
        assert_eq!(telling(&[curve(vec![1.0, 1e9])]), 0.0);
        assert_eq!(telling(&[]), 0.0);
    }
}
