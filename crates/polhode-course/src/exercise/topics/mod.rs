//! Topics: Thornton & Marion, *Classical Dynamics of Particles and Systems*, chapter 11.

mod body;
mod energy;
mod euler;
mod pendulum;
mod principal;
mod shift;
mod tensor;
mod top;

use super::topic::{Datum, Topic, computed, hidden, signed};

/// All topics in the order of the chapter.
pub(super) const TOPICS: [&[Topic]; 8] = [
    &tensor::TOPICS,
    &shift::TOPICS,
    &body::TOPICS,
    &principal::TOPICS,
    &energy::TOPICS,
    &pendulum::TOPICS,
    &euler::TOPICS,
    &top::TOPICS,
];

/// Returns all topics in order.
pub(super) fn all() -> impl Iterator<Item = &'static Topic> {
    TOPICS.into_iter().flatten()
}

/// Tensor of a possible body: p, q and r are ∫x² dm, ∫y² dm and ∫z² dm, and more than twice each
/// product of inertia, so that the matrix of second moments is positive definite.
const TENSOR: [Datum; 9] = [
    hidden("p", 21, 59, 2),
    hidden("q", 21, 59, 2),
    hidden("r", 21, 59, 2),
    computed("I_xx", "kg m^2", "q + r"),
    computed("I_yy", "kg m^2", "p + r"),
    computed("I_zz", "kg m^2", "p + q"),
    signed("I_xy", "kg m^2", 31, 99, 3),
    signed("I_xz", "kg m^2", 31, 99, 3),
    signed("I_yz", "kg m^2", 31, 99, 3),
];

/// Different principal moments of a possible body.
const MOMENTS: [Datum; 6] = [
    hidden("p", 21, 89, 2),
    hidden("q", 21, 89, 2),
    hidden("r", 21, 89, 2),
    computed("I_1", "kg m^2", "q + r"),
    computed("I_2", "kg m^2", "p + r"),
    computed("I_3", "kg m^2", "p + q"),
];
