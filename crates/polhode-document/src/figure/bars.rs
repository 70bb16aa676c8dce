//! Bar charts: the terms of a sum, and the largest contributions to an error.

use super::axes::Area;
use super::legend::{Key, heading};
use super::sheet::{Anchor, Colour, Mark, Pen, SMALL, Sheet, Text};
use super::{font, solids};
use crate::drawing::{Bar, BarPanel, Bars};
use crate::layout::printable;

/// Width of two panels next to each other, and of one, px.
const WIDTHS: [f64; 2] = [640.0, 404.0];
const MARGIN: f64 = 10.0;
/// Distance between bars, px.
const STEP: f64 = 18.0;
const BAR: f64 = 12.0;
/// Height of the title of a panel, px.
const TITLE: f64 = 20.0;
const GAP: f64 = 14.0;
/// Largest part of the width of a panel for names.
const NAMES: f64 = 0.5;

pub(super) fn sheet(bars: &Bars) -> Sheet {
    let (columns, whole_width) = if bars.panels.len() > 1 { (2, WIDTHS[0]) } else { (1, WIDTHS[1]) };
    let title = printable(&bars.title);
    let keys: Vec<Key> = used(bars)
        .filter_map(|kind| Some(Key::dot(Pen::solid(solids::colour(kind), 9.0), *bars.kinds.get(kind)?)))
        .collect();
    // The height of the heading is known only after it is drawn.
    let whole = Area { left: MARGIN, top: MARGIN, right: whole_width - MARGIN, bottom: MARGIN };
    let mut sheet = Sheet::new(whole_width, MARGIN, title.clone());
    let mut top = MARGIN + heading(&mut sheet, whole, &title, "", &keys);
    let width = (whole_width - 2.0 * MARGIN - (columns - 1) as f64 * GAP) / columns as f64;
    for row in bars.panels.chunks(columns) {
        let titled = if columns > 1 { TITLE } else { 0.0 };
        for (k, panel) in row.iter().enumerate() {
            let left = MARGIN + k as f64 * (width + GAP);
            if columns > 1 {
                let title = font::fitted(&printable(&panel.title), SMALL, width);
                sheet.text([left, top + SMALL], Anchor::Start, Colour::BLACK, &title);
            }
            draw(panel, Area { left, top: top + titled, right: left + width, bottom: top }, &mut sheet);
        }
        let most = row.iter().map(|panel| panel.bars.len()).max().unwrap_or(0);
        top += titled + most as f64 * STEP + GAP;
    }
    sheet.height = top;
    sheet
}

/// Returns the kinds that occur among the bars.
fn used(bars: &Bars) -> impl Iterator<Item = usize> + '_ {
    let has = |kind: &usize| bars.panels.iter().flat_map(|panel| &panel.bars).any(|bar| bar.kind == *kind);
    (0..bars.kinds.len()).filter(has)
}

/// Draws the bars from the top of an area downward, names at the left, sizes at the right.
fn draw(panel: &BarPanel, area: Area, sheet: &mut Sheet) {
    let widest = |texts: &mut dyn Iterator<Item = f64>| texts.fold(0.0, f64::max);
    let names = widest(&mut panel.bars.iter().map(|bar| font::width(&printable(&bar.name), SMALL)));
    let names = names.min(NAMES * area.width());
    let sizes = widest(&mut panel.bars.iter().map(|bar| font::width(&bar.size, SMALL)));
    let (left, right) = (area.left + names + 8.0, area.right - sizes - 8.0);
    let [least, greatest] = panel.ends();
    let scale = if greatest > least { (right - left) / (greatest - least) } else { 0.0 };
    let at = |x: f64| left + scale * (x - least);
    let bottom = area.top + panel.bars.len() as f64 * STEP;
    let mut end: Option<f64> = None;
    for (k, bar) in panel.bars.iter().enumerate() {
        let middle = area.top + (k as f64 + 0.5) * STEP;
        let [from, to] = [bar.from.min(bar.to), bar.from.max(bar.to)].map(at);
        // A bar that is too short to be visible is drawn 1 px wide.
        let to = to.max(from + 1.0);
        let (up, down) = (middle - 0.5 * BAR, middle + 0.5 * BAR);
        let corners = vec![[from, up], [to, up], [to, down], [from, down]];
        sheet.marks.push(Mark::Polygon { corners, fill: solids::colour(bar.kind), opacity: 0.85 });
        if let Some(end) = end.filter(|_| bar.from == panel.bars[k - 1].to) {
            sheet.line(vec![[end, up - STEP + BAR], [end, up]], Pen::solid(Colour::FRAME, 0.8));
        }
        end = Some(at(bar.to));
        label(bar, [area.left + names, right + 8.0], middle + 0.36 * SMALL, names, sheet);
    }
    sheet.line(vec![[at(0.0), area.top], [at(0.0), bottom]], Pen::solid(Colour::FRAME, 0.8));
}

fn label(bar: &Bar, [names, sizes]: [f64; 2], base: f64, room: f64, sheet: &mut Sheet) {
    let name = font::fitted(&printable(&bar.name), SMALL, room);
    sheet.text([names, base], Anchor::End, Colour::TEXT, &name);
    sheet.marks.push(Mark::Text(Text::small([sizes, base], Anchor::Start, Colour::FAINT, &bar.size)));
}
