//! Body that turns about a fixed axis.

use nalgebra::DMatrix;
use polhode::math::{Direction, Space};

use super::super::dual::Gradient;
use super::super::number::{Linear, Numbers, Point};
use super::{Equations, Load, Oscillator, Rest};
use crate::error::IdentifyError;

/// Fixed axis of rotation: level for a compound pendulum or a knife edge, upright for a torsion
/// spindle.
///
/// Consider a level axis through P, with the centre of mass at a distance l below it. The edge is
/// round with radius ρ and rolls on a level plane, and h = l + ρ. Then
///
/// T = ½ \[I + m (h² + ρ² − 2 ρ h cos θ)\] θ̇²,  V = −W h cos θ + ½ κ θ²,
///
/// where I is the moment of inertia about the parallel axis through the centre of mass, and W is
/// the weight minus the buoyancy. With ρ = κ = 0 the period is 4 K(sin² ½A) √((I + m h²)/(W h)).
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    point: Point,
    direction: Direction<Space>,
    is_level: bool,
    edge_radius: Linear,
    stiffness: Linear,
}

impl Axis {
    /// Creates a level axis through a point of the rig, with a direction in the rig: a compound
    /// pendulum.
    pub fn level(point: impl Into<Point>, direction: Direction<Space>) -> Self {
        Self {
            point: point.into(),
            direction,
            is_level: true,
            edge_radius: Linear::default(),
            stiffness: Linear::default(),
        }
    }

    /// Creates an upright axis with the stiffness of a spring or wire, N·m/rad. Weight has no
    /// effect.
    pub fn upright(
        point: impl Into<Point>,
        direction: Direction<Space>,
        stiffness: impl Into<Linear>,
    ) -> Self {
        Self { is_level: false, ..Self::level(point, direction).with_stiffness(stiffness) }
    }

    /// Sets the radius (m) of an edge that rolls on a level plane; the point of the axis is the
    /// contact point at rest.
    #[must_use]
    pub fn with_edge(mut self, radius: impl Into<Linear>) -> Self {
        self.edge_radius = radius.into();
        self
    }

    /// Sets the stiffness of a flexure that acts in addition to the weight, N·m/rad.
    #[must_use]
    pub fn with_stiffness(mut self, stiffness: impl Into<Linear>) -> Self {
        self.stiffness = stiffness.into();
        self
    }

    pub(super) fn unit(&self) -> [f64; 3] {
        self.direction.direction().map_or([0.0; 3], Direction::to_array)
    }

    pub(super) fn check(&self, count: usize) -> Result<(), IdentifyError> {
        let length = self.direction.norm();
        IdentifyError::require("the length of an axis", length, length > 0.0, "above zero, and finite")?;
        let all = self.point.0.iter().chain([&self.edge_radius, &self.stiffness]);
        super::wires::all_of(all, count)
    }
}

/// Equation of motion (a − 2 b cos θ) θ̈ + b sin θ θ̇² + w sin θ + κ θ = 0 with
/// a = I + m (h² + ρ²), b = m ρ h, w = W h.
pub(super) struct Held {
    quantities: [Gradient; 4],
    rest: Rest,
}

impl Held {
    pub(super) fn new(axis: &Axis, numbers: &Numbers, load: &Load) -> Result<Self, IdentifyError> {
        let n = axis.unit();
        let point = numbers.point(&axis.point);
        let d = [0, 1, 2].map(|k| load.mass.center[k].minus(&point[k]));
        let along = Gradient::sum(numbers.count(), n.into_iter().zip(&d));
        let across = [0, 1, 2].map(|k| d[k].minus(&along.scaled(n[k])));
        let square =
            across.iter().fold(numbers.constant(0.0), |sum, component| sum.plus(&component.times(component)));
        let own = load.mass.about(n);
        let stiffness = numbers.linear(&axis.stiffness);
        let m = &load.mass.mass;
        let quantities = if axis.is_level {
            let distance = square.value.sqrt();
            IdentifyError::above_zero("the distance of the centre of mass from the axis", distance)?;
            let radius = numbers.linear(&axis.edge_radius);
            let h = square.root().plus(&radius);
            let squares = h.times(&h).plus(&radius.times(&radius));
            [own.plus(&m.times(&squares)), m.times(&radius).times(&h), load.weight.times(&h), stiffness]
        } else {
            [own.plus(&m.times(&square)), numbers.constant(0.0), numbers.constant(0.0), stiffness]
        };
        let [a, b, w, k] = [0, 1, 2, 3].map(|k| quantities[k].value);
        let (inertia, stiffness) = (a - 2.0 * b, w + k);
        IdentifyError::above_zero("the moment of inertia about the axis", inertia)?;
        IdentifyError::above_zero("the restoring stiffness, N·m/rad", stiffness)?;
        let rest = Rest { u: vec![0.0], mode: vec![1.0], rate: (stiffness / inertia).sqrt() };
        Ok(Self { quantities, rest })
    }
}

impl Oscillator for Held {
    fn width(&self) -> usize {
        1
    }

    fn quantities(&self) -> &[Gradient] {
        &self.quantities
    }

    fn equations(&self, u: &[f64], rate: &[f64], acceleration: &[f64], _: bool) -> Equations {
        let [a, b, w, k] = [0, 1, 2, 3].map(|k| self.quantities[k].value);
        let (angle, rate, acceleration) = (u[0], rate[0], acceleration[0]);
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let inertia = a - 2.0 * b * cos;
        let one = |value| DMatrix::from_element(1, 1, value);
        Equations {
            value: vec![inertia * acceleration + b * sin * rate * rate + w * sin + k * angle],
            by_u: one(2.0 * b * sin * acceleration + b * cos * rate * rate + w * cos + k),
            by_rate: one(2.0 * b * sin * rate),
            by_acceleration: one(inertia),
            by_quantities: DMatrix::from_row_slice(
                1,
                4,
                &[acceleration, -2.0 * cos * acceleration + sin * rate * rate, sin, angle],
            ),
        }
    }

    fn angle(&self, u: &[f64]) -> (f64, Vec<f64>) {
        (u[0], vec![1.0])
    }

    fn check(&self, _: &[f64]) -> Result<(), IdentifyError> {
        Ok(())
    }

    fn rest(&self) -> &Rest {
        &self.rest
    }
}
