//! How far a computed motion departs from its balances, sample by sample.
//!
//! The same departures as [`polhode::Drift`], which has the largest of each. A sample's departure is rounding noise in a
//! closed form and a staircase in an integration: dots show either, and a line the largest so far.

use polhode::Sample;

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

/// The balances that this motion keeps.
pub(super) fn departures(motion: &MotionFigures<'_>) -> Vec<Departure> {
    let (first, samples) = (motion.trajectory.start(), motion.samples());
    let largest = |f: &dyn Fn(&Sample) -> f64| samples.iter().chain([first]).map(f).fold(0.0, f64::max);
    let (t0, l0) = (first.kinetic_energy, first.momentum);
    let largest_t = largest(&|s| s.kinetic_energy);
    let largest_l = largest(&|s| s.momentum.norm());
    let relative = |name: &'static str, whole: f64, part: &dyn Fn(&Sample) -> f64| Departure {
        name,
        values: samples.iter().map(|s| if whole > 0.0 { part(s) / whole } else { 0.0 }).collect(),
    };
    if !motion.driven {
        return vec![
            relative("T", largest_t, &|s| (s.kinetic_energy - t0).abs()),
            relative("|L|", largest_l, &|s| (s.momentum.norm() - l0.norm()).abs()),
            relative("L in space", largest_l, &|s| (s.momentum - l0).norm()),
        ];
    }
    let mut all = vec![
        // T(t) − T(0) = W,  L(t) − L(0) = J
        relative("T − work", largest_t, &|s| (s.kinetic_energy - t0 - (s.work - first.work)).abs()),
        relative("L − impulse", largest_l, &|s| (s.momentum - l0 - (s.impulse - first.impulse)).norm()),
    ];
    if let Some(u0) = first.potential_energy {
        let rise = |s: &Sample| s.potential_energy.unwrap_or(u0) - u0;
        let whole = largest_t.max(largest(&|s| rise(s).abs()));
        all.push(relative("T + U", whole, &|s| (s.kinetic_energy - t0 + rise(s)).abs()));
    }
    all
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
