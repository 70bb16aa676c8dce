//! Pictures of the estimate.

use polhode_document::Section;
use polhode_document::drawing::{Correlations, Drawing, Triangle};
use serde_json::{Value, json};

use crate::{Estimate, PrincipalEstimate};

/// Probabilities of the regions of moments: those of one and two standard deviations of a single
/// number.
const PROBABILITIES: [f64; 2] = [0.68, 0.95];

/// Returns the body on the triangle of moments, if its ratios are determined.
pub(crate) fn triangle(p: &PrincipalEstimate) -> Option<Triangle> {
    if p.ratio_sd.iter().any(Option::is_none) {
        return None;
    }
    let region = |probability: f64| Some((probability, p.ratio_region(probability)?));
    let regions = PROBABILITIES.into_iter().filter_map(region).collect();
    let sd = p.ratio_sd.map(Option::unwrap_or_default);
    Some(Triangle { ratios: p.ratios, sd: Some(sd), regions, cloud: Vec::new() })
}

pub(crate) fn draw_triangle(section: &mut Section, p: &PrincipalEstimate) {
    if let Some(triangle) = triangle(p) {
        section.draw(Drawing::Triangle(triangle));
    }
}

/// Returns the triangle with the body and its confidence ellipse as JSON.
pub(crate) fn triangle_to_json(p: &PrincipalEstimate) -> Value {
    triangle(p).map_or(Value::Null, |triangle| triangle.to_json())
}

/// Returns the correlations of the numbers, except exact ones.
fn correlations(estimate: &Estimate) -> Correlations {
    let is_exact = |k: &usize| estimate.numbers[*k].sd == Some(0.0);
    let shown: Vec<usize> = (0..estimate.numbers.len()).filter(|k| !is_exact(k)).collect();
    Correlations {
        names: shown.iter().map(|&k| estimate.numbers[k].name.clone()).collect(),
        rows: shown.iter().map(|&i| shown.iter().map(|&j| estimate.correlation(i, j)).collect()).collect(),
    }
}

pub(crate) fn draw_correlations(section: &mut Section, estimate: &Estimate) {
    let correlations = correlations(estimate);
    if correlations.names.len() > 1 {
        section.draw(Drawing::Correlations(correlations));
    }
}

/// Returns the correlation matrix row by row, in order of the numbers; null where a number has no
/// error.
pub(crate) fn correlations_to_json(estimate: &Estimate) -> Value {
    let n = estimate.numbers.len();
    let row = |i: usize| (0..n).map(|j| estimate.correlation(i, j)).collect::<Vec<_>>();
    json!((0..n).map(row).collect::<Vec<_>>())
}
