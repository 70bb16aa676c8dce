//! Materials by common name.

use polhode::body::Material;
use polhode_source::nearest;

/// Returns a material by its name.
///
/// ```
/// use polhode_shape::material;
/// assert_eq!(material::named("stainless steel").unwrap().name, "stainless steel");
/// assert_eq!(material::named("carbon fiber").unwrap_err().suggestion, Some("carbon fibre"));
/// assert_eq!(material::named("aluminim").unwrap_err().suggestion, Some("aluminium"));
/// ```
///
/// # Errors
/// [`UnknownMaterial`] if no material has that name.
pub fn named(name: &str) -> Result<Material, UnknownMaterial> {
    let names = || Material::ALL.iter().map(|material| material.name);
    // Two spellings of one name may be equally near.
    let suggestion =
        || nearest(name, names()).or_else(|| nearest(name, names().filter(|n| *n != "aluminum")));
    let unknown = || UnknownMaterial { suggestion: suggestion() };
    Material::named(name).ok_or_else(unknown)
}

/// Error: no material has that name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownMaterial {
    /// Nearest known name.
    pub suggestion: Option<&'static str>,
}

impl UnknownMaterial {
    /// Returns all known names, separated by commas.
    pub fn known() -> String {
        Material::ALL.iter().map(|material| material.name).collect::<Vec<_>>().join(", ")
    }

    /// Returns a hint: the nearest known name, otherwise `other`.
    pub fn hint_or(self, other: &str) -> String {
        self.suggestion.map_or_else(|| other.to_owned(), |meant| format!("did you mean \"{meant}\"?"))
    }
}
