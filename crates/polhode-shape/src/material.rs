//! Materials as people name them.

use polhode::body::Material;
use polhode_source::nearest;

/// A material by its name.
///
/// ```
/// use polhode_shape::material;
/// assert_eq!(material::named("stainless steel").unwrap().name, "stainless steel");
/// assert_eq!(material::named("carbon fiber").unwrap_err().suggestion, Some("carbon fibre"));
/// ```
///
/// # Errors
/// [`UnknownMaterial`] if there is none of that name.
pub fn named(name: &str) -> Result<Material, UnknownMaterial> {
    let unknown = || UnknownMaterial { suggestion: nearest(name, Material::ALL.iter().map(|m| m.name)) };
    Material::named(name).ok_or_else(unknown)
}

/// No material has that name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownMaterial {
    /// The name that was probably meant.
    pub suggestion: Option<&'static str>,
}

impl UnknownMaterial {
    /// All names that there are, with commas between.
    pub fn known() -> String {
        Material::ALL.iter().map(|material| material.name).collect::<Vec<_>>().join(", ")
    }

    /// What to write instead: the name that was probably meant, or what this says.
    pub fn hint_or(self, other: &str) -> String {
        self.suggestion.map_or_else(|| other.to_owned(), |meant| format!("did you mean \"{meant}\"?"))
    }
}
