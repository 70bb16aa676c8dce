//! The series of a torsion spring or wire.
//!
//! The turn from rest, p = (w, v), is linear in the turn since the start of the step. In the names of
//! [`Torsion`](crate::motion::torque::Torsion), along principal axes:
//!
//! - a spring has N = −2 κ f(w) v, f = arccos w/√(1 − w²): smooth through rest, w = 1, where the differential equations of f divide
//!   by zero. So f(w) is composed from its own Taylor coefficients at the w that the step starts from;
//! - a wire has N = −κ ψ b, and ψ̇ = b · Ω gives its twist.

use super::super::row::{Row, Series, TERMS, Vectors};
use super::super::scalar::{self, Composition, Scalars};
use super::super::sums::Sums;
use super::{Known, StepStart, row};
use crate::math::frame::{Principal, Space};
use crate::math::number::Number;
use crate::math::rotation::Rotation;
use crate::math::vector::Direction;
use crate::motion::rotor::Rotor;
use crate::motion::torque::{Torsion, half_angle_over_sine};

/// The series of a torsion spring or wire.
#[derive(Clone, Debug)]
pub(in super::super) struct TorsionSeries<N> {
    stiffness: N,
    /// The attitude at rest, of each lane.
    rest: Vec<Rotation<Space, Principal>>,
    /// p at the start of the step.
    start: Row<N>,
    /// Those of p.
    w: Scalars<N>,
    v: Vectors<N>,
    law: Law<N>,
}

#[derive(Clone, Debug)]
enum Law<N> {
    Spring(Box<Spring<N>>),
    Wire(Box<Wire<N>>),
}

#[derive(Clone, Debug)]
struct Spring<N> {
    /// f(w)
    f: Composition<N>,
}

#[derive(Clone, Debug)]
struct Wire<N> {
    /// ê in the axes of the body at rest.
    axis: Row<N>,
    /// ê × v
    across: [Row<N>; TERMS],
    /// s = v · ê
    s: Scalars<N>,
    /// d = w² + s²
    square: Scalars<N>,
    /// b = (w² ê + w ê × v + s v)/d
    b: Series<N>,
    twist: Scalars<N>,
}

impl<N: Number> TorsionSeries<N> {
    pub(super) fn of(zero: N, model: &Torsion) -> Self {
        let law = match model.axis() {
            None => Law::Spring(Box::new(Spring { f: Composition::all(zero) })),
            Some(_) => Law::Wire(Box::new(Wire::all(zero))),
        };
        Self {
            stiffness: zero,
            rest: vec![Rotation::identity(); N::LANES],
            start: Row::splat(zero),
            w: [zero; TERMS],
            v: Vectors::all(zero),
            law,
        }
    }

    pub(super) fn set(&mut self, lane: usize, model: &Torsion, rotor: &Rotor) {
        let rest = model.rest() * rotor.principal().rotation();
        self.stiffness.put(lane, model.stiffness());
        self.rest[lane] = rest;
        if let (Law::Wire(wire), Some(axis)) = (&mut self.law, model.axis()) {
            wire.axis.put(lane, row(rest.inverse() * axis));
        }
    }

    pub(super) fn start(&mut self, at: &StepStart<N>) {
        for (lane, rest) in self.rest.iter().enumerate() {
            let (_, attitude) = at.lane(lane);
            let turn: Rotation<Principal, Principal> = rest.inverse() * attitude;
            let start @ [w, x, y, z] = turn.canonical_quaternion();
            self.start.put(lane, Row(start));
            let sine = Direction::<Principal>::new(x, y, z).norm();
            match &mut self.law {
                Law::Spring(spring) => spring.f.start(lane, half_angle_over_sine(w, sine), w, sine),
                Law::Wire(wire) => wire.start(lane, w, Row([x, y, z, 0.0])),
            }
        }
    }

    #[inline(always)]
    pub(super) fn coefficient<M: Sums<N = N>>(&mut self, n: usize, known: &Known<'_, M>) -> Row<N> {
        // p = p₀ ∘ turn
        let ([w, x, y, z], [a, b, c, d]) = (self.start.0, known.turn(n).0);
        self.w[n] = w * a - x * b - y * c - z * d;
        let v = [w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a];
        self.v.set(n, Row([v[0], v[1], v[2], w.like(0.0)]));
        let lever = match &mut self.law {
            Law::Spring(spring) => spring.coefficient(n, &self.w, &self.v),
            Law::Wire(wire) => wire.coefficient(n, &self.w, &self.v, known),
        };
        lever * Row::splat(-self.stiffness)
    }
}

impl<N: Number> Spring<N> {
    /// 2 f(w) v
    #[inline(always)]
    fn coefficient(&mut self, n: usize, w: &Scalars<N>, v: &Vectors<N>) -> Row<N> {
        self.f.extend(w, n);
        scaled(self.f.series(), &v.rows, n) * Row::splat(w[0].like(2.0))
    }
}

impl<N: Number> Wire<N> {
    fn all(zero: N) -> Self {
        Self {
            axis: Row::splat(zero),
            across: [Row::splat(zero); TERMS],
            s: [zero; TERMS],
            square: [zero; TERMS],
            b: Series::all(zero),
            twist: [zero; TERMS],
        }
    }

    fn start(&mut self, lane: usize, w: f64, v: Row) {
        self.twist[0].put(lane, 2.0 * libm::atan2(dot(v, self.axis.lane(lane)), w));
    }

    /// ψ b
    #[inline(always)]
    fn coefficient<M: Sums<N = N>>(
        &mut self,
        n: usize,
        w: &Scalars<N>,
        v: &Vectors<N>,
        known: &Known<'_, M>,
    ) -> Row<N> {
        let [e1, e2, e3, zero] = self.axis.0;
        let [x, y, z, _] = v.rows[n].0;
        self.s[n] = e1 * x + e2 * y + e3 * z;
        self.across[n] = Row([e2 * z - e3 * y, e3 * x - e1 * z, e1 * y - e2 * x, zero]);
        let square = scalar::product(w, w, n);
        self.square[n] = square + scalar::product(&self.s, &self.s, n);
        let over =
            self.axis * Row::splat(square) + (scaled(w, &self.across, n) + scaled(&self.s, &v.rows, n));
        // d b = over: bₙ = (overₙ − Σ_{k≥1} dₖ bₙ₋ₖ)/d₀
        let known_part = self.square[1..=n].iter().zip(self.b[..n].iter().rev());
        let rest = known_part.fold(over, |rest, (&d, &b)| rest - Row::splat(d) * b);
        // Turned over, across its axis, a body has no twist.
        let over_square = self.square[0].map(|square| if square == 0.0 { 0.0 } else { 1.0 / square });
        self.b.set(n, rest * Row::splat(over_square));
        let torque = scaled(&self.twist, &self.b, n);
        if let Some(next) = self.twist.get_mut(n + 1) {
            let [x, y, z, _] = known.s.product(&self.b, &known.turning.rows, n).0;
            *next = (x + y + z) / x.like((n + 1) as f64);
        }
        torque
    }
}

/// Coefficient n of a v.
#[inline(always)]
fn scaled<N: Number>(a: &Scalars<N>, v: &[Row<N>], n: usize) -> Row<N> {
    let none = Row::splat(a[0].like(0.0));
    a[..=n].iter().zip(v[..=n].iter().rev()).fold(none, |sum, (&a, &v)| sum + Row::splat(a) * v)
}

fn dot(a: Row, b: Row) -> f64 {
    let [x, y, z, _] = (a * b).0;
    x + y + z
}
