//! Request for the inertials of a model.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::path::PathBuf;

use polhode_shape::{PartSubstance, SubstanceChoice};
use polhode_source::given::Given;
use serde::{Deserialize, Serialize};

/// Request for the inertials of a model's links, from their geometry.
///
/// ```
/// use polhode_robot::inertials::{InertialsRequest, write_inertials};
/// use polhode_source::files::Memory;
/// let model = r#"<robot name="r"><link name="arm"><collision><geometry><box size="0.1 0.2 0.3"/>
///     </geometry></collision></link></robot>"#;
/// let mut request = InertialsRequest { file: "arm.urdf".into(), ..InertialsRequest::default() };
/// request.substance.density = Some("500 kg/m^3".parse()?);
/// let written = write_inertials(&request, &Memory::from([("arm.urdf", model)]))?;
/// assert!(written.text().contains(r#"<mass value="3"/><inertia ixx="0.0325""#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct InertialsRequest {
    /// Path of the model.
    pub file: PathBuf,
    /// Folders that hold packages, for package:// and model://.
    #[serde(rename = "root")]
    pub roots: Vec<PathBuf>,
    /// Name of a link, or a pattern with * and ?; all links if it is missing.
    pub link: Option<String>,
    #[serde(flatten)]
    pub options: InertialsOptions,
    /// Density or material of all links, or their total mass; without it each link keeps its mass.
    #[serde(flatten)]
    pub substance: SubstanceChoice,
    /// Density, mass or material of links, by name or pattern; or of one shape or mesh part, as
    /// LINK/PART.
    pub part: Vec<Given<PartSubstance>>,
}

/// Options for the links and their geometry.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct InertialsOptions {
    /// Links that --write-inertials writes: those without an inertial, or with a suspect or
    /// impossible finding.
    #[cfg_attr(feature = "arguments", arg(long, value_enum, value_name = "WHICH"))]
    pub only: Option<Only>,
    /// Geometry from which --write-inertials computes [default: the more detailed one that bounds a
    /// solid].
    #[cfg_attr(feature = "arguments", arg(long, value_enum, value_name = "ROLE"))]
    pub geometry: Option<Origin>,
}

impl InertialsOptions {
    /// Returns the name of the first option that is set.
    pub const fn given(&self) -> Option<&'static str> {
        match self {
            Self { only: Some(_), .. } => Some("--only"),
            Self { geometry: Some(_), .. } => Some("--geometry"),
            Self { only: None, geometry: None } => None,
        }
    }
}

/// Links that get an inertial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Only {
    /// Links that state no complete inertial.
    Missing,
    /// Links with a suspect or impossible finding.
    Suspect,
    /// Links with an impossible finding.
    Impossible,
}

/// Geometry from which inertials are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Origin {
    /// Geometry for display.
    Visual,
    /// Geometry for contact.
    Collision,
}
