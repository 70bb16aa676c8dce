//! Taylor coefficients of torques, principal axes: from those of the motion before them.
//!
//! What is linear or quadratic goes to the recurrence of the motion itself (`quadratic.rs`); of all else the operations of the laws are
//! worked out coefficient by coefficient (`tape.rs`).

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

pub(super) use quadratic::{Decomposition, Quadratic, TorqueKind};
pub(super) use tape::Tape;

/// The state that a step starts from.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepStart<N = f64> {
    pub(super) time: N,
    /// The quaternion of the principal axes.
    pub(super) attitude: Row<N>,
    /// Principal axes; and what rounding left of it.
    pub(super) omega: Row<N>,
    pub(super) omega_low: Row<N>,
}

impl<N: Number> StepStart<N> {
    /// Time and attitude of a lane.
    fn lane(&self, lane: usize) -> (f64, Rotation<Space, Principal>) {
        (self.time.lane(lane), Rotation::from_unit(self.attitude.lane(lane).0))
    }

    /// A vector of space along the principal axes, v + 2w (u × v) + 2 u × (u × v): as the product with a [`Rotation`] has it.
    #[inline(always)]
    fn resolved(&self, v: Row<N>) -> Row<N> {
        let [w, x, y, z] = self.attitude.0;
        let two = Row::splat(w.like(2.0));
        let u = Row([-x, -y, -z, w.like(0.0)]);
        let t = cross(u, v) * two;
        v + t * Row::splat(w) + cross(u, t)
    }
}

/// a × b
#[inline(always)]
fn cross<N: Number>(a: Row<N>, b: Row<N>) -> Row<N> {
    let ([a1, a2, a3, zero], [b1, b2, b3, _]) = (a.0, b.0);
    Row([a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1, zero])
}

/// Coefficients up to n, principal axes.
#[derive(Clone, Copy)]
pub(super) struct Known<'a, M: SeriesSums> {
    /// How sums are done.
    pub(super) s: M,
    /// ω
    pub(super) omega: &'a Vectors<M::N>,
    /// Ω, at which the axes turn: ω unless friction inside the body makes a difference.
    pub(super) turning: &'a Vectors<M::N>,
    /// With the turn since the start of the step.
    pub(super) motion: &'a Motion<M::N>,
}

impl<'a, M: SeriesSums> Known<'a, M> {
    /// Coefficient n of the turn since the start of the step.
    #[inline(always)]
    fn turn(&self, n: usize) -> Row<M::N> {
        self.motion[n].x.first()
    }

    /// Runs what is long apart.
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
