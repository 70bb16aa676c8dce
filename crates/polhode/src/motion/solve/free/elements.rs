//! Constants of a free motion, in double-double and triple-double precision.

use crate::math::double::Double;
use crate::math::means::quarter_and_share;
use crate::math::triple::Triple;

use super::labelled::{Labelled, Mode};

/// Constants of the elliptic motion: amplitudes, parameter, and the rates of the two phases that
/// are linear in time.
///
/// L = (A1 cn, A2 sn, A3 dn)(u0 + λt) in the labelled axes. The plane of L and axis 3 rotates about
/// L at the mean rate Ω.
///
/// Let δⱼ = 1/iⱼ − 1/i3 (both positive in short-axis mode, both negative in long-axis mode) and ρ =
/// δ2/δ1 ≤ 1. Then
///
/// A1² = L1² + ρ L2²,  A2² = A1²/ρ,  A3² = L3² + (1 − ρ) L2²,  λ² = A3² δ1 δ2,  n = 1 − 1/ρ,
///
/// m = −n A1²/A3²
///
/// Units: powers of two such that the largest moment and the fastest component of ω are between 1
/// and 2.
///
/// Source: Landau & Lifshitz, Mechanics, §37. `book/free-motion.md` derives the forms without
/// cancellation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Elements {
    /// |L|
    pub(super) momentum: Double,
    /// A1, A2, A3
    pub(super) amplitudes: [Double; 3],
    /// Amplitudes Aⱼ/iⱼ of ω. For a rod, the amplitude along itself is its spin.
    pub(super) rates: [Double; 3],
    /// cn u0 and sn u0: position of the start on the polhode.
    pub(super) start: [Double; 2],
    /// Elliptic parameter m.
    pub(super) m: Double,
    /// √(1 − m). Its square may leave the range of f64.
    pub(super) k1: Double,
    /// −n ≥ 0
    pub(super) minus_n: Double,
    /// λ, negative in long-axis mode.
    pub(super) lambda: Double,
    /// Quarter period K(m); 2¹⁰⁰ represents infinity on the separatrix.
    pub(super) quarter: Double,
    /// Ω/4π: half the mean precession rate, in turns per unit time.
    pub(super) half_precession: Triple,
}

impl Elements {
    /// Returns (A1, A2, A3)/L, or the direction of axis 3 if L is zero.
    pub(super) fn direction(&self) -> [f64; 3] {
        if self.momentum.is_zero() {
            return [0.0, 0.0, 1.0];
        }
        self.amplitudes.map(|a| a.over(self.momentum).value())
    }

    /// Returns 1 − m.
    pub(super) fn m1(&self) -> Double {
        self.k1.square()
    }

    /// Returns the constants for ω along axis 3 only: λ = 0, and the body rotates at |ω|.
    pub(super) fn permanent(labelled: &Labelled) -> Self {
        let i3 = labelled.moments[2].double();
        let zero = Double::default();
        let rate = labelled.omega[2].double();
        Self {
            momentum: i3 * rate,
            amplitudes: [zero, zero, i3 * rate],
            rates: [zero, zero, rate],
            start: [Double::ONE, zero],
            m: zero,
            k1: Double::ONE,
            minus_n: zero,
            lambda: zero,
            quarter: Double::TAU.scaled(0.25),
            half_precession: labelled.omega[2] * Triple::INVERSE_4_PI,
        }
    }

    pub(super) fn of(labelled: &Labelled) -> Self {
        let (fine, omega) = (labelled.moments, labelled.omega);
        let difference = |j: usize, k: usize| (fine[j] - fine[k]).double();
        let (d21, d32, d31) = (difference(1, 0), difference(2, 1), difference(2, 0));
        let ([i1, i2, i3], [v1, v2, v3]) = (fine.map(Triple::double), omega.map(Triple::double));
        let [l1, l2, l3] = [i1 * v1, i2 * v2, i3 * v3];
        let axisymmetric = d21.is_zero();

        // Only what the rates of the phases depend on needs the last two bits of a quotient.
        // ρ = (i3 − i2) i1 / ((i3 − i1) i2) and 1 − ρ = (i2 − i1) i3 / ((i3 − i1) i2)
        let (rho, rest) = if d31.is_zero() {
            (Double::ONE, Double::default())
        } else {
            ((d32 * i1).over(d31 * i2), (d21 * i3).over(d31 * i2))
        };
        let a1 = (l1.square() + rho * l2.square()).sqrt();
        let a2 = (l2.square() + if a1.is_zero() { Double::default() } else { l1.square().over(rho) }).sqrt();
        // amplitude of ω along axis 3: ω3² + (i2 (i2 − i1) / (i3 (i3 − i1))) ω2², valid also for a
        // rod, where i3 = 0
        let share = if axisymmetric { Double::default() } else { i2 * d21 / (i3 * d31) };
        let rate3 = (v3.square() + share * v2.square()).sqrt();
        let a3 = (l3.square() + rest * l2.square()).sqrt();

        // λ² = (i3 − i1)(i3 − i2) / (i1 i2) times the squared amplitude of ω along axis 3
        let speed = rate3 * (d31 * d32 / (i1 * i2)).sqrt();
        let lambda = if labelled.mode == Mode::Long { -speed } else { speed };
        // m = A1² (i2 − i1) / (i1 i3 (i3 − i2) ω3max²),  1 − m = (L² − 2T i2) / (i3 (i3 − i2) ω3max²)
        let (m, k1, minus_n) = if axisymmetric {
            (Double::default(), Double::ONE, Double::default())
        } else {
            let below = i3 * d32 * rate3.square();
            let k1 = (labelled.excess / below).sqrt().scaled(labelled.excess_unit);
            ((a1.square() * d21).over(i1 * below), k1, (d21 * i3).over(d32 * i1))
        };
        let (quarter, share) =
            quarter_and_share(k1, if d32.is_zero() { Double::ONE } else { d31 * i2 / (d32 * i1) });

        // Ω = L/i2 + ½ L (1/i1 − 1/i2) R
        let squares = [0, 1, 2].map(|k| (fine[k] * omega[k]).square());
        let momentum = (squares[0] + squares[1] + squares[2]).sqrt();
        let difference = if axisymmetric {
            Double::default()
        } else {
            momentum.double() * d21 * share / (i1 * i2).scaled(2.0)
        };
        let precession = momentum / fine[1] + Triple::from(difference);
        let start = if a1.is_zero() { [Double::ONE, Double::default()] } else { [l1.over(a1), l2.over(a2)] };
        Self {
            momentum: momentum.double(),
            amplitudes: [a1, a2, a3],
            rates: [a1.over(i1), a2.over(i2), rate3],
            start,
            m,
            k1,
            minus_n,
            lambda,
            quarter,
            half_precession: precession * Triple::INVERSE_4_PI,
        }
    }
}
