//! Curves against time.

use polhode::{Principal, Sample, Symmetry, Vector};

use super::axes::{Area, Axes, Axis, Key};
use super::figure::Figure;
use super::font;
use super::motion::MotionFigures;
use super::sheet::{Colour, Pen, Point, SMALL, Sheet};

/// Writes the heading of a figure with its keys; gives the area below.
pub(super) type Heading<'a> = &'a dyn Fn(&mut Sheet, &[Key]) -> Area;

/// A curve, and what it is called: at length, and where there is no room for that.
pub(super) struct Series {
    pub(super) pen: Pen,
    pub(super) long: String,
    pub(super) short: String,
    /// One for each sample.
    pub(super) values: Vec<f64>,
}

/// Draws ω, an energy, L or a torque.
pub(super) fn draw(
    motion: &MotionFigures<'_>,
    figure: Figure,
    sheet: &mut Sheet,
    width: f64,
    heading: Heading<'_>,
) {
    let (name, unit, series) = match figure {
        Figure::Energy => ("energy", "J", energy(motion)),
        Figure::Momentum => ("L", "kg·m²/s", momentum(motion)),
        Figure::Torque => ("N", "N·m", torque(motion)),
        _ => ("ω", "rad/s", omega(motion)),
    };
    let keys = keys(&series, width);
    let area = heading(sheet, &keys);
    let (x, scale) = time_axis(motion.samples(), area.width());
    let values = series.iter().flat_map(|series| series.values.iter().copied());
    let axes = Axes::within(area, x, axis(values, area.height(), name, unit), None);
    axes.draw(sheet);
    for series in &series {
        let points = motion.samples().iter().zip(&series.values);
        sheet.line(points.map(|(s, &value)| axes.at([s.state.time / scale, value])).collect(), series.pen);
    }
}

/// The long names if they fit into one line.
fn keys(series: &[Series], width: f64) -> Vec<Key> {
    let needed: f64 = series.iter().map(|series| font::width(&series.long, SMALL) + 50.0).sum();
    let name = |series: &Series| if needed < width { series.long.clone() } else { series.short.clone() };
    series.iter().map(|series| Key::line(series.pen, name(series))).collect()
}

/// An axis for values, with a mark every 40 px or so.
pub(super) fn axis(values: impl Iterator<Item = f64>, height: f64, name: &str, unit: &str) -> Axis {
    Axis::linear(range(values), 0.06, (height / 44.0).clamp(2.0, 8.0), name, unit)
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

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let finite = values.filter(|x| x.is_finite());
    let [least, greatest] =
        finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| [least.min(x), most.max(x)]);
    if least <= greatest { [least, greatest] } else { [0.0, 0.0] }
}

fn omega(motion: &MotionFigures<'_>) -> Vec<Series> {
    along_principal(motion, |s| s.state.omega, "ω")
}

fn momentum(motion: &MotionFigures<'_>) -> Vec<Series> {
    let mut series = if motion.driven {
        components(motion, ["x", "y", "z"].map(|axis| format!("along {axis}")), |s| s.momentum.to_array())
    } else {
        along_principal(motion, |s| s.state.attitude.inverse() * s.momentum, "L")
    };
    series.push(one(motion, Pen::solid(Colour::BLACK, 1.0), "|L|", |s| s.momentum.norm()));
    series
}

fn torque(motion: &MotionFigures<'_>) -> Vec<Series> {
    components(motion, ["x", "y", "z"].map(|axis| format!("along {axis}")), |s| s.torque.to_array())
}

fn energy(motion: &MotionFigures<'_>) -> Vec<Series> {
    let kinetic = |pen| one(motion, pen, "T", |s| s.kinetic_energy);
    let thin = Pen::solid(Colour::BLACK, 1.0);
    if !motion.driven {
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
    vec![kinetic(bold(1)), one(motion, bold(0), "work of the torque", |s| s.work)]
}

fn one(motion: &MotionFigures<'_>, pen: Pen, name: &str, value: impl Fn(&Sample) -> f64) -> Series {
    let values = motion.samples().iter().map(value).collect();
    Series { pen, long: name.to_owned(), short: name.to_owned(), values }
}

fn components(
    motion: &MotionFigures<'_>,
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
    motion: &MotionFigures<'_>,
    vector: impl Fn(&Sample) -> Vector<Q, polhode::Body>,
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
