//! Taylor coefficients of torques, principal axes: each model's from those of ω before it.

use super::row::{Row, Vectors};
use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{Direction, Vector};
use crate::motion::propagate::chart::{ROUNDING, THIN};
use crate::motion::rotor::Rotor;
use crate::motion::torque::{ConstantTorque, TorqueModel};

/// The series of one torque over one step.
#[derive(Clone, Debug)]
pub(super) enum TorqueSeries {
    /// Constant along the body's axes.
    Body(Row),
    /// Linear in a vector that is constant in space.
    Space(Box<SpaceVector>),
}

/// N = A v, v̇ = v × ω: v is constant in space and seen from the body.
#[derive(Clone, Debug)]
pub(super) struct SpaceVector {
    in_space: Direction<Space>,
    /// Columns of A.
    columns: [Row; 3],
    v: Vectors,
}

impl TorqueSeries {
    pub(super) fn of(model: &TorqueModel, rotor: &Rotor) -> Self {
        let r = rotor.principal().rotation().inverse();
        let axes =
            [Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0), Direction::new(0.0, 0.0, 1.0)];
        let linear = |in_space: Direction<Space>,
                      a: &dyn Fn(Direction<Principal>) -> Direction<Principal>| {
            let columns = axes.map(|axis| a(axis).to_array());
            Self::Space(Box::new(SpaceVector {
                in_space,
                columns: cleaned(columns, rotor),
                v: Vectors::ZERO,
            }))
        };
        match model {
            TorqueModel::Constant(ConstantTorque::Body(n)) => Self::Body(row(r * *n)),
            TorqueModel::Constant(ConstantTorque::Space(n)) => linear(n.as_quantity(), &|v| v),
            // N = l × M g
            TorqueModel::Gravity(gravity) => {
                let lever: Direction<Body> = (rotor.lever() * rotor.mass()).as_quantity();
                let lever = r * lever;
                linear(gravity.acceleration.as_quantity(), &|v| lever.cross(v))
            }
        }
    }

    /// Starts a step at an attitude.
    pub(super) fn start(&mut self, attitude: Rotation<Space, Principal>) {
        if let Self::Space(space) = self {
            space.v.set(0, row(attitude.inverse() * space.in_space));
        }
    }

    /// Coefficient n of N, once ω has its coefficients up to n.
    #[inline(always)]
    pub(super) fn coefficient(&self, n: usize) -> Row {
        match self {
            Self::Body(torque) if n == 0 => *torque,
            Self::Body(_) => Row::ZERO,
            Self::Space(space) => {
                let [x, y, z, _] = space.v.rows[n].0;
                let [a, b, c] = space.columns;
                a * Row::splat(x) + (b * Row::splat(y) + c * Row::splat(z))
            }
        }
    }

    /// Finds what coefficient n + 1 needs beside ω.
    #[inline(always)]
    pub(super) fn extend(&mut self, n: usize, omega: &Vectors) {
        if let Self::Space(space) = self {
            let next = space.v.cross(omega, n) * Row::splat(1.0 / (n + 1) as f64);
            space.v.set(n + 1, next);
        }
    }
}

pub(super) fn row<Q>(v: Vector<Q, Principal>) -> Row {
    let [x, y, z] = v.to_array();
    Row([x, y, z, 0.0])
}

/// Columns without what is only rounding along the axis of a needle: divided by so small a moment, it would spin it.
fn cleaned(mut columns: [[f64; 3]; 3], rotor: &Rotor) -> [Row; 3] {
    let moments = rotor.principal().moments();
    let size = |k: usize| columns.iter().map(|column| column[k].abs()).fold(0.0, f64::max);
    let sizes = [size(0), size(1), size(2)];
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    for k in 0..2 {
        if moments[k] < THIN * moments[2] && sizes[k] < ROUNDING * largest {
            columns.iter_mut().for_each(|column| column[k] = 0.0);
        }
    }
    columns.map(|[x, y, z]| Row([x, y, z, 0.0]))
}
