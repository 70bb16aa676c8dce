//! Series of the magnitude of a vector, such as |ω| in quadratic drag: the square root of v · v.
//!
//! The series exists even if v starts from zero: v = tᵐ u with u ≠ 0 at the start gives |v| = tᵐ
//! |u| for later times.
//!
//! |v| has a corner where v passes through zero, and the series from before the corner does not
//! show it. A step therefore goes at most nine tenths of the way to the point where v would vanish
//! (`reach`). After some fifteen such steps, v is of the size of its change within a few roundings
//! of the time. Then |v| is set to zero, and the next series starts beyond the corner.

use super::super::row::{Row, Series};
use super::super::scalar::{self, Scalars};
use crate::math::number::Number;

/// Tolerance for v = 0: v is treated as zero if it changes by its own size within this relative
/// change of the time.
const CLOSEST: f64 = 16.0 * f64::EPSILON;

/// Fraction of the way to a corner that a step may go.
const REACH: f64 = 0.9;

/// Lower bound on |v|; below it the square of v underflows.
const LEAST: f64 = 1e-150;

/// The series of |v|.
#[derive(Clone, Debug)]
pub(super) struct NormSeries<N> {
    /// Index m of the first nonzero coefficient of v, and a bit mask of the lanes with this m. It
    /// is almost always 0 in all lanes.
    leads: Vec<(usize, u8)>,
    /// Bit mask of the lanes whose m is not known yet.
    waiting: u8,
    /// Series of u · u and of |u|, where u = v/tᵐ, in units of `unit`.
    square: Scalars<N>,
    root: Scalars<N>,
    /// |u| at the start, used as unit.
    unit: N,
    /// Threshold below which |v| is treated as zero.
    least: N,
    /// |v̇| at the start of the previous step.
    rate: N,
}

impl<N: Number> NormSeries<N> {
    pub(super) fn all(zero: N) -> Self {
        Self {
            leads: Vec::new(),
            waiting: all_lanes::<N>(),
            square: Scalars::all(zero),
            root: Scalars::all(zero),
            unit: zero,
            least: zero,
            rate: zero,
        }
    }

    /// Prepares a lane for another body.
    pub(super) fn set(&mut self, lane: usize) {
        self.rate.put(lane, 0.0);
    }

    #[inline(always)]
    pub(super) fn start(&mut self, time: N) {
        self.leads.clear();
        self.waiting = all_lanes::<N>();
        self.least = time.zip(self.rate, |time, rate| LEAST.max(CLOSEST * time.abs() * rate));
        self.square[1] = time.like(0.0);
    }

    /// Returns the longest step for which the series is valid, s.
    #[inline(always)]
    pub(super) fn reach(&self, endless: N) -> N {
        // u · u = a (τ − t)² near a corner, so τ = −2 (u · u)₀/(u · u)₁
        let mut reach = self.square[0].zip(self.square[1], |square, slope| {
            if slope < 0.0 { REACH * -2.0 * square / slope } else { f64::INFINITY }
        });
        exchange(&mut reach, endless, self.waiting);
        reach
    }

    /// Returns coefficient n of |v|.
    #[inline(always)]
    pub(super) fn coefficient(&mut self, n: usize, v: &Series<N>) -> N {
        let v = &v[..=n];
        if n == 1 {
            self.rate = v[1].largest();
        }
        if self.waiting != 0 {
            self.look_for_lead(n, v[n]);
        }
        let over = Row::splat(self.unit.like(1.0) / self.unit);
        let mut norm = self.unit.like(0.0);
        for &(lead, lanes) in &self.leads {
            // (u · u)ⱼ, where j = n − m
            let (u, j) = (&v[lead..], n - lead);
            let none = Row::splat(self.unit.like(0.0));
            let dots = u.iter().zip(u.iter().rev()).fold(none, |sum, (&a, &b)| sum + (a * over) * (b * over));
            let [x, y, z, _] = dots.0;
            exchange(&mut self.square[j], x + y + z, lanes);
            let root = if j == 0 {
                self.square[0].map(f64::sqrt)
            } else {
                scalar::power(&self.square, 0.5, &self.root, j)
            };
            exchange(&mut self.root[j], root, lanes);
            // |v|ₙ = |u|ₙ₋ₘ
            exchange(&mut norm, self.root[j] * self.unit, lanes);
        }
        norm
    }

    /// Finds the lanes in which coefficient n of v is the first nonzero one. Not inlined: it is
    /// rarely called, and the loop over n is long enough.
    #[inline(never)]
    fn look_for_lead(&mut self, n: usize, v: Row<N>) {
        let size = v.largest();
        let is_first = |lane: &usize| {
            let least = if n == 0 { self.least.lane(*lane) } else { LEAST };
            self.waiting >> lane & 1 == 1 && size.lane(*lane) > least
        };
        let lanes = (0..N::LANES).filter(is_first).fold(0, |lanes, lane| lanes | 1 << lane);
        if lanes != 0 {
            let [x, y, z, _] = v.0;
            exchange(&mut self.unit, (x * x + y * y + z * z).map(f64::sqrt), lanes);
            self.leads.push((n, lanes));
            self.waiting &= !lanes;
        }
    }
}

/// Returns a bit mask of all lanes.
fn all_lanes<N: Number>() -> u8 {
    u8::MAX >> (8 - N::LANES)
}

/// Replaces the numbers of the given lanes.
#[inline(always)]
fn exchange<N: Number>(old: &mut N, new: N, lanes: u8) {
    if lanes == all_lanes::<N>() {
        *old = new;
        return;
    }
    for lane in (0..N::LANES).filter(|lane| lanes >> lane & 1 == 1) {
        old.put(lane, new.lane(lane));
    }
}
