//! Contents of a model file, unmodified: nothing is repaired, omitted or assumed. Every number
//! keeps its text and its position.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use polhode_source::Failure;

use crate::finding::Severity;
pub use crate::inline_mesh::InlineMesh;
pub use crate::span::Span;
pub use polhode_source::xml::{Name, Number};

/// Language in which a robot model is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelFormat {
    /// Unified Robot Description Format of ROS.
    Urdf,
    /// SDFormat of Gazebo.
    Sdf,
    /// XML format of MuJoCo.
    Mjcf,
    /// Universal Scene Description, with the UsdPhysics schema.
    Usd,
    /// XML format of OpenSim.
    Osim,
}

/// Model of a robot: links and the joints between them. The joints need not form a tree.
#[derive(Clone, Debug)]
pub struct RobotModel {
    /// Path of the file, as passed to the reader.
    pub path: PathBuf,
    /// Canonical path of the file's folder (symbolic links resolved), if it has one.
    pub folder: Option<PathBuf>,
    pub format: ModelFormat,
    /// Text of the file. Every [`Span`] counts bytes of it; spans beyond its end lie in included
    /// files.
    pub text: String,
    /// True if the text states its numbers in m, kg and kg·m². Otherwise the number texts stored
    /// here are converted to these units, and nothing is repaired.
    pub is_si: bool,
    /// False if the text cannot be edited to change one link: a binary USD layer, or a prim that
    /// occurs several times. Nothing is repaired then.
    pub is_editable: bool,
    /// Included files, each once, sorted by their start. For an expanded model these are the files
    /// with the macros, the model's own first.
    pub included: Vec<Source>,
    /// Expansion of macros that made the text, if one did.
    pub expansion: Option<Expansion>,
    /// Name of the model, if it has one.
    pub name: Option<String>,
    /// Links in file order.
    pub links: Vec<Link>,
    /// Joints in file order.
    pub joints: Vec<Joint>,
    /// Elements that stand for bodies but are not read. The mass of these bodies is missing in
    /// `links`.
    pub unread_bodies: Vec<UnreadBodies>,
    /// Notes of the reader: content it skipped, and choices it had to make.
    pub notes: Vec<Note>,
}

impl RobotModel {
    /// Returns the text of the model, then the texts of the included files; without macros.
    pub(crate) fn texts(&self) -> impl Iterator<Item = &str> {
        let included = self.included.iter().filter(|_| self.expansion.is_none());
        [&self.text].into_iter().chain(included.map(|source| &source.text)).map(String::as_str)
    }

    /// Returns the name of the text in messages: the path of the model, or the name of its expansion.
    pub fn text_path(&self) -> &Path {
        self.expansion.as_ref().map_or(&self.path, |expansion| &expansion.path)
    }

    /// Returns the error for a binary model, which cannot be edited; `what` is not done.
    pub(crate) fn require_text(&self, what: &str) -> Result<(), Failure> {
        let is_package = self.path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("usdz"));
        if self.is_editable || !self.text.is_empty() && !is_package {
            return Ok(());
        }
        let file = self.path.file_name().unwrap_or_default().to_string_lossy();
        let message = format!("binary USD and packages are not edited, so {what}");
        let hint = format!("convert it to text: usdcat {file} --out robot.usda");
        Err(Failure::usage(message, hint).in_file(&self.path))
    }

    /// Returns true if a span lies in an included file.
    pub fn is_included(&self, span: &Span) -> bool {
        self.included.iter().any(|source| source.start <= span.start)
    }

    /// Returns a model without content.
    pub(crate) fn empty(path: &Path, format: ModelFormat) -> Self {
        Self {
            path: path.to_owned(),
            folder: None,
            format,
            text: String::new(),
            is_si: true,
            is_editable: true,
            included: Vec::new(),
            expansion: None,
            name: None,
            links: Vec::new(),
            joints: Vec::new(),
            unread_bodies: Vec::new(),
            notes: Vec::new(),
        }
    }
}

/// Expansion of a macro file: the text of the model is the output of xacro.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expansion {
    /// Name of the expanded text: the path of the macro file, followed by "(expanded)".
    pub path: PathBuf,
    /// True if all files with macros could be read, so that a unique match is the only one.
    pub is_whole: bool,
}

/// File that a model includes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Path of the file.
    pub path: PathBuf,
    pub text: String,
    /// Start of this file in the model's byte count: a [`Span`] in it, minus `start`, counts bytes
    /// of `text`.
    pub start: usize,
}

/// Element from which a program generates bodies that are not read: `<composite>` and `<flexcomp>`
/// of MJCF.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnreadBodies {
    /// Name of the element.
    pub element: String,
    /// Name of the link that holds the element; `None` if it is in the world.
    pub link: Option<String>,
    /// Position of the element in the model's text.
    pub span: Span,
}

/// Note of a reader: content that it skipped, or a choice that it had to make.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Stable code for programs: `"read.include"`.
    pub code: &'static str,
    /// Name of the link or joint; empty if the note is about the whole model.
    pub subject: String,
    /// Position in the model's text.
    pub span: Span,
    /// Message, one line.
    pub message: String,
    /// Severity of the note.
    pub severity: Severity,
}

impl Note {
    /// Returns a note of severity [`Severity::Note`], which does not make a check fail.
    pub(crate) fn new(code: &'static str, subject: &str, span: Span, message: String) -> Self {
        Self { code, subject: subject.to_owned(), span, message, severity: Severity::Note }
    }
}

/// Number that a file should have.
#[derive(Clone, Debug, PartialEq)]
pub enum Slot {
    /// Number not in the file.
    Missing {
        /// Element that lacks the number.
        span: Span,
        /// Name of the missing attribute or child element: `"izz"`.
        name: String,
    },
    /// Number in the file, with its text.
    Given(Number),
}

impl Slot {
    /// Returns the value if the number is present, can be read and is finite.
    pub fn finite(&self) -> Option<f64> {
        match self {
            Self::Given(number) => number.value.filter(|value| value.is_finite()),
            Self::Missing { .. } => None,
        }
    }

    /// Returns the position of the number, or of the element that lacks it.
    pub fn span(&self) -> Span {
        match self {
            Self::Given(number) => number.span.clone(),
            Self::Missing { span, .. } => span.clone(),
        }
    }
}

/// Pose of an inner frame in an outer frame, with the position of its text.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// Origin of the inner frame in the outer frame, m.
    pub position: [f64; 3],
    /// Unit quaternion (w, x, y, z) of the rotation from inner to outer components.
    pub rotation: [f64; 4],
    /// Numbers of the pose that cannot be read or are not finite. They count as zero in the fields
    /// above.
    pub unreadable: Vec<Number>,
    /// Position of the pose in the text; `None` if it is omitted.
    pub span: Option<Span>,
}

/// Link: a rigid body or a frame of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Name of the link; generated (`"body 3"`) if the language permits links without a name.
    pub name: Name,
    /// Position of the element.
    pub span: Span,
    /// Mass properties stated in the file; `None` if the link states none.
    pub inertial: Option<Inertial>,
    /// Visual and collision geometry, in file order.
    pub geometry: Vec<Geometry>,
    /// Pose of the link in the model's frame with all joints at zero, if the language states it for
    /// links (SDF; MJCF, composed down the tree). Otherwise the identity.
    pub pose: Pose,
    /// True if the model declares the link immovable: SDF `<static>`.
    pub is_static: bool,
    /// True if the language computes mass, centre and tensor from the geometry, so that `inertial`
    /// is `None`. This holds for an MJCF body without `<inertial>` and for SDF's `<inertial
    /// auto="true">`.
    pub from_geometry: bool,
    /// Mass properties that the language's compiler gives the link, if they differ from `inertial`;
    /// or the reason why they cannot be computed.
    ///
    /// MJCF: from geoms, and after `boundmass`, `boundinertia`, `balanceinertia` and
    /// `settotalmass`. SDF: from collisions, with `auto="true"`.
    pub computed: Option<Result<ComputedMass, String>>,
}

/// Mass properties that a compiler gives a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComputedMass {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the link's frame, m.
    pub center: [f64; 3],
    /// Inertia tensor xx, yy, zz, xy, xz, yz about the centre of mass, link axes, kg·m².
    pub tensor: [f64; 6],
}

/// Mass properties of a link, as stated in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Inertial {
    /// Position of the element.
    pub span: Span,
    /// Mass, kg.
    pub mass: Slot,
    /// Pose of the inertial's frame in the link's frame. Its origin is the centre of mass.
    pub pose: Pose,
    /// Inertia tensor about the centre of mass, axes of the inertial's frame, kg·m².
    pub tensor: Tensor,
}

/// Inertia tensor as the languages write it.
#[derive(Clone, Debug, PartialEq)]
pub enum Tensor {
    /// No tensor in the file; position of the element that should have it.
    Missing(Span),
    /// Elements ixx, iyy, izz, ixy, ixz, iyz of the tensor (ixy = −∫xy dm).
    Six(Box<[Slot; 6]>),
    /// Principal moments along the axes of the inertial's frame.
    Diagonal(Box<[Slot; 3]>),
}

impl Tensor {
    /// Returns the numbers of the tensor in the order above; `None` if the tensor is missing.
    pub(crate) fn slots(&self) -> Option<impl Iterator<Item = &Slot>> {
        match self {
            Self::Missing(_) => None,
            Self::Six(slots) => Some(slots.iter()),
            Self::Diagonal(slots) => Some(slots.iter()),
        }
    }
}

/// Purpose of a geometry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Geometry for display.
    Visual,
    /// Geometry for contact.
    Collision,
}

/// Shape of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Geometry {
    /// Position of the element.
    pub span: Span,
    /// Purpose of the shape. MJCF: a geom with `contype = conaffinity = 0` is visual.
    pub role: Role,
    /// Pose of the shape's frame in the link's frame.
    pub pose: Pose,
    pub shape: GeometryShape,
}

/// Shapes; lengths in metres. The frame is at the middle of the shape, with z along cylinders,
/// capsules and cones. Sizes that cannot be read are NaN.
#[derive(Clone, Debug, PartialEq)]
pub enum GeometryShape {
    /// Box with full edge lengths.
    Box([f64; 3]),
    /// Sphere with its radius.
    Sphere(f64),
    /// Cylinder with flat ends.
    Cylinder {
        radius: f64,
        /// Distance between the ends.
        length: f64,
    },
    /// Capsule: a cylinder with two hemispherical caps.
    Capsule {
        /// Radius of the cylinder and of the caps.
        radius: f64,
        /// Distance between the centres of the caps.
        length: f64,
    },
    /// Ellipsoid with its semi-axes.
    Ellipsoid([f64; 3]),
    /// Cone with its base at z = −length/2 and its apex at z = +length/2.
    Cone {
        /// Radius of the base.
        radius: f64,
        /// Height from the base to the apex.
        length: f64,
    },
    /// Triangle mesh in a file of its own.
    Mesh {
        /// Reference as written: `"package://arm/meshes/link1.stl"`.
        uri: Name,
        /// Path of the file; or the reason why it is not found: outside the roots, or in a package
        /// that no root holds.
        path: Result<PathBuf, String>,
        /// Scale factors along x, y, z. A negative factor mirrors the mesh.
        scale: [f64; 3],
    },
    /// Triangle mesh in the model itself: a `Mesh` prim of USD, or `vertex` and `face` of MJCF.
    Inline {
        /// Path of the prim, or name of the asset.
        name: String,
        /// Triangles; or the reason why there are none.
        mesh: Result<Arc<InlineMesh>, String>,
        /// Factors from the model's unit to metres along x, y, z. A negative factor mirrors the mesh.
        scale: [f64; 3],
    },
    /// Shape without a volume of its own, such as a plane or a height field; its name.
    Other(String),
}

impl GeometryShape {
    /// Returns the shape with all sizes multiplied by a factor.
    #[must_use]
    pub(crate) fn resized(&self, factor: f64) -> Self {
        match self {
            Self::Box(size) => Self::Box(size.map(|c| factor * c)),
            Self::Sphere(radius) => Self::Sphere(factor * radius),
            Self::Cylinder { radius, length } => {
                Self::Cylinder { radius: factor * radius, length: factor * length }
            }
            Self::Capsule { radius, length } => {
                Self::Capsule { radius: factor * radius, length: factor * length }
            }
            Self::Ellipsoid(half_axes) => Self::Ellipsoid(half_axes.map(|c| factor * c)),
            Self::Cone { radius, length } => Self::Cone { radius: factor * radius, length: factor * length },
            Self::Mesh { uri, path, scale } => {
                Self::Mesh { uri: uri.clone(), path: path.clone(), scale: scale.map(|c| factor * c) }
            }
            Self::Inline { name, mesh, scale } => {
                Self::Inline { name: name.clone(), mesh: mesh.clone(), scale: scale.map(|c| factor * c) }
            }
            Self::Other(name) => Self::Other(name.clone()),
        }
    }

    /// Returns the number of bytes of the names in the shape.
    pub(crate) fn named_bytes(&self) -> usize {
        match self {
            Self::Mesh { uri, path, .. } => {
                uri.text.len() + path.as_ref().map_or_else(String::len, |path| path.as_os_str().len())
            }
            Self::Inline { name, mesh, .. } => name.len() + mesh.as_ref().err().map_or(0, String::len),
            Self::Other(name) => name.len(),
            _ => 0,
        }
    }
}

/// Joint between a parent and a child link.
///
/// An MJCF body may have several joints. They are consecutive here, have the same parent, child and
/// pose, and act in this order.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Name of the joint; generated if the language permits joints without a name.
    pub name: Name,
    /// Position of the element.
    pub span: Span,
    /// Motion that the joint allows.
    pub kind: JointKind,
    /// Name of the parent link; `None` if the parent is the world.
    pub parent: Option<Name>,
    /// Name of the child link.
    pub child: Name,
    /// Pose of the child's frame in the parent's frame with the joint at rest
    /// ([`Coordinate::at_rest`]). The rest value is zero in all languages except MJCF.
    pub pose: Pose,
    /// Joint axis in the child's frame, as written or by the language's default.
    pub axis: [f64; 3],
    /// Point on the axis, in the child's frame, m. Zero in URDF.
    pub anchor: [f64; 3],
    /// Value, limits and coupling of the joint.
    pub coordinate: Coordinate,
}

/// Motion that a joint allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// No motion.
    Fixed,
    /// Rotation about the axis: revolute, continuous, hinge.
    Revolute,
    /// Translation along the axis: prismatic, slide.
    Prismatic,
    /// Six degrees of freedom: floating, free.
    Free,
    /// Any other joint: ball, planar, universal, screw.
    Other,
}

/// Value of a joint, its limits and its coupling; rad or m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coordinate {
    /// Name of the coordinate if it differs from the joint's (OpenSim). A value may be given under
    /// either name.
    pub name: Option<Name>,
    /// Value at which the child has the pose [`Joint::pose`]. It is also the default value. MJCF:
    /// `ref`; zero elsewhere.
    pub at_rest: f64,
    /// Lower and upper limit; either may be infinite.
    pub limits: Option<[f64; 2]>,
    /// Coupling to another joint (mimic).
    pub follows: Option<Follows>,
    /// Reason why the rest position of the child is unknown, if the reader cannot read it.
    pub unread: Option<String>,
    /// Reflected inertia of the motor's rotor, added to the joint's coordinate, kg·m²; kg for a
    /// sliding joint. Zero if the file states none, NaN if its number cannot be read.
    pub armature: f64,
}

/// Coupling of a joint: its value is a polynomial of another joint's value.
///
/// y = Σ c_k (x − x₀)^k, x the leader's value.
#[derive(Clone, Debug, PartialEq)]
pub struct Follows {
    /// Position of the coupling in the text.
    pub span: Span,
    /// Leading joint; `None` if the value is the constant c₀.
    pub leader: Option<Name>,
    /// Reference value x₀ of the leader, rad or m.
    pub reference: f64,
    /// Coefficients c_k, the constant first; or the reason why they are unknown.
    pub coefficients: Result<Vec<f64>, String>,
}
