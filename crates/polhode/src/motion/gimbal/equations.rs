//! Lagrange's equations of two gimbals and a rotor, M(q) q̈ + c(q, q̇) = Q, with q = (α, β, γ).
//!
//! Let ω₀ be the angular velocity of the base, and e₁, e₂, e₃ the axes of the outer gimbal, the
//! inner gimbal and the rotor. Each angular velocity is along the axes of its own body, except the
//! rotor's, which is along those of the inner gimbal:
//!
//! ω₁ = R₁ᵀ ω₀ + α̇ e₁,  ω₂ = R₂ᵀ ω₁ + β̇ e₂,  ω₃ = ω₂ + γ̇ e₃.
//!
//! T = ½ Σ ωᵢ · Iᵢ ωᵢ about the intersection of the axes, and U = −Σ mᵢ cᵢ · g. The torque required
//! on body i is Nᵢ = Iᵢ ω̇ᵢ + ωᵢ × Iᵢ ωᵢ − mᵢ cᵢ × g. Lagrange's equations are e₃ · N₃ = Q₃,
//! e₂ · (N₂ + N₃) = Q₂, e₁ · (N₁ + N₂ + N₃) = Q₁.
//!
//! The left sides at q̈ = 0 are c, and M follows from the tensors of the bodies that each axis
//! carries. Q = −d q̇ − k (q − q₀) + τ, plus the torque of a lock or motor that makes q̈ = 0.
//!
//! Sources: H. Goldstein, Classical Mechanics (1980), §1-4 (d'Alembert) and §5-7; K. Magnus,
//! Kreisel (1971), on gyroscopes in gimbals.

use super::axis::{Axis, Hold, Spring};
use super::model::{Form, Model};
use crate::math::algebra::{Components, Field};

/// Indices of the variables: α, β, γ; their rates; cosine and sine of each; work of damping and of
/// motors.
pub(super) const ANGLES: usize = 0;
pub(super) const RATES: usize = 3;
pub(super) const TURNS: usize = 6;
pub(super) const WORKS: usize = 12;
pub(super) const COUNT: usize = 14;

/// Relative threshold below which a pivot of M is rounding: the axis carries no inertia of its own.
const LOST: f64 = 1e-10;

/// Cosine and sine of an angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn<S> {
    cosine: S,
    sine: S,
}

impl<S: Field> Turn<S> {
    /// Converts components in the plane of two axes to the turned axes.
    fn back(self, a: S, b: S) -> [S; 2] {
        [self.cosine * a + self.sine * b, self.cosine * b - self.sine * a]
    }

    /// Converts components along the turned axes back.
    fn forth(self, a: S, b: S) -> [S; 2] {
        [self.cosine * a - self.sine * b, self.cosine * b + self.sine * a]
    }
}

/// Converts a vector to axes that are turned about the first axis.
fn into_outer<S: Field>(turn: Turn<S>, Components([x, y, z]): Components<S>) -> Components<S> {
    let [y, z] = turn.back(y, z);
    Components([x, y, z])
}

/// Converts a vector to axes that are turned about the second axis.
fn into_inner<S: Field>(turn: Turn<S>, Components([x, y, z]): Components<S>) -> Components<S> {
    let [z, x] = turn.back(z, x);
    Components([x, y, z])
}

fn out_of_inner<S: Field>(turn: Turn<S>, Components([x, y, z]): Components<S>) -> Components<S> {
    let [z, x] = turn.forth(z, x);
    Components([x, y, z])
}

fn out_of_outer<S: Field>(turn: Turn<S>, Components([x, y, z]): Components<S>) -> Components<S> {
    let [y, z] = turn.forth(y, z);
    Components([x, y, z])
}

/// Tensor of the rotor and m c, along the axes of the inner gimbal.
struct Rotor<S> {
    rows: [[S; 3]; 3],
    moment: Components<S>,
}

impl<S: Field> Rotor<S> {
    /// Uses the mean of the two transverse moments and half their difference, so that the angle
    /// cancels exactly if the difference is zero.
    fn turned(one: S, form: &Form, turn: Turn<S>) -> Self {
        let Form { inertia: [[a, d, e], [_, b, f], [.., c]], moment: [x, y, z] } = *form;
        let (mean, half) = (one.times(0.5 * (a + b)), 0.5 * (a - b));
        let Turn { cosine, sine } = turn;
        let (double_cosine, double_sine) = (cosine * cosine - sine * sine, (cosine * sine).times(2.0));
        let difference = double_cosine.times(half) - double_sine.times(d);
        let product = double_sine.times(half) + double_cosine.times(d);
        let [e, f] = turned(turn, [e, f]);
        let [x, y] = turned(turn, [x, y]);
        Self {
            rows: [[mean + difference, product, e], [product, mean - difference, f], [e, f, one.times(c)]],
            moment: Components([x, y, one.times(z)]),
        }
    }

    fn image(&self, v: Components<S>) -> Components<S> {
        Components(self.rows.map(|row| Components(row).dot(v)))
    }
}

/// Rotates two constant components.
fn turned<S: Field>(Turn { cosine, sine }: Turn<S>, [a, b]: [f64; 2]) -> [S; 2] {
    [cosine.times(a) - sine.times(b), sine.times(a) + cosine.times(b)]
}

/// Quantities computed from the variables.
pub(super) struct Dynamics<S> {
    /// Mass matrix M.
    pub(super) inertia: [[S; 3]; 3],
    /// Accelerations q̈, rad/s².
    pub(super) accelerations: [S; 3],
    /// Torques of locks and motors in Q, N·m.
    pub(super) holding: [S; 3],
    /// Pivots of M beyond the first, minus their thresholds. They are positive if the axes are
    /// independent.
    pub(super) pivots: Vec<S>,
}

/// Motion of the outer gimbal, the inner gimbal and the rotor. That of the rotor is along the axes
/// of the inner gimbal.
struct Motion<S> {
    omega: [Components<S>; 3],
    omega_rate: [Components<S>; 3],
    /// Gravity along the axes of each.
    gravity: [Components<S>; 3],
}

impl Form {
    fn image<S: Field>(&self, Components([x, y, z]): Components<S>) -> Components<S> {
        Components(self.inertia.map(|[a, b, c]| x.times(a) + y.times(b) + z.times(c)))
    }
}

impl Model {
    /// Returns the rates of the variables, and the pivots of M.
    pub(super) fn rates<S: Field>(&self, one: S, y: &[S]) -> (Vec<S>, Vec<S>) {
        let dynamics = self.dynamics(one, y);
        let zero = one.times(0.0);
        let mut rates = vec![zero; COUNT];
        for (k, axis) in self.axes.iter().enumerate() {
            let rate = self.rate(one, y, k);
            rates[ANGLES + k] = rate;
            rates[RATES + k] = dynamics.accelerations[k];
            // Variables on which nothing depends need no series.
            if axis.hold() != Hold::Locked && !(k == 2 && self.rotor.is_symmetric()) {
                rates[TURNS + 2 * k] = -(y[TURNS + 2 * k + 1] * rate);
                rates[TURNS + 2 * k + 1] = y[TURNS + 2 * k] * rate;
            }
            rates[WORKS] = rates[WORKS] - (rate * rate).times(axis.damping());
            if axis.hold() == Hold::Driven {
                rates[WORKS + 1] = rates[WORKS + 1] + dynamics.holding[k] * rate;
            }
        }
        (rates, dynamics.pivots)
    }

    /// Returns M, q̈, and the torques of locks and motors.
    pub(super) fn dynamics<S: Field>(&self, one: S, y: &[S]) -> Dynamics<S> {
        let constant = |v: [f64; 3]| Components(v.map(|x| one.times(x)));
        let zero = one.times(0.0);
        let [_, inner, own] = self.turns(one, y);
        let rotor = Rotor::turned(one, &self.rotor, own);
        let rate = |k| self.rate(one, y, k);

        // Torques required at q̈ = 0.
        let at = self.motion(one, y, [zero; 3]);
        let needed = |k: usize, image: &dyn Fn(Components<S>) -> Components<S>, moment: Components<S>| {
            let (omega, gravity) = (at.omega[k], at.gravity[k]);
            image(at.omega_rate[k]) + omega.cross(image(omega)) - moment.cross(gravity)
        };
        let on_rotor = needed(2, &|v| rotor.image(v), rotor.moment);
        let on_inner = on_rotor + needed(1, &|v| self.inner.image(v), constant(self.inner.moment));
        let of_outer = needed(0, &|v| self.outer.image(v), constant(self.outer.moment));
        let on_outer = out_of_inner(inner, on_inner) + of_outer;
        let bias = [on_outer.0[0], on_inner.0[1], on_rotor.0[2]];

        // Tensors of the bodies carried by each axis, and e₁, along the axes of the inner gimbal.
        let carried: [[S; 3]; 3] = core::array::from_fn(|i| {
            core::array::from_fn(|j| rotor.rows[i][j] + one.times(self.inner.inertia[i][j]))
        });
        let first = into_inner(inner, Components([one, zero, zero]));
        let of_first = Components(carried.map(|row| Components(row).dot(first)));
        let of_rotor = first.dot(Components(rotor.rows[2]));
        let around = first.dot(of_first) + one.times(self.outer.inertia[0][0]);
        let inertia = [
            [around, of_first.0[1], of_rotor],
            [of_first.0[1], carried[1][1], rotor.rows[1][2]],
            [of_rotor, rotor.rows[1][2], rotor.rows[2][2]],
        ];
        let applied: [S; 3] = core::array::from_fn(|k| applied(one, &self.axes[k], y[ANGLES + k], rate(k)));
        let needs: [S; 3] = core::array::from_fn(|k| applied[k] - bias[k]);
        let (accelerations, pivots) = self.solved(zero, inertia, needs);
        let holding = core::array::from_fn(|k| {
            if self.is_free(k) {
                zero
            } else {
                Components(inertia[k]).dot(Components(accelerations)) - needs[k]
            }
        });
        Dynamics { inertia, accelerations, holding, pivots }
    }

    /// Returns q̇, which is constant for a locked or driven axis.
    fn rate<S: Field>(&self, one: S, y: &[S], axis: usize) -> S {
        if self.is_free(axis) { y[RATES + axis] } else { one.times(self.axes[axis].rate()) }
    }

    fn turns<S: Field>(&self, one: S, y: &[S]) -> [Turn<S>; 3] {
        core::array::from_fn(|k| match self.axes[k].hold() {
            Hold::Locked => {
                let angle = self.axes[k].angle();
                Turn { cosine: one.times(libm::cos(angle)), sine: one.times(libm::sin(angle)) }
            }
            Hold::Free | Hold::Driven => Turn { cosine: y[TURNS + 2 * k], sine: y[TURNS + 2 * k + 1] },
        })
    }

    /// Returns ω, its rate for a given q̈, and g.
    fn motion<S: Field>(&self, one: S, y: &[S], accelerations: [S; 3]) -> Motion<S> {
        let [first, second, _] = self.turns(one, y);
        let constant = |v: [f64; 3]| Components(v.map(|x| one.times(x)));
        let zero = one.times(0.0);
        let along = |k: usize, x: S| Components(core::array::from_fn(|i| if i == k { x } else { zero }));
        let [a, b, c] = core::array::from_fn(|k| along(k, self.rate(one, y, k)));
        let [more_a, more_b, more_c] = core::array::from_fn(|k| along(k, accelerations[k]));
        let outer = into_outer(first, constant(self.turning)) + a;
        let inner = into_inner(second, outer) + b;
        let outer_rate = outer.cross(a) + more_a;
        let inner_rate = into_inner(second, outer_rate) + inner.cross(b) + more_b;
        let outer_gravity = into_outer(first, constant(self.gravity));
        let inner_gravity = into_inner(second, outer_gravity);
        Motion {
            omega: [outer, inner, inner + c],
            omega_rate: [outer_rate, inner_rate, inner_rate + inner.cross(c) + more_c],
            gravity: [outer_gravity, inner_gravity, inner_gravity],
        }
    }

    /// Solves for q̈ of the free axes; also returns the pivots beyond the first. M is eliminated
    /// from the rotor outwards, so that the last pivot vanishes at gimbal lock.
    fn solved<S: Field>(&self, zero: S, mut m: [[S; 3]; 3], mut right: [S; 3]) -> ([S; 3], Vec<S>) {
        let order: Vec<usize> = (0..3).rev().filter(|&k| self.is_free(k)).collect();
        let mut pivots = Vec::new();
        let whole = m;
        for (done, &k) in order.iter().enumerate() {
            if done > 0 {
                pivots.push(m[k][k] - whole[k][k].times(LOST));
            }
            for &row in &order[done + 1..] {
                let factor = m[row][k] / m[k][k];
                for &column in &order[done + 1..] {
                    m[row][column] = m[row][column] - factor * m[k][column];
                }
                right[row] = right[row] - factor * right[k];
            }
        }
        let mut solution = [zero; 3];
        for (done, &k) in order.iter().enumerate().rev() {
            let rest = order[done + 1..].iter().fold(right[k], |sum, &j| sum - m[k][j] * solution[j]);
            solution[k] = rest / m[k][k];
        }
        (solution, pivots)
    }
}

/// Returns −c q̇ − k (q − q₀) + τ.
fn applied<S: Field>(one: S, axis: &Axis, angle: S, rate: S) -> S {
    let spring = axis.spring().unwrap_or(Spring { stiffness: 0.0, rest: 0.0 });
    let constant = axis.torque() + spring.stiffness * spring.rest;
    one.times(constant) - rate.times(axis.damping()) - angle.times(spring.stiffness)
}

/// Numeric quantities of a sample.
pub(super) struct Reading {
    /// ω of the rotor along the axes of its suspension, and the torque on it about the intersection
    /// of the axes.
    pub(super) omega: [f64; 3],
    pub(super) torque: [f64; 3],
    /// Total L about the intersection of the axes, along the axes of the base.
    pub(super) momentum: [f64; 3],
    pub(super) kinetic_energy: f64,
    pub(super) potential_energy: f64,
}

impl Model {
    /// Returns the quantities of a sample.
    pub(super) fn reading(&self, y: &[f64]) -> Reading {
        let [outer, inner, own] = self.turns(1.0, y);
        let rotor = Rotor::turned(1.0, &self.rotor, own);
        let at = self.motion(1.0, y, self.dynamics(1.0, y).accelerations);
        let [w1, w2, w3] = at.omega;
        let [l1, l2, l3] = [self.outer.image(w1), self.inner.image(w2), rotor.image(w3)];
        let moments = [Components(self.outer.moment), Components(self.inner.moment), rotor.moment];
        let weight: f64 = moments.iter().zip(at.gravity).map(|(moment, g)| moment.dot(g)).sum();
        let torque = rotor.image(at.omega_rate[2]) + w3.cross(l3);
        let into_rotor = |Components([x, y, z]): Components<f64>| {
            let [x, y] = own.back(x, y);
            [x, y, z]
        };
        Reading {
            omega: into_rotor(w3),
            torque: into_rotor(torque),
            momentum: out_of_outer(outer, l1 + out_of_inner(inner, l2 + l3)).0,
            kinetic_energy: 0.5 * (w1.dot(l1) + w2.dot(l2) + w3.dot(l3)),
            // Avoids −0.
            potential_energy: 0.0 - weight,
        }
    }
}
