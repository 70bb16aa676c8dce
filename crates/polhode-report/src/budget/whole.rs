//! Mass, centre and tensor of the whole.

use polhode::math::{Frame, Rotation};
use polhode_budget::{Basis, Estimate, EstimateAbout, NUMBERS};
use polhode_document::Section;
use polhode_document::drawing::{Correlations, Drawing};
use polhode_document::number::{number, tidy, with_error};

use super::case::{Case, ten};
use super::{BudgetOptions, basis_name};

/// Where lengths are read in mm, m.
const SHORT: f64 = 10.0;

pub(super) fn section(case: &Case, options: &BudgetOptions) -> Section {
    let mut section = Section::new(2, "Mass properties of the whole");
    let estimate = case.estimate(options.basis);
    if case.grows() {
        section.say(format!("Of {} masses.", basis_name(options.basis)));
    }
    section.say("The tensor is about the centre of mass, along the axes of the body; Ixy = −∫ x y dm. After ± is the standard deviation.");
    let values = ten(&estimate.properties);
    numbers(&mut section, &values, &estimate.covariance);
    if let Some(about) = asked(estimate, options) {
        section.say(asked_in_words(options));
        let matrix = about.inertia;
        let [xx, yy, zz, xy, xz, yz] = matrix;
        let [mass, x, y, z] = about.place;
        numbers(&mut section, &[mass, x, y, z, xx, yy, zz, xy, xz, yz], &about.covariance);
    }
    correlations(&mut section, &estimate.covariance);
    section
}

/// `Centre of mass (1.2 ± 0.3, −0.4 ± 0.3, 102.1 ± 0.8) mm`
pub(super) fn center_in_words(case: &Case, basis: Basis) -> String {
    let estimate = case.estimate(basis);
    let (unit, scale) = length(estimate);
    let center = tidy(estimate.properties.center_of_mass().to_array());
    let each = [0, 1, 2].map(|k| with_error(scale * center[k], scale * estimate.sd(k + 1)));
    format!("Centre of mass ({}) {unit}", each.join(", "))
}

/// The unit of the centre, and how many of it are one m.
pub(super) fn length<F: Frame>(estimate: &Estimate<F>) -> (&'static str, f64) {
    if estimate.properties.center_of_mass().max_abs() < SHORT { ("mm", 1e3) } else { ("m", 1.0) }
}

/// What is wanted about another point or along other axes.
pub(super) struct Asked {
    /// Mass and centre of mass, along the axes, from the body's origin.
    pub(super) place: [f64; 4],
    /// xx, yy, zz, xy, xz, yz
    pub(super) inertia: [f64; 6],
    pub(super) covariance: [[f64; 10]; 10],
}

pub(super) fn asked(estimate: &Estimate<polhode::math::Body>, options: &BudgetOptions) -> Option<Asked> {
    if options.about.is_none() && options.along.is_none() {
        return None;
    }
    let into_axes = options.along.map_or_else(Rotation::identity, Rotation::inverse);
    let turned = estimate.along(into_axes);
    let [x, y, z] = turned.properties.center_of_mass().to_array();
    let place = [turned.properties.mass(), x, y, z];
    let (matrix, covariance) = match options.about {
        Some(point) => {
            let EstimateAbout { inertia, covariance } = turned.about(into_axes * point);
            (inertia.matrix(), covariance)
        }
        None => (turned.properties.inertia().matrix(), turned.covariance),
    };
    let [[xx, xy, xz], [_, yy, yz], [.., zz]] = matrix;
    Some(Asked { place, inertia: [xx, yy, zz, xy, xz, yz], covariance })
}

fn asked_in_words(options: &BudgetOptions) -> String {
    let point = options.about.map_or_else(
        || "the centre of mass".to_owned(),
        |point| {
            let [x, y, z] = point.to_array().map(|x| number(x, 6));
            format!("the point ({x}, {y}, {z}) m")
        },
    );
    let axes = match options.along {
        Some(_) => "along the axes that were asked for, from the same origin",
        None => "along the axes of the body",
    };
    format!("About {point}, {axes}:")
}

fn numbers(section: &mut Section, values: &[f64; 10], covariance: &[[f64; 10]; 10]) {
    let center = tidy([values[1], values[2], values[3]]);
    let short = center.iter().all(|x| x.abs() < SHORT);
    let row = |k: usize| {
        let (name, unit) = NUMBERS[k];
        let (unit, scale) = if unit == "m" && short { ("mm", 1e3) } else { (unit, 1.0) };
        let value = if (1..4).contains(&k) { center[k - 1] } else { values[k] };
        let sd = covariance[k][k].max(0.0).sqrt();
        vec![name.to_owned(), with_error(scale * value, scale * sd), unit.to_owned()]
    };
    section.table(&["number", "value ± sd", "unit"], (0..10).map(row).collect());
}

/// Of numbers that have an error.
pub(super) fn correlation(covariance: &[[f64; 10]; 10], i: usize, j: usize) -> Option<f64> {
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
