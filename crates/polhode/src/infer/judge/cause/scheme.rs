//! Numerical methods with fixed steps, as programs implement them.

use core::fmt;

use super::law::{BodyVector, Law, Numbers, advanced, derivative, numbers, state};
use crate::math::frame::{Body, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::model::state::State;

/// Attitude update for a step h with the angular velocity ω.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Turn {
    /// Exact rotation by the angle |ω| h about ω: q′ = q exp(½ h ω).
    Exponential,
    /// First-order update, normalised: q′ = q + ½ h q ω, with the angle 2 atan(½ |ω| h).
    FirstOrder,
}

/// Integration rule with fixed steps h, with ω along body axes and α(q, ω) = I⁻¹ (N − ω × I ω).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Scheme {
    /// Explicit Euler: q′ by ω, ω′ = ω + h α.
    ExplicitEuler(Turn),
    /// Explicit Euler along space axes: ω′ = ω + h I⁻¹ (N − ω × I ω) there, q′ by ω.
    ExplicitEulerSpace(Turn),
    /// Semi-implicit Euler: ω′ = ω + h α, then q′ by ω′. Used by MuJoCo's Euler and, along space
    /// axes, by most game engines.
    SemiImplicitEuler(Turn),
    /// L along space axes: L′ = L + h N, then q′ by I⁻¹ L′ with the I of q.
    MomentumFirst(Turn),
    /// L along space axes: q′ by I⁻¹ L with the I of q, then L′ = L + h N of q.
    MomentumLast(Turn),
    /// One step of Newton's method for I (ω′ − ω) + h (ω′ × I ω′ − N) = 0, then q′ by ω′. Catto's
    /// method, used in Bullet and, as `implicit`, in MuJoCo.
    ImplicitGyroscopic(Turn),
    /// Solution ω′ of I (ω′ − ω) = h (I ω × ω′ + N), then q′ by ω′. Lacoursière's method, used in
    /// ODE.
    LaggedMomentum(Turn),
    /// L′ = L + h L × ω, rescaled to the length of L, then N, then q′ by ω′. Used in PhysX and
    /// Jolt.
    RescaledMomentum(Turn),
    /// Correct ω; q′ by the ω at the start of the step.
    HeldAtStart(Turn),
    /// Correct ω; q′ by the ω at the end of the step.
    HeldAtEnd(Turn),
    /// Explicit midpoint rule for ω and q: half a step, then a whole step with the derivatives
    /// there.
    Midpoint,
    /// Heun's method: the mean of the derivatives at the start and at the predicted end of the
    /// step.
    Heun,
    /// Velocity Verlet: q′ by ω + ½ h α, then ω′ by the mean of α at both ends.
    VelocityVerlet,
    /// Half a kick, q′ by the resulting ω, half a kick.
    KickTurnKick(Turn),
    /// Implicit midpoint rule for ω′, and q′ by the mean of ω and ω′.
    ImplicitMidpoint(Turn),
    /// Symmetric splitting: half a kick of L, rotations about the three principal axes forward and
    /// back, half a kick.
    Splitting,
    /// Classical Runge–Kutta method of order 4 for q and ω.
    RungeKutta4,
    /// Classical Runge–Kutta method of order 4 for q and L along space axes.
    RungeKutta4Momentum,
    /// Classical Runge–Kutta method for ω, with q′ by the weighted mean of the four ω, as in
    /// MuJoCo's RK4; order 2 for q.
    RungeKutta4MeanRate,
}

use Scheme::*;
use Turn::*;

impl Scheme {
    /// All rules.
    pub const ALL: [Self; 31] = [
        ExplicitEuler(Exponential),
        ExplicitEuler(FirstOrder),
        ExplicitEulerSpace(Exponential),
        ExplicitEulerSpace(FirstOrder),
        SemiImplicitEuler(Exponential),
        SemiImplicitEuler(FirstOrder),
        MomentumFirst(Exponential),
        MomentumFirst(FirstOrder),
        MomentumLast(Exponential),
        MomentumLast(FirstOrder),
        ImplicitGyroscopic(Exponential),
        ImplicitGyroscopic(FirstOrder),
        LaggedMomentum(Exponential),
        LaggedMomentum(FirstOrder),
        RescaledMomentum(Exponential),
        RescaledMomentum(FirstOrder),
        HeldAtStart(Exponential),
        HeldAtStart(FirstOrder),
        HeldAtEnd(Exponential),
        HeldAtEnd(FirstOrder),
        Midpoint,
        Heun,
        VelocityVerlet,
        KickTurnKick(Exponential),
        KickTurnKick(FirstOrder),
        ImplicitMidpoint(Exponential),
        ImplicitMidpoint(FirstOrder),
        Splitting,
        RungeKutta4,
        RungeKutta4Momentum,
        RungeKutta4MeanRate,
    ];

    /// Rules used by engines, which may also damp ω.
    pub(super) const ENGINES: [Self; 8] = [
        SemiImplicitEuler(Exponential),
        SemiImplicitEuler(FirstOrder),
        ImplicitGyroscopic(Exponential),
        ImplicitGyroscopic(FirstOrder),
        LaggedMomentum(Exponential),
        LaggedMomentum(FirstOrder),
        RescaledMomentum(Exponential),
        RescaledMomentum(FirstOrder),
    ];

    /// Returns the order of accuracy: the power of h in the attitude error.
    pub const fn order(self) -> u32 {
        match self {
            RungeKutta4 | RungeKutta4Momentum => 4,
            Midpoint | Heun | VelocityVerlet | Splitting | RungeKutta4MeanRate | ImplicitMidpoint(_) => 2,
            _ => 1,
        }
    }

    /// Returns the state after one step.
    pub(super) fn step(self, law: &Law<'_>, from: &State, h: f64) -> State {
        let time = from.time + h;
        let omega: BodyVector = from.omega.as_quantity();
        let acceleration = || law.acceleration(from, from.time);
        let moved =
            |attitude: Attitude, omega: BodyVector| State { time, attitude, omega: omega.as_quantity() };
        let by = |rate: BodyVector, turn: Turn| from.attitude * turn.turned(rate, h);
        match self {
            ExplicitEuler(turn) => moved(by(omega, turn), omega + acceleration() * h),
            ExplicitEulerSpace(turn) => {
                let turned = turn.turned(omega, h);
                moved(from.attitude * turned, turned.inverse() * (omega + acceleration() * h))
            }
            SemiImplicitEuler(turn) => {
                let after = omega + acceleration() * h;
                moved(by(after, turn), after)
            }
            MomentumFirst(turn) | MomentumLast(turn) => {
                let kicked = law.momentum(from) + law.torque(from, from.time) * h;
                let first = matches!(self, MomentumFirst(_));
                let rate = if first { law.omega(kicked, from.time).as_quantity() } else { omega };
                let turned = turn.turned(rate, h);
                let omega = law.omega(turned.inverse() * kicked, time);
                State { time, attitude: from.attitude * turned, omega }
            }
            ImplicitGyroscopic(turn) => {
                // J = I + h ([ω×] I − [L×]); ω′ = ω + h J⁻¹ (N + L × ω).
                let (tensor, momentum) = (law.tensor().rows(), law.momentum(from));
                let jacobian = matrix(|v| {
                    let image = BodyVector::from_array(tensor.map(|row| dot(row, v.to_array())));
                    image + (omega.cross(image) - momentum.cross(v)) * h
                });
                let force = (law.torque(from, from.time) + momentum.cross(omega)) * h;
                let after = omega + solved(&jacobian, force) - omega * (h * law.damping);
                moved(by(after, turn), after)
            }
            LaggedMomentum(turn) => {
                let (tensor, momentum) = (law.tensor().rows(), law.momentum(from));
                let lagged = matrix(|v| {
                    let image = BodyVector::from_array(tensor.map(|row| dot(row, v.to_array())));
                    image - momentum.cross(v) * h
                });
                let spin = momentum - law.wheel_momentum(from.time) + law.torque(from, from.time) * h;
                let after = solved(&lagged, spin) - omega * (h * law.damping);
                moved(by(after, turn), after)
            }
            RescaledMomentum(turn) => {
                let momentum = law.momentum(from);
                let turned = momentum + momentum.cross(omega) * h;
                let length = turned.norm();
                let kept = if length > 0.0 { turned * (momentum.norm() / length) } else { turned };
                let kicked = kept + law.torque(from, from.time) * h;
                let after: BodyVector = law.omega(kicked, time).as_quantity() - omega * (h * law.damping);
                moved(by(after, turn), after)
            }
            HeldAtStart(turn) => State { attitude: by(omega, turn), ..runge_kutta(law, from, h) },
            HeldAtEnd(turn) => {
                let right = runge_kutta(law, from, h);
                State { attitude: by(right.omega.as_quantity(), turn), ..right }
            }
            Midpoint => {
                let y = numbers(from);
                let half = advanced(&y, 0.5 * h, &derivative(law, from.time, &y, from.time));
                let slope = derivative(law, from.time + 0.5 * h, &half, from.time + 0.5 * h);
                state(time, advanced(&y, h, &slope))
            }
            Heun => {
                let y = numbers(from);
                let first = derivative(law, from.time, &y, from.time);
                let second = derivative(law, time, &advanced(&y, h, &first), time);
                state(time, advanced(&advanced(&y, 0.5 * h, &first), 0.5 * h, &second))
            }
            VelocityVerlet => {
                let first = acceleration();
                let attitude = by(omega + first * (0.5 * h), Exponential);
                let reached = moved(attitude, omega + first * h);
                let second = law.acceleration(&reached, time);
                moved(attitude, omega + (first + second) * (0.5 * h))
            }
            KickTurnKick(turn) => {
                let half = omega + acceleration() * (0.5 * h);
                let reached = moved(by(half, turn), half);
                moved(reached.attitude, half + law.acceleration(&reached, time) * (0.5 * h))
            }
            ImplicitMidpoint(turn) => {
                const ROUNDS: usize = 12;
                let mut middle = omega;
                for _ in 0..ROUNDS {
                    let attitude = from.attitude * turn.turned(middle, 0.5 * h);
                    let half = State { time: from.time + 0.5 * h, attitude, omega: middle.as_quantity() };
                    middle = omega + law.acceleration(&half, half.time) * (0.5 * h);
                }
                moved(by(middle, turn), middle * 2.0 - omega)
            }
            Splitting => split(law, from, h),
            RungeKutta4 => runge_kutta(law, from, h),
            RungeKutta4Momentum => {
                let y = numbers(from);
                let momentum: Direction<Space> = from.attitude * law.momentum(from);
                let [w, x, ydot, z, ..] = y;
                let y = [w, x, ydot, z, momentum.x, momentum.y, momentum.z];
                let end = classical(&y, h, |t, y| momentum_derivative(law, from.time + t, y));
                let reached = state(time, end);
                let kept = Direction::<Space>::from_array(reached.omega.to_array());
                State { omega: law.omega(reached.attitude.inverse() * kept, time), ..reached }
            }
            RungeKutta4MeanRate => {
                let mut stage = *from;
                let (mut rates, mut slopes) = (BodyVector::ZERO, BodyVector::ZERO);
                for (next, weight) in [(0.5, 1.0), (0.5, 2.0), (1.0, 2.0), (0.0, 1.0)] {
                    let rate: BodyVector = stage.omega.as_quantity();
                    let slope = law.acceleration(&stage, stage.time);
                    rates += rate * (weight / 6.0);
                    slopes += slope * (weight / 6.0);
                    let reached = omega + slope * (next * h);
                    stage = State {
                        time: from.time + next * h,
                        attitude: from.attitude * Exponential.turned(rate, next * h),
                        omega: reached.as_quantity(),
                    };
                }
                moved(by(rates, Exponential), omega + slopes * h)
            }
        }
    }

    /// Returns the motion from a start to each of the ascending times, with a whole number of steps
    /// near h between two times.
    pub(super) fn follow(self, law: &Law<'_>, start: State, times: &[f64], h: f64) -> Vec<State> {
        let mut now = start;
        let mut states = Vec::with_capacity(times.len());
        for &time in times {
            let (from, span) = (now.time, time - now.time);
            let steps = (span / h).round().max(if span > 0.0 { 1.0 } else { 0.0 });
            let mut done = 0.0;
            while done < steps {
                now = self.step(law, &now, span / steps);
                done += 1.0;
                // Computed from the number of steps, because a sum of many steps accumulates
                // rounding.
                now.time = from + span * (done / steps);
            }
            if !now.omega.is_finite() {
                break;
            }
            now.time = time;
            states.push(now);
        }
        states
    }
}

impl Turn {
    fn turned(self, rate: BodyVector, h: f64) -> Rotation<Body, Body> {
        match self {
            Exponential => Rotation::from_rotation_vector(rate * h),
            FirstOrder => {
                let [x, y, z] = (rate * (0.5 * h)).to_array();
                Rotation::from_quaternion([1.0, x, y, z]).unwrap_or_else(|_| Rotation::identity())
            }
        }
    }
}

fn runge_kutta(law: &Law<'_>, from: &State, h: f64) -> State {
    let end = classical(&numbers(from), h, |t, y| derivative(law, from.time + t, y, from.time + t));
    state(from.time + h, end)
}

fn classical(y: &Numbers, h: f64, slope: impl Fn(f64, &Numbers) -> Numbers) -> Numbers {
    let a = slope(0.0, y);
    let b = slope(0.5 * h, &advanced(y, 0.5 * h, &a));
    let c = slope(0.5 * h, &advanced(y, 0.5 * h, &b));
    let d = slope(h, &advanced(y, h, &c));
    core::array::from_fn(|k| y[k] + h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]))
}

/// Returns q̇ = ½ q ω with ω = I⁻¹ L, and L̇ = N along space axes.
fn momentum_derivative(law: &Law<'_>, time: f64, y: &Numbers) -> Numbers {
    let [w, x, ydot, z, a, b, c] = *y;
    let reached = state(time, *y);
    let omega = law.omega(reached.attitude.inverse() * Direction::<Space>::new(a, b, c), time);
    let reached = State { omega, ..reached };
    let torque = reached.attitude * law.torque(&reached, time);
    let (a, b, c) = (0.5 * omega.x, 0.5 * omega.y, 0.5 * omega.z);
    let turned = [
        -x * a - ydot * b - z * c,
        w * a + ydot * c - z * b,
        w * b + z * a - x * c,
        w * c + x * b - ydot * a,
    ];
    let [p, q, r, s] = turned;
    [p, q, r, s, torque.x, torque.y, torque.z]
}

fn split(law: &Law<'_>, from: &State, h: f64) -> State {
    let time = from.time + h;
    let mut momentum = law.momentum(from) + law.torque(from, from.time) * (0.5 * h);
    let mut attitude = from.attitude;
    for (axis, part) in [(0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)] {
        let (moment, axis) = law.principal[axis];
        let rate = if moment == 0.0 { 0.0 } else { axis.dot(momentum) / moment };
        let turned = Exponential.turned(axis * rate, part * h);
        attitude = attitude * turned;
        momentum = turned.inverse() * momentum;
    }
    let reached = State { time, attitude, omega: AngularVelocity::ZERO };
    momentum += law.torque(&reached, time) * (0.5 * h);
    State { omega: law.omega(momentum, time), ..reached }
}

type Columns = [BodyVector; 3];

/// Returns the columns of a linear map.
fn matrix(image: impl Fn(BodyVector) -> BodyVector) -> Columns {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| image(BodyVector::from_array(axis)))
}

/// Solves M x = b by Cramer's rule.
fn solved([a, b, c]: &Columns, v: BodyVector) -> BodyVector {
    let volume = a.dot(b.cross(*c));
    BodyVector::new(v.dot(b.cross(*c)) / volume, a.dot(v.cross(*c)) / volume, a.dot(b.cross(v)) / volume)
}

fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

/// Common name of the method.
impl fmt::Display for Scheme {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, turn) = match *self {
            ExplicitEuler(turn) => ("explicit Euler", Some(turn)),
            ExplicitEulerSpace(turn) => ("explicit Euler along space axes", Some(turn)),
            SemiImplicitEuler(turn) => ("semi-implicit Euler", Some(turn)),
            MomentumFirst(turn) => ("semi-implicit Euler with L along space axes", Some(turn)),
            MomentumLast(turn) => ("explicit Euler with L along space axes", Some(turn)),
            ImplicitGyroscopic(turn) => ("semi-implicit Euler with an implicit gyroscopic term", Some(turn)),
            LaggedMomentum(turn) => {
                ("semi-implicit Euler with a gyroscopic term linear in the new ω", Some(turn))
            }
            RescaledMomentum(turn) => ("semi-implicit Euler with |L| restored", Some(turn)),
            HeldAtStart(turn) => ("attitude rotated with ω at the start of the step", Some(turn)),
            HeldAtEnd(turn) => ("attitude rotated with ω at the end of the step", Some(turn)),
            Midpoint => ("the midpoint method (RK2)", None),
            Heun => ("Heun's method (RK2)", None),
            VelocityVerlet => ("velocity Verlet", None),
            KickTurnKick(turn) => ("kick-rotate-kick splitting", Some(turn)),
            ImplicitMidpoint(turn) => ("the implicit midpoint method", Some(turn)),
            Splitting => ("splitting into rotations about the principal axes", None),
            RungeKutta4 => ("RK4", None),
            RungeKutta4Momentum => ("RK4 with L along space axes", None),
            RungeKutta4MeanRate => ("RK4 with the attitude rotated by the mean ω", None),
        };
        f.write_str(name)?;
        match turn {
            Some(FirstOrder) => f.write_str(", attitude by q + ½ h q ω"),
            _ => Ok(()),
        }
    }
}
