//! The surface with which a body touches the ground.

use crate::math::frame::{Body, Part};
use crate::math::rotation::Rotation;
use crate::math::vector::Position;
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// A convex surface of a body, or as much of one as may touch the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SurfaceShape {
    /// A sphere; its centre need not be the centre of mass.
    Sphere {
        /// m
        radius: f64,
    },
    /// An ellipsoid about its own axes.
    Ellipsoid {
        /// Along x, y and z, m.
        semi_axes: [f64; 3],
    },
    /// The rim of a disk or of a hoop, about its z axis: a circle, or the tube around one. Of a thick disk there are two, a thickness apart; it touches
    /// the ground with the lower one.
    Rim {
        /// Of the circle, m.
        radius: f64,
        /// Radius of the tube, m: zero for a sharp edge.
        tube: f64,
        /// Between the two rims, m: zero for a thin disk.
        thickness: f64,
    },
    /// A cylinder about its z axis that lies on the ground, so that its axis keeps its direction.
    Cylinder {
        /// m
        radius: f64,
        /// m: beyond its ends it would tip over; endless if `None`.
        length: Option<f64>,
    },
}

/// Where the surface of a body is in it.
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
    /// A shape with its centre at a point of the body, along axes of its own.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for lengths that are not positive (of a tube and a thickness: negative) or not finite.
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

    /// Its shape.
    pub const fn shape(&self) -> &SurfaceShape {
        &self.shape
    }

    /// Its centre.
    pub const fn center(&self) -> Position<Body> {
        self.center
    }

    /// Its axes.
    pub const fn axes(&self) -> Rotation<Body, Part> {
        self.axes
    }

    /// The largest distance of its points from its centre, m; of a cylinder across its axis.
    pub(super) fn size(&self) -> f64 {
        match self.shape {
            SurfaceShape::Sphere { radius } | SurfaceShape::Cylinder { radius, .. } => radius,
            SurfaceShape::Ellipsoid { semi_axes: [a, b, c] } => a.max(b).max(c),
            SurfaceShape::Rim { radius, tube, thickness } => (radius + tube).hypot(0.5 * thickness),
        }
    }

    /// True if `point` is inside, where the surface bounds something.
    pub(super) fn contains(&self, point: Position<Body>) -> bool {
        let [x, y, z] = (self.axes.inverse() * (point - self.center)).to_array();
        match self.shape {
            SurfaceShape::Sphere { radius } => x.hypot(y).hypot(z) < radius,
            SurfaceShape::Cylinder { radius, .. } => x.hypot(y) < radius,
            SurfaceShape::Ellipsoid { semi_axes: [a, b, c] } => (x / a).hypot(y / b).hypot(z / c) < 1.0,
            // The rest of the body is where it likes along the axis.
            SurfaceShape::Rim { radius, tube, .. } => x.hypot(y) < radius + tube,
        }
    }
}
