//! Drift of conserved quantities, sample by sample.
//!
//! The drift is rounding noise in a closed form, and grows in steps in an integration. Dots show
//! each sample, and a line the maximum so far.

use polhode_document::figure::axes::{Axes, Axis};
use polhode_document::figure::legend::Key;
use polhode_document::figure::range::range;
use polhode_document::figure::sheet::{Colour, Pen, Point, Sheet};

use super::chart::Heading;
use super::plotted::PlottedMotion;
use super::time::time_axis;
use crate::report::balance::balances;

pub(crate) fn draw(motion: &PlottedMotion<'_>, sheet: &mut Sheet, heading: Heading<'_>) {
    const PENS: [Colour; 3] = [Colour::AXES[1], Colour::AXES[0], Colour::AXES[2]];
    const DASHES: [&[f64]; 3] = [&[], &[7.0, 2.5], &[1.6, 2.4]];
    let pen = |k: usize| {
        let colour = PENS.get(k).copied().unwrap_or(Colour::BLACK);
        Pen::solid(colour, 1.7).dashed(DASHES.get(k).copied().unwrap_or(&[]))
    };
    let departures = balances(motion.trajectory, motion.driven);
    let keys: Vec<Key> = departures.iter().enumerate().map(|(k, d)| Key::line(pen(k), d.name)).collect();
    let area = heading(sheet, &keys);
    let (x, scale) = time_axis(range(motion.samples().iter().map(|s| s.state.time)), area.width());
    let values =
        || departures.iter().flat_map(|d| d.values.iter().copied()).filter(|x| *x > 0.0 && x.is_finite());
    let (least, most) = values().fold((f64::INFINITY, 0.0), |(a, b), x| (f64::min(a, x), f64::max(b, x)));
    let [low, high] = if most > 0.0 {
        let high = most.log10().ceil().max(-17.0) as i32;
        [(least.log10().floor() as i32 - 1).clamp(-20, high - 2), high]
    } else {
        [-18, -15]
    };
    let axes = Axes::within(area, x, Axis::powers(low, high, 7, "relative departure"), None);
    axes.draw(sheet);
    let times = || motion.samples().iter().map(|s| s.state.time / scale);
    for (k, departure) in departures.iter().enumerate() {
        let dots = times().zip(&departure.values).map(|(t, &value)| axes.at([t, value])).collect();
        let Pen { colour, .. } = pen(k);
        sheet.dots(sparse(dots), Pen::solid(colour, 1.6).faint(0.3));
    }
    for (k, departure) in departures.iter().enumerate() {
        let mut largest = 0.0;
        let so_far = times().zip(&departure.values).map(|(t, &value)| {
            largest = f64::max(largest, value);
            [t, largest]
        });
        sheet.line(so_far.filter(|p| p[1] > 0.0).map(|p| axes.at(p)).collect(), pen(k));
    }
}

/// Returns the dots without those that overlap others.
fn sparse(dots: Vec<Point>) -> Vec<Point> {
    const CELL: f64 = 1.8;
    let cell = |x: f64| (x / CELL).round() as i64;
    let mut seen = std::collections::BTreeSet::new();
    dots.into_iter()
        .filter(|[x, y]| x.is_finite() && y.is_finite() && seen.insert((cell(*x), cell(*y))))
        .collect()
}
