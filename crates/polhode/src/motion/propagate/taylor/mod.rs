//! Taylor's method: the motion of a step as a power series in time, from the equations themselves.
//!
//! Coefficient n + 1 of every unknown follows from the coefficients up to n, as the equations have only products in
//! them. In principal axes, with q the turn since the start of the step,
//!
//! i1 ω̇1 = (i2 − i3) ω2 ω3 + N1 …,  q̇ = ½ q ∘ ω,  K̇ = N + K × ω,  Ẇ = N · ω
//!
//! K is the angular impulse ∫ N dt as the turning body sees it, W the work: the evidence. The same series is the dense output.
//!
//! Source: À. Jorba, M. Zou, Exp. Math. 14 (2005) 99: order and step.

mod row;
mod stepper;
mod torque;
mod turn;

pub(super) use stepper::Taylor;

use row::{Row, Series, TERMS, Vectors, increment, product};
use torque::{TorqueSeries, row};
use turn::Turn;

use super::super::rotor::Rotor;
use super::super::torque::TorqueModel;
use crate::math::frame::{Principal, Space};
use crate::math::lanes::in_widest_vectors;
use crate::math::rotation::Rotation;
use crate::math::vector::AngularVelocity;

/// The series of everything over one step.
#[derive(Clone, Debug)]
struct Expansion {
    /// (i2 − i3)/i1 …
    ratios: Row,
    /// 1/i; zero along an axis without inertia.
    inverses: Row,
    torques: Vec<TorqueSeries>,
    omega: Vectors,
    turn: Turn,
    torque: Series,
    /// (K, W)
    impulse: Vectors,
    work: [f64; TERMS],
    order: usize,
}

/// What a step adds, after so much time.
#[derive(Clone, Copy, Debug)]
struct Increment {
    /// Of ω, principal axes.
    omega: [f64; 3],
    /// The turn less the identity: (w − 1, x, y, z).
    turn: [f64; 4],
    /// ∫ N dt since the start of the step, along the principal axes at its end.
    impulse: [f64; 3],
    work: f64,
}

impl Expansion {
    fn new(rotor: &Rotor, torques: &[TorqueModel], tolerance: f64) -> Self {
        let [i1, i2, i3] = rotor.principal().moments();
        let over = |numerator: f64, i: f64| if i == 0.0 { 0.0 } else { numerator / i };
        // Jorba & Zou, eq. 3-5: the order that makes a step of given error cheapest.
        let order = (1.0 - 0.5 * tolerance.ln()).ceil() as usize;
        Self {
            ratios: Row([over(i2 - i3, i1), over(i3 - i1, i2), over(i1 - i2, i3), 0.0]),
            inverses: Row([over(1.0, i1), over(1.0, i2), over(1.0, i3), 0.0]),
            torques: torques.iter().map(|torque| TorqueSeries::of(torque, rotor)).collect(),
            omega: Vectors::ZERO,
            turn: Turn::NONE,
            torque: [Row::ZERO; TERMS],
            impulse: Vectors::ZERO,
            work: [0.0; TERMS],
            order: order.clamp(4, TERMS - 1),
        }
    }

    /// The torque along an axis without inertia; only a rod has one, and it is the first.
    fn unbalanced(&self) -> Option<f64> {
        let ([inverse, ..], [torque, ..]) = (self.inverses.0, self.torque[0].0);
        (inverse == 0.0 && torque != 0.0).then_some(torque)
    }

    const fn order(&self) -> usize {
        self.order
    }

    /// Expands the motion about a state.
    fn expand(&mut self, attitude: Rotation<Space, Principal>, omega: AngularVelocity<Principal>) {
        for torque in &mut self.torques {
            torque.start(attitude);
        }
        self.omega.set(0, row(omega));
        self.turn.set(0, Row([1.0, 0.0, 0.0, 0.0]));
        in_widest_vectors(
            #[inline(always)]
            || {
                for n in 0..self.order {
                    self.extend(n);
                }
            },
        );
    }

    #[inline(always)]
    fn extend(&mut self, n: usize) {
        let over = Row::splat(1.0 / (n + 1) as f64);
        let mut rate = self.ratios * self.omega.others(n);
        self.turn.set_omega(n, self.omega.rows[n]);
        if !self.torques.is_empty() {
            let mut torque = Row::ZERO;
            for series in &self.torques {
                torque = torque + series.coefficient(n);
            }
            self.torque[n] = torque;
            rate = rate + self.inverses * torque;
            for series in &mut self.torques {
                series.extend(n, &self.omega);
            }
            let impulse = (torque + self.impulse.cross(&self.omega, n)) * over;
            self.impulse.set(n + 1, impulse);
            let [x, y, z, w] = (product(&self.torque, &self.omega.rows, n) * over).0;
            self.work[n + 1] = (x + y) + (z + w);
        }
        let turn = self.turn.twice_rate(n) * over * Row::splat(0.5);
        self.turn.set(n + 1, turn);
        self.omega.set(n + 1, rate * over);
    }

    /// The longest step whose last terms are as small as the order allows; `scale` is what ω is measured with.
    ///
    /// h = min (1/|xₚ|^(1/p), 1/|xₚ₋₁|^(1/(p−1))) e^(−0.7/(p−1)) / e²  (Jorba & Zou, eq. 3-8, with the safety of 3.3.1)
    fn step(&self, scale: f64) -> f64 {
        let p = self.order;
        let size = |n: usize| {
            let omega = self.omega.rows[n].largest();
            let omega = if omega == 0.0 { 0.0 } else { omega / scale };
            omega.max(self.turn.rows[n].largest())
        };
        // log₂ of a radius: digits beyond the sixth do not matter.
        let radius = |n: usize| {
            let (mantissa, exponent) = libm::frexp(size(n));
            -(f64::from(libm::log2f(mantissa as f32)) + f64::from(exponent)) / n as f64
        };
        let safety = -2.0 - 0.7 / (p - 1) as f64;
        libm::exp2(radius(p).min(radius(p - 1)) + safety * core::f64::consts::LOG2_E)
    }

    /// What the motion adds until a time after the start.
    fn at(&self, h: f64) -> Increment {
        let p = self.order;
        let [x, y, z, _] = increment(&self.omega.rows, p, h).0;
        let turn = increment(&self.turn.rows, p, h).0;
        if self.torques.is_empty() {
            return Increment { omega: [x, y, z], turn, impulse: [0.0; 3], work: 0.0 };
        }
        let [a, b, c, _] = increment(&self.impulse.rows, p, h).0;
        let work = self.work[1..=p].iter().rev().fold(0.0, |sum, c| (sum + c) * h);
        Increment { omega: [x, y, z], turn, impulse: [a, b, c], work }
    }
}
