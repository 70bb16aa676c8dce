//! Pair of axes: conversion of values to positions, frame, grid and labels.

use super::sheet::{Anchor, Colour, Mark, Pen, Point, SMALL, Sheet, Text};
use super::ticks::{Ticks, exponent, reduced};
use super::{font, prefix};

/// Rectangle on a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Left edge, px.
    pub left: f64,
    /// Upper edge, px from the top of the sheet.
    pub top: f64,
    /// Right edge, px.
    pub right: f64,
    /// Lower edge, px from the top of the sheet.
    pub bottom: f64,
}

impl Area {
    /// Width, px.
    pub const fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Height, px.
    pub const fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// Returns the area without the top `used` px.
    pub const fn below(self, used: f64) -> Self {
        Self { top: self.top + used, ..self }
    }
}

/// Axis with its range, ticks and label.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Both ends, in the numbers printed at the axis.
    range: [f64; 2],
    /// Power of ten removed from all numbers.
    exponent: i32,
    /// True for a logarithmic axis; its numbers are log₁₀ of the values.
    log: bool,
    ticks: Ticks,
    /// Label, such as `ω (10⁻³ rad/s)`.
    label: String,
}

impl Axis {
    /// Creates a linear axis for values from `least` to `greatest` with about `count` ticks.
    /// `margin` is added at both ends, relative to the range.
    pub fn linear([least, greatest]: [f64; 2], margin: f64, count: f64, name: &str, unit: &str) -> Self {
        let exponent = exponent(least.abs().max(greatest.abs()));
        let [least, greatest] = [least, greatest].map(|x| reduced(x, exponent));
        let size = least.abs().max(greatest.abs());
        // A curve that varies only by rounding is drawn as a straight line in the middle.
        let [least, greatest] = match greatest - least {
            span if span > 1e-9 * size => [least - margin * span, greatest + margin * span],
            _ if size == 0.0 => [-1.0, 1.0],
            _ => [least - 0.1 * size, greatest + 0.1 * size],
        };
        Self {
            range: [least, greatest],
            exponent,
            log: false,
            ticks: Ticks::linear(least, greatest, count),
            label: labelled(name, &prefix::unit(exponent, unit)),
        }
    }

    /// Returns the axis with its direction reversed.
    pub fn downward(mut self) -> Self {
        self.range.reverse();
        self
    }

    /// Creates a logarithmic axis from 10^least to 10^greatest. Its lowest tick stands for 0 and
    /// for values below the range.
    pub fn powers(least: i32, greatest: i32, most: i32, name: &str) -> Self {
        let mut ticks = Ticks::powers(least + 1, greatest, most);
        ticks.values.insert(0, f64::from(least));
        ticks.labels.insert(0, "0".to_owned());
        Self {
            range: [f64::from(least), f64::from(greatest)],
            exponent: 0,
            log: true,
            ticks,
            label: name.to_owned(),
        }
    }

    /// Creates a logarithmic axis for positive values from `least` to `greatest`, with at most
    /// `most` ticks, at powers of ten.
    pub fn logarithmic([least, greatest]: [f64; 2], most: i32, name: &str, unit: &str) -> Self {
        let range = [least, greatest].map(f64::log10);
        let [first, last] = [range[0].ceil() as i32, range[1].floor() as i32];
        Self {
            range,
            exponent: 0,
            log: true,
            ticks: Ticks::powers(first, last, most),
            label: labelled(name, unit),
        }
    }

    /// Returns the axis without label and tick labels.
    pub fn bare(mut self) -> Self {
        self.label.clear();
        self.ticks.labels.clear();
        self
    }

    /// Returns the relative position of a value: 0 at the start of the axis, 1 at its end.
    pub fn part(&self, value: f64) -> f64 {
        let [least, greatest] = self.range;
        let x = if self.log { value.log10().max(least) } else { reduced(value, self.exponent) };
        (x - least) / (greatest - least)
    }

    /// Returns the width of the label, px.
    pub fn label_width(&self) -> f64 {
        font::width(&self.label, SMALL)
    }

    fn widest(&self) -> f64 {
        self.ticks.labels.iter().map(|label| font::width(label, SMALL)).fold(0.0, f64::max)
    }
}

/// Formats a label as `ω (rad/s)`, or only the name or the unit if the other is empty.
fn labelled(name: &str, unit: &str) -> String {
    match (name, unit) {
        (name, "") => name.to_owned(),
        ("", unit) => unit.to_owned(),
        (name, unit) => format!("{name} ({unit})"),
    }
}

/// Two axes, placed on a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// Area of the curves, inside the frame.
    pub area: Area,
    x: Axis,
    y: Axis,
}

/// Distance from the labels to the frame, px.
const GAP: f64 = 6.0;
const LINE: f64 = 17.0;
/// Space to the right of the frame for half a tick label, px.
const RIGHT: f64 = 14.0;

impl Axes {
    /// Creates axes that fill an area with their labels. `left` fixes the distance of the frame
    /// from the left edge, to align several plots.
    pub fn within(outer: Area, x: Axis, y: Axis, left: Option<f64>) -> Self {
        let beside = left.unwrap_or_else(|| Self::beside(&y));
        let below = match (x.ticks.labels.is_empty(), x.label.is_empty()) {
            (true, _) => GAP,
            (false, true) => LINE,
            (false, false) => 2.0 * LINE + 3.0,
        };
        let area = Area {
            left: outer.left + beside,
            right: outer.right - RIGHT,
            top: outer.top + 0.5 * SMALL,
            bottom: outer.bottom - below,
        };
        Self { area, x, y }
    }

    /// Creates axes with equal scales; the frame is a square in the middle of the area.
    pub fn square(outer: Area, x: Axis, y: Axis) -> Self {
        let mut axes = Self::within(outer, x, y, None);
        let side = axes.area.width().min(axes.area.height());
        let spare = axes.area.width() - side;
        axes.area.left += 0.5 * spare;
        axes.area.right = axes.area.left + side;
        axes.area.bottom = axes.area.top + side;
        axes
    }

    /// Returns the width needed to the left of the frame, px.
    pub fn beside(y: &Axis) -> f64 {
        y.widest() + GAP + if y.label.is_empty() { 0.0 } else { LINE + 2.0 }
    }

    /// Returns the position of a pair of values on the sheet, px.
    pub fn at(&self, [x, y]: Point) -> Point {
        [
            self.area.left + self.x.part(x) * self.area.width(),
            self.area.bottom - self.y.part(y) * self.area.height(),
        ]
    }

    /// Draws the frame, the grid, the tick labels and the axis labels.
    pub fn draw(&self, sheet: &mut Sheet) {
        let Area { left, top, right, bottom } = self.area;
        let grid = Pen::solid(Colour::GRID, 0.8);
        let ([x0, x1], [y0, y1]) = (self.x.range, self.y.range);
        let across = |value: f64| left + (value - x0) / (x1 - x0) * self.area.width();
        let up = |value: f64| bottom - (value - y0) / (y1 - y0) * self.area.height();
        sheet.lines(self.x.ticks.values.iter().map(|&v| vec![[across(v), top], [across(v), bottom]]), grid);
        sheet.lines(self.y.ticks.values.iter().map(|&v| vec![[left, up(v)], [right, up(v)]]), grid);
        if !self.y.log && y0 < 0.0 && y1 > 0.0 {
            sheet.line(vec![[left, up(0.0)], [right, up(0.0)]], Pen::solid(Colour(0xc3_ca_d2), 0.8));
        }
        let frame = vec![[left, top], [left, bottom], [right, bottom], [right, top], [left, top]];
        sheet.line(frame, Pen::solid(Colour::FRAME, 0.8));

        let mut free = f64::NEG_INFINITY;
        for (value, label) in self.x.ticks.values.iter().zip(&self.x.ticks.labels) {
            let text = Text::small([across(*value), bottom + LINE], Anchor::Middle, Colour::TEXT, label);
            let [from, to] = text.extent().map(|x| x + text.at[0]);
            if from > free {
                free = to + 4.0;
                sheet.marks.push(Mark::Text(text));
            }
        }
        for (value, label) in self.y.ticks.values.iter().zip(&self.y.ticks.labels) {
            let at = [left - GAP, up(*value) + 0.36 * SMALL];
            sheet.text(at, Anchor::End, Colour::TEXT, label);
        }
        let middle = [0.5 * (left + right), bottom + 2.0 * LINE];
        if !self.x.label.is_empty() {
            sheet.text(middle, Anchor::Middle, Colour::BLACK, &self.x.label);
        }
        if !self.y.label.is_empty() {
            let at = [left - GAP - self.y.widest() - 8.0, 0.5 * (top + bottom)];
            let text = Text::small(at, Anchor::Middle, Colour::BLACK, &self.y.label);
            sheet.marks.push(Mark::Text(Text { upward: true, ..text }));
        }
    }
}
