//! A model as its file says it: nothing is repaired, left out or trusted. Every number keeps its text and its place.

use std::path::{Path, PathBuf};

use crate::finding::Severity;
pub use crate::span::Span;
pub use polhode_source::xml::{Name, Number};

/// The languages of models.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelFormat {
    /// The Unified Robot Description Format of ROS.
    Urdf,
    /// SDFormat of Gazebo.
    Sdf,
    /// MuJoCo's XML.
    Mjcf,
    /// Universal Scene Description as text, with UsdPhysics.
    Usd,
    /// OpenSim's XML.
    Osim,
}

/// A model: bodies joined to a tree, if it is one.
#[derive(Clone, Debug)]
pub struct RobotModel {
    /// The file, as it was given.
    pub path: PathBuf,
    /// Its folder without links, if there is one.
    pub folder: Option<PathBuf>,
    /// Its language.
    pub format: ModelFormat,
    /// Its text: every [`Span`] counts bytes of it, and those beyond its end are of the files that it includes.
    pub text: String,
    /// Whether its numbers stand in the text in m, kg and kg·m². Where they do not, their texts here are in these, and nothing is repaired.
    pub is_si: bool,
    /// The files that it includes, each once, by their places.
    pub included: Vec<Source>,
    /// Its name, if it has one.
    pub name: Option<String>,
    /// In the order of the file.
    pub links: Vec<Link>,
    /// In the order of the file.
    pub joints: Vec<Joint>,
    /// Elements whose bodies are not read. The mass of these bodies is missing in `links`.
    pub unread_bodies: Vec<UnreadBodies>,
    /// What the reader left out or had to decide.
    pub notes: Vec<Note>,
}

impl RobotModel {
    /// Its text and those of the files that it includes.
    pub(crate) fn texts(&self) -> impl Iterator<Item = &str> {
        [&self.text].into_iter().chain(self.included.iter().map(|source| &source.text)).map(String::as_str)
    }

    /// Whether a span is of a file that the model includes.
    pub fn is_included(&self, span: &Span) -> bool {
        self.included.iter().any(|source| source.start <= span.start)
    }

    /// A model that says nothing.
    pub(crate) fn empty(path: &Path, format: ModelFormat) -> Self {
        Self {
            path: path.to_owned(),
            folder: None,
            format,
            text: String::new(),
            is_si: true,
            included: Vec::new(),
            name: None,
            links: Vec::new(),
            joints: Vec::new(),
            unread_bodies: Vec::new(),
            notes: Vec::new(),
        }
    }
}

/// A file that a model includes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// The file.
    pub path: PathBuf,
    /// Its text.
    pub text: String,
    /// The place of its first byte: a [`Span`] of it, less this, counts bytes of its text.
    pub start: usize,
}

/// An element from which a program makes bodies that are not read: `<composite>` and `<flexcomp>` of MJCF.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnreadBodies {
    /// Name of the element.
    pub element: String,
    /// Name of the link that holds the element; `None` in the world.
    pub link: Option<String>,
    /// Place of the element in the model's text.
    pub span: Span,
}

/// Something that a reader left out of a model, or had to decide.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// A stable name for programs: `"read.include"`.
    pub code: &'static str,
    /// The link or joint; empty if it is about the whole model.
    pub subject: String,
    /// Where in the model's text.
    pub span: Span,
    /// What, in a line.
    pub message: String,
    /// How much that matters.
    pub severity: Severity,
}

impl Note {
    /// A note that is no reason to fail.
    pub(crate) fn new(code: &'static str, subject: &str, span: Span, message: String) -> Self {
        Self { code, subject: subject.to_owned(), span, message, severity: Severity::Note }
    }
}

/// A number that a file should have.
#[derive(Clone, Debug, PartialEq)]
pub enum Slot {
    /// Not there. The element that lacks it, and what it is called there: `"izz"`.
    Missing {
        /// The element.
        span: Span,
        /// The attribute or child.
        name: String,
    },
    /// There, with its text.
    Given(Number),
}

impl Slot {
    /// The number, if it is there, is one and is finite.
    pub fn finite(&self) -> Option<f64> {
        match self {
            Self::Given(number) => number.value.filter(|value| value.is_finite()),
            Self::Missing { .. } => None,
        }
    }

    /// Where it stands, or the element that lacks it.
    pub fn span(&self) -> Span {
        match self {
            Self::Given(number) => number.span.clone(),
            Self::Missing { span, .. } => span.clone(),
        }
    }
}

/// A place and an attitude of one frame in another, as read and as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// The origin of the inner frame in the outer one, m.
    pub position: [f64; 3],
    /// (w, x, y, z) of the rotation that takes inner components to outer ones; unit.
    pub rotation: [f64; 4],
    /// Its numbers that are none, or not finite; they count as zero above.
    pub unreadable: Vec<Number>,
    /// Where it is written; `None` if it is left out.
    pub span: Option<Span>,
}

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Its name; made up (`"body 3"`) where the language lets it be left out.
    pub name: Name,
    /// Its element.
    pub span: Span,
    /// What it says of its mass; `None` if nothing.
    pub inertial: Option<Inertial>,
    /// Visual and collision geometry, in the order of the file.
    pub geometry: Vec<Geometry>,
    /// The link's frame in the model's, all joints at zero, where the language says it of the link itself (SDF, MJCF: composed
    /// down the tree); the identity otherwise.
    pub pose: Pose,
    /// True if the model says that it does not move: SDF `<static>`.
    pub is_static: bool,
    /// True if the language computes mass, centre and tensor from the geometry, and `inertial` is `None` for that reason: an MJCF
    /// body without `<inertial>`, SDF's `<inertial auto="true">`.
    pub from_geometry: bool,
    /// The mass that the language's compiler gives the link, where that is not what `inertial`
    /// says, or why it cannot be told. MJCF: from geoms, and after `boundmass`, `boundinertia`,
    /// `balanceinertia` and `settotalmass`. SDF: from collisions, with `auto="true"`.
    pub computed: Option<Result<ComputedMass, String>>,
}

/// Mass, centre and tensor that a compiler gives a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComputedMass {
    /// kg
    pub mass: f64,
    /// In the link's frame, m.
    pub center: [f64; 3],
    /// xx, yy, zz, xy, xz, yz about the centre, along the link's axes; kg·m².
    pub tensor: [f64; 6],
}

/// Mass, centre and tensor of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Inertial {
    /// Its element.
    pub span: Span,
    /// kg
    pub mass: Slot,
    /// The frame of the inertial in the link's: its origin is the centre of mass.
    pub pose: Pose,
    /// About the centre of mass, along the axes of the inertial's frame; kg·m².
    pub tensor: Tensor,
}

/// A tensor as the languages write it.
#[derive(Clone, Debug, PartialEq)]
pub enum Tensor {
    /// Not there: the element that should have it.
    Missing(Span),
    /// ixx, iyy, izz, ixy, ixz, iyz: elements of the tensor (−∫xy dm).
    Six(Box<[Slot; 6]>),
    /// Along the axes of the inertial's frame.
    Diagonal(Box<[Slot; 3]>),
}

impl Tensor {
    /// Its numbers, in the order of their names, if it is there.
    pub(crate) fn slots(&self) -> Option<impl Iterator<Item = &Slot>> {
        match self {
            Self::Missing(_) => None,
            Self::Six(slots) => Some(slots.iter()),
            Self::Diagonal(slots) => Some(slots.iter()),
        }
    }
}

/// What a geometry is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// To be seen.
    Visual,
    /// To be touched.
    Collision,
}

/// A shape of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Geometry {
    /// Its element.
    pub span: Span,
    /// What it is for. MJCF: a geom with `contype = conaffinity = 0` is visual.
    pub role: Role,
    /// The shape's frame in the link's.
    pub pose: Pose,
    /// The shape.
    pub shape: GeometryShape,
}

/// Shapes, in metres; the frame of each is at its middle, cylinders, capsules and cones along z.
/// Sizes that are none are NaN.
#[derive(Clone, Debug, PartialEq)]
pub enum GeometryShape {
    /// Whole edges.
    Box([f64; 3]),
    /// Radius.
    Sphere(f64),
    /// Radius and whole length.
    Cylinder {
        /// Radius.
        radius: f64,
        /// Whole length.
        length: f64,
    },
    /// Radius, and the length of the cylinder between the caps.
    Capsule {
        /// Radius.
        radius: f64,
        /// Between the middles of the caps.
        length: f64,
    },
    /// Half axes.
    Ellipsoid([f64; 3]),
    /// Base at −length/2, apex at +length/2.
    Cone {
        /// Radius of the base.
        radius: f64,
        /// Height from the base to the apex.
        length: f64,
    },
    /// A file.
    Mesh {
        /// As written: `"package://arm/meshes/link1.stl"`.
        uri: Name,
        /// Where that is, or why it cannot be said: outside the roots, a package that no root holds.
        path: Result<PathBuf, String>,
        /// Factors along x, y, z, applied once; a negative one mirrors.
        scale: [f64; 3],
    },
    /// Planes, height fields and what else has no volume of its own: its name.
    Other(String),
}

impl GeometryShape {
    /// The shape with all its sizes times a factor.
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
            Self::Other(name) => Self::Other(name.clone()),
        }
    }

    /// Bytes of the names in it.
    pub(crate) fn named_bytes(&self) -> usize {
        match self {
            Self::Mesh { uri, path, .. } => {
                uri.text.len() + path.as_ref().map_or_else(String::len, |path| path.as_os_str().len())
            }
            Self::Other(name) => name.len(),
            _ => 0,
        }
    }
}

/// How one link hangs on another.
///
/// An MJCF body may have several joints: they follow each other here with the same parent, child and pose, and act in this order.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Its name; made up where the language lets it be left out.
    pub name: Name,
    /// Its element.
    pub span: Span,
    /// What it lets move.
    pub kind: JointKind,
    /// The link that it hangs on; `None` if that is the world.
    pub parent: Option<Name>,
    /// The link that hangs.
    pub child: Name,
    /// The child's frame in the parent's with the joint at rest ([`Coordinate::at_rest`]): at zero in all languages but MJCF.
    pub pose: Pose,
    /// In the child's frame, as written or the language's default.
    pub axis: [f64; 3],
    /// The point of the child's frame that the axis runs through: zero in URDF.
    pub anchor: [f64; 3],
    /// What is said of its value.
    pub coordinate: Coordinate,
}

/// What a joint lets move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// Nothing.
    Fixed,
    /// A turn about the axis: revolute, continuous, hinge.
    Revolute,
    /// A way along the axis: prismatic, slide.
    Prismatic,
    /// Everything: floating, free.
    Free,
    /// Something else: ball, planar, universal, screw.
    Other,
}

/// What a file says of a joint's value, rad or m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coordinate {
    /// A name of its own, by which it may be given beside the joint's: OpenSim's coordinates.
    pub name: Option<Name>,
    /// The value at which the child stands as [`Joint::pose`] says, and that a joint has of which no value is
    /// given: MJCF's `ref`, zero elsewhere.
    pub at_rest: f64,
    /// The least and the greatest value; either may be infinite.
    pub limits: Option<[f64; 2]>,
    /// The joint that it follows.
    pub follows: Option<Follows>,
    /// Why it is not known where the joint holds the child, if it is not: what it does at rest is not read.
    pub unread: Option<String>,
    /// Inertia that the rotor of a motor adds to the joint's coordinate, reflected by its gear, kg·m²; kg if the joint slides.
    /// Zero if the file states none, NaN if its number cannot be read.
    pub armature: f64,
}

/// A joint whose value is a function of another's.
///
/// y = Σ c_k (x − x₀)^k of the leader's value x.
#[derive(Clone, Debug, PartialEq)]
pub struct Follows {
    /// Where that is written.
    pub span: Span,
    /// The joint that leads; `None` if the value is c₀ and hangs on none.
    pub leader: Option<Name>,
    /// x₀
    pub reference: f64,
    /// c, from the constant up; or why they are not known.
    pub coefficients: Result<Vec<f64>, String>,
}
