//! Options for shapes without a file.

use polhode::body::shape::{BoxShape, Capsule, Cone, Cylinder, Disk, Ellipsoid, Rod, Sphere, Torus};
use polhode_source::given::Given;
use serde::{Deserialize, Serialize};

use crate::inertia::primitive::{AnyPrimitive, Measured};

/// Heading of these options in the help.
#[cfg(feature = "arguments")]
const SHAPES: &str = "Shapes, instead of a file";

/// Shape of uniform density, used instead of files; at most one of the options may be set.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args), group(id = "primitive", multiple = false))]
pub struct PrimitiveChoice {
    /// Box: edges along x, y and z, centre at the origin, such as "20 cm, 10 cm, 6 cm".
    #[cfg_attr(feature = "arguments", arg(long, value_name = "A,B,C", help_heading = SHAPES, allow_hyphen_values = true))]
    pub r#box: Option<Given<Measured<BoxShape, 3>>>,
    /// Sphere with this radius, centre at the origin.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "RADIUS", help_heading = SHAPES, allow_hyphen_values = true))]
    pub sphere: Option<Given<Measured<Sphere, 1>>>,
    /// Ellipsoid: semi-axes along x, y and z, centre at the origin.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "A,B,C", help_heading = SHAPES, allow_hyphen_values = true))]
    pub ellipsoid: Option<Given<Measured<Ellipsoid, 3>>>,
    /// Cylinder along z: radius and length.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "RADIUS,LENGTH", help_heading = SHAPES, allow_hyphen_values = true))]
    pub cylinder: Option<Given<Measured<Cylinder, 2>>>,
    /// Cylinder along z between two half balls: radius, and length without these caps.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "RADIUS,LENGTH", help_heading = SHAPES, allow_hyphen_values = true))]
    pub capsule: Option<Given<Measured<Capsule, 2>>>,
    /// Cone with the centre of its base at the origin and its apex on +z: radius and height.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "RADIUS,HEIGHT", help_heading = SHAPES, allow_hyphen_values = true))]
    pub cone: Option<Given<Measured<Cone, 2>>>,
    /// Torus about z: radius of the ring's centre line, and radius of the tube.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "RING,TUBE", help_heading = SHAPES, allow_hyphen_values = true))]
    pub torus: Option<Given<Measured<Torus, 2>>>,
    /// Thin rod along z: length. It takes --mass only.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "LENGTH", help_heading = SHAPES, allow_hyphen_values = true))]
    pub rod: Option<Given<Measured<Rod, 1>>>,
    /// Thin disk perpendicular to z: radius. It takes --mass only.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "RADIUS", help_heading = SHAPES, allow_hyphen_values = true))]
    pub disk: Option<Given<Measured<Disk, 1>>>,
}

impl PrimitiveChoice {
    /// Returns true if a shape is given.
    pub fn is_given(&self) -> bool {
        !self.given().is_empty()
    }

    /// Returns the shapes that are given.
    pub(in crate::inertia) fn given(&self) -> Vec<&dyn AnyPrimitive> {
        fn any<P: AnyPrimitive>(given: &Option<Given<P>>) -> Option<&dyn AnyPrimitive> {
            given.as_ref().map(|given| &given.value as &dyn AnyPrimitive)
        }
        let Self { r#box, sphere, ellipsoid, cylinder, capsule, cone, torus, rod, disk } = self;
        let all = [
            any(r#box),
            any(sphere),
            any(ellipsoid),
            any(cylinder),
            any(capsule),
            any(cone),
            any(torus),
            any(rod),
            any(disk),
        ];
        all.into_iter().flatten().collect()
    }
}
