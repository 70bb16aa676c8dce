//! Figures of a sweep: distributions of outcomes, their dependence on inputs, and the questions.

mod questions;

use polhode_document::Picture;
use polhode_document::figure::axes::{Area, Axes, Axis};
use polhode_document::figure::font;
use polhode_document::figure::legend::{Key, heading};
use polhode_document::figure::sheet::{Anchor, Colour, LARGE, Mark, Pen, Point, SMALL, Sheet, Text};
use polhode_document::layout::printable;

use crate::report::{SweepSample, SweepStatistic, SweepSummary};

/// Figures of a sweep: [`SweepFigures::histograms`] of its outcomes, [`SweepFigures::pairs`] of
/// inputs and outcomes, and [`SweepFigures::questions`].
#[derive(Clone, Copy, Debug)]
pub struct SweepFigures<'a> {
    summary: &'a SweepSummary,
    sample: &'a SweepSample,
}

/// Width and height of a panel, px, with three panels in a row.
const PANEL: [f64; 2] = [336.0, 232.0];
/// Width of a panel on a page, px.
const ON_PAGE: f64 = 316.0;
const COLUMNS: usize = 3;
const MARGIN: f64 = 14.0;
/// Height of the heading above all panels, px.
const HEAD: f64 = 30.0;
const MOST_HISTOGRAMS: usize = 9;
const MOST_PAIRS: usize = 6;

/// Outcomes shown first, most informative first; others follow in their order.
const FIRST: [&str; 9] = [
    "period_s",
    "rotation_period_s",
    "precession_period_s",
    "largest_angle_to_axis_3_rad",
    "largest_omega_rad_s",
    "end_kinetic_energy_j",
    "end_momentum_kg_m2_s",
    "largest_torque_n_m",
    "end_time_s",
];
/// Prefixes of outcomes shown last, because their histograms contain little information.
const LAST: [&str; 12] = [
    "mass_",
    "moment_",
    "steps_",
    "evaluations",
    "energy_drift",
    "momentum_drift",
    "error_",
    "flip_interval",
    "start_",
    "least_angle_to_axis_1",
    "end_omega",
    "growth_rate",
];

/// Colours of regimes, in the order of the summary.
const REGIMES: [Colour; 4] = [Colour::AXES[0], Colour::AXES[1], Colour::AXES[2], Colour::ORANGE];

impl<'a> SweepFigures<'a> {
    /// Creates the figures of a sweep; `sample` contains some of its members.
    pub const fn new(summary: &'a SweepSummary, sample: &'a SweepSample) -> Self {
        Self { summary, sample }
    }

    /// Draws the distributions of outcomes, one panel for each of the most informative ones.
    pub fn histograms(&self) -> Picture {
        self.together(&self.of_outcomes())
    }

    pub(crate) fn each_histogram(&self) -> (&'static str, Vec<Picture>) {
        (
            "In the histograms, the line is the median; dashed lines are the 5 % and 95 % quantiles.",
            self.of_outcomes().each(),
        )
    }

    fn of_outcomes(&self) -> Panels<'a> {
        let mut shown: Vec<_> =
            self.summary.outcomes.iter().filter_map(|s| Some((s, s.histogram.as_ref()?))).collect();
        shown.sort_by_key(|(statistic, _)| importance(&statistic.name));
        // The end of a free motion has the energy of its start: identical histograms are shown
        // once.
        let all = shown.clone();
        let alike = |(k, (a, _)): &(usize, (&SweepStatistic, _))| {
            all.iter().take(*k).any(|(b, _)| a.mean == b.mean && a.quantiles == b.quantiles)
        };
        shown = shown.into_iter().enumerate().filter(|one| !alike(one)).map(|(_, one)| one).collect();
        shown.truncate(MOST_HISTOGRAMS);
        let note = "line: median; dashed: 5 % and 95 %";
        Panels::new("Outcomes", note.to_owned(), [shown.len(), COLUMNS], move |sheet, area, k| {
            if let Some((statistic, _)) = shown.get(k) {
                bars(sheet, area, &Shown::of(statistic).statistic);
            }
        })
    }

    /// Draws the strongest dependencies of outcomes on inputs, with one dot per sampled member.
    pub fn pairs(&self) -> Picture {
        self.together(&self.of_pairs())
    }

    pub(crate) fn each_pair(&self) -> (&'static str, Vec<Picture>) {
        ("Each dot is a sampled member; r is the rank correlation.", self.of_pairs().each())
    }

    fn of_pairs(&self) -> Panels<'a> {
        let mut shown: Vec<(&str, &str, f64)> = Vec::new();
        for pair in &self.summary.correlations {
            if shown.len() < MOST_PAIRS && !shown.iter().any(|(_, outcome, _)| *outcome == pair.outcome) {
                shown.push((&pair.input, &pair.outcome, pair.value));
            }
        }
        let note = format!("{} sampled members; r: rank correlation", self.sample.rows());
        let figures = *self;
        Panels::new("Outcomes and inputs", note, [shown.len(), COLUMNS], move |sheet, area, k| {
            if let Some((input, outcome, value)) = shown.get(k) {
                figures.dots(sheet, area, input, outcome, *value);
            }
        })
    }

    /// Draws panels under one heading.
    fn together(&self, panels: &Panels<'_>) -> Picture {
        let Panels { what, note, count, columns, draw } = panels;
        let (count, columns) = (*count, *columns);
        let title = printable(self.summary.title.as_deref().unwrap_or("sweep"));
        let width = columns.min(count.max(2)) as f64 * PANEL[0];
        let rows = count.max(1).div_ceil(columns) as f64;
        let mut sheet = Sheet::new(width, HEAD + rows * PANEL[1], format!("{title}: {what}"));
        let note_width = font::width(note, SMALL);
        let title = font::fitted(&title, LARGE, width - note_width - 4.0 * MARGIN);
        let head = Text::small([MARGIN, 24.0], Anchor::Start, Colour::BLACK, &title);
        sheet.marks.push(Mark::Text(Text { size: LARGE, ..head }));
        if count == 0 {
            let middle = [0.5 * width, HEAD + 0.5 * PANEL[1]];
            sheet.text(middle, Anchor::Middle, Colour::FAINT, "nothing to plot");
            return Picture { sheet };
        }
        sheet.text([width - MARGIN, 24.0], Anchor::End, Colour::FAINT, note);
        for k in 0..count {
            let (row, column) = ((k / columns) as f64, (k % columns) as f64);
            let (left, top) = (column * PANEL[0], HEAD + row * PANEL[1]);
            let area = Area {
                left: left + MARGIN,
                top: top + MARGIN,
                right: left + PANEL[0] - MARGIN,
                bottom: top + PANEL[1] - 4.0,
            };
            draw(&mut sheet, area, k);
        }
        Picture { sheet }
    }

    /// Returns a column of the summary as it is shown.
    fn shown(&self, name: &str) -> Option<Shown> {
        let mut all = self.summary.inputs.iter().chain(&self.summary.outcomes);
        all.find(|statistic| statistic.name == name).map(Shown::of)
    }

    /// Returns the place of each sampled member in two columns; `None` if a value is missing or
    /// outside the axes.
    fn places<'s>(
        &'s self,
        axes: &'s Axes,
        names: [&str; 2],
        [p, q]: [f64; 2],
    ) -> impl Iterator<Item = Option<Point>> + 's {
        let column = |name: &str| {
            let k = self.sample.names.iter().position(|other| other == name);
            k.and_then(|k| self.sample.columns.get(k)).map_or(&[][..], Vec::as_slice)
        };
        let [xs, ys] = names.map(column);
        xs.iter().zip(ys).map(move |(x, y)| {
            let place = x.zip(*y).map(|(x, y)| axes.at([p * x, q * y]))?;
            let inside = (axes.area.left..=axes.area.right).contains(&place[0])
                && (axes.area.top..=axes.area.bottom).contains(&place[1]);
            inside.then_some(place)
        })
    }

    fn dots(&self, sheet: &mut Sheet, area: Area, input: &str, outcome: &str, value: f64) {
        let (Some(x), Some(y)) = (self.shown(input), self.shown(outcome)) else { return };
        let regimes: Vec<&str> =
            self.summary.regimes.iter().take(REGIMES.len()).map(|share| share.name.as_str()).collect();
        let pen = |k: usize| Pen::solid(REGIMES.get(k).copied().unwrap_or(Colour::FAINT), 2.2).faint(0.45);
        let keys: Vec<Key> = if regimes.len() > 1 {
            regimes
                .iter()
                .enumerate()
                .map(|(k, name)| Key::dot(Pen { width: 5.0, opacity: 1.0, ..pen(k) }, *name))
                .collect()
        } else {
            Vec::new()
        };
        let used =
            heading(sheet, area, &y.statistic.name, &format!("r = {value:+.2}").replace('-', "−"), &keys);
        let area = area.below(used);
        let axes = Axes::within(
            area,
            axis_of(&x.statistic, area.width(), 70.0),
            axis_of(&y.statistic, area.height(), 34.0),
            None,
        );
        axes.draw(sheet);
        let mut dots: Vec<Vec<Point>> = vec![Vec::new(); regimes.len() + 1];
        for (place, regime) in
            self.places(&axes, [input, outcome], [x.factor, y.factor]).zip(&self.sample.regimes)
        {
            let k = regimes.iter().position(|name| Some(*name) == regime.as_deref()).unwrap_or(regimes.len());
            if let (Some(dots), Some(place)) = (dots.get_mut(k), place) {
                dots.push(place);
            }
        }
        for (k, dots) in dots.into_iter().enumerate() {
            sheet.dots(dots, pen(k));
        }
    }
}

type Draw<'a> = Box<dyn Fn(&mut Sheet, Area, usize) + 'a>;

/// Panels of one figure.
struct Panels<'a> {
    what: &'static str,
    note: String,
    count: usize,
    columns: usize,
    /// Draws a panel, by its index.
    draw: Draw<'a>,
}

impl<'a> Panels<'a> {
    fn new(
        what: &'static str,
        note: String,
        [count, columns]: [usize; 2],
        draw: impl Fn(&mut Sheet, Area, usize) + 'a,
    ) -> Self {
        Self { what, note, count, columns, draw: Box::new(draw) }
    }

    /// Draws each panel as a picture of its own.
    fn each(&self) -> Vec<Picture> {
        let of = |k| {
            let mut sheet = Sheet::new(ON_PAGE, PANEL[1], format!("{} {}", self.what, k + 1));
            let area = Area { left: 4.0, top: 4.0, right: ON_PAGE - 4.0, bottom: PANEL[1] - 4.0 };
            (self.draw)(&mut sheet, area, k);
            Picture { sheet }
        };
        (0..self.count).map(of).collect()
    }
}

/// Column as it is shown: angles in degrees.
struct Shown {
    statistic: SweepStatistic,
    /// Factor from the values of the column to the shown values.
    factor: f64,
}

impl Shown {
    fn of(statistic: &SweepStatistic) -> Self {
        if statistic.unit != "rad" {
            return Self { statistic: statistic.clone(), factor: 1.0 };
        }
        let factor = 1_f64.to_degrees();
        let mut shown = statistic.clone();
        shown.name = statistic.name.trim_end_matches("_rad").to_owned();
        "°".clone_into(&mut shown.unit);
        for number in [&mut shown.mean, &mut shown.standard_deviation, &mut shown.min, &mut shown.max] {
            *number = number.map(|x| factor * x);
        }
        shown.quantiles.iter_mut().for_each(|q| q.value *= factor);
        if let Some(histogram) = &mut shown.histogram {
            histogram.least *= factor;
            histogram.greatest *= factor;
        }
        Self { statistic: shown, factor }
    }
}

/// Returns the rank of an outcome among the histograms, smallest first.
fn importance(name: &str) -> usize {
    if name.starts_with("event_") && name.ends_with("_first_s") {
        return 0;
    }
    match FIRST.iter().position(|first| *first == name) {
        Some(k) => 1 + k,
        None if LAST.iter().any(|last| name.starts_with(last)) => 3 + FIRST.len(),
        None => 2 + FIRST.len(),
    }
}

/// Returns an axis over the range of a column's histogram. `length` is in px, and ticks are about
/// `step` px apart.
fn axis_of(statistic: &SweepStatistic, length: f64, step: f64) -> Axis {
    let ends = [statistic.min.unwrap_or(0.0), statistic.max.unwrap_or(1.0)];
    let (ends, log) = statistic.histogram.as_ref().map_or((ends, false), |h| ([h.least, h.greatest], h.log));
    let (name, marks) = (quantity(statistic, length), length / step);
    if log {
        Axis::logarithmic(ends, marks as i32, &name, &statistic.unit)
    } else {
        Axis::linear(ends, 0.03, marks.clamp(2.0, 8.0), &name, &statistic.unit)
    }
}

/// Returns a column's quantity, shortened to leave room for its unit: `largest omega` for
/// `largest_omega_rad_s`.
fn quantity(statistic: &SweepStatistic, room: f64) -> String {
    let SweepStatistic { name, unit, .. } = statistic;
    let suffix: String = unit.to_lowercase().chars().map(|c| if c == '²' { '2' } else { c }).collect();
    let suffix = format!("_{}", suffix.replace(['·', '/'], "_"));
    let name = name.strip_suffix(&suffix).unwrap_or(name).replace('_', " ");
    font::fitted(&printable(&name), SMALL, room - font::width(&format!(" (10⁻¹² {unit})"), SMALL))
}

fn bars(sheet: &mut Sheet, area: Area, statistic: &SweepStatistic) {
    let Some(histogram) = &statistic.histogram else { return };
    let outside = match (histogram.below, histogram.above) {
        (0, 0) => String::new(),
        (below, 0) => format!("{below} below"),
        (0, above) => format!("{above} above"),
        (below, above) => format!("{below} below, {above} above"),
    };
    let area = area.below(heading(sheet, area, &statistic.name, &outside, &[]));
    let most = histogram.counts.iter().copied().max().unwrap_or(0) as f64;
    let y = Axis::linear([0.0, 1.05 * most], 0.0, (area.height() / 34.0).clamp(2.0, 6.0), "members", "");
    let axes = Axes::within(area, axis_of(statistic, area.width(), 70.0), y, None);
    axes.draw(sheet);
    let bins = histogram.counts.len() as f64;
    let edge = |k: usize| {
        let part = k as f64 / bins;
        if histogram.log {
            histogram.least * (histogram.greatest / histogram.least).powf(part)
        } else {
            histogram.least + part * (histogram.greatest - histogram.least)
        }
    };
    for (k, &count) in histogram.counts.iter().enumerate().filter(|(_, count)| **count > 0) {
        let ([left, top], [right, bottom]) = (axes.at([edge(k), count as f64]), axes.at([edge(k + 1), 0.0]));
        let right = (right - 0.8).max(left + 0.4);
        let corners = vec![[left, bottom], [left, top], [right, top], [right, bottom]];
        sheet.marks.push(Mark::Polygon { corners, fill: Colour(0x7f_b8_d8), opacity: 1.0 });
    }
    let line = Pen::solid(Colour::BLACK, 1.2);
    let dashed = Pen::solid(Colour::BLACK, 1.0).dashed(&[3.0, 2.5]);
    for (probability, pen) in [(0.05, dashed), (0.5, line), (0.95, dashed)] {
        if let Some(value) = statistic.quantile(probability) {
            let ([x, top], [_, bottom]) = (axes.at([value, 1.05 * most]), axes.at([value, 0.0]));
            if (axes.area.left..=axes.area.right).contains(&x) {
                sheet.line(vec![[x, bottom], [x, top]], pen);
            }
        }
    }
}
