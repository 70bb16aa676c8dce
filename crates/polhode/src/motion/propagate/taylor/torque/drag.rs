//! The series of drag.
//!
//! N = −C ω, or −s D ω with s = |ω|, whose series is that of the root of ω · ω. It has one from rest too: ω = tᵐ v with v ≠ 0 at the
//! start has s = tᵐ |v| for the times that follow.
//!
//! |ω| is not smooth where ω passes through zero, and close to there the steps of its series would shrink to nothing. So with
//! s = √(ω · ω + δ²), δ is what ω changes in 2¹⁰ roundings of the time: closer than that no step can come. The torque is wrong by less
//! than ½ |D| δ², which is nothing beside the rounding of |D| ω² elsewhere; a body that just slows down has δ < 1e-12 |ω|.

use super::super::row::{Row, TERMS};
use super::super::scalar::{self, Scalars};
use super::linear::cleaned;
use super::{Known, StepStart};
use crate::motion::rotor::Rotor;
use crate::motion::torque::{Drag, DragLaw};

/// δ over what ω changes while the time grows by itself: 2¹⁰ roundings.
const CLOSEST: f64 = 1024.0 * f64::EPSILON;

/// ω below this (rad/s) is rest: its square is no double.
const REST: f64 = 1e-150;

/// The series of drag.
#[derive(Clone, Debug)]
pub(in super::super) struct DragSeries {
    /// Columns of −C or −D, principal axes.
    columns: [Row; 3],
    speed: Option<Box<Speed>>,
}

/// The series of |ω|.
#[derive(Clone, Debug)]
struct Speed {
    /// −D ω
    bent: [Row; TERMS],
    /// m, once it is known: the first coefficient of ω that is not zero.
    lead: Option<usize>,
    /// v · v + δ² and its root, v = ω/tᵐ, both without their unit.
    square: Scalars,
    root: Scalars,
    /// The greater of |v| at the start and δ, which the others are over.
    unit: f64,
    delta: f64,
    /// |ω̇| where the step before this one began.
    rate: f64,
}

impl DragSeries {
    pub(super) fn of(model: &Drag, rotor: &Rotor) -> Self {
        // Rᵀ C R, and C is symmetric: its columns are its rows.
        let columns = model.matrix_along(&rotor.principal().rotation().inverse().matrix());
        let speed = match model.law() {
            DragLaw::Linear => None,
            DragLaw::Quadratic => Some(Box::new(Speed::NONE)),
        };
        Self { columns: cleaned(columns, rotor).map(|column| Row::ZERO - column), speed }
    }

    pub(super) fn start(&mut self, at: &StepStart) {
        if let Some(speed) = &mut self.speed {
            speed.lead = None;
            speed.delta = CLOSEST * at.time.abs() * speed.rate;
            speed.rate = 0.0;
        }
    }

    #[inline(always)]
    pub(super) fn coefficient(&mut self, n: usize, known: &Known<'_>) -> Row {
        let [x, y, z, _] = known.omega.rows[n].0;
        let [a, b, c] = self.columns;
        let bent = a * Row::splat(x) + (b * Row::splat(y) + c * Row::splat(z));
        match &mut self.speed {
            None => bent,
            Some(speed) => speed.times(n, known, bent),
        }
    }
}

impl Speed {
    const NONE: Self = Self {
        bent: [Row::ZERO; TERMS],
        lead: None,
        square: [0.0; TERMS],
        root: [0.0; TERMS],
        unit: 0.0,
        delta: 0.0,
        rate: 0.0,
    };

    /// Coefficient n of −|ω| D ω; `bent` is that of −D ω.
    #[inline(always)]
    fn times(&mut self, n: usize, known: &Known<'_>, bent: Row) -> Row {
        self.bent[n] = bent;
        let omega = &known.omega.rows[..=n];
        if n == 1 {
            self.rate = omega[1].largest();
        }
        if self.lead.is_none() && omega[n].largest() > REST {
            self.lead = Some(n);
            let [x, y, z, _] = omega[n].0;
            self.delta = if n == 0 { self.delta } else { 0.0 };
            self.unit = (x * x + y * y + z * z).sqrt().max(self.delta);
        }
        let Some(lead) = self.lead else { return Row::ZERO };
        // (v · v)ⱼ, j = n − m
        let (v, j) = (&omega[lead..], n - lead);
        let over = 1.0 / self.unit;
        let dots = v
            .iter()
            .zip(v.iter().rev())
            .fold(Row::ZERO, |sum, (&a, &b)| sum + (a * Row::splat(over)) * (b * Row::splat(over)));
        let [x, y, z, _] = dots.0;
        self.square[j] = x + y + z;
        if j == 0 {
            let delta = self.delta * over;
            self.square[0] += delta * delta;
            self.root[0] = self.square[0].sqrt();
        } else {
            self.root[j] = scalar::power(&self.square, 0.5, &self.root, j);
        }
        // sₙ = |v|ₙ₋ₘ: (s D ω)ₙ = Σ |v|ₖ (D ω)ₙ₋ₘ₋ₖ
        let roots = self.root[..=j].iter();
        let sum =
            roots.zip(self.bent[..=j].iter().rev()).fold(Row::ZERO, |sum, (&s, &b)| sum + Row::splat(s) * b);
        sum * Row::splat(self.unit)
    }
}
