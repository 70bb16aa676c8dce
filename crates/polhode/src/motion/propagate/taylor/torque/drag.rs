//! The series of drag.
//!
//! Linear drag, N = −C ω, is affine (`affine.rs`). Quadratic drag is −s D ω with s = |ω|, whose series is that of the root of ω · ω. It has
//! one from rest too: ω = tᵐ v with v ≠ 0 at the start has s = tᵐ |v| for the times that follow.
//!
//! |ω| has a corner where ω passes through zero, and the series from before goes on as if it had none. So no step goes further than nine
//! tenths of the way to where ω would vanish (`reach`). Some fifteen steps later ω is what it changes in a few roundings of the time: then
//! it is taken as rest for |ω|, from where the series beyond the corner starts.

use super::super::row::{Row, TERMS};
use super::super::scalar::{self, Scalars};
use super::super::sums::Sums;
use super::linear::{cleaned, times};
use super::{Known, StepStart};
use crate::math::number::Number;
use crate::motion::rotor::Rotor;
use crate::motion::torque::Drag;

/// ω is at rest, if it changes by itself in as many roundings of the time.
const CLOSEST: f64 = 16.0 * f64::EPSILON;

/// How much of the way to a corner a step may go.
const REACH: f64 = 0.9;

/// ω below this (rad/s) is rest: its square is no double.
const REST: f64 = 1e-150;

/// The series of quadratic drag.
#[derive(Clone, Debug)]
pub(in super::super) struct DragSeries<N> {
    /// Columns of −D, principal axes.
    columns: [Row<N>; 3],
    speed: Speed<N>,
}

/// The series of |ω|.
#[derive(Clone, Debug)]
struct Speed<N> {
    /// −D ω
    bent: [Row<N>; TERMS],
    /// m, the first coefficient of ω that is not zero, and the lanes where it is, a bit for each. Almost always 0 in all lanes.
    leads: Vec<(usize, u8)>,
    /// The lanes where m is not known yet.
    waiting: u8,
    /// v · v and |v|, v = ω/tᵐ, both without their unit.
    square: Scalars<N>,
    root: Scalars<N>,
    /// |v| at the start, which the others are over.
    unit: N,
    /// |ω| up to here is rest.
    rest: N,
    /// |ω̇| where the step before this one began.
    rate: N,
}

/// Columns of −C or −D, principal axes.
pub(super) fn columns(model: &Drag, rotor: &Rotor) -> [Row; 3] {
    // Rᵀ C R, and C is symmetric: its columns are its rows.
    let columns = model.matrix_along(&rotor.principal().rotation().inverse().matrix());
    cleaned(columns, rotor).map(|column| Row::ZERO - column)
}

impl<N: Number> DragSeries<N> {
    pub(super) fn all(zero: N) -> Self {
        Self { columns: [Row::splat(zero); 3], speed: Speed::all(zero) }
    }

    pub(super) fn set(&mut self, lane: usize, model: &Drag, rotor: &Rotor) {
        for (place, column) in self.columns.iter_mut().zip(columns(model, rotor)) {
            place.put(lane, column);
        }
        self.speed.rate.put(lane, 0.0);
    }

    #[inline(always)]
    pub(super) fn start(&mut self, at: &StepStart<N>) {
        let speed = &mut self.speed;
        speed.leads.clear();
        speed.waiting = all_lanes::<N>();
        speed.rest = at.time.zip(speed.rate, |time, rate| REST.max(CLOSEST * time.abs() * rate));
        speed.square[1] = at.time.like(0.0);
    }

    /// The longest step that the series is good for, s.
    #[inline(always)]
    pub(super) fn reach(&self, endless: N) -> N {
        let speed = &self.speed;
        // v · v = a (τ − t)² near a corner: τ = −2 (v · v)₀/(v · v)₁
        let mut reach = speed.square[0].zip(speed.square[1], |square, slope| {
            if slope < 0.0 { REACH * -2.0 * square / slope } else { f64::INFINITY }
        });
        exchange(&mut reach, endless, speed.waiting);
        reach
    }

    #[inline(always)]
    pub(super) fn coefficient<M: Sums<N = N>>(&mut self, n: usize, known: &Known<'_, M>) -> Row<N> {
        let bent = times(&self.columns, known.omega.rows[n]);
        self.speed.times(n, known, bent)
    }
}

impl<N: Number> Speed<N> {
    fn all(zero: N) -> Self {
        Self {
            bent: [Row::splat(zero); TERMS],
            leads: Vec::new(),
            waiting: all_lanes::<N>(),
            square: [zero; TERMS],
            root: [zero; TERMS],
            unit: zero,
            rest: zero,
            rate: zero,
        }
    }

    /// Coefficient n of −|ω| D ω; `bent` is that of −D ω.
    #[inline(always)]
    fn times<M: Sums<N = N>>(&mut self, n: usize, known: &Known<'_, M>, bent: Row<N>) -> Row<N> {
        self.bent[n] = bent;
        let omega = &known.omega.rows[..=n];
        if n == 1 {
            self.rate = omega[1].largest();
        }
        if self.waiting != 0 {
            self.look_for_lead(n, omega[n]);
        }
        let none = Row::splat(bent.0[0].like(0.0));
        let over = Row::splat(self.unit.like(1.0) / self.unit);
        let mut torque = none;
        for &(lead, lanes) in &self.leads {
            // (v · v)ⱼ, j = n − m
            let (v, j) = (&omega[lead..], n - lead);
            let dots = v.iter().zip(v.iter().rev()).fold(none, |sum, (&a, &b)| sum + (a * over) * (b * over));
            let [x, y, z, _] = dots.0;
            exchange(&mut self.square[j], x + y + z, lanes);
            let root = if j == 0 {
                self.square[0].map(f64::sqrt)
            } else {
                scalar::power(&self.square, 0.5, &self.root, j)
            };
            exchange(&mut self.root[j], root, lanes);
            // sₙ = |v|ₙ₋ₘ: (s D ω)ₙ = Σ |v|ₖ (D ω)ₙ₋ₘ₋ₖ
            let roots = self.root[..=j].iter();
            let sum =
                roots.zip(self.bent[..=j].iter().rev()).fold(none, |sum, (&s, &b)| sum + Row::splat(s) * b);
            for (place, sum) in torque.0.iter_mut().zip((sum * Row::splat(self.unit)).0) {
                exchange(place, sum, lanes);
            }
        }
        torque
    }

    /// Is coefficient n of ω the first that is not zero? Not inlined: it is seldom asked, and the loop over n is long enough.
    #[inline(never)]
    fn look_for_lead(&mut self, n: usize, omega: Row<N>) {
        let size = omega.largest();
        let is_first = |lane: &usize| {
            let least = if n == 0 { self.rest.lane(*lane) } else { REST };
            self.waiting >> lane & 1 == 1 && size.lane(*lane) > least
        };
        let lanes = (0..N::LANES).filter(is_first).fold(0, |lanes, lane| lanes | 1 << lane);
        if lanes != 0 {
            let [x, y, z, _] = omega.0;
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
