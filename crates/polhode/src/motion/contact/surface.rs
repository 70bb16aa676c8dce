//! Surface with which a body touches the ground.

use crate::math::frame::{Body, Part};
use crate::math::rotation::Rotation;
use crate::math::vector::Position;
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Convex surface of a body, or the part of it that may touch the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SurfaceShape {
    /// Sphere; its centre need not be the centre of mass.
    Sphere {
        /// Radius, m.
        radius: f64,
    },
    /// Ellipsoid with its own axes.
    Ellipsoid {
        /// Semi-axes along x, y and z, m.
        semi_axes: [f64; 3],
    },
    /// Rim of a disk or hoop about its z axis: a circle, or a torus around one. A thick disk has
    /// two rims separated by its thickness, and touches the ground with the lower one.
    Rim {
        /// Radius of the circle, m.
        radius: f64,
        /// Radius of the tube, m: zero for a sharp edge.
        tube: f64,
        /// Distance between the two rims, m: zero for a thin disk.
        thickness: f64,
    },
    /// Cylinder about its z axis that lies on the ground, so that its axis keeps its direction.
    Cylinder {
        /// Radius, m.
        radius: f64,
        /// Length, m, beyond whose ends the support cannot lie; `None` for an infinite cylinder.
        length: Option<f64>,
    },
}

/// Surface of a body, with its position and orientation in the body.
///
/// ```
/// use polhode::math::{Body, Part, Position, Rotation};
/// use polhode::motion::contact::{BodySurface, SurfaceShape};
/// let shape = SurfaceShape::Ellipsoid { semi_axes: [0.2, 0.03, 0.02] };
/// let surface = BodySurface::new(shape, Position::new(0.0, 0.0, 0.005), Rotation::identity())?;
/// assert_eq!(surface.center(), Position::new(0.0, 0.0, 0.005));
/// assert!(BodySurface::new(SurfaceShape::Sphere { radius: 0.0 }, Position::ZERO, Rotation::identity()).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodySurface {
    shape: SurfaceShape,
    center: Position<Body>,
    axes: Rotation<Body, Part>,
}

impl BodySurface {
    /// Creates a surface from a shape, the position of its centre in the body, and its axes.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if a length is not positive or not
    /// finite. A tube radius and a thickness may be zero.
    pub fn new(
        shape: SurfaceShape,
        center: Position<Body>,
        axes: Rotation<Body, Part>,
    ) -> Result<Self, MotionError> {
        match shape {
            SurfaceShape::Sphere { radius } => require::positive("the radius of a sphere", radius)?,
            SurfaceShape::Ellipsoid { semi_axes } => {
                semi_axes.iter().try_for_each(|&a| require::positive("a semi-axis of an ellipsoid", a))?;
            }
            SurfaceShape::Rim { radius, tube, thickness } => {
                require::positive("the radius of a rim", radius)?;
                require::not_negative("the radius of the tube of a rim", tube)?;
                require::not_negative("the thickness of a disk", thickness)?;
            }
            SurfaceShape::Cylinder { radius, length } => {
                require::positive("the radius of a cylinder", radius)?;
                length.map_or(Ok(()), |length| require::positive("the length of a cylinder", length))?;
            }
        }
        for x in center.to_array() {
            require::finite("the centre of a surface", x)?;
        }
        Ok(Self { shape, center, axes })
    }

    /// Returns the shape.
    pub const fn shape(&self) -> &SurfaceShape {
        &self.shape
    }

    /// Returns the centre, body axes, m.
    pub const fn center(&self) -> Position<Body> {
        self.center
    }

    /// Returns the rotation from the axes of the surface to body axes.
    pub const fn axes(&self) -> Rotation<Body, Part> {
        self.axes
    }

    /// Returns the largest distance of a point of the surface from its centre, m; for a cylinder,
    /// across its axis.
    pub(super) fn size(&self) -> f64 {
        match self.shape {
            SurfaceShape::Sphere { radius } | SurfaceShape::Cylinder { radius, .. } => radius,
            SurfaceShape::Ellipsoid { semi_axes: [a, b, c] } => a.max(b).max(c),
            SurfaceShape::Rim { radius, tube, thickness } => (radius + tube).hypot(0.5 * thickness),
        }
    }

    /// True if `point` is inside the surface, where the surface is closed.
    pub(super) fn contains(&self, point: Position<Body>) -> bool {
        let [x, y, z] = (self.axes.inverse() * (point - self.center)).to_array();
        match self.shape {
            SurfaceShape::Sphere { radius } => x.hypot(y).hypot(z) < radius,
            SurfaceShape::Cylinder { radius, .. } => x.hypot(y) < radius,
            SurfaceShape::Ellipsoid { semi_axes: [a, b, c] } => (x / a).hypot(y / b).hypot(z / c) < 1.0,
            // The position along the axis is not restricted.
            SurfaceShape::Rim { radius, tube, .. } => x.hypot(y) < radius + tube,
        }
    }
}
