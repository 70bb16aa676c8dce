//! Derivatives of L(t) and of the action with respect to the inertia tensor.

use super::functions::TimeFunctions;
use super::momentum::MomentumFlow;

/// Derivatives with respect to the elements 11, 22, 33, 12, 13, 23 of the tensor along the labelled
/// axes. ω(0) is fixed except for δL(0) = δI ω(0).
#[derive(Clone, Copy, Debug)]
pub(super) struct ByInertia {
    /// t ω·δI ω at the start, halved for a diagonal element, minus ½ ∫ ω·δI ω dt.
    pub(super) action: [f64; 6],
    /// Change of L(t), one column per element of the tensor.
    pub(super) momentum: [[f64; 6]; 3],
}

/// Threshold of cn u. Above it the sums that are divided by 1 + cn u and cn u + dn u do not cancel.
const WELL_BEFORE_HALF: f64 = 0.5;

/// Function h of time and of the constants (`value`), and 2 (∂₁ − ∂₃) h with respect to A1² and A3²
/// (`slope`).
#[derive(Clone, Copy)]
struct Factor {
    value: f64,
    slope: f64,
}

/// Inputs of the rows of ∂L(t)/∂I. Its method is not a closure: closures are not always inlined,
/// and are then not compiled for wide vectors.
struct RowsOf<'a> {
    flow: &'a MomentumFlow,
    l: &'a [f64; 3],
    by_start: &'a [[f64; 3]; 3],
    /// Coefficient of N in the derivative of S₂₂.
    of_second: f64,
    time: f64,
    sigma: f64,
    /// L1 L2(t) + L2 L1(t), and the same for the pairs (L3, L1) and (L2, L3).
    sums: [f64; 3],
    /// Factors of the sums in S₁₂, S₃₁ and S₂₃.
    factors: [Factor; 3],
    early: bool,
}

impl RowsOf<'_> {
    /// Returns row `i`. `end`: the components i of L(t) × eₖ. `n`: component i of N.
    #[inline(always)]
    fn at(&self, i: usize, end: [f64; 3], n: f64) -> [f64; 6] {
        let (share, [rho, rest]) = (&self.flow.shares, self.flow.rho);
        let ([l1, l2, l3], l, t, sigma) = (self.flow.start, self.l, self.time, self.sigma);
        let (sums, [h12, h31, h23]) = (&self.sums, &self.factors);
        let [m1, m2, m3] = self.by_start[i];
        // M (L(0) × eₖ)
        let moved = [l3 * m2 - l2 * m3, l1 * m3 - l3 * m1, l2 * m1 - l1 * m2];
        let second = self.of_second * n + sigma * (l[1] * moved[1] + l2 * end[1]);
        let first_second =
            h12.product(n, sums[0], l[1] * moved[0] + l1 * end[1], l[0] * moved[1] + l2 * end[0]);
        let (third_first, second_third) = if self.early {
            (
                h31.product(n, sums[1], l[0] * moved[2] + l3 * end[0], l[2] * moved[0] + l1 * end[2]),
                h23.product(n, sums[2], l[2] * moved[1] + l2 * end[2], l[1] * moved[2] + l3 * end[1]),
            )
        } else {
            (h31.value * (end[1] - moved[1]), h23.value * (moved[0] - end[0]))
        };
        [
            share[0] * (rho * second - 2.0 * t * n),
            -share[1] * second,
            share[2] * (rest * second + 2.0 * t * n),
            -share[3] * first_second,
            -share[4] * third_first,
            -share[5] * second_third,
        ]
    }
}

impl Factor {
    /// Returns the derivative of h (L1 L2(t) + L2 L1(t)), or of the same for another pair: the term
    /// in N, plus the terms in L.
    #[inline(always)]
    fn product(&self, n: f64, both: f64, a: f64, b: f64) -> f64 {
        (self.slope * both) * n + self.value * (a + b)
    }
}

impl MomentumFlow {
    /// Returns the derivatives, from L(t) = `l` and M = ∂L(t)/∂L(0) = `by_start`.
    ///
    /// A change δH = −½ ω·δI ω of the Hamiltonian acts like a change of the start by L(0) × ∇∫ δH
    /// dt. The integrals Sⱼₖ = ∫ Lⱼ Lₖ dt are therefore needed as functions of L(0).
    ///
    /// M preserves Poisson brackets. Hence M (L(0) × ∇f(L(t))) = L(t) × f′. The same expression for
    /// a function C(A1², A3²) is 2 (∂₁C − ∂₃C) N(t), where N = L̇/δ1. All integrals follow from
    /// these and from σ, cn, dn and S = ∫ σ² dt:
    ///
    /// S₂₂ = δ1² A1² A3² S + σ L2 L2(t),  S₁₁ = A1² t − ρ S₂₂,  S₃₃ = A3² t − (1 − ρ) S₂₂,
    /// S₁₂ = σ (L1 L2(t) + L2 L1(t))/(1 + dn)
    ///
    /// S₂₃ and S₃₁ are like S₁₂, with the denominators 1 + cn and cn + dn. Alternatively S₂₃ = (L1
    /// − L1(t))/δ2 and S₃₁ = (L2(t) − L2)/δ1.
    #[inline(always)]
    pub(super) fn by_inertia(&self, l: &[f64; 3], by_start: &[[f64; 3]; 3], f: &TimeFunctions) -> ByInertia {
        let ([d1, d2, d12], [rho, rest]) = (self.delta, self.rho);
        let ([l1, l2, l3], [a1, a3, norm2]) = (self.start, self.squares);
        let (t, sigma, c, d, v) = (f.time, f.sigma, f.cn, f.dn, f.quotient);
        let pq = d1 * d2;
        // 2 (∂₁ − ∂₃) applied to σ, cn and dn
        let e = self.slope;
        let of_sigma = pq * f.lag - e * (c * d) * v;
        let of_cn = pq * sigma * d * (d1 * d12 * norm2 * v + t);
        let of_dn = sigma * (pq * self.m * c * t - e * (sigma * f.over_dn - self.m * self.p * c * v));

        let ends = l2 * l[1];
        let of_second =
            d1 * d1 * (norm2 * (d * d) * v + a3 * f.square - a1 * (t * sigma * sigma)) + ends * of_sigma;
        // L2² t − S₂₂
        let departure = l2 * l2 * t - (d1 * d1 * (a1 * a3) * f.square + sigma * ends);
        let quotient = |below: f64, of_below: f64| {
            let over = 1.0 / below;
            let value = sigma * over;
            Factor { value, slope: (of_sigma - value * of_below) * over }
        };
        let sums = [l1 * l[1] + l2 * l[0], l3 * l[0] + l1 * l[2], l2 * l[2] + l3 * l[1]];
        let h12 = quotient(1.0 + d, of_dn);
        let early = c > WELL_BEFORE_HALF;
        let (h31, h23, s31, s23);
        if early {
            (h31, h23) = (quotient(c + d, of_cn + of_dn), quotient(1.0 + c, of_cn));
            (s31, s23) = (h31.value * sums[1], h23.value * sums[2]);
        } else {
            let by = |delta: f64| Factor { value: 1.0 / delta, slope: 0.0 };
            (h31, h23) = (by(d1), by(d2));
            (s31, s23) = (h31.value * (l[1] - l2), h23.value * (l1 - l[0]));
        }
        let share = &self.shares;
        let rows = RowsOf {
            flow: self,
            l,
            by_start,
            of_second,
            time: t,
            sigma,
            sums,
            factors: [h12, h31, h23],
            early,
        };
        ByInertia {
            action: [
                -share[0] * (rho * departure),
                share[1] * departure,
                -share[2] * (rest * departure),
                share[3] * (l1 * l2 * t - h12.value * sums[0]),
                share[4] * (l1 * l3 * t - s31),
                share[5] * (l2 * l3 * t - s23),
            ],
            momentum: [
                rows.at(0, [0.0, -l[2], l[1]], -rho * l[1] * l[2]),
                rows.at(1, [l[2], 0.0, -l[0]], l[2] * l[0]),
                rows.at(2, [-l[1], l[0], 0.0], -rest * l[0] * l[1]),
            ],
        }
    }
}
