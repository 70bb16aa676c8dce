//! The wheels inside a body: their momenta above, below the speeds of those that a motor turns.

use crate::layout::printable;
use polhode::motion::{Sample, Wheel};

use super::axes::{Area, Axes};
use super::panel::{Panel, Series};
use super::plotted::PlottedMotion;
use super::series::{Heading, time_axis};
use super::sheet::{Pen, Sheet};

pub(super) fn draw(motion: &PlottedMotion<'_>, sheet: &mut Sheet, width: f64, heading: Heading<'_>) {
    let momenta = series(motion, "h momentum", |wheel, s| Some(wheel.momentum_at(s.state.time)));
    let speeds =
        series(motion, "Ω speed in the body", |wheel, s| wheel.speed_at(s.state.time, s.state.omega));
    let momenta = Panel::new(motion, "h", "kg·m²/s", momenta, 0.0);
    if speeds.is_empty() {
        let area = heading(sheet, &momenta.keys(width));
        let (x, scale) = time_axis(motion.samples(), area.width());
        momenta.draw(motion, sheet, &Axes::within(area, x, momenta.axis(area.height()), None), scale);
        return;
    }
    let speeds = Panel::new(motion, "Ω", "rad/s", speeds, 0.0);
    let mut keys = momenta.keys(width);
    keys.extend(speeds.keys(width));
    let area = heading(sheet, &keys);
    let (x, scale) = time_axis(motion.samples(), area.width());
    let middle = area.top + 0.45 * area.height();
    let (upper, lower) = (Area { bottom: middle, ..area }, Area { top: middle + 4.0, ..area });
    let [above, below] = [(&momenta, upper), (&speeds, lower)].map(|(panel, area)| panel.axis(area.height()));
    let left = Some(Axes::beside(&above).max(Axes::beside(&below)));
    momenta.draw(motion, sheet, &Axes::within(upper, x.clone().bare(), above, left), scale);
    speeds.draw(motion, sheet, &Axes::within(lower, x, below, left), scale);
}

/// A curve for each wheel that has the value.
fn series(
    motion: &PlottedMotion<'_>,
    what: &str,
    value: impl Fn(&Wheel, &Sample) -> Option<f64>,
) -> Vec<Series> {
    let one = |(k, (name, wheel)): (usize, &(String, Wheel))| {
        let values: Option<Vec<f64>> = motion.samples().iter().map(|sample| value(wheel, sample)).collect();
        let is_plain = name == "wheel";
        let name = if is_plain { what.to_owned() } else { format!("{what}, {}", printable(name)) };
        Some(Series { pen: Pen::axis(k % 3), short: name.clone(), long: name, values: values? })
    };
    motion.wheels.iter().enumerate().filter_map(one).collect()
}
