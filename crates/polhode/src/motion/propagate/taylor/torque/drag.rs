//! The series of drag.
//!
//! N = −C ω, or −s D ω with s = |ω|, whose series is that of the root of ω · ω. It has one from rest too: ω = tᵐ v with v ≠ 0 at the
//! start has s = tᵐ |v| for the times that follow.
//!
//! |ω| has a corner where ω passes through zero, and the series from before goes on as if it had none. So no step goes further than nine
//! tenths of the way to where ω would vanish (`reach`). Some fifteen steps later ω is what it changes in a few roundings of the time: then
//! it is taken as rest for |ω|, from where the series beyond the corner starts.

use super::super::row::{Row, TERMS};
use super::super::scalar::{self, Scalars};
use super::linear::cleaned;
use super::{Known, StepStart};
use crate::motion::rotor::Rotor;
use crate::motion::torque::{Drag, DragLaw};

/// ω is at rest, if it changes by itself in as many roundings of the time.
const CLOSEST: f64 = 16.0 * f64::EPSILON;

/// How much of the way to a corner a step may go.
const REACH: f64 = 0.9;

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
    /// v · v and |v|, v = ω/tᵐ, both without their unit.
    square: Scalars,
    root: Scalars,
    /// |v| at the start, which the others are over.
    unit: f64,
    /// |ω| up to here is rest.
    rest: f64,
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
            speed.rest = REST.max(CLOSEST * at.time.abs() * speed.rate);
            speed.square[1] = 0.0;
        }
    }

    /// The longest step that the series is good for, s.
    pub(super) fn reach(&self) -> f64 {
        match &self.speed {
            // v · v = a (τ − t)² near a corner: τ = −2 (v · v)₀/(v · v)₁
            Some(speed) if speed.lead.is_some() && speed.square[1] < 0.0 => {
                REACH * -2.0 * speed.square[0] / speed.square[1]
            }
            _ => f64::INFINITY,
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
        rest: REST,
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
        if self.lead.is_none() && omega[n].largest() > if n == 0 { self.rest } else { REST } {
            self.lead = Some(n);
            let [x, y, z, _] = omega[n].0;
            self.unit = (x * x + y * y + z * z).sqrt();
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
