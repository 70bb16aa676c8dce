//! What a change of the inertia tensor is worth, as a change of the start.

use super::functions::TimeFunctions;
use super::momentum::MomentumFlow;

/// Of one pair of labelled axes j, k and the function S = ∫ Lⱼ Lₖ dt of L(0).
#[derive(Clone, Copy, Debug)]
pub(super) struct Integral {
    /// S; of a pair j = k Lⱼ(0)² t − S.
    pub(super) value: f64,
    /// ∂L(t)/∂L(0) · (L(0) × ∇S)
    pub(super) carried: [f64; 3],
}

/// The pairs of axes in the order of a tensor's elements.
pub(super) const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];

/// While cn u is larger, the sums that are divided by 1 + cn u and cn u + dn u lose nothing.
const FIRST_EIGHTH: f64 = 0.5;

impl MomentumFlow {
    /// The integrals of all pairs, from L(t) and its derivative.
    ///
    /// The map M = ∂L(t)/∂L(0) keeps Poisson brackets. So M (L(0) × ∇f(L(t))) = L(t) × f′, and of a function C(A1², A3²) it is 2 (C₁ − C₃) N(t),
    /// N = L̇/δ1. All integrals are made of these and of σ, cn, dn and S = ∫ σ² dt:
    ///
    /// ∫ L2² = δ1² A1² A3² S + σ L2 L2(t),  ∫ L1² = A1² t − ρ ∫ L2²,  ∫ L3² = A3² t − (1 − ρ) ∫ L2²,
    /// ∫ L1 L2 = σ (L1 L2(t) + L2 L1(t))/(1 + dn),  ∫ L2 L3: 1 + cn,  ∫ L3 L1: cn + dn
    ///
    /// or ∫ L2 L3 = (L1 − L1(t))/δ2, ∫ L3 L1 = (L2(t) − L2)/δ1.
    pub(super) fn integrals(&self, l: &[f64; 3], by_start: &[[f64; 3]; 3], f: &TimeFunctions) -> [Integral; 6] {
        let (start, [d1, d2, d12], [rho, rest]) = (&self.start, self.delta, self.rho);
        let ([l1, l2, l3], [a1, a3, norm2]) = (self.start, self.squares);
        let (t, sigma, c, d, v) = (f.time, f.sigma, f.cn, f.dn, f.quotient);
        let pq = d1 * d2;
        // M (L(0) × eₖ) and L(t) × eₖ
        let column = |k: usize| [by_start[0][k], by_start[1][k], by_start[2][k]];
        let [m1, m2, m3] = [column(0), column(1), column(2)];
        let moved = [mix(l3, &m2, -l2, &m3), mix(l1, &m3, -l3, &m1), mix(l2, &m1, -l1, &m2)];
        let end = [[0.0, l[2], -l[1]], [-l[2], 0.0, l[0]], [l[1], -l[0], 0.0]];
        let n = [-rho * l[1] * l[2], l[2] * l[0], -rest * l[0] * l[1]];
        // 2 (∂₁ − ∂₃) of σ, cn and dn; of Q − mP it is 2e
        let e = if a1 > a3 { pq * self.m * norm2 / a1 } else { d1 * d12 * norm2 / a3 };
        let of_sigma = pq * f.lag - e * (c * d) * v;
        let of_cn = pq * sigma * d * (d1 * d12 * norm2 * v + t);
        let of_dn = sigma * (pq * self.m * c * t - e * (sigma / d - self.m * self.p * c * v));

        let ends = l2 * l[1];
        let of_second = d1 * d1 * (norm2 * (d * d) * v + a3 * f.square - a1 * (t * sigma * sigma)) + ends * of_sigma;
        let second = sum(of_second, &n, sigma * l[1], &moved[1], sigma * l2, &end[1]);
        // L2² t − ∫ L2²
        let departure = l2 * l2 * t - (d1 * d1 * (a1 * a3) * f.square + sigma * ends);
        let squares = [
            Integral { value: -rho * departure, carried: mix(2.0 * t, &n, -rho, &second) },
            Integral { value: departure, carried: second },
            Integral { value: -rest * departure, carried: mix(-2.0 * t, &n, -rest, &second) },
        ];
        let product = |j: usize, k: usize, below: f64, of_below: f64| {
            let h = sigma / below;
            let of_h = (of_sigma - h * of_below) / below;
            let both = start[j] * l[k] + start[k] * l[j];
            let mut carried = sum(of_h * both, &n, h * l[k], &moved[j], h * start[j], &end[k]);
            for (x, y) in carried.iter_mut().zip(mix(h * l[j], &moved[k], h * start[k], &end[j])) {
                *x += y;
            }
            Integral { value: h * both, carried }
        };
        let first_second = product(0, 1, 1.0 + d, of_dn);
        let (third_first, second_third) = if c > FIRST_EIGHTH {
            (product(2, 0, c + d, of_cn + of_dn), product(1, 2, 1.0 + c, of_cn))
        } else {
            let (i1, i2) = (1.0 / d1, 1.0 / d2);
            (
                Integral { value: (l[1] - l2) * i1, carried: mix(i1, &end[1], -i1, &moved[1]) },
                Integral { value: (l1 - l[0]) * i2, carried: mix(i2, &moved[0], -i2, &end[0]) },
            )
        };
        let [s1, s2, s3] = squares;
        [s1, s2, s3, first_second, third_first, second_third]
    }
}

/// x a + y b
fn mix(x: f64, a: &[f64; 3], y: f64, b: &[f64; 3]) -> [f64; 3] {
    [x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]]
}

/// x a + y b + z c
fn sum(x: f64, a: &[f64; 3], y: f64, b: &[f64; 3], z: f64, c: &[f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| x * a[k] + y * b[k] + z * c[k])
}
