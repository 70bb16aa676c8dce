//! Carlson's symmetric elliptic integrals by duplication, with the *square roots* of their usual
//! arguments.
//!
//! Duplication x → ¼(x + √x√y + √x√z + √y√z) becomes a → ½√((a + b)(a + c)) for the roots. This is
//! a product of sums of nonnegative numbers, which keeps full relative precision for any ratio of
//! the arguments. Squares of 10⁻¹⁶² or 10¹⁵⁴ do not occur.
//!
//! Source: B. C. Carlson, Numerical Algorithms 10 (1995) 13; the series are DLMF 19.36.1 and
//! 19.36.2.

use crate::math::double::Double;

/// Spread of the arguments below which the series, of eighth order in the spread, are used: errors
/// below 10⁻²⁴.
const SPREAD: f64 = 1e-3;

/// Returns R_F(a², b², c²) = ½ ∫₀^∞ dt / √((t + a²)(t + b²)(t + c²)); at most one of a, b, c is
/// zero.
pub(super) fn rf(roots: [Double; 3]) -> Double {
    let [mut a, mut b, mut c] = roots;
    loop {
        let [x, y, z] = [a.square(), b.square(), c.square()];
        let mean = (x + y + z) / Double::from(3.0);
        let [x, y, z] = [x, y, z].map(|x| departure(x, mean));
        // Negated so that NaN ends the loop.
        if !(spread([x, y, z]) > SPREAD) {
            let e2 = x * y - z * z;
            let e3 = x * y * z;
            let series =
                -e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0 - 5.0 * e2 * e2 * e2 / 208.0
                    + 3.0 * e3 * e3 / 104.0
                    + e2 * e2 * e3 / 16.0;
            return Double::sum(1.0, series) / mean.sqrt();
        }
        [a, b, c] = duplicated([a, b, c]);
    }
}

/// Returns R_J(a², b², c², p²) = 3/2 ∫₀^∞ dt / ((t + p²) √((t + a²)(t + b²)(t + c²))) for p > 0.
pub(super) fn rj(roots: [Double; 3], p: Double) -> Double {
    let ([mut a, mut b, mut c], mut p) = (roots, p);
    let (mut sum, mut weight) = (Double::default(), 1.0);
    loop {
        let [x, y, z, q] = [a.square(), b.square(), c.square(), p.square()];
        let mean = (x + y + z + q.scaled(2.0)) / Double::from(5.0);
        let [x, y, z, q] = [x, y, z, q].map(|x| departure(x, mean));
        if !(spread([x, y, z, q]) > SPREAD) {
            let series = rj_series([x, y, z, q]);
            return Double::from(6.0) * sum + Double::sum(1.0, series).scaled(weight) / (mean * mean.sqrt());
        }
        // 6 Σ 4⁻ⁿ/dₙ R_C(1, 1 + eₙ),  d = (p + a)(p + b)(p + c),
        // e = (p − a)(p − b)(p − c)/d = 2p (p² + ab + bc + ca)/d − 1
        let d = (p + a) * (p + b) * (p + c);
        let p2 = p.square() + (a * b + b * c + c * a);
        let ratio = (p * p2).scaled(2.0) / d;
        sum = sum + (rc(Double::ONE, ratio.sqrt()) / d).scaled(weight);
        weight *= 0.25;
        p = p2.sqrt().scaled(0.5);
        [a, b, c] = duplicated([a, b, c]);
    }
}

/// Returns R_C(a², b²) = R_F(a², b², b²) for b > 0.
pub(super) fn rc(a: Double, b: Double) -> Double {
    rf([a, b, b])
}

/// Returns ½√((a + b)(a + c)) for each root.
fn duplicated([a, b, c]: [Double; 3]) -> [Double; 3] {
    let (ab, bc, ca) = (a + b, b + c, c + a);
    [ab * ca, bc * ab, ca * bc].map(|x| x.sqrt().scaled(0.5))
}

/// Returns 1 − x/mean.
fn departure(x: Double, mean: Double) -> f64 {
    (mean - x).high / mean.high
}

fn spread<const N: usize>(departures: [f64; N]) -> f64 {
    departures.iter().fold(0.0, |max, x| x.abs().max(max))
}

/// Returns the series DLMF 19.36.2 without its leading 1.
fn rj_series([x, y, z, p]: [f64; 4]) -> f64 {
    let xyz = x * y * z;
    let e2 = x * y + x * z + y * z - 3.0 * p * p;
    let e3 = xyz + 2.0 * e2 * p + 4.0 * p * p * p;
    let e4 = (2.0 * xyz + e2 * p + 3.0 * p * p * p) * p;
    let e5 = xyz * p * p;
    -3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 - 9.0 * e2 * e3 / 52.0
        + 3.0 * e5 / 26.0
        - e2 * e2 * e2 / 16.0
        + 3.0 * e3 * e3 / 40.0
        + 3.0 * e2 * e4 / 20.0
        + 45.0 * e2 * e2 * e3 / 272.0
        - 9.0 * (e3 * e4 + e2 * e5) / 68.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(got: Double, want: (f64, f64)) {
        let error = (got - Double::new(want.0, want.1)).value() / want.0;
        assert!(error.abs() < 1e-22, "{got:?}: {error:e}");
    }

    #[test]
    fn they_meet_their_elementary_cases_to_22_digits() {
        let [zero, one, two] = [0.0, 1.0, 2.0].map(Double::from);
        let quarter_turn = Double::TAU.scaled(0.25);
        // R_C(0, 1) = π/2.
        near(rc(zero, one), (quarter_turn.high, quarter_turn.low));
        // R_F(x, x, x) = x^−½.
        near(rf([two; 3]), (0.5, 0.0));
        // R_J(x, x, x, x) = x^−3/2.
        near(rj([two; 3], two), (0.125, 0.0));
        // R_J(0, 1, 1, 4) = 3 (π/2)(1 − ½)/(4 − 1).
        let value = quarter_turn.scaled(0.5);
        near(rj([zero, one, one], two), (value.high, value.low));
    }
}
