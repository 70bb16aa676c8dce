//! Section of the report on principal moments and axes.

use polhode::body::{Symmetry, ratio_region};
use polhode::math::Body;
use polhode_document::Section;
use polhode_document::drawing::{Drawing, Triangle};
use polhode_document::number::{number, with_error};

use super::case::{AXES, AxisTilt, Case};
use crate::PrincipalUncertainty;
use crate::read::Questions;

/// Probabilities of the regions of moments. They are those of one and two standard deviations of
/// one number.
const PROBABILITIES: [f64; 2] = [0.68, 0.95];
/// Rounding error of terms that cancel, relative to the terms.
const ROUNDING: f64 = 1e-14;
/// Number of dots of the cloud.
const DOTS: usize = 800;
/// Rotation of the axes from which on first order is not valid, rad.
const FAR: f64 = 0.3;

pub(crate) fn section(case: &Case, options: &Questions) -> Section {
    let mut section = Section::new(3, "Principal moments and axes");
    let principal = case.principal(options.basis);
    let row = |k: usize| vec![format!("i{}", k + 1), moment(case, &principal, k), "kg·m²".to_owned()];
    section.table(&["moment", "value ± sd", "unit"], (0..3).map(row).collect());
    let symmetry = principal.frame.symmetry();
    if symmetry != Symmetry::Asymmetric {
        section.say(format!("Symmetry: {}.", symmetry.freedom()));
    }
    if symmetry == Symmetry::Point {
        return section;
    }
    let ratios = Ratios::of(&principal);
    for k in 0..2 {
        let ratio = if principal.is_first_order(k) && principal.is_first_order(2) {
            with_error(ratios.values[k], ratios.sd[k])
        } else {
            format!("{}, {UNKNOWN}", number(ratios.values[k], 6))
        };
        section.line(format!("i{}/i3 = {ratio}", k + 1));
    }
    let quantiles = case.drawn.as_ref().map(|drawn| drawn.tilts);
    let row = |k: usize| {
        if let Some(words) = freedom(symmetry, k) {
            let mut cells = vec![format!("axis {}", k + 1), words.to_owned()];
            cells.resize(if quantiles.is_some() { 7 } else { 6 }, String::new());
            return cells;
        }
        let [x, y, z] = principal.frame.axis(k).to_array().map(|x| format!("{x:.5}"));
        let AxisTilt { from, tilt, .. } = &case.tilts[k];
        let mut cells = vec![format!("axis {}", k + 1), x, y, z, AXES[*from].to_owned()];
        cells.push(match tilt.sd.filter(|sd| *sd < FAR) {
            Some(sd) => with_error(tilt.angle.to_degrees(), sd.to_degrees()),
            None => number(tilt.angle.to_degrees(), 3),
        });
        if let Some(all) = quantiles {
            cells.push(all[k].map_or_else(String::new, |all| {
                let [low, middle, high] = all.map(|angle| number(angle.to_degrees(), 3));
                format!("{low}, {middle}, {high}")
            }));
        }
        cells
    };
    let mut headers = vec!["axis of", "x", "y", "z", "near", "tilt (deg)"];
    if quantiles.is_some() {
        headers.push("5, 50, 95 % of draws");
    }
    section.table(&headers, (0..3).map(row).collect());
    if options.axes.is_some() {
        section.say(
            "Tilts are measured from the requested axes; x, y and z are components along the body axes.",
        );
    }
    section.draw(Drawing::Triangle(triangle(case, &principal)));
    section
}

/// Returns words such as `Principal moments a ± b; c ± d; e ± f kg·m²`.
pub(crate) fn in_words(case: &Case, principal: &PrincipalUncertainty<Body>) -> String {
    let each = [0, 1, 2].map(|k| moment(case, principal, k));
    format!("Principal moments {} kg·m²", each.join("; "))
}

/// Returns a message with the axes that are undetermined within their errors.
pub(crate) fn not_known(principal: &PrincipalUncertainty<Body>) -> Option<String> {
    let k = (0..3).find(|&k| principal.turn_sd[k] > FAR)?;
    let [i, j] = [(k + 1) % 3, (k + 2) % 3].map(|k| k + 1);
    let [i, j] = [i.min(j), i.max(j)];
    Some(format!(
        "axes {i} and {j} are undetermined: i{i} and i{j} are equal within their errors, so any rotation about axis {} is possible",
        k + 1
    ))
}

/// Words for the error of a moment that has none to first order, without draws.
const UNKNOWN: &str = "no first-order error";

/// Returns words such as `1.234 ± 0.012`. The error is that of the draws if two moments are equal
/// within their errors.
pub(crate) fn moment(case: &Case, principal: &PrincipalUncertainty<Body>, k: usize) -> String {
    let value = principal.frame.moments()[k];
    match (moment_sd(principal, k), &case.drawn) {
        (Some(sd), _) => with_error(value, sd),
        (None, Some(drawn)) => format!("{} by draws", with_error(value, drawn.comparison.numbers[10 + k].sd)),
        (None, None) => format!("{}, {UNKNOWN}", number(value, 6)),
    }
}

/// Returns the standard deviation to first order, if first order is valid.
pub(crate) fn moment_sd(principal: &PrincipalUncertainty<Body>, k: usize) -> Option<f64> {
    principal.is_first_order(k).then(|| principal.moment_covariance[k][k].max(0.0).sqrt())
}

/// Returns words for the possible directions of an axis that symmetry does not determine.
pub(crate) const fn freedom(symmetry: Symmetry, k: usize) -> Option<&'static str> {
    match (symmetry, k) {
        (Symmetry::Point | Symmetry::Spherical, _) => Some("any direction"),
        (Symmetry::Rod | Symmetry::Prolate, 1 | 2) => Some("any direction perpendicular to axis 1"),
        (Symmetry::Oblate, 0 | 1) => Some("any direction perpendicular to axis 3"),
        _ => None,
    }
}

/// Ratios i1/i3 and i2/i3, with their errors.
pub(crate) struct Ratios {
    pub values: [f64; 2],
    pub sd: [f64; 2],
    pub correlation: f64,
}

impl Ratios {
    /// Computes the ratios. They are 0 for a body without extent.
    pub(crate) fn of(principal: &PrincipalUncertainty<Body>) -> Self {
        let [i1, i2, i3] = principal.frame.moments();
        if i3 == 0.0 {
            return Self { values: [0.0; 2], sd: [0.0; 2], correlation: 0.0 };
        }
        let values = [i1 / i3, i2 / i3];
        // δ(iₖ/i3) = (δiₖ − iₖ/i3 δi3)/i3
        let c = &principal.moment_covariance;
        let covariance = |a: usize, b: usize| {
            let terms =
                [c[a][b], -values[a] * c[2][b], -values[b] * c[a][2], values[a] * values[b] * c[2][2]];
            let sum: f64 = terms.iter().sum();
            let size: f64 = terms.iter().map(|term| term.abs()).sum();
            if sum.abs() > ROUNDING * size { sum / (i3 * i3) } else { 0.0 }
        };
        let sd = [0, 1].map(|k| covariance(k, k).max(0.0).sqrt());
        let size = sd[0] * sd[1];
        let correlation = if size > 0.0 { covariance(0, 1) / size } else { 0.0 };
        Self { values, sd, correlation }
    }
}

/// Returns the body in the triangle of moments, with the draws around it.
pub(crate) fn triangle(case: &Case, principal: &PrincipalUncertainty<Body>) -> Triangle {
    let Ratios { values, sd, correlation } = Ratios::of(principal);
    let region = |p: f64| Some((p, ratio_region(values, sd, correlation, p)?));
    let bodies = case.drawn.as_ref().map_or(&[][..], |drawn| &drawn.draws.bodies);
    let ratios = |body: &polhode::body::MassProperties<Body>| {
        let [i1, i2, i3] = body.principal().moments();
        [i1 / i3, i2 / i3]
    };
    let is_first_order = (0..3).all(|k| principal.is_first_order(k));
    let varies = !is_first_order || sd.iter().any(|sd| *sd > 0.0);
    Triangle {
        ratios: values,
        sd: is_first_order.then_some(sd),
        regions: PROBABILITIES.into_iter().filter(|_| is_first_order).filter_map(region).collect(),
        cloud: bodies.iter().filter(|_| varies).take(DOTS).map(ratios).collect(),
    }
}
