//! Section of the report on the mass properties of the whole.

use polhode::math::{Body, Frame, Rotation};
use polhode_document::Section;
use polhode_document::drawing::{Correlations, Drawing};
use polhode_document::number::{number, tidy, with_error};

use super::case::Case;
use super::numbers::{shown, ten, tidied};
use crate::read::Questions;
use crate::tensor::elements;
use crate::{Basis, Estimate, EstimateAbout, NUMBERS};

/// Extent below which lengths are shown in mm, m.
const SHORT: f64 = 10.0;

pub(crate) fn section(case: &Case, options: &Questions) -> Section {
    let mut section = Section::new(2, "Mass properties");
    let estimate = case.estimate(options.basis);
    if case.grows() {
        section.say(format!("Based on {} masses.", options.basis.name()));
    }
    section.say("Inertia tensor about the centre of mass, in body axes, with Ixy = −∫ x y dm; ± is one standard deviation.");
    let values = ten(&estimate.properties);
    numbers(&mut section, &values, &estimate.covariance);
    if let Some(about) = asked(estimate, options) {
        section.say(asked_in_words(options));
        numbers(&mut section, &about.numbers, &about.covariance);
    }
    correlations(&mut section, &estimate.covariance);
    section
}

/// Returns words such as `Centre of mass (1.2 ± 0.3, −0.4 ± 0.3, 102.1 ± 0.8) mm`.
pub(crate) fn center_in_words(case: &Case, basis: Basis) -> String {
    let estimate = case.estimate(basis);
    let (unit, scale) = unit_of_length(estimate);
    let center = tidy(estimate.properties.center_of_mass().to_array());
    let each = [0, 1, 2].map(|k| with_error(scale * center[k], scale * estimate.sd(k + 1)));
    format!("Centre of mass ({}) {unit}", each.join(", "))
}

/// Returns the unit in which the centre of mass is shown, and the factor from m to that unit.
pub(crate) fn unit_of_length<F: Frame>(estimate: &Estimate<F>) -> (&'static str, f64) {
    if estimate.properties.center_of_mass().max_abs() < SHORT { ("mm", 1e3) } else { ("m", 1.0) }
}

/// Mass properties about the requested point or along the requested axes.
pub(crate) struct Asked {
    /// Ten numbers along the axes, with the centre of mass from the body's origin.
    pub numbers: [f64; 10],
    pub covariance: [[f64; 10]; 10],
}

pub(crate) fn asked(estimate: &Estimate<Body>, options: &Questions) -> Option<Asked> {
    if options.about.is_none() && options.axes.is_none() {
        return None;
    }
    let into_axes = options.axes.map_or_else(Rotation::identity, Rotation::inverse);
    let turned = estimate.along(into_axes);
    let mut numbers = ten(&turned.properties);
    let Some(point) = options.about else { return Some(Asked { numbers, covariance: turned.covariance }) };
    let EstimateAbout { inertia, covariance } = turned.about_point(into_axes * point);
    numbers[4..].copy_from_slice(&elements(inertia.matrix()));
    Some(Asked { numbers, covariance })
}

fn asked_in_words(options: &Questions) -> String {
    let point = options.about.map_or_else(
        || "the centre of mass".to_owned(),
        |point| {
            let [x, y, z] = point.to_array().map(|x| number(x, 6));
            format!("the point ({x}, {y}, {z}) m")
        },
    );
    let axes = match options.axes {
        Some(_) => "along the requested axes, from the same origin",
        None => "along the axes of the body",
    };
    format!("About {point}, {axes}:")
}

fn numbers(section: &mut Section, values: &[f64; 10], covariance: &[[f64; 10]; 10]) {
    let values = tidied(*values);
    let length = if values[1..4].iter().all(|x| x.abs() < SHORT) { ("mm", 1e3) } else { ("m", 1.0) };
    let row = |k: usize| {
        let (name, unit, scale) = shown(k, length);
        let sd = covariance[k][k].max(0.0).sqrt();
        vec![name.to_owned(), with_error(scale * values[k], scale * sd), unit.to_owned()]
    };
    section.table(&["quantity", "value ± sd", "unit"], (0..10).map(row).collect());
}

/// Returns the correlation of two numbers, if both have an error.
pub(crate) fn correlation(covariance: &[[f64; 10]; 10], i: usize, j: usize) -> Option<f64> {
    let size = (covariance[i][i] * covariance[j][j]).sqrt();
    (size > 0.0).then(|| covariance[i][j] / size)
}

fn correlations(section: &mut Section, covariance: &[[f64; 10]; 10]) {
    let shown: Vec<usize> = (0..10).filter(|&k| covariance[k][k] > 0.0).collect();
    if shown.len() < 2 {
        return;
    }
    section.draw(Drawing::Correlations(Correlations {
        names: shown.iter().map(|&k| NUMBERS[k].0.to_owned()).collect(),
        rows: shown.iter().map(|&i| shown.iter().map(|&j| correlation(covariance, i, j)).collect()).collect(),
    }));
}
