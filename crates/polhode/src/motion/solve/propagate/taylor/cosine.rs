//! Series of cos ½θ of the rotation from a torsion's rest attitude.

use super::Expansion;
use crate::math::frame::{Body, Principal, Space};
use crate::math::number::Number;
use crate::math::rotation::{Attitude, Rotation};
use crate::motion::solve::propagate::half_turn::Cosine;

impl<N: Number> Expansion<N> {
    /// Returns the scalar part of rest⁻¹ ∘ q as a function of the time since the start of the step.
    /// q is the quaternion of a lane's body. The scalar part is linear in the quaternion of the
    /// rotation, whose series is known.
    pub(super) fn cosine<'a>(
        &self,
        lane: usize,
        rest: Attitude,
        (base, to_body): (Rotation<Space, Principal>, Rotation<Body, Principal>),
    ) -> Cosine<'a> {
        let (before, after) = (rest.inverse() * base, to_body.inverse());
        let weights: [f64; 4] = core::array::from_fn(|k| {
            let unit = core::array::from_fn(|n| f64::from(u8::from(n == k)));
            let [w, ..] = (before * Rotation::<Principal, Principal>::from_unit(unit) * after).quaternion();
            w
        });
        let coefficient = |n: usize| {
            let turn = self.motion[n].x.first().lane(lane).0;
            weights.iter().zip(turn).map(|(weight, turn)| weight * turn).sum()
        };
        let series: Vec<f64> = (0..=self.order).map(coefficient).collect();
        Box::new(move |after| series.iter().rev().fold(0.0, |sum, term| sum * after + term))
    }
}
