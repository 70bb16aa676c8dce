//! Input of a law that records values with their derivative: with respect to the state, the inertia
//! or a parameter.

use super::recorder::{NumberNode, Recorder, VectorNode};
use super::varied::{VariedNumber, VariedVector};
use crate::math::algebra::{Scalar as _, VectorAlgebra};
use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::Attitude;
use crate::math::vector::Direction;
use crate::motion::model::law::{LawInput, OrbitPosition};
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;

/// Direction of differentiation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::motion) enum Along {
    /// Rotation about a principal axis.
    Turn(usize),
    /// ω along a principal axis.
    Omega(usize),
    /// Element of the inertia tensor along body axes, in the order xx, yy, zz, xy, xz, yz.
    Inertia(usize),
    /// Parameter of the law, by index.
    Parameter(usize),
}

/// Returns the unit vector of an axis.
fn axis<F>(k: usize) -> Direction<F> {
    Direction::from_array(unit(k))
}

/// Returns 1 at one index and 0 elsewhere.
fn unit<const N: usize>(place: usize) -> [f64; N] {
    core::array::from_fn(|k| f64::from(u8::from(k == place)))
}

/// Records a law, each value with its derivative.
#[derive(Debug)]
pub(in crate::motion) struct Variation<'a, 'r> {
    pub(super) recorder: &'a Recorder<'r>,
    pub(super) along: Along,
}

impl<'r> Variation<'_, 'r> {
    /// Returns the rotation t, if the direction is one. A space-fixed vector v changes by v × t.
    fn turn(&self) -> Option<VectorNode<'r>> {
        match self.along {
            Along::Turn(k) => Some(self.recorder.constant(axis::<Principal>(k))),
            _ => None,
        }
    }

    /// Returns a vector without power series.
    pub(super) fn rough(&self) -> VariedVector<'r> {
        let value = self.recorder.rough();
        VariedVector { value, slope: Some(value) }
    }

    fn constant(&self, value: VectorNode<'r>) -> VariedVector<'r> {
        VariedVector { value, slope: None }
    }

    fn fixed_in_space(&self, value: VectorNode<'r>) -> VariedVector<'r> {
        VariedVector { value, slope: self.turn().map(|turn| value.cross(turn)) }
    }

    /// Returns q ∘ exp(½ t) with its derivative: w′ = −½ v · t, v′ = ½ (w t + v × t).
    fn quaternion(&self, (w, v): (NumberNode<'r>, VectorNode<'r>)) -> (VariedNumber<'r>, VariedVector<'r>) {
        let slopes = self.turn().map(|t| (v.dot(t).scaled(-0.5), (t * w + v.cross(t)).scaled(0.5)));
        let (scalar, vector) = slopes.unzip();
        (VariedNumber { value: w, slope: scalar }, VariedVector { value: v, slope: vector })
    }

    /// Returns the index of the parameter relative to `first`, if it is among `count` consecutive
    /// ones.
    fn parameter_from(&self, first: usize, count: usize) -> Option<usize> {
        match self.along {
            Along::Parameter(which) => which.checked_sub(first).filter(|k| *k < count),
            _ => None,
        }
    }
}

impl<'r> LawInput for Variation<'_, 'r> {
    type Scalar = VariedNumber<'r>;
    type Vector = VariedVector<'r>;

    fn rotor(&self) -> &Rotor {
        self.recorder.rotor()
    }

    fn number(&self, x: f64) -> VariedNumber<'r> {
        VariedNumber { value: self.recorder.number(x), slope: None }
    }

    fn in_body(&self, v: Direction<Body>) -> VariedVector<'r> {
        self.constant(self.recorder.in_body(v))
    }

    fn in_space(&self, v: Direction<Space>) -> VariedVector<'r> {
        self.fixed_in_space(self.recorder.in_space(v))
    }

    fn time(&self) -> VariedNumber<'r> {
        VariedNumber { value: self.recorder.time(), slope: None }
    }

    fn omega(&self) -> VariedVector<'r> {
        let slope = match self.along {
            Along::Omega(k) => Some(self.recorder.constant(axis::<Principal>(k))),
            _ => None,
        };
        VariedVector { value: self.recorder.omega(), slope }
    }

    fn attitude(&self) -> (VariedNumber<'r>, VariedVector<'r>) {
        self.quaternion(self.recorder.attitude())
    }

    fn turn_from(&self, rest: Attitude) -> (VariedNumber<'r>, VariedVector<'r>) {
        self.quaternion(self.recorder.turn_from(rest))
    }

    fn wheel_momentum(&self) -> VariedVector<'r> {
        self.constant(self.recorder.wheel_momentum())
    }

    fn orbit(&self, orbit: &Orbit) -> OrbitPosition<VariedNumber<'r>, VariedVector<'r>> {
        let at = self.recorder.orbit(orbit);
        let number = |value| VariedNumber { value, slope: None };
        OrbitPosition {
            direction: self.fixed_in_space(at.direction),
            square: number(at.square),
            inverse_cube: number(at.inverse_cube),
            distance: number(at.distance),
            strength: number(at.strength),
        }
    }

    fn inertia(&self, v: VariedVector<'r>) -> VariedVector<'r> {
        let image = v.slope.map(|slope| self.recorder.inertia(slope));
        let slope = match self.along {
            Along::Inertia(k) => {
                let more = self.recorder.symmetric(unit(k), v.value);
                Some(image.map_or(more, |image| image + more))
            }
            _ => image,
        };
        VariedVector { value: self.recorder.inertia(v.value), slope }
    }

    fn symmetric(&self, elements: [f64; 6], v: VariedVector<'r>) -> VariedVector<'r> {
        let of = |v| self.recorder.symmetric(elements, v);
        VariedVector { value: of(v.value), slope: v.slope.map(of) }
    }

    fn components(&self, v: VariedVector<'r>) -> [VariedNumber<'r>; 3] {
        let (values, slopes) =
            (self.recorder.components(v.value), v.slope.map(|slope| self.recorder.components(slope)));
        core::array::from_fn(|k| VariedNumber { value: values[k], slope: slopes.map(|slopes| slopes[k]) })
    }

    fn vector(&self, components: [VariedNumber<'r>; 3]) -> VariedVector<'r> {
        let changes = components.iter().any(|component| component.slope.is_some());
        let slope = || self.recorder.vector(components.map(|c| c.slope.unwrap_or(self.recorder.number(0.0))));
        let value = self.recorder.vector(components.map(|component| component.value));
        VariedVector { value, slope: changes.then(slope) }
    }

    fn parameter(&self, which: usize, value: f64) -> VariedNumber<'r> {
        let slope = self.parameter_from(which, 1).map(|_| self.recorder.number(1.0));
        VariedNumber { value: self.recorder.number(value), slope }
    }

    fn body_parameters(&self, first: usize, v: Direction<Body>) -> VariedVector<'r> {
        let slope = self.parameter_from(first, 3).map(|k| self.recorder.in_body(axis(k)));
        VariedVector { value: self.recorder.in_body(v), slope }
    }

    fn space_parameters(&self, first: usize, v: Direction<Space>) -> VariedVector<'r> {
        match self.parameter_from(first, 3) {
            Some(k) => VariedVector {
                value: self.recorder.in_space(v),
                slope: Some(self.recorder.in_space(axis(k))),
            },
            None => self.in_space(v),
        }
    }

    fn moment_parameters(&self, first: usize, [r, force]: [Direction<Body>; 2]) -> VariedVector<'r> {
        self.body_parameters(first, r).cross(self.body_parameters(first + 3, force))
    }

    fn symmetric_parameters(
        &self,
        first: usize,
        elements: [f64; 6],
        v: VariedVector<'r>,
    ) -> VariedVector<'r> {
        let of = self.symmetric(elements, v);
        match self.parameter_from(first, 6) {
            Some(k) => VariedVector { slope: Some(self.recorder.symmetric(unit(k), v.value)), ..of },
            None => of,
        }
    }
}
