//! Pictures of what was found.

use polhode_document::Section;
use polhode_document::drawing::{Correlations, Drawing, Triangle};
use polhode_identify::{Estimate, PrincipalEstimate};
use serde_json::{Value, json};

/// Probabilities of the regions of moments: one and two standard deviations of one number.
const PROBABILITIES: [f64; 2] = [0.68, 0.95];

/// The body on the triangle of moments, if its ratios are known.
pub(super) fn triangle(p: &PrincipalEstimate) -> Option<Triangle> {
    if p.ratio_sd.iter().any(Option::is_none) {
        return None;
    }
    let region = |probability: f64| Some((probability, p.ratio_region(probability)?));
    let regions = PROBABILITIES.into_iter().filter_map(region).collect();
    Some(Triangle { ratios: p.ratios, regions, cloud: Vec::new() })
}

pub(super) fn draw_triangle(section: &mut Section, p: &PrincipalEstimate) {
    if let Some(triangle) = triangle(p) {
        section.draw(Drawing::Triangle(triangle));
    }
}

/// The ellipse by its covariance, and where it is on the triangle.
pub(super) fn triangle_to_json(p: &PrincipalEstimate) -> Value {
    triangle(p).map_or(Value::Null, |triangle| triangle.to_json())
}

/// Correlations of the numbers that have an error.
fn correlations(estimate: &Estimate) -> Correlations {
    let is_exact = |k: &usize| estimate.numbers[*k].sd == Some(0.0);
    let shown: Vec<usize> = (0..estimate.numbers.len()).filter(|k| !is_exact(k)).collect();
    Correlations {
        names: shown.iter().map(|&k| estimate.numbers[k].name.clone()).collect(),
        rows: shown.iter().map(|&i| shown.iter().map(|&j| estimate.correlation(i, j)).collect()).collect(),
    }
}

pub(super) fn draw_correlations(section: &mut Section, estimate: &Estimate) {
    let correlations = correlations(estimate);
    if correlations.names.len() > 1 {
        section.draw(Drawing::Correlations(correlations));
    }
}

/// Row by row, in the order of the numbers; null where a number has no error.
pub(super) fn correlations_to_json(estimate: &Estimate) -> Value {
    let n = estimate.numbers.len();
    let row = |i: usize| (0..n).map(|j| estimate.correlation(i, j)).collect::<Vec<_>>();
    json!((0..n).map(row).collect::<Vec<_>>())
}
