//! Taylor's method: the motion of a step as a power series in time, from the equations themselves.
//!
//! Coefficient n + 1 of every unknown follows from the coefficients up to n, as the equations have only products in
//! them. In principal axes, with q the turn since the start of the step,
//!
//! i1 ω̇1 = (i2 − i3) ω2 ω3 + N1 …,  q̇ = ½ q ∘ ω,  K̇ = N + K × ω,  Ẇ = N · ω
//!
//! K is the angular impulse ∫ N dt as the turning body sees it, W the work: the evidence. The same series is the dense output.
//! With wheels of angular momentum h and with friction inside, L = I ω + h, the axes turn at Ω = ω + α L × ω, I ω̇ = L × Ω + N − ḣ.
//!
//! Source: À. Jorba, M. Zou, Exp. Math. 14 (2005) 99: order and step.

mod function;
mod row;
mod scalar;
mod seen;
mod stepper;
mod torque;
mod turn;

pub(super) use stepper::Taylor;

use row::{Row, Series, TERMS, Vectors, increment, product};
use torque::{Known, StepStart, TorqueSeries, row};
use turn::Turn;

use super::piece::Piece;
use crate::math::lanes::in_widest_vectors;

/// The series of everything over one step.
#[derive(Clone, Debug)]
struct Expansion {
    moments: Row,
    /// (i2 − i3)/i1 …
    ratios: Row,
    /// 1/i; zero along an axis without inertia.
    inverses: Row,
    torques: Vec<TorqueSeries>,
    /// What acts inside the body, if anything does.
    inside: Option<Box<Inside>>,
    omega: Vectors,
    turn: Turn,
    torque: Series,
    /// (K, W)
    impulse: Vectors,
    work: [f64; TERMS],
    order: usize,
}

/// Wheels and friction.
#[derive(Clone, Debug)]
struct Inside {
    /// h at the start of the step, and ḣ.
    wheels: [Row; 2],
    /// α
    sink: f64,
    /// L = I ω + h
    momentum: Vectors,
    /// L × ω
    bending: Series,
    /// Ω
    turning: Vectors,
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
    fn new(piece: &Piece<'_>, tolerance: f64) -> Self {
        let [i1, i2, i3] = piece.rotor.principal().moments();
        let over = |numerator: f64, i: f64| if i == 0.0 { 0.0 } else { numerator / i };
        // Jorba & Zou, eq. 3-5: the order that makes a step of given error cheapest.
        let order = (1.0 - 0.5 * tolerance.ln()).ceil() as usize;
        let mut expansion = Self {
            moments: Row([i1, i2, i3, 0.0]),
            ratios: Row([over(i2 - i3, i1), over(i3 - i1, i2), over(i1 - i2, i3), 0.0]),
            inverses: Row([over(1.0, i1), over(1.0, i2), over(1.0, i3), 0.0]),
            torques: Vec::new(),
            inside: None,
            omega: Vectors::ZERO,
            turn: Turn::NONE,
            torque: [Row::ZERO; TERMS],
            impulse: Vectors::ZERO,
            work: [0.0; TERMS],
            order: order.clamp(4, TERMS - 1),
        };
        expansion.act(piece);
        expansion
    }

    /// What acts from now on.
    fn act(&mut self, piece: &Piece<'_>) {
        self.torques =
            piece.torques.iter().filter_map(|torque| TorqueSeries::of(torque, piece.rotor)).collect();
        let is_plain = piece.rotor.wheels().is_empty() && piece.sink == 0.0;
        self.inside = (!is_plain).then(|| {
            Box::new(Inside {
                wheels: [Row::ZERO; 2],
                sink: piece.sink,
                momentum: Vectors::ZERO,
                bending: [Row::ZERO; TERMS],
                turning: Vectors::ZERO,
            })
        });
    }

    /// The torque along an axis without inertia; only a rod has one, and it is the first.
    fn unbalanced(&self) -> Option<f64> {
        let ([inverse, ..], [torque, ..]) = (self.inverses.0, self.torque[0].0);
        (inverse == 0.0 && torque != 0.0).then_some(torque)
    }

    const fn order(&self) -> usize {
        self.order
    }

    /// True if nothing has to be added up as evidence.
    fn is_free(&self) -> bool {
        self.torques.is_empty() && self.inside.is_none()
    }

    /// Expands the motion about a state.
    fn expand(&mut self, start: &StepStart, piece: &Piece<'_>) {
        for torque in &mut self.torques {
            torque.start(start);
        }
        if let Some(inside) = &mut self.inside {
            inside.wheels = [row(piece.wheel_momentum(start.time)), row(piece.motor_torque())];
        }
        self.omega.set(0, row(start.omega));
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
        let (mut rate, mut power) = match &mut self.inside {
            None => (self.ratios * self.omega.others(n), Row::ZERO),
            Some(inside) => inside.extend(n, self.moments, self.inverses, &self.omega),
        };
        let turning = self.inside.as_ref().map_or(&self.omega, |inside| &inside.turning);
        self.turn.set_omega(n, turning.rows[n]);
        if !self.torques.is_empty() {
            let known = Known { omega: &self.omega, turning, turn: &self.turn.rows };
            let mut torque = Row::ZERO;
            for series in &mut self.torques {
                torque = torque + series.coefficient(n, &known);
            }
            self.torque[n] = torque;
            rate = rate + self.inverses * torque;
            for series in &mut self.torques {
                series.extend(n, &known);
            }
            let impulse = (torque + self.impulse.cross(turning, n)) * over;
            self.impulse.set(n + 1, impulse);
            power = power + product(&self.torque, &self.omega.rows, n);
        }
        let [x, y, z, w] = (power * over).0;
        self.work[n + 1] = (x + y) + (z + w);
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
        if self.is_free() {
            return Increment { omega: [x, y, z], turn, impulse: [0.0; 3], work: 0.0 };
        }
        let [a, b, c, _] = increment(&self.impulse.rows, p, h).0;
        let work = self.work[1..=p].iter().rev().fold(0.0, |sum, c| (sum + c) * h);
        Increment { omega: [x, y, z], turn, impulse: [a, b, c], work }
    }
}

impl Inside {
    /// Coefficient n of (L × Ω − ḣ)/I, and of the power −ḣ · ω − α |L × ω|², component by component; those of Ω on the way.
    #[inline(always)]
    fn extend(&mut self, n: usize, moments: Row, inverses: Row, omega: &Vectors) -> (Row, Row) {
        let [h, rate] = self.wheels;
        let wheels = match n {
            0 => h,
            1 => rate,
            _ => Row::ZERO,
        };
        self.momentum.set(n, moments * omega.rows[n] + wheels);
        self.bending[n] = self.momentum.cross(omega, n);
        self.turning.set(n, omega.rows[n] + Row::splat(self.sink) * self.bending[n]);
        let reaction = if n == 0 { rate } else { Row::ZERO };
        let torque = self.momentum.cross(&self.turning, n) - reaction;
        let loss = product(&self.bending, &self.bending, n) * Row::splat(self.sink);
        (inverses * torque, Row::ZERO - rate * omega.rows[n] - loss)
    }
}
