//! Materials with nominal densities.

/// Material with a name and a nominal density.
///
/// The densities are nominal values of the plain material at room temperature; alloys and grades
/// differ by a few per cent. For a mass budget, use the measured density or the mass.
///
/// ```
/// use polhode::body::Material;
/// assert_eq!(Material::named("Aluminium").map(|m| m.density), Some(2700.0));
/// assert!(Material::named("unobtainium").is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Name of the material, in lower case.
    pub name: &'static str,
    /// Nominal density, kg/m³.
    pub density: f64,
}

impl Material {
    /// Returns the material of that name, ignoring case; `None` if it is unknown.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|m| m.name.eq_ignore_ascii_case(name.trim())).copied()
    }

    /// All materials, in alphabetical order.
    ///
    /// The values are rounded, in common use, compiled from general knowledge and not transcribed
    /// from one table.
    pub const ALL: &'static [Self] = &[
        Self { name: "abs", density: 1050.0 },
        Self { name: "acrylic", density: 1180.0 },
        Self { name: "aluminium", density: 2700.0 },
        Self { name: "aluminum", density: 2700.0 },
        Self { name: "brass", density: 8500.0 },
        Self { name: "bronze", density: 8800.0 },
        Self { name: "carbon fibre", density: 1600.0 },
        Self { name: "concrete", density: 2400.0 },
        Self { name: "copper", density: 8960.0 },
        Self { name: "glass", density: 2500.0 },
        Self { name: "gold", density: 19_300.0 },
        Self { name: "ice", density: 917.0 },
        Self { name: "iron", density: 7870.0 },
        Self { name: "lead", density: 11_340.0 },
        Self { name: "magnesium", density: 1740.0 },
        Self { name: "nylon", density: 1140.0 },
        Self { name: "oak", density: 750.0 },
        Self { name: "pine", density: 500.0 },
        Self { name: "pla", density: 1240.0 },
        Self { name: "platinum", density: 21_450.0 },
        Self { name: "polycarbonate", density: 1200.0 },
        Self { name: "polyethylene", density: 950.0 },
        Self { name: "silver", density: 10_490.0 },
        Self { name: "stainless steel", density: 8000.0 },
        Self { name: "steel", density: 7850.0 },
        Self { name: "titanium", density: 4510.0 },
        Self { name: "tungsten", density: 19_250.0 },
        Self { name: "water", density: 998.0 },
        Self { name: "zinc", density: 7130.0 },
    ];
}
