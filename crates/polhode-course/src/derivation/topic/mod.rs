//! The derivations, in the order of the lecture notes.

mod angular_momentum;
mod axes;
mod energy;
mod euler;
mod free;
mod motion;
mod tensor;
mod top;

use super::Derivation;

pub(super) const ALL: &[Derivation] = &[
    energy::KINETIC_ENERGY,
    tensor::INERTIA_TENSOR,
    tensor::CUBE,
    angular_momentum::ANGULAR_MOMENTUM,
    angular_momentum::TORQUE,
    motion::PENDULUM,
    axes::PARALLEL_AXES,
    axes::CHANGE_OF_AXES,
    axes::PRINCIPAL_AXES,
    axes::CUBE_AXES,
    euler::EULER_EQUATIONS,
    euler::SIX_STEPS,
    motion::DUMBBELL,
    top::SYMMETRIC_TOP,
    free::ENERGY_AND_MOMENTUM,
    top::COPLANAR,
    top::CONES,
];
