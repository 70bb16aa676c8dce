//! Taylor coefficients of torques, principal axes, from the preceding coefficients of the motion.
//!
//! Linear and quadratic torques become part of the recurrence of the motion (`quadratic.rs`), and
//! functions of time are expanded before it (`forcing.rs`). One function of all components of ω has
//! its own recurrence (`componentwise.rs`). The operations of all other laws are evaluated
//! coefficient by coefficient (`tape.rs`).

mod componentwise;
mod forcing;
mod norm;
mod orbit;
mod quadratic;
mod tape;

use super::recurrence::Motion;
use super::row::{Row, Vectors};
use super::sums::SeriesSums;
use crate::math::frame::{Principal, Space};
use crate::math::number::Number;
use crate::math::rotation::Rotation;
use crate::math::vector::Vector;

pub(super) use componentwise::Componentwise;
pub(super) use forcing::Forcing;
pub(super) use quadratic::{Decomposition, Quadratic, TorqueKind};
pub(super) use tape::Tape;

/// State from which a step starts.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepStart<N = f64> {
    pub(super) time: N,
    /// Quaternion of the principal axes.
    pub(super) attitude: Row<N>,
    /// ω, principal axes, rad/s.
    pub(super) omega: Row<N>,
    /// Low word of ω.
    pub(super) omega_low: Row<N>,
}

impl<N: Number> StepStart<N> {
    /// Returns time and attitude of a lane.
    fn lane(&self, lane: usize) -> (f64, Rotation<Space, Principal>) {
        (self.time.lane(lane), Rotation::from_unit(self.attitude.lane(lane).0))
    }

    /// Returns a space vector along the principal axes, v + 2w (u × v) + 2 u × (u × v), with the
    /// same operations as the product with a [`Rotation`].
    #[inline(always)]
    fn resolved(&self, v: Row<N>) -> Row<N> {
        let [w, x, y, z] = self.attitude.0;
        let two = Row::splat(w.like(2.0));
        let u = Row([-x, -y, -z, w.like(0.0)]);
        let t = cross(u, v) * two;
        v + t * Row::splat(w) + cross(u, t)
    }
}

/// Returns a × b.
#[inline(always)]
fn cross<N: Number>(a: Row<N>, b: Row<N>) -> Row<N> {
    let ([a1, a2, a3, zero], [b1, b2, b3, _]) = (a.0, b.0);
    Row([a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1, zero])
}

/// Series known so far, up to coefficient n, principal axes.
#[derive(Clone, Copy)]
pub(super) struct Known<'a, M: SeriesSums> {
    /// Implementation of the sums.
    pub(super) s: M,
    /// ω, principal axes.
    pub(super) omega: &'a Vectors<M::N>,
    /// Ω, angular velocity of the axes; equal to ω without internal friction.
    pub(super) turning: &'a Vectors<M::N>,
    /// Motion, including the rotation since the start of the step.
    pub(super) motion: &'a Motion<M::N>,
}

impl<'a, M: SeriesSums> Known<'a, M> {
    /// Returns coefficient n of the rotation since the start of the step.
    #[inline(always)]
    fn turn(&self, n: usize) -> Row<M::N> {
        self.motion[n].x.first()
    }

    /// Runs long work in a separate function; see [`SeriesSums::apart`].
    #[inline(always)]
    pub(super) fn apart<R>(&self, work: impl FnOnce(&Known<'a, M>) -> R) -> R {
        let Self { omega, turning, motion, .. } = *self;
        self.s.apart(
            #[inline(always)]
            |s| work(&Known { s, omega, turning, motion }),
        )
    }
}

pub(super) fn row<Q, F>(v: Vector<Q, F>) -> Row {
    let [x, y, z] = v.to_array();
    Row([x, y, z, 0.0])
}
