//! Path of a top's axis in space: cusps, loops or waves.
//!
//! The left picture shows the path on the unit sphere, seen slightly from above. The right picture
//! shows the inclination θ from the vertical over the azimuth φ.
//!
//! Close to the vertical φ is ill-defined. The right picture is then a view from above, with θ as
//! the radius.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use polhode::math::{Body, Direction, Position, Space};
use polhode::motion::torque::TorqueModel;
use polhode::motion::{Rotor, Sample, Scenario};
use polhode_document::figure::axes::{Area, Axes, Axis};
use polhode_document::figure::legend::Key;
use polhode_document::figure::range::range;
use polhode_document::figure::sheet::{Anchor, Colour, Mark, Pen, Point, Sheet};
use polhode_document::figure::ticks::Ticks;
use polhode_document::number::number;

use super::chart::Heading;
use super::error::PlotError;
use super::figure::Figure;
use super::plotted::PlottedMotion;
use super::sphere::{FAR, TRACE, arrow};
use super::view::View;

const BOUND: Pen = Pen::solid(Colour::AXES[0], 1.1).dashed(&[4.0, 3.0]);
const START: Pen = Pen::solid(Colour::AXES[1], 6.0);

/// Smallest inclination for the diagram of θ over φ, rad; closer to the vertical a view from above
/// is drawn.
const UPRIGHT: f64 = 0.09;

/// Largest number of periods of θ in the diagram of θ over φ; more would be too narrow.
const MOST_TURNS: usize = 6;

/// Threshold for the range of θ, rad; a smaller range is rounding.
const NOTHING: f64 = 1e-9;

/// Largest distance between consecutive points of the path, rad.
const FINE: f64 = 0.03;

/// Axis of a body that gravity turns about a pivot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TopAxis {
    /// Direction from the pivot to the centre of mass.
    pub axis: Direction<Body>,
    /// Upward vertical, opposite to gravity.
    pub up: Direction<Space>,
    /// Two horizontal directions, orthogonal to each other.
    pub across: [Direction<Space>; 2],
    /// Least and greatest θ of a symmetric top, rad.
    pub bounds: Option<[f64; 2]>,
}

impl TopAxis {
    /// Returns the axis; `None` for a free body, without gravity, or with the centre of mass at the
    /// pivot.
    pub(crate) fn of(scenario: &Scenario, rotor: &Rotor) -> Option<Self> {
        let gravity = scenario.torques().iter().find_map(|torque| match torque {
            TorqueModel::Gravity(gravity) => Some(gravity.acceleration),
            _ => None,
        })?;
        let axis = rotor.lever().direction().filter(|_| rotor.is_pivoted())?;
        let up = -gravity.direction()?;
        // φ = 0 is toward x if gravity is along z.
        let [x, y] = [Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0)];
        let beside = if up.x.abs() < 0.9 { x } else { y };
        let first = (beside - up * up.dot(beside)).direction()?;
        let bounds =
            crate::report::facts::heavy_top_of(scenario, scenario.start()).map(|top| top.nutation_bounds());
        Some(Self { axis, up, across: [first, up.cross(first)], bounds })
    }

    /// Returns the direction of the axis in a sample, and its rate of change ω × e.
    fn at(&self, s: &Sample) -> (Direction<Space>, Direction<Space>) {
        let e = s.state.attitude * self.axis;
        let tip = Position::from_array(e.to_array());
        (e, Direction::from_array(s.state.omega_space().cross(tip).to_array()))
    }

    /// Returns the path, with intermediate points between samples that are far apart.
    ///
    /// These are on the cubic through both samples with their rates of change.
    ///
    /// # Errors
    /// [`PlotError::TooCoarse`] if it moves too far from a sample to the next.
    fn path(&self, samples: &[Sample]) -> Result<Vec<Direction<Space>>, PlotError> {
        let mut path: Vec<Direction<Space>> = samples.first().map(|s| self.at(s).0).into_iter().collect();
        for pair in samples.windows(2) {
            let [a, b] = pair else { continue };
            let ((e0, v0), (e1, v1)) = (self.at(a), self.at(b));
            let h = b.state.time - a.state.time;
            let turn = h * v0.norm().max(v1.norm());
            if !(turn <= FRAC_PI_2) {
                return Err(PlotError::TooCoarse { figure: Figure::Axis, turn });
            }
            let parts = (turn / FINE).ceil().max(1.0) as u32;
            path.extend((1..=parts).filter_map(|k| {
                let s = f64::from(k) / f64::from(parts);
                let u = 1.0 - s;
                let between = e0 * (u * u * (1.0 + 2.0 * s)) + e1 * (s * s * (3.0 - 2.0 * s));
                (between + (v0 * u - v1 * s) * (h * s * u)).direction()
            }));
        }
        Ok(path)
    }

    /// Returns the inclination θ from the vertical, rad.
    fn tilt(&self, e: Direction<Space>) -> f64 {
        e.angle_to(self.up)
    }

    /// Returns the azimuth φ about the vertical, rad, from −π to π.
    fn azimuth(&self, e: Direction<Space>) -> f64 {
        let [x, y] = self.across.map(|axis| axis.dot(e));
        y.atan2(x)
    }

    fn direction(&self, tilt: f64, azimuth: f64) -> Direction<Space> {
        let ([sin, cos], (sin_tilt, cos_tilt)) = ([azimuth.sin(), azimuth.cos()], tilt.sin_cos());
        let [x, y] = self.across;
        (x * cos + y * sin) * sin_tilt + self.up * cos_tilt
    }
}

pub(crate) fn draw(
    motion: &PlottedMotion<'_>,
    top: &TopAxis,
    sheet: &mut Sheet,
    heading: Heading<'_>,
) -> Result<(), PlotError> {
    let path = top.path(motion.samples())?;
    let [least, most] = top.bounds.unwrap_or_else(|| range(path.iter().map(|e| top.tilt(*e))));
    let degrees = |angle: f64| number(angle.to_degrees(), 5);
    let bounds = match most - least > NOTHING {
        true => format!("θ from {}° to {}°", degrees(least), degrees(most)),
        false => format!("θ = {}°", degrees(least)),
    };
    let keys = [Key::line(TRACE, "the axis"), Key::dot(START, "its start"), Key::line(BOUND, bounds)];
    let area = heading(sheet, &keys);
    let middle = area.left + 0.46 * area.width();
    sphere(top, &path, [least, most], sheet, Area { right: middle - 8.0, ..area });
    let beside = Area { left: middle + 8.0, ..area };
    if least > UPRIGHT && most < PI - UPRIGHT {
        unrolled(top, &path, [least, most], sheet, beside);
    } else {
        from_above(top, &path, [least, most], sheet, beside);
    }
    Ok(())
}

/// Draws the sphere with the path; the far side is faint.
fn sphere(top: &TopAxis, path: &[Direction<Space>], bounds: [f64; 2], sheet: &mut Sheet, area: Area) {
    /// Length of the vertical line beyond the sphere, in radii.
    const REACH: f64 = 1.22;
    let [least, most] = bounds;
    let hangs = least + most > PI;
    // A path close to the vertical is viewed from higher up.
    let height = if most < 0.35 || least > PI - 0.35 { 0.9_f64 } else { 0.4 };
    let height = if hangs { -height } else { height };
    let sum = path.iter().fold(Direction::ZERO, |sum, e| sum + *e);
    let level = sum - top.up * sum.dot(top.up);
    // A path around the vertical is viewed from its start, any other path from its own side.
    let toward = if level.norm() > 0.2 * path.len() as f64 { Some(level) } else { path.first().copied() };
    let azimuth = toward.map_or(0.0, |e| top.azimuth(e));
    let viewer = top.direction(FRAC_PI_2 - height, azimuth);
    let radius = (area.height() / (1.0 + REACH) - 2.0).min(0.5 * area.width());
    let center =
        [0.5 * (area.left + area.right), area.bottom - radius - if hangs { 0.22 * radius } else { 2.0 }];
    let radius = if hangs { radius * 0.9 } else { radius };
    let view = View::new(center, radius, viewer, top.up);
    sheet.marks.push(Mark::Ball { center, radius });
    let circle =
        |tilt: f64| (0..=180).map(|k| top.direction(tilt, f64::from(k) / 180.0 * TAU)).collect::<Vec<_>>();
    let end = if hangs { -top.up } else { top.up };
    let equator = Pen::solid(Colour::FRAME, 1.0).dashed(&[2.0, 2.5]);
    let mut curves = vec![(equator, circle(FRAC_PI_2))];
    curves.extend(bounds.map(|tilt| (BOUND, circle(tilt))));
    curves.push((TRACE, path.to_vec()));
    for near in [false, true] {
        for (pen, curve) in &curves {
            let pen = if near { *pen } else { pen.faint(FAR) };
            sheet.lines(view.side(near, curve), pen);
        }
        if near {
            sheet.line(vec![view.at(end), view.at(end * REACH)], Pen::solid(Colour::TEXT, 2.0));
        }
    }
    if let [.., a, b] = path {
        arrow(view.at(*a), view.at(*b), sheet);
    }
    sheet.dots(path.first().map(|e| view.at(*e)).into_iter().collect(), START);
}

/// Draws θ over φ, with small θ at the top, up to [`MOST_TURNS`] periods of θ.
fn unrolled(top: &TopAxis, path: &[Direction<Space>], bounds: [f64; 2], sheet: &mut Sheet, area: Area) {
    let mut points: Vec<Point> = Vec::new();
    let (mut turns, mut rises) = (0, None);
    for e in path {
        let raw = top.azimuth(*e).to_degrees();
        let last = points.last().copied();
        let next = last.map_or(raw, |[phi, _]| raw + 360.0 * ((phi - raw) / 360.0).round());
        let tilt = top.tilt(*e).to_degrees();
        let now = last.map(|[_, before]| tilt > before);
        turns += usize::from(rises.is_some() && now != rises);
        rises = now;
        if turns > 2 * MOST_TURNS && bounds[1] - bounds[0] > NOTHING {
            break;
        }
        points.push([next, tilt]);
    }
    let across =
        Axis::linear(range(points.iter().map(|p| p[0])), 0.03, (area.width() / 64.0).max(2.0), "φ", "deg");
    let tilts = bounds.map(f64::to_degrees);
    let up = Axis::linear(tilts, 0.08, (area.height() / 44.0).clamp(2.0, 8.0), "θ from the vertical", "deg")
        .downward();
    let axes = Axes::within(area, across, up, None);
    axes.draw(sheet);
    for tilt in tilts {
        let y = axes.at([0.0, tilt])[1];
        sheet.line(vec![[axes.area.left, y], [axes.area.right, y]], BOUND);
    }
    let start = points.first().map(|p| axes.at(*p));
    sheet.line(points.into_iter().map(|p| axes.at(p)).collect(), TRACE);
    sheet.dots(start.into_iter().collect(), START);
}

/// Draws the view from above, with θ as the radius and φ as the angle; for a hanging body, from
/// below.
fn from_above(top: &TopAxis, path: &[Direction<Space>], bounds: [f64; 2], sheet: &mut Sheet, area: Area) {
    const WORDS: f64 = 20.0;
    let [least, most] = bounds;
    let hangs = least + most > PI;
    let away = |tilt: f64| if hangs { PI - tilt } else { tilt };
    let farthest = away(least).max(away(most)).max(1e-6);
    let radius = 0.5 * area.width().min(area.height() - WORDS) - 4.0;
    let center = [0.5 * (area.left + area.right), area.top + radius + 4.0];
    let scale = radius / (1.04 * farthest).to_degrees();
    let at = |tilt: f64, azimuth: f64| {
        let (sin, cos) = if hangs { (-azimuth).sin_cos() } else { azimuth.sin_cos() };
        let r = scale * away(tilt).to_degrees();
        [center[0] + r * cos, center[1] - r * sin]
    };
    let ticks = Ticks::linear(0.0, 1.04 * farthest.to_degrees(), 4.0);
    let grid = Pen::solid(Colour::GRID, 0.8);
    for value in ticks.values.iter().filter(|value| **value > 0.0) {
        sheet.circle(center, scale * value, grid);
    }
    for (x, y) in [(radius, 0.0), (0.0, radius)] {
        sheet.line(vec![[center[0] - x, center[1] - y], [center[0] + x, center[1] + y]], grid);
    }
    for tilt in bounds.into_iter().filter(|tilt| away(*tilt) > NOTHING) {
        sheet.circle(center, scale * away(tilt).to_degrees(), BOUND);
    }
    let points: Vec<Point> = path.iter().map(|e| at(top.tilt(*e), top.azimuth(*e))).collect();
    let start = points.first().copied();
    sheet.line(points, TRACE);
    sheet.dots(start.into_iter().collect(), START);
    // Labels at the circles would overlap the path.
    let step = ticks.labels.get(1).map_or("", String::as_str);
    let (side, angle) = if hangs { ("below", "180° − θ") } else { ("above", "θ") };
    let words = format!("from {side}, a circle every {step}° of {angle}");
    sheet.text([center[0], center[1] + radius + WORDS], Anchor::Middle, Colour::BLACK, &words);
}
