//! The ground: a plane, level, inclined or turning; or the inside or outside of a sphere or a
//! cylinder.

use crate::math::frame::{Part, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{Direction, Position};
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Side of a curved ground on which the body is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroundSide {
    /// Inside, such as a marble in a bowl.
    Inside,
    /// Outside, such as a ball on top of another ball.
    Outside,
}

impl GroundSide {
    /// Returns the radius; negative for contact from outside.
    pub(super) const fn signed(self, radius: f64) -> f64 {
        match self {
            Self::Inside => radius,
            Self::Outside => -radius,
        }
    }
}

/// Shape of the ground, centred at the origin of space.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum GroundShape {
    /// Plane through the origin.
    Plane,
    /// Sphere about the origin.
    Sphere {
        /// Radius, m.
        radius: f64,
        /// Side on which the body is.
        side: GroundSide,
    },
    /// Cylinder about an axis through the origin.
    Cylinder {
        /// Radius, m.
        radius: f64,
        /// Side on which the body is.
        side: GroundSide,
    },
}

/// Ground: its shape, its axis, and its rate of turning about the axis. The axis of a plane is its
/// normal towards the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    shape: GroundShape,
    axis: Direction<Space>,
    turning: f64,
}

impl Ground {
    /// Level plane z = 0.
    pub const LEVEL: Self =
        Self { shape: GroundShape::Plane, axis: Direction::new(0.0, 0.0, 1.0), turning: 0.0 };

    /// Creates a ground at rest. The axis of a plane is its normal; that of a sphere is arbitrary.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the radius is not positive, or the
    /// axis is zero or not finite.
    pub fn new(shape: GroundShape, axis: Direction<Space>) -> Result<Self, MotionError> {
        if let GroundShape::Sphere { radius, .. } | GroundShape::Cylinder { radius, .. } = shape {
            require::positive("the radius of the ground", radius)?;
        }
        let axis = require::direction("the axis of the ground", axis)?;
        Ok(Self { shape, axis, turning: 0.0 })
    }

    /// Sets the rate of turning about the axis, rad/s, as of a turntable.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the rate is not finite.
    pub fn turning_at(self, rate: f64) -> Result<Self, MotionError> {
        require::finite("the rate at which the ground turns", rate)?;
        Ok(Self { turning: rate, ..self })
    }

    /// Returns the shape.
    pub const fn shape(&self) -> &GroundShape {
        &self.shape
    }

    /// Returns the unit vector of the axis; for a plane the normal.
    pub const fn axis(&self) -> Direction<Space> {
        self.axis
    }

    /// Returns the rate of turning about the axis, rad/s.
    pub const fn turning(&self) -> f64 {
        self.turning
    }

    /// Returns axes whose third is the axis of the ground. If possible, the first is in the plane
    /// of the third and x.
    pub(super) fn axes(&self) -> Rotation<Space, Part> {
        let z = self.axis;
        // Component of x, or of y, normal to the axis. The vector farther from the axis is used, so
        // that a level plane has the axes of space.
        let first =
            if z.x.abs() <= 0.9 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
        let x = (first - z * z.dot(first)).direction().unwrap_or(first);
        Rotation::from_axes([x, z.cross(x), z])
    }

    /// Returns the normal at a point of the ground, towards the body.
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

    /// Returns the height of a point above the ground, m.
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
