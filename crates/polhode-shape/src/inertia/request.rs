//! Request of the command `inertia`.

use std::path::PathBuf;
use std::str::FromStr;

use polhode::math::{Body, Part, Position, Rotation};
use polhode_source::given::{Given, point, positive, rotation, unit_named};
use polhode_source::unit::Dimension;
use serde::{Deserialize, Serialize};

use super::choice::{CadChoice, MeshChoice, MoleculeChoice, PrimitiveChoice, SubstanceChoice, VoxelChoice};
use super::kind::Kind;

/// Request for the mass properties of bodies in files, with the values that the files omit, or of a
/// shape.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_shape::{Request, run};
/// use polhode_source::files::Memory;
/// let mesh = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
/// let files = Memory::from([("wedge.obj", mesh)]);
/// let mut request = Request { files: vec!["wedge.obj".into()], ..Request::default() };
/// request.substance.density = Some("4 kg/m^3".parse()?);
/// let bodies = run(&request, &files)?;
/// assert_eq!(bodies.to_json()["mass"], 4.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// Scenarios, meshes, molecules, particles, voxel grids, CAD reports, robots; the format
    /// follows from the file extension.
    #[cfg_attr(feature = "arguments", arg(required_unless_present = "primitive", value_name = "FILE"))]
    pub files: Vec<PathBuf>,
    /// Shape, instead of files.
    #[serde(flatten)]
    #[cfg_attr(feature = "arguments", command(flatten))]
    pub primitive: PrimitiveChoice,
    /// Substance of the whole body.
    #[serde(flatten)]
    #[cfg_attr(feature = "arguments", command(flatten))]
    pub substance: SubstanceChoice,
    /// Options for meshes.
    #[serde(flatten)]
    #[cfg_attr(feature = "arguments", command(flatten))]
    pub mesh: MeshChoice,
    /// The unit of length of a file that states none, such as mm or in [default for meshes: m].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "UNIT"))]
    pub unit: Option<Given<LengthUnit>>,
    /// The unit of mass of a file that states none, such as g or lbm.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "UNIT"))]
    pub mass_unit: Option<Given<MassUnit>>,
    /// Options for molecules.
    #[serde(flatten)]
    #[cfg_attr(feature = "arguments", command(flatten))]
    pub molecule: MoleculeChoice,
    /// Options for CAD reports.
    #[serde(flatten)]
    #[cfg_attr(feature = "arguments", command(flatten))]
    pub cad: CadChoice,
    /// Options for voxel grids.
    #[serde(flatten)]
    #[cfg_attr(feature = "arguments", command(flatten))]
    pub voxel: VoxelChoice,
    /// The kind of the files, if it does not follow from the file extension.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "KIND"))]
    pub format: Option<Kind>,
    /// Also print the tensor about this point: x,y,z from the origin, each with its unit or in
    /// metres; or "corner", of --box only: its corner at the smallest x, y and z.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, conflicts_with_all = ["csv", "as_format"]))]
    pub about: Option<Given<Point>>,
    /// Also print the tensor along axes rotated by this unit quaternion (scalar first, rotated axes
    /// to body axes).
    #[cfg_attr(feature = "arguments", arg(long, value_name = "W,X,Y,Z", allow_hyphen_values = true, conflicts_with_all = ["csv", "as_format"]))]
    pub along: Option<Given<Turn>>,
}

impl Request {
    /// Returns the given unit of length, m.
    pub(super) fn length_unit(&self) -> Option<f64> {
        self.unit.as_ref().map(|unit| unit.value.0)
    }

    /// Returns the given unit of mass, kg.
    pub(super) fn mass_unit(&self) -> Option<f64> {
        self.mass_unit.as_ref().map(|unit| unit.value.0)
    }
}

/// Unit of length, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthUnit(pub f64);

impl FromStr for LengthUnit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if !text.starts_with(char::is_alphabetic) {
            return Err("expected a unit of length, such as mm".to_owned());
        }
        positive(unit_named(text, Dimension::LENGTH)?).map(Self)
    }
}

/// Unit of mass, in kilograms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassUnit(pub f64);

impl FromStr for MassUnit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if !text.starts_with(char::is_alphabetic) {
            return Err("expected a unit of mass, such as g".to_owned());
        }
        positive(unit_named(text, Dimension::MASS)?).map(Self)
    }
}

/// Point of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Point {
    /// Position from the origin, body frame, m.
    At(Position<Body>),
    /// Corner of a box with the smallest coordinates.
    Corner,
}

impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "corner" => Ok(Self::Corner),
            "centre" | "center" => Err("the tensor about the centre of mass is always printed (hint: leave out --about, or write x,y,z)".to_owned()),
            _ => point(text).map(Self::At),
        }
    }
}

/// Rotation from the rotated axes to the body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn(pub Rotation<Body, Part>);

impl FromStr for Turn {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        rotation(text).map(Self)
    }
}
