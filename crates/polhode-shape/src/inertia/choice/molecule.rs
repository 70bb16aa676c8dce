//! Options for molecules.

use serde::{Deserialize, Serialize};

/// Options for molecules.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct MoleculeChoice {
    /// The masses of a molecule's atoms whose isotope its file does not name [default: abundant].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "WHICH"))]
    pub isotopes: Option<MassesOf>,
}

/// Masses of atoms whose isotope is not named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum MassesOf {
    /// Those of the most abundant isotopes.
    Abundant,
    /// Standard atomic weights.
    Average,
}

impl MoleculeChoice {
    /// The first that is given.
    pub(in crate::inertia) const fn given(&self) -> Option<&'static str> {
        if self.isotopes.is_some() { Some("--isotopes") } else { None }
    }
}
