//! Curves against time.

use polhode::body::Symmetry;
use polhode::math::{Direction, Principal, Vector};
use polhode::motion::{Pointing, Reference, Sample, Scenario};

use super::axes::{Area, Axes, Axis, Key};
use super::figure::Figure;
use super::panel::{Panel, Series, range};
use super::plotted::PlottedMotion;
use super::sheet::{Colour, Pen, Point, Sheet};

/// Writes the heading of a figure with its keys; gives the area below.
pub(super) type Heading<'a> = &'a dyn Fn(&mut Sheet, &[Key]) -> Area;

/// Draws ω, an energy, L or a torque.
pub(super) fn draw(
    motion: &PlottedMotion<'_>,
    figure: Figure,
    sheet: &mut Sheet,
    width: f64,
    heading: Heading<'_>,
) {
    let panel = panel(motion, figure);
    let area = panel.fitted(heading(sheet, &panel.keys(width)));
    let (x, scale) = time_axis(motion.samples(), area.width());
    let axes = Axes::within(area, x, panel.axis(area.height()), None);
    panel.draw(motion, sheet, &axes, scale);
}

/// The curves of ω, an energy, L or a torque.
pub(super) fn panel(motion: &PlottedMotion<'_>, figure: Figure) -> Panel {
    match figure {
        Figure::Energy => Panel::new(motion, "energy", "J", energy(motion), 0.0),
        Figure::Momentum => Panel::new(motion, "L", "kg·m²/s", momentum(motion), parts_of_momentum(motion)),
        Figure::Torque => Panel::new(motion, "N", "N·m", torque(motion), 0.0),
        Figure::Pointing => Panel::new(motion, "angle", "deg", angles(motion), 180.0).naming_events(),
        _ => Panel::new(motion, "ω", "rad/s", omega(motion), 0.0).naming_events(),
    }
}

/// The angles that a plan asks for; on an orbit without any those of x, −y and z to velocity, normal and nadir.
pub(crate) fn pointings(scenario: &Scenario) -> Vec<Pointing> {
    let Some(orbit) = scenario.orbit().filter(|_| scenario.pointings().is_empty()) else {
        return scenario.pointings().to_vec();
    };
    let usual = [
        ("z to nadir", [0.0, 0.0, 1.0], Reference::Nadir(orbit.clone())),
        ("x to velocity", [1.0, 0.0, 0.0], Reference::Velocity(orbit.clone())),
        ("−y to the orbit's normal", [0.0, -1.0, 0.0], Reference::OrbitNormal(orbit.clone())),
    ];
    usual
        .into_iter()
        .flat_map(|(name, body, to)| Pointing::new(name, Direction::from_array(body), to))
        .collect()
}

fn angles(motion: &PlottedMotion<'_>) -> Vec<Series> {
    let one = |(k, pointing): (usize, &Pointing)| {
        let of = |sample: &Sample| pointing.angle(&sample.state).to_degrees();
        one(motion, Pen::axis(k % 3), pointing.name(), of)
    };
    motion.pointings.iter().enumerate().map(one).collect()
}

/// The axis of time, and the length of its unit, s.
pub(super) fn time_axis(samples: &[Sample], width: f64) -> (Axis, f64) {
    let times = range(samples.iter().map(|s| s.state.time));
    let largest = times.into_iter().map(f64::abs).fold(0.0, f64::max);
    let (unit, scale) = unit_of_time(largest);
    (Axis::linear(times.map(|t| t / scale), 0.0, (width / 76.0).clamp(3.0, 10.0), "t", unit), scale)
}

/// The unit in which a time is read, and its length, s.
pub(super) fn unit_of_time(largest: f64) -> (&'static str, f64) {
    match largest {
        t if t > 3.0 * 86_400.0 => ("d", 86_400.0),
        t if t > 3.0 * 3_600.0 => ("h", 3_600.0),
        _ => ("s", 1.0),
    }
}

fn omega(motion: &PlottedMotion<'_>) -> Vec<Series> {
    along_principal(motion, |s| s.state.omega, "ω")
}

fn momentum(motion: &PlottedMotion<'_>) -> Vec<Series> {
    let mut series = if motion.driven.at_all() {
        components(motion, ["x", "y", "z"].map(|axis| format!("along {axis}")), |s| s.momentum.to_array())
    } else {
        along_principal(motion, |s| s.state.attitude.inverse() * s.momentum, "L")
    };
    series.push(one(motion, Pen::solid(Colour::BLACK, 1.0), "|L|", |s| s.momentum.norm()));
    series
}

/// What L is made of, which may add up to nothing: that of the carrier, at least 2 T/|ω|, and those of the wheels.
fn parts_of_momentum(motion: &PlottedMotion<'_>) -> f64 {
    let parts = |s: &Sample| {
        let rate = s.state.omega.norm();
        let carrier = if rate > 0.0 { 2.0 * s.kinetic_energy / rate } else { 0.0 };
        motion.wheels.iter().map(|(_, wheel)| wheel.momentum_at(s.state.time).abs()).fold(carrier, f64::max)
    };
    motion.samples().iter().map(parts).fold(0.0, f64::max)
}

fn torque(motion: &PlottedMotion<'_>) -> Vec<Series> {
    components(motion, ["x", "y", "z"].map(|axis| format!("along {axis}")), |s| s.torque.to_array())
}

fn energy(motion: &PlottedMotion<'_>) -> Vec<Series> {
    let kinetic = |pen| one(motion, pen, "T", |s| s.kinetic_energy);
    let thin = Pen::solid(Colour::BLACK, 1.0);
    if !motion.driven.at_all() {
        let moments = motion.principal.moments();
        let into = motion.principal.rotation().inverse();
        // ½ iₖ ωₖ²
        let part = |s: &Sample| {
            let [w1, w2, w3] = (into * s.state.omega).to_array();
            let [i1, i2, i3] = moments;
            [0.5 * i1 * w1 * w1, 0.5 * i2 * w2 * w2, 0.5 * i3 * w3 * w3]
        };
        let mut series = components(motion, ["½i₁ω₁²", "½i₂ω₂²", "½i₃ω₃²"].map(str::to_owned), part);
        series.push(kinetic(thin));
        return series;
    }
    let bold = |k: usize| Pen::axis(k);
    if motion.samples().iter().all(|s| s.potential_energy.is_some()) {
        let potential = |s: &Sample| s.potential_energy.unwrap_or_default();
        return vec![
            kinetic(bold(1)),
            one(motion, bold(0), "U", potential),
            one(motion, thin, "T + U", move |s| s.kinetic_energy + potential(s)),
        ];
    }
    let work = if motion.driven.by_torques { "work" } else { "work of the motors" };
    vec![kinetic(bold(1)), one(motion, bold(0), work, |s| s.work)]
}

fn one(motion: &PlottedMotion<'_>, pen: Pen, name: &str, value: impl Fn(&Sample) -> f64) -> Series {
    let values = motion.samples().iter().map(value).collect();
    Series { pen, long: name.to_owned(), short: name.to_owned(), values }
}

fn components(
    motion: &PlottedMotion<'_>,
    names: [String; 3],
    value: impl Fn(&Sample) -> [f64; 3],
) -> Vec<Series> {
    let mut series: Vec<Series> = names
        .into_iter()
        .enumerate()
        .map(|(k, name)| Series { pen: Pen::axis(k), short: name.clone(), long: name, values: Vec::new() })
        .collect();
    for sample in motion.samples() {
        for (series, value) in series.iter_mut().zip(value(sample)) {
            series.values.push(value);
        }
    }
    series
}

fn along_principal<Q>(
    motion: &PlottedMotion<'_>,
    vector: impl Fn(&Sample) -> Vector<Q, polhode::math::Body>,
    letter: &str,
) -> Vec<Series> {
    let into = motion.principal.rotation().inverse();
    let which = match motion.principal.symmetry() {
        Symmetry::Asymmetric => [" least", " intermediate", " greatest moment"],
        Symmetry::Oblate => ["", "", " symmetry axis"],
        Symmetry::Prolate | Symmetry::Rod => [" symmetry axis", "", ""],
        _ => ["", "", ""],
    };
    let names = ["₁", "₂", "₃"].map(|index| format!("{letter}{index}"));
    let value = |s: &Sample| {
        let v: Vector<Q, Principal> = into * vector(s);
        v.to_array()
    };
    let mut series = components(motion, names, value);
    for (series, which) in series.iter_mut().zip(which) {
        series.long.push_str(which);
    }
    series
}

/// The places of a curve's points, broken where it is.
pub(super) fn pieces(axes: &Axes, points: &[Vec<Point>], pen: Pen, sheet: &mut Sheet) {
    sheet.lines(points.iter().map(|piece| piece.iter().map(|&p| axes.at(p)).collect()), pen);
}
