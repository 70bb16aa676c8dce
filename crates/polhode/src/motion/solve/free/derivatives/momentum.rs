//! Derivative of L(t) with respect to L(0), labelled axes.

use crate::math::double::Double;
use crate::math::triple::Triple;
use crate::motion::solve::free::elements::Elements;
use crate::motion::solve::free::labelled::Labelled;

use super::functions::TimeFunctions;

/// Constants of a motion along its labelled axes, in units of the elements.
///
/// δ1 = 1/i1 − 1/i3, δ2 = 1/i2 − 1/i3 and ρ = δ2/δ1 as in `book/free-motion.md`.
/// `book/free-motion-derivatives.md` defines the other symbols.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MomentumFlow {
    /// L(0), labelled axes.
    pub(super) start: [f64; 3],
    /// 1/i1, 1/i2, 1/i3
    pub(super) inverse: [f64; 3],
    /// 1/(iⱼ iₖ) in the order of [`PAIRS`], halved where j = k.
    pub(super) shares: [f64; 6],
    /// δ1, δ2, δ1 − δ2
    pub(super) delta: [f64; 3],
    /// ρ, 1 − ρ
    pub(super) rho: [f64; 2],
    /// A1², A3², L²
    pub(super) squares: [f64; 3],
    /// L3²/A3², (1 − ρ) L2²/A3² and L2 L3/A3².
    parts: [f64; 3],
    /// ½ · 2 (∂₁ − ∂₃)(Q − mP) = δ1 (δ1 − δ2) L²/A3².
    pub(super) slope: f64,
    /// 1/L² and 1/2P.
    pub(super) over: [f64; 2],
    pub(super) m: f64,
    /// P = λ².
    pub(super) p: f64,
    /// Gradients ∇P and ∇Q − m∇P with respect to L(0).
    gradients: [[f64; 3]; 2],
}

/// Pairs of axes in the order of the elements of a tensor: 11, 22, 33, 12, 13, 23.
pub(super) const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];

#[inline(always)]
pub(super) fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl MomentumFlow {
    pub(super) fn of(elements: &Elements, labelled: &Labelled) -> Self {
        let moments = labelled.moments.map(Triple::double);
        let [i1, i2, i3] = moments;
        let gap = |j: usize, k: usize| (labelled.moments[j] - labelled.moments[k]).double();
        let (d21, d32, d31) = (gap(1, 0), gap(2, 1), gap(2, 0));
        let [rho, rest] = if d31.is_zero() {
            [1.0, 0.0]
        } else {
            [d32 * i1 / (d31 * i2), d21 * i3 / (d31 * i2)].map(Double::value)
        };
        let delta = [d31 / (i1 * i3), d32 / (i2 * i3), d21 / (i1 * i2)].map(Double::value);
        let [d1, d2, d12] = delta;
        let start = [0, 1, 2].map(|k| (labelled.moments[k] * labelled.omega[k]).value());
        let [a1, _, a3] = elements.amplitudes.map(|a| a.square().value());
        let (m, m1) = (elements.m.value(), elements.m1().value());
        let [l1, l2, l3] = start;
        let (norm2, p) = (elements.momentum.square().value(), elements.lambda.square().value());
        let a = if a3 == 0.0 { 1.0 } else { a3 };
        let inverse = moments.map(|i| (Double::ONE / i).value());
        Self {
            start,
            inverse,
            shares: PAIRS.map(|[j, k]| (if j == k { 0.5 } else { 1.0 }) * inverse[j] * inverse[k]),
            delta,
            rho: [rho, rest],
            squares: [a1, a3, norm2],
            parts: [l3 * l3 / a, rest * l2 * l2 / a, l2 * l3 / a],
            slope: if a1 > a3 { d1 * d2 * m * norm2 / a1 } else { d1 * d12 * norm2 / a },
            over: [1.0 / norm2, 0.5 / p],
            m,
            p,
            gradients: [
                [0.0, 2.0 * d2 * d12 * l2, 2.0 * d1 * d2 * l3],
                [2.0 * d1 * d12 * l1, 2.0 * d2 * d12 * m1 * l2, -2.0 * m * d1 * d2 * l3],
            ],
        }
    }

    /// Returns ∂L(t)/∂L(0), row by row. The addition theorems give, with P = λ² and Q = mλ² as
    /// functions of L(0),
    ///
    /// L1(t) = (L1 cn − δ2 L2 L3 σ dn)/Δ,  L2(t) = (L2 cn dn + δ1 L3 L1 σ)/Δ,
    /// L3(t) = (L3 dn − (δ1 − δ2) L1 L2 σ cn)/Δ,  Δ = 1 − δ2 (δ1 − δ2) L2² σ² = cn² + (L3/A3)² sn²,
    /// dσ = cn dn dτ − ½σ dP/P,  dcn = −Pσ dn dτ,  ddn = −Qσ cn dτ − ½(σ²/dn) dμ,
    /// dτ = ½t dP/P − ½V dμ,  dμ = dQ − m dP
    ///
    /// τ shifts the time, so its contribution is L̇(t) ∇τ. Near the intermediate axis the
    /// contribution of −½σ dP/P cancels much of the explicit derivative with respect to L(0). The
    /// two are therefore combined, except where |u| is small, because P may vanish there.
    #[inline(always)]
    pub(super) fn derivative(&self, l: &[f64; 3], f: &TimeFunctions) -> [[f64; 3]; 3] {
        let ([l1, l2, l3], [d1, d2, d12]) = (self.start, self.delta);
        let (sigma, c, d) = (f.sigma, f.cn, f.dn);
        let sn2 = self.p * sigma * sigma;
        let [third, second, both] = self.parts;
        let below =
            1.0 / if f.is_near { 1.0 - d2 * d12 * (l2 * sigma) * (l2 * sigma) } else { c * c + third * sn2 };
        let rate = self.rate(l);
        // ∂L(t)/∂dn
        let by_dn = [-d2 * l2 * l3 * sigma * below, l2 * c * below, l3 * below];
        let delay = sigma * sigma * f.over_dn;
        let by_mu = |k: usize| -0.5 * (f.quotient * rate[k] + delay * by_dn[k]);
        let by_mu = [by_mu(0), by_mu(1), by_mu(2)];
        let (x2, x3, y, by_p);
        if f.is_near {
            (x2, x3, y) = (1.0, 1.0, 0.0);
            let k = 2.0 * d2 * d12 * l2 * l2 * sigma;
            let by_sigma =
                [k * l[0] - d2 * l2 * l3 * d, k * l[1] + d1 * l3 * l1, k * l[2] - d12 * l1 * l2 * c];
            let by_cn = [l1, l2 * d, -d12 * l1 * l2 * sigma];
            let of = |k: usize| {
                let by_time = sigma * f.time * (d * by_cn[k] * below + self.m * c * by_dn[k]);
                -0.5 * (f.lag * by_sigma[k] * below + by_time)
            };
            by_p = [of(0), of(1), of(2)];
        } else {
            (x2, x3, y) = (third, second, 1.0);
            let half = self.over[1] * f.time;
            by_p = [half * rate[0], half * rate[1], half * rate[2]];
        }
        let q = y * both;
        let (s1, s2, s12) = (d1 * sigma, d2 * sigma * d, d12 * sigma * c);
        let explicit = [
            [c, -s2 * l3 * x2, -s2 * l2 * x3],
            [s1 * l3, c * d - s1 * l1 * self.rho[1] * q, s1 * l1 * x3],
            [-s12 * l2, -s12 * l1 * x2, d + s12 * l1 * q],
        ];
        let k = 2.0 * d2 * d12 * l2 * sigma * sigma;
        let by_delta = [0.0, k * x2, -k * q];
        let [grad_p, grad_mu] = &self.gradients;
        let element = |i: usize, j: usize| {
            (explicit[i][j] + l[i] * by_delta[j]) * below + by_mu[i] * grad_mu[j] + by_p[i] * grad_p[j]
        };
        let row = |i: usize| [element(i, 0), element(i, 1), element(i, 2)];
        [row(0), row(1), row(2)]
    }

    /// Returns L̇ = (−δ2 L2 L3, δ1 L3 L1, (δ2 − δ1) L1 L2).
    #[inline(always)]
    fn rate(&self, l: &[f64; 3]) -> [f64; 3] {
        let [d1, d2, d12] = self.delta;
        [-d2 * l[1] * l[2], d1 * l[2] * l[0], -d12 * l[0] * l[1]]
    }
}
