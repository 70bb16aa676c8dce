//! The series of a torsion spring or wire.
//!
//! The turn from rest, p = (w, v), is linear in the turn since the start of the step. In the names of
//! [`Torsion`](crate::motion::torque::Torsion), along principal axes:
//!
//! - a spring has N = −2 κ f(w) v, f = arccos w/√(1 − w²): smooth through rest, w = 1, where the differential equations of f divide
//!   by zero. So f(w) is composed from its own Taylor coefficients at the w that the step starts from;
//! - a wire has N = −κ ψ b, and ψ̇ = b · Ω gives its twist.

use super::super::row::{Row, Series, TERMS, Vectors, product};
use super::super::scalar::{self, Composition, Scalars};
use super::{Known, StepStart, row};
use crate::math::frame::{Principal, Space};
use crate::math::lanes::Fours;
use crate::math::rotation::Rotation;
use crate::math::vector::Direction;
use crate::motion::rotor::Rotor;
use crate::motion::torque::{Torsion, half_angle_over_sine};

/// The series of a torsion spring or wire.
#[derive(Clone, Debug)]
pub(in super::super) struct TorsionSeries {
    stiffness: f64,
    rest: Rotation<Space, Principal>,
    /// p at the start of the step.
    start: [f64; 4],
    /// Those of p.
    w: Scalars,
    v: Vectors,
    law: Law,
}

#[derive(Clone, Debug)]
enum Law {
    Spring(Box<Spring>),
    Wire(Box<Wire>),
}

#[derive(Clone, Debug)]
struct Spring {
    /// f(w)
    f: Composition,
}

#[derive(Clone, Debug)]
struct Wire {
    /// ê in the axes of the body at rest.
    axis: Row,
    /// ê × v
    across: [Row; TERMS],
    /// s = v · ê
    s: Scalars,
    /// d = w² + s²
    square: Scalars,
    /// b = (w² ê + w ê × v + s v)/d
    b: Series,
    twist: Scalars,
}

impl TorsionSeries {
    pub(super) fn of(model: &Torsion, rotor: &Rotor) -> Self {
        let rest = model.rest() * rotor.principal().rotation();
        let law = match model.axis() {
            None => Law::Spring(Box::new(Spring { f: Composition::none() })),
            Some(axis) => Law::Wire(Box::new(Wire::along(rest.inverse() * axis))),
        };
        Self { stiffness: model.stiffness(), rest, start: [0.0; 4], w: [0.0; TERMS], v: Vectors::ZERO, law }
    }

    pub(super) fn start(&mut self, at: &StepStart) {
        let turn: Rotation<Principal, Principal> = self.rest.inverse() * at.attitude;
        self.start = turn.canonical_quaternion();
        let [w, x, y, z] = self.start;
        let sine = Direction::<Principal>::new(x, y, z).norm();
        match &mut self.law {
            Law::Spring(spring) => spring.f.start(half_angle_over_sine(w, sine), w, sine),
            Law::Wire(wire) => wire.start(w, Row([x, y, z, 0.0])),
        }
    }

    #[inline(never)]
    pub(super) fn coefficient<S: Fours>(&mut self, n: usize, known: &Known<'_, S>) -> Row {
        // p = p₀ ∘ turn
        let ([w, x, y, z], [a, b, c, d]) = (self.start, known.turn[n].0);
        self.w[n] = w * a - x * b - y * c - z * d;
        let v = [w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a];
        self.v.set(n, Row([v[0], v[1], v[2], 0.0]));
        let lever = match &mut self.law {
            Law::Spring(spring) => spring.coefficient(n, &self.w, &self.v),
            Law::Wire(wire) => wire.coefficient(n, &self.w, &self.v, known),
        };
        lever * Row::splat(-self.stiffness)
    }
}

impl Spring {
    /// 2 f(w) v
    #[inline(always)]
    fn coefficient(&mut self, n: usize, w: &Scalars, v: &Vectors) -> Row {
        self.f.extend(w, n);
        scaled(self.f.series(), &v.rows, n) * Row::splat(2.0)
    }
}

impl Wire {
    fn along(axis: Direction<Principal>) -> Self {
        Self {
            axis: row(axis),
            across: [Row::ZERO; TERMS],
            s: [0.0; TERMS],
            square: [0.0; TERMS],
            b: Series::ZERO,
            twist: [0.0; TERMS],
        }
    }

    fn start(&mut self, w: f64, v: Row) {
        self.twist[0] = 2.0 * libm::atan2(dot(v, self.axis), w);
    }

    /// ψ b
    #[inline(always)]
    fn coefficient<S: Fours>(&mut self, n: usize, w: &Scalars, v: &Vectors, known: &Known<'_, S>) -> Row {
        let [e1, e2, e3, _] = self.axis.0;
        let [x, y, z, _] = v.rows[n].0;
        self.s[n] = e1 * x + e2 * y + e3 * z;
        self.across[n] = Row([e2 * z - e3 * y, e3 * x - e1 * z, e1 * y - e2 * x, 0.0]);
        let square = scalar::product(w, w, n);
        self.square[n] = square + scalar::product(&self.s, &self.s, n);
        let over =
            self.axis * Row::splat(square) + (scaled(w, &self.across, n) + scaled(&self.s, &v.rows, n));
        // d b = over: bₙ = (overₙ − Σ_{k≥1} dₖ bₙ₋ₖ)/d₀
        let known_part = self.square[1..=n].iter().zip(self.b[..n].iter().rev());
        let rest = known_part.fold(over, |rest, (&d, &b)| rest - Row::splat(d) * b);
        // Turned over, across its axis, a body has no twist.
        let over_square = if self.square[0] == 0.0 { 0.0 } else { 1.0 / self.square[0] };
        self.b.set(n, rest * Row::splat(over_square));
        let torque = scaled(&self.twist, &self.b, n);
        if let Some(next) = self.twist.get_mut(n + 1) {
            let [x, y, z, _] = product(known.s, &self.b, &known.turning.rows, n).0;
            *next = (x + y + z) / (n + 1) as f64;
        }
        torque
    }
}

/// Coefficient n of a v.
#[inline(always)]
fn scaled(a: &Scalars, v: &[Row], n: usize) -> Row {
    a[..=n].iter().zip(v[..=n].iter().rev()).fold(Row::ZERO, |sum, (&a, &v)| sum + Row::splat(a) * v)
}

fn dot(a: Row, b: Row) -> f64 {
    let [x, y, z, _] = (a * b).0;
    x + y + z
}
