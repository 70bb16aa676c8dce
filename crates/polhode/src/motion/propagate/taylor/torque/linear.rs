//! Torques that are linear in a vector that is constant in space: constant ones, and gravity at a pivot.

use super::super::row::Row;
use super::super::seen::Seen;
use super::{Known, StepStart, row};
use crate::math::frame::{Body, Principal, Space};
use crate::math::vector::{Direction, Torque};
use crate::motion::propagate::chart::{ROUNDING, THIN};
use crate::motion::rotor::Rotor;
use crate::motion::torque::UniformGravity;

/// N = A v, v̇ = v × Ω: v is constant in space and seen from the body.
#[derive(Clone, Debug)]
pub(in super::super) struct LinearSeries {
    in_space: Direction<Space>,
    /// Columns of A.
    columns: [Row; 3],
    v: Seen,
}

impl LinearSeries {
    pub(super) fn constant(torque: Torque<Space>, rotor: &Rotor) -> Self {
        Self::new(torque.as_quantity(), |v| v, rotor)
    }

    /// N = l × M g
    pub(super) fn gravity(gravity: &UniformGravity, rotor: &Rotor) -> Self {
        let lever: Direction<Body> = (rotor.lever() * rotor.mass()).as_quantity();
        let lever = rotor.principal().rotation().inverse() * lever;
        Self::new(gravity.acceleration.as_quantity(), |v| lever.cross(v), rotor)
    }

    fn new(
        in_space: Direction<Space>,
        a: impl Fn(Direction<Principal>) -> Direction<Principal>,
        rotor: &Rotor,
    ) -> Self {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Direction::from_array);
        Self { in_space, columns: cleaned(axes.map(|axis| a(axis).to_array()), rotor), v: Seen::ZERO }
    }

    pub(super) fn start(&mut self, at: &StepStart) {
        self.v.start(row(at.attitude.inverse() * self.in_space));
    }

    #[inline(always)]
    pub(super) fn coefficient(&self, n: usize) -> Row {
        let [x, y, z, _] = self.v.coefficient(n).0;
        let [a, b, c] = self.columns;
        a * Row::splat(x) + (b * Row::splat(y) + c * Row::splat(z))
    }

    #[inline(always)]
    pub(super) fn extend(&mut self, n: usize, known: &Known<'_>) {
        self.v.extend(n, known.turning, Row::ZERO);
    }
}

/// Columns without what is only rounding along the axis of a needle: divided by so small a moment, it would spin it.
pub(super) fn cleaned(mut columns: [[f64; 3]; 3], rotor: &Rotor) -> [Row; 3] {
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
