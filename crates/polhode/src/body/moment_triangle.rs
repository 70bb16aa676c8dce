//! Triangle of moments: all possible bodies, by the ratios of their principal moments.

use core::f64::consts::TAU;

/// Corners of the triangle of moments, with sides of length 1: rods along the axes 1, 2, 3.
pub const MOMENT_TRIANGLE: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.866_025_403_784_438_6]];

/// Number of points of an ellipse's outline.
const POINTS: u32 = 240;
/// Conditions for a possible body: a i₁/i₃ + b i₂/i₃ + c ≥ 0.
const POSSIBLE: [[f64; 3]; 3] = [[1.0, 1.0, -1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0]];

/// Returns the position of three principal moments in the triangle of moments.
///
/// The second moments along the principal axes are gₖ = ½ (i₁ + i₂ + i₃) − iₖ; none is negative.
/// The position is the centre of mass of masses g₁, g₂, g₃ at the corners. Bodies with extent in
/// all directions are inside, laminae on the edges, rods at the corners, a sphere at the centre.
///
/// ```
/// use polhode::body::place_in_moment_triangle;
/// let [x, y] = place_in_moment_triangle([2.0, 3.0, 5.0]); // a lamina: i₁ + i₂ = i₃
/// assert!((x - 0.4).abs() < 1e-15 && y.abs() < 1e-15);
/// ```
pub fn place_in_moment_triangle(moments: [f64; 3]) -> [f64; 2] {
    let sum: f64 = moments.iter().sum();
    let weights = moments.map(|moment| 1.0 - 2.0 * moment / sum);
    [0, 1].map(|c| (0..3).map(|k| weights[k] * MOMENT_TRIANGLE[k][c]).sum())
}

/// Returns the outline of the confidence region of (i₁/i₃, i₂/i₃) for a given probability p.
///
/// The region is the ellipse of the covariance C of the ratios, rᵀ C⁻¹ r = −2 ln(1 − p), without
/// the part in which no body is possible. The moments are in the order of their axes, which need
/// not be ascending. Returns `None` for exact ratios, and a line if one combination of them is
/// exact.
///
/// ```
/// use polhode::body::ratio_region;
/// let outline = ratio_region([0.6, 0.8], [0.01, 0.02], 0.6, 0.95).unwrap();
/// assert!(outline.iter().all(|[a, b]| (a - 0.6).abs() < 0.025 && (b - 0.8).abs() < 0.05));
/// ```
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

/// Returns the part of a convex outline of (i₁/i₃, i₂/i₃) in which bodies are possible.
pub fn possible_ratios(outline: &[[f64; 2]]) -> Vec<[f64; 2]> {
    POSSIBLE.iter().fold(outline.to_vec(), |outline, side| cut(&outline, *side))
}

/// Returns the part of a convex outline where a x + b y + c ≥ 0.
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
