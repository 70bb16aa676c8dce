//! Derivatives of mass properties with respect to the parameters of a body.

use core::ops::{Add, Mul};

use super::mass_properties::MassProperties;
use super::shape::Extent;
use crate::math::frame::{Body, Frame, Part};
use crate::math::rotation::Rotation;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{Direction, Position};

/// Derivative of mass properties with respect to one parameter: of the mass, kg, of the centre of
/// mass, m, and of the inertia tensor about the centre of mass, kg·m². Each is per unit of that
/// parameter, along the axes of `F`.
///
/// A body is a sum of parts: [`MassPropertiesDerivative::of_whole`] converts the derivative of a
/// part to the derivative of the whole. Assemblies, particles and meshes have their own types:
/// [`AssemblyDerivatives`](super::AssemblyDerivatives),
/// [`ParticleDerivatives`](super::ParticleDerivatives),
/// [`MeshDerivatives`](super::mesh::MeshDerivatives).
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
    /// Derivative of the mass, kg per unit of the parameter.
    pub mass: f64,
    /// Derivative of the centre of mass, m per unit of the parameter.
    pub center_of_mass: Position<F>,
    /// Derivatives of the elements xx, yy, zz, xy, xz, yz of the inertia tensor about the centre of
    /// mass, kg·m² per unit of the parameter. The columns of
    /// [`StateDerivatives`](crate::motion::StateDerivatives) have the same order.
    pub inertia: [f64; 6],
}

impl<F: Frame> MassPropertiesDerivative<F> {
    /// Returns the derivative with respect to the mass, per kg, at constant shape and constant
    /// relative distribution of mass: ∂M = 1, ∂c = 0, ∂I = I/M.
    pub fn by_mass(body: &MassProperties<F>) -> Self {
        let inertia = *body.inertia().symmetric() * (1.0 / body.mass());
        Self { mass: 1.0, center_of_mass: Position::ZERO, inertia: inertia.elements() }
    }

    /// Returns the derivative with respect to the density of a homogeneous body: per kg/m³ for a
    /// solid, per kg/m² for a thin surface, per kg/m for a rod.
    pub fn by_density(body: &MassProperties<F>, extent: Extent) -> Self {
        Self::by_mass(body) * extent.measure()
    }

    /// Returns the derivatives with respect to a translation along each axis, per m.
    pub fn by_translation() -> [Self; 3] {
        UNITS.map(|unit| Self { mass: 0.0, center_of_mass: Position::from_array(unit), inertia: [0.0; 6] })
    }

    /// Returns the derivatives with respect to a small rotation vector θ of the body about
    /// `point` = p, along the axes of `F`, per rad: R → exp(θ) R.
    ///
    /// ∂c = θ × (c − p),  ∂I = \[θ\]ₓ I − I \[θ\]ₓ
    pub fn by_rotation(body: &MassProperties<F>, point: Position<F>) -> [Self; 3] {
        Self::by_turn(body, body.center_of_mass() - point)
    }

    /// Returns the derivatives of `by_rotation`, given the vector `arm` from the point to the
    /// centre of mass.
    pub(super) fn by_turn(body: &MassProperties<F>, arm: Position<F>) -> [Self; 3] {
        let rows = body.inertia().matrix();
        let arm = arm.to_array();
        UNITS.map(|axis| {
            let cross = |[x, y, z]: [f64; 3]| {
                let [a, b, c] = axis;
                [b * z - c * y, c * x - a * z, a * y - b * x]
            };
            // [θ]ₓ I by columns, which are the rows of I; −I [θ]ₓ is its transpose.
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

    /// Converts this derivative of a part to the derivative of the whole. With d from the centre of
    /// mass of the whole to that of the part,
    ///
    /// ∂M = ∂m,  ∂C = (d ∂m + m ∂c)/M,
    /// ∂I_whole = ∂I + (d² 1 − d dᵀ) ∂m + m (2 d·∂c 1 − d ∂cᵀ − ∂c dᵀ)
    ///
    /// The motion of the whole's centre of mass does not affect its tensor, because Σ m d = 0. For
    /// a particle, or for a part that is not yet in the body, only its mass and position matter:
    /// use `by_mass` with `inertia` zero.
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

    /// Returns the derivative along the axes of `A`.
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

/// Sum of the derivatives with respect to two parameters that change together.
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

/// Derivative with respect to another parameter, one unit of which equals `factor` units of this
/// one.
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

/// Gradient of a scalar with respect to mass properties: its derivatives with respect to the mass,
/// the centre of mass and the inertia tensor about it.
///
/// One gradient serves any number of parameters.
/// [`MassPropertiesGradient::derivative_along`] returns the derivative of the scalar with respect to
/// a parameter from that of the mass properties. For a mesh,
/// [`MeshDerivatives::gradient`](super::mesh::MeshDerivatives::gradient) returns the derivatives
/// with respect to all vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassPropertiesGradient<F> {
    /// Derivative with respect to the mass, per kg.
    pub by_mass: f64,
    /// Derivative with respect to the centre of mass, per m.
    pub by_center_of_mass: Direction<F>,
    /// Derivatives with respect to xx, yy, zz, xy, xz, yz of the tensor, per kg·m²; I_xy = I_yx
    /// counts as one variable.
    pub by_inertia: [f64; 6],
}

impl MassPropertiesGradient<Body> {
    /// Returns the gradient with respect to the mass properties of a part that is the whole body
    /// and has the body's axes, as in [`MassProperties::into_body`].
    #[must_use]
    pub fn in_part(&self) -> MassPropertiesGradient<Part> {
        self.pulled_back(|change| change.in_frame(Rotation::identity()))
    }
}

impl<F: Frame> MassPropertiesGradient<F> {
    /// Returns the derivative of the scalar with respect to the parameter whose derivative of the
    /// mass properties is `change`.
    pub fn derivative_along(&self, change: &MassPropertiesDerivative<F>) -> f64 {
        let of_inertia = self.by_inertia.iter().zip(change.inertia).map(|(g, x)| g * x).sum::<f64>();
        self.by_mass * change.mass + self.by_center_of_mass.dot(change.center_of_mass) + of_inertia
    }

    /// Returns the gradient with respect to a part's mass properties, from the gradient with
    /// respect to the whole's. `of` maps a derivative of the part to that of the whole.
    pub(super) fn pulled_back<A: Frame>(
        &self,
        of: impl Fn(&MassPropertiesDerivative<A>) -> MassPropertiesDerivative<F>,
    ) -> MassPropertiesGradient<A> {
        let none = MassPropertiesDerivative { mass: 0.0, center_of_mass: Position::ZERO, inertia: [0.0; 6] };
        let by = |change: MassPropertiesDerivative<A>| self.derivative_along(&of(&change));
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
