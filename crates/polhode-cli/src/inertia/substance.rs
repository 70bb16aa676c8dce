//! What a body in a file that does not say so is made of.

use clap::Args;
use polhode::body::shape::Substance;
use polhode::body::{Finding, Material, Severity};
use polhode_shape::material;
use polhode_shape::material::UnknownMaterial;
use polhode_source::unit::Dimension;

use polhode_source::given::{positive, quantity};

/// What the whole body is made of.
#[derive(Debug, Args)]
#[group(multiple = false)]
pub(super) struct SubstanceFlags {
    /// Density of a mesh, such as "2700 kg/m^3" or "2.7 g/cm^3".
    #[arg(long, value_parser = density)]
    density: Option<f64>,
    /// Mass of a mesh or of a cloud of points, such as "85 g".
    #[arg(long, value_parser = mass)]
    mass: Option<f64>,
    /// Material of a mesh by name, such as aluminium or steel.
    #[arg(long, value_parser = material)]
    material: Option<Material>,
}

impl SubstanceFlags {
    pub(super) fn given(&self) -> Option<Substance> {
        let density = self.density.or(self.material.map(|m| m.density)).map(Substance::Density);
        density.or(self.mass.map(Substance::Mass))
    }

    /// The mass alone.
    pub(super) const fn mass(&self) -> Option<f64> {
        self.mass
    }
}

/// One part's substance: `--part wheel=steel`.
#[derive(Clone, Debug)]
pub(super) struct PartSubstance {
    pub(super) name: String,
    pub(super) substance: Substance,
}

/// `NAME=DENSITY`, `NAME=MASS` or `NAME=MATERIAL`.
pub(super) fn part(text: &str) -> Result<PartSubstance, String> {
    let form = "a part's name, =, and its density, mass or material, such as \"wheel=2.7 g/cm^3\"";
    let (name, what) = text.rsplit_once('=').ok_or_else(|| format!("expected {form}"))?;
    let substance = density(what)
        .map(Substance::Density)
        .or_else(|_| mass(what).map(Substance::Mass))
        .or_else(|_| material(what).map(|m| Substance::Density(m.density)))
        .map_err(|_| format!("{what:?} is no density, mass or material: expected {form}"))?;
    // a bare number is neither
    if what.trim().parse::<f64>().is_ok() {
        return Err(format!("{what:?} has no unit: it could be a density or a mass"));
    }
    Ok(PartSubstance { name: name.trim().to_owned(), substance })
}

/// What is assumed where nothing is given, and said.
pub(super) fn assumed(findings: &mut Vec<Finding>) -> Substance {
    findings.push(Finding {
        code: "mass.assumed",
        severity: Severity::Warning,
        message: "neither density, mass nor material is given: 1 kg/m³ is assumed".to_owned(),
        place: Some("--density, --mass or --material".to_owned()),
    });
    Substance::Density(1.0)
}

fn density(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::DENSITY)?)
}

fn mass(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::MASS)?)
}

fn material(text: &str) -> Result<Material, String> {
    material::named(text).map_err(|unknown| {
        format!(
            "no such material: {} (known: {})",
            unknown.hint_or("give its density, as 2700 kg/m^3"),
            UnknownMaterial::known()
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_has_a_density_a_mass_or_a_material() {
        let of = |text: &str| part(text).map(|p| (p.name, p.substance));
        assert_eq!(of("wheel=2.5 g/cm^3"), Ok(("wheel".to_owned(), Substance::Density(2500.0))));
        assert_eq!(of(" a=b = 250 g"), Ok(("a=b".to_owned(), Substance::Mass(0.25))));
        assert_eq!(of("hub=steel"), Ok(("hub".to_owned(), Substance::Density(7850.0))));
        for wrong in ["wheel", "wheel=7850", "wheel=-1 kg", "wheel=cheese"] {
            assert!(of(wrong).is_err(), "{wrong}");
        }
    }
}
