//! How mass properties depend on what a body is made of.

use core::ops::{Add, Mul};

use super::mass_properties::MassProperties;
use super::shape::Extent;
use crate::math::frame::{Body, Frame, Part};
use crate::math::rotation::Rotation;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{Direction, Position};

/// The derivative of mass properties by one number: of the mass, kg, of the centre of mass, m, and of the inertia tensor about the centre of
/// mass, kg·m², each per unit of that number, along the axes of `F`.
///
/// A body is a sum of parts: [`MassPropertiesDerivative::of_whole`] takes what a part changes by to what the whole changes by. Assemblies,
/// particles and meshes have types of their own: [`AssemblyDerivatives`](super::AssemblyDerivatives),
/// [`ParticleDerivatives`](super::ParticleDerivatives), [`MeshDerivatives`](super::mesh::MeshDerivatives).
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties, MassPropertiesDerivative};
/// use polhode::math::{Body, Position};
/// let inertia = InertiaTensor::<Body>::diagonal([1.0, 2.0, 2.5])?;
/// let body = MassProperties::new(4.0, Position::new(0.0, 0.0, 1.0), inertia)?;
/// // The same form, heavier.
/// let by_mass = MassPropertiesDerivative::by_mass(&body);
/// assert_eq!((by_mass.mass, by_mass.inertia[1]), (1.0, 0.5));
/// // Turned about the third axis: I_xy changes by I_xx − I_yy for each radian.
/// let [.., about_z] = MassPropertiesDerivative::by_rotation(&body, Position::ZERO);
/// assert_eq!(about_z.inertia, [0.0, 0.0, 0.0, -1.0, 0.0, 0.0]);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassPropertiesDerivative<F> {
    /// Of the mass.
    pub mass: f64,
    /// Of the centre of mass.
    pub center_of_mass: Position<F>,
    /// Of the elements of the inertia tensor about the centre of mass: xx, yy, zz, xy, xz, yz, as
    /// [`StateDerivatives`](crate::motion::StateDerivatives) has its columns.
    pub inertia: [f64; 6],
}

impl<F: Frame> MassPropertiesDerivative<F> {
    /// By the mass, kg, of a body whose form and distribution of mass stay: ∂M = 1, ∂c = 0, ∂I = I/M.
    pub fn by_mass(body: &MassProperties<F>) -> Self {
        let inertia = *body.inertia().symmetric() * (1.0 / body.mass());
        Self { mass: 1.0, center_of_mass: Position::ZERO, inertia: inertia.elements() }
    }

    /// By the density of a body that has the same everywhere: kg/m³ of a solid, kg/m² of what is thin, kg/m of a rod.
    pub fn by_density(body: &MassProperties<F>, extent: Extent) -> Self {
        Self::by_mass(body) * extent.measure()
    }

    /// By a translation along each axis, m.
    pub fn by_translation() -> [Self; 3] {
        UNITS.map(|unit| Self { mass: 0.0, center_of_mass: Position::from_array(unit), inertia: [0.0; 6] })
    }

    /// By a small rotation vector θ along the axes of `F`, rad, of the body about a point: R → exp(θ) R.
    ///
    /// ∂c = θ × (c − p),  ∂I = \[θ\]ₓ I − I \[θ\]ₓ
    pub fn by_rotation(body: &MassProperties<F>, point: Position<F>) -> [Self; 3] {
        Self::by_turn(body, body.center_of_mass() - point)
    }

    /// The same, with the arm from the point to the centre of mass.
    pub(super) fn by_turn(body: &MassProperties<F>, arm: Position<F>) -> [Self; 3] {
        let rows = body.inertia().matrix();
        let arm = arm.to_array();
        UNITS.map(|axis| {
            let cross = |[x, y, z]: [f64; 3]| {
                let [a, b, c] = axis;
                [b * z - c * y, c * x - a * z, a * y - b * x]
            };
            // [θ]ₓ I by columns, which are I's rows; and its transpose is −I [θ]ₓ.
            let half = rows.map(cross);
            let element = |i: usize, j: usize| half[i][j] + half[j][i];
            Self {
                mass: 0.0,
                center_of_mass: Position::from_array(cross(arm)),
                inertia: [
                    element(0, 0),
                    element(1, 1),
                    element(2, 2),
                    element(0, 1),
                    element(0, 2),
                    element(1, 2),
                ],
            }
        })
    }

    /// What a whole changes by if this is what a part of it changes by: with d from the centre of mass of the whole to the part's,
    ///
    /// ∂M = ∂m,  ∂C = (d ∂m + m ∂c)/M,  ∂I_whole = ∂I + (d² 1 − d dᵀ) ∂m + m (2 d·∂c 1 − d ∂cᵀ − ∂c dᵀ)
    ///
    /// How the centre of the whole moves does not matter to its tensor, as Σ m d = 0. A particle, and a part that is not there yet, has its mass
    /// and place alone: `by_mass` with `inertia` zero.
    #[must_use]
    pub fn of_whole(&self, part: &MassProperties<F>, whole: &MassProperties<F>) -> Self {
        self.of_sum(part.mass(), part.center_of_mass() - whole.center_of_mass(), whole.mass())
    }

    pub(super) fn of_sum(&self, mass: f64, lever: Position<F>, whole: f64) -> Self {
        let moved = self.center_of_mass * mass;
        let steiner = Symmetric3::outer(lever.to_array()) * self.mass;
        let moving = Symmetric3::twice_outer(lever.to_array(), moved.to_array());
        let own = Symmetric3::from_elements(self.inertia);
        Self {
            mass: self.mass,
            center_of_mass: (lever * self.mass + moved) * (1.0 / whole),
            inertia: (own + (steiner + moving).inertia_of_second_moments()).elements(),
        }
    }

    /// The same along the axes of `A`.
    #[must_use]
    pub fn in_frame<A: Frame>(&self, r: Rotation<A, F>) -> MassPropertiesDerivative<A> {
        MassPropertiesDerivative {
            mass: self.mass,
            center_of_mass: r * self.center_of_mass,
            inertia: Symmetric3::from_elements(self.inertia).rotated(&r.matrix()).elements(),
        }
    }
}

const UNITS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Of two numbers that change together.
impl<F> Add for MassPropertiesDerivative<F> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            center_of_mass: self.center_of_mass + other.center_of_mass,
            inertia: core::array::from_fn(|k| self.inertia[k] + other.inertia[k]),
        }
    }
}

/// By a number of which so many are one of the other.
impl<F> Mul<f64> for MassPropertiesDerivative<F> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self {
            mass: self.mass * factor,
            center_of_mass: self.center_of_mass * factor,
            inertia: self.inertia.map(|x| x * factor),
        }
    }
}

/// How one number depends on mass properties: its derivatives by the mass, the centre of mass and the inertia tensor about it.
///
/// It takes any number of changes at the cost of one: what mass properties change by gives the number's change
/// ([`MassPropertiesGradient::along`]), and a mesh has its derivatives by all vertices
/// ([`MeshDerivatives::gradient`](super::mesh::MeshDerivatives::gradient)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassPropertiesGradient<F> {
    /// By the mass, per kg.
    pub by_mass: f64,
    /// By the centre of mass, per m.
    pub by_center_of_mass: Direction<F>,
    /// By xx, yy, zz, xy, xz, yz of the tensor, per kg·m²; I_xy = I_yx is one number.
    pub by_inertia: [f64; 6],
}

impl MassPropertiesGradient<Body> {
    /// The same by the mass properties of a part that is all of the body, whose axes are the body's: as
    /// [`MassProperties::into_body`] takes it.
    #[must_use]
    pub fn in_part(&self) -> MassPropertiesGradient<Part> {
        self.pulled_back(|change| change.in_frame(Rotation::identity()))
    }
}

impl<F: Frame> MassPropertiesGradient<F> {
    /// What the number changes by if this is what the mass properties change by.
    pub fn along(&self, change: &MassPropertiesDerivative<F>) -> f64 {
        let of_inertia = self.by_inertia.iter().zip(change.inertia).map(|(g, x)| g * x).sum::<f64>();
        self.by_mass * change.mass + self.by_center_of_mass.dot(change.center_of_mass) + of_inertia
    }

    /// The gradient by a part's mass properties of a number that depends on the whole's, from what these change by.
    pub(super) fn pulled_back<A: Frame>(
        &self,
        of: impl Fn(&MassPropertiesDerivative<A>) -> MassPropertiesDerivative<F>,
    ) -> MassPropertiesGradient<A> {
        let none = MassPropertiesDerivative { mass: 0.0, center_of_mass: Position::ZERO, inertia: [0.0; 6] };
        let by = |change: MassPropertiesDerivative<A>| self.along(&of(&change));
        MassPropertiesGradient {
            by_mass: by(MassPropertiesDerivative { mass: 1.0, ..none }),
            by_center_of_mass: Direction::from_array(MassPropertiesDerivative::by_translation().map(by)),
            by_inertia: core::array::from_fn(|k| {
                let mut inertia = [0.0; 6];
                inertia[k] = 1.0;
                by(MassPropertiesDerivative { inertia, ..none })
            }),
        }
    }
}
