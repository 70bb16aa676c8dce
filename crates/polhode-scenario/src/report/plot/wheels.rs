//! Wheels of a body: angular momenta, and speeds of the driven ones.

use polhode::motion::{Sample, Wheel};
use polhode_document::figure::sheet::Pen;
use polhode_document::layout::printable;

use super::chart::Quantity;
use super::curve::Curve;
use super::plotted::PlottedMotion;

pub(crate) fn quantities(motion: &PlottedMotion<'_>) -> Vec<Quantity> {
    let momenta = curves(motion, ["h", "momentum"], |wheel, s| Some(wheel.momentum_at(s.state.time)));
    let speeds =
        curves(motion, ["Ω", "speed in the body"], |wheel, s| wheel.speed_at(s.state.time, s.state.omega));
    let mut quantities = vec![Quantity::new("h", "kg·m²/s", momenta)];
    if !speeds.is_empty() {
        quantities.push(Quantity::new("Ω", "rad/s", speeds));
    }
    quantities
}

/// Returns a curve for each wheel that has this value.
fn curves(
    motion: &PlottedMotion<'_>,
    [letter, what]: [&str; 2],
    value: impl Fn(&Wheel, &Sample) -> Option<f64>,
) -> Vec<Curve> {
    let one = |(k, (name, wheel)): (usize, &(String, Wheel))| {
        let point = |sample: &Sample| Some([sample.state.time, value(wheel, sample)?]);
        let points: Option<Vec<_>> = motion.samples().iter().map(point).collect();
        let (name, symbol) = match name.as_str() {
            "wheel" => (format!("{letter} {what}"), letter.to_owned()),
            name => {
                (format!("{letter} {what}, {}", printable(name)), format!("{letter} {}", printable(name)))
            }
        };
        Some(Curve { pen: Pen::axis(k % 3), name, symbol, pieces: vec![points?] })
    };
    motion.wheels.iter().enumerate().filter_map(one).collect()
}
