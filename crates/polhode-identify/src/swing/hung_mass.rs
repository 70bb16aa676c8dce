//! Suspended mass: the body in its placement, and a fixture that moves with it.

use polhode::math::{Body, Position, Rotation, Space};

use super::dual::Gradient;
use super::number::{CENTER, Linear, MASS, Numbers, Point, TENSOR};
use crate::six::PLACES;

/// Placement of the body in a rig: r_rig = R r_body + origin. The rig's axes are those of space at
/// rest, z up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Rotation R from body axes to rig axes.
    pub rotation: Rotation<Space, Body>,
    /// Position of the body's origin in the rig, m.
    pub origin: Position<Space>,
}

impl Placement {
    /// Placement with the body's axes and origin equal to those of the rig.
    pub const AS_IT_IS: Self = Self { rotation: Rotation::identity(), origin: Position::ZERO };
}

/// Object that moves with the body in the rig: a platform, a frame, a body of known inertia.
#[derive(Clone, Debug, PartialEq)]
pub struct Fixture {
    /// Mass, kg.
    pub mass: Linear,
    /// Centre of mass in the rig, m.
    pub center: Point,
    /// Ixx, Iyy, Izz, Ixy, Ixz, Iyz about its centre of mass, along the axes of the rig, products
    /// as −∫xy dm, kg·m².
    pub inertia: [Linear; 6],
}

/// Mass, centre and tensor about it, along the axes of the rig.
#[derive(Clone, Debug)]
pub(super) struct HungMass {
    pub(super) mass: Gradient,
    pub(super) center: [Gradient; 3],
    pub(super) inertia: [Gradient; 6],
}

/// Index of the tensor element at each row and column.
const ELEMENT: [[usize; 3]; 3] = [[0, 3, 4], [3, 1, 5], [4, 5, 2]];

impl HungMass {
    pub(super) fn of_body(numbers: &Numbers, placement: &Placement) -> Self {
        let (r, n) = (placement.rotation.matrix(), numbers.count());
        let origin = placement.origin.to_array();
        let center = [0, 1, 2].map(|i| {
            let mut c = Gradient::sum(n, (0..3).map(|j| (r[i][j], numbers.at(CENTER + j))));
            c.value += origin[i];
            c
        });
        let inertia = PLACES.map(|(i, j)| {
            let terms = (0..3).flat_map(|a| (0..3).map(move |b| (a, b)));
            Gradient::sum(n, terms.map(|(a, b)| (r[i][a] * r[j][b], numbers.at(TENSOR + ELEMENT[a][b]))))
        });
        Self { mass: numbers.at(MASS).clone(), center, inertia }
    }

    pub(super) fn of_fixture(numbers: &Numbers, fixture: &Fixture) -> Self {
        Self {
            mass: numbers.linear(&fixture.mass),
            center: numbers.point(&fixture.center),
            inertia: [0, 1, 2, 3, 4, 5].map(|k| numbers.linear(&fixture.inertia[k])),
        }
    }

    /// Returns the sum of both masses: I = I₁ + I₂ + μ (d² 1 − d dᵀ), μ = m₁ m₂/(m₁ + m₂), with d
    /// from one centre to the other.
    pub(super) fn joined(&self, other: &Self) -> Self {
        let mass = self.mass.plus(&other.mass);
        let share = other.mass.over(&mass);
        let d = [0, 1, 2].map(|k| other.center[k].minus(&self.center[k]));
        let center = [0, 1, 2].map(|k| self.center[k].plus(&share.times(&d[k])));
        let point = point_mass(&self.mass.times(&share), &d);
        let inertia = [0, 1, 2, 3, 4, 5].map(|k| self.inertia[k].plus(&other.inertia[k]).plus(&point[k]));
        Self { mass, center, inertia }
    }

    /// Returns the moment nᵀ I n about the centre.
    pub(super) fn about(&self, n: [f64; 3]) -> Gradient {
        let terms = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
        Gradient::sum(self.mass.by.len(), terms.map(|(i, j)| (n[i] * n[j], &self.inertia[ELEMENT[i][j]])))
    }

    /// Returns the mass with an additional moment of inertia about the axis n.
    pub(super) fn with_moment(mut self, n: [f64; 3], moment: &Gradient) -> Self {
        for (element, (i, j)) in self.inertia.iter_mut().zip(PLACES) {
            *element = element.plus(&moment.scaled(n[i] * n[j]));
        }
        self
    }
}

/// Returns the tensor m (d² 1 − d dᵀ) of a point mass.
fn point_mass(m: &Gradient, d: &[Gradient; 3]) -> [Gradient; 6] {
    let square = d[0].times(&d[0]).plus(&d[1].times(&d[1])).plus(&d[2].times(&d[2]));
    PLACES.map(|(i, j)| {
        let product = d[i].times(&d[j]);
        m.times(&if i == j { square.minus(&product) } else { product.scaled(-1.0) })
    })
}
