//! Options for the substance of bodies.

use std::str::FromStr;

use polhode::body::Material;
use polhode::body::shape::Substance;
use polhode_source::Failure;
use polhode_source::given::{Density, Given, Mass, Positive};
use serde::{Deserialize, Serialize};

use crate::material;
use crate::material::UnknownMaterial;

/// Substance of the whole body; at most one of the options may be set.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args), group(multiple = false))]
pub struct SubstanceChoice {
    /// Density of a mesh or shape, such as "2700 kg/m^3" or "2.7 g/cm^3".
    #[cfg_attr(feature = "arguments", arg(long))]
    pub density: Option<Given<Positive<Density>>>,
    /// Mass of a mesh, shape or point cloud, such as "85 g".
    #[cfg_attr(feature = "arguments", arg(long))]
    pub mass: Option<Given<Positive<Mass>>>,
    /// Material of a mesh or shape by name, such as aluminium or steel.
    #[cfg_attr(feature = "arguments", arg(long))]
    pub material: Option<Given<MaterialNamed>>,
}

impl SubstanceChoice {
    /// Returns the substance, if one is given.
    ///
    /// # Errors
    /// [`Failure`] if several of the options are set.
    pub fn substance(&self) -> Result<Option<Substance>, Failure> {
        self.refuse_several()?;
        Ok(self.given())
    }

    pub(in crate::inertia) fn given(&self) -> Option<Substance> {
        let density = self.density.as_ref().map(|density| density.value.0.0);
        let density = density.or_else(|| Some(self.material.as_ref()?.value.0.density));
        density.map(Substance::Density).or(self.mass().map(Substance::Mass))
    }

    /// Returns an error if several of the options are set.
    pub(in crate::inertia) fn refuse_several(&self) -> Result<(), Failure> {
        let set = [
            self.density.as_ref().map(|_| "--density"),
            self.mass.as_ref().map(|_| "--mass"),
            self.material.as_ref().map(|_| "--material"),
        ];
        let set: Vec<_> = set.into_iter().flatten().collect();
        if set.len() < 2 {
            return Ok(());
        }
        Err(Failure::usage(format!("{} contradict each other", set.join(" and ")), "give one of them"))
    }

    /// Returns the mass, kg, if it is given.
    pub(in crate::inertia) fn mass(&self) -> Option<f64> {
        self.mass.as_ref().map(|mass| mass.value.0.0)
    }
}

/// Material selected by its name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialNamed(pub Material);

impl FromStr for MaterialNamed {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        material::named(text).map(Self).map_err(|unknown| {
            format!(
                "no such material: {} (known: {})",
                unknown.hint_or("give its density, as 2700 kg/m^3"),
                UnknownMaterial::known()
            )
        })
    }
}

/// Substance of one part: `wheel=steel`.
#[derive(Clone, Debug, PartialEq)]
pub struct PartSubstance {
    /// Name of the part in the file.
    pub name: String,
    /// Density or mass of the part.
    pub substance: Substance,
}

impl FromStr for PartSubstance {
    type Err = String;

    /// Parses `NAME=DENSITY`, `NAME=MASS` or `NAME=MATERIAL`.
    fn from_str(text: &str) -> Result<Self, String> {
        let form = "a part's name, =, and its density, mass or material, such as \"wheel=2.7 g/cm^3\"";
        let (name, what) = text.rsplit_once('=').ok_or_else(|| format!("expected {form}"))?;
        let density = || what.parse().map(|Positive(Density(density))| Substance::Density(density));
        let mass = || what.parse().map(|Positive(Mass(mass))| Substance::Mass(mass));
        let material = || what.parse().map(|MaterialNamed(material)| Substance::Density(material.density));
        let substance = density()
            .or_else(|_: String| mass())
            .or_else(|_: String| material())
            .map_err(|_: String| format!("{what:?} is not a density, mass or material: expected {form}"))?;
        // A number without a unit is ambiguous.
        if what.trim().parse::<f64>().is_ok() {
            return Err(format!("{what:?} has no unit: it could be a density or a mass"));
        }
        Ok(Self { name: name.trim().to_owned(), substance })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_has_a_density_a_mass_or_a_material() {
        let of = |text: &str| text.parse().map(|part: PartSubstance| (part.name, part.substance));
        assert_eq!(of("wheel=2.5 g/cm^3"), Ok(("wheel".to_owned(), Substance::Density(2500.0))));
        assert_eq!(of(" a=b = 250 g"), Ok(("a=b".to_owned(), Substance::Mass(0.25))));
        assert_eq!(of("hub=steel"), Ok(("hub".to_owned(), Substance::Density(7850.0))));
        for wrong in ["wheel", "wheel=7850", "wheel=-1 kg", "wheel=cheese"] {
            assert!(of(wrong).is_err(), "{wrong}");
        }
    }
}
