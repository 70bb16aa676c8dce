//! Plausibility of a mesh without a unit, which is assumed to be in metres. Most meshes are drawn
//! in millimetres.
//!
//! STL, OBJ, PLY and OFF have no unit. The size of a body is the longest side of the box with the
//! same moments. For a box this is its own side, for other bodies a similar length. A mesh drawn in
//! mm and read in m is a thousand times too long and 10⁹ times too heavy.

use polhode::body::shape::Extent;
use polhode::body::{Finding, MassProperties, Severity};
use polhode::math::Frame;

/// Length above which the unit is questioned, m.
const LONGEST: f64 = 5.0;

/// Mass above which the unit is questioned, if the mass follows from the density, kg.
const HEAVIEST: f64 = 1e4;

/// Density below which the unit is questioned, if the mass is given, kg/m³. It is half of the
/// default density.
const THINNEST: f64 = 0.5;

/// Ratio to the length of the other bodies above which the unit is questioned.
const MUCH_LONGER: f64 = 100.0;

/// Mesh whose unit is not given and is assumed to be the metre.
#[derive(Clone, Copy, Debug)]
pub struct AssumedMetres<'a, F: Frame> {
    /// Mass properties of the body.
    pub properties: &'a MassProperties<F>,
    /// Extent of the body, if known.
    pub extent: Option<Extent>,
    /// True if the mass was given, so that it does not follow from the size.
    pub mass_given: bool,
    /// Size of the largest other body, by [`longest_side`], m.
    pub others: Option<f64>,
    /// Advice to state the unit: `--unit mm`.
    pub remedy: &'a str,
}

impl<F: Frame> AssumedMetres<'_, F> {
    /// Returns the finding `mesh.unit` if the result in metres is implausible.
    ///
    /// ```
    /// use polhode::body::{InertiaTensor, MassProperties};
    /// use polhode::math::{Part, Position};
    /// use polhode_shape::mesh::AssumedMetres;
    /// let is_asked = |side: f64, mass: f64| {
    ///     let inertia = InertiaTensor::<Part>::diagonal([mass * side * side / 6.0; 3])?;
    ///     let properties = &MassProperties::new(mass, Position::ZERO, inertia)?;
    ///     let cube = AssumedMetres { properties, extent: None, mass_given: false, others: None, remedy: "--unit mm" };
    ///     Ok::<_, polhode::body::BodyError>(cube.finding(None).is_some())
    /// };
    /// assert!(!is_asked(0.12, 4.7)?);
    /// assert!(is_asked(120.0, 4.7e9)?);
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    pub fn finding(&self, place: Option<String>) -> Option<Finding> {
        let (side, mass) = (longest_side(self.properties), self.properties.mass());
        let volume = match self.extent {
            Some(Extent::Volume(volume)) => Some(volume),
            _ => None,
        };
        let density = volume.map(|volume| mass / volume).filter(|density| *density < THINNEST);
        let mut absurd = Vec::new();
        if side > LONGEST {
            absurd.push(format!("it is about {} m long", rounded(side)));
        }
        if mass > HEAVIEST && !self.mass_given {
            absurd.push(format!("its mass is {} t", rounded(1e-3 * mass)));
        }
        if let Some(density) = density.filter(|_| self.mass_given) {
            absurd.push(format!("its density is {} kg/m³", rounded(density)));
        }
        if let Some(others) = self.others.filter(|others| side > MUCH_LONGER * others) {
            absurd.push(format!("it is {} times as long as the other parts", rounded(side / others)));
        }
        (!absurd.is_empty()).then(|| Finding {
            code: "mesh.unit",
            severity: Severity::Warning,
            message: format!(
                "the unit of the mesh is unknown and metres are assumed, but then {}: is it in mm? ({})",
                absurd.join(", "),
                self.remedy
            ),
            place,
        })
    }
}

/// Returns the longest side of the box with the same moments, m: b² = 6 (i₂ + i₃ − i₁)/M.
pub fn longest_side<F: Frame>(properties: &MassProperties<F>) -> f64 {
    let [i1, i2, i3] = properties.principal().moments();
    (6.0 * ((i2 - i1) + i3) / properties.mass()).sqrt()
}

/// Rounds to three significant digits.
fn rounded(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use polhode::body::InertiaTensor;
    use polhode::math::{Part, Position};

    /// Returns a box with three sides, m, and a density, displaced from the origin.
    fn block(sides: [f64; 3], density: f64) -> (MassProperties<Part>, Option<Extent>) {
        let volume: f64 = sides.iter().product();
        let mass = density * volume;
        let [x, y, z] = sides.map(|side| side * side);
        let inertia = InertiaTensor::diagonal([y + z, z + x, x + y].map(|sum| mass * sum / 12.0)).unwrap();
        let properties = MassProperties::new(mass, Position::new(0.3, -1.2, 0.7), inertia).unwrap();
        (properties, Some(Extent::Volume(volume)))
    }

    fn message(sides: [f64; 3], density: f64, mass_given: bool, others: Option<f64>) -> Option<String> {
        let (properties, extent) = block(sides, density);
        let assumed =
            AssumedMetres { properties: &properties, extent, mass_given, others, remedy: "--unit mm" };
        assumed.finding(None).map(|finding| finding.message)
    }

    #[test]
    fn the_longest_side_is_that_of_the_box() {
        let (properties, _) = block([0.31, 4.7, 1.9], 7850.0);
        assert!((longest_side(&properties) - 4.7).abs() < 1e-14);
    }

    #[test]
    fn what_no_workshop_makes_is_asked_for_its_unit() {
        assert_eq!(message([0.12, 0.08, 0.02], 7850.0, false, None), None);
        assert_eq!(message([1.9, 0.9, 0.7], 7850.0, false, Some(0.03)), None);
        for (sides, density, mass_given, others, says) in [
            ([120.0, 80.0, 9.6], 2700.0, false, None, "about 120 m long, its mass is 249000 t"),
            ([5.5, 0.2, 0.1], 1.0, false, None, "about 5.5 m long: is it in mm? (--unit mm)"),
            ([1.7, 1.5, 1.4], 7850.0, false, None, "then its mass is 28 t"),
            ([4.0, 3.0, 2.0], 0.085 / 24.0, true, None, "then its density is 0.00354 kg/m³"),
            ([2.0, 1.0, 0.5], 700.0, false, Some(0.013), "then it is 154 times as long as the other parts"),
        ] {
            let message = message(sides, density, mass_given, others).unwrap();
            assert!(message.contains(says), "{message}");
        }
        // A given mass is a measured one.
        assert_eq!(message([1.7, 1.5, 1.4], 7850.0, true, None), None);
    }
}
