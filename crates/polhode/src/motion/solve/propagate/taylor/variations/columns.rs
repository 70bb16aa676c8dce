//! Series of eight columns of derivatives in SIMD lanes, from the series of their coefficient
//! matrices.

use super::super::recurrence::over;
use super::super::row::TERMS;
use crate::math::lanes::Lanes;
use crate::math::machine::{Machine, Work};
use crate::math::number::Number;

/// Number of columns in a block.
pub(super) const WIDTH: usize = 8;

/// θ and δω of eight columns, row by row, principal axes.
pub(super) type Rows = [Lanes<WIDTH>; 6];

pub(super) const NO_ROWS: Rows = [Lanes([0.0; WIDTH]); 6];

/// Optional parts of the equations.
#[derive(Clone, Copy, Debug)]
pub(super) struct Equations {
    pub(super) has_friction: bool,
    pub(super) has_attitude: bool,
}

/// Coefficient n of the matrices that multiply θ and δω.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rates {
    /// Ω and −Ω.
    pub(super) turning: [[f64; 3]; 2],
    /// Rows of ∂Ω/∂ω. Unused without friction, where this is the identity.
    pub(super) bending: [[f64; 3]; 3],
    /// Rows of I⁻¹ ∂(L × Ω + N)/∂θ.
    pub(super) of_attitude: [[f64; 3]; 3],
    /// Rows of I⁻¹ ∂(L × Ω + N)/∂ω.
    pub(super) of_omega: [[f64; 3]; 3],
}

/// Series of eight columns, and of their source terms.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) series: Vec<Rows>,
    pub(super) sources: Vec<Rows>,
}

impl Block {
    /// Creates a block of zeros.
    pub(super) fn new() -> Self {
        Self { series: vec![NO_ROWS; TERMS], sources: vec![NO_ROWS; TERMS] }
    }

    /// Computes all coefficients.
    #[inline(always)]
    pub(super) fn expand<S: Machine>(&mut self, s: S, equations: Equations, rates: &[Rates]) {
        match (equations.has_friction, equations.has_attitude) {
            (false, false) => self.extend::<S, false, false>(s, rates),
            (false, true) => self.extend::<S, false, true>(s, rates),
            (true, _) => self.extend::<S, true, true>(s, rates),
        }
    }

    /// Solves (n + 1) xₙ₊₁ = Σₖ Aₖ xₙ₋ₖ + bₙ for all n.
    #[inline(always)]
    fn extend<S: Machine, const FRICTION: bool, const ATTITUDE: bool>(&mut self, s: S, rates: &[Rates]) {
        let Self { series, sources } = self;
        for n in 0..rates.len() {
            let mut sums = load(s, &sources[n]);
            for (a, x) in rates[..=n].iter().zip(series[..=n].iter().rev()).rev() {
                sums = plus::<S, FRICTION, ATTITUDE>(s, sums, a, load(s, x));
            }
            if !FRICTION {
                for k in 0..3 {
                    sums[k] = sums[k] + s.load_eight(&series[n][3 + k].0);
                }
            }
            for (place, sum) in series[n + 1].iter_mut().zip(sums) {
                *place = Lanes(s.eight_numbers(over(sum, n + 1)));
            }
        }
    }
}

/// Loads six rows into registers. In a closure of `map`, the vector operations would become
/// function calls; a loop avoids this.
#[inline(always)]
fn load<S: Machine>(s: S, rows: &Rows) -> [S::Eight; 6] {
    let mut all = [s.eight(0.0); 6];
    for (place, row) in all.iter_mut().zip(rows) {
        *place = s.load_eight(&row.0);
    }
    all
}

/// Adds θ × Ω and the terms that are linear in θ and δω.
#[inline(always)]
fn plus<S: Machine, const FRICTION: bool, const ATTITUDE: bool>(
    s: S,
    mut sums: [S::Eight; 6],
    a: &Rates,
    x: [S::Eight; 6],
) -> [S::Eight; 6] {
    let [plus, minus] = a.turning;
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        sums[i] = x[j].mul_add(s.eight(plus[k]), sums[i]);
        sums[i] = x[k].mul_add(s.eight(minus[j]), sums[i]);
        for j in 0..3 {
            if FRICTION {
                sums[i] = x[3 + j].mul_add(s.eight(a.bending[i][j]), sums[i]);
            }
            if ATTITUDE {
                sums[3 + i] = x[j].mul_add(s.eight(a.of_attitude[i][j]), sums[3 + i]);
            }
            sums[3 + i] = x[3 + j].mul_add(s.eight(a.of_omega[i][j]), sums[3 + i]);
        }
    }
    sums
}
/// Evaluation of all series at one time.
pub(super) struct Sum<'v> {
    pub(super) blocks: &'v [Block],
    pub(super) order: usize,
    pub(super) h: f64,
    pub(super) sums: &'v mut [Rows],
}

impl Work for Sum<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Machine>(self, s: S) {
        let Self { blocks, order, h, sums } = self;
        let h = s.eight(h);
        for (block, place) in blocks.iter().zip(sums) {
            let mut sums = load(s, &block.series[order]);
            for rows in block.series[..order].iter().rev() {
                for (sum, c) in sums.iter_mut().zip(load(s, rows)) {
                    *sum = sum.mul_add(h, c);
                }
            }
            for (place, sum) in place.iter_mut().zip(sums) {
                *place = Lanes(s.eight_numbers(sum));
            }
        }
    }
}
