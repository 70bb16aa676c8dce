//! How far a computed motion departs from its balances, sample by sample.
//!
//! They are those of [`Drift::along`]. A sample's departure is rounding noise in a
//! closed form and a staircase in an integration: dots show either, and a line the largest so far.

use polhode::{Drift, Solution};

use super::axes::{Axes, Axis, Key};
use super::motion::MotionFigures;
use super::series::{Heading, time_axis};
use super::sheet::{Colour, Pen, Point, Sheet};

/// What should be nothing, relative to its size, at each sample.
pub(super) struct Departure {
    pub(super) name: &'static str,
    pub(super) values: Vec<f64>,
}

pub(super) fn draw(motion: &MotionFigures<'_>, sheet: &mut Sheet, heading: Heading<'_>) {
    const PENS: [Colour; 3] = [Colour::AXES[1], Colour::AXES[0], Colour::AXES[2]];
    const DASHES: [&[f64]; 3] = [&[], &[7.0, 2.5], &[1.6, 2.4]];
    let pen = |k: usize| {
        let colour = PENS.get(k).copied().unwrap_or(Colour::BLACK);
        Pen::solid(colour, 1.7).dashed(DASHES.get(k).copied().unwrap_or(&[]))
    };
    let departures = departures(motion);
    let keys: Vec<Key> = departures.iter().enumerate().map(|(k, d)| Key::line(pen(k), d.name)).collect();
    let area = heading(sheet, &keys);
    let (x, scale) = time_axis(motion.samples(), area.width());
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

/// The balances that this motion keeps, and that say something of how it was computed.
pub(super) fn departures(motion: &MotionFigures<'_>) -> Vec<Departure> {
    let all = Drift::along(motion.trajectory).unwrap_or_default();
    let one = |name: &'static str, value: &dyn Fn(&Drift) -> f64| Departure {
        name,
        values: all.iter().map(value).collect(),
    };
    if !motion.driven {
        return vec![
            one("T", &|d| d.kinetic_energy),
            one("|L|", &|d| d.momentum_magnitude),
            one("L in space", &|d| d.momentum),
        ];
    }
    // Work and impulse of a closed form are what T and L have gained.
    let mut balances = if matches!(motion.trajectory.solution(), Solution::Exact(_)) {
        Vec::new()
    } else {
        let impulse = if motion.torqued { "L − impulse" } else { "L in space" };
        vec![one("T − work", &|d| d.work_energy), one(impulse, &|d| d.momentum)]
    };
    if all.iter().all(|d| d.total_energy.is_some()) {
        balances.push(one("T + U", &|d| d.total_energy.unwrap_or_default()));
    }
    balances
}

/// One dot where several would be one.
fn sparse(dots: Vec<Point>) -> Vec<Point> {
    const CELL: f64 = 1.8;
    let cell = |x: f64| (x / CELL).round() as i64;
    let mut seen = std::collections::BTreeSet::new();
    dots.into_iter()
        .filter(|[x, y]| x.is_finite() && y.is_finite() && seen.insert((cell(*x), cell(*y))))
        .collect()
}
