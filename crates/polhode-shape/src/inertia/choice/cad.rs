//! Answers to what CAD reports leave open.

use serde::{Deserialize, Serialize};

use crate::cad::{DecimalMark, ProductConvention};

/// Answers to what a CAD report may leave open.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct CadChoice {
    /// What the products of inertia in a CAD report are, where nothing in it proves it.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "SIGN"))]
    pub products: Option<ProductConvention>,
    /// The decimal mark of a CAD report, where its numbers leave it open.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "MARK"))]
    pub decimal: Option<DecimalMark>,
}

impl CadChoice {
    /// The first that is given.
    pub(in crate::inertia) const fn given(&self) -> Option<&'static str> {
        match self {
            Self { products: Some(_), .. } => Some("--products"),
            Self { decimal: Some(_), .. } => Some("--decimal"),
            _ => None,
        }
    }
}
