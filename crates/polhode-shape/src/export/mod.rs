//! Export of mass properties to the formats of other programs.
//!
//! Each format has its own frame, reference point and sign convention. The files state them in a
//! comment, if the format has comments:
//!
//! | format | tensor about | along | products of inertia | numbers |
//! |---|---|---|---|---|
//! | URDF, SDF, MJCF | centre of mass | body axes | elements of the tensor, −∫xy dm | f64 |
//! | MJCF principal, USD | centre of mass | principal axes, by a quaternion (w, x, y, z) | none | f64; USD f32 |
//! | JSBSim | centre of mass | body: x aft, y right, z up; lb, in, slug·ft² | −∫xy dm | f64 |
//! | RocketPy | centre of mass | body: z along the rocket, towards its nose | −∫xy dm | f64 |
//! | Basilisk | centre of mass | body axes | −∫xy dm | f64 |
//! | SolidWorks | centre of mass, and the origin | body axes | "positive tensor notation", +∫xy dm | f64 |
//! | CSV | centre of mass | body axes, and principal ones | elements of the tensor, −∫xy dm | f64 |
//!
//! The frame of a link, prim, hub or output coordinate system is the body's. All units are SI,
//! except for JSBSim. Text other than numbers is ASCII, for compatibility with old programs.

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

/// Export format for mass properties.
///
/// ```
/// use polhode_shape::ExportFormat;
/// assert_eq!(ExportFormat::named("URDF"), Some(ExportFormat::Urdf));
/// assert_eq!(ExportFormat::MjcfPrincipal.name(), "mjcf-principal");
/// ```
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum ExportFormat {
    /// URDF: a robot with one link and its `<inertial>`.
    Urdf,
    /// SDFormat 1.7: a model with one link for each body.
    Sdf,
    /// MuJoCo's MJCF: one `<body>` for each body, with the tensor as `fullinertia`.
    Mjcf,
    /// MuJoCo's MJCF with principal moments and axes, as `diaginertia` and `quat`.
    ///
    /// MuJoCo uses these values unchanged. From a `fullinertia` it computes them itself: MuJoCo 4.0
    /// loses 1e-14 of the tensor, and rejects rods and moments as small as 1e-15 kg·m².
    MjcfPrincipal,
    /// OpenUSD as text: one prim for each body, with `PhysicsMassAPI` applied. USD stores single
    /// precision.
    Usd,
    /// JSBSim: the `<mass_balance>` of an aircraft, in lb, in and slug·ft².
    JsbSim,
    /// Python code for RocketPy: the arguments of `rocketpy.Rocket`.
    RocketPy,
    /// Python code for Basilisk: the hub of a spacecraft.
    Basilisk,
    /// Text in the layout of a SolidWorks report.
    SolidWorks,
    /// CSV table: a header, and one line for each body.
    Csv,
}

impl ExportFormat {
    /// List of all formats.
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

    /// Returns the lower-case name, as used in options.
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

    /// Returns the format with this name, in any case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|format| format.name().eq_ignore_ascii_case(name.trim())).copied()
    }

    /// Returns the file extension, without the dot.
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

/// Body to be exported, with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportBody {
    /// Name of the body in the file.
    pub name: String,
    /// Mass, centre of mass and inertia tensor.
    pub properties: MassProperties<Body>,
    /// Enclosed volume, m³.
    pub volume: Option<f64>,
    /// Surface area, m².
    pub surface_area: Option<f64>,
    /// Mass per volume, kg/m³.
    pub density: Option<f64>,
    /// Interpretation of a mesh if it is not a solid: `convex_hull`, `sheet`.
    pub taken_as: Option<String>,
}

impl ExportBody {
    /// Creates a body with only a name and mass properties.
    pub fn new(name: impl Into<String>, properties: MassProperties<Body>) -> Self {
        let (volume, surface_area, density) = (None, None, None);
        Self { name: name.into(), properties, volume, surface_area, density, taken_as: None }
    }

    /// Creates the body of a report.
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
    /// Returns a remark if the numbers are not those of the solid that a mesh bounds.
    fn remark(&self) -> Option<String> {
        let taken_as = self.taken_as.as_ref()?.replace('_', " ");
        Some(format!("the mesh was taken as a {taken_as}, not as a solid"))
    }
}

/// Returns the text of a file in this format.
///
/// Numbers are the shortest decimals that read back bit for bit. They are those of the body: axes
/// and reference point are changed only if the format requires it.
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
/// [`ExportError`] if the format cannot represent the bodies: several links in a URDF, a reserved
/// name, or a number beyond its precision.
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

/// Returns the shortest decimal that reads back bit for bit. Zero has no sign.
fn number(x: f64) -> String {
    // −0 + 0 = 0
    exact(x + 0.0)
}

/// Joins numbers with a separator.
fn numbers(values: &[f64], between: &str) -> String {
    values.iter().map(|&x| number(x)).collect::<Vec<_>>().join(between)
}

/// Returns ixx, ixy, ixz, iyy, iyz, izz: the tensor about the centre of mass in body axes, row by
/// row.
fn elements(body: &MassProperties<Body>) -> [f64; 6] {
    let [[ixx, ixy, ixz], [_, iyy, iyz], [_, _, izz]] = body.inertia().matrix();
    [ixx, ixy, ixz, iyy, iyz, izz]
}
