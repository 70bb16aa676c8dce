//! Errors of meshes that cannot be used as bodies.

use std::error::Error;
use std::fmt;

use polhode::body::BodyError;
use polhode_document::number::number;
use polhode_source::text::counted;
use polhode_source::{Failure, FormatError};

use crate::mesh::{Share, UnboundedClosure, percent_above};

/// Error of a mesh that cannot be used as a body.
#[derive(Clone, Debug)]
pub enum MeshBodyError {
    /// The file cannot be read, or does not bound a solid.
    Format(FormatError),
    /// The mass properties are not physical.
    Body(BodyError),
    /// The walls or the infill of a print cannot be computed.
    Print(BodyError),
    /// The value of a density formula is not a density.
    Density(BodyError),
    /// A substance is given for an unknown part.
    UnknownPart {
        /// Name of the part.
        name: String,
        /// Names of the existing parts.
        known: Vec<String>,
    },
    /// Two substances are given for one part.
    PartTwice {
        /// Name of the part.
        name: String,
    },
    /// One mass is given for several parts with the same name.
    SharedMass {
        /// Name of the parts.
        name: String,
        /// Number of parts with this name.
        count: usize,
    },
    /// A substance for the remaining parts is given, but every part has its own.
    AllNamed,
    /// The caps of holes give no bound, or too wide a bound.
    Unbounded(UnboundedClosure),
    /// The uncertain mass of the closed holes is not smaller than the mass.
    AllUncertain,
    /// The computation was cancelled.
    Interrupted,
}

impl MeshBodyError {
    /// Returns a hint in terms of the command; empty if there is none.
    pub fn hint(&self) -> String {
        match self {
            Self::Format(error) => error.hint().unwrap_or_default(),
            Self::Body(BodyError::FlatPoints { .. }) => {
                "a hull needs four points that do not lie in one plane".to_owned()
            }
            Self::Body(_) => "check --density, --mass, --part and --unit".to_owned(),
            Self::Print(_) => "check --walls and the layers".to_owned(),
            Self::Density(error) => error.hint().unwrap_or("check --field and --tolerance").to_owned(),
            Self::UnknownPart { known, .. } => {
                let known: Vec<_> = known.iter().map(|name| format!("{name:?}")).collect();
                format!("its parts are {}", known.join(", "))
            }
            Self::PartTwice { .. } => "a part has one substance: delete one of the two".to_owned(),
            Self::SharedMass { .. } => {
                "give a density or a material, which applies to each, or give the parts different names in the file"
                    .to_owned()
            }
            Self::AllNamed => "delete it, or delete a --part".to_owned(),
            Self::Unbounded(UnboundedClosure::Crossed { .. }) => {
                "close the surface in the tool that made it; or use its convex hull by --hull, or a shell along it by --shell".to_owned()
            }
            Self::Unbounded(UnboundedClosure::TooWide { share, .. }) if *share <= Share::MOST => format!(
                "use --close-within {}, or close the largest hole in the tool that made the mesh",
                percent_above(*share)
            ),
            Self::Unbounded(UnboundedClosure::TooWide { .. }) | Self::AllUncertain => {
                "close the largest hole in the tool that made the mesh; or use its convex hull by --hull, or a shell along it by --shell".to_owned()
            }
            Self::Interrupted => String::new(),
        }
    }
}

impl fmt::Display for MeshBodyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Format(error) => error.fmt(f),
            Self::Body(error) | Self::Density(error) | Self::Print(error) => error.fmt(f),
            Self::UnknownPart { name, .. } => write!(f, "the mesh has no part named {name:?}"),
            Self::PartTwice { name } => write!(f, "--part {name} is given twice"),
            Self::SharedMass { name, count } => {
                write!(f, "{count} parts of the mesh are named {name:?}: the mass is ambiguous")
            }
            Self::AllNamed => f.write_str(
                "--density, --mass or --material applies to parts without --part, but every part has one",
            ),
            Self::Unbounded(UnboundedClosure::Crossed { point: [x, y, z] }) => write!(
                f,
                "a surface that closes a hole intersects the mesh near ({x:.6e}, {y:.6e}, {z:.6e}) m, so its error has no bound"
            ),
            Self::Unbounded(UnboundedClosure::TooWide {
                share,
                most,
                repaired,
                holes,
                size,
                center: [x, y, z],
            }) => {
                write!(
                    f,
                    "{} {} of the volume uncertain, more than {}%: {}, the largest {size:.2e} m across at ({x:.3e}, {y:.3e}, {z:.3e}) m",
                    if *repaired { "the holes and the repairs before leave" } else { "the holes leave" },
                    if share.is_finite() { percent_above(*share) } else { "all".to_owned() },
                    number(100.0 * most, 6),
                    counted(*holes, "hole")
                )
            }
            Self::AllUncertain => f.write_str("all of the mass is uncertain"),
            Self::Interrupted => f.write_str("the computation was interrupted"),
        }
    }
}

impl Error for MeshBodyError {}

impl From<FormatError> for MeshBodyError {
    fn from(error: FormatError) -> Self {
        Self::Format(error)
    }
}

impl From<BodyError> for MeshBodyError {
    fn from(error: BodyError) -> Self {
        Self::Body(error)
    }
}

impl From<MeshBodyError> for Failure {
    fn from(error: MeshBodyError) -> Self {
        match error {
            MeshBodyError::Format(error) => error.into(),
            error => Self::usage(error.to_string(), error.hint()),
        }
    }
}
