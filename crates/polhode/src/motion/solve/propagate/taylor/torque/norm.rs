//! The series of the magnitude of a vector, such as |ω| of quadratic drag: the root of v · v.
//!
//! It has one where v starts from zero too: v = tᵐ u with u ≠ 0 at the start has |v| = tᵐ |u| for the times that follow.
//!
//! |v| has a corner where v passes through zero, and the series from before goes on as if it had none. So no step goes further than nine
//! tenths of the way to where v would vanish (`reach`). Some fifteen steps later v is what it changes in a few roundings of the time: then
//! it is taken as zero for |v|, from where the series beyond the corner starts.

use super::super::row::{Row, Series};
use super::super::scalar::{self, Scalars};
use crate::math::number::Number;

/// v is zero, if it changes by itself in as many roundings of the time.
const CLOSEST: f64 = 16.0 * f64::EPSILON;

/// How much of the way to a corner a step may go.
const REACH: f64 = 0.9;

/// v below this is zero: its square is no double.
const LEAST: f64 = 1e-150;

/// The series of |v|.
#[derive(Clone, Debug)]
pub(super) struct NormSeries<N> {
    /// m, the first coefficient of v that is not zero, and the lanes where it is, a bit for each. Almost always 0 in all lanes.
    leads: Vec<(usize, u8)>,
    /// The lanes where m is not known yet.
    waiting: u8,
    /// u · u and |u|, u = v/tᵐ, both without their unit.
    square: Scalars<N>,
    root: Scalars<N>,
    /// |u| at the start, which the others are over.
    unit: N,
    /// |v| up to here is zero.
    least: N,
    /// |v̇| where the step before this one began.
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

    /// A lane has another body.
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

    /// The longest step that the series is good for, s.
    #[inline(always)]
    pub(super) fn reach(&self, endless: N) -> N {
        // u · u = a (τ − t)² near a corner: τ = −2 (u · u)₀/(u · u)₁
        let mut reach = self.square[0].zip(self.square[1], |square, slope| {
            if slope < 0.0 { REACH * -2.0 * square / slope } else { f64::INFINITY }
        });
        exchange(&mut reach, endless, self.waiting);
        reach
    }

    /// Coefficient n of |v|.
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
            // (u · u)ⱼ, j = n − m
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

    /// Is coefficient n of v the first that is not zero? Not inlined: it is seldom asked, and the loop over n is long enough.
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

/// A bit for each lane.
fn all_lanes<N: Number>() -> u8 {
    u8::MAX >> (8 - N::LANES)
}

/// Puts new numbers into these lanes.
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
