//! Mass properties as other programs read them.
//!
//! Each format has a frame, a point and a sign of its own. What is written says which, in a comment where the format has
//! comments:
//!
//! | format | tensor about | along | products of inertia | numbers |
//! |---|---|---|---|---|
//! | URDF, SDF, MJCF | centre of mass | body axes | elements of the tensor, −∫xy dm | f64 |
//! | MJCF principal, USD | centre of mass | principal axes, turned by a quaternion (w, x, y, z) | none | f64; USD reads f32 |
//! | JSBSim | centre of mass | body axes, as its structural frame: x aft, y right, z up; lb, in, slug·ft² | elements of the tensor, −∫xy dm | f64 |
//! | RocketPy, Basilisk | centre of mass | body axes; RocketPy: z along the rocket, towards its nose | elements of the tensor, −∫xy dm | f64 |
//! | SolidWorks | centre of mass, and the origin | body axes | "positive tensor notation", +∫xy dm | f64 |
//! | CSV | centre of mass | body axes, and principal ones | elements of the tensor, −∫xy dm | f64 |
//!
//! The frame of a link, prim, hub or output coordinate system is the body's. All is SI, but for JSBSim. Text around the numbers is ASCII: these
//! files meet old tools.

pub(crate) mod csv;
mod error;
mod jsbsim;
mod mjcf;
mod python;
mod sdf;
mod solidworks;
mod urdf;
mod usd;
mod xml;

pub use error::ExportError;

use polhode::body::MassProperties;
use polhode::math::Body;

use crate::report::InertiaReport;
use polhode_document::number::exact;

/// A format that mass properties can be written in.
///
/// ```
/// use polhode_shape::ExportFormat;
/// assert_eq!(ExportFormat::named("URDF"), Some(ExportFormat::Urdf));
/// assert_eq!(ExportFormat::MjcfPrincipal.name(), "mjcf-principal");
/// ```
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum ExportFormat {
    /// A robot of one link with its `<inertial>`.
    Urdf,
    /// SDFormat 1.7: a model with a link for each body.
    Sdf,
    /// MuJoCo's XML, a `<body>` each: the tensor as `fullinertia`.
    Mjcf,
    /// The same, but `diaginertia` and `quat`: principal moments, and the axes that they belong to.
    ///
    /// MuJoCo keeps these as they are. Of a `fullinertia` it finds them itself: MuJoCo 4.0 was seen to lose 1e-14 of the
    /// tensor, and to refuse rods and moments as small as 1e-15 kg·m².
    MjcfPrincipal,
    /// OpenUSD as text, a prim each, with `PhysicsMassAPI` applied. USD keeps single precision.
    Usd,
    /// The `<mass_balance>` of a JSBSim aircraft, in lb, in and slug·ft².
    JsbSim,
    /// Python: the arguments of `rocketpy.Rocket`.
    RocketPy,
    /// Python: the hub of a Basilisk spacecraft.
    Basilisk,
    /// Text in the layout of a SolidWorks report.
    SolidWorks,
    /// A table: a line of column names, and a line for each body.
    Csv,
}

impl ExportFormat {
    /// All formats.
    pub const ALL: &'static [Self] = &[
        Self::Urdf,
        Self::Sdf,
        Self::Mjcf,
        Self::MjcfPrincipal,
        Self::Usd,
        Self::JsbSim,
        Self::RocketPy,
        Self::Basilisk,
        Self::SolidWorks,
        Self::Csv,
    ];

    /// The name in lower case, as a flag has it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Urdf => "urdf",
            Self::Sdf => "sdf",
            Self::Mjcf => "mjcf",
            Self::MjcfPrincipal => "mjcf-principal",
            Self::Usd => "usd",
            Self::JsbSim => "jsbsim",
            Self::RocketPy => "rocketpy",
            Self::Basilisk => "basilisk",
            Self::SolidWorks => "solidworks",
            Self::Csv => "csv",
        }
    }

    /// The format of that name; case does not matter.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|format| format.name().eq_ignore_ascii_case(name.trim())).copied()
    }

    /// How the names of its files end, without the dot.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Urdf => "urdf",
            Self::Sdf => "sdf",
            Self::Mjcf | Self::MjcfPrincipal | Self::JsbSim => "xml",
            Self::RocketPy | Self::Basilisk => "py",
            Self::Usd => "usda",
            Self::SolidWorks => "txt",
            Self::Csv => "csv",
        }
    }
}

/// A body to be written, under its name.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportBody {
    /// What to call it.
    pub name: String,
    /// Mass, centre of mass and inertia tensor.
    pub properties: MassProperties<Body>,
    /// Enclosed volume, m³.
    pub volume: Option<f64>,
    /// Surface area, m².
    pub surface_area: Option<f64>,
    /// Mass per volume, kg/m³.
    pub density: Option<f64>,
    /// What a mesh was taken for other than the solid that it bounds: `convex_hull`, `sheet`.
    pub taken_as: Option<String>,
}

impl ExportBody {
    /// A body of which nothing else is known.
    pub fn new(name: impl Into<String>, properties: MassProperties<Body>) -> Self {
        let (volume, surface_area, density) = (None, None, None);
        Self { name: name.into(), properties, volume, surface_area, density, taken_as: None }
    }

    /// The body of a report.
    pub fn of_report(name: impl Into<String>, report: &InertiaReport) -> Self {
        Self {
            volume: report.volume,
            surface_area: report.surface_area,
            density: report.density,
            taken_as: report.taken_as().map(str::to_owned),
            ..Self::new(name, report.properties)
        }
    }
}

impl ExportBody {
    /// What its numbers are of, where that is not the solid that a mesh bounds.
    fn remark(&self) -> Option<String> {
        let taken_as = self.taken_as.as_ref()?.replace('_', " ");
        Some(format!("the mesh was taken as a {taken_as}, not as a solid"))
    }
}

/// The text of a whole file in that format.
///
/// Numbers are the shortest decimals that read back bit for bit. They are those of the body: nothing is turned or moved
/// but what the format itself asks for.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::Position;
/// use polhode_shape::{ExportBody, ExportFormat, export};
/// let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia)?;
/// let urdf = export(ExportFormat::Urdf, &[ExportBody::new("bracket", body)])?;
/// assert!(urdf.contains(r#"<origin xyz="0.11 -0.07 0.23" rpy="0 0 0"/>"#));
/// assert!(urdf.contains(r#"<inertia ixx="3.1" ixy="0.4" ixz="-0.3" iyy="4.2" iyz="0.2" izz="5.3"/>"#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ExportError`] if the format cannot say this: several links in a URDF, a name that it reserves, a number beyond its
/// precision.
pub fn export(format: ExportFormat, bodies: &[ExportBody]) -> Result<String, ExportError> {
    if bodies.is_empty() {
        return Err(ExportError::Empty);
    }
    match format {
        ExportFormat::Urdf => urdf::write(bodies),
        ExportFormat::Sdf => sdf::write(bodies),
        ExportFormat::Mjcf | ExportFormat::MjcfPrincipal => mjcf::write(format, bodies),
        ExportFormat::Usd => usd::write(bodies),
        ExportFormat::JsbSim => jsbsim::write(bodies),
        ExportFormat::RocketPy => python::rocketpy(bodies),
        ExportFormat::Basilisk => python::basilisk(bodies),
        ExportFormat::SolidWorks => solidworks::write(bodies),
        ExportFormat::Csv => Ok(csv::write(bodies)),
    }
}

/// The shortest decimal that reads back bit for bit; no zero has a sign.
fn number(x: f64) -> String {
    // −0 + 0 = 0
    exact(x + 0.0)
}

/// Numbers with something between them.
fn numbers(values: &[f64], between: &str) -> String {
    values.iter().map(|&x| number(x)).collect::<Vec<_>>().join(between)
}

/// ixx, ixy, ixz, iyy, iyz, izz: the tensor about the centre of mass along body axes, row by row.
fn elements(body: &MassProperties<Body>) -> [f64; 6] {
    let [[ixx, ixy, ixz], [_, iyy, iyz], [_, _, izz]] = body.inertia().matrix();
    [ixx, ixy, ixz, iyy, iyz, izz]
}
