//! Pictures of documents, except graphs: scatter plots and correlations are drawn here.

use super::axes::{Area, Axes, Axis};
use super::font;
use super::legend::{Key, heading};
use super::picture::Picture;
use super::sheet::{Anchor, Colour, Mark, Pen, SMALL, Sheet, Text};
use super::{bars, solids, triangle};
use crate::drawing::{Correlations, Drawing, Scatter};
use crate::layout::printable;

const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 250.0;
const MARGIN: f64 = 10.0;
/// Resolution of a scatter plot, columns; of more points, only the least and the greatest of each
/// column are drawn.
const COLUMNS: usize = 400;
/// Largest number of points that are drawn as large dots.
const FEW: usize = 60;

impl Picture {
    /// Returns the picture of a drawing.
    pub fn of_drawing(drawing: &Drawing) -> Self {
        let sheet = match drawing {
            Drawing::Scatter(scatter) => dots(scatter),
            Drawing::Triangle(triangle) => triangle::sheet(triangle),
            Drawing::Correlations(all) => correlations(all),
            Drawing::Bars(all) => bars::sheet(all),
            Drawing::Solids(all) => solids::sheet(all),
        };
        Self { sheet }
    }
}

fn dots(scatter: &Scatter) -> Sheet {
    let title = printable(&scatter.title);
    let mut sheet = Sheet::new(WIDTH, HEIGHT, title.clone());
    let whole = Area { left: MARGIN, top: MARGIN, right: WIDTH - MARGIN, bottom: HEIGHT - MARGIN };
    let most = scatter.series.iter().map(|series| series.points.len()).max().unwrap_or(0);
    let pen = |k: usize| Pen::solid(Colour::AXES[k % 3], if most < FEW { 5.0 } else { 3.2 }).faint(0.75);
    let band = Pen::solid(Colour::BLACK, 1.1).dashed(&[7.0, 2.5]);
    let names = scatter.series.iter().enumerate();
    let mut keys: Vec<Key> = names.map(|(k, s)| Key::dot(pen(k), printable(&s.name))).collect();
    keys.push(Key::line(band, scatter.band_name));
    if most > 2 * COLUMNS {
        keys.push(Key::words(format!("In each of {COLUMNS} columns the least and the greatest")));
    }
    let used = heading(&mut sheet, whole, &title, "", &keys);
    let [x, y] = scatter.ends();
    let axes = Axes::within(
        whole.below(used),
        Axis::linear(x, 0.02, 7.0, scatter.across[0], scatter.across[1]),
        Axis::linear(y, 0.06, 5.0, scatter.up[0], scatter.up[1]),
        None,
    );
    axes.draw(&mut sheet);
    for height in [-scatter.band, scatter.band] {
        let [from, to] = [axes.area.left, axes.area.right].map(|x| [x, axes.at([0.0, height])[1]]);
        sheet.line(vec![from, to], band);
    }
    for (k, series) in scatter.series.iter().enumerate() {
        sheet.dots(series.seen(COLUMNS, x).into_iter().map(|point| axes.at(point)).collect(), pen(k));
    }
    sheet
}

/// Largest side of a cell, px.
const CELL: f64 = 27.0;
const MOST: f64 = 600.0;

fn correlations(all: &Correlations) -> Sheet {
    let names: Vec<String> = all.names.iter().map(|name| printable(name)).collect();
    let count = names.len().max(1) as f64;
    let cell = CELL.min(MOST / count);
    let beside = names.iter().map(|name| font::width(name, SMALL)).fold(0.0, f64::max) + 34.0;
    let title = "Correlations";
    let (width, top) = ((beside + count * cell + 2.0 * MARGIN).max(420.0), 74.0);
    let mut sheet = Sheet::new(width, top + count * cell + MARGIN, title.to_owned());
    let whole = Area { left: MARGIN, top: MARGIN, right: width - MARGIN, bottom: top };
    let colour = |r: f64| if r > 0.0 { Colour::AXES[0] } else { Colour::AXES[1] };
    let key = |r: f64| Pen::solid(colour(r), 9.0).faint(0.8);
    let keys = [Key::dot(key(1.0), "positive"), Key::dot(key(-1.0), "negative"), Key::words("in hundredths")];
    heading(&mut sheet, whole, title, "", &keys);
    let left = MARGIN + beside;
    for (i, name) in names.iter().enumerate() {
        let base = top + (i as f64 + 0.5) * cell + 0.36 * SMALL;
        sheet.text([left - 8.0, base], Anchor::End, Colour::TEXT, &format!("{name}  {}", i + 1));
        sheet.text(
            [left + (i as f64 + 0.5) * cell, top - 5.0],
            Anchor::Middle,
            Colour::FAINT,
            &format!("{}", i + 1),
        );
        for (j, r) in all.rows.get(i).into_iter().flatten().enumerate() {
            let (x, y) = (left + j as f64 * cell, top + i as f64 * cell);
            let corners = vec![[x, y], [x + cell, y], [x + cell, y + cell], [x, y + cell]];
            match r {
                Some(r) => {
                    let fill = if i == j { Colour::GRID } else { colour(*r) };
                    let opacity = if i == j { 1.0 } else { 0.85 * r.abs().min(1.0) };
                    // An invisible cell gets no colour: the colour would be that of a rounding
                    // error.
                    if opacity >= 1e-3 {
                        sheet.marks.push(Mark::Polygon { corners: corners.clone(), fill, opacity });
                    }
                    if i != j && r.abs() >= 0.05 && cell > 18.0 {
                        let text = format!("{:.0}", 100.0 * r).replace('-', "−");
                        let ink = if r.abs() > 0.6 { Colour(0xff_ff_ff) } else { Colour::TEXT };
                        let text = Text::small([x + 0.5 * cell, base], Anchor::Middle, ink, &text);
                        sheet.marks.push(Mark::Text(text));
                    }
                }
                None => sheet.text([x + 0.5 * cell, base], Anchor::Middle, Colour::FAINT, "·"),
            }
            let frame = corners.iter().chain(&corners[..1]).copied().collect();
            sheet.line(frame, Pen::solid(Colour::GRID, 0.6));
        }
    }
    sheet
}
