//! Curves of ω, energy, L, torque and angles.

use polhode::body::Symmetry;
use polhode::math::{Direction, Principal, Vector};
use polhode::motion::channel::ENERGY;
use polhode::motion::{Energy, Pointing, Reference, Sample, Scenario, Series};
use polhode_document::figure::sheet::{Colour, Pen, Point};

use super::chart::Quantity;
use super::curve::Curve;
use super::figure::Figure;
use super::plotted::PlottedMotion;

/// Returns the curves of one of these quantities.
pub(crate) fn quantity(motion: &PlottedMotion<'_>, figure: Figure) -> Quantity {
    match figure {
        Figure::Energy => Quantity::new("energy", "J", energy(motion)),
        Figure::Momentum => {
            Quantity::new("L", "kg·m²/s", momentum(motion)).made_of(parts_of_momentum(motion))
        }
        Figure::Torque => Quantity::new("N", "N·m", torque(motion)),
        Figure::Pointing => Quantity::new("angle", "deg", angles(motion)).made_of(180.0),
        _ => Quantity::new("ω", "rad/s", omega(motion)),
    }
}

/// Returns the pointing angles of a scenario.
///
/// The default on an orbit is z to nadir, x to velocity, and −y to the orbit normal.
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

fn angles(motion: &PlottedMotion<'_>) -> Vec<Curve> {
    let one = |(k, pointing): (usize, &Pointing)| {
        let of = |sample: &Sample| pointing.angle(&sample.state).to_degrees();
        one(motion, Pen::axis(k % 3), pointing.name(), of)
    };
    motion.pointings.iter().enumerate().map(one).collect()
}

fn omega(motion: &PlottedMotion<'_>) -> Vec<Curve> {
    along_principal(motion, |s| s.state.omega, "ω")
}

fn momentum(motion: &PlottedMotion<'_>) -> Vec<Curve> {
    let mut curves = if motion.driven.at_all() {
        components(motion, along_xyz("L"), |s| s.momentum.to_array())
    } else {
        along_principal(motion, |s| s.state.attitude.inverse() * s.momentum, "L")
    };
    curves.push(one(motion, Pen::solid(Colour::BLACK, 1.0), "|L|", |s| s.momentum.norm()));
    curves
}

/// Returns the size of the terms of L, which may cancel.
///
/// These are the momentum of the carrier, at least 2 T/|ω|, and that of each wheel.
fn parts_of_momentum(motion: &PlottedMotion<'_>) -> f64 {
    let parts = |s: &Sample| {
        let rate = s.state.omega.norm();
        let carrier = if rate > 0.0 { 2.0 * s.kinetic_energy / rate } else { 0.0 };
        motion.wheels.iter().map(|(_, wheel)| wheel.momentum_at(s.state.time).abs()).fold(carrier, f64::max)
    };
    motion.samples().iter().map(parts).fold(0.0, f64::max)
}

fn torque(motion: &PlottedMotion<'_>) -> Vec<Curve> {
    components(motion, along_xyz("N"), |s| s.torque.to_array())
}

fn energy(motion: &PlottedMotion<'_>) -> Vec<Curve> {
    let kinetic = |pen| one(motion, pen, "T", |s| s.kinetic_energy);
    let thin = Pen::solid(Colour::BLACK, 1.0);
    if !motion.driven.at_all() {
        let moments = motion.principal.moments();
        let into = motion.principal.rotation().inverse();
        // The energy along axis k is ½ iₖ ωₖ².
        let part = |s: &Sample| {
            let [w1, w2, w3] = (into * s.state.omega).to_array();
            let [i1, i2, i3] = moments;
            [0.5 * i1 * w1 * w1, 0.5 * i2 * w2 * w2, 0.5 * i3 * w3 * w3]
        };
        let mut curves =
            components(motion, ["½i₁ω₁²", "½i₂ω₂²", "½i₃ω₃²"].map(|name| [name; 2].map(str::to_owned)), part);
        curves.push(kinetic(thin));
        return curves;
    }
    let bold = |k: usize| Pen::axis(k);
    let energies: Vec<Energy> =
        motion.trajectory.channel(ENERGY).into_iter().flat_map(Series::iter).collect();
    let has_potential = energies.iter().all(|energy| energy.potential.is_some_and(f64::is_finite));
    if has_potential {
        let of = |pen, name: &str, value: fn(&Energy) -> f64| {
            let points = motion.samples().iter().zip(&energies).map(|(s, e)| [s.state.time, value(e)]);
            Curve { pen, name: name.to_owned(), symbol: name.to_owned(), pieces: vec![points.collect()] }
        };
        return vec![
            of(bold(1), "T", |e| e.kinetic),
            of(bold(0), "U", |e| e.potential.unwrap_or_default()),
            of(thin, "T + U", |e| e.kinetic + e.potential.unwrap_or_default()),
        ];
    }
    vec![kinetic(bold(1)), one(motion, bold(0), motion.driven.work(), |s| s.work)]
}

fn one(motion: &PlottedMotion<'_>, pen: Pen, name: &str, value: impl Fn(&Sample) -> f64) -> Curve {
    let points = motion.samples().iter().map(|s| [s.state.time, value(s)]).collect();
    Curve { pen, name: name.to_owned(), symbol: name.to_owned(), pieces: vec![points] }
}

/// Returns the curves of three components, each with its name and symbol.
fn components(
    motion: &PlottedMotion<'_>,
    names: [[String; 2]; 3],
    value: impl Fn(&Sample) -> [f64; 3],
) -> Vec<Curve> {
    let mut pieces: [Vec<Point>; 3] = Default::default();
    for sample in motion.samples() {
        for (piece, value) in pieces.iter_mut().zip(value(sample)) {
            piece.push([sample.state.time, value]);
        }
    }
    let curves = names.into_iter().zip(pieces).enumerate();
    curves
        .map(|(k, ([name, symbol], points))| Curve { pen: Pen::axis(k), name, symbol, pieces: vec![points] })
        .collect()
}

/// Returns the names and symbols of the components along x, y and z.
fn along_xyz(letter: &str) -> [[String; 2]; 3] {
    ["x", "y", "z"].map(|axis| format!("{letter}{axis}")).map(|name| [name.clone(), name])
}

fn along_principal<Q>(
    motion: &PlottedMotion<'_>,
    vector: impl Fn(&Sample) -> Vector<Q, polhode::math::Body>,
    letter: &str,
) -> Vec<Curve> {
    let into = motion.principal.rotation().inverse();
    let which = match motion.principal.symmetry() {
        Symmetry::Asymmetric => [" least", " intermediate", " greatest moment"],
        Symmetry::Oblate => ["", "", " symmetry axis"],
        Symmetry::Prolate | Symmetry::Rod => [" symmetry axis", "", ""],
        _ => ["", "", ""],
    };
    let names = ["₁", "₂", "₃"].map(|index| format!("{letter}{index}")).map(|name| [name.clone(), name]);
    let value = |s: &Sample| {
        let v: Vector<Q, Principal> = into * vector(s);
        v.to_array()
    };
    let mut curves = components(motion, names, value);
    for (curve, which) in curves.iter_mut().zip(which) {
        curve.name.push_str(which);
    }
    curves
}
