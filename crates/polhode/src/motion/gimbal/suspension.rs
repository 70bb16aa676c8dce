//! The suspension: two gimbals between a base and a rotor.

use super::axis::Axis;
use super::base::Base;
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::{Body, Part, Space};
use crate::math::vector::{Acceleration, Direction, Position};
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// A gimbal, along the axes that are those of the base when all angles are zero, from the crossing of the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gimbal {
    /// About the crossing.
    inertia: [[f64; 3]; 3],
    /// m c, kg·m
    moment: [f64; 3],
}

impl Gimbal {
    /// One whose mass does not count.
    pub const MASSLESS: Self = Self { inertia: [[0.0; 3]; 3], moment: [0.0; 3] };

    /// One whose centre of mass is the crossing of the axes, by its tensor about that.
    pub fn balanced(inertia: &InertiaTensor<Part>) -> Self {
        Self { inertia: inertia.matrix(), moment: [0.0; 3] }
    }

    /// One that hangs: its centre of mass is not the crossing, which is the origin.
    pub fn pendulous(mass: &MassProperties<Part>) -> Self {
        let moment = mass.center_of_mass().to_array().map(|x| mass.mass() * x);
        Self { inertia: mass.inertia_about(Position::ZERO).matrix(), moment }
    }

    /// Its tensor about the crossing, kg·m².
    pub const fn inertia(&self) -> [[f64; 3]; 3] {
        self.inertia
    }

    /// Its mass times the place of its centre of mass, kg·m.
    pub const fn moment(&self) -> [f64; 3] {
        self.moment
    }
}

/// Two gimbals that hang a rotor, and how their three axes are held.
///
/// The outer gimbal turns about an axis of the base by α; the inner one by β about an axis of the outer one that is perpendicular to that; the rotor by γ
/// about an axis of the inner one that is perpendicular to the second. With all angles zero the third axis is the first × the second. All cross in
/// one point.
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

/// How far from a right angle two axes may be by rounding.
const PERPENDICULAR: f64 = 1e-9;

impl Gimbals {
    /// Massless ones on a base at rest, without gravity, that hold a body at the origin of its axes, its z axis along the third of theirs.
    ///
    /// `outer_axis` and `inner_axis` are where the first two axes stand in the base with all angles zero; `axes` how they are held: outer, inner, rotor's.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for axes without direction, or not perpendicular.
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

    /// Holding the body at a point of it, by an axis of it through that.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for an axis without direction and a point that is not finite.
    pub fn holding(self, crossing: Position<Body>, axis: Direction<Body>) -> Result<Self, MotionError> {
        require::finite("the crossing of the axes", crossing.norm())?;
        Ok(Self { crossing, rotor_axis: require::direction("the axis of the rotor", axis)?, ..self })
    }

    /// With mass properties of the outer and the inner gimbal.
    #[must_use]
    pub const fn with_mass(self, outer: Gimbal, inner: Gimbal) -> Self {
        Self { gimbals: [outer, inner], ..self }
    }

    /// On a base.
    #[must_use]
    pub const fn on(self, base: Base) -> Self {
        Self { base, ..self }
    }

    /// Under gravity, m/s², constant in the base.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for one that is not finite.
    pub fn under(self, gravity: Acceleration<Space>) -> Result<Self, MotionError> {
        require::finite("the acceleration of gravity", gravity.norm())?;
        Ok(Self { gravity, ..self })
    }

    /// What carries them.
    pub const fn base(&self) -> &Base {
        &self.base
    }

    /// The outer axis, in the base.
    pub const fn outer_axis(&self) -> Direction<Space> {
        self.outer_axis
    }

    /// The inner axis, in the base when all angles are zero.
    pub const fn inner_axis(&self) -> Direction<Space> {
        self.inner_axis
    }

    /// The rotor's axis, in the body.
    pub const fn rotor_axis(&self) -> Direction<Body> {
        self.rotor_axis
    }

    /// Where the axes cross, in the body.
    pub const fn crossing(&self) -> Position<Body> {
        self.crossing
    }

    /// Mass properties of the outer gimbal and of the inner one.
    pub const fn masses(&self) -> &[Gimbal; 2] {
        &self.gimbals
    }

    /// How the axes are held: outer, inner, rotor's.
    pub const fn axes(&self) -> &[Axis; 3] {
        &self.axes
    }

    /// g, m/s², along the axes of the base.
    pub const fn gravity(&self) -> Acceleration<Space> {
        self.gravity
    }

    pub(in crate::motion) const fn with_axes(self, axes: [Axis; 3]) -> Self {
        Self { axes, ..self }
    }
}
