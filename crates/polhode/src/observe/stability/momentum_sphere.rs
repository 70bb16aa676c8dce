//! Extrema of a gyrostat's energy on the sphere of constant |L|.
//!
//! I⁻¹ (L − h) = ν L, so that ω = ν L and L_k = h_k / (1 − ν i_k). The remaining equation for ν is
//!
//! g(ν) = Σ h_k² / (1 − ν i_k)² = |L|²
//!
//! g has a double pole at each 1/i_k and is convex between them: it has one root below all poles,
//! one above, and none or two between neighbours. Every root is computed as its distance from a
//! pole, by bisection of the logarithm, so that a wheel with very small momentum costs no digits.
//! If h_k = 0, the pole at 1/i_k vanishes, and L_k is free there.

use crate::math::frame::Principal;
use crate::math::vector::AngularVelocity;

/// A moment, or several equal moments, with h along their axes.
#[derive(Clone, Copy, Debug)]
struct Pole {
    moment: f64,
    /// Wheel momentum √Σ h_k², kg·m²/s.
    wheels: f64,
}

/// Relative tolerance within which moments are equal, as for principal axes.
const EQUAL: f64 = 4.0 * f64::EPSILON;

/// Returns ω of all extrema, principal axes, rad/s.
pub(super) fn extrema(moments: [f64; 3], h: [f64; 3], momentum: f64) -> Vec<AngularVelocity<Principal>> {
    let size = h.iter().fold(0.0, |max: f64, x| max.max(x.abs()));
    // Removes components of h that are only rounding of the rotation to principal axes.
    let h = h.map(|x| if x.abs() <= EQUAL * size { 0.0 } else { x });
    if momentum == 0.0 {
        // L = 0: the body rotates opposite to its wheels, if it has any.
        let spins = [0, 1, 2].map(|k| -h[k] / moments[k]);
        return if size > 0.0 { vec![AngularVelocity::from_array(spins)] } else { Vec::new() };
    }
    let moments = merged(moments);
    let mut found = Vec::new();
    for k in 0..3 {
        found.extend(along_free_axis(moments, h, momentum, k).into_iter().flatten());
    }
    let poles = poles(moments, h);
    for (pole, distance) in roots(&poles, momentum) {
        let nu = 1.0 / pole + distance;
        found
            .push([0, 1, 2].map(|k| {
                if h[k] == 0.0 { 0.0 } else { nu * h[k] / denominator(pole, distance, moments[k]) }
            }));
    }
    found.into_iter().map(AngularVelocity::from_array).collect()
}

/// Returns the moments, with those that count as equal made identical.
fn merged([i1, i2, i3]: [f64; 3]) -> [f64; 3] {
    let i2 = if i2 - i1 <= EQUAL * i3 { i1 } else { i2 };
    [i1, i2, if i3 - i2 <= EQUAL * i3 { i2 } else { i3 }]
}

/// Returns the poles of g, in ascending order of ν.
fn poles(moments: [f64; 3], h: [f64; 3]) -> Vec<Pole> {
    let mut poles: Vec<Pole> = Vec::new();
    for k in (0..3).rev().filter(|&k| h[k] != 0.0) {
        match poles.last_mut() {
            Some(pole) if pole.moment == moments[k] => pole.wheels = libm::hypot(pole.wheels, h[k]),
            _ => poles.push(Pole { moment: moments[k], wheels: h[k].abs() }),
        }
    }
    poles
}

/// Returns the extrema for ν = 1/i_k, if no wheel has a component along axis k or along an axis of
/// equal moment: L_k = ±√(|L|² − Σ L_j²) with j ≠ k.
fn along_free_axis(moments: [f64; 3], h: [f64; 3], momentum: f64, k: usize) -> [Option<[f64; 3]>; 2] {
    let i = moments[k];
    if (0..3).any(|j| moments[j] == i && h[j] != 0.0) {
        return [None; 2];
    }
    let l = [0, 1, 2].map(|j| if h[j] == 0.0 { 0.0 } else { h[j] * i / (i - moments[j]) });
    let rest = l.iter().fold(0.0, |sum, &l| libm::hypot(sum, l));
    if !(rest < momentum) {
        return [None; 2];
    }
    let free = ((momentum - rest) * (momentum + rest)).sqrt();
    [free, -free].map(|free| {
        let mut l = l;
        l[k] = free;
        Some(l.map(|l| l / i))
    })
}

/// Returns 1 − ν i for ν = 1/`pole` + `distance`, without cancellation.
fn denominator(pole: f64, distance: f64, i: f64) -> f64 {
    (pole - i) / pole - distance * i
}

/// Returns the roots of g = |L|², each as the moment of a pole and the distance of ν from it.
fn roots(poles: &[Pole], momentum: f64) -> Vec<(f64, f64)> {
    let (Some(first), Some(last)) = (poles.first(), poles.last()) else { return Vec::new() };
    let root = |pole: f64, furthest: f64| (pole, bisect(poles, pole, furthest, momentum));
    let far = 1e150;
    let mut found = vec![root(first.moment, -far / first.moment), root(last.moment, far / last.moment)];
    for pair in poles.windows(2) {
        let [left, right] = [pair[0].moment, pair[1].moment];
        let width = (left - right) / left / right;
        let least = least(poles, left, width);
        if size(poles, left, least) < momentum {
            found.extend([root(left, least), root(right, least - width)]);
        }
    }
    found
}

/// Returns √g.
fn size(poles: &[Pole], pole: f64, distance: f64) -> f64 {
    poles.iter().fold(0.0, |sum, p| libm::hypot(sum, p.wheels / denominator(pole, distance, p.moment)))
}

/// Returns the distance at which g is smallest between a pole and the next one, `width` above it;
/// g′ increases from −∞ to ∞.
fn least(poles: &[Pole], pole: f64, width: f64) -> f64 {
    let slope = |distance: f64| {
        let term = |p: &Pole| {
            let d = denominator(pole, distance, p.moment);
            (p.wheels / d) * (p.wheels / d) * (p.moment / d)
        };
        poles.iter().map(term).sum::<f64>()
    };
    let (mut low, mut high) = (0.0, width);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if slope(middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Returns the distance from a pole at which √g equals |L|; √g decreases monotonically up to
/// `furthest`, whose sign is the side.
fn bisect(poles: &[Pole], pole: f64, furthest: f64, momentum: f64) -> f64 {
    let (mut near, mut far) = (1e-150 / pole, furthest.abs());
    for _ in 0..200 {
        let middle = near.sqrt() * far.sqrt();
        if size(poles, pole, middle.copysign(furthest)) > momentum { near = middle } else { far = middle }
    }
    far.copysign(furthest)
}
