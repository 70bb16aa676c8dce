//! Nutation: the axis moves between two roots of a cubic, as sn².
//!
//! The variable is v = 1 − cos θ, the height below the upright position in units of the arm. It
//! satisfies
//!
//! v̇² = g(v) = (α − β + βv)(2v − v²) − (b − a + av)² = −(b − a)² + c₁v + c₂v² − βv³.
//!
//! The three roots are real: v₃ ≤ 0 ≤ v₂ ≤ v₁ ≤ 2. v oscillates between v₂ and v₁: v = v₁ cn² + v₂
//! sn².
//!
//! v is measured from the upright position because the roots v₂ and v₃ can coincide only there
//! (motion asymptotic to a sleeping top). 1 − m then vanishes with (b − a)² and c₁, which the start
//! determines to full precision.

use crate::math::double::Double;
use crate::math::elliptic::EllipticParameter;
use crate::math::triple::Triple;

use super::constants::Constants;

/// Nutation v = v₁ cn²(x|m) + v₂ sn²(x|m), x = x₀ + λt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nutation {
    /// v₁, v₂, |v₃|: absolute value of 1 − cos θ at the lowest, the highest and the third root.
    pub(super) from_top: [Double; 3],
    /// 1 + cos θ at the same three roots.
    pub(super) from_bottom: [Double; 3],
    /// v₁ − v₂
    pub(super) swing: Double,
    /// v₁ − v₃
    pub(super) spread: Double,
    /// λ, in the unit of the constants.
    pub(super) rate: Double,
    /// x₀
    pub(super) start: Double,
    pub(super) parameter: EllipticParameter,
}

impl Nutation {
    pub(super) fn of(top: &Constants) -> Self {
        let Roots { v1, v2, v3, swing } = Roots::of(top);
        let two = Triple::from(2.0);
        let (w2, w3) = (two - v2, two - v3);
        // w₁ w₂ w₃ = (b + a)²/β
        let w1 = if v1.value() > 1.5 { top.b_plus_a.square() / (top.beta * w2 * w3) } else { two - v1 };
        let spread = v1 - v3;
        let [m, m1] = if spread.value() > 0.0 {
            [swing / spread, (v2 - v3) / spread]
        } else {
            [Triple::default(), Triple::from(1.0)]
        };
        let parameter = EllipticParameter::of(m.double(), m1.double());
        // λ² = ¼ β (v₁ − v₃)
        let rate = (top.beta * spread).sqrt().scaled(0.5).double();
        let (sin, cos) = start(top, v1, v2, v3);
        Self {
            from_top: [v1, v2, -v3].map(Triple::double),
            from_bottom: [w1, w2, w3].map(Triple::double),
            swing: swing.double(),
            spread: spread.double(),
            rate,
            start: parameter.first(sin, cos),
            parameter,
        }
    }
}

/// Returns sn and cn at the start, cn ≥ 0: sn² = (v₁ − v)/(v₁ − v₂), and sn has the sign of d(cos
/// θ)/dt.
fn start(top: &Constants, v1: Triple, v2: Triple, v3: Triple) -> (Double, Double) {
    let v = top.from_top;
    let (below, above, third) = (v1 - v, v - v2, v - v3);
    // β (v₁ − v)(v − v₂)(v − v₃) = v̇² determines the smaller of the two differences accurately.
    let other = |difference: Triple| {
        let product = top.beta * difference * third;
        if product.value() > 0.0 { top.fall.square() / product } else { Triple::default() }
    };
    let (below, above) =
        if below.value() > above.value() { (below, other(below)) } else { (other(above), above) };
    let whole = below + above;
    if !(whole.value() > 0.0) {
        return (Double::default(), Double::ONE);
    }
    let sin = (below / whole).sqrt().double();
    let cos = (above / whole).sqrt().double();
    (if top.fall.value() < 0.0 { -sin } else { sin }, cos)
}

/// Roots v₁ ≥ v₂ ≥ 0 ≥ v₃ of the cubic, and v₁ − v₂.
struct Roots {
    v1: Triple,
    v2: Triple,
    v3: Triple,
    swing: Triple,
}

impl Roots {
    fn of(top: &Constants) -> Self {
        // v³ − e₁v² + e₂v + e₃ = 0
        let square = top.b_minus_a.square();
        let c1 = (top.excess - top.a * top.b_minus_a).scaled(2.0);
        let c2 = top.beta.scaled(2.0) - top.excess - top.a.square();
        let [e1, e2, e3] = [c2 / top.beta, -c1 / top.beta, square / top.beta];
        let (end, is_lowest) = isolated([e1, e2, e3]);
        if is_lowest { Self::beside_lowest(end, e2, e3) } else { Self::beside_third(end, [e1, e2, e3]) }
    }

    /// Computes the other roots from v₁. v₂ v₃ = −e₃/v₁ is not positive, so nothing cancels.
    fn beside_lowest(v1: Triple, e2: Triple, e3: Triple) -> Self {
        let zero = Triple::default();
        if !(v1.value() > 0.0) {
            return Self { v1: zero, v2: zero, v3: zero, swing: zero };
        }
        let product = -e3 / v1;
        let sum = (e2 - product) / v1;
        let gap = (sum.square() - product.scaled(4.0)).sqrt();
        let over = |root: Triple| if root.is_zero() { zero } else { product / root };
        let (v2, v3) = if sum.value() >= 0.0 {
            let v2 = (sum + gap).scaled(0.5);
            (v2, over(v2))
        } else {
            let v3 = (sum - gap).scaled(0.5);
            (over(v3), v3)
        };
        Self { v1, v2, v3, swing: v1 - v2 }
    }

    /// Computes the other roots from v₃. v₁ + v₂ and v₁ v₂ follow from those of Vieta's formulas
    /// that do not cancel.
    fn beside_third(v3: Triple, [e1, e2, e3]: [Triple; 3]) -> Self {
        let zero = Triple::default();
        let v3 = if v3.value() < 0.0 { v3 } else { zero };
        let sum = e1 - v3;
        let (sum, product) = if -v3.value() <= sum.value() {
            (sum, e2 - v3 * sum)
        } else {
            let product = -e3 / v3;
            ((e2 - product) / v3, product)
        };
        let square = sum.square() - product.scaled(4.0);
        let swing = if square.value() > 0.0 { square.sqrt() } else { zero };
        let v1 = (sum + swing).scaled(0.5);
        let v2 = if v1.value() > 0.0 { product / v1 } else { zero };
        Self { v1, v2, v3, swing }
    }
}

/// Returns the root of v³ − e₁v² + e₂v + e₃ = 0 that is farther from the middle root, and true if
/// it is the largest.
///
/// The trigonometric formula (cosine of a third of an angle) gives the first approximation; Newton
/// steps in three words refine it. They converge because no other root is near.
fn isolated([e1, e2, e3]: [Triple; 3]) -> (Triple, bool) {
    let mean = e1 / Triple::from(3.0);
    let at = |v: Triple| ((v - e1) * v + e2) * v + e3;
    let slope = |v: Triple| (v.scaled(3.0) - e1.scaled(2.0)) * v + e2;
    // z³ − 3r²z + q = 0 for z = v − mean
    let (radius, q) = ((-slope(mean).value() / 3.0).max(0.0).sqrt(), at(mean).value());
    let is_largest = q <= 0.0;
    let cosine = (q.abs() / (2.0 * radius * radius * radius)).min(1.0);
    let third = if cosine.is_nan() { 0.0 } else { libm::acos(cosine) / 3.0 };
    let z = 2.0 * radius * libm::cos(third);
    let mut v = mean + Triple::from(if is_largest { z } else { -z });
    for _step in 0..NEWTON_STEPS {
        let slope = slope(v);
        if slope.is_zero() {
            break;
        }
        v = v - at(v) / slope;
    }
    (v, is_largest)
}

/// Number of Newton steps. Two improve the error from 10⁻¹² to 10⁻⁴⁷ of the distance between roots.
/// A root that is far smaller than this distance needs more.
const NEWTON_STEPS: usize = 8;
