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

mod base;
mod fleet;
mod function;
mod row;
mod scalar;
mod seen;
mod stepper;
mod sums;
mod torque;
mod turned;

pub(in crate::motion) use fleet::{Body, Kind, advance, kind};
pub(super) use stepper::Taylor;

use row::{INVERSES, Row, Series, TERMS, Vectors};
use seen::Seen;
use sums::{ByFours, Sums};
use torque::{Affine, Known, StepStart, TorqueSeries, from_outside, row, split};
use turned::{Newest, Pair, Turned};

use super::piece::Piece;
use crate::math::machine::{Machine, Work, in_vectors};
use crate::math::number::Number;

/// The series of everything over one step: of one body, or of one in each lane.
#[derive(Clone, Debug)]
struct Expansion<N = f64> {
    moments: Row<N>,
    /// (i2 − i3)/i1 …
    ratios: Row<N>,
    /// 1/i; zero along an axis without inertia.
    inverses: Row<N>,
    /// What is affine in ω and in a vector of space, which is expanded beside the turn.
    affine: Affine<N>,
    /// All other torques.
    torques: Vec<TorqueSeries<N>>,
    /// Where there is no such vector: the first torque whose vector of space is expanded beside the turn.
    rider: Option<usize>,
    /// What acts inside the body, if anything does.
    inside: Option<Box<Inside<N>>>,
    omega: Vectors<N>,
    turned: Turned<N>,
    torque: Series<N>,
    impulse: Seen<N>,
    /// The work, component by component.
    work: Series<N>,
    /// Are K and W wanted?
    evidence: bool,
    order: usize,
    /// log₂ of the part of the radius of convergence that a step may go.
    reach: f64,
}

/// Wheels and friction.
#[derive(Clone, Debug)]
struct Inside<N> {
    /// h at the start of the step, and ḣ.
    wheels: [Row<N>; 2],
    /// α
    sink: N,
    /// L = I ω + h
    momentum: Series<N>,
    /// L × ω
    bending: Series<N>,
    /// Ω
    turning: Vectors<N>,
}

/// What a step adds, after so much time.
#[derive(Clone, Copy, Debug)]
struct Increment<N = f64> {
    /// Of ω, principal axes.
    omega: [N; 3],
    /// The turn less the identity: (w − 1, x, y, z).
    turn: [N; 4],
    /// ∫ N dt since the start of the step, along the principal axes at its end.
    impulse: [N; 3],
    work: N,
}

impl<N: Number> Expansion<N> {
    /// Of bodies with what acts in this piece, each lane to be [`Expansion::set`].
    fn of(zero: N, piece: &Piece<'_>, tolerance: f64, evidence: bool) -> Self {
        let order = order(tolerance);
        let remainder = (CAUTION * tolerance).max(SMALLEST_REMAINDER);
        let none = Row::splat(zero);
        let mut expansion = Self {
            moments: none,
            ratios: none,
            inverses: none,
            affine: Affine::none(zero),
            torques: Vec::new(),
            rider: None,
            inside: None,
            omega: Vectors::all(zero),
            turned: Turned::all(zero),
            torque: Series::all(zero),
            impulse: Seen::all(zero),
            work: Series::all(zero),
            evidence,
            order,
            reach: reach(order, remainder),
        };
        expansion.act(piece);
        expansion
    }

    /// What kind of things act from now on.
    fn act(&mut self, piece: &Piece<'_>) {
        let zero = self.zero();
        let [affine, others] = split(from_outside(&piece.torques), piece.rotor);
        self.affine = Affine::of(zero, &affine, piece.rotor);
        self.torques =
            others.into_iter().filter_map(|model| TorqueSeries::of(zero, model, piece.rotor)).collect();
        let rider = self.torques.iter().position(TorqueSeries::can_ride);
        self.rider = rider.filter(|_| !self.affine.carries());
        self.turned.carries = self.affine.carries() || self.rider.is_some();
        // Nothing of a torque that has ended.
        (self.torque, self.impulse) = (Series::all(zero), Seen::all(zero));
        let is_plain = piece.rotor.wheels().is_empty() && piece.sink == 0.0;
        self.inside = (!is_plain).then(|| {
            Box::new(Inside {
                wheels: [Row::splat(zero); 2],
                sink: zero,
                momentum: Series::all(zero),
                bending: Series::all(zero),
                turning: Vectors::all(zero),
            })
        });
    }

    /// The body of a lane, and what acts on it from now on.
    fn set(&mut self, lane: usize, piece: &Piece<'_>) {
        let [i1, i2, i3] = piece.rotor.principal().moments();
        let over = |numerator: f64, i: f64| if i == 0.0 { 0.0 } else { numerator / i };
        self.moments.put(lane, Row([i1, i2, i3, 0.0]));
        self.ratios.put(lane, Row([over(i2 - i3, i1), over(i3 - i1, i2), over(i1 - i2, i3), 0.0]));
        self.inverses.put(lane, Row([over(1.0, i1), over(1.0, i2), over(1.0, i3), 0.0]));
        let [affine, others] = split(from_outside(&piece.torques), piece.rotor);
        self.affine.set(lane, &affine, piece.rotor, self.inverses.lane(lane));
        for (series, model) in self.torques.iter_mut().zip(others) {
            series.set(lane, model, piece.rotor);
        }
        if let Some(inside) = &mut self.inside {
            inside.sink.put(lane, piece.sink);
        }
    }

    fn zero(&self) -> N {
        self.moments.0[0].like(0.0)
    }

    /// The torque along an axis without inertia; only a rod has one, and it is the first.
    fn unbalanced(&self, lane: usize) -> Option<f64> {
        let (inverse, torque) = (self.inverses.0[0].lane(lane), self.torque[0].0[0].lane(lane));
        (inverse == 0.0 && torque != 0.0).then_some(torque)
    }

    const fn order(&self) -> usize {
        self.order
    }

    /// True if nothing has to be added up as evidence.
    fn is_free(&self) -> bool {
        self.affine.is_none() && self.torques.is_empty() && self.inside.is_none()
    }

    /// Starts a step.
    #[inline(always)]
    fn start(&mut self, at: &StepStart<N>) {
        for torque in &mut self.torques {
            torque.start(at);
        }
        self.omega.set(0, at.omega);
        let [one, none] = [1.0, 0.0].map(|x| at.time.like(x));
        let rider = || self.torques.get(self.rider?)?.carried();
        let seen = self.affine.carried(at).or_else(rider).unwrap_or(Row::splat(none));
        self.turned.set(0, Pair::new(Row([one, none, none, none]), seen));
    }

    /// What wheels have at the start of a step of a lane.
    fn start_wheels(&mut self, lane: usize, time: f64, piece: &Piece<'_>) {
        if let Some(inside) = &mut self.inside {
            let wheels = [row(piece.wheel_momentum(time)), row(piece.motor_torque())];
            for (place, wheels) in inside.wheels.iter_mut().zip(wheels) {
                place.put(lane, wheels);
            }
        }
    }

    /// True if no more is asked for than the motion under torques of the affine kind, or none.
    fn is_plain(&self) -> bool {
        self.torques.is_empty() && self.inside.is_none() && !self.evidence
    }

    /// Expands the motion about where it starts.
    #[inline(always)]
    fn expand<M: Sums<N = N>>(&mut self, s: M) {
        let mut newest = Newest { omega: self.omega.rows.at(0), pair: self.turned.at(0) };
        if self.is_plain() {
            for n in 0..self.order {
                newest = self.extend::<M, true>(s, n, &newest);
            }
        } else {
            for n in 0..self.order {
                newest = self.extend::<M, false>(s, n, &newest);
            }
        }
        self.omega.set(self.order, newest.omega);
        self.turned.set(self.order, newest.pair);
    }

    /// Coefficients n + 1 of all that is unknown, from those up to n.
    #[inline(always)]
    fn extend<M: Sums<N = N>, const PLAIN: bool>(&mut self, s: M, n: usize, newest: &Newest<N>) -> Newest<N> {
        let (next, none) = (n + 1, Row::splat(newest.omega.0[0].like(0.0)));
        let mut rate = self.affine.acceleration(n, newest.pair.seen(), newest.omega);
        let (turned, turning, mut power);
        if let (false, Some(inside)) = (PLAIN, &mut self.inside) {
            let before = s.before(&self.omega, &self.turned, &inside.turning, n);
            self.omega.set(n, newest.omega);
            self.turned.set(n, newest.pair);
            let own;
            (own, power) = inside.extend(s, n, self.moments, self.inverses, &self.omega);
            rate = rate + own;
            turning = &inside.turning;
            let ends = [turning.rows.at(0), turning.rows.at(n)];
            (_, turned) = s.with(before, &self.omega, &self.turned, ends, (n, newest));
        } else {
            let before = s.before(&self.omega, &self.turned, &self.omega, n);
            self.omega.set(n, newest.omega);
            self.turned.set(n, newest.pair);
            turning = &self.omega;
            let ends = [turning.rows.at(0), newest.omega];
            let others;
            (others, turned) = s.with(before, &self.omega, &self.turned, ends, (n, newest));
            rate = self.ratios.mul_add(others, rate);
            power = none;
        }
        let mut pair = s.shared(turned, next);
        if !PLAIN {
            let known = Known { s, omega: &self.omega, turning, turned: &self.turned };
            let mut torque = none;
            for series in &mut self.torques {
                torque = torque + series.coefficient(n, &known);
            }
            for (k, series) in self.torques.iter_mut().enumerate() {
                let rides = self.rider == Some(k);
                let next = series.extend(n, &known, if rides { Some(turned.seen()) } else { None });
                if let (true, Some(next)) = (rides, next) {
                    pair = Pair::new(pair.turn(), next);
                }
            }
            rate = rate + self.inverses * torque;
            torque = torque + self.affine.torque(n, newest.pair.seen(), newest.omega);
            self.torque.set(n, torque);
            if self.evidence {
                self.impulse.extend(s, n, turning, torque);
                power = power + s.product(&self.torque, &self.omega.rows, n);
                self.work.set(next, power.over(next));
            }
        } else if n == 0 {
            self.torque.set(0, self.affine.torque(0, newest.pair.seen(), newest.omega));
        }
        Newest { omega: rate.over(next).vector(), pair }
    }

    /// The longest step at which the terms that are left out are as small as they should be; `scale` is what ω is measured with.
    ///
    /// With a radius ρ = min (1/|xₚ|^(1/p), 1/|xₚ₋₁|^(1/(p−1))) they are about (h/ρ)^(p+1) / (1 − h/ρ).
    #[inline(always)]
    fn step(&self, scale: N) -> N {
        let p = self.order;
        let unit = scale.like(1.0) / scale;
        let (last, before) = (self.log_radius(p, unit), self.log_radius(p - 1, unit));
        last.zip(before, |a, b| rough_exp2(a.min(b) + self.reach))
    }

    /// log₂ of 1/|xₙ|^(1/n): digits beyond the third do not matter.
    #[inline(always)]
    fn log_radius(&self, n: usize, unit: N) -> N {
        // ω = 0 has none, even where nothing turns: the larger of NaN and a number is the number.
        let size = (self.omega.rows[n].largest() * unit).zip(self.turned.at(n).turn().largest(), f64::max);
        let [inverse, _] = INVERSES[n];
        size.map(|size| rough_log2(size) * -inverse)
    }

    /// The longest step to which the series hold, where their last terms do not show it.
    #[inline(always)]
    fn reach(&self) -> N {
        let endless = self.zero().like(f64::INFINITY);
        self.torques.iter().fold(endless, |least, torque| least.zip(torque.reach(endless), f64::min))
    }

    /// What the motion adds until a time after the start.
    #[inline(always)]
    fn at<M: Sums<N = N>>(&self, s: M, h: N) -> Increment<N> {
        let (p, zero) = (self.order, self.zero());
        let [x, y, z, _] = s.increment(&self.omega.rows, p, h).0;
        let turn = s.turn_increment(&self.turned, p, h).0;
        let mut sum = Increment { omega: [x, y, z], turn, impulse: [zero; 3], work: zero };
        if self.evidence && !self.is_free() {
            let [a, b, c, _] = s.increment(self.impulse.series(), p, h).0;
            let [x, y, z, w] = s.increment(&self.work, p, h).0;
            sum.impulse = [a, b, c];
            sum.work = (x + y) + (z + w);
        }
        sum
    }
}

/// The expansion of one body.
struct Expand<'a>(&'a mut Expansion);

impl Work for Expand<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Machine>(self, s: S) {
        self.0.expand(ByFours(s));
    }
}

/// The sums of all series of one body at a time.
struct Sum<'a> {
    expansion: &'a Expansion,
    h: f64,
}

impl Work for Sum<'_> {
    type Output = Increment;

    #[inline(always)]
    fn run<S: Machine>(self, s: S) -> Increment {
        self.expansion.at(ByFours(s), self.h)
    }
}

impl Expansion {
    fn of_one(piece: &Piece<'_>, tolerance: f64, evidence: bool) -> Self {
        let mut expansion = Self::of(0.0, piece, tolerance, evidence);
        expansion.set(0, piece);
        expansion
    }

    fn expand_about(&mut self, start: &StepStart, piece: &Piece<'_>) {
        self.start(start);
        self.start_wheels(0, start.time, piece);
        in_vectors(Expand(self));
    }

    fn after(&self, h: f64) -> Increment {
        in_vectors(Sum { expansion: self, h })
    }
}

impl<N: Number> Inside<N> {
    /// Coefficient n of (L × Ω − ḣ)/I, and of the power −ḣ · ω − α |L × ω|², component by component; those of Ω on the way.
    #[inline(always)]
    fn extend<M: Sums<N = N>>(
        &mut self,
        s: M,
        n: usize,
        moments: Row<N>,
        inverses: Row<N>,
        omega: &Vectors<N>,
    ) -> (Row<N>, Row<N>) {
        let none = Row::splat(self.sink.like(0.0));
        let [h, rate] = self.wheels;
        let wheels = match n {
            0 => h,
            1 => rate,
            _ => none,
        };
        self.momentum.set(n, (moments * omega.rows.at(n) + wheels).vector());
        let bending = s.cross(&self.momentum, omega, n);
        self.bending.set(n, bending);
        self.turning.set(n, omega.rows.at(n) + Row::splat(self.sink) * bending);
        let reaction = if n == 0 { rate } else { none };
        let torque = s.cross(&self.momentum, &self.turning, n) - reaction;
        let loss = s.product(&self.bending, &self.bending, n) * Row::splat(self.sink);
        (inverses * torque, none - rate * omega.rows.at(n) - loss)
    }
}

/// The order of a tolerance.
fn order(tolerance: f64) -> usize {
    ((14.0 - 0.3 * tolerance.ln()).ceil() as usize).min(TERMS - 1)
}

/// The terms that are left out, over the tolerance: the errors of all steps add up.
const CAUTION: f64 = 4e-4;

/// Less is lost in rounding.
const SMALLEST_REMAINDER: f64 = 5e-18;

/// log₂ x of x^(p+1)/(1 − x) = the remainder.
fn reach(order: usize, remainder: f64) -> f64 {
    let power = 1.0 / (order + 1) as f64;
    // From x = 0, a few rounds are enough: the right-hand side hardly changes.
    (0..8).fold(0.0, |x: f64, _| {
        libm::log2(remainder * (1.0 - if x == 0.0 { 0.0 } else { libm::exp2(x) })) * power
    })
}

/// log₂ of a number that is not negative, to 2e-4.
///
/// Without a branch, and with no more than shifts for the integers: eight at once are vectors.
#[inline(always)]
fn rough_log2(x: f64) -> f64 {
    let bits = x.to_bits();
    // The integer n < 2⁵² is the mantissa of 2⁵² + n.
    let exponent = f64::from_bits(TWO_52.to_bits() | bits >> 52) - TWO_52 - 1023.0;
    let m = f64::from_bits((bits & 0x000f_ffff_ffff_ffff) | 0x3ff0_0000_0000_0000) - 1.0;
    let square = m * m;
    let log = (exponent + m * 1.43856) + square * ((m * 0.32366 - 0.67811) - square * 0.08411);
    let log = if x >= f64::MIN_POSITIVE { log } else { f64::NEG_INFINITY };
    if x.is_nan() { x } else { log }
}

/// 2ˣ, to 2e-4; infinite and zero where f64 ends.
#[inline(always)]
fn rough_exp2(x: f64) -> f64 {
    // Positive, and its floor.
    let shifted = x + 1023.0;
    let nearest = (shifted + TWO_52) - TWO_52;
    let floor = if nearest > shifted { nearest - 1.0 } else { nearest };
    let m = shifted - floor;
    let power = f64::from_bits((floor + TWO_52).to_bits() << 52);
    let exp = power * ((1.0 + m * 0.69556) + (m * m) * (0.22676 + m * 0.07768));
    let end = if x > 0.0 { f64::INFINITY } else { x.abs() * 0.0 };
    if x.abs() < 1022.0 { exp } else { end }
}

const TWO_52: f64 = 4_503_599_627_370_496.0;
