//! Where the ratios of moments are with a probability, among those of possible bodies.
//!
//! The triangle of moments: with the second moments gₖ = ½ (i1 + i2 + i3) − iₖ along the principal axes, which are not negative, a body is where the masses g1, g2, g3 in the
//! triangle's corners balance. Inside are bodies with extent in all directions, edges are laminae, corners are rods, the middle is a sphere.

use core::f64::consts::TAU;

use crate::principal::PrincipalEstimate;

/// The corners of the triangle of moments, its side 1: rods along the axes 1, 2, 3.
pub const TRIANGLE: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.866_025_403_784_438_6]];

/// Where moments are in the triangle.
pub fn on_triangle(moments: [f64; 3]) -> [f64; 2] {
    let sum: f64 = moments.iter().sum();
    let weights = moments.map(|moment| 1.0 - 2.0 * moment / sum);
    [0, 1].map(|c| (0..3).map(|k| weights[k] * TRIANGLE[k][c]).sum())
}

/// Points of the outline of an ellipse.
const POINTS: u32 = 240;
/// What a possible body keeps: a i1/i3 + b i2/i3 + c ≥ 0.
const POSSIBLE: [[f64; 3]; 3] = [[1.0, 1.0, -1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0]];

impl PrincipalEstimate {
    /// [`ratio_region`] of the ratios that were found; `None` where they are not known.
    pub fn ratio_region(&self, probability: f64) -> Option<Vec<[f64; 2]>> {
        let [Some(first), Some(second)] = self.ratio_sd else { return None };
        ratio_region(self.ratios, [first, second], self.ratio_correlation.unwrap_or(0.0), probability)
    }
}

/// The outline of where (i1/i3, i2/i3) are with a probability: the ellipse of their covariance, rᵀ C⁻¹ r = −2 ln(1 − p), cut off where no body is possible. The
/// moments are those along the axes that were found, in whatever order. `None` of exact ratios; a line if one combination of them is exact.
pub fn ratio_region(
    ratios: [f64; 2],
    [first, second]: [f64; 2],
    correlation: f64,
    probability: f64,
) -> Option<Vec<[f64; 2]>> {
    if !(first.max(second) > 0.0 && first.max(second).is_finite()) {
        return None;
    }
    let size = (-2.0 * libm::log1p(-probability)).sqrt();
    let r = correlation.clamp(-1.0, 1.0);
    let across = (1.0 - r * r).sqrt();
    let at = |k: u32| {
        let (sin, cos) = libm::sincos(TAU * f64::from(k) / f64::from(POINTS));
        let [x, y] = [size * first * cos, size * second * (r * cos + across * sin)];
        [ratios[0] + x, ratios[1] + y]
    };
    let outline = possible_ratios(&(0..POINTS).map(at).collect::<Vec<_>>());
    (!outline.is_empty()).then_some(outline)
}

/// The part of a convex outline of (i1/i3, i2/i3) in which bodies are possible.
pub fn possible_ratios(outline: &[[f64; 2]]) -> Vec<[f64; 2]> {
    POSSIBLE.iter().fold(outline.to_vec(), |outline, side| cut(&outline, *side))
}

/// The part of a convex outline where a x + b y + c ≥ 0.
fn cut(outline: &[[f64; 2]], [a, b, c]: [f64; 3]) -> Vec<[f64; 2]> {
    let height = |[x, y]: [f64; 2]| a * x + b * y + c;
    let mut kept = Vec::with_capacity(outline.len() + 2);
    for (k, &here) in outline.iter().enumerate() {
        let there = outline[(k + 1) % outline.len()];
        let (from, to) = (height(here), height(there));
        if from >= 0.0 {
            kept.push(here);
        }
        if (from < 0.0) != (to < 0.0) {
            let part = from / (from - to);
            kept.push([0, 1].map(|i| here[i] + part * (there[i] - here[i])));
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn principal(ratios: [f64; 2], sd: [f64; 2], r: f64) -> PrincipalEstimate {
        PrincipalEstimate {
            moments: [ratios[0], ratios[1], 1.0],
            moment_sd: [None; 3],
            moment_covariance: None,
            ratios,
            ratio_sd: sd.map(Some),
            ratio_correlation: Some(r),
            thickness: ratios[0] + ratios[1] - 1.0,
            thickness_sd: None,
            axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            turn_sd: [None; 3],
        }
    }

    #[test]
    fn rods_are_corners_and_laminae_edges() {
        let near =
            |a: [f64; 2], b: [f64; 2]| assert!((0..2).all(|k| (a[k] - b[k]).abs() < 1e-15), "{a:?} {b:?}");
        near(on_triangle([0.0, 2.0, 2.0]), TRIANGLE[0]);
        near(on_triangle([3.0, 0.0, 3.0]), TRIANGLE[1]);
        near(on_triangle([3.0, 3.0, 0.0]), TRIANGLE[2]);
        near(on_triangle([4.0, 4.0, 4.0]), [0.5, TRIANGLE[2][1] / 3.0]);
        // i1 + i2 = i3: a mass of g1 : g2 = 3 : 2 between the first two corners
        near(on_triangle([2.0, 3.0, 5.0]), [0.4, 0.0]);
    }

    #[test]
    fn the_outline_is_where_the_square_of_the_error_is_the_quantile() {
        let (sd, r) = ([0.01, 0.02], 0.6);
        let p = principal([0.6, 0.8], sd, r);
        for probability in [0.68, 0.95] {
            for point in p.ratio_region(probability).unwrap() {
                let [a, b] = [0, 1].map(|k| (point[k] - p.ratios[k]) / sd[k]);
                let square = (a * a - 2.0 * r * a * b + b * b) / (1.0 - r * r);
                // χ² of two degrees of freedom: 1 − exp(−½ x)
                assert!((1.0 - (-0.5 * square).exp() - probability).abs() < 1e-12, "{square}");
            }
        }
    }

    #[test]
    fn no_impossible_body_is_inside() {
        // a thin plate, and nearly a rod
        for (ratios, sd) in [([0.301, 0.702], [0.01, 0.02]), ([0.02, 0.985], [0.03, 0.03])] {
            let p = principal(ratios, sd, -0.2);
            let region = p.ratio_region(0.95).unwrap();
            assert!(region.len() > 20);
            let edge = region.iter().filter(|[a, b]| (a + b - 1.0).abs() < 1e-12).count();
            assert!(edge >= 2, "{region:?}");
            for [a, b] in region {
                assert!(a + b >= 1.0 - 1e-12 && a + 1.0 >= b - 1e-12 && b + 1.0 >= a - 1e-12);
                let [x, y] = on_triangle([a, b, 1.0]);
                assert!(y > -1e-12 && y <= 3.0_f64.sqrt() * x.min(1.0 - x) + 1e-12, "{x} {y}");
            }
        }
    }

    #[test]
    fn what_is_not_known_has_no_region() {
        let mut p = principal([0.6, 0.8], [0.01, 0.02], 0.0);
        p.ratio_sd[1] = None;
        assert_eq!(p.ratio_region(0.95), None);
        let exact = principal([0.0, 1.0], [0.0, 0.0], 0.0);
        assert_eq!(exact.ratio_region(0.95), None);
    }
}
