//! Options for molecules.

use serde::{Deserialize, Serialize};

use crate::molecule::Isotopes;

/// Options for molecules.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct MoleculeChoice {
    /// The isotopes of atoms for which the file names none [default: abundant].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "WHICH"))]
    pub isotopes: Option<Isotopes>,
}

impl MoleculeChoice {
    /// Returns the name of the option, if it is set.
    pub(in crate::inertia) const fn given(&self) -> Option<&'static str> {
        if self.isotopes.is_some() { Some("--isotopes") } else { None }
    }
}
