//! Herpolhode: the path of ω in the invariable plane.

use polhode::motion::{FreeMotion, Regime};
use polhode::observe::{CurveError, Herpolhode};
use polhode_document::figure::axes::{Axes, Axis};
use polhode_document::figure::legend::Key;
use polhode_document::figure::prefix;
use polhode_document::figure::sheet::{Colour, Pen, Point, Sheet};

use super::chart::Heading;
use super::time::unit_of_time;

/// Largest number of drawn periods of ω, for legibility.
const MOST_PERIODS: f64 = 12.0;
/// Largest number of drawn revolutions about L.
const MOST_TURNS: f64 = 60.0;

/// Draws the herpolhode over `duration`, s.
pub(crate) fn draw(
    motion: &FreeMotion,
    duration: f64,
    sheet: &mut Sheet,
    heading: Heading<'_>,
) -> Result<(), CurveError> {
    let periods = motion.period().map_or(1.0, |period| {
        let turns = (motion.precession_rate() * period).abs() / std::f64::consts::TAU;
        let asked = if duration > 0.0 { duration / period } else { 3.0 };
        asked.min(MOST_PERIODS).min(MOST_TURNS / turns)
    });
    let herpolhode = Herpolhode::of(motion, periods, 5e-4)?;
    let [least, greatest] = herpolhode.annulus;
    let path = Pen::solid(Colour::AXES[0], 1.3);
    let between = Pen::solid(Colour::FAINT, 1.0).dashed(&[4.0, 3.0]);
    let (unit, scale) = unit_of_time(periods * motion.period().unwrap_or_default());
    let name = match motion.regime() {
        Regime::Separatrix => "ω, from L and back to it".to_owned(),
        _ => format!("ω, {}", prefix::value(periods * motion.period().unwrap_or_default() / scale, 3, unit)),
    };
    let start = Pen::solid(Colour::BLACK, 5.0);
    let tip = Pen::solid(Colour::AXES[1], 5.0);
    let keys = [
        Key::line(path, name),
        Key::dot(start, "its start"),
        Key::dot(tip, "L"),
        Key::line(between, "least and largest distance"),
    ];
    let area = heading(sheet, &keys);
    let side = area.width().min(area.height());
    let ends = [-greatest, greatest];
    let axis = || Axis::linear(ends, 0.07, (side / 56.0).clamp(3.0, 8.0), "ω across L", "rad/s");
    let axes = Axes::square(area, axis(), axis());
    axes.draw(sheet);
    let center = axes.at([0.0, 0.0]);
    for radius in [least, greatest] {
        sheet.circle(center, axes.at([radius, 0.0])[0] - center[0], between);
    }
    let points: Vec<Point> = herpolhode.in_plane().into_iter().map(|p| axes.at(p)).collect();
    let first = points.first().copied();
    sheet.line(points, path);
    sheet.dots(vec![center], tip);
    sheet.dots(first.into_iter().collect(), start);
    Ok(())
}
