//! The suspension: two gimbals between a base and a rotor.

use super::axis::Axis;
use super::base::Base;
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::{Body, Part, Space};
use crate::math::vector::{Acceleration, Direction, Position};
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Mass properties of a gimbal about the intersection of the axes, along the axes of the base at
/// zero angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gimbal {
    /// Tensor about the intersection of the axes.
    inertia: [[f64; 3]; 3],
    /// m c, kg·m.
    moment: [f64; 3],
}

impl Gimbal {
    /// Massless gimbal.
    pub const MASSLESS: Self = Self { inertia: [[0.0; 3]; 3], moment: [0.0; 3] };

    /// Creates a gimbal whose centre of mass is the intersection of the axes, from its tensor about
    /// that point.
    pub fn balanced(inertia: &InertiaTensor<Part>) -> Self {
        Self { inertia: inertia.matrix(), moment: [0.0; 3] }
    }

    /// Creates a gimbal whose centre of mass is not the intersection of the axes. The origin of
    /// `mass` is the intersection.
    pub fn pendulous(mass: &MassProperties<Part>) -> Self {
        let moment = mass.center_of_mass().to_array().map(|x| mass.mass() * x);
        Self { inertia: mass.inertia_about(Position::ZERO).matrix(), moment }
    }

    /// Returns the tensor about the intersection of the axes, kg·m².
    pub const fn inertia(&self) -> [[f64; 3]; 3] {
        self.inertia
    }

    /// Returns the mass times the position of the centre of mass, kg·m.
    pub const fn moment(&self) -> [f64; 3] {
        self.moment
    }
}

/// Two gimbals that suspend a rotor, with the constraints of their three axes.
///
/// The outer gimbal turns by α about an axis of the base. The inner gimbal turns by β about an axis
/// of the outer one, perpendicular to the first. The rotor turns by γ about an axis of the inner
/// one, perpendicular to the second. At zero angles the third axis is the first × the second. All
/// axes intersect at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gimbals {
    base: Base,
    outer_axis: Direction<Space>,
    inner_axis: Direction<Space>,
    rotor_axis: Direction<Body>,
    crossing: Position<Body>,
    gimbals: [Gimbal; 2],
    axes: [Axis; 3],
    gravity: Acceleration<Space>,
}

/// Tolerance on the right angle between two axes.
const PERPENDICULAR: f64 = 1e-9;

impl Gimbals {
    /// Creates massless gimbals on a base at rest, without gravity. They hold the body at its
    /// origin, with its z axis along the third axis.
    ///
    /// `outer_axis` and `inner_axis` are the directions of the first two axes in the base at zero
    /// angles. `axes` are the constraints of the outer, inner and rotor axes.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if an axis is zero or not finite, or if
    /// the axes are not perpendicular.
    pub fn new(
        outer_axis: Direction<Space>,
        inner_axis: Direction<Space>,
        axes: [Axis; 3],
    ) -> Result<Self, MotionError> {
        let outer_axis = require::direction("the outer axis", outer_axis)?;
        let inner_axis = require::direction("the inner axis", inner_axis)?;
        let cosine = outer_axis.dot(inner_axis);
        let rule = "zero: the inner axis is perpendicular to the outer one";
        let holds = cosine.abs() <= PERPENDICULAR;
        require::that("the cosine between the inner and the outer axis", cosine, holds, rule)?;
        let inner_axis = require::direction("the inner axis", inner_axis - outer_axis * cosine)?;
        Ok(Self {
            base: Base::FIXED,
            outer_axis,
            inner_axis,
            rotor_axis: Direction::new(0.0, 0.0, 1.0),
            crossing: Position::ZERO,
            gimbals: [Gimbal::MASSLESS; 2],
            axes,
            gravity: Acceleration::ZERO,
        })
    }

    /// Sets the point and the axis of the body at which the rotor is held. The axis passes through
    /// the point.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the axis is zero or not finite, or
    /// the point is not finite.
    pub fn holding(self, crossing: Position<Body>, axis: Direction<Body>) -> Result<Self, MotionError> {
        require::finite("the crossing of the axes", crossing.norm())?;
        Ok(Self { crossing, rotor_axis: require::direction("the axis of the rotor", axis)?, ..self })
    }

    /// Sets the mass properties of the outer and the inner gimbal.
    #[must_use]
    pub const fn with_mass(self, outer: Gimbal, inner: Gimbal) -> Self {
        Self { gimbals: [outer, inner], ..self }
    }

    /// Sets the base.
    #[must_use]
    pub const fn with_base(self, base: Base) -> Self {
        Self { base, ..self }
    }

    /// Sets gravity, m/s², constant in the base.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if it is not finite.
    pub fn with_gravity(self, gravity: Acceleration<Space>) -> Result<Self, MotionError> {
        require::finite("the acceleration of gravity", gravity.norm())?;
        Ok(Self { gravity, ..self })
    }

    /// Returns the base.
    pub const fn base(&self) -> &Base {
        &self.base
    }

    /// Returns the direction of the outer axis in the base.
    pub const fn outer_axis(&self) -> Direction<Space> {
        self.outer_axis
    }

    /// Returns the direction of the inner axis in the base at zero angles.
    pub const fn inner_axis(&self) -> Direction<Space> {
        self.inner_axis
    }

    /// Returns the direction of the rotor's axis in the body.
    pub const fn rotor_axis(&self) -> Direction<Body> {
        self.rotor_axis
    }

    /// Returns the intersection of the axes, body axes, m.
    pub const fn crossing(&self) -> Position<Body> {
        self.crossing
    }

    /// Returns the mass properties of the outer and the inner gimbal.
    pub const fn masses(&self) -> &[Gimbal; 2] {
        &self.gimbals
    }

    /// Returns the outer, inner and rotor axes.
    pub const fn axes(&self) -> &[Axis; 3] {
        &self.axes
    }

    /// Returns g along the axes of the base, m/s².
    pub const fn gravity(&self) -> Acceleration<Space> {
        self.gravity
    }

    pub(in crate::motion) const fn with_axes(self, axes: [Axis; 3]) -> Self {
        Self { axes, ..self }
    }
}
