//! The ground that a body touches: a plane, level or not, or turning; the inside or the outside of a sphere or a cylinder.

use crate::math::frame::{Part, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{Direction, Position};
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// On which side of a curved ground the body is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroundSide {
    /// In it, as a marble in a bowl.
    Inside,
    /// On it, as a ball on top of another one.
    Outside,
}

impl GroundSide {
    /// The radius, negative of what is touched from outside.
    pub(super) const fn signed(self, radius: f64) -> f64 {
        match self {
            Self::Inside => radius,
            Self::Outside => -radius,
        }
    }
}

/// The form of the ground; its centre is the origin of space.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum GroundShape {
    /// A plane through the origin.
    Plane,
    /// A sphere.
    Sphere {
        /// m
        radius: f64,
        /// Where the body is.
        side: GroundSide,
    },
    /// A cylinder.
    Cylinder {
        /// m
        radius: f64,
        /// Where the body is.
        side: GroundSide,
    },
}

/// The ground: its form, the direction of its axis (of a plane: its normal, towards the body), and the rate at which it turns about that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    shape: GroundShape,
    axis: Direction<Space>,
    turning: f64,
}

impl Ground {
    /// The level plane z = 0.
    pub const LEVEL: Self =
        Self { shape: GroundShape::Plane, axis: Direction::new(0.0, 0.0, 1.0), turning: 0.0 };

    /// A ground with an axis: of a plane its normal; of a sphere any direction.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for a radius that is not positive and an axis without direction.
    pub fn new(shape: GroundShape, axis: Direction<Space>) -> Result<Self, MotionError> {
        if let GroundShape::Sphere { radius, .. } | GroundShape::Cylinder { radius, .. } = shape {
            require::positive("the radius of the ground", radius)?;
        }
        let axis = require::direction("the axis of the ground", axis)?;
        Ok(Self { shape, axis, turning: 0.0 })
    }

    /// Turning about its axis, rad/s: a turntable.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for a rate that is not finite.
    pub fn turning_at(self, rate: f64) -> Result<Self, MotionError> {
        require::finite("the rate at which the ground turns", rate)?;
        Ok(Self { turning: rate, ..self })
    }

    /// Its form.
    pub const fn shape(&self) -> &GroundShape {
        &self.shape
    }

    /// Its axis; of a plane the normal.
    pub const fn axis(&self) -> Direction<Space> {
        self.axis
    }

    /// The rate at which it turns about its axis, rad/s.
    pub const fn turning(&self) -> f64 {
        self.turning
    }

    /// Axes of which the third is its own, and the first, where it can be, lies in the plane of the third and x.
    pub(super) fn axes(&self) -> Rotation<Space, Part> {
        let z = self.axis;
        // What is left of x, or of y, whichever is farther from the axis: so that a level plane has the axes of space.
        let first =
            if z.x.abs() <= 0.9 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
        let x = (first - z * z.dot(first)).direction().unwrap_or(first);
        Rotation::from_axes([x, z.cross(x), z])
    }

    /// The normal at a point of it, towards the body.
    pub fn normal_at(&self, point: Position<Space>) -> Option<Direction<Space>> {
        match self.shape {
            GroundShape::Plane => Some(self.axis),
            GroundShape::Sphere { side, .. } => {
                point.direction().map(|out| if side == GroundSide::Inside { -out } else { out })
            }
            GroundShape::Cylinder { side, .. } => {
                let across = point.as_quantity() - self.axis * self.axis.dot(point);
                across.direction().map(|out| if side == GroundSide::Inside { -out } else { out })
            }
        }
    }

    /// How far a point is above it, m.
    pub(super) fn height_of(&self, point: Position<Space>) -> f64 {
        let along = self.axis.dot(point);
        match self.shape {
            GroundShape::Plane => along,
            GroundShape::Sphere { radius, side } => (radius - point.norm()) * side.signed(1.0),
            GroundShape::Cylinder { radius, side } => {
                let from_center: Direction<Space> = point.as_quantity();
                let across = from_center - self.axis * along;
                (radius - across.norm()) * side.signed(1.0)
            }
        }
    }
}
