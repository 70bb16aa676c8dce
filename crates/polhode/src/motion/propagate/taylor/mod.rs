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
//! Source: À. Jorba, M. Zou, Exp. Math. 14 (2005) 99. Their order, 1 − ½ ln ε, is best where the time of a step grows with its square. Here
//! it hardly grows, as most of it is waiting for the coefficient before, so that higher orders and longer steps are faster: of a heavy
//! top by an eighth at ε = 1e-15, by more than a half at 1e-6.

mod function;
mod row;
mod scalar;
mod seen;
mod stepper;
mod torque;
mod turn;

pub(super) use stepper::Taylor;

use row::{Row, Series, TERMS, Vectors, cross, product};
use seen::Seen;
use torque::{Known, StepStart, TorqueSeries, row};
use turn::turned_at;

use super::piece::Piece;
use crate::math::lanes::{Fours, Work, in_fours};

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
    /// (w, x, y, z)
    turn: Series,
    torque: Series,
    impulse: Seen,
    /// The work, component by component.
    work: Series,
    /// Are K and W wanted?
    evidence: bool,
    order: usize,
    /// log₂ of the part of the radius of convergence that a step may go.
    reach: f64,
}

/// Wheels and friction.
#[derive(Clone, Debug)]
struct Inside {
    /// h at the start of the step, and ḣ.
    wheels: [Row; 2],
    /// α
    sink: f64,
    /// L = I ω + h
    momentum: Series,
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
    fn new(piece: &Piece<'_>, tolerance: f64, evidence: bool) -> Self {
        let [i1, i2, i3] = piece.rotor.principal().moments();
        let over = |numerator: f64, i: f64| if i == 0.0 { 0.0 } else { numerator / i };
        let order = ((14.0 - 0.3 * tolerance.ln()).ceil() as usize).min(TERMS - 1);
        let remainder = (CAUTION * tolerance).max(SMALLEST_REMAINDER);
        let mut expansion = Self {
            moments: Row([i1, i2, i3, 0.0]),
            ratios: Row([over(i2 - i3, i1), over(i3 - i1, i2), over(i1 - i2, i3), 0.0]),
            inverses: Row([over(1.0, i1), over(1.0, i2), over(1.0, i3), 0.0]),
            torques: Vec::new(),
            inside: None,
            omega: Vectors::ZERO,
            turn: Series::ZERO,
            torque: Series::ZERO,
            impulse: Seen::ZERO,
            work: Series::ZERO,
            evidence,
            order,
            reach: reach(order, remainder),
        };
        expansion.act(piece);
        expansion
    }

    /// What acts from now on.
    fn act(&mut self, piece: &Piece<'_>) {
        self.torques =
            piece.torques.iter().filter_map(|torque| TorqueSeries::of(torque, piece.rotor)).collect();
        // Nothing of a torque that has ended.
        (self.torque, self.impulse) = (Series::ZERO, Seen::ZERO);
        let is_plain = piece.rotor.wheels().is_empty() && piece.sink == 0.0;
        self.inside = (!is_plain).then(|| {
            Box::new(Inside {
                wheels: [Row::ZERO; 2],
                sink: piece.sink,
                momentum: Series::ZERO,
                bending: Series::ZERO,
                turning: Vectors::ZERO,
            })
        });
    }

    /// The torque along an axis without inertia; only a rod has one, and it is the first.
    fn unbalanced(&self) -> Option<f64> {
        let ([inverse, ..], [torque, ..]) = (self.inverses.0, self.torque.at(0).0);
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
        in_fours(self);
    }

    #[inline(always)]
    fn extend<S: Fours>(&mut self, s: S, n: usize) {
        let next = n + 1;
        let (mut rate, turned, mut power, turning);
        if let Some(inside) = &mut self.inside {
            (rate, power) = inside.extend(s, n, self.moments, self.inverses, &self.omega);
            turning = &inside.turning;
            (_, turned) = products(s, &self.omega, &self.turn, turning, n);
        } else {
            let others;
            turning = &self.omega;
            (others, turned) = products(s, &self.omega, &self.turn, turning, n);
            (rate, power) = (self.ratios * others, Row::ZERO);
        }
        if !self.torques.is_empty() {
            let known = Known { s, omega: &self.omega, turning, turn: &self.turn };
            let mut torque = Row::ZERO;
            for series in &mut self.torques {
                torque = torque + series.coefficient(n, &known);
            }
            self.torque.set(n, torque);
            rate = rate + self.inverses * torque;
            for series in &mut self.torques {
                series.extend(n, &known);
            }
            if self.evidence {
                self.impulse.extend(s, n, turning, torque);
                power = power + product(s, &self.torque, &self.omega.rows, n);
            }
        }
        self.work.set(next, power.over(next));
        self.turn.set(next, turned.over(2 * next));
        self.omega.set(next, rate.over(next));
    }

    /// The longest step at which the terms that are left out are as small as they should be; `scale` is what ω is measured with.
    ///
    /// With a radius ρ = min (1/|xₚ|^(1/p), 1/|xₚ₋₁|^(1/(p−1))) they are about (h/ρ)^(p+1) / (1 − h/ρ).
    fn step(&self, scale: f64) -> f64 {
        let p = self.order;
        let size = |n: usize| {
            let omega = self.omega.rows.at(n).largest();
            let omega = if omega == 0.0 { 0.0 } else { omega / scale };
            omega.max(self.turn.at(n).largest())
        };
        // log₂ of a radius: digits beyond the third do not matter.
        let radius = |n: usize| -rough_log2(size(n)) / n as f64;
        rough_exp2(radius(p).min(radius(p - 1)) + self.reach)
    }

    /// The longest step to which the series holds, where its last terms do not show it.
    fn reach(&self) -> f64 {
        self.torques.iter().fold(f64::INFINITY, |least, torque| least.min(torque.reach()))
    }

    /// What the motion adds until a time after the start.
    fn at(&self, h: f64) -> Increment {
        in_fours(Sum { expansion: self, h })
    }
}

/// The sums of all series at a time.
struct Sum<'a> {
    expansion: &'a Expansion,
    h: f64,
}

impl Work for Sum<'_> {
    type Output = Increment;

    #[inline(always)]
    fn run<S: Fours>(self, s: S) -> Increment {
        let Self { expansion, h } = self;
        let (p, h) = (expansion.order, s.splat(h));
        let [x, y, z, _] = expansion.omega.rows.increment(s, p, h).0;
        let turn = expansion.turn.increment(s, p, h).0;
        let mut sum = Increment { omega: [x, y, z], turn, impulse: [0.0; 3], work: 0.0 };
        if expansion.evidence && !expansion.is_free() {
            let [a, b, c, _] = expansion.impulse.series().increment(s, p, h).0;
            let [x, y, z, w] = expansion.work.increment(s, p, h).0;
            sum.impulse = [a, b, c];
            sum.work = (x + y) + (z + w);
        }
        sum
    }
}

impl Work for &mut Expansion {
    type Output = ();

    #[inline(always)]
    fn run<S: Fours>(self, s: S) {
        for n in 0..self.order {
            self.extend(s, n);
        }
    }
}

impl Inside {
    /// Coefficient n of (L × Ω − ḣ)/I, and of the power −ḣ · ω − α |L × ω|², component by component; those of Ω on the way.
    #[inline(always)]
    fn extend<S: Fours>(
        &mut self,
        s: S,
        n: usize,
        moments: Row,
        inverses: Row,
        omega: &Vectors,
    ) -> (Row, Row) {
        let [h, rate] = self.wheels;
        let wheels = match n {
            0 => h,
            1 => rate,
            _ => Row::ZERO,
        };
        self.momentum.set(n, moments * omega.rows.at(n) + wheels);
        let bending = cross(s, &self.momentum, omega, n);
        self.bending.set(n, bending);
        self.turning.set(n, omega.rows.at(n) + Row::splat(self.sink) * bending);
        let reaction = if n == 0 { rate } else { Row::ZERO };
        let torque = cross(s, &self.momentum, &self.turning, n) - reaction;
        let loss = product(s, &self.bending, &self.bending, n) * Row::splat(self.sink);
        (inverses * torque, Row::ZERO - rate * omega.rows.at(n) - loss)
    }
}

/// Coefficients n of (ω2 ω3, ω3 ω1, ω1 ω2) and of q ∘ Ω, in one loop.
#[inline(always)]
fn products<S: Fours>(s: S, omega: &Vectors, turn: &Series, turning: &Vectors, n: usize) -> (Row, Row) {
    let [x, y, z] = &turning.components;
    let [mut others, mut p, mut q, mut r] = [s.splat(0.0); 4];
    let forward = omega.rows.forward().zip(turn.forward());
    let backward = x.backward(n).zip(y.backward(n)).zip(z.backward(n)).zip(omega.turned.backward(n));
    for ((w, turn), (((x, y), z), t)) in forward.zip(backward) {
        for k in 0..4 {
            others = others + s.load(&w[k].0) * s.load(&t[3 - k].0);
            let turn = s.load(&turn[k].0);
            p = p + turn * s.splat(x[3 - k]);
            q = q + turn * s.splat(y[3 - k]);
            r = r + turn * s.splat(z[3 - k]);
        }
    }
    let turn = s.load(&turn.at(0).0);
    others = others + s.load(&omega.rows.at(0).0) * s.load(&omega.turned.at(n).0);
    let outer = [p + turn * s.splat(x.at(n)), q + turn * s.splat(y.at(n)), r + turn * s.splat(z.at(n))];
    let (others, outer) = (Row(s.numbers(others)), outer.map(|sum| Row(s.numbers(sum))));
    // ω and ω turned: turning once more brings (ω1 ω2, ω2 ω3, ω3 ω1) there.
    (others.turned(), turned_at(outer))
}

/// The terms that are left out, over the tolerance: the errors of all steps add up.
const CAUTION: f64 = 0.01;

/// Less is lost in rounding.
const SMALLEST_REMAINDER: f64 = 5e-17;

/// log₂ x of x^(p+1)/(1 − x) = the remainder.
fn reach(order: usize, remainder: f64) -> f64 {
    let power = 1.0 / (order + 1) as f64;
    // From x = 0, a few rounds are enough: the right-hand side hardly changes.
    (0..8).fold(0.0, |x: f64, _| {
        libm::log2(remainder * (1.0 - if x == 0.0 { 0.0 } else { libm::exp2(x) })) * power
    })
}

/// log₂ of a number that is not negative, to 2e-4.
#[inline(always)]
fn rough_log2(x: f64) -> f64 {
    if !(x >= f64::MIN_POSITIVE) {
        return if x.is_nan() { x } else { f64::NEG_INFINITY };
    }
    let bits = x.to_bits();
    let exponent = (bits >> 52) as f64 - 1023.0;
    let m = f64::from_bits((bits & 0x000f_ffff_ffff_ffff) | 0x3ff0_0000_0000_0000) - 1.0;
    exponent + m * (1.43856 + m * (-0.67811 + m * (0.32366 - m * 0.08411)))
}

/// 2ˣ, to 2e-4; infinite and zero where f64 ends.
#[inline(always)]
fn rough_exp2(x: f64) -> f64 {
    if !(x.abs() < 1022.0) {
        return if x > 0.0 { f64::INFINITY } else { x.abs() * 0.0 };
    }
    // Positive, and so cut towards its floor.
    let shifted = x + 1023.0;
    let m = shifted - (shifted as u64) as f64;
    let power = f64::from_bits((shifted as u64) << 52);
    power * (1.0 + m * (0.69556 + m * (0.22676 + m * 0.07768)))
}
