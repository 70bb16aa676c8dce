//! Options for CAD reports.

use serde::{Deserialize, Serialize};

use crate::cad::{DecimalMark, ProductConvention};

/// Values that a CAD report may leave ambiguous.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct CadChoice {
    /// The sign convention of the products of inertia in a CAD report, if the report does not prove
    /// it.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "SIGN"))]
    pub products: Option<ProductConvention>,
    /// The decimal mark of a CAD report, if its numbers are ambiguous.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "MARK"))]
    pub decimal: Option<DecimalMark>,
}

impl CadChoice {
    /// Returns the name of the first option that is set.
    pub(in crate::inertia) const fn given(&self) -> Option<&'static str> {
        match self {
            Self { products: Some(_), .. } => Some("--products"),
            Self { decimal: Some(_), .. } => Some("--decimal"),
            _ => None,
        }
    }
}
